// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/report_parts.h"

#include "core/analysis/svg.h"

#include <fmt/format.h>

namespace hygroloom {
namespace {

constexpr const char* style = R"(
body { font: 15px/1.45 system-ui, sans-serif; color: #22262e; background: #fff; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }
h1 { margin-bottom: 0; overflow-wrap: anywhere; } h2 { margin-top: 2rem; border-bottom: 1px solid #ccc; }
table { border-collapse: collapse; } td, th { padding: .15rem 1rem .15rem 0; text-align: left; vertical-align: top; }
td.number { text-align: right; font-variant-numeric: tabular-nums; }
figure { display: inline-block; margin: 0 1rem 1rem 0; vertical-align: top; } figure img { max-width: 28rem; } figcaption { color: #555; }
pre { background: #f4f4f2; padding: .7rem; overflow-x: auto; font-size: 12px; white-space: pre-wrap; }
@media print { body { margin: 0; max-width: none; } h2, figure, tr { break-inside: avoid; } h2 { break-after: avoid; } }
)";

std::string base64(std::string_view bytes)
{
    constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto byte = [&](std::size_t k) { return i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u; };
        const unsigned three = byte(0) << 16 | byte(1) << 8 | byte(2);
        for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : digits[three >> (18 - 6 * k) & 63u];
    }
    return text;
}

} // namespace

std::string page(const std::string& title, const std::string& body)
{
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
        "content=\"width=device-width\">\n<title>{0}</title>\n<style>{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n{2}</body>\n</html>\n",
        escaped_markup(title), style, body);
}

std::string row(const std::string& name, const std::string& value, const std::string& unit, const std::string& remark)
{
    return fmt::format("<tr><th>{}</th><td class=\"number\">{}</td><td>{}</td>{}</tr>\n", escaped_markup(name), escaped_markup(value),
                       escaped_markup(unit), remark.empty() ? "" : "<td>" + escaped_markup(remark) + "</td>");
}

std::string table(const std::string& rows) { return rows.empty() ? "" : "<table>\n" + rows + "</table>\n"; }

std::string list(const std::vector<std::string>& sentences)
{
    std::string items;
    for (const std::string& sentence : sentences) items += "<li>" + escaped_markup(sentence) + "</li>\n";
    return items.empty() ? "" : "<ul>\n" + items + "</ul>\n";
}

std::string section(const char* title, const std::string& body) { return body.empty() ? "" : fmt::format("<h2>{}</h2>\n{}", title, body); }

std::string figures_of(const std::vector<ReportPicture>& pictures)
{
    std::string body;
    for (const ReportPicture& picture : pictures)
        body += fmt::format("<figure><img alt=\"{0}\" src=\"data:image/png;base64,{1}\"><figcaption>{0}</figcaption></figure>\n",
                            escaped_markup(picture.caption), base64(png_bytes(picture.image)));
    return body;
}

} // namespace hygroloom
