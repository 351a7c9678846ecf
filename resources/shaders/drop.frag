in vec3 at;
in vec3 facing;
uniform vec3 eye;
uniform vec3 tint;
out vec4 color;

void main()
{
    vec3 to_eye = normalize(eye - at);
    vec3 n = normalize(gl_FrontFacing ? facing : -facing); // the inside is seen where a section opens the drop
    float across = max(dot(n, to_eye), 0.0);
    float side = eye.z >= 0.0 ? 1.0 : -1.0;
    vec3 lamp = normalize(vec3(-0.35, 0.3, 0.9 * side) + 0.5 * to_eye);
    float rim = pow(1.0 - across, 3.0);
    float shine = pow(max(dot(n, normalize(lamp + to_eye)), 0.0), 120.0);
    vec3 body = tint * (0.62 + 0.38 * max(dot(n, lamp), 0.0));
    vec3 sky = mix(vec3(0.55, 0.68, 0.80), vec3(0.95, 0.98, 1.0), 0.5 + 0.5 * n.z * side);
    color = vec4(mix(body, sky, 0.65 * rim) + vec3(0.85 * shine), clamp(0.46 + 0.45 * rim + shine, 0.0, 1.0));
}
