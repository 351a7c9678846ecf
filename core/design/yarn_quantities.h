// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Numbers of one yarn as it lies in the fabric, by formula alone: of the fabric's own and of those of its stripes.
#pragma once

#include "core/design/yarn_sections.h"

namespace hygroloom {

struct YarnQuantities {
    double linear_density_tex = 0;
    double diameter_mm = 0;              ///< of the free, round yarn
    double packing_factor = 0;           ///< of the free yarn
    Section section_mm;                  ///< in the fabric, at a crossing
    double area_share = 1;               ///< mean area along the yarn over that of section_mm
    double packing_factor_in_fabric = 0; ///< mean along the yarn
    double pitch_mm = 0;                 ///< from yarn to yarn
    double rise_mm = 0;                  ///< of the centreline, from side to side
    double crimp_percent = 0;
    double cover = 0; ///< sett x mean width, 1 = touching
    double fibre_radius_um = 0;
    double pore_radius_um = 0; ///< between the fibres: 2 x void area / wetted perimeter
    double contact_angle_deg = 0;
    double receding_angle_deg = 0;
    double helix_tortuosity = 1; ///< of the twisted fibres' way, see helix_tortuosity(); of the free yarn
    YarnClass yarn_class = YarnClass::ring;
    double shape = 1;             ///< height over width that its kind and twist give it: see usual_shape()
    bool class_assumed = false;   ///< the yarn does not say it
    bool packing_assumed = false; ///< the same
    bool flattened = false;       ///< section is not the free circle
};

/// How much longer than the yarn the way along its fibres is, squared: mean of 1 / cos2 of the helix angle over the section of an ideal
/// helix, 1 + (pi d T)2 / 2; of a plied yarn that of the plies in the yarn times that of the fibres in a ply, whose section is the yarn's
/// share. Round a core that takes so much of the section the mean is over the ring that is left, 1 + (pi d T)2 (1 + core) / 2. Derived
/// here. Diameter of the free yarn; meant for pi d T up to about 1, twist angles of 45 degrees at the skin.
double helix_tortuosity(const Yarn& yarn, double diameter_mm, double core = 0);

/// A fabric's yarns in their places.
struct WovenYarns {
    const Fabric& fabric;
    const FittedYarns& fitted;
    double warp_changes = 0; ///< share of crossings after which an end changes sides
    double weft_changes = 0;

    const std::vector<FittedYarn>& types(bool warp) const { return warp ? fitted.warp : fitted.weft; }
    const YarnOrder& order(bool warp) const { return warp ? fitted.warp_order : fitted.weft_order; }
    double sett_per_cm(bool warp) const { return warp ? fabric.ends_per_cm : fabric.picks_per_cm; }
    double pitch_mm(bool warp) const { return 10 / sett_per_cm(warp); }
    double changes(bool warp) const { return warp ? warp_changes : weft_changes; }
};

/// The fabric and its fitted yarns must outlive it.
WovenYarns woven_yarns(const Fabric& fabric, const FittedYarns& fitted);

/// One type of the warp's (weft's) yarns.
YarnQuantities yarn_quantities(const WovenYarns& yarns, bool warp, std::size_t type);

/// Crimp of one type over all it crosses, percent.
double crimp_percent(const WovenYarns& yarns, bool warp, std::size_t type);

/// Mean share of the pitch under a system's yarns: all types, in the shares they come in.
double mean_cover(const WovenYarns& yarns, bool warp);

/// An extra yarn, and how it lies among the ends and among the picks where their orders have it.
struct StripeYarn {
    FreeYarn free;
    double contact_angle_deg = 0;
    std::optional<YarnQuantities> as_end;
    std::optional<YarnQuantities> as_pick;
};

/// Of each extra yarn, from the yarns fitted without laboratory values.
std::vector<StripeYarn> stripe_yarns(const Design& design, const Fabric& fabric, const FittedYarns& fitted);

} // namespace hygroloom
