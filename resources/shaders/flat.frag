// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Cloth so far away that its yarns are not drawn: the colour of the repeat there.
in vec2 crossing;
flat in float fade;
in vec3 mean;       // see flat.vert
in vec2 shine;      // of fibres, of a film of water
flat in vec3 above;
in float steepness; // 1 from straight above, 0 along the cloth

uniform sampler2D repeat_light; // see repeat.frag
uniform vec2 period;          // crossings
uniform vec2 crossings;       // of the whole
uniform sampler2D end_colors;
uniform sampler2D pick_colors;
uniform sampler2D water;
uniform float water_scale;
uniform sampler2D ramp;
uniform float bare;
uniform ivec2 marked;
uniform vec3 background;
uniform vec3 belt;            // pixels of a pitch at depth 1, begin and end of the belt where tubes take over
uniform float over_tubes;     // 1: laid over tubes, the thinner the nearer

out vec4 color;

// The light of ends and of picks, and the share of the background. The repeat's picture is one from straight above, and gives the
// pattern; its means are made those of what is seen from here, where less of the gaps shows and more of the yarns' sides.
vec3 light_here()
{
    float finest = max(length(dFdx(crossing)), length(dFdy(crossing))); // crossings in a pixel
    vec3 here = texture(repeat_light, crossing / period, 1.5 * smoothstep(0.3, 0.7, finest)).rgb;
    here = mix(above, here, 0.5 + 0.5 * steepness); // flatter from the side
    float seen_through = min((1.0 - mean.b) / max(1.0 - above.b, 0.001), 1.0);
    float in_gaps = 0.7 * (1.0 - seen_through); // of the mean light, where one sees yarns below instead of the background
    vec2 wanted = mean.rg * (1.0 - in_gaps * (1.0 - above.b));
    vec2 times = min(wanted / max(above.rg, 0.001), 1.6);
    return vec3(here.rg * times + (wanted - above.rg * times) + in_gaps * (1.0 - here.b) * mean.rg, (1.0 - here.b) * seen_through);
}

void main()
{
#ifdef FADING
    if (left_out(fade))
        discard;
#endif
    vec3 light = light_here();
    vec2 share = crossing / crossings;
    vec3 end_dry = texture(end_colors, vec2(share.x, 0.5)).rgb, pick_dry = texture(pick_colors, vec2(share.y, 0.5)).rgb;
    vec2 which = floor(crossing);
    if (marked.x == 0 && float(marked.y) == which.x)
        end_dry = mix(end_dry, marked_color, 0.7);
    if (marked.x == 1 && float(marked.y) == which.y)
        pick_dry = mix(pick_dry, marked_color, 0.7);
    vec2 amount = water_scale > 0.0 ? texture(water, share).rg * water_scale : vec2(0.0);
    vec3 end_base = wetted(ramp, end_dry, amount.r, bare), pick_base = wetted(ramp, pick_dry, amount.g, bare);
    float thin = clamp((belt.x * gl_FragCoord.w - belt.y) / (belt.z - belt.y), 0.0, 1.0);
    vec2 part = mean.rg / max(mean.r + mean.g, 0.001);
    float wet = dot(part, vec2(under_water(amount.r), under_water(amount.g)));
    float glossy = 1.0 - dot(part, vec2(stained(amount.r, bare), stained(amount.g, bare)));
    color = vec4(end_base * light.r + pick_base * light.g + background * light.b + glossy * gloss(shine.x, shine.y, wet), 1.0 - over_tubes * thin);
}
