// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What this program adds to a WIF file of its own: [PRIVATE HYGROLOOM FABRIC] with the fabric as JSON, its repeat and what its weave was.
#pragma once

#include "core/design/fabric.h"

namespace hygroloom {

constexpr char private_section[] = "PRIVATE HYGROLOOM FABRIC";
constexpr int most_tied_shafts = 32;        ///< with more, a liftplan is written
constexpr Color uncoloured{224, 224, 224};  ///< written for a yarn without a colour
constexpr double assumed_diameter_mm = 0.2; ///< of yarns the file does not describe

/// Tells which sett and diameter an imported fabric was given for want of better ones.
std::string assumed_numbers(const Fabric& fabric);

} // namespace hygroloom
