// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A ball of water on its square, with its place in depth.
in vec2 on_disc;
flat in vec3 middle;
flat in vec3 towards;
flat in vec3 across;
flat in vec3 upwards;
uniform mat4 view_projection;
uniform vec3 eye;
uniform vec3 tint;
uniform float radius;
out vec4 color;

void main()
{
    float from_middle = length(on_disc);
    float edge = fwidth(from_middle);
    float covered = clamp((1.0 - from_middle) / edge + 0.5, 0.0, 1.0); // of the pixel, spread over its samples
    if (covered <= 0.0) discard;
    float height = sqrt(max(1.0 - from_middle * from_middle, 0.0));
    vec3 n = normalize(on_disc.x * across + on_disc.y * upwards + height * towards);
    vec4 place = view_projection * vec4(middle + radius * n, 1.0);
    gl_FragDepth = 0.5 + 0.5 * place.z / place.w;
    float side = eye.z >= 0.0 ? 1.0 : -1.0;
    vec3 lamp = normalize(vec3(-0.35, 0.3, 0.9 * side) + 0.5 * towards);
    float shine = pow(max(dot(n, normalize(lamp + towards)), 0.0), 60.0);
    vec3 lit = tint * (0.17 + 0.2 * (0.5 + 0.5 * n.z * side) + 0.85 * max(dot(n, lamp), 0.0)) * (0.39 + 0.61 * height);
    color = vec4(lit + vec3(0.35 * shine), covered); // linear light
}
