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
/// Atomic; the previous version stays beside it, and the library's yarns stay in it. Throws FileError.
void write_library(const std::vector<Preset>& presets, const std::filesystem::path& path);

struct YarnColour {
    std::string name;
    Color color;
};
/// A yarn as it is sold, with the materials of its own that it needs.
struct LibraryYarn {
    std::string name, supplier;
    std::string currency; ///< of its price
    std::vector<YarnColour> colours;
    Design design; ///< one fabric, whose warp it is; no experiments
    const Yarn& yarn() const { return design.fabrics[0].warp; }
};
/// Those of a user's library, as read_library() and write_library() do; the presets stay in it.
std::vector<LibraryYarn> read_yarns(const std::filesystem::path& path);
void write_yarns(const std::vector<LibraryYarn>& yarns, const std::filesystem::path& path);
/// A yarn of a design, with those of the design's materials that it names.
LibraryYarn library_yarn(const Design& design, const Yarn& yarn, const std::string& name);
/// Puts it into the list; one of the same name is replaced.
void keep_yarn(std::vector<LibraryYarn>& yarns, LibraryYarn yarn);

/// A library's yarn for a design, which gets its materials unless it has the same.
Yarn take_yarn(Design& design, const LibraryYarn& from);
/// Whether it is the same yarn, dyed, priced or drawn otherwise.
bool same_yarn(Yarn a, Yarn b);
/// Names of the design's fabrics that have the yarn, see same_yarn().
std::vector<std::string> fabrics_with(const Design& design, const Yarn& yarn);
/// In all fabrics; each keeps its colour and its number of drawn fibres. How many fabrics changed.
int replace_yarn(Design& design, const Yarn& old, const LibraryYarn& by);

/// A row a yarn, UTF-8. Columns: name, supplier, material ("cotton 60 + polyester 40", in percent), core ("elastane 5"), those of a yarn's
/// numbers in the project file, colours ("navy #101a40 + white #ffffff"), currency. Of materials the names stand in it, of its own colour
/// nothing.
std::string csv_of_yarns(const std::vector<LibraryYarn>& yarns);
/// Reads the same; a column count ("Ne 60/2") may stand for linear density, plies and filaments, and columns may be left out that a valid
/// yarn does without. A yarn of a known one's name keeps its colour and materials. Throws Error naming file, line and field, also where a
/// column is unknown, a name stands twice or the yarn is not valid.
std::vector<LibraryYarn> yarns_of_csv(const std::string& text, const std::string& file, const std::vector<LibraryYarn>& known = {});

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
