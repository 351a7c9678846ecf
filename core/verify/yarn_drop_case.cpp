// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A drop on yarns that take up nothing: the angle it shows by the roughness and the cover of their skins (Wenzel 1936; Cassie and Baxter
// 1944), its shape by Young and Laplace.
#include "core/physics/wetting.h"
#include "core/verify/drop_set_ups.h"
#include "core/verify/fits.h"
#include "core/verify/set_ups.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

const double temperature = kelvin_from_celsius(20);
constexpr double sample_mm = 10;     // on a side
constexpr double yarn_radius = 1e-4; // m, of the parallel ones

/// What liquid touches where it sees skin that slopes less than 180 degrees less the contact angle, so that it covers whatever it gains by:
/// below 90 degrees it fills the grooves.
struct WettedSkin {
    double skin = 0;  ///< over the plane's area
    double seen = 0;  ///< the same from above
    double crown = 0; ///< m, height of the highest skin
    double cosine(double angle) const { return skin * std::cos(angle) + seen - 1.0; }
};

/// Racetracks that touch, cylinders where they are as wide as high.
WettedSkin skin_of_parallel(double angle, double width_over_height)
{
    const double arc = std::min(pi - angle, 0.5 * pi), flat = width_over_height - 1; // from the crown to the contact line; of the top
    return {(flat + arc) / width_over_height, (flat + std::sin(arc)) / width_over_height, yarn_radius};
}

/// Height of the upper skin of a yarn over a place of its crossing's cell, far below where it does not reach.
double upper_skin(const Textile& t, YarnKind kind, int end, int pick, double x, double y)
{
    const bool is_warp = kind == YarnKind::warp;
    const double along = is_warp ? (y - t.y_of_pick(pick)) / t.weft.pitch : (x - t.x_of_end(end)) / t.warp.pitch;
    const YarnPoint p = yarn_point(t, kind, is_warp ? end : pick, is_warp ? pick : end, std::clamp(along, -0.5, 0.5));
    const double across = std::abs(is_warp ? x - p.centre.x : y - p.centre.y);
    const double past = std::max(0.0, across - (p.half_width - p.half_height));
    if (past >= p.half_height) return -1;
    return p.centre.z + std::sqrt(p.half_height * p.half_height - past * past) / std::hypot(p.tangent.x, p.tangent.y);
}

/// Upper halves of racetracks along their centrelines, as far as no yarn lies over them; what hangs into holes is left out.
WettedSkin skin_of_weave(const Textile& t, double angle)
{
    constexpr int along_steps = 60, round_steps = 120, flat_steps = 40;
    const double cell = t.warp.pitch * t.weft.pitch, steepest = std::cos(std::min(pi - angle, 0.5 * pi));
    const int first_end = t.ends() / 2, first_pick = t.picks() / 2, ends = t.weave.ends(), picks = t.weave.picks();
    WettedSkin sum{0, 0, t.half_thickness()};
    const auto add = [&](YarnKind kind, int end, int pick, const YarnPoint& p, double across, double height, double cosine, double area) {
        const double flat = std::hypot(p.tangent.x, p.tangent.y), up = flat * cosine; // of the normal
        const bool is_warp = kind == YarnKind::warp;
        const double x = p.centre.x + (is_warp ? across : 0), y = p.centre.y + (is_warp ? 0 : across), z = p.centre.z + height / flat;
        if (up < steepest || upper_skin(t, other_kind(kind), end, pick, x, y) > z) return;
        sum.skin += area / flat / (cell * ends * picks);
        sum.seen += area * cosine / (cell * ends * picks);
    };
    for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
        for (int end = first_end; end < first_end + ends; ++end)
            for (int pick = first_pick; pick < first_pick + picks; ++pick)
                for (int k = 0; k < along_steps; ++k) {
                    const bool is_warp = kind == YarnKind::warp;
                    const YarnPoint p = yarn_point(t, kind, is_warp ? end : pick, is_warp ? pick : end, (k + 0.5) / along_steps - 0.5);
                    const double piece = t.system(other_kind(kind)).pitch / along_steps, core = p.half_width - p.half_height;
                    for (int i = 0; i < round_steps; ++i) {
                        const double round = pi * ((i + 0.5) / round_steps - 0.5), side = std::sin(round) * p.half_height;
                        add(kind, end, pick, p, side + std::copysign(core, side), std::cos(round) * p.half_height, std::cos(round),
                            p.half_height * pi / round_steps * piece);
                    }
                    for (int i = 0; i < flat_steps; ++i)
                        add(kind, end, pick, p, 2 * core * ((i + 0.5) / flat_steps - 0.5), p.half_height, 1, 2 * core / flat_steps * piece);
                }
    return sum;
}

/// Ends side by side; the weft is a thread in their middle that nothing meets.
Scene parallel_yarns(double width_over_height)
{
    const double pitch = 2 * yarn_radius * width_over_height;
    const int count = static_cast<int>(1e-3 * sample_mm / pitch);
    Scene scene = bare_scene(count, count, pitch, temperature);
    scene.cloth.half_thickness = yarn_radius;
    scene.cloth.crossing = {CrossingParameters{}};
    for (std::size_t type : {0, 1}) {
        const double height = type == 0 ? yarn_radius : 1e-3 * yarn_radius, width = type == 0 ? 0.5 * pitch : height;
        ContactShape& shape = scene.cloth.shapes[type];
        shape = {height, width, {}};
        for (std::size_t i = 0; i < 4 * static_cast<std::size_t>(scene.cloth.profile_samples); ++i)
            for (double part : {0.0, 0.0, height, width}) shape.profiles.push_back(static_cast<float>(part));
    }
    return scene;
}

Scene woven(const Design& design, const Textile& textile)
{
    Scene scene = build_scene(design, textile, design.experiments[0], ModelPlan{}, 1);
    scene.supply = {};
    for (YarnParameters& yarn : scene.cloth.yarns) yarn.absorbs = false;
    return scene;
}

/// Null: it must hold.
const char* why_it_misses(bool parallel, double angle_deg, double volume_ul)
{
    if (!parallel && angle_deg <= 90) return "Liquid runs into the holes between yarns, which the expected angle leaves to the air.";
    if (angle_deg < 85) return "Liquid runs along grooves away from the drop, or sticks in them where particles are as small.";
    if (angle_deg <= 90 && volume_ul >= 4) return nullptr;
    return "Yarns' beads show some 10 degrees less than asked for even where yarns are flat, and hardly see grooves.";
}

std::vector<VerifyResult> drop_on_yarns(const VerifyValues& v, Backend& backend)
{
    const double angle = radian_from_degree(value(v, "contact_angle_deg")), volume = cubic_metre_from_ul(value(v, "volume_ul"));
    Scene scene;
    WettedSkin wetted;
    if (v.at("fabric").word == "parallel") {
        scene = parallel_yarns(value(v, "width_over_height"));
        wetted = skin_of_parallel(angle, value(v, "width_over_height"));
    } else {
        Experiment experiment = standard_experiment(ExperimentType::horizontal_wicking);
        experiment.climate.temperature_c = celsius_from_kelvin(temperature);
        const Design design = design_of(library_fabric(v.at("fabric").word), experiment);
        const Fabric& fabric = design.fabrics[0];
        const Textile textile = build_textile(design, fabric, region_of_sample(fabric, sample_mm, sample_mm));
        scene = woven(design, textile);
        wetted = skin_of_weave(textile, angle);
    }
    for (YarnParameters& yarn : scene.cloth.yarns) yarn.adhesion = work_of_adhesion(scene.climate.surface_tension, angle);
    const double start = angle + 0.3 * (0.5 * pi - angle); // as `sessile_drop` starts
    const Scene cap = cap_on_plate(static_cast<int>(value(v, "particles")), {volume, start, angle}, temperature);
    scene.rules = cap.rules; // free liquid alone
    scene.liquid = cap.liquid;
    for (Vec3d& p : scene.liquid.places) p.z += wetted.crown - plate_height;
    scene.liquid.vessel.reset();
    scene.liquid.gravity = gravity_acceleration;

    const double weight = gravity_acceleration * scene.climate.density / scene.climate.surface_tension;
    const double time = 12.0 * std::sqrt(scene.climate.density * volume / scene.climate.surface_tension);
    const std::vector<Frame> frames = frames_at(backend, scene, times_between(0.8 * time, time, 20));
    const DropOnPlate drop = shape_over(wetted.crown, frames, weight);
    const double cosine = wetted.cosine(angle), computed = drop.contact_angle * 180 / pi;
    std::vector<VerifyResult> results;
    if (cosine >= 1) { // it spreads without end
        results = {{"apparent_angle_deg", computed, 0, 10}};
    } else {
        const DropOnPlate expected = drop_of_volume(volume, std::acos(cosine), weight);
        results = {{"base_radius_mm", 1e3 * drop.base_radius, 1e3 * expected.base_radius, 0.1 * 1e3 * expected.base_radius},
                   {"height_mm", 1e3 * drop.height, 1e3 * expected.height, 0.1 * 1e3 * expected.height},
                   {"apparent_angle_deg", computed, expected.contact_angle * 180 / pi, 10}};
    }
    if (const char* reason = why_it_misses(v.at("fabric").word == "parallel", value(v, "contact_angle_deg"), value(v, "volume_ul")))
        for (VerifyResult& result : results) // no angle comes out by more than 45 degrees beside it
            result = known_miss(result, reason, result.name == "apparent_angle_deg" ? 45 : 0.65 * result.expected);
    return results;
}

} // namespace

std::vector<VerifyCase> yarn_drop_cases()
{
    return {{"drop_on_yarns",
             "A drop on yarns that take up nothing, `parallel` ones that touch, so wide for their height, or a library fabric's, against "
             "Wenzel, Cassie and Laplace.",
             {{"fabric", 0, 0, 0, "parallel"},
              {"volume_ul", 5, 0.5, 20, ""},
              {"contact_angle_deg", 120, 45, 150, ""},
              whole_number("particles", 1000, 200, 1e5),
              {"width_over_height", 1, 1, 20, ""}},
             drop_on_yarns}};
}

} // namespace hygroloom
