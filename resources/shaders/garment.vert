// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A garment's cloth: each panel has a picture that lies on its flat coordinates.
layout(location = 0) in vec3 place;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 flat_place;
uniform mat4 view_projection;
uniform vec3 to_u; // dot(to_u, (flat place, 1)) is where it lies across the picture, 0..1
uniform vec3 to_v;
out vec3 n;
out vec3 at;
out vec2 in_picture;

void main()
{
    n = normal;
    at = place;
    in_picture = vec2(dot(to_u, vec3(flat_place, 1.0)), dot(to_v, vec3(flat_place, 1.0)));
    gl_Position = view_projection * vec4(place, 1.0);
}
