// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How yarn reflects light: one text for the shaders and, through ui/picture/cloth_light.h, for C++, in words that both read. All is linear
// light; a white matt face square to a lamp gets that lamp's strength. n is a skin's normal, t the direction of its fibres.

const real lamp_strength = 0.86;
const real sky_strength = 0.22;  // from straight above
const real sky_below = 0.03;     // from elsewhere
const real film_zero = 0.0204;   // Fresnel's reflection of water square on: (0.333 / 2.333)^2
const real film_rough = 0.4;     // wet_roughness of core/project/wet_look.h
const real film_peak = 76.125;   // exponent of that roughness: 2 / film_rough^4 - 2 (Walter et al. 2007, as Blinn's lobe)
const real fibre_zero = 0.0465;  // the same of a fibre of refractive index 1.55 in air: between cellulose (1.53 to 1.60) and polyester
const real fibre_under = 0.0057; // and in water: (0.217 / 2.883)^2
const real surface_width = 0.21; // radian: 12 degrees, linen's of Sadeghi et al. 2013; we know no measurement of cotton
const real volume_width = 0.42;  // 24 degrees, the same
const real isotropic = 0.5;      // share of the light through fibres that has lost its direction: an assumption, they give 0.3

// A lamp over the viewer's left shoulder. side is 1 where the top face is looked at, else -1.
vec3 lamp_from(vec3 to_eye, real side)
{
    return normalize(vec3(-0.35, 0.3, 0.9 * side) + 0.5 * to_eye);
}

// Sky on whichever face is looked at, from a direction.
real sky_from(vec3 direction, real side)
{
    return sky_strength * (0.5 + 0.5 * direction.z * side) + sky_below;
}

// Where fibres lie on a skin of a yarn that runs along: wound by the tangent of their angle.
vec3 fibre_direction(vec3 n, vec3 along, real wound)
{
    vec3 straight = normalize(along - dot(n, along) * n + vec3(1e-5, 2e-5, 3e-5));
    return normalize(straight + wound * cross(straight, n));
}

// How much of a lamp fibres throw to the eye that lies off the cone which a smooth one would mirror into: Marschner et al. 2003, a bell over
// the mean of both inclinations, about half of the sum of their sines. width: radian.
real fibre_lobe(vec3 t, vec3 lamp, vec3 to_eye, real width)
{
    real off = 0.5 * (dot(t, lamp) + dot(t, to_eye)) / width;
    return exp(-0.5 * off * off);
}

// What a white skin of fibres sends back of sky and lamp without gloss. Light that went through fibres keeps their colour and part of their
// direction (Sadeghi et al. 2013, their linen: a bell of 24 degrees; 1.3 leaves the mean over a crossing about as it is).
real matt_light(vec3 n, vec3 t, vec3 lamp, vec3 to_eye, real side)
{
    real through = mix(1.3 * fibre_lobe(t, lamp, to_eye, volume_width), 1.0, isotropic);
    return sky_from(n, side) + lamp_strength * max(dot(n, lamp), 0.0) * through;
}

// Schlick 1994.
real fresnel(real zero, real cosine)
{
    return zero + (1.0 - zero) * pow(1.0 - clamp(cosine, 0.0, 1.0), 5.0);
}

// What a film of water mirrors. The lamp: Blinn's lobe, normalized, with the visibility of Kelemen and Szirmay-Kalos 2001. The sky: Fresnel's
// reflection of a rough surface (Lagarde 2011).
real film_shine(vec3 n, vec3 lamp, vec3 to_eye, real side)
{
    vec3 half_way = normalize(lamp + to_eye);
    real tilt = max(dot(lamp, half_way), 0.1);
    real lobe = 0.125 * (film_peak + 2.0) * pow(max(dot(n, half_way), 0.0), film_peak) / (tilt * tilt);
    real across = clamp(dot(n, to_eye), 0.0, 1.0);
    real grazing = film_zero + (1.0 - film_rough - film_zero) * pow(1.0 - across, 5.0);
    vec3 mirrored = 2.0 * dot(n, to_eye) * n - to_eye;
    return lamp_strength * max(dot(n, lamp), 0.0) * fresnel(film_zero, tilt) * lobe + grazing * sky_from(mirrored, side);
}

// What fibres in air mirror of the lamp at their skins, in water fibre_under / fibre_zero of it: the first lobe of Marschner et al. 2003, with
// the masking by neighbours that Sadeghi et al. 2013 use. White matt faces send the lamp's strength, mirrors pi times as much of its beam.
real fibre_shine(vec3 n, vec3 t, vec3 lamp, vec3 to_eye)
{
    real from = dot(t, lamp), into = dot(t, to_eye), between = dot(lamp, to_eye);
    real straight = sqrt(max((1.0 - from * from) * (1.0 - into * into), 1e-4));
    real half_round = sqrt(0.5 + 0.5 * clamp((between - from * into) / straight, -1.0, 1.0));
    real apart = 0.5 * (into - from);
    real bell = fibre_lobe(t, lamp, to_eye, surface_width) / (2.5066 * surface_width);
    real mirrored = fresnel(fibre_zero, sqrt(0.5 + 0.5 * between));
    return 3.1416 * lamp_strength * max(dot(n, lamp), 0.0) * bell * mirrored * 0.25 * half_round / (1.0 - apart * apart);
}

// Gloss of a yarn by the share of its surface that is under water.
real gloss(real fibres, real film, real wet)
{
    return mix(fibres, fibres * (fibre_under / fibre_zero), wet) + wet * film;
}

// The deeper in the fabric, the less light. height: of half the thickness, towards the face that is looked at.
real light_at_depth(real height)
{
    return 0.55 + 0.45 * smoothstep(-1.0, 0.75, height);
}
