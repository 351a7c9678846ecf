// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The observed order of the yarns' schemes, from three resolutions each, beside the order the scheme has by its construction:
// central differences on even cells, 2 in space; implicit Euler and steps of its parts one after the other, 1 in time.
#include "core/verify/fits.h"
#include "core/verify/set_ups.h"
#include "core/verify/verify.h"

#include <cmath>
#include <numeric>

namespace hygroloom {
namespace {

using Profile = std::vector<double>;

/// A field per resolution, on equal places, each twice as fine as the one before: order = log2 of the ratio of their differences.
double observed_order(const std::array<Profile, 3>& fields)
{
    const auto apart = [](const Profile& a, const Profile& b) {
        double sum = 0;
        for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
        return sum;
    };
    return std::log2(apart(fields[0], fields[1]) / apart(fields[1], fields[2]));
}

/// run(resolution) for a resolution, twice and four times as much.
template <typename Run> double order_of(int resolution, const Run& run)
{
    return observed_order({run(resolution), run(2 * resolution), run(4 * resolution)});
}

/// Steps of the yarns begin with a millisecond, so shorter ones are all alike.
constexpr double short_time = 1e-2; // s, ten steps and more

/// A slab cooled on both faces, by Fourier number 0.2: the warmth of its middle.
Profile cooling_slab(Backend& backend, int half, int steps)
{
    constexpr double diffusivity = 1e-7, fourier = 0.2;
    const double cell = std::sqrt(diffusivity * short_time / fourier) / half;
    Scene scene = warm_yarn(2 * half + 1, cell, diffusivity, true);
    scene.cloth.start.warmth = 50; // frames are in single precision
    scene.rules.network_step = short_time / steps;
    return {frames_at(backend, scene, {short_time}).back().temperature[half]};
}

/// A fibre in liquid, by Fourier number 0.1: its regain.
Profile absorbing_fibre(Backend& backend, int shells, int steps)
{
    Scene scene = bare_scene(1, 1, 1e-3, isotherm_temperature);
    scene.rules.sorption = true;
    scene.rules.fibre_shells = shells;
    YarnParameters& yarn = scene.cloth.yarns[0];
    yarn.fibre_area = 1e-6 * yarn.pore_area;
    yarn.diffusivity.constant = 0.1 * yarn.fibre_radius * yarn.fibre_radius / short_time;
    const double full = scene.climate.density * yarn.pore_area * scene.cloth.length[0];
    scene.cloth.start.liquid = {full, full};
    scene.rules.network_step = short_time / (4 * steps); // fibres take every fourth step of the network
    return {frames_at(backend, scene, {short_time}).back().regain[0]};
}

/// Liquid in a closed yarn evens out from a cosine, D = D0 s: the means over sixteen parts of it.
Profile levelling_yarn(Backend& backend, int cells, int steps)
{
    constexpr double length = 0.01, diffusivity = 1e-3;
    constexpr int parts = 16;
    Scene scene = bare_scene(1, cells, length / cells, 293.15);
    scene.rules.wicking = true;
    scene.cloth.yarns[0].liquid_diffusivity = diffusivity;
    scene.rules.saturation_change = 1e3; // steps stay alike
    scene.rules.network_step = short_time / steps;
    scene.cloth.start.liquid.assign(static_cast<std::size_t>(scene.cloth.segments()), 0.0);
    const double capacity = scene.climate.density * scene.cloth.yarns[0].pore_area * scene.cloth.length[0];
    for (int i = 0; i < cells; ++i)
        scene.cloth.start.liquid[i] = capacity * (0.5 + 0.4 * cells / pi * (std::sin(pi * (i + 1) / cells) - std::sin(pi * i / cells)));
    const Frame frame = frames_at(backend, scene, {short_time}).back();
    Profile means(parts, 0.0);
    for (int i = 0; i < cells; ++i) means[i * parts / cells] += static_cast<double>(frame.saturation[i]) * parts / cells;
    return means;
}

/// Liquid runs into a dry yarn from its end, D = D0 s: what the yarn absorbed. The front is a corner, where no scheme keeps its order.
Profile absorbing_yarn(Backend& backend, int cells, int steps)
{
    constexpr double length = 0.01, diffusivity = 1e-3;
    const double cell = length / (cells + 0.5); // from the middle of the fed segment to the end
    Scene scene = bare_scene(1, cells + 1, cell, 293.15);
    scene.rules.wicking = true;
    scene.cloth.yarns[0].liquid_diffusivity = diffusivity;
    scene.rules.saturation_change = 1e3;
    scene.rules.network_step = short_time / steps;
    scene.supply.fed.assign(static_cast<std::size_t>(scene.cloth.segments()), 0);
    scene.supply.fed[0] = 1;
    const Frame frame = frames_at(backend, scene, {short_time}).back();
    const double held = std::accumulate(frame.saturation.begin() + 1, frame.saturation.begin() + cells + 1, 0.0);
    return {(held + 0.5) * cell / length};
}

/// A wet spot with its parts at work one after the other: wicking, conduction, crossings, vapour, fibres and air.
std::array<Frame, 3> working_spots(Backend& backend, bool vapour, double time, int steps)
{
    std::array<Frame, 3> frames;
    for (std::size_t k = 0; k < 3; ++k) {
        Scene scene = wet_spot();
        scene.rules.vapour = vapour;
        scene.rules.saturation_change = 1e3; // steps stay alike
        scene.rules.calm_network_step = 0;
        scene.rules.step_share = 0;
        scene.rules.network_step = time / (steps << k); // and every fourth an exchange with fibres and air
        frames[k] = frames_at(backend, scene, {time}).back();
    }
    return frames;
}

VerifyResult splitting_order(const char* name, const std::array<Frame, 3>& frames, std::vector<float> Frame::*values)
{
    const auto field = [&](const Frame& frame) { return Profile((frame.*values).begin(), (frame.*values).end()); };
    return {name, observed_order({field(frames[0]), field(frames[1]), field(frames[2])}), 1, 0.2, Rule::at_least};
}

std::vector<VerifyResult> convergence(const VerifyValues&, Backend& backend)
{
    constexpr double tolerance = 0.2;
    constexpr int steps = 80, cells = 16, shells = 8;
    std::vector<VerifyResult> results{
        {"heat_space", order_of(8, [&](int half) { return cooling_slab(backend, half, steps); }), 2, tolerance},
        {"heat_time", order_of(steps, [&](int n) { return cooling_slab(backend, cells, n); }), 1, tolerance},
        {"fibre_space", order_of(shells, [&](int n) { return absorbing_fibre(backend, n, steps); }), 2, tolerance},
        {"fibre_time", order_of(steps, [&](int n) { return absorbing_fibre(backend, 2 * shells, n); }), 1, tolerance},
        {"wicking_space", order_of(cells, [&](int n) { return levelling_yarn(backend, n, steps); }), 2, tolerance},
        {"wicking_time", order_of(steps, [&](int n) { return levelling_yarn(backend, 2 * cells, n); }), 1, tolerance},
        {"wicking_front_space", order_of(4 * cells, [&](int n) { return absorbing_yarn(backend, n, steps); }), 1, tolerance,
         Rule::at_least},
        {"wicking_front_time", order_of(steps, [&](int n) { return absorbing_yarn(backend, 8 * cells, n); }), 1, tolerance},
    };
    // Pores and their liquid reach equilibrium within a millisecond; vapour is tested with steps of several, as in runs.
    constexpr double long_time = 1; // s
    const std::array<Frame, 3> dry = working_spots(backend, false, 2 * short_time, 2 * steps),
                               all = working_spots(backend, true, long_time, steps / 4);
    results.push_back(splitting_order("splitting_saturation", dry, &Frame::saturation));
    results.push_back(splitting_order("splitting_regain", dry, &Frame::regain));
    results.push_back(splitting_order("splitting_temperature", dry, &Frame::temperature));
    const char* stops = "The steps' differences stop falling at about 10 ms; the cause has not been traced.";
    results.push_back(known_miss(splitting_order("with_vapour_regain", all, &Frame::regain), stops, 0.45));
    results.push_back(known_miss(splitting_order("with_vapour_temperature", all, &Frame::temperature), stops, 0.45));
    return results;
}

} // namespace

std::vector<VerifyCase> convergence_cases()
{
    return {{"convergence",
             "How errors fall with cells and steps twice as fine: observed orders against the schemes' own, 2 in space and 1 in time.",
             {},
             convergence,
             "",
             ""}};
}

} // namespace hygroloom
