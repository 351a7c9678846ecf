// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/metrics.h"

#include "core/analysis/outcomes.h"
#include "core/analysis/stain_shape.h"
#include "core/base/units.h"
#include "core/design/holes.h"
#include "core/plan/bundles.h"
#include "core/scene/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hygroloom {
namespace {

/// The wet segments of one face.
struct WetFace {
    std::vector<std::array<double, 2>> outline;     ///< m, of each end the first and the last; all others lie between
    std::vector<std::array<double, 2>> places;      ///< m, of all; none where frames show cells
    double count = 0, x = 0, y = 0, xx = 0, yy = 0; ///< sums over all
    double each = 0;                                ///< m2 of the face that each lies on

    void add(double at_x, double at_y)
    {
        count += 1;
        x += at_x;
        y += at_y;
        xx += at_x * at_x;
        yy += at_y * at_y;
        places.push_back({at_x, at_y});
    }
};

/// Top and bottom, of a frame that shows cells: as fine as it is simulated. A bundle of yarns reaches to its outer ones.
std::array<WetFace, 2> wet_faces_of_ends(const Textile& textile, const Frame& frame, const Bundling& bundling)
{
    std::array<WetFace, 2> faces;
    const auto ends = static_cast<double>(frame.wet.size());
    const auto side_of = [&bundling](double yarns, double pitch, double cells) { // of one
        const Bundles bundles = bundles_of(static_cast<int>(std::lround(yarns)), bundling);
        return pitch * (bundles.count == static_cast<int>(cells) ? bundles.size() : yarns / cells);
    };
    const double end_pitch = textile.warp.pitch / textile.ends_per_cell, pick_pitch = textile.weft.pitch / textile.picks_per_cell;
    const double across = side_of(textile.ends() * textile.ends_per_cell, end_pitch, ends);
    const double along = side_of(textile.picks() * textile.picks_per_cell, pick_pitch, frame.wet_picks);
    const double side = 0.5 * (across - end_pitch), tip = 0.5 * (along - pick_pitch); // m, from the bundle's middle
    const double edge = 0.5 * (textile.ends() * textile.warp.pitch - end_pitch),
                 tip_edge = 0.5 * (textile.picks() * textile.weft.pitch - pick_pitch);
    double x = -0.5 * (ends - 1) * across;
    for (const WetEnd& end : frame.wet) {
        for (std::size_t f = 0; f < 2; ++f) {
            if (end.first[f] < 0) continue;
            WetFace& face = faces[f];
            face.each = across * along;
            const auto y_of = [&](float pick) { return (static_cast<double>(pick) - 0.5 * (frame.wet_picks - 1)) * along; };
            for (double at : {std::max(x - side, -edge), std::min(x + side, edge)}) {
                face.outline.push_back({at, std::max(y_of(end.first[f]) - tip, -tip_edge)});
                face.outline.push_back({at, std::min(y_of(end.last[f]) + tip, tip_edge)});
            }
            // Sums over the yarns of the bundles, which lie evenly in them.
            const auto squares_in = [](double bundle, double pitch) { return (bundle * bundle - pitch * pitch) / 12; };
            const auto count = static_cast<double>(end.count[f]);
            face.count += count;
            face.x += count * x;
            face.xx += count * (x * x + squares_in(across, end_pitch));
            const double y = y_of(end.first[f]), places = static_cast<double>(end.places[f]) * along;
            face.y += count * y + places;
            face.yy +=
                y * (count * y + 2 * places) + static_cast<double>(end.squares[f]) * along * along + count * squares_in(along, pick_pitch);
        }
        x += across;
    }
    return faces;
}

/// Top and bottom.
std::array<WetFace, 2> wet_faces(const Textile& textile, const Frame& frame, const Bundling& bundling)
{
    if (!frame.wet.empty()) return wet_faces_of_ends(textile, frame, bundling);
    std::array<WetFace, 2> faces;
    for (WetFace& face : faces) face.each = textile.warp.pitch * textile.weft.pitch;
    const auto wet = [&](YarnKind kind, int end, int pick) {
        return frame.saturation[static_cast<std::size_t>(textile.segment(kind, end, pick))] >= wet_saturation;
    };
    for (int end = 0; end < textile.ends(); ++end) {
        const double x = textile.x_of_end(end);
        std::array<int, 2> first{-1, -1}, last{-1, -1};
        for (int pick = 0; pick < textile.picks(); ++pick) {
            const bool warp = wet(YarnKind::warp, end, pick), weft = wet(YarnKind::weft, end, pick);
            if (!warp && !weft) continue;
            const bool up = textile.warp_up(end, pick);
            for (std::size_t face = 0; face < 2; ++face) {
                if (!(up == (face == 0) ? warp : weft)) continue;
                faces[face].add(x, textile.y_of_pick(pick));
                if (first[face] < 0) first[face] = pick;
                last[face] = pick;
            }
        }
        for (std::size_t face = 0; face < 2; ++face) {
            if (first[face] < 0) continue;
            faces[face].outline.push_back({x, textile.y_of_pick(first[face])});
            if (last[face] > first[face]) faces[face].outline.push_back({x, textile.y_of_pick(last[face])});
        }
    }
    return faces;
}

/// Semi-axes of the ellipse with the wet points' second moments: a filled ellipse's are twice their standard deviations.
std::array<double, 2> wetted_ellipse(const WetFace& face)
{
    if (face.count < 1) return {0, 0};
    const auto semi_axis = [n = face.count](double sum, double squares) {
        return 2.0 * std::sqrt(std::max(0.0, squares / n - sum * sum / (n * n)));
    };
    return {semi_axis(face.x, face.xx), semi_axis(face.y, face.yy)};
}

/// How far a yarn along a strip is wet from the strip's lower end on, in crossings. The front lies where the saturation falls to
/// wet_saturation on a line from the middle of the last wet cell to the middle of the next, which is dry beyond the strip's end. So it
/// goes on between crossings, never jumps as a cell gets wet, and never falls where a saturation rises. cells: along the yarn; of
/// several crossings where yarns go in bundles. 0 where none is wet beyond so many crossings.
double wet_crossings(const Textile& textile, const Frame& frame, bool along_weft, int yarn, const Bundles& cells, double beyond_crossing)
{
    const auto saturation = [&](int cell) {
        const int at = cells.middle_of(cell);
        const int segment = along_weft ? textile.segment(YarnKind::weft, at, yarn) : textile.segment(YarnKind::warp, yarn, at);
        return static_cast<double>(frame.saturation[static_cast<std::size_t>(segment)]);
    };
    int last = cells.count - 1;
    while (last >= 0 && saturation(last) < wet_saturation) --last;
    if (last < 0 || (last + 1) * cells.size() <= beyond_crossing + 1e-9) return 0;
    const double wet = saturation(last), beyond = last + 1 < cells.count ? saturation(last + 1) : 0.0;
    return std::min(last + 0.5 + (wet - wet_saturation) / (wet - beyond), static_cast<double>(cells.count)) * cells.size();
}

/// Mean over the yarns along the strip of how far each is wet above the liquid, m.
double wick_height(const Textile& textile, const Frame& frame, const Experiment& experiment, const Bundling& bundling)
{
    const YarnKind kind = experiment.along_weft ? YarnKind::weft : YarnKind::warp;
    const YarnSystem& across = textile.system(other_kind(kind));
    const int yarns = textile.system(kind).count;
    const Bundles cells = bundles_of(across.count, bundling);
    const double surface = metre_from_mm(experiment.immersion_mm);
    double sum = 0;
    for (int yarn = 0; yarn < yarns; ++yarn)
        sum += std::max(0.0,
                        wet_crossings(textile, frame, experiment.along_weft, yarn, cells, surface / across.pitch) * across.pitch - surface);
    return sum / yarns;
}

/// Whether water has reached an edge, of a frame that shows cells: as fine as it is simulated. No strip is shown so.
bool wet_at_an_edge(const std::vector<WetEnd>& wet, int picks)
{
    const auto is_wet = [](const WetEnd& end) { return end.first[0] >= 0 || end.first[1] >= 0; };
    return is_wet(wet.front()) || is_wet(wet.back()) || std::any_of(wet.begin(), wet.end(), [picks](const WetEnd& end) {
               return end.first[0] == 0 || end.first[1] == 0 || std::max(end.last[0], end.last[1]) >= static_cast<float>(picks - 1);
           });
}

/// Whether water has reached an edge of the sample or the upper end of a strip.
bool wet_at_the_end(const Textile& textile, const Frame& frame, const Experiment& experiment)
{
    if (changes_everywhere(experiment.type)) return false;
    if (!frame.wet.empty()) return wet_at_an_edge(frame.wet, frame.wet_picks);
    const int last_end = textile.ends() - 1, last_pick = textile.picks() - 1;
    const auto wet = [&](int end, int pick) {
        return std::max(frame.saturation[static_cast<std::size_t>(textile.segment(YarnKind::warp, end, pick))],
                        frame.saturation[static_cast<std::size_t>(textile.segment(YarnKind::weft, end, pick))]) >= wet_saturation;
    };
    const bool strip = is_strip(experiment.type);
    for (int pick = 0; pick <= last_pick && (!strip || experiment.along_weft); ++pick)
        if ((!strip && wet(0, pick)) || wet(last_end, pick)) return true;
    for (int end = 0; end <= last_end && (!strip || !experiment.along_weft); ++end)
        if ((!strip && wet(end, 0)) || wet(end, last_pick)) return true;
    return false;
}

/// Water of a drying test that the fibres of each face absorbed before the first frame, kg; frames count from there.
std::array<double, 2> absorbed_before(const RunRecord& run, const Experiment& experiment)
{
    std::array<double, 2> water{0, 0};
    if (!starts_wet(experiment.type)) return water;
    const Scene scene = build_scene(run.design, run.textile, experiment, run.plan, run.seed);
    for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
        for (int end = 0; end < run.textile.ends(); ++end)
            for (int pick = 0; pick < run.textile.picks(); ++pick) {
                const int line = kind == YarnKind::warp ? end : run.textile.ends() + pick;
                const YarnParameters& yarn = scene.cloth.yarns[scene.cloth.type[static_cast<std::size_t>(line)]];
                const double length = scene.cloth.fibre_length(static_cast<std::size_t>(run.textile.segment(kind, end, pick)), yarn);
                const double absorbed = (yarn.initial_regain - yarn.resting_regain) * yarn.fibre_area * yarn.fibre_density * length;
                const double top = run.textile.on_top(kind, end, pick);
                water[0] += top * absorbed;
                water[1] += (1.0 - top) * absorbed;
            }
    return water;
}

/// Water of a face, or 0 below the rounding error of the frames, which are floats, in the water that the fibres hold.
double water_of_face(double water, const Frame& frame)
{
    constexpr double rounding = 2e-7;
    return std::abs(water) > rounding * frame.ledger.water_bound ? water : 0.0;
}

/// Takes in how far each end is wet; whether it is farther, or at more crossings, than before.
bool spreads(std::vector<WetEnd>& was_wet, const std::vector<WetEnd>& wet)
{
    was_wet.resize(wet.size());
    bool any = false;
    for (std::size_t i = 0; i < wet.size(); ++i)
        for (int f = 0; f < 2; ++f) {
            WetEnd& before = was_wet[i];
            const WetEnd& now = wet[i];
            if (now.first[f] < 0) continue;
            any = any || before.first[f] < 0 || now.first[f] < before.first[f] || now.last[f] > before.last[f] ||
                  now.count[f] > before.count[f];
            before.first[f] = before.first[f] < 0 ? now.first[f] : std::min(before.first[f], now.first[f]);
            before.last[f] = std::max(before.last[f], now.last[f]);
            before.count[f] = std::max(before.count[f], now.count[f]);
        }
    return any;
}

/// Takes in the segments that are wet; whether any had not been before.
bool spreads(std::vector<std::uint8_t>& was_wet, const Frame& frame)
{
    was_wet.resize(frame.saturation.size(), 0);
    std::uint8_t any = 0;
    for (std::size_t i = 0; i < was_wet.size(); ++i) {
        const std::uint8_t wet = frame.saturation[i] >= wet_saturation ? 1 : 0;
        any |= wet & (was_wet[i] ^ 1);
        was_wet[i] |= wet;
    }
    return any != 0;
}

double mean_of(const std::vector<float>& values)
{
    return std::reduce(values.begin(), values.end(), 0.0, std::plus<double>()) / static_cast<double>(values.size());
}

constexpr double rest = 10; // s, without a newly wet segment

} // namespace

Circle wetted_circle(const Textile& textile, const Frame& frame, Face face)
{
    return smallest_enclosing_circle(wet_faces(textile, frame, {})[face == Face::top ? 0 : 1].outline);
}

void MetricsCollector::start(const RunRecord& run)
{
    textile_ = run.textile;
    const Experiment* experiment = find_experiment(run.design, run.experiment);
    experiment_ = experiment ? *experiment : Experiment{};
    bundling_ = run.plan.bundling();
    metrics_ = {};
    absorbed_before_ = absorbed_before(run, experiment_);
    regain_at_start_.clear();
    pins_ = uses_field(experiment_.type, "feed_s") ? TesterPins(textile_, experiment_.closure == Closure::pores) : TesterPins();
    edge_time_.reset();
    falls_through_.reset();
    assumes_depth_ = false;
    if (const Fabric* fabric = find_fabric(run.design, run.fabric)) {
        falls_through_ = falls_through(*fabric, fit_fabric(run.design, *fabric), experiment_);
        assumes_depth_ = experiment_.closure == Closure::pores && (fabric->finish_face || fabric->finish_back) && !fabric->finish_depth;
    }
    was_wet_.clear();
    wet_ends_.clear();
    last_wetted_ = 0;
    had_free_water_ = false;
    wiped_.reset();
    delivered_ = 0;
    unsolved_lines_ = run.unsolved_lines;
    for (const SwitchedPart& part : run.switched_on) add(part);
    note_hand(run.acts);
}

void MetricsCollector::add(const Frame& frame)
{
    Series& s = metrics_.series;
    std::array<WetFace, 2> wet = wet_faces(textile_, frame, bundling_);
    const double top = std::max(0.0, smallest_enclosing_circle(wet[0].outline).radius);
    const double bottom = std::max(0.0, smallest_enclosing_circle(wet[1].outline).radius);
    s.time.push_back(frame.time);
    s.radius_top.push_back(top);
    s.radius_bottom.push_back(bottom);
    s.water_top.push_back(water_of_face(frame.water_top + absorbed_before_[0], frame));
    s.water_bottom.push_back(water_of_face(frame.water_bottom + absorbed_before_[1], frame));
    s.delivered.push_back(frame.ledger.water_delivered);
    s.free_water.push_back(frame.ledger.water_free);
    s.yarn_water.push_back(frame.ledger.water_liquid);
    s.bound_water.push_back(frame.ledger.water_bound);
    s.evaporated.push_back(frame.ledger.water_evaporated);
    s.dripped.push_back(frame.ledger.water_dripped);
    const auto [coldest, hottest] = std::minmax_element(frame.temperature.begin(), frame.temperature.end());
    s.temperature_mean.push_back(mean_of(frame.temperature));
    s.temperature_min.push_back(*coldest);
    s.temperature_max.push_back(*hottest);
    s.regain_mean.push_back(mean_of(frame.regain));
    s.air_temperature.push_back(kelvin_from_celsius(climate_at(experiment_, frame.time).temperature_c));
    if (regain_at_start_.empty()) regain_at_start_ = frame.regain;
    if (is_strip(experiment_.type)) s.wick_height.push_back(wick_height(textile_, frame, experiment_, bundling_));
    if (uses_field(experiment_.type, "feed_s")) {
        s.tester.push_back(pins_.read(frame, regain_at_start_));
        s.content_top.push_back(face_content(s.tester.back().top));
        s.content_bottom.push_back(face_content(s.tester.back().bottom));
    }

    metrics_.maximum_wetted_radius_top = std::max(metrics_.maximum_wetted_radius_top, top);
    metrics_.maximum_wetted_radius_bottom = std::max(metrics_.maximum_wetted_radius_bottom, bottom);
    const auto equal_area = [](const WetFace& face) { return std::sqrt(face.count * face.each / pi); };
    metrics_.equal_area_radius_top = std::max(metrics_.equal_area_radius_top, equal_area(wet[0]));
    metrics_.equal_area_radius_bottom = std::max(metrics_.equal_area_radius_bottom, equal_area(wet[1]));
    const std::array<double, 2> axes = wetted_ellipse(wet[0]);
    metrics_.wetted_area_ellipse_weft = axes[0];
    metrics_.wetted_area_ellipse_warp = axes[1];
    stain_ = std::move(wet[0].places);
    metrics_.ledger = frame.ledger;
    if (frame.unsolved_lines > 0) unsolved_lines_ = frame.unsolved_lines; // steps beside for earlier frames do not count
    metrics_.water_between_yarns = std::accumulate(frame.between.begin(), frame.between.end(), 0.0);
    if (frame.wet.empty() ? spreads(was_wet_, frame) : spreads(wet_ends_, frame.wet)) last_wetted_ = frame.time;
    metrics_.time_of_arrest.reset();
    if (frame.time - last_wetted_ >= rest && metrics_.maximum_wetted_radius_top + metrics_.maximum_wetted_radius_bottom > 0)
        metrics_.time_of_arrest = last_wetted_;
    if (!edge_time_ && wet_at_the_end(textile_, frame, experiment_)) edge_time_ = frame.time;

    watch_free_water(frame);
}

/// Absorbency: when liquid last stood on the cloth, which the ledger knows; of older recordings the first frame without any. Liquid that
/// comes later starts it anew.
void MetricsCollector::watch_free_water(const Frame& frame)
{
    constexpr double some = 1e-9;     // of the water; a pool keeps the remainder of its quanta
    constexpr double rounding = 1e-9; // of the time: the ledger's is a sum of steps
    const bool free_water = frame.ledger.water_free > some * frame.ledger.water_delivered &&
                            !(frame.ledger.free_until >= 0 && frame.ledger.free_until < frame.time * (1 - rounding));
    had_free_water_ = had_free_water_ || frame.ledger.water_delivered > 0;
    const bool comes = frame.ledger.water_delivered > delivered_;
    delivered_ = frame.ledger.water_delivered;
    const double until = frame.ledger.free_until;
    const bool wiped = wiped_ && std::abs(until - *wiped_) <= 1e-6 * (1 + until); // it ran off
    if (free_water || comes) metrics_.absorbency_time.reset();
    if (!free_water && !wiped && had_free_water_ && !metrics_.absorbency_time)
        metrics_.absorbency_time = frame.ledger.free_until >= 0 ? frame.ledger.free_until : frame.time;
}

void MetricsCollector::note_hand(const HandActs& acts)
{
    wiped_ = acts.wiped;
    for (const auto& [what, time] : {std::pair{"tilted", acts.tilted}, std::pair{"squeezed", acts.squeezed}})
        if (time)
            metrics_.notes.push_back(
                fmt::format("A hand {} the cloth, the last time at {:.3g} s; its experiment does not repeat that.", what, *time));
}

void MetricsCollector::add(const SwitchedPart& part) { metrics_.notes.push_back(in_words(part)); }

Metrics MetricsCollector::metrics() const
{
    Metrics m = metrics_;
    m.shape = stain_shape(stain_, textile_.warp.pitch, textile_.weft.pitch);
    m.edge_time = edge_time_;
    if (falls_through_) {
        m.notes.push_back(english(*falls_through_));
        m.absorbency_time.reset(); // nobody sees it absorbed
    }
    if (edge_time_)
        m.notes.push_back(
            is_strip(experiment_.type)
                ? fmt::format("Water reached the upper end of the strip after {:.3g} s; the height afterwards is limited by the "
                              "strip's length.",
                              *edge_time_)
                : fmt::format("Water reached the edge of the sample after {:.3g} s; the radius afterwards is limited by the "
                              "sample's size.",
                              *edge_time_));
    m.unsettled = unsolved_lines_;
    compute_results(m, experiment_, textile_.crossings() * textile_.warp.pitch * textile_.weft.pitch);
    if (assumes_depth_)
        m.assumed.push_back(fmt::format("The finish of a face reaches {:g} % of the thickness deep, since the fabric has no finish_depth.",
                                        100 * default_finish_depth));
    return m;
}

std::vector<std::string> notes_of(const Metrics& metrics)
{
    std::vector<std::string> notes = metrics.notes;
    if (metrics.unsettled > 0)
        notes.push_back(fmt::format("{:.0f} {} the suctions along a yarn were not found; its liquid stayed where it was for that step.",
                                    metrics.unsettled, metrics.unsettled > 1 ? "times" : "time"));
    return notes;
}

} // namespace hygroloom
