// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Numbers that follow from a fabric's description by formula alone, in trade units.
#pragma once

#include "core/base/message.h"
#include "core/design/yarn_quantities.h"

namespace hygroloom {

struct FabricQuantities {
    YarnQuantities warp;
    YarnQuantities weft;
    double cover_factor = 0;            ///< share of the area under yarns; c1 + c2 - c1 c2 where they keep their width
    double areal_density_g_m2 = 0;      ///< dry
    double yarn_layer_thickness_mm = 0; ///< of the interlaced yarns
    double thickness_mm = 0;            ///< with flyaway, or as given
    double thickness_1kpa_mm = 0;       ///< as given, or of the yarns and the fibres that stand out under 1 kPa
    double porosity = 0;                ///< 1 - areal density / (thickness x fibre density)
    double rough_porosity = 0;          ///< porosity less the share of flyaways: eps - k (1 - smoothness), k = 1, at least 0.01
    double fibre_volume_fraction = 0;   ///< of the yarn layer
    double gap_warp_mm = 0;             ///< between neighbouring ends
    double gap_weft_mm = 0;
    double inter_yarn_pore_radius_um = 0;       ///< hydraulic radius of the hole between four yarns
    double smoothness = 1;                      ///< 1 - volume of flyaway fibres / volume of the fabric
    double hair_surface = 0;                    ///< of the flyaway fibres on one face, over its area
    double finish_depth = default_finish_depth; ///< see Fabric::finish_depth
    double finish_holes = 0;                    ///< see Fabric::finish_holes
    bool jammed = false;                        ///< yarns cannot bend round each other without being squeezed
    std::vector<Message> notes;                 ///< what was done to the sections, in sentences
};

/// By formula alone, of a fabric with its yarns fitted. Sections keep the free linear density of their yarn; the thickness limits their
/// height and the pitch their width. Of what a laboratory measured, only a crimp is noted.
FabricQuantities quantities_of(const Fabric& fabric, const FittedYarns& fitted);

/// How much more fibre the yarns hold than their description says, by the measured areal density or else the measured porosity, for the
/// crimp and the thickness of these quantities; 1 when neither is given.
double fibre_scale(const FabricQuantities& quantities, const Measured& measured);

/// With what a laboratory measured in its place, and what follows from that.
FabricQuantities with_measured(FabricQuantities quantities, const Measured& measured);

} // namespace hygroloom
