// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/page.h"

#include "core/analysis/map_image.h"
#include "core/base/text.h"

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
        std::vector<std::vector<std::string>> rows;
        for (const PageRow& row : block.rows) {
            rows.emplace_back();
            for (const PageCell& cell : row) rows.back().push_back(in_line(cell));
        }
        text += aligned_columns(rows);
    }
    void operator()(const PageDrawing& block) { caption(block.caption); }
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
