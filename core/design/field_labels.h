// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#pragma once

#include <string>
#include <string_view>

namespace hygroloom {

/// The label of the first row of that key, in small letters: "twist"; empty: no row has it.
std::string label_of_key(std::string_view key);

} // namespace hygroloom
