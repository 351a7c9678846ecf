// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The lines of a WIF file, sorted into sections; tolerant of all that drafting programs are known to write.
#pragma once

#include "core/base/text.h"
#include "core/project/draft_import.h"

namespace hygroloom {

constexpr std::size_t longest_name = 200; ///< bytes, of a fabric

struct WifEntry {
    std::string_view key;
    std::string_view value;
};

struct WifSection {
    std::string name;                    ///< capitals, single spaces
    std::vector<WifEntry> entries;       ///< in the file's order; a later one of the same key counts
    std::vector<std::string_view> lines; ///< of private sections, the header included
    int strays = 0;                      ///< lines that are no entries
};

/// Views into the text it was made from.
struct WifFile {
    std::vector<WifSection> sections;
    std::vector<ImportLine> remarks;

    const WifSection* find(std::string_view name) const;
    /// The value of a key in whatever case, of the section if it is there; empty values count as none.
    std::optional<std::string_view> value(std::string_view section, std::string_view key) const;
};

/// UTF-8 without a byte order mark, from UTF-8 or Windows-1252.
std::string decoded_text(std::string_view bytes, const std::string& name);

/// A file's name without its folder and ending, in UTF-8.
std::string name_of_file(const std::string& path);
/// Takes the first line off, which LF, CR or both end.
std::string_view take_line(std::string_view& text);

WifFile parse_wif(std::string_view text);

/// Of a value that may have blanks around it. A decimal comma is understood.
std::optional<int> whole_number(std::string_view text);
std::optional<double> real_number(std::string_view text);
/// The same of what a value begins with, for WIF 1.1 lets a comment follow a number or a truth, "should be prefixed by a semicolon": 8
/// ends. rest: what follows the number, without blanks.
std::optional<int> leading_whole(std::string_view text, std::string_view* rest = nullptr);
std::optional<double> leading_real(std::string_view text);
std::optional<bool> truth(std::string_view text);
/// What stands before the first blank or semicolon.
std::string_view first_word(std::string_view text);
std::vector<std::string_view> parted(std::string_view text, char separator);
std::string_view trimmed(std::string_view text);
std::string capitals(std::string_view text);
bool is_wif_section(std::string_view name);

} // namespace hygroloom
