// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/wear/wear_report.h"

#include "core/analysis/line_chart.h"
#include "core/analysis/report_inputs.h"
#include "core/analysis/report_outcomes.h"
#include "core/base/units.h"
#include "core/base/version.h"
#include "core/project/project_json.h"
#include "core/wear/wear_outcomes.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace hygroloom {
namespace {

constexpr std::size_t most_curves = 8; ///< in one chart

std::string grams(double kg) { return fmt::format("{:.4g}", 1e3 * kg); }
/// Of water that was given: less than a billionth of it is rounding.
std::string grams(double kg, double given) { return std::abs(kg) < 1e-9 * given ? "0" : grams(kg); }

PageBlocks results(const WearMetrics& metrics, const ReaderUnits& units)
{
    const OutcomeRows found = outcome_rows(outcomes_of(metrics, metrics.all()), {}, units);
    std::string about = fmt::format("Cloth is wet with more than {:.0f} % of what it can hold, full with {:.0f} %, and dry with less than "
                                    "{:.0f} % of the most that it held.",
                                    100 * share_of_wet, 100 * share_of_full, 100 * share_of_dry);
    if (metrics.stops())
        about += *metrics.stops() > 0 ? fmt::format(" Drying counts from when the activity last falls, at {:.4g} s.", *metrics.stops())
                                      : " Drying counts from the start.";
    return joined({table(found.rows), list(found.notes), sentence(about)});
}

/// A row for each part, at the end.
PageBlocks parts_table(const char* title, const WearMetrics& metrics, const std::vector<WearPart>& parts, const ReaderUnits& units)
{
    std::vector<std::string> titles{title};
    for (const WearNumber& number : wear_numbers())
        if (number.decimals)
            titles.push_back(fmt::format("{}, {}", number.info.title, reader_unit(units, shown(number.info, 0).unit).unit));
    std::vector<PageRow> rows{row_of_headings(titles)};
    for (const WearPart& part : parts) {
        rows.push_back(row_of_headings({part.name}));
        for (const WearNumber& number : wear_numbers()) {
            if (!number.decimals) continue;
            const std::optional<double> value = number.value({metrics, part, part.course.back()});
            rows.back().push_back({value ? text_in_table(number, *value, units) : "–", PageCell::Kind::number});
        }
    }
    return table(rows);
}

/// The largest parts, in their own order.
std::vector<const WearPart*> for_curves(const std::vector<WearPart>& parts)
{
    std::vector<const WearPart*> by_area, kept;
    for (const WearPart& part : parts) by_area.push_back(&part);
    std::stable_sort(by_area.begin(), by_area.end(), [](const WearPart* a, const WearPart* b) { return a->area > b->area; });
    by_area.resize(std::min(by_area.size(), most_curves));
    for (const WearPart& part : parts)
        if (std::find(by_area.begin(), by_area.end(), &part) != by_area.end()) kept.push_back(&part);
    return kept;
}

/// Of each name a part's number over time.
struct NamedCourse {
    std::string name;
    const WearPart& part;
    const char* key;
};

PageBlock chart_of(const WearMetrics& metrics, const char* title, const std::vector<NamedCourse>& lines)
{
    LineChart chart{title, "time, s", shown(wear_number(lines.front().key).info, 0).unit, {}, {}};
    for (const WearNow& now : metrics.all().course) chart.x.push_back(now.time);
    for (const NamedCourse& line : lines) chart.curves.push_back({line.name, course_of(metrics, line.part, line.key)});
    return PageDrawing{svg_of(chart)};
}

PageBlocks curves(const WearMetrics& metrics)
{
    const WearPart& all = metrics.all();
    if (all.course.size() < 2) return {};
    PageBlocks figures{chart_of(metrics, "Wet area", {{"all", all, "wet_area_m2"}}),
                       chart_of(metrics, "Water",
                                {{"in the cloth", all, "water_g"},
                                 {"of it at the skin's face", all, "water_inside_g"},
                                 {"evaporated", all, "evaporated_g"},
                                 {"on the skin", all, "on_skin_g"}})};
    for (const auto& [title, parts] : {std::pair{"Water by panel", &metrics.panels()}, {"Water by zone of the body", &metrics.zones()}}) {
        std::vector<NamedCourse> lines;
        for (const WearPart* part : for_curves(*parts)) lines.push_back({part->name, *part, "water_g_m2"});
        figures.push_back(chart_of(metrics, title, lines));
    }
    const bool some = metrics.panels().size() > most_curves || metrics.zones().size() > most_curves;
    if (some) figures.emplace_back(PageText{fmt::format("Of panels and zones the {} largest.", most_curves)});
    return figures;
}

PageBlocks balance(const WearMetrics& metrics)
{
    const Ledger& ledger = metrics.ledger();
    const double evaporated = ledger.water_evaporated, given = ledger.water_delivered;
    return table({row("in the cloth at the start", grams(metrics.at_start()), "g"), row("sweat", grams(metrics.sweat()), "g"),
                  row("in the cloth", grams(metrics.all().course.back().water), "g", "liquid and bound by fibres"),
                  row("on the skin", grams(ledger.water_free, given), "g"),
                  row(evaporated < 0 ? "taken from the air" : "evaporated", grams(std::abs(evaporated), given), "g"),
                  row("dripped", grams(ledger.water_dripped, given), "g"),
                  row("not accounted for", fmt::format("{:.1g}", metrics.imbalance()), "of all water")});
}

PageBlocks assumed(const WearRecord& record)
{
    std::vector<std::string> sentences{
        fmt::format("The skin holds a film of up to {:.0f} g/m² under the cloth; more drips.", 1e6 * skin_film),
        fmt::format("Where cloth lies on the skin, {:.1f} mm of still air are between them.", 1e3 * contact_gap),
        "All sweat comes to the cloth, whether it touches or not; no vapour crosses the gap, and no air moves in it.",
        "Zones are those of a standing body of 1.75 m.", "Computed in " + record.layout.cells_in_words + "; yarns are even."};
    const Garment* garment = find_garment(record.design, record.layout.garment);
    if (garment != nullptr)
        sentences.push_back(
            "Sweat by zones: " + garment->wearer.zones +
            fmt::format("; skin of {:g} °C, where no file says otherwise.", celsius_from_kelvin(record.layout.skin_temperature)));
    if (garment != nullptr)
        for (const OwnZone& zone : garment->wearer.own_zones)
            sentences.push_back(
                fmt::format("The zone {} of its own, on the panel {}: {:g} g/m²h.", zone.name, zone.panel, zone.sweat_g_m2_h));
    const WearExperiment* wear = find_wear(record.design, record.layout.experiment);
    if (wear != nullptr && !wear->activity_file.empty())
        sentences.push_back("Rates over time, of the zones that it names: " + wear->activity_file + ".");
    return joined({list(sentences), sentence("No interval stands beside these numbers: their error has not been measured on garments. "
                                             "The guide's page on limits names what is left out.")});
}

/// The garment, its experiment and its fabrics, as the project has them.
PageBlocks input(const WearRecord& record, const ReaderUnits& units)
{
    Design used;
    if (const Garment* garment = find_garment(record.design, record.layout.garment)) used.garments.push_back(*garment);
    if (const WearExperiment* wear = find_wear(record.design, record.layout.experiment)) used.wears.push_back(*wear);
    std::set<std::string> names;
    for (const WearPanel& panel : record.layout.panels) names.insert(panel.fabric);
    for (const std::string& name : names)
        if (const Fabric* fabric = find_fabric(record.design, name)) used.fabrics.push_back(*fabric);
    const ProjectJson project = json_from_design(used);
    PageBlocks body;
    for (const auto& [key, name] : {std::pair{"garments", "Garment"}, {"experiments", "Experiment"}, {"fabrics", "Fabric"}})
        for (const ProjectJson& value : project.value(key, ProjectJson::array()))
            body = joined({body, table_of_inputs(name, value, units)});
    return body;
}

PageBlocks origin(const WearRecord& record, const WearMetrics& metrics)
{
    return table({row("program", std::string("Hygroloom ") + program_version(), ""), row("commit", program_commit(), ""),
                  row("garment", record.layout.garment, ""), row("experiment", record.layout.experiment, ""),
                  row("cells", std::to_string(record.layout.cells.size()), "", record.layout.cells_in_words),
                  row("fidelity", record.fidelity, ""), row("backend", record.backend, ""), row("device", record.device, ""),
                  row("simulated time", fmt::format("{:.4g}", metrics.all().course.back().time), "s"), row("started", record.date, "")});
}

} // namespace

std::vector<int> frames_for_report(const std::vector<double>& frames, const std::vector<double>& wanted)
{
    std::vector<double> times = wanted;
    for (int quarter = 1; times.size() < 4 && wanted.empty(); ++quarter) times.push_back(0.25 * quarter * frames.back());
    std::set<int> chosen;
    for (const double time : times) {
        std::size_t nearest = frames.size() - 1;
        for (std::size_t k = frames.size(); k-- > 0;)
            if (std::abs(frames[k] - time) < std::abs(frames[nearest] - time)) nearest = k;
        chosen.insert(static_cast<int>(nearest));
    }
    return {chosen.begin(), chosen.end()};
}

std::vector<ReportPicture> pictures_of_panels(const WearRecording& recording, const std::vector<int>& frames, const WearMapOptions& options)
{
    std::vector<std::shared_ptr<const WearFrame>> read;
    read.reserve(frames.size());
    for (const int number : frames) read.push_back(std::make_shared<const WearFrame>(recording.frame(number)));
    return pictures_of_panels(recording.record().layout, read, options);
}

std::vector<ReportPicture> pictures_of_panels(const WearLayout& layout, const std::vector<std::shared_ptr<const WearFrame>>& frames,
                                              const WearMapOptions& options)
{
    std::vector<std::pair<double, WearMap>> maps;
    double most = 0;
    for (const auto& frame : frames) {
        maps.emplace_back(frame->time, wear_map(layout, *frame, options));
        most = std::max(most, maps.back().second.most());
    }
    std::vector<ReportPicture> pictures;
    for (auto& [time, map] : maps) {
        if (!options.steps) map.steps = even_steps(most);
        for (std::size_t panel = 0; panel < layout.panels.size(); ++panel)
            pictures.push_back({fmt::format("{}, at {:.4g} s", layout.panels[panel].name, time), panel_picture(layout, map, panel, time)});
    }
    return pictures;
}

std::vector<ReportPicture> pictures_on_one_scale(const std::vector<GarmentAtEnd>& garments, WearMapOptions& how)
{
    how.most = 0;
    double most = 0;
    for (const GarmentAtEnd& garment : garments) most = std::max(most, wear_map(*garment.layout, *garment.frame, how).most());
    how.most = most;
    std::vector<ReportPicture> pictures;
    for (const GarmentAtEnd& garment : garments)
        for (ReportPicture& picture : pictures_of_panels(*garment.layout, {garment.frame}, how)) {
            picture.caption = garment.name + ": " + picture.caption;
            pictures.push_back(std::move(picture));
        }
    return pictures;
}

ReportPage wear_report(const WearRecord& record, const WearMetrics& metrics, const std::vector<ReportPicture>& pictures, bool finished,
                       const ReaderUnits& units)
{
    const std::string origin_of_all =
        "Simulated, not measured." +
        (finished ? std::string() : fmt::format(" The run was stopped at {:.4g} s.", metrics.all().course.back().time));
    return {
        record.layout.garment + ", " + record.layout.experiment,
        joined({sentence(origin_of_all), section("Results", results(metrics, units)),
                section("Panels", parts_table("panel", metrics, metrics.panels(), units)),
                section("Zones of the body", parts_table("zone", metrics, metrics.zones(), units)), section("Maps", blocks_of(pictures)),
                section("Over time", curves(metrics)), section("Balance", balance(metrics)), section("Assumed", assumed(record)),
                section("Inputs", input(record, units)), section("Computation", origin(record, metrics))})};
}

} // namespace hygroloom
