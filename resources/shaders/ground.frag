// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The ground has the colour of the background, but for the cloth's shadow.
in vec2 place;
uniform vec4 cloth;
uniform vec2 aside;  // where the shadow falls, mm beside the cloth
uniform float soft;  // half the width of its edge, mm
uniform float dark;
uniform vec3 background;

out vec4 color;

void main()
{
    vec2 from = place - aside;
    vec2 within = smoothstep(cloth.xy - soft, cloth.xy + soft, from) - smoothstep(cloth.zw - soft, cloth.zw + soft, from);
    color = vec4(background * (1.0 - dark * within.x * within.y), 1.0);
}
