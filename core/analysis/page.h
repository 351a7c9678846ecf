// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A report as a list of blocks, whatever it is printed as: HTML, PDF, text or JSON.
#pragma once

#include "core/analysis/image.h"

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace hygroloom {

struct PageCell {
    enum class Kind { text, number, heading };
    std::string text;
    Kind kind = Kind::text;
    std::vector<std::string> strong{}; ///< lines below it that stand out
    std::string below{};               ///< a line below these
    int columns = 1;                   ///< that it takes
};
using PageRow = std::vector<PageCell>;
struct PageTable {
    std::vector<PageRow> rows;
};
struct PageHeading {
    std::string text;
    int level = 2; ///< 3: of a part of the section
};
struct PageText {
    std::string text;
    std::string strong{}; ///< before it; it stands out
};
struct PageList {
    std::vector<std::string> sentences;
};
struct PageDrawing {
    std::string svg;
    std::string caption{};
};
struct PagePicture {
    std::string png; ///< the bytes of a file
    std::string caption;
    double width_mm = 0; ///< at true scale, with a bar of 10 mm under it; 0: as wide as the page has room
};
using PageBlock = std::variant<PageHeading, PageText, PageList, PageTable, PageDrawing, PagePicture>;
using PageBlocks = std::vector<PageBlock>;
struct ReportPage {
    std::string title;
    PageBlocks blocks;
};

struct ReportPicture {
    std::string caption;
    Image image;
    double width_mm = 0; ///< see PagePicture
};

PageBlocks joined(std::vector<PageBlocks> parts);
/// A heading and what follows it; nothing where nothing follows.
PageBlocks section(const std::string& title, PageBlocks body, int level = 2);
/// Nothing where there are no rows, or no sentences.
PageBlocks table(std::vector<PageRow> rows);
PageBlocks list(std::vector<std::string> sentences);
PageBlocks sentence(std::string text);
/// Throws Error when there is no memory for their files.
PageBlocks blocks_of(const std::vector<ReportPicture>& pictures);
/// A row of a name, a number, its unit and, if there is one, a remark.
PageRow row(const std::string& name, const std::string& value, const std::string& unit, const std::string& remark = "");
PageRow row_of_headings(const std::vector<std::string>& texts);

/// One file that needs nothing else, pictures and curves in it; for browsers and for their printers.
std::string html_of(const ReportPage& page);
/// UTF-8 for a terminal; of drawings and pictures their captions.
std::string text_of(const ReportPage& page);
/// {"title", "blocks": [{"heading", "level"}, {"text", "strong"}, {"list"}, {"table": rows of cells}, {"drawing": SVG, "caption"},
/// {"picture": PNG in base64, "caption", "width_mm"}]}, in order.
std::string json_of(const ReportPage& page);
/// The page as the file's ending asks: .html, .txt or .json, in small or capital letters; empty: another one.
std::string written_as(const ReportPage& page, const std::filesystem::path& file);
/// What json_of() wrote. Throws Error where the text is none such.
ReportPage page_from_json(const std::string& json);

} // namespace hygroloom
