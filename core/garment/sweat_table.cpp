// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/garment/sweat_table.h"

#include "core/base/csv_table.h"
#include "core/base/error.h"
#include "core/base/words.h"
#include "core/design/garment.h"
#include "core/project/atomic_file.h"
#include "core/project/migrations.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace hygroloom {

extern const char body_sweat_json[];

namespace {

constexpr double most_sweat = 100000; // g/m2h, as an experiment's rate
constexpr std::size_t largest_table_bytes = 1u << 20, largest_course_bytes = 1u << 24;
constexpr double latest_moment = 1e6, coldest_skin = 10, warmest_skin = 45; // s; C, as a wearer's skin

SweatTable shipped(const ProjectJson& entry, const std::string& source)
{
    SweatTable table;
    for (const std::string& zone : body_zones()) table.g_m2_h.push_back(entry.at("zones").at(zone).get<double>());
    table.measured = entry.at("measured").get<bool>();
    table.source = source;
    return table;
}

std::string place_of(const CsvTable& csv, std::size_t row) { return fmt::format("{}: line {}: ", csv.file, csv.lines[row]); }

/// A zone of the body, one of the wearer's own, or "default".
const std::string& zone_in(const CsvTable& csv, std::size_t row, std::size_t column, const std::vector<std::string>& own = {})
{
    std::vector<std::string> known = body_zones();
    known.insert(known.end(), own.begin(), own.end());
    known.emplace_back("default");
    const std::string& zone = csv.rows[row][column];
    if (std::find(known.begin(), known.end(), zone) != known.end()) return zone;
    throw FileError(fmt::format("{}There is no zone \"{}\" of the body{} There are {}.", place_of(csv, row), zone,
                                did_you_mean(zone, known), listed(known)));
}

double number_within(const CsvTable& csv, std::size_t row, std::size_t column, const char* name, double least, double most)
{
    const double value = number_in(csv, row, column, name);
    if (!(value >= least && value <= most))
        throw FileError(fmt::format("{}{} must be from {:g} to {:g}; given is {:g}.", place_of(csv, row), name, least, most, value));
    return value;
}

SweatTable table_of(const CsvTable& csv)
{
    std::map<std::string, double> rates;
    for (std::size_t row = 0; row < csv.rows.size(); ++row) {
        const std::string& zone = zone_in(csv, row, 0);
        const std::string at = place_of(csv, row);
        const double rate = number_within(csv, row, 1, "g_m2_h", 0, most_sweat);
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

using Moments = std::vector<SweatMomentOfZone>;

/// Leaves out what lies between two that are like it.
Moments without_repeats(const Moments& all)
{
    Moments kept;
    const auto alike = [](const SweatMomentOfZone& a, const SweatMomentOfZone& b) {
        return a.g_m2_h == b.g_m2_h && a.skin_temperature_c == b.skin_temperature_c;
    };
    for (std::size_t i = 0; i < all.size(); ++i)
        if (i == 0 || !alike(kept.back(), all[i]) || (i + 1 < all.size() && !alike(all[i], all[i + 1]))) kept.push_back(all[i]);
    return kept;
}

SweatCourse course_of(const CsvTable& csv, const std::vector<std::string>& own)
{
    SweatCourse course;
    course.source = csv.file;
    course.rows = csv.rows.size();
    course.has_temperature =
        std::any_of(csv.rows.begin(), csv.rows.end(), [](const std::vector<std::string>& row) { return !row[3].empty(); });
    std::map<std::string, Moments> zones;
    for (std::size_t row = 0; row < csv.rows.size(); ++row) {
        SweatMomentOfZone moment;
        moment.time_s = number_within(csv, row, 0, "time_s", 0, latest_moment);
        const std::string& zone = zone_in(csv, row, 1, own);
        moment.g_m2_h = number_within(csv, row, 2, "g_m2_h", 0, most_sweat);
        if (course.has_temperature) {
            if (csv.rows[row][3].empty())
                throw FileError(fmt::format("{}skin_temperature_c is empty; give it in each row, from {:g} to {:g} C, or in none.",
                                            place_of(csv, row), coldest_skin, warmest_skin));
            moment.skin_temperature_c = number_within(csv, row, 3, "skin_temperature_c", coldest_skin, warmest_skin);
        }
        Moments& moments = zones[zone];
        if (moments.empty()) course.named.push_back(zone);
        course.first_time = row == 0 ? moment.time_s : std::min(course.first_time, moment.time_s);
        course.last_time = std::max(course.last_time, moment.time_s);
        if (!moments.empty() && moment.time_s < moments.back().time_s)
            throw FileError(fmt::format("{}Rows of a zone stand in order of time; time_s is {:g} after {:g}.", place_of(csv, row),
                                        moment.time_s, moments.back().time_s));
        if (moments.size() > 1 && moments[moments.size() - 2].time_s == moment.time_s)
            throw FileError(fmt::format("{}The zone \"{}\" stands there a third time at {:g} s; two rows at one time are a jump.",
                                        place_of(csv, row), zone, moment.time_s));
        moments.push_back(moment);
        if (moments.size() > most_moments_of_zone)
            throw FileError(
                fmt::format("{}A zone may have {} rows at most; \"{}\" has more.", place_of(csv, row), most_moments_of_zone, zone));
    }
    if (zones.empty()) throw FileError(csv.file + ": There is no row. Give time_s, zone and g_m2_h of one zone at least.");
    for (const std::string& zone : body_zones()) {
        auto found = zones.find(zone);
        if (found == zones.end()) found = zones.find("default");
        course.zones.push_back(found == zones.end() ? Moments{} : without_repeats(found->second));
    }
    for (const std::string& zone : own) {
        const auto found = zones.find(zone);
        course.zones.push_back(found == zones.end() ? Moments{} : without_repeats(found->second));
    }
    return course;
}

/// What reading a table says, as a FileError.
template <typename Read> auto from_csv(const Read& read)
{
    try {
        return read();
    } catch (const FileError&) {
        throw;
    } catch (const Error& error) {
        throw FileError(error.what());
    }
}

} // namespace

SweatTable sweat_table(const std::string& name_or_file, const std::filesystem::path& base)
{
    static const ProjectJson file = ProjectJson::parse(body_sweat_json);
    for (const ProjectJson& entry : file.at("tables"))
        if (entry.at("name").get<std::string>() == name_or_file) return shipped(entry, file.at("source").get<std::string>());
    const std::filesystem::path path = base / name_or_file;
    const std::string text = read_file(path, largest_table_bytes);
    return from_csv([&] { return table_of(read_csv(text, path.string(), {"zone", "g_m2_h"}, {})); });
}

SweatCourse sweat_course(const std::string& file, const std::filesystem::path& base, const std::vector<OwnZone>& own)
{
    std::vector<std::string> names;
    names.reserve(own.size());
    for (const OwnZone& zone : own) names.push_back(zone.name);
    const std::filesystem::path path = base / file;
    const std::string text = read_file(path, largest_course_bytes);
    return from_csv([&] { return course_of(read_csv(text, path.string(), {"time_s", "zone", "g_m2_h"}, {"skin_temperature_c"}), names); });
}

} // namespace hygroloom
