// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The room between drawn yarns, and flow through voxels where it is known.
#include "core/base/error.h"
#include "core/base/units.h"
#include "core/physics/water.h"
#include "core/room/room_flow.h"
#include "core/room/room_menisci.h"
#include "core/room/room_tables.h"
#include "core/room/stokes.h"
#include "core/verify/pore_set_ups.h"

#include <fmt/format.h>

#include <cmath>

namespace hygroloom {
namespace {

/// A channel along the ends with solid above, below and beside it; outside(x, z): m from its skin into the liquid, x and z from its middle.
template <typename Outside> DrawnLayer channel(int wide, int high, double voxel, const Outside& outside)
{
    DrawnLayer layer;
    layer.per_end = wide;
    layer.per_pick = 2;
    layer.dx = layer.dy = layer.dz = voxel;
    layer.grid = {wide, 2, high, true, false};
    layer.reach = voxel * (wide + high);
    layer.outside.resize(layer.grid.size());
    for (int z = 0; z < high; ++z)
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < wide; ++x)
                layer.outside[layer.grid.at(x, y, z)] =
                    static_cast<float>(outside((x + 0.5 - 0.5 * wide) * voxel, (z + 0.5 - 0.5 * high) * voxel));
    return layer;
}

/// Flow through the whole channel for a unit gradient and viscosity, m4.
double conductance(const DrawnLayer& layer)
{
    return stokes_permeability(layer, 0, true) * layer.grid.nx * layer.dx * layer.grid.nz * layer.dz;
}

VerifyResult near_known(const char* name, double computed, double expected, double share)
{
    return {name, computed, expected, share * expected};
}

constexpr int margin = 2; // voxels of solid

std::vector<VerifyResult> stokes_slot(const VerifyValues& v, Backend&)
{
    const double voxels = value(v, "voxels");
    const int wide = static_cast<int>(std::ceil(voxels)) + 2 * margin;
    DrawnLayer layer = channel(wide, 2, 1, [&](double x, double) { return 0.5 * voxels - std::abs(x); });
    return {near_known("permeability_ratio", conductance(layer) / 2 / (std::pow(voxels, 3) / 12), 1, 2.5 / (voxels * voxels))};
}

/// Width over height at least 1 or less; White 2006.
double duct(double width, double height)
{
    double sum = 0;
    for (int n = 1; n < 40; n += 2) sum += std::tanh(0.5 * n * pi * width / height) / std::pow(n, 5);
    return width * std::pow(height, 3) / 12 * (1 - 192 / std::pow(pi, 5) * height / width * sum);
}
std::vector<VerifyResult> stokes_duct(const VerifyValues& v, Backend&)
{
    const double height = value(v, "voxels"), width = value(v, "width_over_height") * height;
    const DrawnLayer layer = channel(static_cast<int>(std::ceil(width)) + 2 * margin, static_cast<int>(std::ceil(height)) + 2 * margin, 1,
                                     [&](double x, double z) { return std::min(0.5 * width - std::abs(x), 0.5 * height - std::abs(z)); });
    const double over = std::pow(height, 4);
    return {near_known("conductance", conductance(layer) / over, duct(width, height) / over, 5 / (height * height))};
}

/// Half axes voxels and voxels x axes_ratio.
std::vector<VerifyResult> stokes_ellipse(const VerifyValues& v, Backend&)
{
    const double a = value(v, "voxels"), ratio = value(v, "axes_ratio"), b = ratio * a;
    const auto outside = [&](double x, double z) { // to first order in the distance
        const double level = std::hypot(x / a, z / b), slope = std::hypot(x / (a * a), z / (b * b));
        return level > 1e-9 ? (1 - level) * level / slope : std::min(a, b);
    };
    const DrawnLayer layer =
        channel(2 * static_cast<int>(std::ceil(a)) + 2 * margin, 2 * static_cast<int>(std::ceil(b)) + 2 * margin, 1, outside);
    return {near_known("conductance", conductance(layer) / std::pow(a, 4), pi * std::pow(ratio, 3) / (4 * (1 + ratio * ratio)),
                       0.6 / (std::min(a, b) * std::min(a, b)) + 2e-3)};
}

/// Equilateral.
std::vector<VerifyResult> stokes_triangle(const VerifyValues& v, Backend&)
{
    const double side = value(v, "voxels"), inner = side / (2 * std::sqrt(3.0)); // of the circle in it
    const auto outside = [&](double x, double z) {
        return std::min({inner + z, inner - 0.5 * z - 0.5 * std::sqrt(3.0) * x, inner - 0.5 * z + 0.5 * std::sqrt(3.0) * x});
    };
    const int all = static_cast<int>(std::ceil(2 * side / std::sqrt(3.0))) + 2 * margin;
    const DrawnLayer layer = channel(all, all, 1, outside);
    return {near_known("conductance", conductance(layer) / std::pow(side, 4), std::sqrt(3.0) / 320, 0.5 / side)};
}

/// Rods along the ends, or along the picks, in a square or hexagonal array, one layer of cells high: its faces are planes of symmetry.
double array_permeability(double solid, bool across, bool hexagonal, int voxels)
{
    // A cell of sides 1 x height with rods in its corners, and in its middle if hexagonal.
    const double height = hexagonal ? std::sqrt(3.0) : 1.0, rods = hexagonal ? 2 : 1;
    const double radius = std::sqrt(solid * height / (pi * rods));
    const int wide = voxels, high = static_cast<int>(std::lround(height * voxels));
    DrawnLayer layer;
    layer.per_end = across ? 2 : wide;
    layer.per_pick = across ? wide : 2;
    layer.dx = layer.dy = 1.0 / voxels;
    layer.dz = height / high;
    layer.grid = {layer.per_end, layer.per_pick, high, true, false};
    layer.reach = 2;
    layer.outside.resize(layer.grid.size());
    for (int z = 0; z < high; ++z)
        for (int y = 0; y < layer.grid.ny; ++y)
            for (int x = 0; x < layer.grid.nx; ++x) {
                const double u = ((across ? y : x) + 0.5) / voxels, w = (z + 0.5) * layer.dz;
                double nearest = 2;
                for (double a : {0.0, 1.0})
                    for (double b : {0.0, height}) nearest = std::min(nearest, std::hypot(u - a, w - b));
                if (hexagonal) nearest = std::min(nearest, std::hypot(u - 0.5, w - 0.5 * height));
                layer.outside[layer.grid.at(x, y, z)] = static_cast<float>(nearest - radius);
            }
    return stokes_permeability(layer, 0, true);
}
std::vector<VerifyResult> stokes_array(const VerifyValues& v, Backend&)
{
    const double solid = value(v, "solid_share");
    const bool across = value(v, "across") != 0, hexagonal = value(v, "hexagonal") != 0;
    const int voxels = static_cast<int>(value(v, "voxels"));
    const double found = array_permeability(solid, across, hexagonal, voxels);
    const double finer = array_permeability(solid, across, hexagonal, 2 * voxels);
    double expected = finer;    // where no series is at hand, a grid twice as fine
    if (!hexagonal && across) { // Sangani and Acrivos 1982, for thin rods
        const double c = solid;
        if (c <= 0.15) expected = (-std::log(c) - 1.476 + 2 * c - 1.774 * c * c + 4.076 * c * c * c) / (8 * pi);
    } else if (!hexagonal) { // Drummond and Tahir 1984
        const double c = solid;
        expected = (-std::log(c) - 1.476 + 2 * c - 0.5 * c * c - 0.0510 * std::pow(c, 4)) / (4 * pi);
    } else if (!across) {
        const double c = solid;
        expected = 0.5 * std::sqrt(3.0) * (-std::log(c) - 1.498 + 2 * c - 0.5 * c * c) / (4 * pi);
    }
    return {near_known("permeability", found, expected, 1.5 / voxels)};
}

/// A film on an incline across the grid's cubes, a wall under it and air over it, whose face is steps. It runs along the picks, whose
/// period goes so many voxels up. By mobility, as rooms that hold air are computed.
std::vector<VerifyResult> stokes_film(const VerifyValues& v, Backend&)
{
    const double rise = value(v, "rise"), run = value(v, "run"), height = value(v, "voxels"), slant = std::hypot(rise, run);
    const int periods = static_cast<int>(std::ceil(4 / run)); // of a few voxels at least
    DrawnLayer layer;
    layer.per_end = periods * static_cast<int>(run);
    layer.per_pick = static_cast<int>(std::ceil((height + 2 * margin) * slant / run)) + 1;
    layer.dx = layer.dy = layer.dz = 1;
    layer.grid = {layer.per_end, layer.per_pick, 2, true, false, periods * static_cast<int>(rise) % layer.per_pick};
    layer.reach = 2 * height;
    layer.outside.resize(layer.grid.size());
    std::vector<std::uint8_t> air(layer.grid.size());
    for (int z = 0; z < 2; ++z)
        for (int y = 0; y < layer.grid.ny; ++y)
            for (int x = 0; x < layer.grid.nx; ++x) {
                const double up = y + 0.5 - rise / run * (x + 0.5),
                             above = (up - layer.grid.ny * std::floor(up / layer.grid.ny)) * run / slant;
                const double next = layer.grid.ny * run / slant; // to the wall of the film above
                const std::size_t i = layer.grid.at(x, y, z);
                layer.outside[i] = static_cast<float>(std::min(above - margin, next - above));
                air[i] = above - margin > height;
            }
    // Along the film the gradient is the period's over the longer way.
    const double flow = room_permeability(layer, 0, air).weft.mean * layer.grid.ny * slant / run;
    return {near_known("permeability_ratio", flow / (std::pow(height, 3) / 3), 1, 1 / height)};
}

/// Air comes between two rods from both sides by discs of the meniscus' radius, which at the nearest meet a rod's skin at the contact
/// angle. Expected: the balance of forces.
std::vector<VerifyResult> rod_morphology(const VerifyValues& v, Backend&)
{
    const double radius = metre_from_um(value(v, "radius_um")), half_gap = metre_from_um(value(v, "half_gap_um")),
                 side = metre_from_um(value(v, "voxel_um")), angle = radian_from_degree(value(v, "contact_angle_deg"));
    const double tension = water_surface_tension(pore_temperature), meniscus = tension / value(v, "pressure_pa");
    const RodColumn column = rod_column(radius, half_gap, angle, tension, value(v, "pressure_pa"));
    if (!(column.area > 0)) throw Error("half_gap_um: At this suction no water stands between the rods. Take a smaller gap.");
    const double wide = 2 * (radius + half_gap) / side, high = 2 * (radius + 2 * meniscus) / side;
    if (4 * side > half_gap) throw Error("voxel_um: Must be a quarter of half_gap_um at most.");
    constexpr double most = 2000; // voxels along a side
    if (wide > most || high > most) throw Error(fmt::format("voxel_um: Takes more than {:g} voxels along a side. Take larger ones.", most));
    VoxelGrid grid;
    grid.nx = static_cast<int>(std::ceil(wide));
    grid.ny = static_cast<int>(std::ceil(high));
    const double keeps_off = std::sqrt(radius * radius + meniscus * meniscus + 2 * radius * meniscus * std::cos(angle)) - radius;
    std::vector<std::uint8_t> liquid(grid.size()), middles(grid.size());
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x) {
            const double across = std::abs(x + 0.5 - 0.5 * grid.nx) * side, along = (y + 0.5 - 0.5 * grid.ny) * side;
            const double outside = std::hypot(radius + half_gap - across, along) - radius;
            liquid[grid.at(x, y, 0)] = outside > 0;
            middles[grid.at(x, y, 0)] = outside >= keeps_off - 0.5 * side; // whose voxel reaches there
        }
    const std::vector<int> to_middle = squared_distances(grid, middles);
    double voxels = 0;
    for (std::size_t i = 0; i < liquid.size(); ++i) voxels += liquid[i] && to_middle[i] * side * side > meniscus * meniscus ? 1 : 0;
    const double um2 = 1e12;
    return {near_known("area_um2", voxels * side * side * um2, column.area * um2, 0.01 + 0.5 * side / (half_gap + 0.1 * radius))};
}

/// A row of parallel rods, all alike. Water stands between each two; with that water least energy must give the suction back.
std::vector<VerifyResult> rod_menisci(const VerifyValues& v, Backend&)
{
    const double radius = metre_from_um(value(v, "radius_um")), half_gap = metre_from_um(value(v, "half_gap_um")),
                 angle = radian_from_degree(value(v, "contact_angle_deg")), suction = value(v, "pressure_pa");
    const double tension = water_surface_tension(pore_temperature);
    const RodColumn column = rod_column(radius, half_gap, angle, tension, suction);
    if (!(column.area > 0)) throw Error("half_gap_um: At this suction no water stands between the rods. Take a smaller gap.");
    const int per_rod = static_cast<int>(value(v, "voxels"));
    DrawnLayer layer;
    layer.per_end = per_rod;
    layer.per_pick = 2;
    layer.dx = layer.dy = layer.dz = 2 * (radius + half_gap) / per_rod;
    const int layers = 2 * static_cast<int>(std::ceil(radius / layer.dz));
    layer.margin = per_rod / 2;
    layer.grid = {per_rod, layer.per_pick, layers + 2 * layer.margin, true, false};
    layer.reach = radius;
    layer.nearest_is_warp.assign(layer.grid.size(), 1);
    double room = 0; // m2 of a section
    for (int z = 0; z < layer.grid.nz; ++z)
        for (int i = 0; i < layer.grid.nx * layer.grid.ny; ++i) {
            const double across = (i % per_rod + 0.5 - 0.5 * per_rod) * layer.dx, up = (z + 0.5 - 0.5 * layer.grid.nz) * layer.dz;
            layer.outside.push_back(static_cast<float>(std::min(layer.reach, std::hypot(across, up) - radius)));
            if (z >= layer.first() && z <= layer.last())
                room += layer.dx * layer.dz / layer.per_pick *
                        std::clamp(0.5 + static_cast<double>(layer.outside.back()) / layer.side(), 0.0, 1.0);
        }
    RestingLiquid liquid(layer, 0, std::cos(angle));
    constexpr int stages = 8; // on the way down from full
    for (int stage = 1; stage <= stages; ++stage) liquid.hold(1 - (1 - column.area / room) * stage / stages);
    const double gap_in_blurs = half_gap / (2 * layer.dx); // energies are blurred over about two voxels
    return {near_known("pressure_pa", tension * liquid.curvature(), suction, 0.05 + 0.1 * std::min(1.0, 2 / gap_in_blurs))};
}

std::vector<VerifyResult> room(const VerifyValues& v, Backend&)
{
    const Fabric& fabric = library_fabric(v.at("fabric").word);
    const int voxels = static_cast<int>(value(v, "voxels_per_pitch"));
    Experiment experiment = standard_experiment(ExperimentType::horizontal_wicking);
    experiment.closure = Closure::pores;
    const Design design = design_of(fabric, experiment);
    const Textile textile =
        textile_of_run(design, design.fabrics[0], design.experiments[0], {0, 0, fabric.weave.ends(), fabric.weave.picks()});
    const LiquidInPores liquid{water_surface_tension(pore_temperature), water_viscosity(pore_temperature)};
    struct Found {
        double warp, weft, filling, half;
    };
    const auto found_at = [&](int n) {
        const auto tables = find_room_tables(textile, n);
        if (tables.types.empty()) throw Error("fabric: Must have at most 16 pairs of yarns that cross; it has more.");
        const BetweenParameters between = room_of_crossing(textile, 0, 0, liquid, tables);
        return Found{tables.types[0].along_warp, tables.types[0].along_weft, suction_filling(between.retention[both_wet], 0.5),
                     suction_emptying(between.retention[both_wet], 0.5)};
    };
    const Found found = found_at(voxels), finer = found_at(std::min(64, voxels * 3 / 2));
    const auto tables = find_room_tables(textile, voxels);
    const double drawn_void = share_outside(drawn_layer(textile, voxels * 3 / 2), tables.growth);
    const BetweenParameters between = room_of_crossing(textile, 0, 0, liquid, tables);
    const double layer = textile.thickness * textile.warp.pitch * textile.weft.pitch;
    const YarnType &warp = textile.warp.types[0], &weft = textile.weft.types[0];
    const double yarns =
        warp.area * warp.length_per_pitch[0] * textile.weft.pitch + weft.area * weft.length_per_pitch[0] * textile.warp.pitch;
    const auto near = [](const char* name, double computed, double expected) {
        return VerifyResult{name, computed, expected, 0.1 * std::abs(expected) + 1e-15};
    };
    const double pull = 0.15 * liquid.surface_tension * textile.warp.pitch * textile.weft.pitch / between.volume; // part of a face's
    return {{"void", drawn_void, std::max(least_share_of_room, 1 - yarns / layer), 0.01},
            near("permeability_warp_m2", found.warp, finer.warp),
            near("permeability_weft_m2", found.weft, finer.weft),
            {"filling_suction_pa", found.filling, finer.filling, pull},
            {"half_suction_pa", found.half, finer.half, pull}};
}

} // namespace

std::vector<VerifyCase> room_cases()
{
    const auto voxels = [](double usual) { return VerifyParameter{"voxels", usual, 4, 64, ""}; };
    return {
        {"stokes_slot", "Stokes flow in voxels between two plates, over that of the formula.", {voxels(10.4)}, stokes_slot},
        {"stokes_duct",
         "The same in a rectangular duct: flow over height^4.",
         {{"width_over_height", 1, 1, 4, ""}, voxels(16)},
         stokes_duct},
        {"stokes_ellipse",
         "The same in an elliptic tube: flow over the first half axis^4, which has as many voxels.",
         {{"axes_ratio", 0.5, 0.25, 1, ""}, voxels(20)},
         stokes_ellipse},
        {"stokes_triangle", "The same in a tube with three equal sides: flow over side^4.", {voxels(32)}, stokes_triangle},
        {"stokes_array",
         "The same along parallel rods or across them, in a square array or a hexagonal one: permeability over side^2 of its cell.",
         {{"solid_share", 0.3, 0.05, 0.6, ""}, on_or_off("across", true), on_or_off("hexagonal", false), whole_number("voxels", 40, 8, 80)},
         stokes_array},
        {"stokes_film",
         "A film of liquid on an incline through the cubes, by the mobility that rooms use; its free face is steps: flow over that of the "
         "formula.",
         {whole_number("rise", 1, 0, 4), whole_number("run", 2, 1, 4), voxels(20)},
         stokes_film},
        {"rod_morphology",
         "Water between two rods, as far as balls of air do not come, in voxels: its cross-section against the balance of forces.",
         {{"radius_um", 100, 1, 1e4, ""},
          {"half_gap_um", 30, 0.1, 1e4, ""},
          {"contact_angle_deg", 0, 0, 80, ""},
          {"pressure_pa", 1000, 1, 1e6, ""},
          {"voxel_um", 1, 0.01, 1e3, ""}},
         rod_morphology},
        {"rod_menisci",
         "Water between the rods of a row, at rest by least energy of its surfaces, in voxels: its suction against the balance of forces.",
         {{"radius_um", 100, 1, 1e4, ""},
          {"half_gap_um", 30, 0.1, 1e4, ""},
          {"contact_angle_deg", 30, 0, 80, ""},
          {"pressure_pa", 1000, 1, 1e6, ""},
          whole_number("voxels", 48, 24, 200)},
         rod_menisci},
        {"room",
         "The room between a fabric's yarns as it is drawn, against the same in voxels two thirds as large.",
         {{"fabric", 0, 0, 0, "Textile F"}, whole_number("voxels_per_pitch", 16, 8, 32)},
         room}};
}

} // namespace hygroloom
