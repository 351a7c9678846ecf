// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/page.h"

#include "core/analysis/map_image.h"
#include "core/base/text.h"

#include <algorithm>
#include <cctype>
#include <iterator>

namespace hygroloom {
namespace {

/// What a cell says, in one line.
std::string in_line(const PageCell& cell)
{
    std::string text = cell.text;
    for (const std::string& line : cell.strong) text += ", " + line;
    return cell.below.empty() ? text : text + ", " + cell.below;
}

constexpr const char* between_columns = "  ";

std::size_t columns_taken(const PageCell& cell) { return static_cast<std::size_t>(std::max(cell.columns, 1)); }

/// How wide each column is. A text at a row's end and what takes several columns widen none.
std::vector<std::size_t> widths_of(const PageTable& table)
{
    std::vector<std::size_t> widths;
    for (const PageRow& row : table.rows) {
        std::size_t column = 0;
        for (const PageCell& cell : row) {
            const bool at_end = &cell == &row.back() && cell.kind != PageCell::Kind::number;
            widths.resize(std::max(widths.size(), column + columns_taken(cell)));
            if (!at_end && columns_taken(cell) == 1) widths[column] = std::max(widths[column], width_as_seen(in_line(cell)));
            column += columns_taken(cell);
        }
    }
    return widths;
}

/// Numbers are aligned right, texts and headings left.
std::string line_of(const PageRow& row, const std::vector<std::size_t>& widths)
{
    std::string line;
    std::size_t column = 0;
    for (const PageCell& cell : row) {
        const std::string text = in_line(cell);
        std::size_t width = width_as_seen(between_columns) * (columns_taken(cell) - 1);
        for (std::size_t i = 0; i < columns_taken(cell); ++i) width += widths[column + i];
        const std::string blanks(width - std::min(width, width_as_seen(text)), ' ');
        if (column > 0) line += between_columns;
        line += cell.kind == PageCell::Kind::number ? blanks + text : text + blanks;
        column += columns_taken(cell);
    }
    return line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
}

struct TextWriter {
    std::string text;

    void operator()(const PageHeading& heading)
    {
        text += "\n" + heading.text + "\n" + (heading.level == 2 ? rule(heading.text, '-') : "");
    }
    void operator()(const PageText& block) { text += (block.strong.empty() ? "" : block.strong + " ") + block.text + "\n"; }
    void operator()(const PageList& block)
    {
        for (const std::string& one : block.sentences) text += "- " + one + "\n";
    }
    void operator()(const PageTable& block)
    {
        const std::vector<std::size_t> widths = widths_of(block);
        for (const PageRow& row : block.rows) text += line_of(row, widths);
    }
    void operator()(const PageDrawing& block) { caption(block.caption.empty() ? "curves" : block.caption); }
    void operator()(const PagePicture& block) { caption(block.caption); }

    static std::string rule(const std::string& under, char mark) { return std::string(width_as_seen(under), mark) + "\n"; }
    void caption(const std::string& words)
    {
        if (!words.empty()) text += "[" + words + "]\n";
    }
};

} // namespace

PageBlocks joined(std::vector<PageBlocks> parts)
{
    PageBlocks all;
    for (PageBlocks& part : parts) std::move(part.begin(), part.end(), std::back_inserter(all));
    return all;
}

PageBlocks section(const std::string& title, PageBlocks body, int level)
{
    if (!body.empty()) body.insert(body.begin(), PageHeading{title, level});
    return body;
}

PageBlocks table(std::vector<PageRow> rows) { return rows.empty() ? PageBlocks() : PageBlocks{PageTable{std::move(rows)}}; }

PageBlocks list(std::vector<std::string> sentences)
{
    return sentences.empty() ? PageBlocks() : PageBlocks{PageList{std::move(sentences)}};
}

PageBlocks sentence(std::string text) { return {PageText{std::move(text)}}; }

PageBlocks blocks_of(const std::vector<ReportPicture>& pictures)
{
    PageBlocks blocks;
    for (const ReportPicture& picture : pictures)
        blocks.emplace_back(PagePicture{png_bytes(picture.image), picture.caption, picture.width_mm});
    return blocks;
}

PageRow row(const std::string& name, const std::string& value, const std::string& unit, const std::string& remark)
{
    PageRow made{{name, PageCell::Kind::heading}, {value, PageCell::Kind::number}, {unit}};
    if (!remark.empty()) made.push_back({remark});
    return made;
}

PageRow row_of_headings(const std::vector<std::string>& texts)
{
    PageRow made;
    for (const std::string& text : texts) made.push_back({text, PageCell::Kind::heading});
    return made;
}

std::string written_as(const ReportPage& page, const std::filesystem::path& file)
{
    std::string ending = file.extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending == ".html" ? html_of(page) : ending == ".txt" ? text_of(page) : ending == ".json" ? json_of(page) : std::string();
}

std::string text_of(const ReportPage& page)
{
    TextWriter writer{page.title + "\n" + TextWriter::rule(page.title, '=')};
    for (const PageBlock& block : page.blocks) std::visit(writer, block);
    return writer.text;
}

} // namespace hygroloom
