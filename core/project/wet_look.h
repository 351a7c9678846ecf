// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How cloth looks when it is wet: darker, since a film of water throws part of the light that leaves it back onto it, and smoother.
#pragma once

namespace hygroloom {

constexpr double water_index = 1.333;                      ///< refractive, of visible light at 20 C
constexpr double dry_roughness = 0.9, wet_roughness = 0.4; ///< of renderers, 0 .. 1: assumptions, nobody measured them on cloth

/// Share of light that gets through a smooth surface of water from above: Fresnel's formula.
constexpr double film_entry = 1 - (water_index - 1) / (water_index + 1) * ((water_index - 1) / (water_index + 1));
/// Share of diffuse light that a smooth surface of this refractive index throws back from outside: Fresnel's formulas over a half space.
double diffuse_reflection(double index);
/// Share of diffuse light that such a surface throws back from inside: 1 - (1 - diffuse_reflection) / index^2, by the law of cosines in
/// both media (Lekner and Dorf 1988, doi 10.1364/AO.27.001278).
double inner_reflection(double index);

/// Reflectance (0 .. 1, of linear light) of a rough surface under a film of water, of that of the dry one: light enters the film, is
/// reflected by the surface, and what the film throws back is reflected again, and so on. Lekner and Dorf 1988, after Angstroem 1925, with
/// the surface's own reflectance unchanged by the water; the gloss of the film itself is left to the renderer.
double wet_reflectance(double dry);

/// wet_share: of the surface that a film of water covers.
double roughness_at(double wet_share);
double reflectance_at(double dry, double wet_share);

} // namespace hygroloom
