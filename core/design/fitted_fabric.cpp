// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/fitted_fabric.h"

namespace hygroloom {

FittedFabric fit_fabric(const Design& design, const Fabric& fabric) { return fit_fabric(design, fabric, fit_yarns(design, fabric)); }

FittedFabric fit_fabric(const Design& design, const Fabric& fabric, FittedYarns yarns)
{
    FittedFabric fitted;
    fitted.yarns = std::move(yarns);
    const FabricQuantities quantities = quantities_of(fabric, fitted.yarns);
    fitted.fibre_scale = fibre_scale(quantities, fabric.measured);
    fitted.measured = with_measured(quantities, fabric.measured);
    if (!fabric.measured.crimp_percent) { // nothing else that was measured changes how yarns fit
        fitted.derived = quantities;
        fitted.stripes = stripe_yarns(design, fabric, fitted.yarns);
        return fitted;
    }
    Fabric described = fabric;
    described.measured = {};
    const FittedYarns by_description = fit_yarns(design, described);
    fitted.derived = quantities_of(described, by_description);
    fitted.stripes = stripe_yarns(design, described, by_description);
    return fitted;
}

} // namespace hygroloom
