// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Whole drops on cloth: nothing gets through yarn, nothing is lost.
#include "core/run/plan_run.h"
#include "core/solver/host_cloth.h"
#include "core/verify/set_ups.h"
#include "core/verify/verify.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hygroloom {
namespace {

constexpr double pitch = 3e-4; // m
constexpr int threads = 80;    // each way

/// Plain weave of yarns a sixth of the pitch high, which leave a gap of this share of the pitch between them and absorb nothing.
Scene cloth_with_gaps(double gap)
{
    Scene scene = bare_scene(threads, threads, pitch, 293.15);
    const double half_height = pitch / 6.0, half_width = 0.5 * (1.0 - gap) * pitch;
    ContactShape shape{half_height, half_width, {}};
    for (double rise : {half_height, half_height, half_height, -half_height}) // level, then from side to side
        for (double v : {rise, 0.0, half_height, half_width}) shape.profiles.push_back(static_cast<float>(v));
    scene.cloth.shapes.assign(2, shape);
    scene.cloth.crossing = {{0, 0, 0, half_height, half_height}};
    scene.cloth.half_thickness = 2.0 * half_height;
    for (YarnParameters& yarn : scene.cloth.yarns) yarn.adhesion = scene.climate.surface_tension; // at 90 degrees
    return scene;
}

/// Of all water there ever was.
double water_drift(const Ledger& ledger) { return std::abs(ledger.water_imbalance()) / (ledger.water_delivered + ledger.water_initial); }

/// Keeps a NaN.
double larger_or_nan(double a, double b) { return b > a || std::isnan(b) ? b : a; }

/// Times of an impact from a height, in moves of a tenth of the spacing, and on until the liquid has run apart.
std::vector<double> moments_of_impact(double height, double radius, double speed, double spacing)
{
    const double impact = 2.0 * (height + 2.0 * radius) / std::max(speed, 0.1);
    std::vector<double> times;
    const int samples = std::clamp(static_cast<int>(10.0 * impact * speed / spacing), 20, 400);
    for (int k = 1; k <= samples; ++k) times.push_back(impact * k / samples);
    for (int k = 1; k <= 20; ++k) times.push_back(impact + 2e-4 * k);
    return times;
}

/// How far a place lies under the nearest skin, m; NaN where there is no such place.
double under_skin(const HostCloth& cloth, const std::array<float, 3>& x, double spacing)
{
    if (!std::isfinite(x[0] + x[1] + x[2])) return std::numeric_limits<double>::quiet_NaN();
    return -static_cast<double>(nearest_skin(cloth.shape(), {Real(x[0]), Real(x[1]), Real(x[2])}, static_cast<Real>(spacing)).distance);
}

std::vector<VerifyResult> no_penetration(const VerifyValues& v, Backend& backend)
{
    const double speed = value(v, "speed_m_s"), gap = value(v, "gap_percent") / 100.0;
    const double volume = cubic_metre_from_ul(value(v, "volume_ul")), radius = std::cbrt(3.0 * volume / (4.0 * pi));
    const double spacing = std::cbrt(volume / value(v, "particles"));
    Scene scene = cloth_with_gaps(gap);
    scene.rules.particles_per_droplet = static_cast<int>(value(v, "particles"));
    scene.supply.droplets = {{0, volume, {0, 0, scene.cloth.half_thickness + 1e-6 * value(v, "height_um") + radius}, speed}};
    const HostCloth cloth(scene);
    const std::vector<double> times = moments_of_impact(1e-6 * value(v, "height_um"), radius, speed, spacing);
    double deepest = 0;
    int through = 0;
    for (const Frame& f : frames_at(backend, scene, times)) {
        int under = 0;
        for (const auto& x : f.positions) {
            // What is thrown past the edge may cling to the other face.
            if (static_cast<double>(std::max(std::abs(x[0]), std::abs(x[1]))) > 0.3 * threads * pitch) continue;
            deepest = larger_or_nan(deepest, under_skin(cloth, x, spacing) / spacing);
            under += x[2] < 0;
        }
        through = std::max(through, under);
    }
    std::vector<VerifyResult> results{{"deepest_under_skin_spacings", deepest, 0, 0.01, Rule::at_most}};
    if (gap * pitch < 0.1 * spacing) // closed to these particles
        results.push_back({"particles_through", static_cast<double>(through), 0, 0, Rule::at_most});
    return results;
}

/// A drop strikes a fabric of the library, which absorbs it: how many particles are ever seen deeper in a yarn than half-way to its
/// middle, where those must be that pass through it, or nowhere, and whether water is lost. In wedges between yarns particles stand up to a
/// quarter of their spacing under a skin (see MeetYarns); where yarns climb steeply (textiles A and B) up to 1.3 spacings at 5 m/s.
std::vector<VerifyResult> impact(const VerifyValues& v, Backend& backend)
{
    const double volume = value(v, "volume_ul"), speed = value(v, "speed_m_s"), height = 0.2; // mm
    const double radius = std::cbrt(3.0 * cubic_metre_from_ul(volume) / (4.0 * pi));
    const double spacing = std::cbrt(cubic_metre_from_ul(volume) / value(v, "particles"));
    const std::vector<double> times = moments_of_impact(1e-3 * height, radius, speed, spacing);
    Experiment experiment = standard_experiment(ExperimentType::droplet);
    experiment.sample_mm = {12, 12};
    experiment.duration_s = times.back();
    experiment.climate.temperature_c = value(v, "temperature_c");
    experiment.droplets.resize(1);
    experiment.droplets[0].volume_ul = volume;
    experiment.droplets[0].height_mm = height;
    experiment.droplets[0].speed_m_s = speed;
    const Design design = design_of(library_fabric(v.at("fabric").word), experiment);
    ModelPlan plan = plan_run(design, design.fabrics[0], experiment, Fidelity::standard, {});
    plan.particles_per_droplet = static_cast<int>(value(v, "particles"));
    const Scene scene = build_scene(design, build_textile(design, design.fabrics[0], plan.region), experiment, plan, 1);
    const HostCloth cloth(scene);
    double half_way = std::numeric_limits<double>::infinity();
    for (const ContactShape& shape : scene.cloth.shapes) half_way = std::min(half_way, 0.5 * shape.half_height);
    int inside = 0;
    double drift = 0;
    for (const Frame& f : frames_at(backend, scene, times)) {
        const auto is_inside = [&](const auto& x) { return !(under_skin(cloth, x, spacing) <= half_way); };
        inside = std::max(inside, static_cast<int>(std::count_if(f.positions.begin(), f.positions.end(), is_inside)));
        drift = larger_or_nan(drift, water_drift(f.ledger));
    }
    return {{"penetrated_particles", static_cast<double>(inside), 0, 0, Rule::at_most}, {"mass_drift", drift, 0, 1e-12}};
}

std::vector<VerifyResult> drop_conservation(const VerifyValues& v, Backend& backend)
{
    const double duration = value(v, "time_s");
    Design design = drop_on_cotton(value(v, "volume_ul"), duration, value(v, "contact_angle_deg"));
    Experiment& experiment = design.experiments[0];
    experiment.swelling = value(v, "swelling") != 0;
    ModelPlan plan =
        plan_run(design, design.fabrics[0], experiment, Fidelity::draft, {{"sorption", true}, {"vapour", true}, {"heat", true}});
    plan.particles_per_droplet = static_cast<int>(value(v, "particles"));
    const Scene scene = build_scene(design, build_textile(design, design.fabrics[0], plan.region), experiment, plan, 1);
    std::vector<double> times;
    for (int k = 1; k <= 40; ++k) times.push_back(duration * k / 40.0);
    double imbalance = 0, fullest = 0;
    for (const Frame& f : frames_at(backend, scene, times)) {
        imbalance = larger_or_nan(imbalance, water_drift(f.ledger));
        for (float s : f.saturation) fullest = std::max(fullest, static_cast<double>(s));
    }
    return {{"water_imbalance", imbalance, 0, 1e-12},
            {"fullest_pores", fullest, 1, 1e-6, Rule::at_most}}; // saturations are shown in single precision
}

} // namespace

std::vector<VerifyCase> cloth_cases()
{
    return {
        {"no_penetration",
         "A drop fired at cloth that absorbs nothing: how far under a skin a particle's middle is found, and how many pass closed cloth.",
         {{"speed_m_s", 5, 0, 20, ""},
          {"gap_percent", 2, 1, 80, ""},
          whole_number("particles", 300, 10, 1e5),
          {"volume_ul", 1, 1e-3, 10, ""},
          {"height_um", 50, 10, 1e4, ""}},
         no_penetration},
        {"impact",
         "A drop fired at a fabric of the library: particles ever seen deeper in a yarn than half-way to its middle, and drift of mass.",
         {{"volume_ul", 5, 0.01, 20, ""},
          {"speed_m_s", 3, 0, 10, ""},
          {"fabric", 0, 0, 0, "Textile F"},
          whole_number("particles", 2000, 10, 1e5),
          {"temperature_c", 20, -10, 60, ""}},
         impact},
        {"drop_conservation",
         "A drop on cotton: water in particles, yarns and air together, and pores that hold no more than they can.",
         {{"volume_ul", 2, 0.1, 20, ""},
          {"contact_angle_deg", 35, 0, 180, ""},
          whole_number("particles", 500, 10, 1e5),
          {"time_s", 0.4, 0.01, 100, ""},
          on_or_off("swelling", false)},
         drop_conservation},
    };
}

} // namespace hygroloom
