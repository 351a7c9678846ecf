// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/garment/worn_run.h"

#include "core/base/error.h"
#include "ui/basics/color_map.h"
#include "ui/basics/quantity.h"
#include "ui/basics/words.h"
#include "ui/garment/step_legend.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hygroloom {

namespace {

/// Fills bare pixels beside cells with those, so that outlines are covered.
std::vector<int> widened(const PanelGrid& grid, const std::vector<int>& cells)
{
    std::vector<int> wide = cells;
    const auto at = [&](int end, int pick) {
        return end < 0 || pick < 0 || end >= grid.ends || pick >= grid.picks
                   ? -1
                   : cells[static_cast<std::size_t>(pick) * static_cast<std::size_t>(grid.ends) + static_cast<std::size_t>(end)];
    };
    for (int pick = 0; pick < grid.picks; ++pick) {
        for (int end = 0; end < grid.ends; ++end) {
            int& own = wide[static_cast<std::size_t>(pick) * static_cast<std::size_t>(grid.ends) + static_cast<std::size_t>(end)];
            for (int near = 0; own < 0 && near < 9; ++near) { own = at(end + near % 3 - 1, pick + near / 3 - 1); }
        }
    }
    return wide;
}

std::shared_ptr<const GarmentPaint> paintOf(const WornRun& run, const std::vector<double>& values, const std::function<QRgb(double)>& color)
{
    auto paint = std::make_shared<GarmentPaint>();
    const WearLayout& layout = run.layout();
    for (std::size_t k = 0; k < layout.panels.size(); ++k) {
        const WearPanel& panel = layout.panels[k];
        const std::vector<int>& pixels = run.lookup->pixels(k);
        QImage image(panel.grid.ends, panel.grid.picks, QImage::Format_ARGB32);
        std::size_t next = 0;
        for (int pick = 0; pick < panel.grid.picks; ++pick) {
            auto* line = reinterpret_cast<QRgb*>(image.scanLine(pick));
            for (int end = 0; end < panel.grid.ends; ++end) {
                const int cell = pixels[next++];
                line[end] = cell < 0 ? 0U : color(values[static_cast<std::size_t>(cell)]);
            }
        }
        paint->fills.push_back({std::move(image), panel.grid.origin, panel.grid.across, panel.grid.along});
        paint->labels.push_back({QString::fromStdString(panel.name), QString::fromStdString(panel.fabric), panel.grain});
    }
    return paint;
}

} // namespace

std::shared_ptr<const Candidate> numbersOf(const WornRun& run)
{
    try {
        return run.metrics ? std::make_shared<const Candidate>(candidate_of(*run.record, *run.metrics, run.wall)) : nullptr;
    } catch (const Error&) { // a damaged recording
        return nullptr;
    }
}

CellLookup::CellLookup(const WearLayout& layout) : layout_(layout), pixels_(layout.panels.size())
{
    for (std::size_t k = 0; k < layout.panels.size(); ++k) {
        const PanelGrid& grid = layout.panels[k].grid;
        pixels_[k].assign(static_cast<std::size_t>(grid.ends) * static_cast<std::size_t>(grid.picks), -1);
    }
    for (std::size_t i = 0; i < layout.cells.size(); ++i) {
        const GarmentCell& cell = layout.cells[i];
        const auto panel = static_cast<std::size_t>(cell.panel);
        pixels_[panel][static_cast<std::size_t>(cell.pick) * static_cast<std::size_t>(layout.panels[panel].grid.ends) +
                       static_cast<std::size_t>(cell.end)] = static_cast<int>(i);
    }
    for (std::size_t k = 0; k < layout.panels.size(); ++k) { pixels_[k] = widened(layout.panels[k].grid, pixels_[k]); }
}

int CellLookup::at(const GarmentSpot& spot) const
{
    if (spot.panel < 0 || spot.panel >= static_cast<int>(pixels_.size())) { return -1; }
    const auto panel = static_cast<std::size_t>(spot.panel);
    const PanelGrid& grid = layout_.panels[panel].grid;
    const auto [end, pick] = grid.cell_at(spot.flat);
    if (end < 0 || pick < 0 || end >= grid.ends || pick >= grid.picks) { return -1; }
    return pixels_[panel][static_cast<std::size_t>(pick) * static_cast<std::size_t>(grid.ends) + static_cast<std::size_t>(end)];
}

int WornRun::frameAt(double time) const
{
    const auto after = std::upper_bound(frames.begin(), frames.end(), time + 1e-9,
                                        [](double t, const std::shared_ptr<const WearFrame>& frame) { return t < frame->time; });
    if (frames.empty() || time > frames.back()->time + 1e-3) { return -1; }
    return std::max(0, static_cast<int>(after - frames.begin()) - 1);
}

std::shared_ptr<WornRun> newWornRun(std::shared_ptr<const WearRecord> record)
{
    auto run = std::make_shared<WornRun>();
    run->record = std::move(record);
    run->drawing = drawingOf(run->layout());
    run->lookup = std::make_shared<const CellLookup>(run->layout());
    if (const WearExperiment* wear = find_wear(run->record->design, run->layout().experiment)) { run->duration = wear->duration_s; }
    return run;
}

std::vector<double> cellValues(const WearLayout& layout, const WearFrame& frame, WearValue what)
{
    std::vector<double> values(layout.cells.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const GarmentCell& cell = layout.cells[i];
        values[i] = what == WearValue::water ? 1e3 * frame.water(i) / cell.area : cell.capacity > 0 ? frame.water(i) / cell.capacity : 0;
    }
    return values;
}

MostWater mostWater(const WearLayout& layout, const WearFrame& frame)
{
    const auto most_of = [&](WearValue what) {
        const std::vector<double> values = cellValues(layout, frame, what);
        return values.empty() ? 0 : std::max(0.0, *std::max_element(values.begin(), values.end()));
    };
    return {most_of(WearValue::water), most_of(WearValue::share)};
}

QString directionWords(const WornRun& run, int cell)
{
    constexpr double level = 0.2;                       // of a length along the cloth that it must rise, else it lies level
    constexpr double nearly = 15, to_degree = 57.29578; // degrees from a yarn that still count as along it; degrees of a radian
    const WearLayout& layout = run.layout();
    const GarmentCell& here = layout.cells[static_cast<std::size_t>(cell)];
    const PanelGrid& grid = layout.panels[static_cast<std::size_t>(here.panel)].grid;
    // How fast the cloth rises from end to end and from pick to pick, by its neighbours on either side.
    const auto rise = [&](int ends, int picks) {
        double height[2] = {here.place.y, here.place.y}, length = 0;
        for (const int side : {0, 1}) {
            const int sign = side ? 1 : -1;
            const FlatPlace place = grid.middle(here.end + sign * ends, here.pick + sign * picks);
            const int other = run.lookup->at({here.panel, place});
            if (other < 0) { continue; }
            const GarmentCell& there = layout.cells[static_cast<std::size_t>(other)];
            height[side] = there.place.y;
            length += std::hypot(there.place.x - here.place.x, there.place.y - here.place.y, there.place.z - here.place.z);
        }
        return length > 0 ? (height[1] - height[0]) / length : 0.0;
    };
    const double weft = rise(1, 0), warp = rise(0, 1);
    if (std::hypot(weft, warp) < level) { return tr("the cloth lies level here"); }
    const double from_warp = to_degree * std::atan2(std::abs(weft), std::abs(warp));
    if (from_warp < nearly) { return tr("the warp runs down here"); }
    if (from_warp > 90 - nearly) { return tr("the weft runs down here"); }
    return tr("the bias runs down here, %1° from the warp").arg(std::lround(from_warp));
}

QString cellsText(const std::string& cells_in_words)
{
    static const QRegularExpression cells(R"(^cells of (\S+) x (\S+) mm, (\d+) x (\d+) crossings$)");
    static const QRegularExpression sums(R"(^shown in sums of (\d+) x (\d+) cells( at most)?$)");
    QStringList parts = QString::fromStdString(cells_in_words).split("; ");
    for (QString& part : parts) {
        if (const auto one = cells.match(part); one.hasMatch()) {
            part = tr("cells of %1 × %2 mm, %3 × %4 crossings").arg(one.captured(1), one.captured(2), one.captured(3), one.captured(4));
        } else if (const auto sum = sums.match(part); sum.hasMatch()) {
            const QString words =
                sum.captured(3).isEmpty() ? tr("shown in sums of %1 × %2 cells") : tr("shown in sums of %1 × %2 cells at most");
            part = words.arg(sum.captured(1), sum.captured(2));
        }
    }
    return parts.join("; ");
}

std::shared_ptr<const GarmentPaint> waterPaint(const WornRun& run, const std::vector<double>& values, const WearSteps& steps)
{
    return paintOf(run, values, [steps](double value) {
        const auto color = step_colour(step_of(steps, value));
        return qRgb(color[0], color[1], color[2]);
    });
}

std::shared_ptr<const GarmentPaint> differencePaint(const WornRun& run, const std::vector<double>& values, double most)
{
    return paintOf(run, values, [most](double value) {
        return std::isnan(value) ? 0U : differenceColor(differenceStep(most > 0 ? value / most : 0)).rgb();
    });
}

GarmentSpot sameSpot(const WearLayout& from, const WearLayout& to, const GarmentSpot& spot)
{
    if (spot.panel < 0 || spot.panel >= static_cast<int>(from.panels.size())) { return {}; }
    const std::string& name = from.panels[static_cast<std::size_t>(spot.panel)].name;
    const auto found = std::find_if(to.panels.begin(), to.panels.end(), [&](const WearPanel& panel) { return panel.name == name; });
    return found == to.panels.end() ? GarmentSpot{} : GarmentSpot{static_cast<int>(found - to.panels.begin()), spot.flat};
}

std::vector<int> samePlaces(const WornRun& one, const WornRun& other)
{
    const WearLayout& layout = one.layout();
    std::vector<int> panels(layout.panels.size());
    for (std::size_t k = 0; k < panels.size(); ++k) { panels[k] = sameSpot(layout, other.layout(), {static_cast<int>(k), {}}).panel; }
    std::vector<int> places(layout.cells.size(), -1);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const GarmentCell& cell = layout.cells[i];
        const auto panel = static_cast<std::size_t>(cell.panel);
        if (panels[panel] >= 0) { places[i] = other.lookup->at({panels[panel], layout.panels[panel].grid.middle(cell.end, cell.pick)}); }
    }
    return places;
}

std::vector<double> differences(const std::vector<double>& values, const std::vector<double>& others, const std::vector<int>& places)
{
    std::vector<double> result(values.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (places[i] >= 0) { result[i] = values[i] - others[static_cast<std::size_t>(places[i])]; }
    }
    return result;
}

} // namespace hygroloom
