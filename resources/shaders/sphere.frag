#version 330 core
in vec2 on_disc;
in vec3 centre_in_view;
uniform mat4 projection;
uniform float radius;
uniform vec3 tint;
out vec4 color;
void main()
{
    float r2 = dot(on_disc, on_disc);
    if (r2 > 1.0)
        discard;
    vec3 n = vec3(on_disc, sqrt(1.0 - r2));
    vec4 clip = projection * vec4(centre_in_view + radius * n, 1.0);
    gl_FragDepth = 0.5 + 0.5 * clip.z / clip.w;
    vec3 lamp = normalize(vec3(-0.4, 0.5, 0.8));
    float rim = pow(1.0 - n.z, 2.0);
    float shine = pow(max(dot(n, normalize(lamp + vec3(0.0, 0.0, 1.0))), 0.0), 60.0);
    color = vec4(tint * (0.55 + 0.45 * max(dot(n, lamp), 0.0)) + vec3(0.25 * rim + 0.5 * shine), 0.72);
}
