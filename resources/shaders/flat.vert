layout(location = 0) in vec2 corner;      // 0 or 1
layout(location = 4) in vec4 cell;        // corner, first end and pick
layout(location = 5) in vec3 cell_fade;   // size, fade

uniform mat4 view_projection;
uniform vec3 pitch;           // mm; z is the layer's height
uniform vec4 cut;

out vec3 at;
out vec2 crossing;            // counted from the fabric's corner
flat out float fade;

void main()
{
    vec2 span = corner * cell_fade.xy;
    at = vec3(cell.xy + span, pitch.z);
    crossing = cell.zw + span / pitch.xy;
    fade = cell_fade.z;
    gl_ClipDistance[0] = cut.w - dot(cut.xyz, at);
    gl_Position = view_projection * vec4(at, 1.0);
}
