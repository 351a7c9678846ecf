// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/laboratory/technical.h"

#include "core/base/units.h"

#include <fmt/format.h>

#include <cmath>

namespace hygroloom {
namespace {

constexpr double cm_in_metre = 100, grams_in_tex = 1e-3; // a tex is so many grams of a metre

/// Yarns of a system that has so many threads in a metre of cloth, each so long there for a crimp (as a share).
template <typename Length>
void add_yarns(TechnicalCard& card, const Fabric& fabric, const FittedFabric& fitted, bool warp, double threads, const Length& length,
               double with_waste)
{
    const WovenYarns woven = woven_yarns(fabric, fitted.yarns);
    for (std::size_t type = 0; type < woven.types(warp).size(); ++type) {
        YarnConsumption use;
        use.warp = warp;
        use.yarn = woven.order(warp).yarns[type];
        use.share = woven.order(warp).share[type];
        use.tex = woven.types(warp)[type].free.linear_density_tex;
        use.crimp_percent = crimp_percent(woven, warp, type);
        use.grams_per_metre = use.share * threads * length(0.01 * use.crimp_percent) * use.tex * grams_in_tex * with_waste;
        if (const auto& price = yarn_in(fabric, warp, use.yarn).price; price) use.cost_per_metre = 1e-3 * use.grams_per_metre * *price;
        card.yarns.push_back(use);
    }
}

/// Of crimps that are calculated. Taylor's rule of thumb: contraction in percent is four times the intersections an inch over the cotton
/// count of the crossed yarn.
void note_take_up(TechnicalCard& card, const Fabric& fabric, const FittedFabric& fitted)
{
    const WovenYarns woven = woven_yarns(fabric, fitted.yarns);
    for (const YarnConsumption& use : card.yarns) {
        if (use.warp ? fabric.warp_crimp_percent : fabric.weft_crimp_percent) continue;
        const double crossed_per_inch = per_inch_from_per_cm(use.warp ? fabric.picks_per_cm : fabric.ends_per_cm);
        const double changes = woven.changes(use.warp) * crossed_per_inch;
        double crossed_tex = 0;
        for (const YarnConsumption& other : card.yarns)
            if (other.warp != use.warp) crossed_tex += other.share * other.tex;
        const double rule = 4 * changes / ne_from_tex(crossed_tex);
        constexpr double most = 25; // where a rule of thumb ends
        const std::string extra = use.yarn == 0 ? std::string() : fmt::format(" (extra yarn {})", use.yarn);
        if (rule < most && (use.take_up_percent() < 0.5 * rule || use.take_up_percent() > 2 * rule))
            card.notes.push_back(
                fmt::format("Take-up of the {}{} is {:.1f} %; Taylor's rule of thumb gives {:.1f} %. Set the crimps as measured.",
                            use.warp ? "warp" : "weft", extra, use.take_up_percent(), rule));
    }
}

/// Finished, cm: as asked; else by the warp's ends in the reed; else usual.
double width_of(const Fabric& fabric, const CardRequest& request)
{
    constexpr double usual = 150, usual_shrink = 1.06; // reed over finished width
    if (request.width_cm > 0) return request.width_cm;
    const Loom& loom = fabric.loom;
    if (loom.reed_width_cm && loom.ends_per_cm) return *loom.reed_width_cm * *loom.ends_per_cm / fabric.ends_per_cm;
    return loom.reed_width_cm ? *loom.reed_width_cm / usual_shrink : usual;
}

void note_loom(TechnicalCard& card, const Fabric& fabric, const CardRequest& request)
{
    const Loom& loom = fabric.loom;
    if (!(request.width_cm > 0) && loom.reed_width_cm && !loom.ends_per_cm)
        card.notes.push_back(fmt::format(
            "The finished width is not given; taken as {:.4g} cm, as if the cloth shrank by 6 % from the reed.", card.width_cm));
    if (loom.reed_width_cm && loom.ends_per_cm) {
        const double in_reed = *loom.reed_width_cm * *loom.ends_per_cm;
        if (std::abs(in_reed / card.ends - 1) > 0.02)
            card.notes.push_back(
                fmt::format("{:.0f} ends stand in the reed and {:.0f} in the finished width of {:.4g} cm: one of reed width, "
                            "setts and finished width is wrong.",
                            in_reed, card.ends, card.width_cm));
    }
    if (const auto& shrinks = card.loom.width_shrinks_percent; shrinks && (*shrinks < -2 || *shrinks > 40))
        card.notes.push_back(
            fmt::format("A cloth of {:.4g} cm does not come from a reed of {:.4g} cm.", card.width_cm, *card.loom.reed_width_cm));
    if (const auto& shrinks = card.loom.length_shrinks_percent; shrinks && (*shrinks < -2 || *shrinks > 40))
        card.notes.push_back(fmt::format("A cloth of {:.4g} picks/cm does not come from {:.4g} picks/cm on the loom.", fabric.picks_per_cm,
                                         *card.loom.picks_per_cm));
}

} // namespace

LoomState loom_state(const Fabric& fabric, double width_cm)
{
    LoomState state{fabric.loom.reed_width_cm, fabric.loom.ends_per_cm, fabric.loom.picks_per_cm, {}, {}, {}};
    const double ends = fabric.ends_per_cm * width_cm;
    if (!state.ends_per_cm && state.reed_width_cm) state.ends_per_cm = ends / *state.reed_width_cm;
    if (!state.reed_width_cm && state.ends_per_cm) state.reed_width_cm = ends / *state.ends_per_cm;
    if (state.ends_per_cm && fabric.loom.ends_per_dent) state.dents_per_10_cm = 10 * *state.ends_per_cm / *fabric.loom.ends_per_dent;
    if (state.reed_width_cm) state.width_shrinks_percent = 100 * (*state.reed_width_cm / width_cm - 1);
    if (state.picks_per_cm) state.length_shrinks_percent = 100 * (fabric.picks_per_cm / *state.picks_per_cm - 1);
    return state;
}

TechnicalCard technical_card(const Fabric& fabric, const FittedFabric& fitted, const CardRequest& request)
{
    TechnicalCard card;
    card.width_cm = width_of(fabric, request);
    card.ends = std::round(fabric.ends_per_cm * card.width_cm);
    card.loom = loom_state(fabric, card.width_cm);
    const double with_waste = 1 + 0.01 * request.waste_percent;
    const double width = card.width_cm / cm_in_metre, tails = request.tails_cm / cm_in_metre;
    const auto of_weft = [&](double crimp) {
        return tails + (card.loom.reed_width_cm ? *card.loom.reed_width_cm / cm_in_metre : width * (1 + crimp));
    };
    add_yarns(
        card, fabric, fitted, true, fabric.ends_per_cm * card.width_cm, [](double crimp) { return 1 + crimp; }, with_waste);
    add_yarns(card, fabric, fitted, false, cm_in_metre * fabric.picks_per_cm, of_weft, with_waste);
    double cost = 0;
    bool priced = true;
    for (const YarnConsumption& use : card.yarns) {
        card.grams_per_metre += use.grams_per_metre;
        cost += use.cost_per_metre.value_or(0);
        priced = priced && use.cost_per_metre;
    }
    if (priced && cost > 0) card.yarn_cost_per_metre = cost;
    note_loom(card, fabric, request);
    note_take_up(card, fabric, fitted);
    return card;
}

} // namespace hygroloom
