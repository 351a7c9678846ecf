// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/closed_forms.h"

#include "core/analysis/laboratory.h"
#include "core/physics/water.h"
#include "core/scene/scene.h"

#include <numeric>

namespace hygroloom {
namespace {

/// Of all fibres together, in equilibrium with the climate.
double resting_regain(const Scene& scene)
{
    double water = 0, fibres = 0;
    for (int i = 0; i < scene.cloth.segments(); ++i) {
        const bool is_warp = i < scene.cloth.crossings();
        const int line = is_warp ? i / scene.cloth.picks : scene.cloth.ends + (i - scene.cloth.crossings()) / scene.cloth.ends;
        const YarnParameters& yarn = scene.cloth.yarns[scene.cloth.type[static_cast<std::size_t>(line)]];
        const double mass = yarn.fibre_density * yarn.fibre_area * scene.cloth.fibre_length(static_cast<std::size_t>(i), yarn);
        fibres += mass;
        water += mass * yarn.resting_regain;
    }
    return water / fibres;
}

/// K, by halving between the coldest air there is and this one.
double wet_bulb(const ClimateParameters& air)
{
    double low = air.temperature - 60, high = air.temperature;
    for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        const double evaporates = air.mass_transfer * (saturation_concentration(middle) - air.vapour); // kg/(m2 s)
        (air.heat_transfer * (air.temperature - middle) > evaporates * heat_of_evaporation(middle) ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// Whether there is still water outside the fibres when the constant-rate period ends at the latest.
bool stays_wet(const Scene& scene)
{
    const ClothStart& start = scene.cloth.start;
    const auto sum = [](const std::vector<double>& masses) { return std::accumulate(masses.begin(), masses.end(), 0.0); };
    const double liquid = sum(start.liquid) + sum(start.between) + start.film;
    return liquid > 0 && steady_to * (liquid + start.bound) >= start.bound;
}

} // namespace

std::map<std::string, double> closed_forms(const RunRecord& run)
{
    const Experiment& experiment = *find_experiment(run.design, run.experiment);
    const bool conditions = info_of(experiment.type).source == WaterSource::air && run.plan.on("sorption");
    const bool dries = starts_wet(experiment.type) && run.plan.on("vapour");
    if (!conditions && !dries) return {};
    const Scene scene = build_scene(run.design, run.textile, experiment, run.plan, run.seed);
    if (!scene.climate.course.empty()) return {};
    if (conditions) return {{"regain_end", resting_regain(scene)}};
    if (!stays_wet(scene)) return {};
    const ClimateParameters& air = scene.climate;
    const double temperature = scene.rules.heat ? wet_bulb(air) : air.temperature;
    const double rate = 2 * air.mass_transfer * (saturation_concentration(temperature) - air.vapour);
    return {{"surface_temperature_steady_c", celsius_from_kelvin(temperature)}, {"drying_rate_g_m2_h", g_m2_h_per_kg_m2_s * rate}};
}

} // namespace hygroloom
