// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the tests of garments share: patterns in a few words, panels folded onto a tube.
#pragma once

#include "core/base/error.h"
#include "core/garment/pattern.h"
#include "core/garment/readers.h"

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

namespace hygroloom {

inline const std::string garments = std::string(HYGROLOOM_SOURCE_DIR) + "/tests/data/garments/";

inline std::string bytes_of(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

inline void write_bytes(const std::filesystem::path& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

template <typename Act> std::string refusal_of(Act act)
{
    try {
        act();
    } catch (const FileError& error) {
        return error.what();
    }
    return {};
}

inline bool tells(const GarmentPattern& pattern, const std::string& words)
{
    for (const std::string& issue : pattern.issues)
        if (issue.find(words) != std::string::npos) return true;
    return false;
}

inline std::string all_issues(const GarmentPattern& pattern)
{
    std::string all;
    for (const std::string& issue : pattern.issues) all += issue + "\n";
    return all;
}

inline Garment from_file(const std::string& source)
{
    Garment garment;
    garment.source = source;
    return garment;
}

inline double area_of(const GarmentPattern& pattern)
{
    double area = 0;
    for (const PatternPanel& panel : pattern.panels) area += area_of(panel);
    return area;
}

/// Onto a tube about the body's axis, without stretch.
inline Vec3d folded(const FlatPlace& flat, double radius, bool behind)
{
    const double turn = flat[0] / radius, side = behind ? -1 : 1;
    return {side * radius * std::sin(turn), flat[1], side * radius * std::cos(turn)};
}

} // namespace hygroloom
