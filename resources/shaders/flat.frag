in vec3 at;
in vec2 crossing;
flat in float fade;

uniform sampler2DArray repeat_picture; // see RepeatPicture
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
uniform float gap_depth;      // half the thickness of the fabric in widths of a gap
uniform vec3 belt;            // pixels of a pitch at depth 1, begin and end of the belt where tubes take over
uniform float over_tubes;     // 1: laid over tubes, the thinner the nearer

out vec4 color;

vec4 layer(float which)
{
    vec4 texel = texture(repeat_picture, vec3(crossing / period, which), -0.4);
    return vec4((texel.xyz * 255.0 - 128.0) / 127.0, texel.w);
}

void main()
{
#ifdef FADING
    if (left_out(fade))
        discard;
#endif
    vec3 to_eye = normalize(eye - at);
    vec3 lamp = lamp_direction(to_eye);
    float first = side > 0.0 ? 0.0 : 2.0;
    vec4 warp = layer(first), weft = layer(first + 1.0);
    float covered = texture(repeat_picture, vec3(crossing / period, 4.0), -0.4).r;
    vec2 share = crossing / crossings;
    vec3 end_dry = texture(end_colors, vec2(share.x, 0.5)).rgb, pick_dry = texture(pick_colors, vec2(share.y, 0.5)).rgb;
    vec2 which = floor(crossing);
    if (marked.x == 0 && float(marked.y) == which.x)
        end_dry = mix(end_dry, marked_color, 0.7);
    if (marked.x == 1 && float(marked.y) == which.y)
        pick_dry = mix(pick_dry, marked_color, 0.7);
    vec2 amount = water_scale > 0.0 ? texture(water, share).rg * water_scale : vec2(0.0);
    vec3 end_base = wetted(ramp, end_dry, amount.r, bare), pick_base = wetted(ramp, pick_dry, amount.g, bare);
    vec3 light = light_on(end_base, warp.xyz, warp.w, lamp) + light_on(pick_base, weft.xyz, weft.w, lamp);
    // One sees through the gaps the less the more from the side, and instead dark skins in the depth.
    float slant = length(to_eye.xy) / max(abs(to_eye.z), 0.01);
    float through = (1.0 - covered) * clamp(1.0 - gap_depth * slant, 0.0, 1.0);
    light += (1.0 - covered) * 0.12 * mix(end_base, pick_base, 0.5);
    float thin = clamp((belt.x * gl_FragCoord.w - belt.y) / (belt.z - belt.y), 0.0, 1.0);
    color = vec4(light * (1.0 - through) + background * through, 1.0 - over_tubes * thin);
}
