// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Heat along yarns against Fourier's series, and the heat that sorption releases against reference integrations.
#include "core/base/error.h"
#include "core/design/design.h"
#include "core/physics/sorption.h"
#include "core/physics/water.h"
#include "core/verify/set_ups.h"
#include "core/verify/verify.h"

#include <fmt/format.h>

#include <algorithm>

namespace hygroloom {
namespace {

double warmth_at(const Frame& frame, double place) // in cells from the first one's middle
{
    const auto cell = static_cast<std::size_t>(place);
    const double share = place - static_cast<double>(cell);
    const double here = frame.temperature[cell], next = frame.temperature[cell + 1];
    return here + share * (next - here) - 293.15;
}

std::vector<VerifyResult> slab_conduction(const VerifyValues& v, Backend& backend)
{
    const double fourier = value(v, "fourier"), position = value(v, "position");
    constexpr int half = 100;
    constexpr double cell = 1e-4, diffusivity = 1e-7;
    Scene scene = warm_yarn(2 * half + 1, cell, diffusivity, true);
    const double thickness = half * cell, time = fourier * thickness * thickness / diffusivity;
    scene.rules.network_step = time / 3000;
    const Frame frame = frames_at(backend, scene, {time}).back();
    double expected = 0;
    for (int n = 0; n < 400; ++n) {
        const double m = (n + 0.5) * pi;
        expected += (n % 2 == 0 ? 2.0 : -2.0) / m * std::exp(-m * m * fourier) * std::cos(m * position);
    }
    return {{"temperature", warmth_at(frame, std::min(half * (1.0 - position), half * 2.0 - 1.0)), expected, 0.005}};
}

std::vector<VerifyResult> half_space(const VerifyValues& v, Backend& backend)
{
    const double diffusivity = value(v, "diffusivity_m2_s"), depth = metre_from_mm(value(v, "depth_mm")), time = value(v, "time_s");
    const double reach = std::sqrt(4.0 * diffusivity * time);
    constexpr int cells = 1200;
    const double cell = std::max(5.0 * reach, 1.5 * depth) / cells;
    Scene scene = warm_yarn(cells, cell, diffusivity, false);
    scene.rules.network_step = time / 3000;
    const Frame frame = frames_at(backend, scene, {time}).back();
    return {{"temperature", warmth_at(frame, depth / cell), std::erf(depth / reach), 0.005}};
}

/// A sheet whose fibres are always in equilibrium with their pores, or take up water by diffusion, in air of a humidity: one temperature,
/// one pore vapour, both faces alike. Integrated by itself, in small explicit steps, for comparison.
struct Sheet {
    double mass, specific_heat, mass_transfer, heat_transfer; // per m2 of sheet and face
    Isotherm isotherm;
    double radius, diffusivity; // 0: always in equilibrium
    double temperature, vapour; // of the air

    struct Course {
        double peak = 0, peak_time = 0, regain = 0;
    };
    /// Regain in equilibrium with the pores, by a curve that is inverted by bisection.
    double humidity_of(double regain) const
    {
        double low = 0, high = 1;
        for (int i = 0; i < 50; ++i) {
            const double middle = 0.5 * (low + high);
            (regain_at_reference(isotherm, middle) < regain ? low : high) = middle;
        }
        return 0.5 * (low + high);
    }
    Course run(double from, double until) const
    {
        constexpr int shells = 60;
        Course course;
        std::vector<double> w(diffusivity > 0 ? shells : 1, regain_at_reference(isotherm, from));
        double warmth = 0;
        const double dr = radius / shells;
        double dt = std::min(0.005, 1e-3 * mass / mass_transfer); // s
        if (diffusivity > 0) dt = std::min(dt, 0.2 * dr * dr / diffusivity);
        const auto mean = [&] {
            if (w.size() == 1) return w[0];
            double sum = 0;
            for (int k = 0; k < shells; ++k) sum += w[k] * (2 * k + 1);
            return sum / (shells * shells);
        };
        for (double time = 0; time < until; time += dt) {
            const double here = temperature + warmth, saturated = saturation_concentration(here);
            double gain = 0, skin = 0; // kg/(m2 s); humidity at the fibres' skin
            if (w.size() == 1) {
                skin = humidity_of(w[0]);
                gain = 2.0 * mass_transfer * (vapour - skin * saturated);
                w[0] += dt * gain / mass;
            } else {
                // The pores hold nothing: what comes in through the faces goes into the skin, half a shell away.
                const double conductance = mass * diffusivity * 4.0 / (radius * dr); // kg/(m2 s) per difference of regain
                double low = 0, high = 1;
                for (int i = 0; i < 50; ++i) {
                    const double middle = 0.5 * (low + high);
                    const double in = 2.0 * mass_transfer * (vapour - middle * saturated);
                    (in > conductance * (regain_at_reference(isotherm, middle) - w.back()) ? low : high) = middle;
                }
                skin = 0.5 * (low + high);
                gain = conductance * (regain_at_reference(isotherm, skin) - w.back());
                std::vector<double> next = w;
                for (int k = 0; k < shells; ++k) {
                    const auto i = static_cast<std::size_t>(k);
                    const double inner = k > 0 ? 2.0 * k * (w[i] - w[i - 1]) : 0.0;
                    const double outer =
                        k < shells - 1 ? 2.0 * (k + 1) * (w[i + 1] - w[i]) : 4.0 * shells * (regain_at_reference(isotherm, skin) - w[i]);
                    next[i] += dt * diffusivity / (dr * dr) * (outer - inner) / (2 * k + 1);
                }
                w = next;
            }
            const double regain = mean();
            const double heat = gain * (heat_of_evaporation(here) + heat_of_sorption(humidity_of(regain))) - 2.0 * heat_transfer * warmth;
            warmth += dt * heat / (mass * (specific_heat + regain * water_specific_heat));
            if (warmth > course.peak) {
                course.peak = warmth;
                course.peak_time = time + dt;
            }
        }
        course.regain = mean();
        return course;
    }
};

std::vector<VerifyResult> sorption_heating(const VerifyValues& v, Backend& backend)
{
    const Material& material = library_material(v.at("material").word);
    const std::string& curve = v.at("isotherm").word;
    if (curve != "master" && curve != "gab") throw Error(fmt::format("isotherm: Must be master or gab; \"{}\" was given.", curve));
    Isotherm isotherm = isotherm_of(material);
    isotherm.shifts = false;
    if (curve == "master") {
        isotherm.monolayer_regain = 0;
        isotherm.saturation_regain = 1; // the curve ends by itself
    } else if (isotherm.monolayer_regain <= 0) {
        throw Error(fmt::format("isotherm: The library has no GAB isotherm of {}; take master.", material.name));
    }
    const double temperature = 293.15, to = value(v, "humidity_to"), from = value(v, "humidity_from");
    const double vapour = to * saturation_concentration(temperature);
    const Sheet sheet{1e-3 * value(v, "areal_density_g_m2"),
                      material.specific_heat_j_kgk,
                      value(v, "mass_transfer_m_s"),
                      value(v, "heat_transfer_w_m2k"),
                      isotherm,
                      metre_from_um(material.fibre_radius_um),
                      value(v, "fibre_diffusivity_m2_s"),
                      temperature,
                      vapour};

    Scene scene =
        sheet_in_air(material, isotherm, {sheet.mass, sheet.mass_transfer, sheet.heat_transfer, sheet.diffusivity, from, to, temperature});
    const double course = sheet.mass * regain_at_reference(isotherm, std::max(from, to)) /
                          (2.0 * sheet.mass_transfer * saturation_concentration(temperature));
    scene.rules.network_step = std::clamp(course / 5000, 1e-3, 0.02);
    std::vector<double> times;
    const double until = 600, spacing = std::min(0.5, course / 500);
    for (double time = spacing; time < until; time += time < 500 * spacing ? spacing : 0.5) times.push_back(time);
    times.push_back(until);
    double peak = 0, peak_time = 0;
    const std::vector<Frame> frames = frames_at(backend, scene, times);
    for (const Frame& frame : frames) {
        const double rise = static_cast<double>(frame.temperature[0]) - temperature;
        if (rise > peak) {
            peak = rise;
            peak_time = frame.time;
        }
    }
    const Sheet::Course expected = sheet.run(from, until);
    return {{"peak_rise_k", peak, expected.peak, 1.0},
            {"peak_time_s", peak_time, expected.peak_time, 5.0},
            {"regain_600s", frames.back().regain[0], expected.regain, 0.03 * std::max(1e-6, expected.regain)}};
}

std::vector<VerifyResult> adiabatic_wetting(const VerifyValues& v, Backend& backend)
{
    const Material& material = library_material(v.at("material").word);
    const double regain = value(v, "regain");
    if (regain > material.saturation_regain + 1e-9)
        throw Error(fmt::format("regain: {} takes up at most {}; {} was given.", material.name, material.saturation_regain, regain));
    const Scene scene = fibre_with_liquid(material, regain);
    const Isotherm& isotherm = scene.cloth.yarns[0].isotherm;
    const double scale = scene.cloth.yarns[0].sorption_heat_scale;
    const Frame frame = frames_at(backend, scene, {600.0}).back();

    // The heat of sorption over the isotherm up to this regain.
    double heat = 0, before = 0;
    constexpr int steps = 20000;
    for (int i = 1; i <= steps && before < regain; ++i) {
        const double after = std::min(regain, regain_at_reference(isotherm, static_cast<double>(i) / steps));
        heat += scale * heat_of_sorption((i - 0.5) / steps) * (after - before);
        before = after;
    }
    const double expected = heat / (material.specific_heat_j_kgk + regain * water_specific_heat);
    return {{"rise_k", static_cast<double>(frame.temperature[0]) - isotherm_temperature, expected, std::max(0.05, 0.05 * expected)}};
}

} // namespace

std::vector<VerifyCase> heat_cases()
{
    return {
        {"slab_conduction",
         "A slab cooled on both faces: temperature against Fourier's series.",
         {{"fourier", 0.5, 1e-3, 5, ""}, {"position", 0, 0, 1, ""}},
         slab_conduction},
        {"half_space",
         "A half space whose face is cooled: temperature at a depth.",
         {{"diffusivity_m2_s", 1e-7, 1e-9, 1e-3, ""}, {"depth_mm", 1, 1e-3, 1e4, ""}, {"time_s", 5, 1e-3, 1e6, ""}},
         half_space},
        {"sorption_heating",
         "A dry sheet in moist air: how warm it gets, when, and its regain after 600 s, against an integration of its own.",
         {{"material", 0, 0, 0, "wool"},
          {"areal_density_g_m2", 250, 10, 2000, ""},
          {"humidity_from", 0, 0, 1, ""},
          {"humidity_to", 0.65, 0, 1, ""},
          {"mass_transfer_m_s", 0.005, 1e-4, 0.1, ""},
          {"heat_transfer_w_m2k", 5.48, 0, 100, ""},
          {"fibre_diffusivity_m2_s", 0, 0, 1e-10, ""},
          {"isotherm", 0, 0, 0, "master"}},
         sorption_heating},
        {"adiabatic_wetting",
         "Dry fibre absorbs liquid and keeps the heat: its warming against the heat of wetting.",
         {{"material", 0, 0, 0, "cotton"}, {"regain", 0.24, 0, 1, ""}},
         adiabatic_wetting},
    };
}

} // namespace hygroloom
