// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#pragma once

#include <filesystem>

namespace hygroloom {

/// Where programs keep what they could find again: $XDG_CACHE_HOME, or $HOME/.cache, then hygroloom; empty where there is neither.
std::filesystem::path cache_folder();

} // namespace hygroloom
