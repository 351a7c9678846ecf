// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How uneven yarns are along their length where nobody says: by what they are spun of.
#pragma once

#include "core/design/design.h"

namespace hygroloom {

/// Coefficient of variation of the linear density of fibres that lie at random, as a fraction: the constant (106 % of cotton, 112 % of
/// wool, 100 % of cut man-made fibres; Martindale 1945, Uster) over the root of their number. Linear densities in one unit.
double limit_irregularity(double constant, double yarn_density, double fibre_density);

/// Whether a yarn is of continuous filaments: its class says so, it counts them, or it is of silk or man-made fibres with under 300
/// turns/m.
bool is_filament(const Design& design, const Yarn& yarn);

/// How the linear density goes up and down along a yarn.
struct Unevenness {
    double cv = 0;            ///< coefficient of variation, fraction
    double alike_over_mm = 0; ///< places farther apart have nothing in common, the nearer ones the more; of staple yarn, the fibres' length
};

/// Of a yarn as mills spin it: staple yarn an index (worsted 1.3, others 1.25; assumptions) times the limit, 25 % at most; filaments 1.5 %;
/// plies even each other out by the root of their number.
Unevenness typical_unevenness(const Design& design, const Yarn& yarn);

} // namespace hygroloom
