// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Yarns that hold more fibres in one place than in another.
#pragma once

#include "core/scene/scene.h"

namespace hygroloom {

/// Pores of yarns that have more fibres in one place than in another, within the same outline. Along a yarn places some centimetres apart
/// are alike.
void add_unevenness(Scene& scene, const Textile& textile, std::uint64_t seed);

} // namespace hygroloom
