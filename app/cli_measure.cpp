// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// measure: numbers and maps from a recording.
#include "app/cli.h"
#include "app/cli_metrics.h"

#include "core/analysis/map_image.h"
#include "core/base/units.h"
#include "core/sim/recording.h"

#include <fmt/format.h>

namespace hygroloom {
namespace {

struct MeasureOptions : CommonOptions {
    std::string recording;
    std::string map;
    int cells = 2;
    double time = -1;
    std::string output;
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
    const CellMap map = cell_map(run.textile, frame, recording.frame(0), side, options.cells);
    if (ending == ".csv") {
        write_cell_map_csv(map, run, frame.time, side, options.output);
    } else {
        MapImageOptions image;
        image.captions = {fmt::format("{}, {}", run.fabric, run.experiment),
                          fmt::format("{} after {:.4g} s, cells of {} x {}", options.map == "total" ? "water" : options.map + " face",
                                      frame.time, options.cells, options.cells)};
        if (side != MapSide::total) {
            const Circle circle = wetted_circle(run.textile, frame, side == MapSide::top ? Face::top : Face::bottom);
            if (circle.radius > 0) {
                image.circle = circle;
                image.captions.push_back(fmt::format("wetted radius {:.3g} mm", mm_from_metre(circle.radius)));
            }
        }
        write_png(draw_map(map, run.textile.ends() * run.textile.warp.pitch, run.textile.picks() * run.textile.weft.pitch, image),
                  options.output);
    }
    if (!options.quiet) fmt::print(stderr, "The map at {:.4g} s is in {}.\n", frame.time, options.output);
}

int measure(const MeasureOptions& options)
{
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
    print_metrics(recording->run(), collector.metrics(), options.json);
    return exit_ok;
}

} // namespace

void print_metrics(const RunRecord& run, const Metrics& m, bool json)
{
    if (json) {
        fmt::print("{}\n", metrics_json(run, m));
        return;
    }
    const auto row = [](const char* name, double value, const char* unit) { fmt::print("  {:<34} {:>10.4g} {}\n", name, value, unit); };
    const Ledger& l = m.ledger;
    fmt::print("{}, {} ({}, {}, {:.3g} s)\n", run.fabric, run.experiment, name_of(run.plan.fidelity), run.backend, run.wall);
    row("simulated", l.time, "s");
    row("maximum wetted radius, top", mm_from_metre(m.maximum_wetted_radius_top), "mm");
    row("maximum wetted radius, bottom", mm_from_metre(m.maximum_wetted_radius_bottom), "mm");
    if (m.absorbency_time)
        row("absorbency time", *m.absorbency_time, "s");
    else
        fmt::print("  {:<34} {:>10} (free liquid was left)\n", "absorbency time", "-");
    row("stain on top, half along warp", mm_from_metre(m.wetted_area_ellipse_warp), "mm");
    row("stain on top, half along weft", mm_from_metre(m.wetted_area_ellipse_weft), "mm");
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
    for (const std::string& note : m.notes) fmt::print("  {}\n", note);
}

void add_measure(CLI::App& app, Verb& verb)
{
    auto options = std::make_shared<MeasureOptions>();
    CLI::App& measure_verb = *app.add_subcommand("measure", "Numbers and maps from a recording");
    measure_verb.footer("Example: hygroloom-cli measure cloth.hygrorec --map top --cells 2 -o top.png");
    measure_verb.add_option("recording", options->recording, "Recording (.hygrorec)")->required();
    measure_verb.add_option("--map", options->map, "Write a water map of the side top, bottom or total");
    measure_verb.add_option("--cells", options->cells, "Crossings along each side of a cell of the map")->check(CLI::Range(1, 1000));
    measure_verb.add_option("--time", options->time, "Take the frame nearest to this time, s, for the map; the last one otherwise")
        ->check(moment());
    measure_verb.add_option("-o,--output", options->output, "Map to write (.csv or .png)");
    add_common_options(measure_verb, *options);
    measure_verb.callback([&verb, options] { verb = [options] { return measure(*options); }; });
}

} // namespace hygroloom
