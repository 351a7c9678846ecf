// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/yarn_class.h"

#include "core/design/evenness.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {

YarnClass yarn_class_of(const Design& design, const Yarn& yarn)
{
    constexpr double flat_from = 0.6;
    if (yarn.yarn_class) return *yarn.yarn_class;
    if (!is_filament(design, yarn)) return yarn.plies > 1 ? YarnClass::plied : YarnClass::ring;
    const double by_count = yarn.diameter_mm ? default_packing_factor : info_of(YarnClass::flat).packing;
    return yarn.packing_factor.value_or(by_count) < flat_from ? YarnClass::textured : YarnClass::flat;
}

namespace {

/// Packing over that of round fibres: lobes keep fibres as far apart as the circles about them; assumptions.
double kept_apart(const Design& design, const Yarn& yarn)
{
    double share = 0, all = 0;
    for (const MaterialShare& part : yarn.material) {
        const Material* material = find_material(design, part.name);
        const std::string shape = material ? material->cross_section.shape : std::string();
        share += part.share * (shape == "trilobal" ? 0.75 : shape == "channelled" ? 0.65 : 1.0);
        all += part.share;
    }
    return all > 0 ? share / all : 1.0;
}

} // namespace

double packing_of(const Design& design, const Yarn& yarn)
{
    if (yarn.packing_factor) return *yarn.packing_factor;
    if (yarn.diameter_mm || !yarn.linear_density_tex) return default_packing_factor;
    const YarnClass kind = yarn_class_of(design, yarn);
    const double usual = info_of(kind).packing * kept_apart(design, yarn);
    if (kind == YarnClass::ring) {
        const double twist_factor = yarn.twist_per_m * std::sqrt(*yarn.linear_density_tex);
        return std::clamp(usual * std::pow(twist_factor / 3800, 0.25), 0.45 * kept_apart(design, yarn), 0.68);
    }
    const auto silk = [&](const MaterialShare& part) {
        const Material* material = find_material(design, part.name);
        return material && library_name(*material) == "silk";
    };
    return kind == YarnClass::flat && std::all_of(yarn.material.begin(), yarn.material.end(), silk) ? 0.65 : usual;
}

} // namespace hygroloom
