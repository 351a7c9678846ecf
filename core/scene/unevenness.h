// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Yarns that hold more fibres in one place than in another.
#pragma once

#include "core/geometry/textile.h"

#include <cstdint>
#include <vector>

namespace hygroloom {

/// Pores of each segment, m3, of yarns that have more fibres in one place than in another, within the same outline. Along a yarn places
/// some centimetres apart are alike. None where no yarn is uneven. lengths: m, of each segment.
std::vector<double> uneven_pores(const Textile& textile, const std::vector<double>& lengths, std::uint64_t seed);

} // namespace hygroloom
