// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The surface of a yarn or a fibre, and the inside where a plane cuts it.
in vec3 at;
in vec3 facing;
in float open;
in vec2 on_yarn;
in float wet;
flat in int is_weft;
flat in vec4 dry;           // alpha: turns per crossing, signed
flat in float chosen;
flat in float fade;
flat in float is_cut;
flat in float is_fibre;

uniform sampler2D ramp;       // colours of water
uniform float bare;           // share of full water below which the fabric's own colour shows
uniform vec4 cut;
uniform vec2 winding;          // of ends and of picks: a yarn's perimeter over the distance of crossings along it
uniform vec3 fibre_belt;      // pixels of a pitch at depth 1, begin and end of the belt where fibres take over

out vec4 color;               // alpha: share of the fibres in that belt

// Light on the ends of fibres in a plane that cuts a yarn.
float fibre_ends(vec2 plane)
{
    vec2 grid = plane * 26.0 / half_thickness * 0.3;
    grid.x += 0.5 * mod(floor(grid.y), 2.0);
    float blur = clamp(1.0 - 1.4 * max(fwidth(grid.x), fwidth(grid.y)), 0.0, 1.0);
    return 0.60 - 0.38 * blur * (smoothstep(0.28, 0.46, length(fract(grid) - 0.5)) - 0.5);
}

// The inside of a yarn is only seen where it is cut: shown as a flat cut, with the ends of its fibres.
vec3 cut_face(vec3 base, vec3 from, vec3 towards)
{
    float along = (cut.w - dot(cut.xyz, from)) / dot(cut.xyz, towards);
    vec3 q = from + along * towards;
    return base * fibre_ends(abs(cut.x) > 0.5 ? q.yz : abs(cut.y) > 0.5 ? q.xz : q.xy);
}

// Of a fibre: across the yarn and up, the rest along it.
vec3 own_direction()
{
    float rest = sqrt(max(1.0 - dot(on_yarn, on_yarn), 0.0));
    return is_weft == 1 ? vec3(rest, on_yarn) : vec3(on_yarn.x, rest, on_yarn.y);
}

void main()
{
#ifdef FADING
    if (left_out(fade))
        discard;
#endif
    float fibres = clamp((fibre_belt.x * gl_FragCoord.w - fibre_belt.y) / (fibre_belt.z - fibre_belt.y), 0.0, 1.0);
    vec3 to_eye = normalize(eye - at);
    vec3 base = wetted(ramp, mix(dry.rgb, marked_color, 0.7 * chosen), wet, bare);
    if (!gl_FrontFacing) {
        color = vec4(cut_face(base, at, -to_eye), fibres);
        return;
    }
    vec3 n = normalize(facing);

    // Fibres wind round the yarn; they fade where they are finer than a pixel.
    float phase = 11.0 * (on_yarn.y - dry.a * on_yarn.x);
    float blur = clamp(1.0 - 1.6 * fwidth(phase), 0.0, 1.0);
    float wave = 6.2831853 * phase;
    // Seen from near, single fibres among them.
    float fine_phase = 4.0 * phase + 0.35 * sin(wave + 5.0 * on_yarn.x);
    float fine = clamp(1.0 - 1.6 * fwidth(fine_phase), 0.0, 1.0);
    float fine_wave = 6.2831853 * fine_phase;
    vec3 along = is_weft == 1 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
    float on_skin = (1.0 - is_fibre) * (1.0 - is_cut);
    blur *= on_skin * (1.0 - 0.5 * fine);
    fine *= on_skin;
    vec3 around = normalize(cross(along, n) + vec3(1e-6));
    vec3 bent = normalize(n + (0.22 * blur * cos(wave) + 0.22 * fine * cos(fine_wave)) * around);
    float groove = 1.0 + 0.1 * blur * sin(wave) + 0.1 * fine * sin(fine_wave); // as bright as without, on the whole

    vec3 lamp = lamp_from(to_eye, side);
    vec3 t = is_fibre > 0.5 ? own_direction() : fibre_direction(bent, along, dry.a * (is_weft == 1 ? winding.y : winding.x));
    if (is_cut > 0.5) {
        t = n; // light goes in along the fibres
        groove = fibre_ends(is_weft == 1 ? at.yz : at.xz);
    }
    float shine = gloss(fibre_shine(bent, t, lamp, to_eye), film_shine(bent, lamp, to_eye, side), under_water(wet));
    float reach = open * light_at_depth(at.z * side / half_thickness), light = reach * groove * matt_light(bent, t, lamp, to_eye, side);
    float in_color = stained(wet, bare);
    color = vec4(base * mix(light, min(light, 1.0), in_color) + vec3(reach * (1.0 - in_color) * shine), fibres);
}
