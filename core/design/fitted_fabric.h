// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What follows from fitting a fabric's yarns. Made once per fabric: checks, shown numbers, the textile and its plan all read it.
#pragma once

#include "core/design/fabric_quantities.h"

#include <memory>

namespace hygroloom {

struct FittedFabric {
    FittedYarns yarns;               ///< with what a laboratory measured: what geometry and simulation use
    FabricQuantities measured;       ///< of these, with the laboratory's values in their places
    double fibre_scale = 1;          ///< how much more fibre the yarns hold than their description says
    FabricQuantities derived;        ///< by formula alone, laboratory values left aside
    std::vector<StripeYarn> stripes; ///< the same of each extra yarn
};

/// Precondition: the fabric's numbers are in range and its yarns fit; validate() found no error in it.
FittedFabric fit_fabric(const Design& design, const Fabric& fabric);
/// The same where fit_yarns() has already been called.
FittedFabric fit_fabric(const Design& design, const Fabric& fabric, FittedYarns yarns);

/// One of its values, where nothing else of it is needed.
inline FabricQuantities derive_quantities(const Design& design, const Fabric& fabric) { return fit_fabric(design, fabric).derived; }
inline FabricQuantities quantities_in_use(const Design& design, const Fabric& fabric) { return fit_fabric(design, fabric).measured; }

} // namespace hygroloom
