// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Liquid that suctions move along a yarn and beside it: where it stops, how fast it is drawn in, how high it stands.
#include "core/base/error.h"
#include "core/physics/water.h"
#include "core/verify/fits.h"
#include "core/verify/pore_set_ups.h"

#include <fmt/format.h>

#include <numeric>

namespace hygroloom {
namespace {

/// What no path can pass: the slug's pores at the front's suction, those beyond it just connected.
struct SlugBounds {
    double core, edge; ///< edge over the slug's length
};
SlugBounds slug_bounds(const PoreClosure& pores)
{
    const double ratio = pores.front_suction / pores.entry_suction;
    const double emptied = std::min(1.0, std::pow(pores.hysteresis / ratio, pores.shape));
    const double core = std::min(1.0 - bulging * ratio, emptied);
    return {core, 1.0 + (1.0 - core) / pores.threshold};
}

Scene slug_scene(const VerifyValues& v, const FibreBundle& bundle)
{
    const double cell = metre_from_mm(value(v, "cell_mm")), slug = metre_from_mm(value(v, "slug_mm"));
    const int full = static_cast<int>(std::lround(slug / cell));
    constexpr int most_cells = 4000;
    const double cells = 1.02 * full * slug_bounds(bundle.pores).edge + 8;
    if (full < 1 || cells > most_cells)
        throw Error(
            fmt::format("cell_mm: A slug is 1 cell to {} cells with all it can reach; {} was given.", most_cells, value(v, "cell_mm")));
    Scene scene = lone_yarn(bundle, static_cast<int>(cells), cell);
    std::fill_n(scene.cloth.start.liquid.begin(), full, cell_capacity(scene));
    scene.rules.network_step = std::max(1.0, value(v, "time_s") / 400);
    scene.rules.saturation_change = 0.03;
    return scene;
}

/// Numbers of the page for the public bundle and slug, by hysteresis and time: converged runs of another program.
struct KnownSlug {
    double hysteresis, time, core, edge, core_tolerance, edge_tolerance;
};
const KnownSlug* known_slug(const VerifyValues& v)
{
    static const KnownSlug table[] = {{0, 60, 0.984, 10.6, 0.006, 0.4},
                                      {1.2, 600, 0.655, 20.5, 0.02, 1},
                                      {1.2, 3600, 0.530, 25.6, 0.02, 1},
                                      {1, 3600, 0.300, 35.4, 0.02, 1}};
    constexpr double coarsest = 0.25; // mm, that was run
    const bool usual = value(v, "cell_mm") <= coarsest && value(v, "packing") == 0.5 && value(v, "fibre_radius_um") == 8 &&
                       value(v, "contact_angle_deg") == 35 && value(v, "receding_angle_deg") == 0 && value(v, "slug_mm") == 10;
    for (const KnownSlug& known : table)
        if (usual && known.hysteresis == value(v, "hysteresis") &&
            (known.time == value(v, "time_s") || (known.hysteresis == 0 && value(v, "time_s") > known.time)))
            return &known;
    return nullptr;
}

std::vector<VerifyResult> slug_arrest(const VerifyValues& v, Backend& backend)
{
    const FibreBundle bundle = fibre_bundle(v);
    const Scene scene = slug_scene(v, bundle);
    const Frame frame = frames_at(backend, scene, {value(v, "time_s")}).front();
    const std::vector<double> held = saturations(frame, scene);
    const double slug = value(v, "slug_mm"), edge = wet_length(held, bundle.pores.threshold, value(v, "cell_mm"));
    const SlugBounds bounds = slug_bounds(bundle.pores);
    std::vector<VerifyResult> results;
    const KnownSlug* known = known_slug(v);
    if (known)
        results = {{"core_saturation", held[0], known->core, known->core_tolerance}, {"edge_mm", edge, known->edge, known->edge_tolerance}};
    else // no other program has run it
        results = {at_least("core_saturation", held[0], bounds.core - 1e-6), at_most("edge_mm", edge, slug * bounds.edge)};
    results.push_back(at_least("least_core_saturation", held[0], bounds.core - 1e-6)); // frames show single precision
    results.push_back(at_most("largest_edge_mm", edge, slug * bounds.edge));
    return results;
}

int different_bytes(const std::vector<std::byte>& a, const std::vector<std::byte>& b)
{
    int different = static_cast<int>(std::max(a.size(), b.size()) - std::min(a.size(), b.size()));
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) different += a[i] != b[i];
    return different;
}
int different_numbers(const std::vector<float>& a, const std::vector<float>& b)
{
    int different = 0;
    for (std::size_t i = 0; i < a.size(); ++i) different += a[i] != b[i];
    return different;
}

/// All that the solver has come to after steps that grow from 1 ms to 1000 s, from a state on.
std::vector<std::byte> state_after(Backend& backend, const Scene& scene, const std::vector<std::byte>& state, double time, int steps)
{
    backend.load(scene);
    backend.go_on_from(state);
    for (int k = 0; k < steps; ++k) {
        time += 1e-3 * std::pow(10.0, 6.0 * k / std::max(1, steps - 1));
        while (backend.advance(time) < time) {}
    }
    return backend.state();
}

/// Goes on until frames show no change while time doubles: the last of what comes to rest lies a cell beyond the edge. Returns the time.
double come_to_rest(Backend& backend, double time)
{
    constexpr double longest = 1e8; // s
    for (Frame before = backend.frame(); time < longest;) {
        for (time *= 2; backend.advance(time) < time;) {}
        Frame now = backend.frame();
        if (different_numbers(before.saturation, now.saturation) == 0) break;
        before = std::move(now);
    }
    return time;
}

/// The twin's joints are closed: its state differs from that of a yarn at rest in nothing, and neither has moved.
std::vector<VerifyResult> slug_rest(const VerifyValues& v, Backend& backend)
{
    const FibreBundle bundle = fibre_bundle(v);
    Scene scene = slug_scene(v, bundle);
    scene.rules.network_step = 1e3;
    frames_at(backend, scene, {value(v, "time_s")});
    const double rest = come_to_rest(backend, value(v, "time_s"));
    const Frame before = backend.frame();
    const std::vector<std::byte> state = backend.state();
    const int steps = 2 * static_cast<int>(value(v, "steps") / 2); // even: which system goes first is part of the state
    const std::vector<std::byte> open = state_after(backend, scene, state, rest, steps);
    const Frame after = backend.frame();
    scene.cloth.yarns[0].flow_along = 0;
    const std::vector<std::byte> closed = state_after(backend, scene, state, rest, steps);
    const int moved = different_numbers(before.saturation, after.saturation) * static_cast<int>(sizeof(float));
    return {{"changed_bytes", static_cast<double>(different_bytes(open, closed) + moved), 0, 0}};
}

/// A level yarn that hangs in water with its first cell, as finely as fronts ask for.
Scene supplied_scene(const FibreBundle& bundle, int cells, double farthest, double time, int steps)
{
    Scene scene = lone_yarn(bundle, cells, 1.15 * farthest / cells);
    scene.supply.fed.assign(static_cast<std::size_t>(scene.cloth.segments()), 0);
    scene.supply.fed[0] = 1;
    scene.cloth.start.liquid[0] = cell_capacity(scene);
    scene.rules.network_step = time / steps;
    scene.rules.saturation_change = 1e3; // steps are the same whatever lies beside
    return scene;
}
/// Distances count from the middle of the cell in the water.
double drawn_distance(const std::vector<double>& held, double threshold, double cell)
{
    return wet_length(held, threshold, cell) - 0.5 * cell;
}
double full_distance(const std::vector<double>& held, double cell)
{
    constexpr double full = 0.9999;
    return cell * (static_cast<double>(std::count_if(held.begin(), held.end(), [](double s) { return s > full; })) - 0.5);
}

/// Bundles that liquid does not enter have no front.
void refuse_dry(const FibreBundle& bundle)
{
    if (bundle.gate <= 0) throw Error("contact_angle_deg: At this packing and angle water does not enter dry fibres; give a smaller one.");
}

std::vector<VerifyResult> supplied_yarn(const VerifyValues& v, Backend& backend)
{
    const FibreBundle bundle = fibre_bundle(v);
    refuse_dry(bundle);
    const double time = value(v, "time_s");
    const SuppliedFront front = supplied_front(bundle.pores, bundle.mobility(), 3.5);
    const double expected = std::sqrt(front.rate * time);
    const Scene scene = supplied_scene(bundle, 400, expected, time, 2500);
    const double cell = scene.cloth.length[0];
    const std::vector<double> held = saturations(frames_at(backend, scene, {time}).front(), scene);
    const double distance = drawn_distance(held, bundle.pores.threshold, cell);
    return {{"distance_mm", 1e3 * distance, 1e3 * expected, 0.03 * 1e3 * expected},
            {"rate_m2_s", distance * distance / time, front.rate, 0.03 * front.rate},
            {"full_to", full_distance(held, cell) / distance, front.full_to, 0.03 * front.full_to}};
}

/// The room beside the yarn of a case with entry_suction_pa.
PoreClosure room_pores_of(const VerifyValues& v, double shape, double hysteresis, double threshold)
{
    PoreClosure pores;
    pores.entry_suction = value(v, "entry_suction_pa");
    pores.shape = shape;
    pores.hysteresis = hysteresis;
    pores.threshold = threshold;
    pores.front_suction = pores.entry_suction * std::pow(threshold, -1.0 / shape);
    return pores;
}

/// So many cells that each front crosses 100 at least. Throws Error where that takes too many: a front crosses few in a step.
int cells_of_fronts(double in_yarn, double beside)
{
    constexpr double most_unlike = 12;
    const double ratio = std::max(in_yarn / beside, beside / in_yarn);
    if (ratio > most_unlike)
        throw Error(
            fmt::format("permeability_m2: Water comes {:.3g} mm in the yarn and {:.3g} mm beside it; one may come {:g} times as far as "
                        "the other. Give a value that brings them closer together.",
                        mm_from_metre(in_yarn), mm_from_metre(beside), most_unlike));
    return static_cast<int>(std::clamp(300 * ratio, 300.0, std::max(900.0, 100 * ratio)));
}

std::vector<VerifyResult> two_fronts(const VerifyValues& v, Backend& backend)
{
    constexpr double threshold = 0.3389; // of textile F's room
    const FibreBundle bundle = fibre_bundle(v);
    refuse_dry(bundle);
    const RoomBeside room{room_pores_of(v, 2.0, 1.75, threshold), value(v, "permeability_m2"), value(v, "porosity")};
    const double time = value(v, "time_s"), conductance = value(v, "conductance");
    const double in_yarn = std::sqrt(time * supplied_front(bundle.pores, bundle.mobility(), 3.5).rate);
    const double beside = std::sqrt(time * supplied_front(room.pores, room.mobility(), 4).rate);
    if (conductance > 0 && room.pores.front_suction > bundle.pores.front_suction)
        throw Error(
            fmt::format("entry_suction_pa: With a conductance at most {:.4g}, beyond which dry yarns do not fill from the room; {:g} "
                        "was given.",
                        bundle.pores.front_suction / room.pores.front_suction * room.pores.entry_suction, room.pores.entry_suction));
    const int cells = cells_of_fronts(in_yarn, beside);
    Scene both = supplied_scene(bundle, cells, std::max(in_yarn, beside), time, std::max(2000, 3 * cells));
    open_rooms(both, room);
    both.cloth.start.between[0] = room_capacity(both);
    const double cell = both.cloth.length[0], width = std::sqrt(both.cloth.yarns[0].pore_area / (1 - bundle.packing));
    const double skin = 3 * width * cell, deep = 0.25 * width; // of a square yarn with one side covered
    both.cloth.crossing[0].between.to_warp =
        conductance * skin * permeability_across(bundle.fibre_radius, bundle.packing) / (both.climate.viscosity * deep);
    const auto fronts = [&](const Scene& scene) {
        const Frame frame = frames_at(backend, scene, {time}).front();
        return std::pair{1e3 * drawn_distance(saturations(frame, scene), bundle.pores.threshold, cell),
                         1e3 * drawn_distance(room_saturations(frame, scene), threshold, cell)};
    };
    Scene yarn_alone = both, room_alone = both;
    yarn_alone.cloth.crossing[0].between.along_warp = yarn_alone.cloth.crossing[0].between.to_warp = 0;
    room_alone.cloth.yarns[0].flow_along = room_alone.cloth.crossing[0].between.to_warp = 0;
    const auto [yarn, between] = fronts(both);
    const double single_yarn = fronts(yarn_alone).first, single_between = fronts(room_alone).second;
    if (conductance > 0) // what runs ahead in the one enters the other
        return {at_least("yarn_mm", yarn, between - 1e3 * cell), at_most("between_mm", between, yarn + 1e3 * cell)};
    return {{"yarn_mm", yarn, 1e3 * in_yarn, 0.03 * 1e3 * in_yarn},
            {"between_mm", between, 1e3 * beside, 0.03 * 1e3 * beside},
            {"yarn_to_single", yarn / single_yarn, 1, 1e-3},
            {"between_to_single", between / single_between, 1, 1e-3}};
}

} // namespace

std::vector<VerifyCase> pore_flow_cases()
{
    const VerifyParameter packing{"packing", 0.5, 0.05, 0.9, ""}, radius{"fibre_radius_um", 8, 0.5, 100, ""};
    const VerifyParameter angle{"contact_angle_deg", 35, 0, 85, ""};
    const std::vector<VerifyParameter> slug{packing,
                                            radius,
                                            angle,
                                            {"receding_angle_deg", 0, 0, 85, ""},
                                            {"hysteresis", 0, 0, 5, ""},
                                            {"slug_mm", 10, 0.5, 500, ""},
                                            {"time_s", 60, 1e-3, 1e6, ""},
                                            {"cell_mm", 0.125, 0.01, 10, ""}};
    std::vector<VerifyParameter> rest = slug;
    rest.push_back(whole_number("steps", 1000, 2, 1e5));
    return {
        {"slug_arrest",
         "A slug of water in the middle of a level dry yarn: what stays in its middle, and where its end stops, by hysteresis.", slug,
         slug_arrest},
        {"slug_rest", "The same slug at its end: steps of 1 ms to 1000 s must change no byte of it.", rest, slug_rest},
        {"supplied_yarn",
         "A level dry yarn hangs in water with one end: how far water runs, against an integration of the closure for long yarns.",
         {packing, radius, angle, {"time_s", 10, 1e-3, 1e5, ""}},
         supplied_yarn},
        {"two_fronts",
         "The same beside a room between yarns, which draws water, too: without conductance (a multiple of the closure's own) each front "
         "is "
         "as alone.",
         {packing,
          radius,
          angle,
          {"permeability_m2", 2e-11, 1e-14, 1e-8, ""},
          {"entry_suction_pa", 1373, 10, 1e5, ""},
          {"porosity", 0.285, 0.01, 1, ""},
          {"conductance", 0, 0, 1e3, ""},
          {"time_s", 10, 1e-3, 1e5, ""}},
         two_fronts},
    };
}

} // namespace hygroloom
