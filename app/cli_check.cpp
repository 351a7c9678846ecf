// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// check: issues of a project, and the calculated properties of its fabrics beside those a laboratory measured.
#include "app/cli.h"
#include "app/cli_room.h"
#include "app/cli_weave.h"

#include "core/analysis/card.h"
#include "core/base/units.h"
#include "core/base/words.h"
#include "core/design/validate.h"
#include "core/design/yarn_class.h"
#include "core/garment/check_garment.h"
#include "core/geometry/measured_geometry.h"
#include "core/project/project_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <iterator>
#include <optional>

namespace hygroloom {
namespace {

using Json = nlohmann::ordered_json;

/// assumed: names of the values that neither the yarn nor a count says.
Json yarn_json(const YarnQuantities& yarn)
{
    Json assumed = Json::array();
    if (yarn.class_assumed) assumed.push_back("yarn_class");
    if (yarn.packing_assumed) assumed.push_back("packing_factor");
    if (yarn.class_assumed) assumed.push_back("shape");
    return {{"linear_density_tex", yarn.linear_density_tex},
            {"count_ne", ne_from_tex(yarn.linear_density_tex)},
            {"diameter_mm", yarn.diameter_mm},
            {"packing_factor", yarn.packing_factor},
            {"section_width_mm", yarn.section_mm.width},
            {"section_height_mm", yarn.section_mm.height},
            {"packing_factor_in_fabric", yarn.packing_factor_in_fabric},
            {"pitch_mm", yarn.pitch_mm},
            {"crimp_percent", yarn.crimp_percent},
            {"cover", yarn.cover},
            {"pore_radius_um", yarn.pore_radius_um},
            {"contact_angle_deg", yarn.contact_angle_deg},
            {"receding_angle_deg", yarn.receding_angle_deg},
            {"helix_tortuosity", yarn.helix_tortuosity},
            {"flattened", yarn.flattened},
            {"yarn_class", info_of(yarn.yarn_class).name},
            {"shape", yarn.shape},
            {"assumed", assumed}};
}

Json stripes_json(const std::vector<StripeYarn>& stripes)
{
    Json list = Json::array();
    for (std::size_t i = 0; i < stripes.size(); ++i) {
        const StripeYarn& stripe = stripes[i];
        list.push_back({{"extra_yarn", i + 1},
                        {"linear_density_tex", stripe.free.linear_density_tex},
                        {"count_ne", ne_from_tex(stripe.free.linear_density_tex)},
                        {"diameter_mm", stripe.free.diameter},
                        {"packing_factor", stripe.free.packing_factor},
                        {"contact_angle_deg", stripe.contact_angle_deg}});
        if (stripe.as_end) list.back()["warp"] = yarn_json(*stripe.as_end);
        if (stripe.as_pick) list.back()["weft"] = yarn_json(*stripe.as_pick);
    }
    return list;
}

Json pores_json(const PoreRadii& radii)
{
    return {{"tenth", radii.tenth_um}, {"median", radii.median_um}, {"nine_tenths", radii.nine_tenths_um}, {"mean", radii.mean_um}};
}

Json permeability_json(const Permeability& k)
{
    return {{"through", k.through}, {"along_warp", k.along_warp}, {"along_weft", k.along_weft}};
}

Json geometry_json(const MeasuredGeometry& m)
{
    const auto yarn = [](const MeasuredYarn& y) {
        return Json{{"crimp_percent", y.crimp_percent},
                    {"cover", y.cover},
                    {"braiding_angle_deg", y.braiding_angle_deg},
                    {"pore_radius_um", pores_json(y.pores)}};
    };
    return {{"ends", m.ends},
            {"picks", m.picks},
            {"warp", yarn(m.warp)},
            {"weft", yarn(m.weft)},
            {"cover_factor", m.cover_factor},
            {"areal_density_g_m2", m.areal_density_g_m2},
            {"yarn_layer_thickness_mm", m.yarn_layer_thickness_mm},
            {"thickness_mm", m.thickness_mm},
            {"porosity", m.porosity},
            {"fibre_volume_fraction", m.fibre_volume_fraction},
            {"smoothness", m.smoothness},
            {"inter_yarn_pore_radius_um", pores_json(m.holes)},
            {"permeability_m2", permeability_json(m.permeability)}};
}

/// Permeability and braiding angle by formula, beside those of the geometry.
struct Formulas {
    Permeability permeability;
    double warp_angle = 0, weft_angle = 0;
};

Formulas formulas_of(const FabricQuantities& q)
{
    Formulas f;
    f.permeability = permeability_of(q);
    f.warp_angle = braiding_angle_deg(q.weft.pitch_mm, q.warp.rise_mm);
    f.weft_angle = braiding_angle_deg(q.warp.pitch_mm, q.weft.rise_mm);
    return f;
}

Json fabric_json(const Fabric& fabric, const FittedFabric& fitted)
{
    const FabricQuantities& q = fitted.derived;
    const std::vector<StripeYarn>& stripes = fitted.stripes;
    Json measured = Json::object();
    const auto add = [&](const char* key, const std::optional<double>& value) {
        if (value) measured[key] = *value;
    };
    add("thickness_mm", fabric.thickness_mm);
    add("porosity", fabric.measured.porosity);
    add("areal_density_g_m2", fabric.measured.areal_density_g_m2);
    add("tortuosity", fabric.measured.tortuosity);
    add("crimp_percent", fabric.measured.crimp_percent);
    return {{"name", fabric.name},
            {"derived",
             {{"warp", yarn_json(q.warp)},
              {"weft", yarn_json(q.weft)},
              {"cover_factor", q.cover_factor},
              {"areal_density_g_m2", q.areal_density_g_m2},
              {"yarn_layer_thickness_mm", q.yarn_layer_thickness_mm},
              {"thickness_mm", q.thickness_mm},
              {"porosity", q.porosity},
              {"rough_porosity", q.rough_porosity},
              {"fibre_volume_fraction", q.fibre_volume_fraction},
              {"gap_warp_mm", q.gap_warp_mm},
              {"gap_weft_mm", q.gap_weft_mm},
              {"inter_yarn_pore_radius_um", q.inter_yarn_pore_radius_um},
              {"smoothness", q.smoothness},
              {"jammed", q.jammed},
              {"extra_yarns", stripes_json(stripes)}}},
            {"yarn_class", {{"warp", info_of(q.warp.yarn_class).name}, {"weft", info_of(q.weft.yarn_class).name}}},
            {"thickness_mm_1kpa", q.thickness_1kpa_mm},
            {"laboratory", laboratory_json(quick_numbers(fitted))},
            {"measured", measured},
            {"notes", english(q.notes)}};
}

std::string text(double value) { return fmt::format("{:.4g}", value); }
std::string text(const std::optional<double>& value) { return value ? fmt::format("{:.4g}", *value) : std::string(); }

std::string range(const PoreRadii& radii) { return fmt::format("{:.3g}..{:.3g}", radii.tenth_um, radii.nine_tenths_um); }

/// The yarns of the stripes, below those of the fabric's own warp and weft.
void print_stripes(const std::vector<StripeYarn>& stripes)
{
    const auto row = [](const char* name, const std::string& warp, const std::string& weft, const char* unit) {
        print_result("  {:<26} {:>9} {:>9}   {:>9} {:>9} {}\n", name, warp, weft, "", "", unit);
    };
    for (std::size_t i = 0; i < stripes.size(); ++i) {
        const std::optional<YarnQuantities>&end = stripes[i].as_end, &pick = stripes[i].as_pick;
        const std::string name = fmt::format("yarn {} (extra yarn {})", letters_of(static_cast<int>(i) + 1), i + 1);
        if (!end && !pick) {
            print_result("  {}: used in neither order; {} tex, {} mm.\n", name, text(stripes[i].free.linear_density_tex),
                         text(stripes[i].free.diameter));
            continue;
        }
        const auto both = [&](const char* what, double YarnQuantities::*value, const char* unit) {
            row(what, end ? text((*end).*value) : "", pick ? text((*pick).*value) : "", unit);
        };
        const auto section = [&](const char* what, double Section::*side) {
            row(what, end ? text(end->section_mm.*side) : "", pick ? text(pick->section_mm.*side) : "", "mm");
        };
        row(name.c_str(), end ? "warp" : "", pick ? "weft" : "", "");
        both("linear density", &YarnQuantities::linear_density_tex, "tex");
        both("diameter, free", &YarnQuantities::diameter_mm, "mm");
        section("section, width", &Section::width);
        section("section, height", &Section::height);
        both("packing factor, free", &YarnQuantities::packing_factor, "");
        both("packing factor, in fabric", &YarnQuantities::packing_factor_in_fabric, "");
        both("crimp", &YarnQuantities::crimp_percent, "%");
        both("pore radius in yarn", &YarnQuantities::pore_radius_um, "um");
        both("contact angle", &YarnQuantities::contact_angle_deg, "deg");
        both("receding angle", &YarnQuantities::receding_angle_deg, "deg");
        both("tortuosity of the twist", &YarnQuantities::helix_tortuosity, "");
    }
}

void print_notes(const Fabric& fabric, const FabricQuantities& q, const std::optional<MeasuredGeometry>& geometry)
{
    if (fabric.measured != Measured{})
        print_result("  The cloth that is drawn and simulated uses the laboratory's values; the columns of formula and geometry do not.\n");
    if (geometry)
        print_result("  Geometry of {} ends and {} picks.\n", geometry->ends, geometry->picks);
    else
        print_result(
            "  Its geometry was not computed; check does so for the first dozen or so fabrics of a project. Add --fabric and its name.\n");
    if (geometry && geometry->flyaways_seen < 1 && geometry->thickness_mm > geometry->yarn_layer_thickness_mm)
        print_result("  Of its loops and hairs {} % were measured; the thickness by geometry may miss the highest.\n",
                     text(100 * geometry->flyaways_seen));
    for (const Message& note : q.notes) print_result("  {}\n", english(note));
}

/// Without a measured geometry its columns are empty.
void print_fabric(const Fabric& fabric, const FabricQuantities& q, const std::vector<StripeYarn>& stripes,
                  const std::optional<MeasuredGeometry>& geometry, const Formulas& f)
{
    const MeasuredGeometry m = geometry.value_or(MeasuredGeometry());
    const auto made = [&geometry](double value) { return geometry ? text(value) : std::string(); };
    const auto made_range = [&geometry](const PoreRadii& radii) { return geometry ? range(radii) : std::string(); };
    const auto row = [](const char* name, const std::string& warp, const std::string& weft, const std::string& warp_made,
                        const std::string& weft_made, const char* unit, const std::string& laboratory = {}) {
        print_result("  {:<26} {:>9} {:>9}   {:>9} {:>9} {:<5} {:>9}\n", name, warp, weft, warp_made, weft_made, unit, laboratory);
    };
    const YarnQuantities &a = q.warp, &b = q.weft;
    print_result("{}\n", fabric.name);
    print_result("  {:<26} {:>19}   {:>19} {:<5} {:>9}\n", "", "by formula", "by geometry", "", "laboratory");
    row("", "warp", "weft", "warp", "weft", "");
    row("linear density", text(a.linear_density_tex), text(b.linear_density_tex), "", "", "tex");
    row("cotton count", text(ne_from_tex(a.linear_density_tex)), text(ne_from_tex(b.linear_density_tex)), "", "", "Ne");
    row("diameter, free", text(a.diameter_mm), text(b.diameter_mm), "", "", "mm");
    row("section, width", text(a.section_mm.width), text(b.section_mm.width), "", "", "mm");
    row("section, height", text(a.section_mm.height), text(b.section_mm.height), "", "", "mm");
    row("kind", info_of(a.yarn_class).name, info_of(b.yarn_class).name, "", "", "");
    row("packing factor, free", text(a.packing_factor), text(b.packing_factor), "", "", "");
    row("packing factor, in fabric", text(a.packing_factor_in_fabric), text(b.packing_factor_in_fabric), "", "", "");
    row("crimp", text(a.crimp_percent), text(b.crimp_percent), made(m.warp.crimp_percent), made(m.weft.crimp_percent), "%",
        text(fabric.measured.crimp_percent));
    row("angle over a crossing", text(f.warp_angle), text(f.weft_angle), made(m.warp.braiding_angle_deg), made(m.weft.braiding_angle_deg),
        "deg");
    row("cover", text(a.cover), text(b.cover), made(m.warp.cover), made(m.weft.cover), "");
    row("gap between yarns", text(q.gap_warp_mm), text(q.gap_weft_mm), "", "", "mm");
    row("pore radius in yarn", text(a.pore_radius_um), text(b.pore_radius_um), made_range(m.warp.pores), made_range(m.weft.pores), "um");
    row("contact angle", text(a.contact_angle_deg), text(b.contact_angle_deg), "", "", "deg");
    row("receding angle", text(a.receding_angle_deg), text(b.receding_angle_deg), "", "", "deg");
    row("tortuosity of the twist", text(a.helix_tortuosity), text(b.helix_tortuosity), "", "", "", text(fabric.measured.tortuosity));
    row("pore radius between yarns", text(q.inter_yarn_pore_radius_um), "", made_range(m.holes), "", "um");
    row("cover factor", text(q.cover_factor), "", made(m.cover_factor), "", "");
    row("areal density", text(q.areal_density_g_m2), "", made(m.areal_density_g_m2), "", "g/m2", text(fabric.measured.areal_density_g_m2));
    row("thickness of the yarns", text(q.yarn_layer_thickness_mm), "", made(m.yarn_layer_thickness_mm), "", "mm");
    row("thickness at 1 kPa", text(q.thickness_1kpa_mm), "", "", "", "mm");
    row("thickness, as drawn", text(q.thickness_mm), "", made(m.thickness_mm), "", "mm", text(fabric.thickness_mm));
    row("share of air", text(q.porosity), "", made(m.porosity), "", "", text(fabric.measured.porosity));
    row("share of air less flyaways", text(q.rough_porosity), "", "", "", "");
    row("fibre volume fraction", text(q.fibre_volume_fraction), "", made(m.fibre_volume_fraction), "", "");
    row("smoothness", text(q.smoothness), "", made(m.smoothness), "", "");
    row("permeability, through", text(1e12 * f.permeability.through), "", made(1e12 * m.permeability.through), "", "um2");
    row("permeability, along", text(1e12 * f.permeability.along_warp), text(1e12 * f.permeability.along_weft),
        made(1e12 * m.permeability.along_warp), made(1e12 * m.permeability.along_weft), "um2");
    print_stripes(stripes);
    print_result(
        "  Angle over a crossing (braiding angle): between the two stretches of a yarn that meet over a crossed yarn; 180 deg is "
        "straight.\n"
        "  Cover: a yarn's width over the distance from yarn to yarn. Cover factor: the share of the area that yarns hide, seen from "
        "above.\n"
        "  Share of air (porosity): of the volume of the fabric as drawn, what is not fibre; less flyaways: without what loops and hairs "
        "take of the faces. Smoothness: 1 less the flyaways' share of the fabric's volume.\n");
    print_notes(fabric, q, geometry);
}

/// Each garment's panels and their areas; those that could be read.
void show_garments(const Design& design, const GarmentCheck& garments, bool as_json, Json& json)
{
    json["garments"] = Json::array();
    for (std::size_t i = 0; i < garments.patterns.size(); ++i) {
        if (!garments.patterns[i]) continue;
        const GarmentPattern& pattern = *garments.patterns[i];
        Json panels = Json::array();
        std::string listed;
        double area = 0;
        for (const PatternPanel& panel : pattern.panels) {
            area += area_of(panel);
            panels.push_back({{"name", panel.name}, {"area_m2", area_of(panel)}});
            listed += fmt::format("{}{} {:.3f}", listed.empty() ? "" : ", ", panel.name, area_of(panel));
        }
        json["garments"].push_back(
            {{"name", design.garments[i].name}, {"area_m2", area}, {"seams", pattern.seams.size()}, {"panels", std::move(panels)}});
        if (!as_json)
            print_result("Garment {}: {:.3f} m2 in {} panels, {} seams: {}\n", design.garments[i].name, area, pattern.panels.size(),
                         pattern.seams.size(), listed);
    }
}

/// Of all fabrics, after which no further geometry is measured, so that a check stays short: a dozen everyday fabrics, 0.7 s on one core.
constexpr double most_points_of_all = 2e7;

int check(const ProjectOptions& options)
{
    const Design design = load_project(options);
    const Validation validation = validate_and_fit(design);
    GarmentCheck garments = check_garments(design, std::filesystem::absolute(options.project).parent_path(), validation.issues);
    std::vector<Issue> issues = validation.issues;
    std::move(garments.issues.begin(), garments.issues.end(), std::back_inserter(issues));
    const bool is_sound = !has_error(validation.issues); // what garments' files hold changes no fabric
    std::optional<Place> chosen_place;
    if (!options.fabric.empty())
        chosen_place = Place("fabrics") / static_cast<std::size_t>(&chosen_fabric(design, options) - design.fabrics.data());

    constexpr const char* severities[] = {"note", "warning", "error"};
    Json json{{"format", "hygroloom-check"}, {"version", 1}, {"project", options.project}, {"valid", !has_error(issues)}};
    json["issues"] = Json::array();
    for (const Issue& issue : issues) {
        json["issues"].push_back({{"severity", severities[static_cast<int>(issue.severity)]},
                                  {"code", issue.code},
                                  {"where", issue.where.text()},
                                  {"text", issue.text()}});
        const bool of_another = issue.where.key(0) == "fabrics" && chosen_place && !issue.where.is_in(*chosen_place);
        const bool in_table = issue.code == "sections" && !options.json; // printed below the numbers
        if (of_another && issue.severity != Severity::error) continue;
        if (issue.severity != Severity::note || (!options.quiet && !in_table)) print_issue(options.project, issue);
    }
    if (design.fabrics.empty() && !options.json && !options.quiet)
        print_note("{}: The project has no fabric. hygroloom-cli presets lists fabrics to begin with.\n", options.project);
    json["fabrics"] = Json::array();
    double points = 0;
    for (std::size_t i = 0; i < design.fabrics.size() && is_sound; ++i) { // calculated from wrong values they would be wrong
        const Fabric& fabric = design.fabrics[i];
        if (!options.fabric.empty() && fabric.name != options.fabric) continue;
        const FittedFabric& fitted = *validation.fabrics[i];
        const FabricQuantities& quantities = fitted.derived;
        const std::vector<StripeYarn>& stripes = fitted.stripes;
        std::optional<MeasuredGeometry> geometry;
        if (points < most_points_of_all) geometry = measure_geometry(design, fabric, &fitted);
        points += geometry ? geometry->points : 0;
        const Formulas formulas = formulas_of(quantities);
        json["fabrics"].push_back(fabric_json(fabric, fitted));
        Json& entry = json["fabrics"].back();
        entry["derived"]["warp"]["braiding_angle_deg"] = formulas.warp_angle;
        entry["derived"]["weft"]["braiding_angle_deg"] = formulas.weft_angle;
        entry["derived"]["permeability_m2"] = permeability_json(formulas.permeability);
        entry["geometry"] = geometry ? geometry_json(*geometry) : Json();
        add_weave_json(json["fabrics"].back(), fabric, fitted.yarns);
        if (options.json) {
            add_room_json(json["fabrics"].back(), fabric, fitted);
            continue;
        }
        print_fabric(fabric, quantities, stripes, geometry, formulas);
        print_weave(fabric, fitted.yarns);
        print_room(fabric, fitted);
    }
    show_garments(design, garments, options.json, json);
    if (options.json) print_json(json);
    return has_error(issues) ? exit_invalid : exit_ok;
}

} // namespace

void add_check(CLI::App& app, Verb& verb)
{
    auto options = std::make_shared<ProjectOptions>();
    CLI::App& check_verb = *app.add_subcommand("check", "Check a project; print the properties calculated for its fabrics");
    check_verb.footer("Example: hygroloom-cli check cloth.hygro --json");
    add_project_options(check_verb, *options, false);
    check_verb.callback([&verb, options] { verb = [options] { return check(*options); }; });
}

} // namespace hygroloom
