// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/verify/set_ups.h"

#include "core/physics/air.h"

namespace hygroloom {

Scene bare_scene(int ends, int picks, double pitch, double temperature)
{
    Scene scene;
    scene.ends = ends;
    scene.picks = picks;
    scene.length.assign(static_cast<std::size_t>(scene.segments()), pitch);
    scene.warp_up.resize(static_cast<std::size_t>(scene.crossings()));
    for (int end = 0; end < ends; ++end)
        for (int pick = 0; pick < picks; ++pick) scene.warp_up[static_cast<std::size_t>(end * picks + pick)] = (end + pick) % 2 == 0;
    scene.cell_area = pitch * pitch;
    scene.half_thickness = 0.25 * pitch;
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
    scene.yarns = {yarn, yarn};
    scene.type.assign(static_cast<std::size_t>(ends), 0);
    scene.type.resize(static_cast<std::size_t>(ends + picks), 1);
    scene.crossing = {{0, 0, 0, 0.125 * pitch, 0.125 * pitch}};
    scene.warp_pitch = scene.weft_pitch = pitch;
    scene.profile_samples = 2;
    scene.shapes.assign(2, {0.125 * pitch, 0.25 * pitch, std::vector<float>(16, 0.0f)});
    ClimateParameters& climate = scene.climate;
    climate.temperature = temperature;
    climate.surface_tension = water_surface_tension(temperature);
    climate.viscosity = water_viscosity(temperature);
    climate.density = water_density(temperature);
    scene.wicking = scene.sorption = scene.vapour = scene.heat = false;
    scene.network_step = 1e-2;
    scene.saturation_change = 1.0;
    return scene;
}

std::vector<Frame> frames_at(Backend& backend, const Scene& scene, const std::vector<double>& times)
{
    backend.load(scene);
    std::vector<Frame> frames;
    for (double time : times) {
        while (backend.advance(time) < time) {
        }
        frames.push_back(backend.frame());
    }
    return frames;
}

} // namespace hygroloom
