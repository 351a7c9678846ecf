// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The surface of water that stands on cloth.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 view_projection;
uniform vec4 cut; // kept where dot(cut.xyz, at) <= cut.w
out vec3 at;
out vec3 facing;

void main()
{
    at = position;
    facing = normal;
    gl_Position = view_projection * vec4(position, 1.0);
    gl_ClipDistance[0] = cut.w - dot(cut.xyz, position);
}
