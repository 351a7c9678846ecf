// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What falls on or is fed into a cloth.
#pragma once

#include <string>
#include <vector>

namespace hygroloom {

/// At 20 C. At other temperatures each property follows that of water.
struct Liquid {
    std::string name;
    double surface_tension_mn_m = 72.74;
    double viscosity_mpa_s = 1.0016;
    double density_kg_m3 = 998.2;
    bool operator==(const Liquid&) const = default;
};

/// Water; "saline", 9 g/l of NaCl as management testers use; "sweat". Their sources stand in core/physics/README.md.
const std::vector<Liquid>& library_liquids();

} // namespace hygroloom
