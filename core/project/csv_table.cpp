// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/project/csv_table.h"

#include "core/base/error.h"

#include <csv.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>

namespace hygroloom {
namespace {

constexpr std::size_t most_rows = 100000;

struct Line {
    std::vector<std::string> fields;
    std::size_t number;
};

/// The fields of one line, by libcsv.
std::vector<std::string> fields_of(const std::string& line, char separator, const std::string& where)
{
    std::vector<std::string> fields;
    csv_parser parser;
    if (csv_init(&parser, CSV_STRICT | CSV_STRICT_FINI) != 0) throw Error(where + "There is no memory to read it.");
    const std::unique_ptr<csv_parser, void (*)(csv_parser*)> ends(&parser, csv_free);
    csv_set_delim(&parser, static_cast<unsigned char>(separator));
    const auto field = [](void* text, std::size_t length, void* into) {
        static_cast<std::vector<std::string>*>(into)->emplace_back(static_cast<const char*>(text), length);
    };
    const auto row = [](int, void*) {};
    if (csv_parse(&parser, line.data(), line.size(), field, row, &fields) != line.size() || csv_fini(&parser, field, row, &fields) != 0)
        throw Error(where + "A quote is missing or stands inside a field.");
    return fields;
}

std::vector<Line> lines_of(std::string text, const std::string& file)
{
    if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
    std::vector<Line> lines;
    char separator = ',';
    std::size_t number = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        std::string line = text.substr(at, end - at);
        at = end + 1;
        ++number;
        if (line.ends_with('\r')) line.pop_back();
        if (line.find_first_not_of(" \t") == std::string::npos || line.front() == '#') continue;
        if (lines.size() > most_rows) throw Error(fmt::format("{}: A table has at most {} rows; this one has more.", file, most_rows));
        if (lines.empty() && line.find(',') == std::string::npos && line.find(';') != std::string::npos) separator = ';';
        lines.push_back({fields_of(line, separator, fmt::format("{}: line {}: ", file, number)), number});
    }
    if (lines.empty()) throw Error(fmt::format("{}: The table is empty; its first line names the columns.", file));
    return lines;
}

std::string listed(const std::vector<std::string>& words)
{
    std::string all;
    for (const std::string& word : words) all += (all.empty() ? "" : ", ") + word;
    return all;
}

} // namespace

CsvTable read_csv(const std::string& text, const std::string& file, const std::vector<std::string>& required,
                  const std::vector<std::string>& optional)
{
    const std::vector<Line> lines = lines_of(text, file);
    const std::vector<std::string>& header = lines.front().fields;
    std::vector<std::string> wanted = required;
    wanted.insert(wanted.end(), optional.begin(), optional.end());
    std::vector<std::size_t> places;
    for (const std::string& name : wanted) {
        const auto found = std::find(header.begin(), header.end(), name);
        if (found == header.end() && places.size() < required.size())
            throw Error(fmt::format("{}: line {}: There is no column \"{}\"; a table has {}; given are {}.", file, lines.front().number,
                                    name, listed(required), listed(header)));
        if (std::count(header.begin(), header.end(), name) > 1)
            throw Error(fmt::format("{}: line {}: The column \"{}\" is named twice.", file, lines.front().number, name));
        places.push_back(static_cast<std::size_t>(found - header.begin()));
    }
    CsvTable table{file, {}, {}};
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const std::vector<std::string>& fields = lines[i].fields;
        if (fields.size() != header.size())
            throw Error(fmt::format("{}: line {}: A row needs {} fields as the header; this one has {}.", file, lines[i].number,
                                    header.size(), fields.size()));
        std::vector<std::string> row;
        row.reserve(places.size());
        for (const std::size_t place : places) row.push_back(place < fields.size() ? fields[place] : std::string());
        table.rows.push_back(std::move(row));
        table.lines.push_back(lines[i].number);
    }
    return table;
}

std::vector<std::string> csv_header(const std::string& text, const std::string& file) { return lines_of(text, file).front().fields; }

double number_in(const CsvTable& table, std::size_t row, std::size_t column, const std::string& name)
{
    const std::string& text = table.rows[row][column];
    double number = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failure != std::errc() || end != text.data() + text.size() || !std::isfinite(number))
        throw Error(fmt::format("{}: line {}: {} must be a number with a dot for its decimals; given is \"{}\".", table.file,
                                table.lines[row], name, text));
    return number;
}

} // namespace hygroloom
