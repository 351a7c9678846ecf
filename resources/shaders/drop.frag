// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Water that stands on cloth, which is seen through it; its surface bends and mirrors.
in vec3 at;
in vec3 facing;
uniform vec3 eye;
uniform vec3 tint;
uniform float tinted;         // how much of the water's colour in the legend it has
uniform float face;           // height of the cloth that is seen through it
uniform mat4 view_projection;
uniform sampler2D below;      // the picture without liquid
out vec4 color;

const float index = 1.333;    // of water

// Where the line of sight, bent by the surface, meets the cloth.
vec3 seen_through(vec3 n, vec3 to_eye)
{
    vec3 bent = refract(-to_eye, n, gl_FrontFacing ? 1.0 / index : 1.0);
    float down = (face - at.z) / bent.z;
    vec3 there = at + bent * clamp(down > 0.0 ? down : 0.0, 0.0, 20.0);
    vec4 place = view_projection * vec4(there, 1.0);
    return texture(below, clamp(0.5 + 0.5 * place.xy / place.w, 0.001, 0.999)).rgb;
}

void main()
{
    vec3 to_eye = normalize(eye - at);
    vec3 n = normalize(gl_FrontFacing ? facing : -facing); // the inside is seen where a section opens the drop
    float across = clamp(dot(n, to_eye), 0.0, 1.0);
    float side = eye.z >= 0.0 ? 1.0 : -1.0;
    vec3 lamp = normalize(vec3(-0.35, 0.3, 0.9 * side) + 0.5 * to_eye);
    float mirrored = 0.02 + 0.98 * pow(1.0 - across, 5.0); // Schlick 1994
    float shine = pow(max(dot(n, normalize(lamp + to_eye)), 0.0), 160.0);
    vec3 back = reflect(-to_eye, n);
    vec3 sky = mix(vec3(0.15, 0.19, 0.23), vec3(0.91, 0.95, 1.0), smoothstep(-0.2, 0.9, back.z * side));
    vec3 through = mix(seen_through(n, to_eye), tint * (0.35 + 0.65 * max(dot(n, lamp), 0.0)), tinted);
    color = vec4(mix(through * mix(0.65, 1.0, across), sky, mirrored) + vec3(0.85 * shine), 1.0);
}
