// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// measure: numbers, maps and reports from a recording.
#include "app/cli.h"
#include "app/cli_bar.h"
#include "app/cli_interrupt.h"
#include "app/cli_metrics.h"

#include "core/analysis/report.h"
#include "core/analysis/vtk_files.h"
#include "core/base/text.h"
#include "core/base/units.h"
#include "core/project/atomic_file.h"

#include <fmt/format.h>

namespace hygroloom {
namespace {

struct MeasureOptions : CommonOptions {
    std::string recording;
    std::string map;
    int cells = 2;
    double time = -1;
    std::string output;
    std::string report;
    std::string vtk;
    int every = 1;
};

void write_map(const Recording& recording, const MeasureOptions& options)
{
    MapSide side{};
    try {
        side = map_side_from_name(options.map);
    } catch (const Error& error) {
        throw Stop(exit_usage, error.what());
    }
    const std::string ending = std::filesystem::path(options.output).extension().string();
    if (ending != ".csv" && ending != ".png") throw Stop(exit_usage, "A map is written as .csv or .png; give one with -o.");

    const RunRecord& run = recording.run();
    const Frame frame = recording.frame(frame_at(recording, options.recording, options.time));
    const MapPicture picture = map_picture(run, frame, start_of_maps(run, recording.frame(0)), side, options.cells);
    if (ending == ".csv")
        write_cell_map_csv(picture.map, run, frame.time, side, options.output);
    else
        write_picture(picture, options.output);
    if (!options.quiet) fmt::print(stderr, "The map at {:.4g} s is in {}.\n", frame.time, options.output);
}

/// With maps of both faces at the moment of --time.
void write_report(const Recording& recording, const Metrics& metrics, const MeasureOptions& options)
{
    const RunRecord& run = recording.run();
    const Frame frame = recording.frame(frame_at(recording, options.recording, options.time));
    const Frame start = start_of_maps(run, recording.frame(0));
    MapPicture top = map_picture(run, frame, start, MapSide::top, options.cells);
    MapPicture bottom = map_picture(run, frame, start, MapSide::bottom, options.cells);
    top.image.most = bottom.image.most = std::max(top.map.maximum(), bottom.map.maximum()); // colours mean the same
    std::vector<ReportPicture> pictures;
    for (const auto& [name, picture] : {std::pair{"Top face", &top}, std::pair{"Bottom face", &bottom}})
        pictures.push_back(
            {fmt::format("{} after {:.4g} s", name, frame.time), draw_map(picture->map, picture->width, picture->height, picture->image)});
    write_file(options.report, report_html(run, metrics, pictures, recording.finished()));
    if (!options.quiet) fmt::print(stderr, "The report is in {}.\n", options.report);
}

void write_vtk_files(const Recording& recording, const MeasureOptions& options)
{
    std::atomic<bool> cancel{false};
    const InterruptCancels cancels(cancel);
    int frames = 0;
    try {
        FileBar bar(options.quiet);
        frames = write_vtk(recording, options.vtk, options.every, [&](double share) {
            bar.tell(share);
            return !cancel;
        });
    } catch (const Cancelled&) {
        throw Stop(exit_cancelled, "Cancelled. The frames so far are in " + options.vtk + ".");
    }
    if (!options.quiet) fmt::print(stderr, "{} frames are in {}; open yarns.pvd.\n", frames, options.vtk);
}

int measure(const MeasureOptions& options)
{
    if (!options.report.empty() && CLI::detail::to_lower(std::filesystem::path(options.report).extension().string()) != ".html")
        throw Stop(exit_usage, "A report is written as .html, which browsers print as PDF; \"" + options.report + "\" was given.");
    if (options.time >= 0 && options.map.empty() && options.report.empty())
        throw Stop(exit_usage, "--time is the moment of maps; give --map or --report, too.");
    if (options.map.empty() != options.output.empty()) throw Stop(exit_usage, "--map and -o go together: the side, and the file to write.");
    std::unique_ptr<Recording> recording;
    try {
        recording = std::make_unique<Recording>(options.recording);
    } catch (const FileError& error) {
        throw Stop(exit_invalid, error.what());
    }
    if (recording->frames() == 0) throw Stop(exit_invalid, options.recording + ": The recording has no frame.");
    if (!recording->finished() && !options.quiet)
        fmt::print(stderr, "{}: The recording was cut short at {:.4g} s.\n", options.recording, recording->ledgers().back().time);
    if (!options.map.empty()) write_map(*recording, options);
    MetricsCollector collector;
    collector.start(recording->run());
    for (int i = 0; i < recording->frames(); ++i) collector.add(recording->frame(i));
    const Metrics metrics = collector.metrics();
    if (!options.report.empty()) write_report(*recording, metrics, options);
    if (!options.vtk.empty()) write_vtk_files(*recording, options);
    print_metrics(recording->run(), metrics, options.json);
    return exit_ok;
}

void row(const char* name, double value, const char* unit) { fmt::print("  {:<34} {:>10.4g} {}\n", name, value, unit); }
void row(const char* name, const std::optional<double>& value, double factor, const char* unit, const char* why)
{
    if (value)
        row(name, *value * factor, unit);
    else
        fmt::print("  {:<34} {:>10} ({})\n", name, "-", why);
}

void print_stain(const Metrics& m)
{
    row("maximum wetted radius, top", mm_from_metre(m.maximum_wetted_radius_top), "mm");
    row("maximum wetted radius, bottom", mm_from_metre(m.maximum_wetted_radius_bottom), "mm");
    row("stain on top, half along warp", mm_from_metre(m.wetted_area_ellipse_warp), "mm");
    row("stain on top, half along weft", mm_from_metre(m.wetted_area_ellipse_weft), "mm");
}

void print_management(const ManagementIndices& m)
{
    const ManagementGrades g = management_grades(m);
    fmt::print("  {:<34} {:>10} {:>10}  grades\n", "", "top", "bottom");
    const auto both = [](const char* name, const std::string& top, const std::string& bottom, int top_grade, int bottom_grade) {
        fmt::print("  {:<34} {:>10} {:>10}  {} {}\n", name, top, bottom, top_grade, bottom_grade);
    };
    const auto text = [](const std::optional<double>& value) { return value ? fmt::format("{:.4g}", *value) : std::string("-"); };
    both("wetting time, s", text(m.top.wetting_time), text(m.bottom.wetting_time), g.wetting_time_top, g.wetting_time_bottom);
    both("absorption rate, %/s", text(m.top.absorption_rate), text(m.bottom.absorption_rate), g.absorption_rate_top,
         g.absorption_rate_bottom);
    both("maximum wetted radius, mm", text(m.top.maximum_wetted_radius), text(m.bottom.maximum_wetted_radius), g.maximum_wetted_radius_top,
         g.maximum_wetted_radius_bottom);
    both("spreading speed, mm/s", text(m.top.spreading_speed), text(m.bottom.spreading_speed), g.spreading_speed_top,
         g.spreading_speed_bottom);
    fmt::print("  {:<34} {:>10.4g} %           {}\n", "one-way transport", m.one_way_transport, g.one_way_transport);
    fmt::print("  {:<34} {:>10.4g}             {}\n", "overall capability (OMMC)", m.ommc, g.ommc);
    fmt::print("  {:<34} {}\n", "class (simulated)", fabric_class(m));
}

/// What its type of experiment reports.
void print_results(const RunRecord& run, const Metrics& m)
{
    const Experiment* experiment = find_experiment(run.design, run.experiment);
    switch (experiment ? experiment->type : ExperimentType::droplet) {
    case ExperimentType::droplet:
        print_stain(m);
        row("absorbency time", m.absorbency_time, 1, "s", "free liquid was left");
        break;
    case ExperimentType::horizontal_wicking:
        print_stain(m);
        row("absorbency time", m.absorbency_time, 1, "s", "free liquid was left");
        row("wicking rate", m.horizontal_rate, 1e6, "mm2/s", "nothing got wet");
        break;
    case ExperimentType::moisture_management:
        if (m.management) print_management(*m.management);
        break;
    case ExperimentType::vertical_wicking:
        if (!m.wicking) break;
        row("height", mm_from_metre(m.wicking->height), "mm");
        row("wicking rate", m.wicking->rate, 1e3, "mm/s^0.5", "the liquid did not rise");
        break;
    case ExperimentType::drying:
        if (!m.drying) break;
        row("steady drying rate", m.drying->rate, 3.6e6, "g/(m2 h)", "less than 70 % of the water dried");
        row("steady temperature",
            m.drying->steady_temperature ? std::optional(celsius_from_kelvin(*m.drying->steady_temperature)) : std::nullopt, 1, "C",
            "less than 70 % of the water dried");
        row("time to dry", m.drying->time_to_dry, 1, "s", "more than 4 % of the water were left");
        break;
    case ExperimentType::conditioning:
        if (!m.conditioning) break;
        row("regain at the start", m.conditioning->regain_start, "");
        row("regain at the end", m.conditioning->regain_end, m.conditioning->settled ? "" : "(still changing)");
        row("half of the change after", m.conditioning->half_time, 1, "s", "the regain did not change");
        row("warmer than the air by, at most", m.conditioning->peak_rise, "K");
        break;
    case ExperimentType::sweat: print_stain(m); break;
    }
}

} // namespace

MapPicture map_picture(const RunRecord& run, const Frame& frame, const Frame& start, MapSide side, int crossings_per_cell)
{
    const Textile& t = run.textile;
    MapPicture picture;
    picture.map = cell_map(t, frame, start, side, crossings_per_cell);
    picture.width = t.ends() * t.warp.pitch;
    picture.height = t.picks() * t.weft.pitch;
    const char* what = side == MapSide::top ? "top face" : side == MapSide::bottom ? "bottom face" : "water";
    picture.image.captions = {fmt::format("{}, {}", run.fabric, run.experiment),
                              fmt::format("{} after {:.4g} s, cells of {} x {}", what, frame.time, crossings_per_cell, crossings_per_cell)};
    if (side == MapSide::total) return picture;
    const Circle circle = wetted_circle(t, frame, side == MapSide::top ? Face::top : Face::bottom);
    if (circle.radius > 0) {
        picture.image.circle = circle;
        picture.image.captions.push_back(fmt::format("wetted radius {:.3g} mm", mm_from_metre(circle.radius)));
    }
    return picture;
}

void write_picture(const MapPicture& picture, const std::filesystem::path& path)
{
    write_png(draw_map(picture.map, picture.width, picture.height, picture.image), path);
}

void print_metrics(const RunRecord& run, const Metrics& m, bool json)
{
    if (json) {
        fmt::print("{}\n", metrics_json(run, m));
        return;
    }
    const Ledger& l = m.ledger;
    fmt::print("{}, {} ({}, {}, {} s)\n", run.fabric, run.experiment, name_of(run.plan.fidelity), run.backend, rounded_text(run.wall, 3));
    row("simulated", l.time, "s");
    print_results(run, m);
    row("water delivered", 1e6 * l.water_delivered, "mg");
    row("water free", 1e6 * l.water_free, "mg");
    row("water in the yarns' pores", 1e6 * l.water_liquid, "mg");
    row("water taken up by fibres", 1e6 * (l.water_bound + l.water_vapour - l.water_initial), "mg");
    row("water evaporated", 1e6 * l.water_evaporated, "mg");
    row("water dripped", 1e6 * l.water_dripped, "mg");
    row("water imbalance", 1e6 * l.water_imbalance(), "mg");
    if (!m.series.temperature_max.empty())
        row("highest temperature", celsius_from_kelvin(*std::max_element(m.series.temperature_max.begin(), m.series.temperature_max.end())),
            "C");
    const std::optional<double>& error = run.plan.expected_error;
    if (error && *error > 0) fmt::print("  {:<34} {:>10} %\n", "error to be expected", rounded_text(100 * *error, 2));
    for (const std::string& note : notes_of(run.plan)) fmt::print("  {}\n", note);
    for (const std::string& note : m.notes) fmt::print("  {}\n", note);
}

void add_measure(CLI::App& app, Verb& verb)
{
    auto options = std::make_shared<MeasureOptions>();
    CLI::App& measure_verb = *app.add_subcommand("measure", "Numbers, maps, reports and files for ParaView from a recording");
    measure_verb.footer("Example: hygroloom-cli measure cloth.hygrorec --map top --cells 2 -o top.png");
    measure_verb.add_option("recording", options->recording, "Recording (.hygrorec)")->required();
    measure_verb.add_option("--map", options->map, "Write a water map of the side top, bottom or total");
    measure_verb.add_option("--cells", options->cells, "Crossings along each side of a cell of the map")->check(CLI::Range(1, 1000));
    measure_verb.add_option("--time", options->time, "Take the frame nearest to this time, s, for maps; the last one otherwise")
        ->check(moment());
    measure_verb.add_option("-o,--output", options->output, "Map to write (.csv or .png)");
    const CLI::Validator given([](const std::string& text) { return text.empty() ? "no name is given" : ""; }, "");
    measure_verb.add_option("--report", options->report, "Write a page (.html) with results, maps, curves and all that went in")
        ->check(given);
    CLI::Option* vtk =
        measure_verb.add_option("--vtk", options->vtk, "Write yarns and liquid of all frames to this folder, for ParaView (.vtp, .pvd)")
            ->check(given);
    measure_verb.add_option("--every", options->every, "With --vtk: one frame out of so many")->check(CLI::Range(1, 1000000))->needs(vtk);
    add_common_options(measure_verb, *options);
    measure_verb.callback([&verb, options] { verb = [options] { return measure(*options); }; });
}

} // namespace hygroloom
