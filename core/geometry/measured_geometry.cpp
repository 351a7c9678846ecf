// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/geometry/measured_geometry.h"

#include "core/base/units.h"
#include "core/geometry/fibres.h"
#include "core/physics/wicking.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hygroloom {
namespace {

constexpr int least_threads = 16, most_threads = 240;
constexpr double most_points = 5e6;         // of fibres, and of the raster for cover; of 56 large fabrics within 0.1 % of what 2e8 give
constexpr double most_flyaway_points = 2e7; // half of them move the smoothness by 5 %

/// Whole repeats of weave and yarn order where they are small enough.
int threads_for(int repeat, const std::vector<YarnRun>& order)
{
    long period = 0;
    for (const YarnRun& run : order) period += run.count;
    const long both = std::lcm(std::max(1L, static_cast<long>(repeat)), std::max(1L, period));
    return static_cast<int>(std::min<long>(both * std::max(1L, (least_threads + both - 1) / both), most_threads));
}

PoreRadii radii_of(std::vector<std::pair<double, double>> radius_and_weight)
{
    PoreRadii radii;
    std::sort(radius_and_weight.begin(), radius_and_weight.end());
    double all = 0;
    for (const auto& [radius, weight] : radius_and_weight) {
        all += weight;
        radii.mean_um += radius * weight;
    }
    if (all <= 0) return {};
    radii.mean_um /= all;
    double so_far = 0;
    for (const auto& [radius, weight] : radius_and_weight) {
        const double before = so_far;
        so_far += weight / all;
        if (before < 0.1 && so_far >= 0.1) radii.tenth_um = radius;
        if (before < 0.5 && so_far >= 0.5) radii.median_um = radius;
        if (before < 0.9 && so_far >= 0.9) radii.nine_tenths_um = radius;
    }
    return radii;
}

/// 2 x void area / wetted perimeter, over the packing that falls from the axis to the surface; weights are void areas.
PoreRadii pores_of(const YarnType& type)
{
    std::vector<std::pair<double, double>> pores;
    constexpr int steps = 200;
    for (int i = 0; i < steps; ++i) {
        const double squared = (i + 0.5) / steps; // of the radius: equal areas
        const double packing = packing_at(type, squared);
        pores.push_back({type.fibre.fibre_radius_um * (1 - packing) / packing, 1 - packing});
    }
    return radii_of(std::move(pores));
}

struct FibreSums {
    double mass = 0, volume = 0, flyaway = 0; ///< kg, m3, m3
    double highest = 0, lowest = 0;           ///< m, of what is no hair
    double seen = 1;                          ///< least share of a type's yarns whose flyaways were looked at
    double points = 0;
};

double line_length(const std::vector<float>& line)
{
    double length = 0;
    for (std::size_t i = 3; i < line.size(); i += 3)
        length += std::hypot(static_cast<double>(line[i] - line[i - 3]), static_cast<double>(line[i + 1] - line[i - 2]),
                             static_cast<double>(line[i + 2] - line[i - 1]));
    return length;
}

/// Twelve points per turn, and enough for the bends.
int samples_for(const YarnType& type, double pitch)
{
    return static_cast<int>(
        std::clamp(std::ceil(12 * pitch * std::max(std::abs(type.twist), type.plies > 1 ? std::abs(type.ply_twist) : 0.0)), 24.0, 1200.0));
}

/// Points of the fibres of one yarn, with the loops that each must be compared with.
double points_of(const Textile& textile, const YarnType& type, int crossings, double pitch, bool flyaways)
{
    double points = static_cast<double>(crossings) * samples_for(type, pitch) * type.fibres;
    if (flyaways) {
        constexpr double comparison = 0.3; // of a point's time
        points *= 1 + comparison * YarnFibres::loops_over(textile.flyaway, type.fibres);
        points += crossings * pitch * 1e3 * textile.flyaway.hair_density_per_mm * YarnFibres::hair_points;
    }
    return points;
}

/// Mass and volume are those of the yarns without flyaways: a yarn's linear density holds them already. Of many points every few yarns
/// are summed, or a piece of one, and stand for the others; flyaways, of which there may be far more, by a count of their own.
FibreSums sum_fibres(const Textile& textile)
{
    FibreSums sums;
    std::vector<float> line;
    for (YarnKind kind : {YarnKind::warp, YarnKind::weft}) {
        const YarnSystem& system = textile.system(kind);
        const int crossings = kind == YarnKind::warp ? textile.picks() : textile.ends();
        const double pitch = textile.system(other_kind(kind)).pitch;
        std::vector<int> threads(system.types.size(), 0);
        for (int yarn = 0; yarn < system.count; ++yarn) ++threads[static_cast<std::size_t>(textile.type_of(kind, yarn))];
        for (bool flyaways : {false, true}) {
            std::vector<int> wanted, pieces, summed(system.types.size(), 0);
            for (std::size_t type = 0; type < system.types.size(); ++type) {
                const double each = points_of(textile, system.types[type], crossings, pitch, flyaways);
                const double yarns = 0.25 * (flyaways ? most_flyaway_points : most_points) * threads[type] / system.count / each;
                wanted.push_back(static_cast<int>(std::clamp(yarns, 1.0, std::max(1.0, double(threads[type])))));
                pieces.push_back(static_cast<int>(std::clamp(yarns * crossings, 1.0, double(crossings))));
                if (flyaways && threads[type] > 0)
                    sums.seen = std::min(sums.seen, double(wanted.back()) * pieces.back() / (double(threads[type]) * crossings));
            }
            for (int yarn = 0; yarn < system.count; ++yarn) {
                const auto number = static_cast<std::size_t>(textile.type_of(kind, yarn));
                if (summed[number] == wanted[number]) continue;
                ++summed[number];
                const YarnType& type = system.types[number];
                const int piece = pieces[number]; // crossings
                const double stands_for = static_cast<double>(threads[number]) / wanted[number] * crossings / piece;
                const double real_area = pi * std::pow(metre_from_um(type.fibre.fibre_radius_um), 2);
                const YarnFibres fibres(textile, {samples_for(type, pitch), 6, flyaways, true, 1}, kind, yarn, 0, piece);
                for (int strand = 0; strand < fibres.strands(); ++strand) {
                    line.resize(3 * fibres.points(strand));
                    fibres.curve(strand, line.data());
                    sums.points += static_cast<double>(fibres.points(strand));
                    const double radius = fibres.radius(strand);
                    if (!flyaways) {
                        const double volume = stands_for * line_length(line) * pi * radius * radius;
                        sums.volume += volume;
                        sums.mass += volume * type.fibre.density_kg_m3;
                        continue;
                    }
                    sums.flyaway += stands_for * real_area * (fibres.is_hair(strand) ? line_length(line) : fibres.loop_length(strand));
                    for (std::size_t i = 2; i < line.size() && !fibres.is_hair(strand); i += 3) {
                        sums.highest = std::max(sums.highest, static_cast<double>(line[i]) + radius);
                        sums.lowest = std::min(sums.lowest, static_cast<double>(line[i]) - radius);
                    }
                }
            }
        }
    }
    return sums;
}

/// Half the yarn's width and where its middle lies.
struct Strip {
    double middle = 0, half = 0;
};
Strip strip_at(const Textile& textile, YarnKind kind, int yarn, int at, double offset)
{
    const YarnPoint p = yarn_point(textile, kind, yarn, at, offset);
    return {kind == YarnKind::warp ? p.centre.x : p.centre.y, p.half_width};
}

struct Cover {
    double warp = 0, weft = 0, both = 0;
    double points = 0;
};

/// Shares of the fabric's area that lie under ends, under picks, under either.
Cover rasterize(const Textile& textile)
{
    const int raster = static_cast<int>(std::clamp(std::sqrt(0.2 * most_points / textile.crossings()), 8.0, 100.0)); // cells per pitch
    const double step = 1.0 / raster;
    const auto strips = [&](int yarns, int crossings, auto at) { // one more yarn on each side
        std::vector<Strip> all;
        for (int yarn = -1; yarn <= yarns; ++yarn)
            for (int i = 0; i < crossings * raster; ++i) all.push_back(at(yarn, i / raster, (i % raster + 0.5) * step - 0.5));
        return all;
    };
    const auto warp = strips(textile.ends(), textile.picks(),
                             [&](int yarn, int at, double offset) { return strip_at(textile, YarnKind::warp, yarn, at, offset); });
    const auto weft = strips(textile.picks(), textile.ends(),
                             [&](int yarn, int at, double offset) { return strip_at(textile, YarnKind::weft, yarn, at, offset); });
    // Share of a cell from place to place + size that a yarn or its neighbours cover.
    const auto covered = [](const std::vector<Strip>& all, int yarn, int along, int length, double place, double size) {
        double share = 0;
        for (int beside = 0; beside <= 2; ++beside) {
            const Strip& strip = all[static_cast<std::size_t>((yarn + beside) * length + along)];
            share += std::max(0.0, std::min(place + size, strip.middle + strip.half) - std::max(place, strip.middle - strip.half)) / size;
        }
        return std::min(1.0, share);
    };
    Cover cover;
    const int columns = textile.ends() * raster, rows = textile.picks() * raster;
    const double dx = step * textile.warp.pitch, dy = step * textile.weft.pitch;
    const double x0 = textile.x_of_end(0) - 0.5 * textile.warp.pitch, y0 = textile.y_of_pick(0) - 0.5 * textile.weft.pitch;
    for (int column = 0; column < columns; ++column)
        for (int row = 0; row < rows; ++row) {
            const double under_warp = covered(warp, column / raster, row, rows, x0 + column * dx, dx);
            const double under_weft = covered(weft, row / raster, column, columns, y0 + row * dy, dy);
            cover.warp += under_warp;
            cover.weft += under_weft;
            cover.both += 1 - (1 - under_warp) * (1 - under_weft);
        }
    const double n = static_cast<double>(columns) * rows;
    return {cover.warp / n, cover.weft / n, cover.both / n, n};
}

/// Every hole between two ends and two picks: its hydraulic radius, weighted by its area.
std::vector<std::pair<double, double>> find_holes(const Textile& textile)
{
    std::vector<std::pair<double, double>> holes;
    const auto gap = [&](YarnKind kind, int yarn, int at) {
        const Strip a = strip_at(textile, kind, yarn, at, 0.5), b = strip_at(textile, kind, yarn + 1, at, 0.5);
        return std::max(0.0, b.middle - b.half - a.middle - a.half);
    };
    for (int end = 0; end < textile.ends(); ++end)
        for (int pick = 0; pick < textile.picks(); ++pick) {
            const double across = gap(YarnKind::warp, end, pick), along = gap(YarnKind::weft, pick, end);
            if (across > 0 && along > 0) holes.push_back({1e6 * across * along / (across + along), across * along});
        }
    return holes;
}

double mean_braiding_angle(const Textile& textile, YarnKind kind)
{
    double sum = 0;
    int count = 0;
    const bool is_warp = kind == YarnKind::warp;
    for (int end = 0; end < textile.ends(); ++end)
        for (int pick = 0; pick < textile.picks(); ++pick) {
            if (!textile.changes_after(kind, end, pick)) continue;
            const YarnPoint a = yarn_point(textile, kind, is_warp ? end : pick, is_warp ? pick : end, 0);
            const YarnPoint b = yarn_point(textile, kind, is_warp ? end : pick, (is_warp ? pick : end) + 1, 0);
            sum += braiding_angle_deg(std::hypot(b.centre.x - a.centre.x, b.centre.y - a.centre.y), std::abs(b.centre.z - a.centre.z));
            ++count;
        }
    return count > 0 ? sum / count : 0;
}

double mean_crimp_percent(const Textile& textile, YarnKind kind)
{
    double length = 0;
    for (int end = 0; end < textile.ends(); ++end)
        for (int pick = 0; pick < textile.picks(); ++pick) {
            // Chords of a fine polyline: the path as it is drawn.
            constexpr int steps = 24;
            const bool is_warp = kind == YarnKind::warp;
            Vec3d before;
            for (int i = 0; i <= steps; ++i) {
                const Vec3d here =
                    yarn_point(textile, kind, is_warp ? end : pick, is_warp ? pick : end, static_cast<double>(i) / steps - 0.5).centre;
                if (i > 0)
                    length += is_warp ? std::hypot(here.y - before.y, here.z - before.z) : std::hypot(here.x - before.x, here.z - before.z);
                before = here;
            }
        }
    return 100 * (length / (textile.crossings() * textile.system(other_kind(kind)).pitch) - 1);
}

/// m, over the middle plane.
double highest_of_yarns(const Textile& textile)
{
    double highest = 0;
    for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
        for (int yarn = 0; yarn < textile.system(kind).count; ++yarn)
            for (int at = 0; at < (kind == YarnKind::warp ? textile.picks() : textile.ends()); ++at) {
                const YarnPoint p = yarn_point(textile, kind, yarn, at, 0);
                highest = std::max(highest, std::abs(p.centre.z) + p.half_height);
            }
    return highest;
}

/// Poiseuille flow through holes of mean squared radius r2 on a share of the area, beside yarns.
double through(double open, double r2, double across) { return open * r2 / 8 + (1 - open) * across; }

} // namespace

double braiding_angle_deg(double pitch, double rise) { return rise > 0 ? 2 * std::atan2(pitch, rise) * 180.0 / pi : 180; }

Permeability permeability_of(const FabricQuantities& q)
{
    const double warp_r = metre_from_um(q.warp.fibre_radius_um), weft_r = metre_from_um(q.weft.fibre_radius_um);
    const double warp_phi = q.warp.packing_factor_in_fabric, weft_phi = q.weft.packing_factor_in_fabric;
    const double open = 1 - q.cover_factor, hole = metre_from_um(q.inter_yarn_pore_radius_um);
    const double across = 0.5 * (permeability_across(warp_r, warp_phi) + permeability_across(weft_r, weft_phi));
    const double layer = q.yarn_layer_thickness_mm;
    const auto along = [&](const YarnQuantities& yarn, double radius) {
        const double share = yarn.area_share * section_area(yarn.section_mm) / (yarn.pitch_mm * layer); // of the layer's section
        return share * permeability_along(radius, yarn.packing_factor_in_fabric) / std::pow(1 + 0.01 * yarn.crimp_percent, 2);
    };
    return {through(open, hole * hole, across), along(q.warp, warp_r), along(q.weft, weft_r)};
}

MeasuredGeometry measure_geometry(const Design& design, const Fabric& fabric, const FittedFabric* fitted)
{
    Fabric unmeasured = fabric; // to compare with the formulas
    unmeasured.measured = {};
    const TextileRegion region{0, 0, threads_for(fabric.weave.ends(), fabric.warp_order),
                               threads_for(fabric.weave.picks(), fabric.weft_order)};
    const bool is_fitted = fitted != nullptr && fabric.measured == Measured{};
    const Textile textile = is_fitted ? build_textile(fabric, *fitted, region) : build_textile(design, unmeasured, region);
    const FabricQuantities& formula = textile.quantities;
    const double area = textile.crossings() * textile.warp.pitch * textile.weft.pitch;
    const FibreSums sums = sum_fibres(textile);
    const Cover cover = rasterize(textile);
    const auto holes = find_holes(textile);

    MeasuredGeometry m;
    m.ends = textile.ends();
    m.picks = textile.picks();
    m.flyaways_seen = sums.seen;
    m.points = sums.points + cover.points;
    for (YarnKind kind : {YarnKind::warp, YarnKind::weft}) {
        MeasuredYarn& yarn = kind == YarnKind::warp ? m.warp : m.weft;
        yarn.crimp_percent = mean_crimp_percent(textile, kind);
        yarn.cover = kind == YarnKind::warp ? cover.warp : cover.weft;
        yarn.braiding_angle_deg = mean_braiding_angle(textile, kind);
        yarn.pores = pores_of(textile.type(kind, 0));
    }
    m.cover_factor = cover.both;
    m.areal_density_g_m2 = 1e3 * sums.mass / area;
    m.yarn_layer_thickness_mm = mm_from_metre(2 * highest_of_yarns(textile));
    m.thickness_mm = std::max(m.yarn_layer_thickness_mm, mm_from_metre(sums.highest - sums.lowest));
    m.porosity = 1 - sums.volume / (area * metre_from_mm(formula.thickness_mm));
    m.fibre_volume_fraction = sums.volume / (area * metre_from_mm(m.yarn_layer_thickness_mm));
    m.smoothness = std::max(0.0, 1 - sums.flyaway / (area * metre_from_mm(formula.thickness_mm)));
    m.holes = radii_of(holes);

    double open = 0, r2 = 0;
    for (const auto& [radius_um, hole_area] : holes) {
        open += hole_area;
        r2 += hole_area * std::pow(metre_from_um(radius_um), 2);
    }
    r2 = open > 0 ? r2 / open : 0;
    const auto across = [&](YarnKind kind) {
        const YarnType& type = textile.type(kind, 0);
        return permeability_across(metre_from_um(type.fibre.fibre_radius_um), type.packing_round_core());
    };
    const auto along = [&](YarnKind kind, const MeasuredYarn& yarn) {
        const YarnType& type = textile.type(kind, 0);
        const double share = (type.area - type.core_area()) / (textile.system(kind).pitch * metre_from_mm(m.yarn_layer_thickness_mm));
        return share * permeability_along(metre_from_um(type.fibre.fibre_radius_um), type.packing_round_core()) /
               std::pow(1 + 0.01 * yarn.crimp_percent, 2);
    };
    m.permeability = {through(open / area, r2, 0.5 * (across(YarnKind::warp) + across(YarnKind::weft))), along(YarnKind::warp, m.warp),
                      along(YarnKind::weft, m.weft)};
    return m;
}

} // namespace hygroloom
