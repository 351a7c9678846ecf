#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 place; // along in crossings, once round is 1
layout(location = 3) in uint segment;

uniform mat4 view_projection;
uniform int crossings;        // segments below are warp
uniform sampler2D water;      // one value per segment, 1024 a row
uniform float water_scale;    // 0: no values

out vec3 at;
out vec3 facing;
out vec2 on_yarn;
out float wet;
flat out int is_weft;

void main()
{
    at = position;
    facing = normal;
    on_yarn = place;
    int index = int(segment);
    is_weft = index >= crossings ? 1 : 0;
    wet = water_scale > 0.0 ? texelFetch(water, ivec2(index & 1023, index >> 10), 0).r * water_scale : 0.0;
    gl_Position = view_projection * vec4(position, 1.0);
}
