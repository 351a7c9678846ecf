// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The table of measured scenes, which tradeoff writes and expectations read. Of a scene on a backend a row "scene" comes first, with what
// all its runs share; then a row for each fidelity, and one of what the reference itself lacks.
#include "core/base/csv_table.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/plan/expectation.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace hygroloom {

extern const char measured_scenes_csv[];

namespace {

struct CountColumn {
    const char* name;
    double SceneCounts::*value;
};
constexpr CountColumn count_columns[] = {{"drops", &SceneCounts::drops},
                                         {"landings", &SceneCounts::landings},
                                         {"drop_volume_m3", &SceneCounts::drop_volume},
                                         {"largest_drop_m3", &SceneCounts::largest_drop},
                                         {"landing_speed_m_s", &SceneCounts::landing_speed},
                                         {"sample_area_m2", &SceneCounts::sample_area},
                                         {"sample_edge_m", &SceneCounts::sample_edge},
                                         {"duration_s", &SceneCounts::duration},
                                         {"wet_share", &SceneCounts::wet_share},
                                         {"suction", &SceneCounts::suction},
                                         {"uptake_m3_s", &SceneCounts::uptake},
                                         {"pores_m", &SceneCounts::pores},
                                         {"drop_base", &SceneCounts::drop_base},
                                         {"capillarity_m3_s2", &SceneCounts::capillarity},
                                         {"viscosity_m2_s", &SceneCounts::viscosity},
                                         {"drawn_cubes", &SceneCounts::drawn_cubes},
                                         {"drawn_periods", &SceneCounts::drawn_periods},
                                         {"drawn_longest", &SceneCounts::drawn_longest}};
struct SizeColumn {
    const char* name;
    int ModelPlan::*value;
};
constexpr SizeColumn size_columns[] = {{"particles_per_droplet", &ModelPlan::particles_per_droplet},
                                       {"fibre_shells", &ModelPlan::fibre_shells},
                                       {"crossings_per_cell", &ModelPlan::crossings_per_cell},
                                       {"shown_ends", &ModelPlan::shown_ends},
                                       {"shown_picks", &ModelPlan::shown_picks}};
constexpr const char* scene_row = "scene";
constexpr const char* reference_row = "reference itself";
const std::string of_metric = "error_of_";

std::vector<std::string> columns_before_errors()
{
    std::vector<std::string> columns{"scene", "backend", "row", "device", "date", "type", "closure", "ends", "picks"};
    for (const CountColumn& column : count_columns) columns.emplace_back(column.name);
    for (const char* name : {"seconds", "bytes", "parts", "vapour_share"}) columns.emplace_back(name);
    for (const SizeColumn& column : size_columns) columns.emplace_back(column.name);
    columns.insert(columns.end(), {"frames", "error"});
    return columns;
}

/// One row, by the names of its columns. What is empty is left out.
struct TableRow {
    std::map<std::string, std::string> texts;
    std::map<std::string, double> numbers;
    std::map<std::string, double> errors; ///< by metric

    const std::string& text(const std::string& column) const
    {
        static const std::string empty;
        const auto found = texts.find(column);
        return found == texts.end() ? empty : found->second;
    }
    double number(const std::string& column) const
    {
        const auto found = numbers.find(column);
        return found == numbers.end() ? 0.0 : found->second;
    }
};

std::vector<TableRow> rows_of(const std::string& csv, const std::string& file)
{
    const std::set<std::string> words{"scene", "backend", "row", "device", "date", "type", "closure", "parts"};
    std::vector<std::string> columns = columns_before_errors();
    for (const std::string& column : csv_header(csv, file))
        if (column.starts_with(of_metric)) columns.push_back(column);
    const CsvTable table = read_csv(csv, file, columns, {});
    std::vector<TableRow> rows(table.rows.size());
    for (std::size_t r = 0; r < rows.size(); ++r)
        for (std::size_t c = 0; c < columns.size(); ++c) {
            const std::string& field = table.rows[r][c];
            if (field.empty()) continue;
            if (words.contains(columns[c]))
                rows[r].texts[columns[c]] = field;
            else if (columns[c].starts_with(of_metric))
                rows[r].errors[columns[c].substr(of_metric.size())] = number_in(table, r, c, columns[c]);
            else
                rows[r].numbers[columns[c]] = number_in(table, r, c, columns[c]);
        }
    return rows;
}

ModelPlan plan_of_scene(const TableRow& row)
{
    ModelPlan plan;
    plan.counts.type = row.text("type");
    plan.counts.closure = row.text("closure");
    for (const CountColumn& column : count_columns) plan.counts.*column.value = row.number(column.name);
    plan.region = {0, 0, static_cast<int>(row.number("ends")), static_cast<int>(row.number("picks"))};
    plan.segments = 2 * plan.region.ends * plan.region.picks;
    return plan;
}

/// "liquid wicking vapour?": those that are on, and those that are watched.
std::vector<PlannedPart> parts_of(const TableRow& row)
{
    std::vector<PlannedPart> parts;
    const std::string& words = row.text("parts");
    for (std::size_t at = 0; at < words.size();) {
        const std::size_t end = std::min(words.find(' ', at), words.size());
        PlannedPart part;
        part.name = words.substr(at, end - at);
        part.watched = part.name.ends_with('?');
        part.on = !part.watched;
        if (part.watched) part.name.pop_back();
        if (part.name == "vapour") part.share = row.number("vapour_share");
        parts.push_back(std::move(part));
        at = end + 1;
    }
    return parts;
}

/// shared: what all runs of the scene have in common.
MeasuredRun run_of(const TableRow& row, const ModelPlan& shared)
{
    MeasuredRun run{.plan = shared, .seconds = row.number("seconds"), .bytes = row.number("bytes")};
    run.plan.fidelity = fidelity_from_name(row.text("row"));
    run.plan.knobs = knobs_of(run.plan.fidelity);
    run.plan.counts.frames = row.number("frames");
    for (const SizeColumn& column : size_columns) run.plan.*column.value = static_cast<int>(row.number(column.name));
    run.plan.parts = parts_of(row);
    if (row.numbers.contains("error")) run.error = row.number("error");
    run.errors = row.errors;
    return run;
}

/// Both backends compute the same: where a scene's reference ran, or was refined, on one of them only, errors hold on the other as well.
void share_errors(std::vector<MeasuredScene>& scenes)
{
    for (MeasuredScene& scene : scenes)
        for (const MeasuredScene& other : scenes) {
            if (scene.name != other.name) continue;
            if (scene.reference_errors.empty()) scene.reference_errors = other.reference_errors;
            for (MeasuredRun& run : scene.runs)
                for (const MeasuredRun& same : other.runs)
                    if (!run.error && run.plan.fidelity == same.plan.fidelity) {
                        run.error = same.error;
                        run.errors = same.errors;
                        run.errors_from = other.device;
                    }
        }
}

using Fields = std::map<std::string, std::string>;

std::string number_text(double value, int digits) { return fmt::format("{:.{}g}", value, digits); }

void add_errors(Fields& row, const std::map<std::string, double>& errors)
{
    constexpr double next_to_nothing = 1e-6;
    for (const auto& [metric, error] : errors) row[of_metric + metric] = error < next_to_nothing ? "0" : number_text(error, 3);
}

Fields fields_of(const MeasuredScene& scene)
{
    const ModelPlan& plan = scene.runs.front().plan;
    Fields row{{"row", scene_row},
               {"device", scene.device},
               {"date", scene.date},
               {"type", plan.counts.type},
               {"closure", plan.counts.closure},
               {"ends", std::to_string(plan.region.ends)},
               {"picks", std::to_string(plan.region.picks)}};
    for (const CountColumn& column : count_columns) row[column.name] = number_text(plan.counts.*column.value, 6);
    return row;
}

Fields fields_of(const MeasuredRun& run)
{
    Fields row{{"row", name_of(run.plan.fidelity)}, {"frames", number_text(run.plan.counts.frames, 6)}};
    for (const SizeColumn& column : size_columns) row[column.name] = std::to_string(run.plan.*column.value);
    for (const PlannedPart& part : run.plan.parts) {
        if (part.on || part.watched) row["parts"] += (row["parts"].empty() ? "" : " ") + part.name + (part.on ? "" : "?");
        if (part.name == "vapour" && part.share) row["vapour_share"] = number_text(*part.share, 5);
    }
    if (run.seconds > 0) row["seconds"] = number_text(run.seconds, 5);
    if (run.seconds > 0) row["bytes"] = fmt::format("{:.0f}", run.bytes);
    if (run.error) row["error"] = number_text(*run.error, 4);
    add_errors(row, run.errors);
    return row;
}

} // namespace

std::string measured_csv(const std::vector<MeasuredScene>& scenes)
{
    std::vector<Fields> rows;
    std::set<std::string> metrics;
    const auto add = [&](const MeasuredScene& scene, Fields row) {
        row["scene"] = scene.name;
        row["backend"] = scene.backend;
        for (const auto& [column, text] : row)
            if (column.starts_with(of_metric)) metrics.insert(column);
        rows.push_back(std::move(row));
    };
    for (const MeasuredScene& scene : scenes) {
        if (scene.runs.empty()) continue;
        add(scene, fields_of(scene));
        for (const MeasuredRun& run : scene.runs) add(scene, fields_of(run));
        if (scene.reference_errors.empty()) continue;
        Fields reference{{"row", reference_row}};
        add_errors(reference, scene.reference_errors);
        add(scene, reference);
    }
    std::vector<std::string> columns = columns_before_errors();
    columns.insert(columns.end(), metrics.begin(), metrics.end());
    std::string text = fmt::format("{}\n", fmt::join(columns, ","));
    for (const Fields& row : rows)
        for (const std::string& column : columns) {
            const auto found = row.find(column);
            if (found != row.end()) text += csv_field(found->second);
            text += column == columns.back() ? '\n' : ',';
        }
    return text;
}

std::vector<MeasuredScene> measured_scenes(const std::string& csv, const std::string& file)
{
    std::vector<MeasuredScene> scenes;
    std::map<std::pair<std::string, std::string>, ModelPlan> shared;
    for (const TableRow& row : rows_of(csv, file)) {
        const std::string &name = row.text("scene"), &backend = row.text("backend"), &kind = row.text("row");
        const auto own = std::find_if(scenes.begin(), scenes.end(),
                                      [&](const MeasuredScene& scene) { return scene.name == name && scene.backend == backend; });
        if (kind == scene_row) {
            if (own != scenes.end()) throw Error(fmt::format("{}: \"{}\" on {} has two rows \"scene\".", file, name, backend));
            scenes.push_back({.name = name, .backend = backend, .device = row.text("device"), .date = row.text("date")});
            shared[{name, backend}] = plan_of_scene(row);
            continue;
        }
        if (own == scenes.end()) throw Error(fmt::format("{}: \"{}\" on {} has no row \"scene\" before its runs.", file, name, backend));
        if (kind == reference_row) {
            own->reference_errors = row.errors;
            continue;
        }
        try {
            own->runs.push_back(run_of(row, shared.at({name, backend})));
        } catch (const Error& error) {
            throw Error(fmt::format("{}: \"{}\" on {}: {}", file, name, backend, error.what()));
        }
    }
    share_errors(scenes);
    return scenes;
}

const std::vector<MeasuredScene>& shipped_measurements()
{
    static const std::vector<MeasuredScene> scenes = measured_scenes(measured_scenes_csv, "measured.csv");
    return scenes;
}

const std::vector<MeasuredScene>& shipped_measurements(const std::string& backend)
{
    static const std::map<std::string, std::vector<MeasuredScene>> scenes = [] {
        std::map<std::string, std::vector<MeasuredScene>> lists;
        for (const MeasuredScene& scene : shipped_measurements()) lists[scene.backend].push_back(scene);
        return lists;
    }();
    static const std::vector<MeasuredScene> none;
    const auto found = scenes.find(backend);
    return found == scenes.end() ? none : found->second;
}

} // namespace hygroloom
