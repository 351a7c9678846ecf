// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How much each zone of the body sweats.
#pragma once

#include "core/design/garment.h"

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

/// A zone of the body at one moment; between two of them it changes evenly, and two at one time are a jump.
struct SweatMomentOfZone {
    double time_s = 0;
    double g_m2_h = 0;
    double skin_temperature_c = 0; ///< where SweatCourse::has_temperature
    bool operator==(const SweatMomentOfZone&) const = default;
};

/// How zones sweat, and how warm their skin is, over time. Before a zone's first moment and after its last it is as in that one.
struct SweatCourse {
    /// By body_zones(), then by the wearer's own zones; empty: the wearer's table, or the own zone's rate, holds.
    std::vector<std::vector<SweatMomentOfZone>> zones;
    bool has_temperature = false;
    std::string source; ///< the file
    // What stood there.
    std::size_t rows = 0;
    std::vector<std::string> named;       ///< zones and "default", in order of their first rows
    double first_time = 0, last_time = 0; ///< s, of all rows
};

constexpr std::size_t most_moments_of_zone = 10'000;

/// A CSV beside the project with the columns time_s, zone, g_m2_h and, if it has that, skin_temperature_c. Rows of a zone stand in order of
/// time; "default" stands for all zones of the body that are not named. Throws FileError, naming file, line, field, range and value.
SweatCourse sweat_course(const std::string& file, const std::filesystem::path& base, const std::vector<OwnZone>& own = {});

} // namespace hygroloom
