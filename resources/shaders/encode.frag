// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// From linear light to what a display takes: sRGB, IEC 61966-2-1.
uniform sampler2D picture;

out vec4 color;

void main()
{
    vec3 light = clamp(texelFetch(picture, ivec2(gl_FragCoord.xy), 0).rgb, 0.0, 1.0);
    vec3 curved = 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055;
    color = vec4(mix(curved, 12.92 * light, vec3(lessThan(light, vec3(0.0031308)))), 1.0);
}
