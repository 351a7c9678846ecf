// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A level ground far beyond the cloth.
uniform mat4 view_projection;
uniform vec4 cloth;  // its lower and its upper corner, mm
uniform float height;
uniform float soft;
out vec2 place;

void main()
{
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    place = mix(cloth.xy - 3.0 * soft, cloth.zw + 3.0 * soft, corner);
    gl_Position = view_projection * vec4(place, height, 1.0);
}
