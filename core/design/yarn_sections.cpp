// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/yarn_sections.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

constexpr double circle_area(double diameter) { return 0.25 * pi * diameter * diameter; }

FittedYarn fit(const FreeYarn& yarn, double height, double pitch)
{
    FittedYarn fitted;
    fitted.section = height < yarn.diameter ? flattened_section(yarn.diameter, height) : Section{yarn.diameter, yarn.diameter};
    fitted.flattened = height < yarn.diameter;
    const double widest = widest_share_of_pitch * pitch;
    if (fitted.section.width > widest) {
        fitted.section = {widest, std::min(fitted.section.height, widest)};
        fitted.narrowed = true;
    }
    fitted.packing_factor = yarn.packing_factor * circle_area(yarn.diameter) / section_area(fitted.section);
    return fitted;
}

} // namespace

FreeYarn free_yarn(const Yarn& yarn, double density)
{
    // 1 kg/m3 over 1 mm2 is 1 g/km.
    FreeYarn free;
    if (yarn.diameter_mm) {
        free.diameter = *yarn.diameter_mm;
        const double solid = density * circle_area(free.diameter); // tex of a yarn without pores
        const double assumed = yarn.packing_factor.value_or(default_packing_factor);
        free.linear_density_tex = yarn.linear_density_tex.value_or(assumed * solid);
        free.packing_factor = yarn.packing_factor.value_or(free.linear_density_tex / solid);
    } else {
        free.linear_density_tex = yarn.linear_density_tex.value_or(0);
        free.packing_factor = yarn.packing_factor.value_or(default_packing_factor);
        free.diameter = std::sqrt(4 * free.linear_density_tex / (pi * density * free.packing_factor));
    }
    return free;
}

FittedYarns fit_yarns(const Fabric& fabric, const FreeYarn& warp, const FreeYarn& weft)
{
    FittedYarns fitted;
    double scale = 1;
    if (fabric.thickness_mm) {
        fitted.available_height = *fabric.thickness_mm - 2 * fabric.flyaway.loop_height_mm;
        scale = std::min(1.0, fitted.available_height / (warp.diameter + weft.diameter));
    }
    fitted.warp = fit(warp, scale * warp.diameter, 10 / fabric.ends_per_cm);
    fitted.weft = fit(weft, scale * weft.diameter, 10 / fabric.picks_per_cm);
    return fitted;
}

} // namespace hygroloom
