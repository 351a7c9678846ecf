// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Turns a fabric's fitted yarns into SI paths; all positions follow from indices.
#include "core/geometry/textile.h"

#include "core/base/units.h"
#include "core/design/yarn_quantities.h"
#include "core/design/yarn_sections.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hygroloom {
namespace {

constexpr double default_tortuosity = 1.2; // Li and Zhu 2003, of liquid in a yarn's pores

Section metres(const Section& mm) { return {metre_from_mm(mm.width), metre_from_mm(mm.height)}; }

double smooth(double t) { return t * t * (3 - 2 * t); }
double smooth_slope(double t) { return 6 * t * (1 - t); }

/// What a yarn crosses at one end of a path.
struct Crossed {
    Section section;
    double own_rise = 0;
    double other_rise = 0;              ///< less what a gap between both leaves to the other
    const SpanSections* bent = nullptr; ///< mm, of the own yarn
};

/// From over a to under b (or over b, when it stays up). Between two different yarns the two paths that each would make are blended.
YarnPath make_path(const FittedYarns& fitted, const Section& own, const Crossed& a, const Crossed& b, double pitch, bool changes)
{
    const Interlacing from = fitted.path(pitch, own, a.section, a.own_rise), to = fitted.path(pitch, own, b.section, b.own_rise);
    const bool alike = a.own_rise == b.own_rise && a.section == b.section;
    const double sign = changes ? -1 : 1;
    YarnPath path;
    for (int i = 0; i < span_samples; ++i) {
        const double t = static_cast<double>(i) / (span_samples - 1), x = pitch * t;
        double z, slope;
        if (changes) {
            const double w = alike ? 0 : smooth(t), dw = alike ? 0 : smooth_slope(t) / pitch;
            z = (1 - w) * from.height_at(x) + w * to.height_at(x);
            slope = (1 - w) * from.slope_at(x) + w * to.slope_at(x) + dw * (to.height_at(x) - from.height_at(x));
        } else {
            z = a.own_rise + smooth(t) * (b.own_rise - a.own_rise);
            slope = smooth_slope(t) / pitch * (b.own_rise - a.own_rise);
        }
        // Its height is what the two crossed yarns leave it, its flat what is as free of both.
        const double height = std::min(squeezed_height(own, a.section, x, z + a.other_rise),
                                       squeezed_height(own, b.section, x - pitch, z + sign * b.other_rise));
        path.height.push_back(z);
        path.slope.push_back(slope);
        path.half_height.push_back(0.5 * height);
        const auto at = static_cast<std::size_t>(i);
        const double flat =
            changes ? metre_from_mm(std::min(a.bent->half_flat[at], b.bent->half_flat[at])) : 0.5 * (own.width - own.height);
        path.half_width.push_back(0.5 * height + flat);
    }
    if (changes && alike) {
        path.length = from.length;
    } else {
        for (int i = 0; i + 1 < span_samples; ++i)
            path.length += std::hypot(pitch / (span_samples - 1),
                                      path.height[static_cast<std::size_t>(i) + 1] - path.height[static_cast<std::size_t>(i)]);
    }
    return path;
}

/// Mean length of fibres that keep their places in the section along a path, at about the resolution that fibres are drawn with.
double untwisted_length(const YarnPath& path, double pitch)
{
    constexpr int radii = 6, angles = 8;
    double sum = 0;
    for (int r = 0; r < radii; ++r)
        for (int a = 0; a < angles; ++a) {
            const double radius = std::sqrt((r + 0.5) / radii), angle = 2 * pi * (a + 0.5) / angles;
            Vec3d before;
            for (std::size_t i = 0; i < span_samples; i += 8) {
                const double up = radius * path.half_height[i] * std::cos(angle), norm = 1 / std::hypot(1.0, path.slope[i]);
                const Vec3d here{pitch * static_cast<double>(i) / (span_samples - 1) - up * path.slope[i] * norm,
                                 radius * path.half_width[i] * std::sin(angle), path.height[i] + up * norm};
                if (i > 0) sum += length(here - before) / (radii * angles);
                before = here;
            }
        }
    return sum;
}

YarnType make_type(const Fabric& fabric, const Yarn& yarn, const FittedYarn& fitted, double fibre_scale)
{
    YarnType type;
    type.section = metres(fitted.section);
    type.area = section_area(type.section) * fitted.area_share;
    type.packing = fitted.packing_factor * fibre_scale;
    type.fibre = fitted.fibre;
    type.core = fitted.core;
    const double packing = type.packing_round_core();
    type.pore_radius = metre_from_um(type.fibre.fibre_radius_um * (1 - packing) / packing);
    type.tortuosity = fabric.measured.tortuosity.value_or(default_tortuosity);
    type.contact_angle = radian_from_degree(fabric.contact_angle_deg.value_or(type.fibre.contact_angle_deg));
    type.helix_tortuosity =
        fabric.measured.tortuosity.value_or(helix_tortuosity(yarn, fitted.free.diameter, fitted.free.packing_factor * fitted.core));
    type.receding_angle = radian_from_degree(fitted.receding_angle_deg);
    constexpr double between_nodes = 0.04; // m, where flat filaments are intermingled; an assumption
    if (fitted.yarn_class == YarnClass::flat) type.mouths_apart = between_nodes;
    type.perimeter_factor = type.fibre.cross_section.perimeter_factor;
    type.unevenness = fitted.unevenness;
    type.fibres = yarn.fibres_per_yarn;
    type.plies = yarn.plies;
    type.twist = yarn.twist_direction == TwistDirection::z ? yarn.twist_per_m : -yarn.twist_per_m;
    type.ply_twist = yarn.ply_twist_direction == TwistDirection::z ? yarn.ply_twist_per_m : -yarn.ply_twist_per_m;
    return type;
}

YarnSystem make_system(const Fabric& fabric, const FittedYarns& fitted, bool warp, int count, double fibre_scale)
{
    YarnSystem system;
    const YarnOrder& order = warp ? fitted.warp_order : fitted.weft_order;
    const auto& yarns = warp ? fitted.warp : fitted.weft;
    const auto& crossed = warp ? fitted.weft : fitted.warp;
    system.count = count;
    system.pitch = metre_from_mm(10 / (warp ? fabric.ends_per_cm : fabric.picks_per_cm));
    system.order = order.type;
    system.yarns = order.yarn;
    const double span = metre_from_mm(10 / (warp ? fabric.picks_per_cm : fabric.ends_per_cm));
    const double changes = share_of_changes(fabric.weave, warp);
    for (std::size_t own = 0; own < yarns.size(); ++own) {
        YarnType type = make_type(fabric, yarn_in(fabric, warp, order.yarns[own]), yarns[own], fibre_scale);
        std::vector<Crossed> all;
        for (std::size_t other = 0; other < crossed.size(); ++other) {
            const CrossingHeights& heights = warp ? fitted.at(own, other) : fitted.at(other, own);
            const Section section = metres(crossed[other].section);
            const double own_rise = metre_from_mm(warp ? heights.warp : heights.weft),
                         other_rise = metre_from_mm(warp ? heights.weft : heights.warp);
            all.push_back({section, own_rise, other_rise - left_between(type.section, own_rise, section, other_rise),
                           warp ? &fitted.span_at(own, other).warp : &fitted.span_at(other, own).weft});
            type.rise.push_back(all.back().own_rise);
        }
        for (const Crossed& before : all)
            for (const Crossed& after : all)
                for (bool turns : {false, true}) {
                    system.paths.push_back(make_path(fitted, type.section, before, after, span, turns));
                    for (double half : system.paths.back().half_width) type.widest = std::max(type.widest, 2 * half);
                }
        for (std::size_t other = 0; other < all.size(); ++other) {
            const YarnPath& path = system.paths[((own * all.size() + other) * all.size() + other) * 2 + 1];
            type.length_per_pitch.push_back(1 + (path.length / span - 1) * changes);
            type.fibre_length += changes * (untwisted_length(path, span) / path.length - 1) / static_cast<double>(all.size());
        }
        system.types.push_back(std::move(type));
    }
    return system;
}

double interpolated(const std::vector<double>& samples, double position)
{
    const double at = std::clamp(position, 0.0, 1.0) * static_cast<double>(samples.size() - 1);
    const auto low = std::min(static_cast<std::size_t>(at), samples.size() - 2);
    return samples[low] + (samples[low + 1] - samples[low]) * (at - static_cast<double>(low));
}

std::size_t wrapped(int index, std::size_t period)
{
    const auto n = static_cast<int>(period);
    return static_cast<std::size_t>(((index % n) + n) % n);
}

/// Which way a yarn is drawn at one crossing, -1, 0 or 1 half gaps: away from the neighbour that a thread parts it from.
double drawn(const Textile& textile, bool is_warp, int end, int pick)
{
    const bool up = textile.warp_up(end, pick);
    const bool before = textile.warp_up(end - (is_warp ? 1 : 0), pick - (is_warp ? 0 : 1)) != up;
    const bool after = textile.warp_up(end + (is_warp ? 1 : 0), pick + (is_warp ? 0 : 1)) != up;
    return (before ? 1.0 : 0.0) - (after ? 1.0 : 0.0);
}

bool takes_angle_of_cotton(const Fabric& fabric, const Experiment& experiment)
{
    return experiment.closure == Closure::paper && !fabric.contact_angle_deg;
}

} // namespace

int Textile::type_of(YarnKind kind, int yarn) const
{
    const YarnSystem& own = system(kind);
    if (own.types.size() == 1) return 0;
    return own.order[wrapped((kind == YarnKind::warp ? first_end : first_pick) + yarn, own.order.size())];
}

int Textile::yarn_number(YarnKind kind, int yarn) const
{
    const YarnSystem& own = system(kind);
    return own.yarns[wrapped((kind == YarnKind::warp ? first_end : first_pick) + yarn, own.yarns.size())];
}

double Textile::height_at_crossing(YarnKind kind, int end, int pick) const
{
    const bool is_warp = kind == YarnKind::warp;
    const auto crossed = static_cast<std::size_t>(type_of(other_kind(kind), is_warp ? pick : end));
    const double rise = type(kind, is_warp ? end : pick).rise[crossed];
    return warp_up(end, pick) == is_warp ? rise : -rise;
}

double Textile::shift_at_crossing(YarnKind kind, int end, int pick) const
{
    const bool is_warp = kind == YarnKind::warp;
    // A yarn is too stiff to follow every crossing: the mean over the two half floats beside it.
    const double drift =
        0.5 * drawn(*this, is_warp, end, pick) + 0.25 * (drawn(*this, is_warp, end - (is_warp ? 0 : 1), pick - (is_warp ? 1 : 0)) +
                                                         drawn(*this, is_warp, end + (is_warp ? 0 : 1), pick + (is_warp ? 1 : 0)));
    const int towards = drift > 0 ? 1 : -1;
    // A thread that passes between the two fills the room there, up to the crossings before and after.
    for (int along : {-1, 0, 1}) {
        const int here_end = end + (is_warp ? 0 : along), here_pick = pick + (is_warp ? along : 0);
        if (warp_up(here_end, here_pick) != warp_up(here_end + (is_warp ? towards : 0), here_pick + (is_warp ? 0 : towards))) return 0;
    }
    const int yarn = is_warp ? end : pick, neighbour = yarn + towards;
    const double gap = system(kind).pitch - 0.5 * (type(kind, yarn).widest + type(kind, neighbour).widest);
    return drift * 0.5 * std::max(0.0, gap);
}

bool Textile::touches_next(YarnKind kind, int end, int pick) const
{
    constexpr double drawn_apart = 1.0 - widest_share_of_pitch + 1e-6; // of the pitch: yarns that press each other are drawn so
    const bool is_warp = kind == YarnKind::warp;
    const YarnSystem& own = system(kind);
    const int yarn = is_warp ? end : pick;
    if (yarn + 1 >= own.count) return false;
    const double nearer = shift_at_crossing(kind, end, pick) - shift_at_crossing(kind, end + (is_warp ? 1 : 0), pick + (is_warp ? 0 : 1));
    return own.pitch - 0.5 * (type(kind, yarn).widest + type(kind, yarn + 1).widest) - nearer <= drawn_apart * own.pitch;
}

bool Textile::changes_after(YarnKind kind, int end, int pick) const
{
    const bool along_warp = kind == YarnKind::warp;
    return warp_up(end, pick) != warp_up(end + (along_warp ? 0 : 1), pick + (along_warp ? 1 : 0));
}

const YarnPath& Textile::path_after(YarnKind kind, int end, int pick) const
{
    const YarnSystem& own = system(kind);
    const std::size_t turns = changes_after(kind, end, pick) ? 1 : 0;
    if (own.paths.size() == 2) return own.paths[turns];
    const bool is_warp = kind == YarnKind::warp;
    const YarnKind crossed = other_kind(kind);
    const auto types = system(crossed).types.size();
    const auto self = static_cast<std::size_t>(type_of(kind, is_warp ? end : pick));
    const auto before = static_cast<std::size_t>(type_of(crossed, is_warp ? pick : end));
    const auto after = static_cast<std::size_t>(type_of(crossed, (is_warp ? pick : end) + 1));
    return own.paths[((self * types + before) * types + after) * 2 + turns];
}

double Textile::segment_length(YarnKind kind, int end, int pick) const
{
    const bool along_warp = kind == YarnKind::warp;
    return 0.5 * (path_after(kind, end - (along_warp ? 0 : 1), pick - (along_warp ? 1 : 0)).length + path_after(kind, end, pick).length);
}

namespace {

/// Whole crossings that fit. Rounded to a millionth of a pitch first, so that 2 cm at 35 ends/cm are 70 ends and not 69.
int whole(double crossings)
{
    if (!(crossings >= 1)) return 1; // nor is what is not a number
    return static_cast<int>(std::floor(std::min(crossings + 1e-6, double(largest_yarn_order))));
}

/// Of less than two yarns one.
int even(double crossings) { return std::max(1, whole(crossings) / 2 * 2); }

/// From which yarn on so many have in their middle the last beginning of a weave's repeat before the middle of a repeat with its stripes.
int first_about_a_repeat(const Fabric& fabric, bool warp, int yarns)
{
    std::int64_t ordered = 0;
    for (const YarnRun& run : warp ? fabric.warp_order : fabric.weft_order) ordered += run.count;
    const int weave = warp ? fabric.weave.ends() : fabric.weave.picks();
    const std::int64_t repeat = std::lcm(std::int64_t{weave}, std::max<std::int64_t>(1, ordered));
    if (repeat > most_yarns_before) return 0;
    const std::int64_t first = (repeat / 2 / weave * weave - yarns / 2) % repeat;
    return static_cast<int>(first < 0 ? first + repeat : first);
}

} // namespace

TextileRegion region_of_sample(const Fabric& fabric, double width_mm, double height_mm)
{
    return {0, 0, whole(0.1 * width_mm * fabric.ends_per_cm), whole(0.1 * height_mm * fabric.picks_per_cm)};
}

TextileRegion region_of_run(const Fabric& fabric, const Experiment& experiment)
{
    const auto [width, height] = sample_extent_mm(experiment);
    const int ends = even(0.1 * width * fabric.ends_per_cm), picks = even(0.1 * height * fabric.picks_per_cm);
    return {first_about_a_repeat(fabric, true, ends), first_about_a_repeat(fabric, false, picks), ends, picks};
}

Textile build_textile(const Design& design, const Fabric& fabric, const TextileRegion& region)
{
    return build_textile(fabric, fit_fabric(design, fabric), region);
}

Textile build_textile(const Fabric& fabric, const FittedFabric& fitted, const TextileRegion& region)
{
    Textile textile;
    textile.quantities = fitted.measured;
    textile.thickness = metre_from_mm(fitted.yarns.thickness());
    textile.warp = make_system(fabric, fitted.yarns, true, region.ends, fitted.fibre_scale);
    textile.weft = make_system(fabric, fitted.yarns, false, region.picks, fitted.fibre_scale);
    textile.weave = fabric.weave;
    textile.flyaway = fabric.flyaway;
    if (fabric.finish_face) textile.face_angle = radian_from_degree(*fabric.finish_face);
    if (fabric.finish_back) textile.back_angle = radian_from_degree(*fabric.finish_back);
    textile.first_end = region.first_end;
    textile.first_pick = region.first_pick;
    return textile;
}

namespace {

/// Share of each cell's crossings at which the warp is up.
std::vector<float> warp_up_in_cells(const Textile& fine, int ends, int picks)
{
    const auto overlap = [](int yarn, int yarns, int cell, int cells) {
        const long begin = std::max(long(yarn) * cells, long(cell) * yarns), end = std::min((yarn + 1L) * cells, (cell + 1L) * yarns);
        return static_cast<double>(end - begin) / cells;
    };
    const auto each = [](int yarns, int cell, int cells, const auto& visit) {
        for (long yarn = long(cell) * yarns / cells; yarn * cells < (cell + 1L) * yarns; ++yarn) visit(static_cast<int>(yarn));
    };
    std::vector<float> shares;
    shares.reserve(std::size_t(ends) * std::size_t(picks));
    for (int column = 0; column < ends; ++column)
        for (int row = 0; row < picks; ++row) {
            double up = 0, all = 0;
            each(fine.ends(), column, ends, [&](int end) {
                each(fine.picks(), row, picks, [&](int pick) {
                    const double share = overlap(end, fine.ends(), column, ends) * overlap(pick, fine.picks(), row, picks);
                    all += share;
                    if (fine.warp_up(end, pick)) up += share;
                });
            });
            shares.push_back(static_cast<float>(up / all));
        }
    return shares;
}

} // namespace

Textile in_cells(const Textile& fine, int ends, int picks)
{
    Textile cells = fine;
    cells.first_end = cells.first_pick = 0;
    cells.ends_per_cell = double(fine.ends()) / ends;
    cells.picks_per_cell = double(fine.picks()) / picks;
    const auto widen = [&fine](YarnSystem& own, YarnKind kind, int count, double crossed) {
        const double yarns = double(own.count) / count;
        own.order.clear();
        own.yarns.clear();
        for (int cell = 0; cell < count; ++cell) {
            const int middle = static_cast<int>((cell + 0.5) * yarns);
            own.order.push_back(static_cast<std::uint8_t>(fine.type_of(kind, middle)));
            own.yarns.push_back(static_cast<std::uint16_t>(fine.yarn_number(kind, middle)));
        }
        own.count = count;
        own.pitch *= yarns;
        for (YarnType& type : own.types) {
            type.section.width *= yarns;
            type.widest *= yarns;
            type.area *= yarns;
        }
        for (YarnPath& path : own.paths) {
            for (double& width : path.half_width) width *= yarns;
            for (double& slope : path.slope) slope /= crossed;
            path.length *= crossed;
        }
    };
    cells.warp_on_top = warp_up_in_cells(fine, ends, picks);
    widen(cells.warp, YarnKind::warp, ends, cells.picks_per_cell);
    widen(cells.weft, YarnKind::weft, picks, cells.ends_per_cell);
    return cells;
}

YarnPoint yarn_point(const Textile& textile, YarnKind kind, int yarn, int at, double offset)
{
    const bool is_warp = kind == YarnKind::warp;
    const bool back = offset < 0; // the path that leads here, read from its end
    const int start = back ? at - 1 : at;
    const int end = is_warp ? yarn : start, pick = is_warp ? start : yarn;
    const double position = back ? 1 + offset : offset;
    const YarnPath& path = textile.path_after(kind, end, pick);
    const double side = textile.warp_up(end, pick) == is_warp ? 1.0 : -1.0;
    const double slope = side * interpolated(path.slope, position);
    const double span = textile.system(other_kind(kind)).pitch;

    const double shift_before = textile.shift_at_crossing(kind, end, pick);
    const double shift_after = textile.shift_at_crossing(kind, end + (is_warp ? 0 : 1), pick + (is_warp ? 1 : 0));
    const double shift = shift_before + smooth(position) * (shift_after - shift_before);
    const double sideways = smooth_slope(position) / span * (shift_after - shift_before);
    const double norm = 1.0 / std::sqrt(1.0 + slope * slope + sideways * sideways);

    YarnPoint point;
    point.half_height = interpolated(path.half_height, position);
    point.half_width = interpolated(path.half_width, position);
    const double height = side * interpolated(path.height, position), along = offset * span;
    if (is_warp) {
        point.centre = {textile.x_of_end(yarn) + shift, textile.y_of_pick(at) + along, height};
        point.tangent = {sideways * norm, norm, slope * norm};
    } else {
        point.centre = {textile.x_of_end(at) + along, textile.y_of_pick(yarn) + shift, height};
        point.tangent = {norm, sideways * norm, slope * norm};
    }
    return point;
}

Textile textile_of_run(const Design& design, const Fabric& fabric, const Experiment& experiment, const TextileRegion& region,
                       const FittedFabric* fitted)
{
    if (!takes_angle_of_cotton(fabric, experiment))
        return fitted ? build_textile(fabric, *fitted, region) : build_textile(design, fabric, region);
    Fabric alike = fabric;
    alike.contact_angle_deg = find_library_material("cotton")->contact_angle_deg;
    if (!fitted) return build_textile(design, alike, region);
    return build_textile(alike, fit_fabric(design, alike, with_angle_of(design, alike, fitted->yarns)), region);
}

Textile textile_of_run(const Design& design, const Fabric& fabric, const Experiment& experiment, const FittedFabric* fitted)
{
    return textile_of_run(design, fabric, experiment, region_of_run(fabric, experiment), fitted);
}

} // namespace hygroloom
