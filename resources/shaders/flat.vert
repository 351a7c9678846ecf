// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A cell of cloth so far away that its yarns are not drawn.
layout(location = 0) in vec2 corner;      // 0 or 1
layout(location = 4) in vec4 cell;        // corner, first end and pick
layout(location = 5) in vec3 cell_fade;   // size, fade

uniform mat4 view_projection;
uniform vec3 pitch;           // mm; z is the layer's height
uniform vec4 cut;
uniform vec3 eye;
uniform float side;
uniform sampler2D repeat_light; // see repeat.frag
uniform sampler2DArray looks;   // see RepeatPicture: what the whole looks like from each direction

out vec2 crossing;            // counted from the fabric's corner
flat out float fade;
out vec3 mean;                // light of ends and of picks, and how much is covered, looked at from here
out vec2 shine;               // of fibres, of a film of water
flat out vec3 above;          // of the first three from straight above, as repeat_light has them
out float steepness;

void main()
{
    vec2 span = corner * cell_fade.xy;
    vec3 at = vec3(cell.xy + span, pitch.z);
    crossing = cell.zw + span / pitch.xy;
    fade = cell_fade.z;
    vec3 to_eye = normalize(eye - at);
    vec2 nodes = vec2(textureSize(looks, 0).xy);
    vec2 node = (0.5 * to_eye.xy + 0.5) * (nodes - 1.0) / nodes + 0.5 / nodes;
    float face = side > 0.0 ? 0.0 : 1.0;
    mean = textureLod(looks, vec3(node, face), 0.0).rgb;
    shine = textureLod(looks, vec3(node, face + 2.0), 0.0).rg;
    above = textureLod(repeat_light, vec2(0.5), 20.0).rgb;
    steepness = abs(to_eye.z);
    gl_ClipDistance[0] = cut.w - dot(cut.xyz, at);
    gl_Position = view_projection * vec4(at, 1.0);
}
