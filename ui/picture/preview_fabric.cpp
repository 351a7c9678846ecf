// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/picture/preview_fabric.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hygroloom {

namespace {

constexpr int least_cell = 4; // crossings
constexpr int largest_repeat_cell = 12;
constexpr int other_cell = 8; // of fabrics with a larger repeat
constexpr int first_look_crossings = 20;
constexpr double stay = 1.12; // of a level's range

/// Whole repeats where they are small, so that all cells are alike.
int cell_for(int period) { return period > largest_repeat_cell ? other_cell : period * ((least_cell + period - 1) / period); }

/// The yarns of one period of an order.
std::vector<const Yarn*> yarns_of(const Fabric& fabric, bool warp)
{
    std::vector<const Yarn*> yarns;
    for (const YarnRun& run : warp ? fabric.warp_order : fabric.weft_order) {
        yarns.insert(yarns.end(), static_cast<std::size_t>(std::max(0, run.count)), &yarn_in(fabric, warp, run.yarn));
    }
    if (yarns.empty()) { yarns.push_back(warp ? &fabric.warp : &fabric.weft); }
    return yarns;
}

/// Whether yarns of an order lie differently; colour does not matter to a mesh.
bool shapes_differ(const std::vector<const Yarn*>& yarns)
{
    Yarn first = *yarns.front();
    return std::any_of(yarns.begin(), yarns.end(), [&first](const Yarn* yarn) {
        first.color = yarn->color;
        return !(*yarn == first);
    });
}

int period_of(int weave, const std::vector<const Yarn*>& order, int most)
{
    const auto count = static_cast<int>(order.size());
    const long period = shapes_differ(order) ? std::lcm(static_cast<long>(weave), static_cast<long>(count)) : weave;
    return static_cast<int>(std::min<long>(period, std::max(weave, most)));
}

int repeats_about(int crossings, int period, int most)
{
    const int whole = std::max(1, static_cast<int>(std::lround(static_cast<double>(crossings) / period))) * period;
    return std::clamp(whole, 2, std::max(2, most));
}

} // namespace

int level_for(double pitch_pixels, int shown)
{
    const auto least = [](int level) { return level == fibre_level ? fibre_pixels : tubes[level - 1].pixels; };
    int level = 0;
    while (level < fibre_level && pitch_pixels >= least(level + 1)) { ++level; }
    // The belt blends level 0 with the first tubes; that one needs no staying.
    if (level > 0 && shown == level + 1 && pitch_pixels * stay >= least(shown)) { return shown; }
    if (shown > 0 && shown == level - 1 && pitch_pixels < stay * least(level)) { return shown; }
    return level;
}

TextileRegion PreviewFabric::crossings(Cell cell) const
{
    const int end = cell.column * cell_ends, pick = cell.row * cell_picks;
    return {end, pick, std::min(cell_ends, textile.ends() - end), std::min(cell_picks, textile.picks() - pick)};
}

MeshKey PreviewFabric::key(Cell cell, int level) const
{
    if (level == 0) {
        return {}; // one picture serves all cells
    }
    const TextileRegion part = crossings(cell);
    if (level == fibre_level) {
        return {level, part.first_end, part.first_pick, part.ends, part.picks}; // no two places have the same fibres
    }
    return {level, part.first_end % period_ends, part.first_pick % period_picks, part.ends, part.picks};
}

QVector3D PreviewFabric::pitch() const
{
    return {static_cast<float>(mm_from_metre(textile.x_of_end(1) - textile.x_of_end(0))),
            static_cast<float>(mm_from_metre(textile.y_of_pick(1) - textile.y_of_pick(0))),
            static_cast<float>(mm_from_metre(2 * textile.half_thickness()))};
}

QVector3D PreviewFabric::low(const TextileRegion& crossings) const
{
    const QVector3D step = pitch();
    return {static_cast<float>(mm_from_metre(textile.x_of_end(crossings.first_end))) - 0.5F * step.x(),
            static_cast<float>(mm_from_metre(textile.y_of_pick(crossings.first_pick))) - 0.5F * step.y(), -0.5F * step.z()};
}

QVector3D PreviewFabric::high(const TextileRegion& crossings) const
{
    return low(crossings) + QVector3D(static_cast<float>(crossings.ends), static_cast<float>(crossings.picks), 1) * pitch();
}

QVector3D PreviewFabric::low() const { return low({0, 0, textile.ends(), textile.picks()}); }

QVector3D PreviewFabric::high() const { return high({0, 0, textile.ends(), textile.picks()}); }

TextileRegion PreviewFabric::first_look() const
{
    const auto span = [](int count, int period) {
        const int shown = std::min(
            count, std::clamp(static_cast<int>(std::ceil(0.66 * first_look_crossings / period)) * period, 2, first_look_crossings));
        return std::pair((count - shown) / 2 / period * period, shown);
    };
    const auto [end, ends] = span(textile.ends(), textile.weave.ends());
    const auto [pick, picks] = span(textile.picks(), textile.weave.picks());
    return {end, pick, ends, picks};
}

TextileRegion swatch_region(const Fabric& fabric, double side_mm)
{
    const TextileRegion sample = region_of_sample(fabric, side_mm, side_mm);
    return {0, 0, repeats_about(sample.ends, fabric.weave.ends(), sample.ends),
            repeats_about(sample.picks, fabric.weave.picks(), sample.picks)};
}

std::shared_ptr<const PreviewFabric> prepare_fabric(const PreviewRequest& request)
{
    auto fabric = std::make_shared<PreviewFabric>();
    fabric->request = request;
    const Fabric& shown = request.design->fabrics[static_cast<std::size_t>(request.fabric)];
    fabric->textile =
        request.fitted ? build_textile(shown, *request.fitted, request.whole) : build_textile(*request.design, shown, request.whole);
    const auto end_order = yarns_of(shown, true), pick_order = yarns_of(shown, false);
    fabric->period_ends = period_of(shown.weave.ends(), end_order, request.whole.ends);
    fabric->period_picks = period_of(shown.weave.picks(), pick_order, request.whole.picks);
    fabric->cell_ends = cell_for(fabric->period_ends);
    fabric->cell_picks = cell_for(fabric->period_picks);
    if (request.shown_ends > 0) { fabric->textile = in_cells(fabric->textile, request.shown_ends, request.shown_picks); }
    const auto yarns_in = [](const std::vector<const Yarn*>& order, int first, int yarns, int count) {
        std::vector<const Yarn*> all;
        for (int i = 0; i < count; ++i) { // of a cell the yarn in its middle
            const auto middle = static_cast<int>((i + 0.5) * yarns / count);
            all.push_back(order[static_cast<std::size_t>(first + middle) % order.size()]);
        }
        return all;
    };
    fabric->end_yarns = yarns_in(end_order, request.whole.first_end, request.whole.ends, fabric->textile.ends());
    fabric->pick_yarns = yarns_in(pick_order, request.whole.first_pick, request.whole.picks, fabric->textile.picks());
    return fabric;
}

} // namespace hygroloom
