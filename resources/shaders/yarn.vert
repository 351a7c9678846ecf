// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A piece of yarn of a cell, and what its crossing holds.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 shape;       // normal, openness
layout(location = 2) in vec2 place;       // see CellVertex
layout(location = 3) in uvec4 crossing;   // end and pick in the cell, see CellVertex
layout(location = 4) in vec4 cell;        // corner, first end and pick
layout(location = 5) in vec3 cell_fade;   // size, fade

uniform mat4 view_projection;
uniform sampler2D water;      // ends and picks, red for the end and green for the pick of a crossing
uniform float water_scale;    // 0: no values
uniform sampler2D end_colors; // alpha: turns per crossing, signed
uniform sampler2D pick_colors;
uniform ivec2 marked;         // 0 for ends and 1 for picks, which
uniform vec4 cut;             // kept where dot(cut.xyz, at) <= cut.w

out vec3 at;
out vec3 facing;
out float open;
out vec2 on_yarn;
out float wet;
flat out int is_weft;
flat out vec4 dry;
flat out float chosen;
flat out float fade;
flat out float is_cut;        // 1: the end of a yarn that is cut off
flat out float is_fibre;      // 1: on_yarn has its direction, no fibres wind round it

void main()
{
    at = position + vec3(cell.xy, 0.0);
    facing = shape.xyz;
    open = shape.w;
    fade = cell_fade.z;
    is_fibre = crossing.w == 1u ? 1.0 : 0.0;
    is_cut = crossing.w == 2u ? 1.0 : 0.0;
    is_weft = int(crossing.z);
    on_yarn = place + (crossing.w == 1u ? vec2(0.0) : vec2(is_weft == 1 ? cell.z : cell.w, 0.0));
    ivec2 where = ivec2(crossing.xy) + ivec2(cell.zw);
    vec2 amount = water_scale > 0.0 ? texelFetch(water, where, 0).rg * water_scale : vec2(0.0);
    wet = is_weft == 1 ? amount.g : amount.r;
    int yarn = is_weft == 1 ? where.y : where.x;
    dry = is_weft == 1 ? texelFetch(pick_colors, ivec2(yarn, 0), 0) : texelFetch(end_colors, ivec2(yarn, 0), 0);
    chosen = marked.x == is_weft && marked.y == yarn ? 1.0 : 0.0;
    gl_ClipDistance[0] = cut.w - dot(cut.xyz, at);
    gl_Position = view_projection * vec4(at, 1.0);
}
