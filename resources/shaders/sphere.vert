#version 330 core
layout(location = 0) in vec2 corner;  // -1..1
layout(location = 1) in vec3 centre;  // per instance, mm
uniform mat4 view;
uniform mat4 projection;
uniform float radius;
out vec2 on_disc;
out vec3 centre_in_view;
void main()
{
    on_disc = corner;
    centre_in_view = (view * vec4(centre, 1.0)).xyz;
    gl_Position = projection * vec4(centre_in_view + vec3(radius * corner, 0.0), 1.0);
}
