// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "tests/support/random_design.h"

#include "core/design/validate.h"
#include "core/design/yarn_sections.h"

namespace hygroloom {
namespace {

Yarn random_yarn(Dice& dice)
{
    Yarn yarn;
    std::vector<std::string> names;
    for (const Material& material : material_library()) names.push_back(material.name);
    yarn.material = {{dice.one_of(names), 1.0}};
    if (dice.chance(0.3)) {
        const double share = dice.by_decades(1e-3, 0.5);
        const std::string other = dice.one_of(names);
        if (other != yarn.material[0].name) yarn.material = {{yarn.material[0].name, 1 - share}, {other, share}};
    }
    yarn.diameter_mm = dice.by_decades(0.05, 1.5);
    yarn.packing_factor =
        dice.chance(0.3) ? dice.one_of<double>({loosest_packing, densest_packing}) : dice.between(loosest_packing, densest_packing);
    yarn.fibres_per_yarn = dice.one_of<int>({1, 2, 30, 500});
    yarn.twist_per_m = dice.one_of<double>({0, 700, 2000});
    yarn.irregularity_cv = dice.one_of<double>({0, 0, 0.2, 0.4});
    return yarn;
}

Climate random_climate(Dice& dice)
{
    Climate climate;
    climate.temperature_c = dice.chance(0.4) ? dice.one_of<double>({-10, 0, 20, 60}) : dice.between(-10, 60);
    climate.relative_humidity = dice.chance(0.5) ? dice.one_of<double>({0, 0.65, 1, 1.2, most_humidity}) : dice.share();
    climate.air_speed_m_s = dice.one_of<double>({0, 0.1, 1, 20});
    return climate;
}

void add_droplets(Dice& dice, Experiment& experiment)
{
    experiment.droplets.clear();
    const int count = dice.chance(0.1) ? 0 : dice.one_of<int>({1, 1, 1, 3});
    for (int i = 0; i < count; ++i) {
        Droplet drop;
        drop.volume_ul = dice.chance(0.25) ? dice.one_of<double>({1e-6, 5000}) : dice.by_decades(1e-3, 50);
        drop.time_s = i * 0.2 * std::min(longest_of_most, experiment.duration_s);
        drop.height_mm = drop.volume_ul < 1e-3 ? 0.0 : dice.one_of<double>({0, 2, 20}); // the smallest would fall a million steps long
        drop.speed_m_s = dice.one_of<double>({0, 0, 0, 1, fastest_droplet_m_s});
        for (std::size_t axis = 0; axis < 2; ++axis)
            drop.at_mm[axis] = dice.chance(0.8) ? 0.0 : 0.5 * experiment.sample_mm[axis] * dice.between(-1, 1);
        experiment.droplets.push_back(drop);
    }
}

/// Of one in four: fibres as thin or thick, and as quick or slow to take up water, as there may be.
void change_fibres(int index, Design& design)
{
    Dice dice(index + 2000000); // of their own
    if (!dice.chance(0.25)) return;
    Material own = *find_library_material(dice.one_of<std::string>({"cotton", "wool", "polyester"}));
    own.based_on = own.name;
    own.name = "own";
    own.fibre_radius_um = dice.one_of<double>({0.001, 0.001, 8, 200});
    own.diffusion.constant_m2_s = dice.one_of<double>({1e-30, 1e-20, 1e-9});
    design.materials = {own};
    for (Yarn* yarn : {&design.fabrics[0].warp, &design.fabrics[0].weft}) yarn->material = {{"own", 1.0}};
}

/// Other fibres, and of one in two: another weave, plied yarns of filaments with a core, hairs, both faces finished, yarns that touch, odd
/// receding angles.
void change_cloth(int index, Design& design)
{
    change_fibres(index, design);
    Dice dice(index + 3000000); // of their own
    if (!dice.chance(0.5)) return;
    Fabric& fabric = design.fabrics[0];
    fabric.weave = weave_from_pattern(dice.one_of<std::string>({"plain", "twill 2/1 Z", "satin 5/2", "basket 2/2"}));
    for (Yarn* yarn : {&fabric.warp, &fabric.weft}) {
        yarn->plies = dice.one_of<int>({1, 2, most_plies});
        yarn->fibres_per_yarn = std::max(yarn->fibres_per_yarn, yarn->plies);
        yarn->ply_twist_per_m = dice.one_of<double>({0, 400, 2000});
        if (dice.chance(0.3)) yarn->filament_count = dice.one_of<int>({fewest_filaments, 48, 5000});
        if (dice.chance(0.2)) yarn->core = YarnCore{"elastane", dice.one_of<double>({least_core_share, most_core_share})};
    }
    fabric.flyaway = {dice.one_of<double>({0, 6, 1000}), dice.one_of<double>({0, 10, 1000}), dice.one_of<double>({0, 0.1, 20}),
                      dice.one_of<double>({0, 0.4, 50})};
    if (dice.chance(0.3)) fabric.ends_per_cm = 10 / *fabric.warp.diameter_mm * dice.one_of<double>({0.98, 1, 1.02});
    if (dice.chance(0.3)) fabric.finish_back = dice.one_of<double>({0, 62.7, 85, 89.9, 180});
    if (dice.chance(0.3)) fabric.contact_angle_deg = dice.one_of<double>({30, 62.7, 76.4, 84.9, 85, 85.1});
    for (Material& own : design.materials) {
        own.contact_angle_deg = dice.one_of<double>({0, 35, 85});
        own.receding_angle_deg = dice.one_of<double>({0, own.contact_angle_deg});
        own.cross_section = dice.one_of(cross_sections());
    }
    if (dice.chance(0.5)) fabric.finish_depth = dice.one_of<double>({0, 0.05, 0.33, 0.5, 1});
    if (dice.chance(0.3)) fabric.finish_holes = dice.one_of<double>({0, 0.02, 1});
}

} // namespace

Design random_design(int index, double& simulated)
{
    Dice dice(index);
    Design design;
    Fabric fabric;
    fabric.name = "cloth";
    fabric.warp = random_yarn(dice);
    fabric.weft = dice.chance(0.5) ? fabric.warp : random_yarn(dice);
    // From far apart to squeezed, so that porosity comes near both its ends.
    fabric.ends_per_cm = std::clamp(10 / *fabric.warp.diameter_mm * dice.by_decades(0.05, 2), 0.5, 500.0);
    fabric.picks_per_cm = std::clamp(10 / *fabric.weft.diameter_mm * dice.by_decades(0.05, 2), 0.5, 500.0);
    if (dice.chance(0.7)) fabric.contact_angle_deg = dice.one_of<double>({0, 1e-6, 60, 89.9, 90, 90.1, 120, 180});
    if (dice.chance(0.2)) fabric.finish_face = dice.one_of<double>({0, 60, 89.9, 120, 180});
    if (dice.chance(0.2)) {
        fabric.extra_yarns = {random_yarn(dice)};
        fabric.weft_order = {{0, 2}, {1, 1}};
    }
    design.fabrics.push_back(fabric);
    if (dice.chance(0.2)) design.liquids.push_back({"own", dice.by_decades(1, 500), dice.by_decades(0.05, 1000), dice.between(500, 2000)});

    // Free liquid costs most: one in ten.
    Experiment experiment = standard_experiment(static_cast<ExperimentType>(index % 10 == 0 ? 0 : 1 + index % (experiment_types - 1)));
    experiment.name = "test";
    experiment.climate = random_climate(dice);
    const bool whole = experiment.type != ExperimentType::droplet && dice.chance(0.1);
    experiment.duration_s = dice.chance(0.2) ? dice.one_of<double>({1e-6, 86400}) : dice.by_decades(0.1, 3600);
    simulated = whole ? experiment.duration_s : std::min(longest_of_most, experiment.duration_s);
    // Some threads each way, or a single yarn.
    const double threads = dice.by_decades(1, 25);
    experiment.sample_mm = {std::clamp(10 * threads / fabric.ends_per_cm, 0.1, 2000.0),
                            std::clamp(10 * dice.by_decades(1, 25) / fabric.picks_per_cm, 0.1, 2000.0)};
    if (dice.chance(0.4)) { // 0 to 100 % and back, and other changes
        const double when = simulated * dice.by_decades(1e-3, 0.3);
        Climate moist = random_climate(dice), dry = random_climate(dice);
        if (dice.chance(0.5)) {
            experiment.climate.relative_humidity = dry.relative_humidity = 0;
            moist.relative_humidity = 1;
        }
        experiment.climates = {{when, moist}, {2 * when, moist}, {2 * when + 1e-6 * dice.by_decades(1, 1e5), dry}};
    }
    if (!design.liquids.empty())
        experiment.liquid = "own";
    else
        experiment.liquid = dice.one_of<std::string>({"water", "saline", "sweat"});
    experiment.closure = dice.one_of<Closure>({Closure::pores, Closure::pores, Closure::paper});
    experiment.swelling = dice.chance(0.3);
    if (experiment.type == ExperimentType::droplet) add_droplets(dice, experiment);
    experiment.volume_ul = dice.by_decades(1e-3, 1e4);
    experiment.feed_s = dice.by_decades(0.01, 10);
    experiment.drop_ul = dice.one_of<double>({0, 25, 1000});
    experiment.along_weft = dice.chance(0.5);
    experiment.immersion_mm = experiment.sample_mm[1] * dice.between(0.01, 0.99);
    experiment.initial_water_g_m2 = dice.one_of<double>({0, 1, 100, 1000, 1e5});
    experiment.initial = random_climate(dice);
    experiment.rate_g_m2_h = dice.one_of<double>({0, 10, 1000, 1e5});
    experiment.from_top = dice.chance(0.5);
    design.experiments.push_back(experiment);
    change_cloth(index, design);
    return design;
}

} // namespace hygroloom
