// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "app/cli_weave.h"

#include "app/cli_print.h"

#include "core/design/drawdown.h"
#include "core/design/jam.h"
#include "core/design/weave_analysis.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hygroloom {
namespace {

using Json = nlohmann::ordered_json;

/// {"longest": 3, "longest_mm": 1.5, "count": {"1": 4, "3": 2}}
Json floats_json(const Floats& floats, double crossed_per_cm)
{
    Json json{{"longest", floats.longest}, {"longest_mm", 10 * floats.longest / crossed_per_cm}, {"count", Json::object()}};
    for (std::size_t length = 1; length < floats.count.size(); ++length)
        if (floats.count[length] > 0) json["count"][std::to_string(length)] = floats.count[length];
    return json;
}

Json jam_json(const JamOfSystem& jam)
{
    return {{"sett_per_cm", jam.sett_per_cm},
            {"ashenhurst_per_cm", jam.ashenhurst_per_cm},
            {"ashenhurst_percent", jam.ashenhurst_percent},
            {"peirce_per_cm", jam.peirce_per_cm},
            {"peirce_percent", jam.peirce_percent}};
}

std::string floats_text(const Floats& floats, double crossed_per_cm)
{
    if (floats.longest == 0) return "none";
    return fmt::format("{} ({:.3g} mm)", floats.longest, 10 * floats.longest / crossed_per_cm);
}

/// Ashenhurst's rule is for square cloth.
void print_jam(const char* name, const JamOfSystem& jam, bool square)
{
    const std::string ashenhurst =
        square ? fmt::format("{:.0f} % of Ashenhurst's limit {:.3g}/cm and ", jam.ashenhurst_percent, jam.ashenhurst_per_cm) : "";
    print_result("  {} sett {:.4g}/cm is {}{:.0f} % of Peirce's limit {:.3g}/cm for round yarns\n", name, jam.sett_per_cm, ashenhurst,
                 jam.peirce_percent, jam.peirce_per_cm);
}

} // namespace

void add_weave_json(Json& json, const Fabric& fabric, const FittedYarns& yarns)
{
    const WeaveAnalysis a = analyse(fabric.weave);
    json["weave"] = {{"ends", fabric.weave.ends()},
                     {"picks", fabric.weave.picks()},
                     {"smallest_repeat", {a.repeat_ends, a.repeat_picks}},
                     {"warp_up_share", a.warp_up_share},
                     {"warp_interlacings", a.warp_interlacings},
                     {"weft_interlacings", a.weft_interlacings},
                     {"floats",
                      {{"warp_face", floats_json(a.warp_face, fabric.picks_per_cm)},
                       {"warp_back", floats_json(a.warp_back, fabric.picks_per_cm)},
                       {"weft_face", floats_json(a.weft_face, fabric.ends_per_cm)},
                       {"weft_back", floats_json(a.weft_back, fabric.ends_per_cm)}}},
                     {"unbound_ends", a.unbound_ends.size()},
                     {"unbound_picks", a.unbound_picks.size()},
                     {"cloths", a.cloths}};
    if (!fabric.weave.pattern().empty()) json["weave"]["pattern"] = fabric.weave.pattern();
    const Draft draft = fabric.weave.draft() ? *fabric.weave.draft() : smallest_draft(fabric.weave);
    json["weave"]["shafts"] = draft.shafts;
    if (draft.liftplan.empty()) json["weave"]["treadles"] = draft.treadles;
    const JamGauge jam = jam_gauge(fabric, yarns);
    json["sett_share_of_limit"] = sett_share_of_limit(fabric, yarns);
    json["jam"] = {{"warp", jam_json(jam.warp)}, {"weft", jam_json(jam.weft)}};
}

void print_weave(const Fabric& fabric, const FittedYarns& yarns)
{
    const WeaveAnalysis a = analyse(fabric.weave);
    const auto row = [](const char* name, const std::string& warp, const std::string& weft) {
        print_result("  {:<26} {:>14} {:>14}\n", name, warp, weft);
    };
    print_result("  {}: smallest repeat {} ends x {} picks, warp up at {:.3g} % of the crossings\n",
                 fabric.weave.pattern().empty() ? "free weave" : fabric.weave.pattern(), a.repeat_ends, a.repeat_picks,
                 100 * a.warp_up_share);
    const bool loose = !a.unbound_ends.empty() || !a.unbound_picks.empty(); // they float over the whole cloth
    row(loose ? "longest bound float, face" : "longest float, face", floats_text(a.warp_face, fabric.picks_per_cm),
        floats_text(a.weft_face, fabric.ends_per_cm));
    row(loose ? "longest bound float, back" : "longest float, back", floats_text(a.warp_back, fabric.picks_per_cm),
        floats_text(a.weft_back, fabric.ends_per_cm));
    row("interlacings per repeat", std::to_string(a.warp_interlacings), std::to_string(a.weft_interlacings));
    const JamGauge jam = jam_gauge(fabric, yarns);
    const bool square = is_square(fabric.ends_per_cm, fabric.picks_per_cm);
    print_result("  both setts together are {:.0f} % of their limit; looms stop at about {:.0f} %\n",
                 100 * sett_share_of_limit(fabric, yarns), 100 * most_sett_share);
    print_jam("warp", jam.warp, square);
    print_jam("weft", jam.weft, square);
}

} // namespace hygroloom
