// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Two pictures of the same, yarns with skins and yarns of fibres, whose alpha is the share that the fibres have there.
uniform sampler2D skins;
uniform sampler2D fibres;

out vec4 color;

void main()
{
    vec4 far = texelFetch(skins, ivec2(gl_FragCoord.xy), 0);
    vec4 near = texelFetch(fibres, ivec2(gl_FragCoord.xy), 0);
    color = vec4(mix(far.rgb, near.rgb, smoothstep(0.0, 1.0, max(far.a, near.a))), 1.0);
}
