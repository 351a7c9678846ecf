// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Light takes little from the colours, so that they can be compared with their legend.
uniform sampler2D picture;
uniform vec3 eye;
uniform vec3 bare; // of cloth without a colour
uniform vec4 line; // with alpha 1: drawn in this colour
in vec3 n;
in vec3 at;
in vec2 in_picture;
out vec4 color;

void main()
{
    vec4 own = texture(picture, in_picture);
    bool beyond = any(lessThan(in_picture, vec2(0.0))) || any(greaterThan(in_picture, vec2(1.0)));
    vec3 base = mix(bare, own.rgb, beyond ? 0.0 : own.a);
    float facing = abs(dot(normalize(n), normalize(eye - at)));
    float light = (0.86 + 0.14 * facing) * (gl_FrontFacing ? 1.0 : 0.82);
    color = vec4(mix(base * light, line.rgb, line.a), 1.0);
}
