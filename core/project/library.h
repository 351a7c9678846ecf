// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Fabrics to begin with: those that ship with the program, and those that a user keeps; and finishes.
#pragma once

#include "core/design/design.h"

#include <filesystem>

namespace hygroloom {

/// A fabric with the materials of its own that it needs.
struct Preset {
    std::string group; ///< "Cotton", "From the paper"
    std::string note;  ///< one sentence
    Design design;     ///< one fabric, whose name is the preset's; no experiments
    const Fabric& fabric() const { return design.fabrics[0]; }
};

/// Trade-typical constructions and the paper's textiles A to G, compiled in from resources/library/fabrics.json.
const std::vector<Preset>& shipped_presets();

/// A user's library. A file that is not there yet is an empty library. Throws FileError, naming the preset and the field.
std::vector<Preset> read_library(const std::filesystem::path& path);
/// Atomic; the previous version stays beside it. Throws FileError.
void write_library(const std::vector<Preset>& presets, const std::filesystem::path& path);

/// A fabric of a design as a preset, with those of the design's materials that its yarns name.
Preset preset_of(const Design& design, const Fabric& fabric, const std::string& group, const std::string& note);

/// Adds a preset's fabric to a design, and its materials unless the design has the same; names that are taken get a number.
/// Returns the fabric's index.
std::size_t add_preset(Design& design, const Preset& preset);

/// What a finish does to the fibres' wetting.
struct Finish {
    std::string name;
    double contact_angle_deg = 0; ///< advancing, of water
    std::string note;
};
const std::vector<Finish>& finishes();

} // namespace hygroloom
