// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The part of a garment's layout that its recording holds as JSON: all but cells and shape.
#pragma once

#include "core/wear/wear_layout.h"

namespace hygroloom {

constexpr long most_layout_cells = 100'000'000; ///< of a panel, and of a recording

std::string layout_json(const WearLayout& layout);
/// Throws FileError with the file's name and the place in it.
WearLayout layout_from(const std::string& text, const std::string& file);

} // namespace hygroloom
