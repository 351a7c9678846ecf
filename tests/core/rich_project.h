// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A project with every optional thing in it, for tests of its file.
#pragma once

#include "core/base/error.h"
#include "core/project/project_file.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace hygroloom {

inline const std::string examples = std::string(HYGROLOOM_SOURCE_DIR) + "/resources/examples/";

inline std::string bytes_of(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

template <typename Act> std::string message_of(Act act)
{
    try {
        act();
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

inline bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A drawn one and one from a file, cut from two fabrics.
inline std::vector<Garment> rich_garments(const std::string& one, const std::string& other)
{
    Garment tee;
    tee.name = "tee \"β\"";
    tee.built_in = {"tee", 1010.5, 690, 1.0 / 3.0, 210};
    tee.panels = {{"front", {one, 12.5, true}}, {"*", {other, 0, false}}};
    tee.seams = {{"default", 0.5}, {"front|back", 0}};
    tee.wearer = {33.5, {{"default", 2.5}, {"upper arm", 0.1 + 0.2}}, "taylor-2013 rest", {}};
    Garment leggings = tee;
    leggings.name = "leggings";
    leggings.source = "worn/leggings.glb";
    leggings.built_in = {};
    leggings.uv_unit = UvUnit::millimetre;
    return {tee, leggings};
}

/// Every optional thing in use.
inline Design rich()
{
    Design design = read_project(examples + "one-drop-on-cotton.hygro");
    Material own = *find_library_material("cotton");
    own.name = "my cotton \"β\"";
    own.based_on = "cotton";
    own.contact_angle_deg = 31.25;
    own.receding_angle_deg = 12.5;
    own.cross_section = cross_sections().at(1);
    own.diffusion.two_stage = true;
    Material free = *find_library_material("polyester");
    free.name = "free";
    free.density_kg_m3 = 1401.0 / 3.0;
    free.heat_of_wetting_j_g = 12.5;
    free.cross_section = {1.375, {}};
    design.materials = {own, free};
    Fabric fabric = design.fabrics[0];
    fabric.name = "satin";
    fabric.warp.material = {{own.name, 0.1 + 0.2}, {"free", 0.7}};
    fabric.warp.core = YarnCore{own.name, 0.1 + 0.02};
    fabric.warp.linear_density_tex = 24.3;
    fabric.warp.packing_factor = 0.1 + 0.7;
    fabric.weft.twist_direction = TwistDirection::s;
    fabric.weave = weave_from_pattern("satin 5/2").toggled(1, 0);
    fabric.contact_angle_deg = 1e-7;
    fabric.calibrated = Calibrated{"strip \"β\".csv", "strip", "draft", "wick_height_mm", 0.1 + 0.2, {35.5, {}, 1.0 / 3.0}};
    fabric.finish_face = 110.5;
    fabric.finish_back = 0;
    fabric.finish_depth = 0.125;
    fabric.finish_holes = 0.1 + 0.2;
    fabric.weft.irregularity_cv = 0.125;
    fabric.weft.filament_count = 96;
    fabric.weft.yarn_class = YarnClass::textured;
    fabric.measured = {0.8, 160.0, 1.3, 6.0};
    fabric.thickness_mm.reset();
    design.fabrics.push_back(fabric);
    design.experiments[0].droplets.resize(3);
    design.liquids.push_back({"dye bath", 45.5, 1.2, 1010});
    for (int type = 1; type < experiment_types; ++type) {
        Experiment experiment = standard_experiment(static_cast<ExperimentType>(type));
        experiment.name = name_of(experiment.type);
        experiment.liquid = "dye bath";
        experiment.closure = static_cast<Closure>(type % closures);
        experiment.swelling = type % 2 == 0;
        if (type % 2) experiment.climates = {{60, {30, 0.8, 0.5}}, {90.5, {30, 0.4, 0.5}}};
        design.experiments.push_back(experiment);
    }
    design.garments = rich_garments("satin", design.fabrics[0].name);
    design.experiments[1].volume_ul = 150.5;
    design.experiments[1].feed_s = 10;
    design.experiments[1].drop_ul = 7.5;
    design.experiments[2].along_weft = true;
    design.experiments[2].immersion_mm = 3;
    design.experiments[3].volume_ul = 1234;
    design.experiments[4].initial_water_g_m2 = 55;
    design.experiments[5].initial = {35, 0.2, 0};
    design.experiments[6].rate_g_m2_h = 650;
    design.experiments[6].from_top = true;
    return design;
}

} // namespace hygroloom
