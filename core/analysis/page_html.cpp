// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/page.h"

#include "core/analysis/svg.h"
#include "core/base/base64.h"

#include <fmt/format.h>

namespace hygroloom {
namespace {

constexpr const char* style = R"(
body { font: 15px/1.45 system-ui, sans-serif; color: #22262e; background: #fff; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }
h1 { margin-bottom: 0; overflow-wrap: anywhere; } h2 { margin-top: 2rem; border-bottom: 1px solid #ccc; }
table { border-collapse: collapse; } td, th { padding: .15rem 1rem .15rem 0; text-align: left; vertical-align: top; }
td.number { text-align: right; font-variant-numeric: tabular-nums; }
figure { display: inline-block; margin: 0 1rem 1rem 0; vertical-align: top; } figure img { max-width: 28rem; } figcaption { color: #555; }
@media print { body { margin: 0; max-width: none; } h2, h3, figure, tr { break-inside: avoid; } h2, h3 { break-after: avoid; } }
)";

std::string html_of(const PageCell& cell)
{
    const char* tag = cell.kind == PageCell::Kind::heading ? "th" : "td";
    std::string lines = escaped_markup(cell.text);
    for (const std::string& line : cell.strong) lines += "<br><b>" + escaped_markup(line) + "</b>";
    if (!cell.below.empty()) lines += "<br>" + escaped_markup(cell.below);
    return fmt::format("<{0}{1}{2}>{3}</{0}>", tag, cell.kind == PageCell::Kind::number ? " class=\"number\"" : "",
                       cell.columns > 1 ? fmt::format(" colspan=\"{}\"", cell.columns) : "", lines);
}

struct HtmlWriter {
    std::string html;

    void operator()(const PageHeading& heading) { html += fmt::format("<h{0}>{1}</h{0}>\n", heading.level, escaped_markup(heading.text)); }
    void operator()(const PageText& block)
    {
        const std::string strong = block.strong.empty() ? "" : "<b>" + escaped_markup(block.strong) + "</b> ";
        html += "<p>" + strong + escaped_markup(block.text) + "</p>\n";
    }
    void operator()(const PageList& block)
    {
        html += "<ul>\n";
        for (const std::string& one : block.sentences) html += "<li>" + escaped_markup(one) + "</li>\n";
        html += "</ul>\n";
    }
    void operator()(const PageTable& block)
    {
        html += "<table>\n";
        for (const PageRow& row : block.rows) {
            html += "<tr>";
            for (const PageCell& cell : row) html += html_of(cell);
            html += "</tr>\n";
        }
        html += "</table>\n";
    }
    void operator()(const PageDrawing& block) { figure(block.svg, block.caption); }
    void operator()(const PagePicture& block)
    {
        const bool scaled = block.width_mm > 0;
        const std::string width = scaled ? fmt::format(" style=\"width:{:.2f}mm;max-width:none\"", block.width_mm) : "";
        const char* bar = scaled ? "<div style=\"width:10mm;height:1mm;background:#000\"></div>10 mm" : "";
        figure(fmt::format("<img alt=\"{}\" src=\"data:image/png;base64,{}\"{}>{}", escaped_markup(block.caption), base64_of(block.png),
                           width, bar),
               block.caption);
    }
    void figure(const std::string& inside, const std::string& caption)
    {
        html += "<figure>" + inside + (caption.empty() ? "" : "<figcaption>" + escaped_markup(caption) + "</figcaption>") + "</figure>\n";
    }
};

} // namespace

std::string html_of(const ReportPage& page)
{
    HtmlWriter writer;
    for (const PageBlock& block : page.blocks) std::visit(writer, block);
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
        "content=\"width=device-width\">\n<title>{0}</title>\n<style>{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n{2}</body>\n</html>\n",
        escaped_markup(page.title), style, writer.html);
}

} // namespace hygroloom
