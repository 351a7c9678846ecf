// Shared by all that is made of yarn. A lamp over the viewer's left shoulder, sky on whichever face is looked at.
uniform vec3 eye;
uniform float side;           // 1: the top face is looked at, -1: the bottom
uniform vec3 marked_color;    // of the chosen yarn
uniform float half_thickness;
uniform float natural;        // 1: wet yarns are darker, 0: they are coloured by their water
uniform vec2 film;            // shares of light: what gets into a film of water, what it throws back from inside

vec3 lamp_direction(vec3 to_eye)
{
    return normalize(vec3(-0.35, 0.3, 0.9 * side) + 0.5 * to_eye);
}

// weight is how much light reaches the skin at all, n its direction times that: sums over many skins stay right.
vec3 light_on(vec3 base, vec3 n, float weight, vec3 lamp)
{
    float sky = 0.5 * (weight + n.z * side);
    return base * (0.38 * sky + 0.64 * max(dot(n, lamp), 0.0) + 0.12 * weight);
}

// The deeper in the fabric, the less light.
float light_at_height(float height)
{
    return 0.70 + 0.30 * smoothstep(-1.0, 0.75, height * side / half_thickness);
}

// Colour of a yarn whose surface is under water by a share: core/project/wet_look.h.
vec3 darkened(vec3 dry, float wet)
{
    vec3 light = pow(dry, vec3(2.2));
    vec3 under = film.x * (1.0 - film.y) * light / (1.0 - film.y * light);
    return pow(mix(light, under, clamp(wet, 0.0, 1.0)), vec3(1.0 / 2.2));
}

// Colour of a yarn with so much water, a share of the full colours.
vec3 wetted(sampler2D ramp, vec3 dry, float wet, float bare)
{
    if (natural > 0.5)
        return darkened(dry, wet);
    vec3 stained = texture(ramp, vec2(clamp(wet, 0.0, 1.0) * 255.0 / 256.0 + 0.5 / 256.0, 0.5)).rgb;
    return mix(dry, stained, smoothstep(0.25 * bare, 1.5 * bare, wet));
}

// An even spread of thresholds over the pixels, for fading from one shape to another.
bool left_out(float fade)
{
    float share = abs(fade);
    ivec2 p = ivec2(gl_FragCoord.xy);
    int x = p.x ^ p.y;
    int rank = ((x & 1) << 5) | ((p.y & 1) << 4) | ((x & 2) << 2) | ((p.y & 2) << 1) | ((x & 4) >> 1) | ((p.y & 4) >> 2);
    float threshold = (float(rank) + 0.5) / 64.0;
    return fade >= 0.0 ? threshold >= share : threshold < share;
}
