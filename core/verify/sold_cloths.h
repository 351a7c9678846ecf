// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Cloths that were bought and measured: Rogak, Sipkens and others, Aerosol Science and Technology 2021, 55, 398, doi
// 10.1080/02786826.2020.1855321, data of its figures. Their constructions were not measured: intervals of them are tried.
#pragma once

#include "core/design/design.h"

#include <optional>

namespace hygroloom {

struct SoldCloth {
    const char* name;
    std::vector<MaterialShare> fibre;
    const char* weave;
    double areal_density = 0;               ///< g/m2
    std::optional<double> thickness_mm;     ///< at some 1 kPa
    double least_sett = 0, most_sett = 0;   ///< per cm, of ends and of picks, that cloths of such a mass and thickness are woven at
    std::vector<double> twists;             ///< per m; under 300 silk and polyester are of flat filaments
    std::optional<double> pressure_drop_pa; ///< of air at 4.9 cm/s, as bought
    bool raised = false;                    ///< with a nap, which no yarn of the drawn cloth has

    /// Of so many, from 0 at the least sett to 1 at the most.
    double sett(double place) const;
};
const std::vector<SoldCloth>& sold_cloths();
/// Precondition: there is one.
const SoldCloth& sold_cloth(const std::string& name);

/// With yarns whose linear density, alike in both systems, makes the cloth as heavy as it is; the thickness is not given.
Fabric fabric_of(const SoldCloth& cloth, double sett, double twist);

} // namespace hygroloom
