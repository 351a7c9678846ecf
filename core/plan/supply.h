// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How the water of an experiment comes to the cloth: how much, and in words.
#pragma once

#include "core/design/experiment.h"

#include <cstddef>
#include <string>

namespace hygroloom {

/// The sample that the water comes to.
struct DryCloth {
    double sample = 0;   ///< m2
    double capacity = 0; ///< kg/m2 that all pores hold
    double density = 0;  ///< kg/m3, of the liquid
};

/// Liquid that comes, kg; of a strip that hangs in liquid, what all its pores hold.
double delivered_water(const Experiment& experiment, const DryCloth& cloth);

/// One sentence. drops: that fall; delivered: kg.
std::string supply_in_words(const Experiment& experiment, std::size_t drops, double delivered);

} // namespace hygroloom
