// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How much each zone of the body sweats.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hygroloom {

struct SweatTable {
    std::vector<double> g_m2_h; ///< by body_zones()
    bool measured = false;      ///< else estimated, or nobody says
    std::string source;
};

/// A shipped table by its name, or a CSV with the columns zone and g_m2_h beside the project. Each zone stands there once, or "default"
/// stands for those that do not. Throws FileError, naming file, line and zone.
SweatTable sweat_table(const std::string& name_or_file, const std::filesystem::path& base);

} // namespace hygroloom
