// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/yarn_quantities.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

/// How one type bends over another of the crossed system.
Interlacing meeting(const WovenYarns& yarns, bool warp, std::size_t type, std::size_t other)
{
    const CrossingHeights& heights = warp ? yarns.fitted.at(type, other) : yarns.fitted.at(other, type);
    return yarns.fitted.path(yarns.pitch_mm(!warp), yarns.types(warp)[type].section, yarns.types(!warp)[other].section,
                             warp ? heights.warp : heights.weft);
}

/// Mean width of one type in the fabric, mm: another where crossed yarns squeeze it.
double mean_width_of(const WovenYarns& yarns, bool warp, std::size_t type)
{
    const double changes = yarns.changes(warp);
    double sum = 0;
    for (std::size_t other = 0; other < yarns.types(!warp).size(); ++other) {
        const SpanPair& span = warp ? yarns.fitted.span_at(type, other) : yarns.fitted.span_at(other, type);
        const double bent = (warp ? span.warp : span.weft).mean_width(), straight = yarns.types(warp)[type].section.width;
        sum += yarns.order(!warp).share[other] * (changes * bent + (1 - changes) * straight);
    }
    return sum;
}

std::vector<YarnQuantities> quantities_of_types(const WovenYarns& yarns, bool warp)
{
    std::vector<YarnQuantities> all;
    for (std::size_t type = 0; type < yarns.types(warp).size(); ++type) all.push_back(yarn_quantities(yarns, warp, type));
    return all;
}

/// Those of the type that a yarn belongs to; none when the order does not have the yarn.
std::optional<YarnQuantities> of_yarn(int yarn, const YarnOrder& order, const std::vector<YarnQuantities>& types)
{
    const auto thread = std::find(order.yarn.begin(), order.yarn.end(), yarn);
    if (thread == order.yarn.end()) return {};
    return types[order.type[static_cast<std::size_t>(thread - order.yarn.begin())]];
}

} // namespace

double helix_tortuosity(const Yarn& yarn, double diameter_mm, double core)
{
    const auto mean = [](double mm, double turns_per_m) { return 1 + 0.5 * std::pow(pi * metre_from_mm(mm) * turns_per_m, 2); };
    const auto round_core = [&](double mm) { return 1 + (mean(mm, yarn.twist_per_m) - 1) * (1 + core); };
    if (yarn.plies < 2) return round_core(diameter_mm);
    return mean(diameter_mm, yarn.ply_twist_per_m) * round_core(diameter_mm / std::sqrt(yarn.plies));
}

WovenYarns woven_yarns(const Fabric& fabric, const FittedYarns& fitted)
{
    return {fabric, fitted, share_of_changes(fabric.weave, true), share_of_changes(fabric.weave, false)};
}

double crimp_percent(const WovenYarns& yarns, bool warp, std::size_t type)
{
    // A yarn runs longer than the fabric only where it changes sides.
    double sum = 0;
    for (std::size_t other = 0; other < yarns.types(!warp).size(); ++other) {
        const Interlacing path = meeting(yarns, warp, type, other);
        const double crimp = path.length / path.pitch - 1;
        sum += yarns.order(!warp).share[other] * 100 * (crimp > 1e-9 ? crimp : 0) * yarns.changes(warp);
    }
    return sum;
}

double mean_cover(const WovenYarns& yarns, bool warp)
{
    const YarnOrder& order = yarns.order(warp);
    double width = 0;
    for (std::size_t type = 0; type < order.share.size(); ++type) width += order.share[type] * mean_width_of(yarns, warp, type);
    return width / yarns.pitch_mm(warp);
}

YarnQuantities yarn_quantities(const WovenYarns& yarns, bool warp, std::size_t type)
{
    const FittedYarn& fitted = yarns.types(warp)[type];
    YarnQuantities yarn;
    yarn.linear_density_tex = fitted.free.linear_density_tex;
    yarn.diameter_mm = fitted.free.diameter;
    yarn.packing_factor = fitted.free.packing_factor;
    yarn.section_mm = fitted.section;
    yarn.area_share = fitted.area_share;
    yarn.packing_factor_in_fabric = fitted.packing_factor;
    yarn.pitch_mm = yarns.pitch_mm(warp);
    yarn.rise_mm = 2 * (warp ? yarns.fitted.at(type, 0).warp : yarns.fitted.at(0, type).weft);
    yarn.crimp_percent = crimp_percent(yarns, warp, type);
    yarn.cover = mean_width_of(yarns, warp, type) / yarn.pitch_mm;
    yarn.fibre_radius_um = fitted.fibre.fibre_radius_um;
    // Void area over wetted perimeter of parallel cylinders, twice.
    const double packing = packing_round_core(fitted.packing_factor, fitted.core);
    yarn.pore_radius_um = fitted.fibre.fibre_radius_um * (1 - packing) / packing;
    yarn.contact_angle_deg = yarns.fabric.contact_angle_deg.value_or(fitted.fibre.contact_angle_deg);
    yarn.receding_angle_deg = fitted.receding_angle_deg;
    yarn.helix_tortuosity = helix_tortuosity(yarn_in(yarns.fabric, warp, yarns.order(warp).yarns[type]), fitted.free.diameter,
                                             fitted.free.packing_factor * fitted.core);
    const Yarn& given = yarn_in(yarns.fabric, warp, yarns.order(warp).yarns[type]);
    yarn.yarn_class = fitted.yarn_class;
    yarn.shape = fitted.shape;
    yarn.class_assumed = !given.yarn_class;
    yarn.packing_assumed = !given.packing_factor && !(given.diameter_mm && given.linear_density_tex);
    yarn.flattened = fitted.flattened || fitted.narrowed;
    return yarn;
}

std::vector<StripeYarn> stripe_yarns(const Design& design, const Fabric& fabric, const FittedYarns& fitted)
{
    if (fabric.extra_yarns.empty()) return {};
    const WovenYarns yarns = woven_yarns(fabric, fitted);
    const std::vector<YarnQuantities> ends = quantities_of_types(yarns, true), picks = quantities_of_types(yarns, false);
    std::vector<StripeYarn> stripes;
    for (int yarn = 1; yarn <= static_cast<int>(fabric.extra_yarns.size()); ++yarn) {
        const Yarn& given = yarn_in(fabric, true, yarn);
        const Material fibre = yarn_substance(design, given);
        stripes.push_back({free_yarn(design, given), fabric.contact_angle_deg.value_or(fibre.contact_angle_deg),
                           of_yarn(yarn, yarns.order(true), ends), of_yarn(yarn, yarns.order(false), picks)});
    }
    return stripes;
}

} // namespace hygroloom
