// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/yarn_sections.h"

#include "core/base/units.h"
#include "core/design/labels.h"
#include "core/design/yarn_class.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

constexpr double flattest = 0.15; // height / diameter that flattening may reach
constexpr int flattening_steps = 34;
constexpr double steepest = 0.49; // rise over span of the steepest arcs

constexpr double circle_area(double diameter) { return 0.25 * pi * diameter * diameter; }

/// The racetrack of so much area, by its height over its width.
Section section_of_shape(double area, double shape)
{
    const double width = std::sqrt(area / (shape * (1 - (1 - 0.25 * pi) * shape)));
    return {width, shape * width};
}

/// Of a racetrack so wide, up to a circle.
double height_of_area(double area, double width)
{
    constexpr double corners = 1 - 0.25 * pi;
    const double root = width * width - 4 * corners * area;
    return std::min(width, root > 0 ? (width - std::sqrt(root)) / (2 * corners) : width);
}

/// scale: of the height that it has where only the weave presses it.
void fit(FittedYarn& yarn, double scale, double pitch)
{
    const double diameter = yarn.free.diameter * std::sqrt(yarn.loosened);
    const double widest = widest_share_of_pitch * pitch;
    Section usual = section_of_shape(circle_area(diameter), yarn.shape);
    if (yarn.soft) usual = flattened_section(diameter, pressed_height * usual.height);
    const double wider = std::min(yarn.in_floats * usual.width, widest); // floats spread within the pitch
    if (wider > usual.width) usual = {wider, height_of_area(circle_area(diameter), wider)};
    yarn.flattened = scale < 1;
    yarn.section = yarn.flattened ? flattened_section(diameter, scale * usual.height) : usual;
    yarn.narrowed = false;
    if (yarn.section.width > widest) {
        yarn.section = {widest, std::min(yarn.section.height, widest)};
        yarn.narrowed = true;
        const double closest = circle_area(yarn.free.diameter) * yarn.free.packing_factor / densest_squeezed;
        if (!yarn.flattened && section_area(yarn.section) < closest) yarn.section.height = height_of_area(closest, widest);
    }
    yarn.packing_factor = yarn.free.packing_factor * circle_area(yarn.free.diameter) / section_area(yarn.section);
    yarn.area_share = 1;
}

/// The greatest rise of a yarn over the other's sections without tightening its arcs, from 0 to the sum of the half heights.
double rise_before_jam(double span, const Section& own, const Section& other)
{
    const double radius = 0.5 * (own.height + other.height);
    const double across = 0.5 * span - 0.5 * std::max(0.0, other.width - other.height);
    return across >= radius ? radius : radius - std::sqrt(radius * radius - across * across);
}

/// The rise that gives a crimp over one change of sides, at most most.
double rise_of_crimp(const FittedYarns& fitted, double span, const Section& own, const Section& other, double crimp, double most)
{
    if (crimp <= 0) return 0;
    double low = 0, high = most;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (fitted.path(span, own, other, middle).length / span - 1 < crimp ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// What fit_yarns() works on.
struct Weaver {
    FittedYarns& fitted;
    double warp_pitch, weft_pitch;
    double along_warp, along_weft;           // share_of_changes()
    double warp_crimp = -1, weft_crimp = -1; // of one change of sides; negative: not set

    void lay(double scale)
    {
        for (FittedYarn& yarn : fitted.warp) fit(yarn, scale, warp_pitch);
        for (FittedYarn& yarn : fitted.weft) fit(yarn, scale, weft_pitch);
        fitted.heights.clear();
        for (const FittedYarn& warp : fitted.warp)
            for (const FittedYarn& weft : fitted.weft) fitted.heights.push_back(rises(warp, weft));
    }

    /// No arc turns by more than a right angle; level faces always do with less.
    CrossingHeights highest(const Section& warp, const Section& weft) const
    {
        const double sum = 0.5 * (warp.height + weft.height);
        return {std::min(sum, std::max(0.5 * weft.height, steepest * weft_pitch)),
                std::min(sum, std::max(0.5 * warp.height, steepest * warp_pitch))};
    }

    CrossingHeights rises(const FittedYarn& warp, const FittedYarn& weft) const
    {
        const Section &a = warp.section, &b = weft.section;
        const double sum = 0.5 * (a.height + b.height);
        const auto [warp_limit, weft_limit] = highest(a, b);
        if (warp_crimp >= 0 && weft_crimp >= 0)
            return {rise_of_crimp(fitted, weft_pitch, a, b, warp_crimp, warp_limit),
                    rise_of_crimp(fitted, warp_pitch, b, a, weft_crimp, weft_limit)};
        if (warp_crimp >= 0) {
            const double rise = std::max(sum - weft_limit, rise_of_crimp(fitted, weft_pitch, a, b, warp_crimp, warp_limit));
            return {rise, sum - rise};
        }
        if (weft_crimp >= 0) {
            const double rise = std::max(sum - warp_limit, rise_of_crimp(fitted, warp_pitch, b, a, weft_crimp, weft_limit));
            return {sum - rise, rise};
        }
        const double warp_gives = std::pow(weft_pitch, 1.5), weft_gives = std::pow(warp_pitch, 1.5);
        // Level faces jam last of all, so each may rise at least as far.
        const double warp_most = std::max(0.5 * b.height, rise_before_jam(weft_pitch, a, b));
        const double weft_most = std::max(0.5 * a.height, rise_before_jam(warp_pitch, b, a));
        const double warp_rise =
            std::min(std::max(sum * warp_gives / (warp_gives + weft_gives), sum - weft_most), warp_most); // where all jams, warp_most
        return {warp_rise, sum - warp_rise};
    }

    bool jams()
    {
        bool jams = false;
        for (std::size_t i = 0; i < fitted.warp.size(); ++i)
            for (std::size_t j = 0; j < fitted.weft.size(); ++j) {
                const Section &a = fitted.warp[i].section, &b = fitted.weft[j].section;
                jams = jams || (along_warp > 0 && fitted.path(weft_pitch, a, b, fitted.at(i, j).warp).jammed) ||
                       (along_weft > 0 && fitted.path(warp_pitch, b, a, fitted.at(i, j).weft).jammed);
            }
        return jams;
    }

    bool touching_neighbours() const
    {
        const auto narrowed = [](const FittedYarn& yarn) { return yarn.narrowed; };
        return std::any_of(fitted.warp.begin(), fitted.warp.end(), narrowed) ||
               std::any_of(fitted.weft.begin(), fitted.weft.end(), narrowed);
    }

    /// Whether set crimps leave the yarns of every crossing cutting into each other.
    bool too_high()
    {
        for (std::size_t i = 0; i < fitted.warp.size(); ++i)
            for (std::size_t j = 0; j < fitted.weft.size(); ++j) {
                const double sum = 0.5 * (fitted.warp[i].section.height + fitted.weft[j].section.height);
                if (fitted.at(i, j).warp + fitted.at(i, j).weft < sum * (1 - 1e-9)) return true;
            }
        return false;
    }

    /// Sections between the crossings, and how close that packs the yarns.
    void lay_between()
    {
        std::vector<double> ends(fitted.warp.size(), 0), picks(fitted.weft.size(), 0); // mean areas over the sections'
        fitted.spans.clear();
        for (std::size_t i = 0; i < fitted.warp.size(); ++i)
            for (std::size_t j = 0; j < fitted.weft.size(); ++j) {
                const Section &a = fitted.warp[i].section, &b = fitted.weft[j].section;
                const CrossingHeights& rise = fitted.at(i, j);
                const Spanning warp{fitted.path(weft_pitch, a, b, rise.warp), a, rise.warp, widest_share_of_pitch * warp_pitch,
                                    along_warp > 0},
                    weft{fitted.path(warp_pitch, b, a, rise.weft), b, rise.weft, widest_share_of_pitch * weft_pitch, along_weft > 0};
                fitted.spans.push_back(span_sections(warp, weft));
                ends[i] += fitted.weft_order.share[j] * mean_share(fitted.spans.back().warp, warp.path, along_warp);
                picks[j] += fitted.warp_order.share[i] * mean_share(fitted.spans.back().weft, weft.path, along_weft);
            }
        for (std::size_t i = 0; i < ends.size(); ++i) fitted.warp[i].area_share = ends[i];
        for (std::size_t j = 0; j < picks.size(); ++j) fitted.weft[j].area_share = picks[j];
    }

    static double mean_share(const SpanSections& bent, const Interlacing& path, double changes)
    {
        const double on_bends = changes * path.length;
        return (on_bends * bent.area_share + (1 - changes) * path.pitch) / (on_bends + (1 - changes) * path.pitch);
    }

    bool squeezed_too_close() const
    {
        const auto too_close = [](const FittedYarn& yarn) {
            return yarn.packing_factor > yarn.area_share * yarn.most_packing() * (1 + 1e-9);
        };
        return std::any_of(fitted.warp.begin(), fitted.warp.end(), too_close) ||
               std::any_of(fitted.weft.begin(), fitted.weft.end(), too_close);
    }

    /// Without a thickness or a set crimp: whether yarns have to be flattened to bend round each other. Yarns of given diameters as long as
    /// their arcs tighten, soft ones only where they would be packed too close.
    bool too_round()
    {
        const auto soft = [](const FittedYarn& yarn) { return yarn.soft; };
        if (std::none_of(fitted.warp.begin(), fitted.warp.end(), soft) || std::none_of(fitted.weft.begin(), fitted.weft.end(), soft))
            return jams();
        lay_between();
        return squeezed_too_close();
    }

    /// What set crimps leave overlapping is the crossing's to share.
    void part_overlapping()
    {
        for (std::size_t i = 0; i < fitted.warp.size(); ++i)
            for (std::size_t j = 0; j < fitted.weft.size(); ++j) {
                CrossingHeights& rises = fitted.heights[i * fitted.weft.size() + j];
                const double sum = 0.5 * (fitted.warp[i].section.height + fitted.weft[j].section.height);
                const double factor = sum / std::max(rises.warp + rises.weft, 1e-12);
                if (factor > 1) rises = {rises.warp * factor, rises.weft * factor};
            }
    }

    /// Yarns are packed as close as their mean area needs, up to the closest.
    void pack()
    {
        for (auto* yarns : {&fitted.warp, &fitted.weft})
            for (FittedYarn& yarn : *yarns) {
                const double packed = std::min(yarn.packing_factor / yarn.area_share, std::max(yarn.packing_factor, yarn.most_packing()));
                yarn.area_share = yarn.packing_factor / packed;
                yarn.packing_factor = packed;
            }
    }
};

/// As a share, of one change of sides; negative when it is not given.
double crimp_of_change(const std::optional<double>& set, const std::optional<double>& measured, double changes)
{
    const std::optional<double>& percent = set ? set : measured;
    return percent && changes > 0 ? 0.01 * *percent / changes : -1;
}

/// Returns the scale that it ends with.
double flatten_until(Weaver& weaver, double scale, bool (Weaver::*wrong)(), bool stop_at_neighbours)
{
    double good = scale;
    for (int step = 1; step <= flattening_steps && (weaver.*wrong)(); ++step) {
        const double next = scale + (flattest - scale) * step / flattening_steps;
        weaver.lay(next);
        if (stop_at_neighbours && weaver.touching_neighbours()) break;
        good = next;
    }
    weaver.lay(good);
    return good;
}

/// Loosens soft yarns of a cloth that lies flatter than so high, mm.
void loosen_to(Weaver& weaver, double height)
{
    for (int i = 0; i < 8; ++i) {
        const double ratio = height / weaver.fitted.thickness();
        if (ratio < 1 + 1e-6) return;
        for (auto* yarns : {&weaver.fitted.warp, &weaver.fitted.weft})
            for (FittedYarn& yarn : *yarns)
                if (yarn.soft)
                    yarn.loosened = std::max(1.0, std::min(yarn.free.packing_factor / loosest_in_cloth, yarn.loosened * ratio * ratio));
        weaver.lay(1);
    }
}

/// Set crimps that would squeeze yarns too close give way, a step at a time, to those that the yarns would have without.
void give_way(Weaver& weaver, double scale)
{
    constexpr int steps = 10;
    FittedYarns& fitted = weaver.fitted;
    const std::vector<CrossingHeights> set = fitted.heights;
    weaver.warp_crimp = weaver.weft_crimp = -1;
    fitted.roundness = 0;
    weaver.lay(1);
    const double free_scale = flatten_until(weaver, 1, &Weaver::too_round, true);
    const std::vector<CrossingHeights> free = fitted.heights;
    for (int step = 1; step <= steps; ++step) {
        const double given = static_cast<double>(step) / steps;
        weaver.lay(scale + given * (free_scale - scale));
        fitted.roundness = 1 - given;
        for (std::size_t i = 0; i < free.size(); ++i)
            fitted.heights[i] = {set[i].warp + given * (free[i].warp - set[i].warp), set[i].weft + given * (free[i].weft - set[i].weft)};
        weaver.part_overlapping();
        weaver.lay_between();
        if (!weaver.squeezed_too_close()) break;
    }
}

} // namespace

FreeYarn free_yarn(const Yarn& yarn, double density, double packing_if_open)
{
    // 1 kg/m3 over 1 mm2 is 1 g/km.
    FreeYarn free;
    if (yarn.diameter_mm) {
        free.diameter = *yarn.diameter_mm;
        const double solid = density * circle_area(free.diameter); // tex of a yarn without pores
        const double assumed = yarn.packing_factor.value_or(packing_if_open);
        free.linear_density_tex = yarn.linear_density_tex.value_or(assumed * solid);
        free.packing_factor = yarn.packing_factor.value_or(free.linear_density_tex / solid);
    } else {
        free.linear_density_tex = yarn.linear_density_tex.value_or(0);
        free.packing_factor = yarn.packing_factor.value_or(packing_if_open);
        free.diameter = std::sqrt(4 * free.linear_density_tex / (pi * density * free.packing_factor));
    }
    return free;
}

FreeYarn free_yarn(const Design& design, const Yarn& yarn)
{
    return free_yarn(yarn, yarn_substance(design, yarn).density_kg_m3, packing_of(design, yarn));
}

double usual_shape(const Design& design, const Yarn& yarn, const FreeYarn& free)
{
    if (yarn.diameter_mm) return 1;
    constexpr double flat = 0.30, textured = 0.40, plied = 0.80, looser_spun = 0.03;
    const YarnClass kind = yarn_class_of(design, yarn);
    if (kind == YarnClass::monofilament) return 1;
    if (kind == YarnClass::flat) return flat;
    if (kind == YarnClass::textured) return textured;
    if (kind == YarnClass::plied) return plied;
    constexpr double untwisted = 0.35, hard_twisted = 0.86, hard = 4600, course = 1600; // twist times the root of tex
    const double twist = std::min(hard, yarn.twist_per_m * std::sqrt(free.linear_density_tex));
    const double ring = untwisted + (hard_twisted - untwisted) * std::expm1(-twist / course) / std::expm1(-hard / course);
    return kind == YarnClass::rotor ? ring - looser_spun : ring;
}

double filament_radius_um(double linear_density_tex, int filaments, double fibre_density_kg_m3)
{
    const double section_mm2 = linear_density_tex / (filaments * fibre_density_kg_m3); // 1 tex over 1 kg/m3 is 1 mm2
    return 1e3 * std::sqrt(section_mm2 / pi);
}

YarnOrder yarn_order(const Fabric& fabric, bool warp)
{
    const std::vector<YarnRun> alike{{0, 1}};
    const std::vector<YarnRun>& given = warp ? fabric.warp_order : fabric.weft_order;
    YarnOrder order;
    std::vector<int> type_of(fabric.extra_yarns.size() + 1, -1);
    const auto plain = [&](int yarn) { return without_labels(yarn_in(fabric, warp, yarn)); };
    std::vector<Yarn> seen;
    for (const YarnRun& run : given.empty() ? alike : given) {
        int& type = type_of[run.yarn];
        if (type < 0) {
            const auto same = std::find(seen.begin(), seen.end(), plain(run.yarn));
            type = static_cast<int>(same - seen.begin());
            if (same == seen.end()) {
                seen.push_back(plain(run.yarn));
                order.yarns.push_back(run.yarn);
            }
        }
        order.type.insert(order.type.end(), static_cast<std::size_t>(run.count), static_cast<std::uint8_t>(std::min(type, 255)));
        order.yarn.insert(order.yarn.end(), static_cast<std::size_t>(run.count), static_cast<std::uint16_t>(run.yarn));
    }
    order.share.assign(order.yarns.size(), 0);
    for (std::uint8_t type : order.type)
        if (type < order.share.size()) order.share[type] += 1.0 / static_cast<double>(order.type.size());
    return order;
}

double FittedYarns::thickness() const
{
    double half = 0;
    for (std::size_t i = 0; i < warp.size(); ++i)
        for (std::size_t j = 0; j < weft.size(); ++j)
            half = std::max({half, at(i, j).warp + 0.5 * warp[i].section.height, at(i, j).weft + 0.5 * weft[j].section.height});
    return 2 * half;
}

double FittedYarns::surface() const
{
    double most = 0;
    for (const auto* yarns : {&warp, &weft})
        for (const FittedYarn& yarn : *yarns) most = std::max(most, info_of(yarn.yarn_class).surface_mm);
    return most;
}

FittedYarns fit_yarns(const Design& design, const Fabric& fabric)
{
    FittedYarns fitted;
    for (bool warp : {true, false}) {
        YarnOrder& order = warp ? fitted.warp_order : fitted.weft_order;
        order = yarn_order(fabric, warp);
        for (int number : order.yarns) {
            FittedYarn yarn;
            yarn.fibre = yarn_substance(design, yarn_in(fabric, warp, number));
            yarn.core = core_of_solids(design, yarn_in(fabric, warp, number));
            yarn.free = free_yarn(design, yarn_in(fabric, warp, number));
            yarn.yarn_class = yarn_class_of(design, yarn_in(fabric, warp, number));
            yarn.shape = usual_shape(design, yarn_in(fabric, warp, number), yarn.free);
            yarn.soft = !yarn_in(fabric, warp, number).diameter_mm && yarn.yarn_class != YarnClass::monofilament;
            if (yarn.soft) yarn.in_floats = widening_by_floats(fabric.weave, warp);
            yarn.unevenness = typical_unevenness(design, yarn_in(fabric, warp, number));
            if (const auto& given = yarn_in(fabric, warp, number).irregularity_cv) yarn.unevenness.cv = *given;
            if (const auto& filaments = yarn_in(fabric, warp, number).filament_count)
                yarn.fibre.fibre_radius_um =
                    filament_radius_um((1 - yarn.core) * yarn.free.linear_density_tex, *filaments, yarn.fibre.density_kg_m3);
            if (yarn.yarn_class == YarnClass::monofilament)
                yarn.fibre.fibre_radius_um = filament_radius_um(yarn.free.linear_density_tex, 1, yarn.fibre.density_kg_m3);
            (warp ? fitted.warp : fitted.weft).push_back(yarn);
        }
    }
    Weaver weaver{fitted, 10 / fabric.ends_per_cm, 10 / fabric.picks_per_cm, share_of_changes(fabric.weave, true),
                  share_of_changes(fabric.weave, false)};
    weaver.lay(1);
    fitted.jammed = weaver.jams();

    weaver.warp_crimp = crimp_of_change(fabric.warp_crimp_percent, fabric.measured.crimp_percent, weaver.along_warp);
    weaver.weft_crimp = crimp_of_change(fabric.weft_crimp_percent, fabric.measured.crimp_percent, weaver.along_weft);
    fitted.roundness = weaver.warp_crimp >= 0 || weaver.weft_crimp >= 0 ? 1 : 0;
    weaver.lay(1);
    double scale = 1;
    if (fabric.thickness_mm) {
        fitted.available_height = *fabric.thickness_mm - 2 * fabric.flyaway.loop_height_mm;
        for (int i = 0; i < 8 && fitted.thickness() > fitted.available_height; ++i) { // once, unless a section was narrowed or a crimp set
            scale = std::max(0.01, scale * fitted.available_height / fitted.thickness());
            weaver.lay(scale);
        }
        if (scale == 1) loosen_to(weaver, *fabric.thickness_mm - std::max(2 * fabric.flyaway.loop_height_mm, fitted.surface()));
    }
    if (weaver.warp_crimp >= 0 && weaver.weft_crimp >= 0)
        scale = flatten_until(weaver, scale, &Weaver::too_high, false);
    else if (!fabric.thickness_mm && weaver.warp_crimp < 0 && weaver.weft_crimp < 0)
        scale = flatten_until(weaver, scale, &Weaver::too_round, true);
    if (weaver.too_high()) weaver.part_overlapping();
    weaver.lay_between();
    if (fitted.roundness > 0 && !fabric.thickness_mm && weaver.squeezed_too_close()) give_way(weaver, scale);
    weaver.pack();
    return with_angle_of(design, fabric, std::move(fitted));
}

FittedYarns with_angle_of(const Design& design, const Fabric& fabric, FittedYarns yarns)
{
    for (bool warp : {true, false}) {
        const YarnOrder& order = warp ? yarns.warp_order : yarns.weft_order;
        for (std::size_t type = 0; type < order.yarns.size(); ++type)
            (warp ? yarns.warp : yarns.weft)[type].receding_angle_deg =
                receding_angle_of(design, yarn_in(fabric, warp, order.yarns[type]).material, fabric.contact_angle_deg);
    }
    return yarns;
}

} // namespace hygroloom
