// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How near a sett is to the closest that a loom weaves: both systems together, and each alone by two rules of the trade.
#pragma once

#include "core/design/yarn_sections.h"

namespace hygroloom {

constexpr double usual_share_of_ashenhurst = 0.75; ///< three quarters of the limit are usual for a firm cloth

struct JamOfSystem {
    double sett_per_cm = 0;
    double ashenhurst_per_cm = 0; ///< the limit: yarns side by side, with room for the other system's yarn wherever they change sides
    double ashenhurst_percent = 0;
    double peirce_per_cm = 0; ///< the limit: round arcs touching, with the other system at its own sett
    double peirce_percent = 0;
};

struct JamGauge {
    JamOfSystem warp;
    JamOfSystem weft;
};

/// Yarns of one system, as the limit of both together needs them.
struct SettSystem {
    double tex = 0; ///< mean of its yarns
    double sett_per_cm = 0;
    double fibre_density_kg_m3 = 0;
};

/// Room that a weave's floats give: the closest square sett over that of plain weave. In the form of Milašius (J. Text. Inst. 91, 2000),
/// P1 = sqrt(3 R1 R2 / (3 R1 R2 - sum of gains over the free fields)): a field of a yarn is free where it passes a pair of crossed yarns
/// without changing sides. A free field gains (11 - n)/8, n: how many of the two yarns beside it change sides there. Of his six groups of
/// free fields that tells two apart by their published factors, twill 2/2 (1.265) and twill 3/1 (1.31); see DECISIONS.md.
double weave_factor(const Weave& weave);

/// The share of the limit of sett at which looms stop, by equal weavability of unbalanced setts (Brierley; Milašius 2008):
/// F = sqrt(3) d S2^(1/(1+u)) S1^(u/(1+u)) / P1, u = 2/3 sqrt(tex1/tex2), d the diameter of a solid yarn of the mean tex of all threads.
/// 1: solid round yarns jam in square cloth (Peirce); looms stop at about 0.9.
double sett_share(const SettSystem& warp, const SettSystem& weft, double weave_factor);
double sett_share_of_limit(const Fabric& fabric, const FittedYarns& yarns);
constexpr double most_sett_share = 0.9;

/// Whether the yarns cannot bend round each other even in the sections that they were flattened to, squeezed as close as they can be:
/// racetracks, as by Love (1954), of which both systems together ask for more height than there is.
bool racetracks_jam(const Fabric& fabric, const FittedYarns& yarns);

/// Whether Ashenhurst's rule, which is for square cloth, says something of these setts.
constexpr bool is_square(double ends_per_cm, double picks_per_cm)
{
    const double ratio = ends_per_cm / picks_per_cm;
    return ratio > 0.85 && ratio < 1.15;
}

/// Ashenhurst (1884), T = D r/(r + i), with the diameters of both systems: 10 r / (r own + i other) per cm. Peirce (1937), jammed round
/// yarns: cos a + cos b = 1 for the weave angles a, b of the two systems; carried over to weaves with floats as by Love (1954): where a
/// yarn passes over several, they lie side by side. Diameters are those of the free yarns, in mm.
JamGauge jam_gauge(const Weave& weave, double ends_per_cm, double picks_per_cm, double warp_diameter_mm, double weft_diameter_mm);

/// With the mean diameters of the free yarns, in the order they come in.
JamGauge jam_gauge(const Fabric& fabric, const FittedYarns& yarns);

} // namespace hygroloom
