// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// One particle of free liquid: a square that faces the eye, on which the fragments make a ball.
layout(location = 0) in vec2 corner; // 0..1
layout(location = 1) in vec3 centre;
uniform mat4 view_projection;
uniform vec3 eye;
uniform float radius;
uniform vec4 cut; // kept where dot(cut.xyz, centre) <= cut.w
out vec2 on_disc;
flat out vec3 middle;
flat out vec3 towards;
flat out vec3 across;
flat out vec3 upwards;

void main()
{
    middle = centre;
    towards = normalize(eye - centre);
    across = normalize(cross(abs(towards.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(0.0, 1.0, 0.0), towards));
    upwards = cross(towards, across);
    on_disc = 2.2 * corner - 1.1; // a little more, for the edge's samples
    gl_Position = view_projection * vec4(centre + radius * (on_disc.x * across + on_disc.y * upwards), 1.0);
    gl_ClipDistance[0] = cut.w - dot(cut.xyz, centre);
}
