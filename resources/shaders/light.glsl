// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Shared by all that is made of yarn, after cloth_light.glsl. Colours are linear light.
uniform vec3 eye;
uniform float side;           // 1: the top face is looked at, -1: the bottom
uniform vec3 marked_color;    // of the chosen yarn
uniform float half_thickness;
uniform float natural;        // 1: wet yarns are darker, 0: they are coloured by their water
uniform vec2 film;            // shares of light: what gets into a film of water, what it throws back from inside

// Colour of a yarn whose surface is under water by a share: core/project/wet_look.h.
vec3 darkened(vec3 dry, float wet)
{
    vec3 under = film.x * (1.0 - film.y) * dry / (1.0 - film.y * dry);
    return mix(dry, under, clamp(wet, 0.0, 1.0));
}

// How far a yarn has the colour of its water instead of its own. That colour shows without gloss, or the legend would not have it.
float stained(float wet, float bare)
{
    return natural > 0.5 ? 0.0 : smoothstep(0.25 * bare, 1.5 * bare, wet);
}

// Colour of a yarn with so much water, a share of the full colours.
vec3 wetted(sampler2D ramp, vec3 dry, float wet, float bare)
{
    if (natural > 0.5)
        return darkened(dry, wet);
    vec3 of_water = texture(ramp, vec2(clamp(wet, 0.0, 1.0) * 255.0 / 256.0 + 0.5 / 256.0, 0.5)).rgb;
    return mix(dry, of_water, stained(wet, bare));
}

// The share of its surface that looks as if it were under water.
float under_water(float wet)
{
    return natural > 0.5 ? clamp(wet, 0.0, 1.0) : 0.0;
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
