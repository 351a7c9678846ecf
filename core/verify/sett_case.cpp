// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The limit of sett of both systems together, against the square cloth that is as hard to weave.
#include "core/base/units.h"
#include "core/design/jam.h"
#include "core/verify/verify.h"

namespace hygroloom {
namespace {

/// Solid round yarns of square plain cloth jam where each leaves the middle plane at 60 degrees: a pitch of two diameters times its sine.
/// Cloth of two setts is as hard to weave as square cloth whose sett is their mean on a logarithmic scale, weighted by 1 and u.
std::vector<VerifyResult> sett_limit(const VerifyValues& v, Backend&)
{
    const double density = value(v, "fibre_density_kg_m3");
    const SettSystem warp{value(v, "warp_tex"), value(v, "ends_per_cm"), density};
    const SettSystem weft{value(v, "weft_tex"), value(v, "picks_per_cm"), density};
    const double factor = value(v, "weave_factor");

    const double u = std::sqrt(4 * warp.tex / (9 * weft.tex));
    const double square_sett = std::exp((std::log(weft.sett_per_cm) + u * std::log(warp.sett_per_cm)) / (1 + u));
    const double per_cm = warp.sett_per_cm + weft.sett_per_cm; // threads, of which a cm of each weighs its tex
    const double kg_per_m = 1e-6 * (warp.sett_per_cm * warp.tex + weft.sett_per_cm * weft.tex) / per_cm;
    const double radius_m = std::sqrt(kg_per_m / density / pi);
    const double jam_pitch_cm = 100 * 4 * radius_m * std::sin(pi / 3);
    const double expected = square_sett * jam_pitch_cm / factor;
    return {{"share", sett_share(warp, weft, factor), expected, 1e-9 * expected}};
}

} // namespace

std::vector<VerifyCase> sett_cases()
{
    return {{"sett_limit",
             "How near the setts of both systems together are to the closest that looms weave, as a share.",
             {{"warp_tex", 14.7625, 0.05, 5e4, ""},
              {"weft_tex", 14.7625, 0.05, 5e4, ""},
              {"ends_per_cm", 52.4, 0.5, 500, ""},
              {"picks_per_cm", 28.3, 0.5, 500, ""},
              {"weave_factor", 1, 0.5, 10, ""},
              {"fibre_density_kg_m3", 1540, 500, 3000, ""}},
             sett_limit}};
}

} // namespace hygroloom
