// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Weaves from other programs: WIF drafts, grids of text, pictures. Each becomes a fabric and a report of what was understood and repaired.
#pragma once

#include "core/design/validate.h"

#include <filesystem>
#include <string_view>

namespace hygroloom {

constexpr std::size_t largest_import_bytes = 64u << 20;
constexpr int most_imported_threads = 100000; ///< before they are reduced to the repeat

/// One sentence; note: understood, warning: repaired or left out.
struct ImportLine {
    Severity severity = Severity::note;
    std::string text;
};

/// A number of the file that may be only the default of the program that wrote it.
struct Suggestion {
    std::optional<double> value;
    bool plausible = false;
    std::string why; ///< a sentence, when it is not
};

struct DraftImport {
    Fabric fabric; ///< ready to add to a design; sett and yarns are assumed unless numbers_are_ours
    std::vector<ImportLine> report;
    Suggestion ends_per_cm, picks_per_cm;
    Suggestion warp_diameter_mm, weft_diameter_mm;
    bool numbers_are_ours = false; ///< the file was written by this program: sett, yarns and materials are the fabric's own
};

/// By the file's content: PNG, BMP, WIF, else a grid of text. known: materials of the design the fabric will join.
/// Throws FileError with a sentence when there is no weave to be had from it.
DraftImport import_draft(const std::filesystem::path& path, const Design& known = {});
DraftImport import_wif(std::string_view bytes, const std::string& name, const Design& known = {});
/// Rows of 0 and 1, of . and #, or of spaces and x; the top row is the last pick.
DraftImport import_grid(std::string_view text, const std::string& name);
/// Dark is warp up; the top row is the last pick.
DraftImport import_picture(std::string_view bytes, const std::string& name);

/// Gives the fabric the suggested numbers that are plausible.
void take_suggestions(DraftImport& draft);

/// A WIF 1.1 file of the fabric: its draft, or the smallest one; colours per thread, sett and diameters in centimetres.
/// Precondition: validate() found no error in the fabric.
std::string format_wif(const Design& design, const Fabric& fabric);
/// Writes it atomically. Throws FileError.
void write_wif(const Design& design, const Fabric& fabric, const std::filesystem::path& path);

} // namespace hygroloom
