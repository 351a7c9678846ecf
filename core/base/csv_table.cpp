// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/base/csv_table.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/base/utf8.h"

#include <csv.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>

namespace hygroloom {
namespace {

constexpr std::size_t most_rows = 100000, longest_field = 1000;

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

/// The lines of a table and what stands between their fields.
struct Lines {
    std::vector<Line> lines;
    char separator = ',';
};

void refuse_no_text(const std::string& text, const std::string& file)
{
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
        throw Error(file + ": The text is UTF-16; save the table as CSV in UTF-8.");
    if (text.find('\0') != std::string::npos) throw Error(file + ": This is no text: it holds bytes of value 0.");
}

/// Takes a line off, which LF, CR or both end.
std::string next_line(const std::string& text, std::size_t& at)
{
    const std::size_t end = std::min(text.find_first_of("\n\r", at), text.size());
    std::string line = text.substr(at, end - at);
    at = end + (text.compare(end, 2, "\r\n") == 0 ? 2 : 1);
    return line;
}

/// By the first line: what stands between its fields.
char separator_of(const std::string& line, const std::string& where)
{
    if (line.find(',') != std::string::npos) return ',';
    if (line.find(';') != std::string::npos) return ';';
    if (line.find('\t') != std::string::npos)
        throw Error(where + "The columns are separated by tabs; save the table as CSV, with commas or semicolons between them.");
    return ',';
}

Lines lines_of(std::string text, const std::string& file)
{
    refuse_no_text(text, file);
    if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
    Lines all;
    bool is_given = false; // by a first line such as sep=;
    std::size_t number = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::string line = next_line(text, at), where = fmt::format("{}: line {}: ", file, ++number);
        if (!is_utf8(line)) throw Error(where + "The text is not UTF-8; save the table as CSV in UTF-8.");
        if (line.find_first_not_of(" \t") == std::string::npos || line.front() == '#') continue;
        if (all.lines.empty() && !is_given && line.size() == 5 && (line.starts_with("sep=") || line.starts_with("SEP="))) {
            is_given = true;
            all.separator = line[4];
            if (all.separator != ',' && all.separator != ';') separator_of(line.substr(4), where);
            continue;
        }
        if (all.lines.size() > most_rows) throw Error(fmt::format("{}: A table has at most {} rows; this one has more.", file, most_rows));
        if (all.lines.empty() && !is_given) all.separator = separator_of(line, where);
        all.lines.push_back({fields_of(line, all.separator, where), number});
        for (const std::string& field : all.lines.back().fields)
            if (field.size() > longest_field)
                throw Error(fmt::format("{}A field has up to {} characters; one has {} and begins with \"{}\".", where, longest_field,
                                        field.size(), in_one_line(cut_text(field, 40))));
    }
    if (all.lines.empty()) throw Error(fmt::format("{}: The table is empty; its first line names the columns.", file));
    return all;
}

} // namespace

CsvTable read_csv(const std::string& text, const std::string& file, const std::vector<std::string>& required,
                  const std::vector<std::string>& optional)
{
    const Lines all = lines_of(text, file);
    const std::vector<Line>& lines = all.lines;
    const std::vector<std::string>& header = lines.front().fields;
    std::vector<std::string> wanted = required;
    wanted.insert(wanted.end(), optional.begin(), optional.end());
    std::vector<std::size_t> places;
    for (const std::string& name : wanted) {
        const auto found = std::find(header.begin(), header.end(), name);
        if (found == header.end() && places.size() < required.size())
            throw Error(fmt::format("{}: line {}: There is no column \"{}\"; a table has {}; given are {}.", file, lines.front().number,
                                    name, column_list(required), column_list(header)));
        if (std::count(header.begin(), header.end(), name) > 1)
            throw Error(fmt::format("{}: line {}: The column \"{}\" is named twice.", file, lines.front().number, name));
        places.push_back(static_cast<std::size_t>(found - header.begin()));
    }
    CsvTable table{file, {}, {}, all.separator == ';'};
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

std::vector<std::string> csv_header(const std::string& text, const std::string& file) { return lines_of(text, file).lines.front().fields; }

std::string column_list(const std::vector<std::string>& names)
{
    constexpr std::size_t most = 20;
    std::string all;
    for (std::size_t i = 0; i < std::min(most, names.size()); ++i) all += (i == 0 ? "" : ", ") + in_one_line(cut_text(names[i], 40));
    return names.size() > most ? fmt::format("{} and {} more", all, names.size() - most) : all;
}

double number_in(const CsvTable& table, std::size_t row, std::size_t column, const std::string& name)
{
    std::string text = table.rows[row][column];
    const std::size_t comma = text.find(',');
    if (table.by_semicolons && comma != std::string::npos && text.find('.') == std::string::npos) text[comma] = '.';
    double number = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failure != std::errc() || end != text.data() + text.size() || !std::isfinite(number))
        throw Error(fmt::format("{}: line {}: {} must be a number with a dot for its decimals{}; given is \"{}\".", table.file,
                                table.lines[row], name, table.by_semicolons ? ", or a comma" : "",
                                in_one_line(cut_text(table.rows[row][column], 60))));
    return number;
}

} // namespace hygroloom
