// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/garment/sweat_table.h"

#include "core/base/error.h"
#include "core/base/words.h"
#include "core/design/garment.h"
#include "core/project/atomic_file.h"
#include "core/project/csv_table.h"
#include "core/project/migrations.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace hygroloom {

extern const char body_sweat_json[];

namespace {

constexpr double most_sweat = 100000; // g/m2h, as an experiment's rate
constexpr std::size_t largest_table_bytes = 1u << 20;

SweatTable shipped(const ProjectJson& entry, const std::string& source)
{
    SweatTable table;
    for (const std::string& zone : body_zones()) table.g_m2_h.push_back(entry.at("zones").at(zone).get<double>());
    table.measured = entry.at("measured").get<bool>();
    table.source = source;
    return table;
}

SweatTable table_of(const CsvTable& csv)
{
    std::map<std::string, double> rates;
    std::vector<std::string> known = body_zones();
    known.emplace_back("default");
    for (std::size_t row = 0; row < csv.rows.size(); ++row) {
        const std::string& zone = csv.rows[row][0];
        const std::string at = fmt::format("{}: line {}: ", csv.file, csv.lines[row]);
        if (std::find(known.begin(), known.end(), zone) == known.end()) {
            std::string all;
            for (const std::string& word : known) all += (all.empty() ? "" : ", ") + word;
            throw FileError(fmt::format("{}There is no zone \"{}\" of the body{} There are {}.", at, zone, did_you_mean(zone, known), all));
        }
        const double rate = number_in(csv, row, 1, "g_m2_h");
        if (!(rate >= 0 && rate <= most_sweat))
            throw FileError(fmt::format("{}g_m2_h must be from 0 to {:g}; given is {:g}.", at, most_sweat, rate));
        if (!rates.emplace(zone, rate).second) throw FileError(fmt::format("{}The zone \"{}\" stands twice; leave one.", at, zone));
    }
    SweatTable table;
    std::string missing;
    for (const std::string& zone : body_zones()) {
        auto rate = rates.find(zone);
        if (rate == rates.end()) rate = rates.find("default");
        if (rate == rates.end())
            missing += (missing.empty() ? "" : ", ") + zone;
        else
            table.g_m2_h.push_back(rate->second);
    }
    if (!missing.empty()) throw FileError(fmt::format("{}: Zones are missing: {}. Give them, or a row \"default\".", csv.file, missing));
    table.source = csv.file;
    return table;
}

} // namespace

SweatTable sweat_table(const std::string& name_or_file, const std::filesystem::path& base)
{
    static const ProjectJson file = ProjectJson::parse(body_sweat_json);
    for (const ProjectJson& entry : file.at("tables"))
        if (entry.at("name").get<std::string>() == name_or_file) return shipped(entry, file.at("source").get<std::string>());
    const std::filesystem::path path = base / name_or_file;
    const std::string text = read_file(path, largest_table_bytes);
    try {
        return table_of(read_csv(text, path.string(), {"zone", "g_m2_h"}, {}));
    } catch (const FileError&) {
        throw;
    } catch (const Error& error) {
        throw FileError(error.what());
    }
}

} // namespace hygroloom
