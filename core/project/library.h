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
    /// Keys of those of unsaid_keys() that its table leaves out: no yarn is another one by them, and an update leaves them.
    std::vector<std::string> unsaid;
    const Yarn& yarn() const { return design.fabrics[0].warp; }
};
/// What the trade's tables often leave out: turns and direction of the twist, and of the plies'; packing, class and irregularity.
const std::vector<std::string>& unsaid_keys();

/// Those of a user's library, as read_library() and write_library() do; the presets stay in it.
std::vector<LibraryYarn> read_yarns(const std::filesystem::path& path);
void write_yarns(const std::vector<LibraryYarn>& yarns, const std::filesystem::path& path);
/// A yarn of a design, with those of the design's materials that it names.
LibraryYarn library_yarn(const Design& design, const Yarn& yarn, const std::string& name);
/// Puts it into the list; one of the same name is replaced.
void keep_yarn(std::vector<LibraryYarn>& yarns, LibraryYarn yarn);

/// Puts a yarn or a fabric into the library at path, in place of one of the same name. Meanwhile others that change it wait. Throws
/// FileError.
void keep_in_library(LibraryYarn yarn, const std::filesystem::path& path);
void keep_in_library(Preset preset, const std::filesystem::path& path);

/// A library's yarn for a design, which gets its materials unless it has the same. It refers to the library's.
Yarn take_yarn(Design& design, const LibraryYarn& from);

/// A number, or the fibres or the core, in which a yarn is not as the library has it.
struct YarnChange {
    std::string key;           ///< in the project file
    std::string label;         ///< "Twist"
    std::string before, after; ///< with unit: "14.8 tex"; empty: not given
};
/// In which a design's yarn is not the library's. Fibres are compared by what they are, in any order and under any name, their shares to
/// 1e-6, linear densities to 1e-4 of them; colour and number of drawn fibres are not compared, nor what the library does not say.
std::vector<YarnChange> changes_of_yarn(const Design& design, const Yarn& yarn, const LibraryYarn& of);
/// Whether it is the same yarn, dyed, priced or drawn otherwise.
bool same_yarn(const Design& design, const Yarn& yarn, const LibraryYarn& as);
/// Names of the design's fabrics that have the yarn, see same_yarn().
std::vector<std::string> fabrics_with(const Design& design, const LibraryYarn& yarn);
/// A yarn of a design that refers to one of the library.
struct YarnUpdate {
    std::string fabric, key;  ///< the fabric's name; the yarn's key there: "warp", "extra_yarns[0]"
    std::string library_yarn; ///< name
    bool is_missing = false;  ///< the library has no such yarn; it stays as it is
    std::vector<YarnChange> changes;
};
/// The library's yarn as it stands in the place of one of the design, which keeps what changes_of_yarn() does not tell. It refers to the
/// library's. The design gets the materials that it lacks.
Yarn yarn_in_place(Design& design, const Yarn& before, const LibraryYarn& by);
/// In all fabrics, as yarn_in_place() does. Returns each that was replaced, with what changed of it, which may be nothing.
std::vector<YarnUpdate> replace_yarn(Design& design, const LibraryYarn& old, const LibraryYarn& by);
/// Each yarn that refers to one of the library becomes that yarn; what changes_of_yarn() does not compare stays. Returns those that were
/// other ones, and those whose yarn is missing.
std::vector<YarnUpdate> update_yarns(Design& design, const std::vector<LibraryYarn>& library);

/// "cotton 60 + polyester 40", in percent.
std::string fibres_text(const Yarn& yarn);
/// The count as the trade of its fibre writes it, or in the fewest digits, so that it is read as it is: "Ne 60/2"; one that no four digits
/// tell in tex, with four; without a linear density the diameter: "0.2 mm".
std::string size_text(const Yarn& yarn);

/// A row a yarn, UTF-8. Columns: name, supplier, material ("cotton 60 + polyester 40", in percent), core ("elastane 5"), count ("Ne 60/2";
/// empty where four digits do not tell it, whose linear density and plies stand in their columns then), those of a yarn's numbers in the
/// project file, colours ("navy #101a40 + white #ffffff"), currency. Of materials the names stand in it, of its own colour nothing.
/// for_programs: a yarn with a count has its linear density and plies beside it, too, which yarns_of_csv() refuses.
std::string csv_of_yarns(const std::vector<LibraryYarn>& yarns, bool for_programs = false);
/// Reads the same; a column count ("Ne 60/2") may stand for linear density, plies and filaments, and columns may be left out that a valid
/// yarn does without. A yarn of a known one's name keeps its colour and what the table has no column for; an empty field clears. Where its
/// fibres or count change, what the table leaves out of unsaid_keys() is unsaid.
/// Throws Error naming file, line and field, also where a column is unknown, a name stands twice, the yarn is not valid or there is none.
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
