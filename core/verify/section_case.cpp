// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Sections of yarns in cloth: how flat by their twist, how wide by their area.
#include "core/base/units.h"
#include "core/design/interlacing.h"
#include "core/design/yarn_sections.h"
#include "core/verify/verify.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

/// Measured heights over widths: 0.35 untwisted, 0.86 at a twist factor of 4600 (Afrashteh, Merati and Jeddi 2013). Between them the curve
/// is an assumption; it is kept between the lines to either end.
std::vector<VerifyResult> section(const VerifyValues& v, Backend&)
{
    constexpr double untwisted = 0.35, twisted = 0.86, hard = 4600;
    const double factor = value(v, "twist_factor"), area = value(v, "area_mm2"), height = value(v, "height_mm");
    const Design design;
    Yarn yarn;
    yarn.linear_density_tex = 20;
    yarn.twist_per_m = factor / std::sqrt(*yarn.linear_density_tex);
    const double shape = usual_shape(design, yarn, free_yarn(design, yarn));
    const double straight = untwisted + (twisted - untwisted) * std::min(1.0, factor / hard), rounder = std::min(1.0, straight + 0.2);
    const double round = std::sqrt(4 * area / pi), racetrack = area / height + (1 - 0.25 * pi) * height;
    return {{"height_over_width", shape, 0.5 * (straight + rounder), 0.5 * (rounder - straight) + 1e-9},
            {"width_mm", flattened_section(round, std::min(height, round)).width, height < round ? racetrack : round, 1e-9 * round}};
}

} // namespace

std::vector<VerifyCase> section_cases()
{
    return {{"section",
             "A ring spun yarn's section in cloth: height over width by its twist factor, turns/m x tex^0.5; width by area and height.",
             {{"twist_factor", 3800, 0, 8000, ""}, {"area_mm2", 0.03, 1e-4, 10, ""}, {"height_mm", 0.15, 0.01, 5, ""}},
             section}};
}

} // namespace hygroloom
