// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/verify/set_ups.h"

#include "core/analysis/measured_run.h"
#include "core/base/error.h"
#include "core/base/words.h"
#include "core/physics/air.h"
#include "core/physics/sorption.h"
#include "core/project/library.h"

#include <algorithm>

namespace hygroloom {

Scene bare_scene(int ends, int picks, double pitch, double temperature)
{
    Scene scene;
    scene.cloth.ends = ends;
    scene.cloth.picks = picks;
    scene.cloth.length.assign(static_cast<std::size_t>(scene.cloth.segments()), pitch);
    scene.cloth.warp_up.resize(static_cast<std::size_t>(scene.cloth.crossings()));
    for (int end = 0; end < ends; ++end)
        for (int pick = 0; pick < picks; ++pick) scene.cloth.warp_up[end * picks + pick] = (end + pick) % 2 == 0;
    scene.cloth.cell_area = pitch * pitch;
    scene.cloth.half_thickness = 0.25 * pitch;
    YarnParameters yarn;
    yarn.pore_area = 0.1 * pitch * pitch;
    yarn.fibre_area = 0.1 * pitch * pitch;
    yarn.fibre_radius = 8e-6;
    yarn.fibre_density = 1550;
    yarn.fibre_specific_heat = 1250;
    yarn.fibre_conductivity = 0.35;
    yarn.isotherm = {0.07, 0.24, 0, 0, 0};
    yarn.diffusivity = {DiffusionLaw::constant, 5e-14};
    yarn.vapour_diffusivity = vapour_diffusivity(temperature);
    scene.cloth.yarns = {yarn, yarn};
    scene.cloth.type.assign(static_cast<std::size_t>(ends), 0);
    scene.cloth.type.resize(static_cast<std::size_t>(ends + picks), 1);
    scene.cloth.crossing = {{0, 0, 0, 0.125 * pitch, 0.125 * pitch}};
    scene.cloth.warp_pitch = scene.cloth.weft_pitch = pitch;
    scene.cloth.profile_samples = 2;
    scene.cloth.shapes.assign(2, {0.125 * pitch, 0.25 * pitch, std::vector<float>(16, 0.0f)});
    ClimateParameters& climate = scene.climate;
    climate.temperature = temperature;
    climate.surface_tension = water_surface_tension(temperature);
    climate.viscosity = water_viscosity(temperature);
    climate.density = water_density(temperature);
    scene.rules.wicking = scene.rules.sorption = scene.rules.vapour = scene.rules.heat = false;
    scene.rules.network_step = 1e-2;
    scene.rules.saturation_change = 1.0;
    return scene;
}

std::vector<Frame> frames_at(Backend& backend, const Scene& scene, const std::vector<double>& times)
{
    backend.load(scene);
    std::vector<Frame> frames;
    for (double time : times) {
        while (backend.advance(time) < time) {}
        frames.push_back(backend.frame());
    }
    return frames;
}

const Material& library_material(const std::string& name)
{
    static const std::map<std::string, std::string> usual{{"nylon", "nylon 6.6"}, {"linen", "flax"}, {"rayon", "viscose"}};
    const auto known = usual.find(name);
    const Material* material = find_library_material(known == usual.end() ? name : known->second);
    if (material) return *material;
    throw Error("There is no material \"" + name + "\" in the library; there are: " + listed(names_in(material_library())) + ".");
}

const Fabric& library_fabric(const std::string& name)
{
    std::string names;
    for (const Preset& preset : shipped_presets()) {
        if (preset.fabric().name == name || (name.size() == 1 && preset.fabric().name == "Textile " + name)) return preset.fabric();
        names += (names.empty() ? "" : ", ") + preset.fabric().name;
    }
    throw Error("There is no fabric \"" + name + "\" in the library; there are: " + names + ".");
}

Isotherm isotherm_of(const Material& m) { return {m.standard_regain, m.saturation_regain, m.gab.monolayer_regain, m.gab.c, m.gab.k}; }

Scene fibre_in_air(const Material& material, double temperature, double humidity)
{
    Scene scene = bare_scene(1, 1, 1e-3, temperature);
    scene.rules.sorption = scene.rules.vapour = true;
    scene.rules.fibre_shells = 8;
    scene.climate.humidity = humidity;
    scene.climate.vapour = humidity * saturation_concentration(temperature);
    scene.climate.mass_transfer = 0.01;
    for (YarnParameters& yarn : scene.cloth.yarns) {
        yarn.isotherm = isotherm_of(material);
        yarn.diffusivity.constant = 1e-12; // only the end matters here
        yarn.initial_regain = 0;
        yarn.resting_regain = equilibrium_regain(yarn.isotherm, humidity, temperature);
    }
    scene.rules.network_step = 5.0;
    return scene;
}

Scene fibre_with_liquid(const Material& material, double regain)
{
    Isotherm isotherm = isotherm_of(material);
    isotherm.shifts = false; // heats of wetting are measured at one temperature
    Scene scene = bare_scene(1, 1, 1e-3, isotherm_temperature);
    scene.rules.sorption = scene.rules.vapour = scene.rules.heat = true; // vapour fills the pores; no air takes it
    scene.rules.fibre_shells = 12;
    scene.climate.humidity = scene.cloth.start.humidity = 1;
    scene.climate.vapour = saturation_concentration(scene.climate.temperature);
    scene.cloth.start.liquid.assign(2, 0.0);
    for (std::size_t i = 0; i < 2; ++i) {
        YarnParameters& yarn = scene.cloth.yarns[i];
        yarn.fibre_density = material.density_kg_m3;
        yarn.fibre_specific_heat = material.specific_heat_j_kgk;
        yarn.isotherm = isotherm;
        if (material.heat_of_wetting_j_g > 0) yarn.sorption_heat_scale = 1e3 * material.heat_of_wetting_j_g / heat_of_wetting(isotherm);
        yarn.diffusivity = {DiffusionLaw::constant, 1e-12, 0.0};
        yarn.resting_regain = 1;
        scene.cloth.start.liquid[i] = regain * scene.cloth.length[i] * yarn.fibre_area * yarn.fibre_density;
        yarn.pore_area = std::max(yarn.pore_area, 2.0 * scene.cloth.start.liquid[i] / (scene.climate.density * scene.cloth.length[i]));
    }
    scene.cloth.face_only = true;
    scene.rules.network_step = 0.05;
    return scene;
}

Scene warm_yarn(int cells, double cell, double diffusivity, bool both_ends)
{
    Scene scene = bare_scene(1, cells, cell, 293.15);
    scene.rules.heat = true;
    for (YarnParameters& yarn : scene.cloth.yarns) {
        yarn.pore_area = 1e-9 * yarn.fibre_area;
        yarn.fibre_conductivity = diffusivity * yarn.fibre_density * yarn.fibre_specific_heat;
    }
    scene.cloth.start.warmth = 1;
    scene.supply.fed.assign(static_cast<std::size_t>(scene.cloth.segments()), 0);
    scene.supply.fed[0] = 1;
    if (both_ends) scene.supply.fed[cells - 1] = 1;
    return scene;
}

Scene sheet_in_air(const Material& material, const Isotherm& isotherm, const SheetClimate& air)
{
    Scene scene = bare_scene(1, 1, 1e-3, air.temperature);
    scene.rules.sorption = scene.rules.vapour = scene.rules.heat = true;
    scene.rules.fibre_shells = air.diffusivity > 0 ? largest_shell_count : 1;
    scene.climate.humidity = air.to_humidity;
    scene.climate.vapour = air.to_humidity * saturation_concentration(air.temperature);
    scene.climate.mass_transfer = air.mass_transfer;
    scene.climate.heat_transfer = air.heat_transfer;
    scene.cloth.start.humidity = air.from_humidity;
    for (YarnParameters& yarn : scene.cloth.yarns) {
        yarn.fibre_density = material.density_kg_m3;
        yarn.fibre_specific_heat = material.specific_heat_j_kgk;
        yarn.fibre_radius = metre_from_um(material.fibre_radius_um);
        yarn.fibre_area = 0.5 * air.areal_density * scene.cloth.cell_area / (scene.cloth.length[0] * yarn.fibre_density);
        yarn.pore_area = 0.01 * yarn.fibre_area;
        yarn.isotherm = isotherm;
        yarn.diffusivity = {DiffusionLaw::constant, air.diffusivity > 0 ? air.diffusivity : 1e-6, 0.0};
        yarn.vapour_diffusivity = 0;
        yarn.initial_regain = equilibrium_regain(isotherm, air.from_humidity, air.temperature);
        yarn.resting_regain = equilibrium_regain(isotherm, air.to_humidity, air.temperature);
    }
    scene.cloth.face_only = true; // a sheet has no cut ends
    scene.rules.network_step = 0.02;
    return scene;
}

Scene wet_spot()
{
    Design design = drop_on_cotton(1, 1, 35);
    design.experiments[0].closure = Closure::paper; // pores that fill and empty bend too sharply for an order
    const Textile textile = build_textile(design, design.fabrics[0], {0, 0, 37, 41});
    ModelPlan plan;
    for (const char* part : {"wicking", "sorption", "vapour", "heat"}) plan.parts.push_back({part, true, false, ""});
    plan.fibre_shells = 6;
    plan.knobs.network_step_limit = 5e-3;
    plan.knobs.saturation_change = 0.1;
    Scene scene = build_scene(design, textile, design.experiments[0], plan, 1);
    constexpr double slower = 0.1; // so that a step does not move all of the spot
    for (YarnParameters& yarn : scene.cloth.yarns) yarn.liquid_diffusivity *= slower;
    for (CrossingParameters& crossing : scene.cloth.crossing) crossing.liquid_conductance *= slower;
    scene.cloth.start.liquid.assign(static_cast<std::size_t>(scene.cloth.segments()), 0.0);
    for (int end = 12; end < 25; ++end)
        for (int pick = 14; pick < 27; ++pick) {
            const auto i = static_cast<std::size_t>(textile.segment(YarnKind::warp, end, pick));
            scene.cloth.start.liquid[i] = 0.9 * scene.climate.density * scene.cloth.yarns[0].pore_area * scene.cloth.length[i];
        }
    return scene;
}

Fabric of_even_yarns(Fabric fabric)
{
    for (Yarn* yarn : yarns_of(fabric)) yarn->irregularity_cv = 0;
    return fabric;
}

Design design_of(Fabric fabric, Experiment experiment)
{
    Design design;
    experiment.name = name_of(experiment.type);
    design.fabrics.push_back(std::move(fabric));
    design.experiments.push_back(std::move(experiment));
    return design;
}

Design drop_on_cotton(double volume, double duration, double contact_angle)
{
    Design design;
    Fabric fabric;
    fabric.name = "cotton";
    fabric.warp.diameter_mm = fabric.weft.diameter_mm = 0.2;
    fabric.ends_per_cm = fabric.picks_per_cm = 35;
    fabric.contact_angle_deg = contact_angle;
    design.fabrics.push_back(fabric);
    Experiment experiment;
    experiment.name = "drop";
    experiment.duration_s = duration;
    experiment.sample_mm = {12, 12};
    experiment.droplets[0].volume_ul = volume;
    design.experiments.push_back(experiment);
    return design;
}

WholeRun run_whole(const Design& design, Fidelity fidelity, Backend& backend, const KnobSettings& knobs)
{
    RunOptions options;
    options.fidelity = fidelity;
    options.knobs = knobs;
    RunControl control;
    WholeRun whole;
    RunCallbacks callbacks;
    callbacks.frame = [&](const std::shared_ptr<const Frame>& frame) { whole.last = *frame; };
    const FinishedRun finished =
        run_and_measure(design, design.fabrics[0].name, design.experiments[0].name, options, backend, control, callbacks);
    whole.record = finished.run;
    whole.metrics = finished.metrics;
    return whole;
}

} // namespace hygroloom
