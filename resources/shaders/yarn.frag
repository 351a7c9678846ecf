#version 330 core
in vec3 at;
in vec3 facing;
in vec2 on_yarn;
in float wet;
flat in int is_weft;

uniform vec3 eye;
uniform vec3 warp_color;
uniform vec3 weft_color;
uniform vec2 twist;           // turns per crossing of warp and weft, signed
uniform float half_thickness;
uniform sampler2D ramp;       // colours of water
uniform float bare;           // share of full water below which the fabric's own colour shows

out vec4 color;

void main()
{
    vec3 n = normalize(facing);
    vec3 to_eye = normalize(eye - at);
    if (dot(n, to_eye) < 0.0)
        n = -n;

    // Fibres wind round the yarn; they fade where they are finer than a pixel.
    float turns = is_weft == 1 ? twist.y : twist.x;
    float phase = 11.0 * (on_yarn.y - turns * on_yarn.x);
    float blur = clamp(1.0 - 1.6 * fwidth(phase), 0.0, 1.0);
    float wave = 6.2831853 * phase;
    vec3 along = is_weft == 1 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
    blur *= 1.0 - smoothstep(0.8, 0.95, abs(dot(n, along))); // none on cut ends
    vec3 around = normalize(cross(along, n) + vec3(1e-6));
    vec3 bent = normalize(n + 0.22 * blur * cos(wave) * around);
    float groove = 1.0 - 0.10 * blur * (0.5 - 0.5 * sin(wave));

    vec3 dry = is_weft == 1 ? weft_color : warp_color;
    float amount = clamp(wet, 0.0, 1.0);
    vec3 stained = texture(ramp, vec2(amount * 255.0 / 256.0 + 0.5 / 256.0, 0.5)).rgb;
    float cover = smoothstep(0.25 * bare, 1.5 * bare, wet);
    vec3 base = mix(dry, stained, cover) * groove;

    // A lamp over the viewer's left shoulder, sky on whichever face is looked at.
    float side = eye.z >= 0.0 ? 1.0 : -1.0;
    vec3 lamp = normalize(vec3(-0.35, 0.3, 0.9 * side) + 0.5 * to_eye);
    float direct = max(dot(bent, lamp), 0.0);
    float sky = 0.5 + 0.5 * bent.z * side;
    float height = at.z * side / half_thickness;
    float open = mix(0.42, 1.0, smoothstep(-1.0, 0.75, height));
    float shine = pow(max(dot(bent, normalize(lamp + to_eye)), 0.0), mix(12.0, 40.0, cover)) * mix(0.05, 0.28, cover);
    vec3 light = base * (0.34 * sky + 0.72 * direct + 0.06) * open;
    color = vec4(light + vec3(shine * open), 1.0);
}
