// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a mill needs to know of a cloth beside its setts: how it lies on the loom, what yarn a metre of it takes, what that yarn costs.
#pragma once

#include "core/design/fitted_fabric.h"

namespace hygroloom {

struct CardRequest {
    double width_cm = 0;      ///< of the finished cloth; 0: by the loom, else 150
    double waste_percent = 0; ///< of all yarn
    double tails_cm = 0;      ///< of weft beyond the reed, both sides together
    double length_m = 0;      ///< that is ordered; 0: none
};

/// One yarn of the warp or of the weft.
struct YarnConsumption {
    bool warp = true;
    int yarn = 0;     ///< as yarn_in() numbers it
    double share = 1; ///< of its system's threads
    double tex = 0;
    double crimp_percent = 0;   ///< how much longer the yarn is than the cloth
    double grams_per_metre = 0; ///< of finished cloth, with waste and tails
    std::optional<double> cost_per_metre;
    double take_up_percent() const { return 100 * crimp_percent / (100 + crimp_percent); } ///< of the yarn's length
};

/// The cloth on the loom; what is neither given nor follows is missing.
struct LoomState {
    std::optional<double> reed_width_cm, ends_per_cm, picks_per_cm;
    std::optional<double> dents_per_10_cm;
    std::optional<double> width_shrinks_percent, length_shrinks_percent; ///< from loom to finished cloth, of the finished one
};

struct TechnicalCard {
    double width_cm = 0;
    double ends = 0; ///< of the whole width
    LoomState loom;
    std::vector<YarnConsumption> yarns;
    double grams_per_metre = 0;
    std::optional<double> yarn_cost_per_metre; ///< where every yarn that is used has a price
    std::vector<std::string> notes;
};

/// Warp: ends x tex x (1 + crimp); weft: picks x (reed width, else width x (1 + crimp), and tails) x tex. Without waste, tails and reed
/// width the grams over the width are the mass in g/m2. Precondition: validate() found no error.
TechnicalCard technical_card(const Fabric& fabric, const FittedFabric& fitted, const CardRequest& request = {});

/// Ends on the loom and in the finished cloth are the same threads: setts and widths go against each other.
LoomState loom_state(const Fabric& fabric, double width_cm);

} // namespace hygroloom
