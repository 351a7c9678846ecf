// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/evenness.h"

#include "core/base/units.h"
#include "core/design/yarn_sections.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hygroloom {
namespace {

/// What unevenness asks of a fibre.
struct Staple {
    const char* fibre; // of the library
    bool spun;         // grown or shorn in lengths, so yarns of it are staple yarns
    double constant;   // see limit_irregularity()
    double index;      // over the limit
    double length_mm;  // usual in spinning; assumptions
};
constexpr std::array staples{
    Staple{"cotton", true, 1.06, 1.25, 28},
    Staple{"hemp", true, 1.06, 1.25, 60},
    Staple{"flax", true, 1.06, 1.25, 60},
    Staple{"wool", true, 1.12, 1.3, 65},
};
constexpr Staple man_made{"", false, 1.0, 1.25, 38};

const Staple& staple_of(const std::string& fibre)
{
    const auto found = std::find_if(staples.begin(), staples.end(), [&](const Staple& staple) { return fibre == staple.fibre; });
    return found != staples.end() ? *found : man_made;
}

/// The library's fibre that a yarn's is, or starts from.
std::string library_fibre(const Design& design, const std::string& name)
{
    const Material* material = find_material(design, name);
    return material ? library_name(*material) : name;
}

/// tex of one fibre.
double fineness(const Design& design, const std::string& name)
{
    const Material& fibre = *find_material(design, name);
    return 1e6 * fibre.density_kg_m3 * pi * std::pow(metre_from_um(fibre.fibre_radius_um), 2);
}

} // namespace

bool is_filament(const Design& design, const Yarn& yarn)
{
    constexpr double least_of_staple = 300; // turns/m
    if (yarn.yarn_class) return *yarn.yarn_class >= YarnClass::flat;
    if (yarn.filament_count) return true;
    return yarn.twist_per_m < least_of_staple && std::none_of(yarn.material.begin(), yarn.material.end(), [&](const MaterialShare& part) {
               return staple_of(library_fibre(design, part.name)).spun;
           });
}

double limit_irregularity(double constant, double yarn_density, double fibre_density)
{
    return constant / std::sqrt(std::max(1.0, yarn_density / fibre_density));
}

Unevenness typical_unevenness(const Design& design, const Yarn& yarn)
{
    constexpr double of_filaments = 0.015, most = 0.25;
    const double plies = std::sqrt(1.0 / yarn.plies);
    double constant = 0, index = 0, length = 0, fibre_tex = 0;
    for (const MaterialShare& part : yarn.material) {
        const Staple& staple = staple_of(library_fibre(design, part.name));
        constant += part.share * staple.constant;
        index += part.share * staple.index;
        length += part.share * staple.length_mm;
        fibre_tex += part.share * fineness(design, part.name);
    }
    if (is_filament(design, yarn)) return {of_filaments * plies, length};
    const double covering = yarn.core ? 1 - yarn.core->share : 1;
    const double ply_tex = covering * free_yarn(design, yarn).linear_density_tex / yarn.plies;
    return {std::min(most, index * limit_irregularity(constant, ply_tex, fibre_tex)) * plies, length};
}

} // namespace hygroloom
