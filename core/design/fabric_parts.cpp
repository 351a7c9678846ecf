// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/fabric_parts.h"

#include "core/design/yarn_class.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace hygroloom {
namespace {

constexpr const char* contact_angle_title = "contact angle";

std::string words(double value, const char* unit, const NumberText& number)
{
    return number ? number(value, unit) : fmt::format("{:.4g}{}", value, unit);
}
std::string words(int value, const char* unit, const NumberText&) { return fmt::format("{}{}", value, unit); }
std::string words(TwistDirection value, const char*, const NumberText&) { return value == TwistDirection::s ? "S" : "Z"; }
std::string words(YarnClass value, const char*, const NumberText&) { return info_of(value).title; }
std::string words(const std::string& value, const char*, const NumberText&) { return value; }

std::string words(const Color& value, const char*, const NumberText&)
{
    return fmt::format("#{:02x}{:02x}{:02x}", value.red, value.green, value.blue);
}

template <typename Value> std::string words(const std::optional<Value>& value, const char* unit, const NumberText& number)
{
    return value ? words(*value, unit, number) : "not given";
}

std::string words(const std::vector<MaterialShare>& shares, const char*, const NumberText&)
{
    std::string text;
    for (const MaterialShare& part : shares)
        text += (text.empty() ? "" : ", ") + (shares.size() == 1 ? "" : fmt::format("{:.3g} % ", 100 * part.share)) + part.name;
    return text;
}

std::string words(const std::optional<YarnCore>& core, const char*, const NumberText&)
{
    return core ? fmt::format("{:.3g} % {}", 100 * core->share, core->material) : "none";
}

std::string words(const Weave& weave, const char*, const NumberText&)
{
    if (!weave.pattern().empty()) return weave.pattern();
    return fmt::format("a repeat of {} x {}", weave.ends(), weave.picks());
}

std::string words(const std::vector<Yarn>& yarns, const char*, const NumberText& number)
{
    std::string text;
    for (const Yarn& yarn : yarns) {
        text += (text.empty() ? "" : "; ") + words(yarn.material, "", number);
        if (yarn.core) text += ", core of " + words(yarn.core, "", number);
        if (yarn.diameter_mm) text += ", " + words(yarn.diameter_mm, " mm", number);
        if (yarn.linear_density_tex) text += ", " + words(yarn.linear_density_tex, " tex", number);
        if (yarn.packing_factor) text += ", packing " + words(yarn.packing_factor, "", number);
        if (yarn.yarn_class) text += ", " + words(yarn.yarn_class, "", number);
        if (yarn.filament_count) text += ", " + words(yarn.filament_count, " filaments", number);
        text += fmt::format(", {:.4g} turns/m", yarn.twist_per_m);
        if (yarn.plies > 1) text += fmt::format(", {} plies of {:.4g} turns/m", yarn.plies, yarn.ply_twist_per_m);
        if (yarn.irregularity_cv) text += ", unevenness " + words(yarn.irregularity_cv, "", number);
    }
    return text.empty() ? "none" : text;
}

std::string words(const std::vector<YarnRun>& order, const char*, const NumberText&)
{
    if (order.empty()) return "all alike";
    std::string text;
    for (const YarnRun& run : order) text += fmt::format("{}{} of {}", text.empty() ? "" : ", ", run.count, run.yarn);
    return text.size() <= 40 ? text : fmt::format("{} stripes", order.size());
}

std::string words(const std::optional<Calibrated>& calibrated, const char*, const NumberText&)
{
    return calibrated ? calibrated->file : "not given";
}

template <typename Value> bool alike(const Value& a, const Value& b) { return a == b; }
bool alike(const Weave& a, const Weave& b) { return a.same_matrix(b); }

/// But for how they look.
bool alike(const std::vector<Yarn>& a, const std::vector<Yarn>& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Yarn& one, Yarn other) {
        other.fibres_per_yarn = one.fibres_per_yarn;
        other.twist_direction = one.twist_direction;
        other.ply_twist_direction = one.ply_twist_direction;
        other.color = one.color;
        return one == other;
    });
}

/// get(fabric): the value of the key.
template <typename Get> PartField field(std::string key, const char* name, const char* unit, Get get)
{
    return {std::move(key), name, [get](const Fabric& a, const Fabric& b) { return alike(get(a), get(b)); },
            [get](Fabric& to, const Fabric& from) { get(to) = get(from); },
            [get, unit](const Fabric& fabric, const NumberText& number) { return words(get(fabric), unit, number); }};
}

/// Of the warp or the weft; yarn(fabric): it.
template <typename OfYarn> void add_yarn(std::vector<FabricPart>& parts, const std::string& which, OfYarn yarn)
{
    const auto of = [&](const char* key, const char* name, const char* unit, auto member) {
        return field(
            which + "." + key, name, unit, [ yarn, member ](auto& fabric) -> auto& { return yarn(fabric).*member; });
    };
    PartField plies = of("plies", "plies", "", &Yarn::plies);
    plies.copy = [yarn](Fabric& to, const Fabric& from) {
        yarn(to).plies = yarn(from).plies;
        yarn(to).fibres_per_yarn = yarn(from).fibres_per_yarn; // no fewer drawn fibres than plies are allowed
    };
    parts.push_back({which + " fibre", PartActs::always, {of("material", "", "", &Yarn::material), of("core", "core", "", &Yarn::core)}});
    parts.push_back({which + " count",
                     PartActs::always,
                     {of("diameter_mm", "diameter", " mm", &Yarn::diameter_mm),
                      of("linear_density_tex", "linear density", " tex", &Yarn::linear_density_tex)}});
    parts.push_back(
        {which + " construction",
         PartActs::always,
         {of("packing_factor", "packing", "", &Yarn::packing_factor), of("yarn_class", "class", "", &Yarn::yarn_class),
          of("filament_count", "filaments", "", &Yarn::filament_count), of("twist_per_m", "twist", " turns/m", &Yarn::twist_per_m),
          std::move(plies), of("ply_twist_per_m", "ply twist", " turns/m", &Yarn::ply_twist_per_m),
          of("irregularity_cv", "unevenness", "", &Yarn::irregularity_cv)}});
    parts.push_back(
        {which + " look",
         PartActs::never,
         {of("fibres_per_yarn", "drawn fibres", "", &Yarn::fibres_per_yarn), of("twist_direction", "twist", "", &Yarn::twist_direction),
          of("ply_twist_direction", "ply twist", "", &Yarn::ply_twist_direction), of("color", "colour", "", &Yarn::color)}});
}

#define OF(member)                                                                                                                         \
    [](auto& fabric) -> auto& { return fabric.member; } // NOLINT(bugprone-macro-parentheses): the name of a member

void add_faces(std::vector<FabricPart>& parts)
{
    parts.push_back({"hairs and loops",
                     PartActs::always,
                     {field("flyaway.loop_density_per_mm", "loops", " /mm", OF(flyaway.loop_density_per_mm)),
                      field("flyaway.hair_density_per_mm", "hairs", " /mm", OF(flyaway.hair_density_per_mm)),
                      field("flyaway.loop_height_mm", "height of loops", " mm", OF(flyaway.loop_height_mm)),
                      field("flyaway.hair_length_mm", "length of hairs", " mm", OF(flyaway.hair_length_mm))}});
    parts.push_back({contact_angle_title, PartActs::always, {field("contact_angle_deg", "finish", "°", OF(contact_angle_deg))}});
    parts.push_back({"finish of the upper face", PartActs::always, {field("finish_face", "", "°", OF(finish_face))}});
    parts.push_back({"finish of the lower face", PartActs::always, {field("finish_back", "", "°", OF(finish_back))}});
    parts.push_back({"depth of the finish",
                     PartActs::always,
                     {field("finish_depth", "depth", "", OF(finish_depth)), field("finish_holes", "untreated", "", OF(finish_holes))}});
}

void add_knowledge(std::vector<FabricPart>& parts)
{
    parts.push_back({"measured values",
                     PartActs::always,
                     {field("porosity", "porosity", "", OF(measured.porosity)),
                      field("areal_density_g_m2", "weight", " g/m²", OF(measured.areal_density_g_m2)),
                      field("capillary_radius_um", "pore radius", " µm", OF(measured.capillary_radius_um)),
                      field("tortuosity", "tortuosity", "", OF(measured.tortuosity)),
                      field("crimp_percent", "crimp", " %", OF(measured.crimp_percent))}});
    parts.push_back({"ranges of what is not known",
                     PartActs::in_replicates,
                     {field("uncertainty.contact_angle_deg", "contact angle ±", "°", OF(uncertainty.contact_angle_deg)),
                      field("uncertainty.receding_angle_deg", "receding angle ±", "°", OF(uncertainty.receding_angle_deg)),
                      field("uncertainty.packing_factor", "packing ±", "", OF(uncertainty.packing_factor))}});
    parts.push_back({"origin of fitted values", PartActs::never, {field("calibrated", "", "", OF(calibrated))}});
}

std::vector<FabricPart> all_parts()
{
    std::vector<FabricPart> parts;
    parts.push_back({"name", PartActs::never, {field("name", "", "", OF(name))}});
    add_yarn(parts, "warp", OF(warp));
    add_yarn(parts, "weft", OF(weft));
    parts.push_back({"weave", PartActs::always, {field("weave", "", "", OF(weave))}});
    parts.push_back({"warp sett", PartActs::always, {field("ends_per_cm", "", " ends/cm", OF(ends_per_cm))}});
    parts.push_back({"weft sett", PartActs::always, {field("picks_per_cm", "", " picks/cm", OF(picks_per_cm))}});
    parts.push_back({"stripes",
                     PartActs::always,
                     {field("extra_yarns", "yarns", "", OF(extra_yarns)), field("warp_order", "ends", "", OF(warp_order)),
                      field("weft_order", "picks", "", OF(weft_order))}});
    parts.push_back({"thickness", PartActs::always, {field("thickness_mm", "", " mm", OF(thickness_mm))}});
    parts.push_back({"crimp",
                     PartActs::always,
                     {field("warp_crimp_percent", "warp", " %", OF(warp_crimp_percent)),
                      field("weft_crimp_percent", "weft", " %", OF(weft_crimp_percent))}});
    add_faces(parts);
    add_knowledge(parts);
    return parts;
}

#undef OF

/// The fibre of a yarn that is no blend; nullptr: it is one.
const Material* only_fibre(const Design& design, const Yarn& yarn)
{
    return yarn.material.size() == 1 ? find_material(design, yarn.material.front().name) : nullptr;
}

/// Whether two yarns' fibres are one substance with other angles of water.
bool differ_in_angles_alone(const Design& design, const Yarn& a, const Yarn& b)
{
    const Material *one = only_fibre(design, a), *other = only_fibre(design, b);
    if (!one || !other || two_stage_law(*one) != two_stage_law(*other)) return false;
    Material alike = *other;
    alike.name = one->name;
    alike.based_on = one->based_on;
    alike.contact_angle_deg = one->contact_angle_deg;
    alike.receding_angle_deg = one->receding_angle_deg;
    return alike == *one;
}

std::string with_angle(const Design& design, const Yarn& yarn)
{
    const Material& fibre = *only_fibre(design, yarn);
    const std::string receding = fibre.receding_angle_deg ? fmt::format(", receding {:.4g}°", *fibre.receding_angle_deg) : "";
    return fmt::format("{} {:.4g}°{}", fibre.name, fibre.contact_angle_deg, receding);
}

void add_text(std::string& text, const char* name, const std::string& value)
{
    text += (text.empty() ? "" : ", ") + (*name ? name + (" " + value) : value);
}

} // namespace

const std::vector<FabricPart>& fabric_parts()
{
    static const std::vector<FabricPart> parts = all_parts();
    return parts;
}

std::vector<PartDifference> part_differences(const Design& design, const Fabric& first, const Fabric& second, bool replicates,
                                             const NumberText& number)
{
    std::vector<PartDifference> found;
    PartDifference angles{contact_angle_title, {}, {}, {}};
    for (const FabricPart& part : fabric_parts()) {
        if (part.acts == PartActs::never || (part.acts == PartActs::in_replicates && !replicates)) continue;
        PartDifference own{part.title, {}, {}, {}};
        if (own.title == contact_angle_title) own = angles;
        for (const PartField& each : part.fields) {
            if (each.same(first, second)) continue;
            const bool warp = each.key == "warp.material", weft = each.key == "weft.material";
            const Yarn &one = warp ? first.warp : first.weft, &other = warp ? second.warp : second.weft;
            if ((warp || weft) && differ_in_angles_alone(design, one, other)) {
                add_text(angles.first, warp ? "warp" : "weft", with_angle(design, one));
                add_text(angles.second, warp ? "warp" : "weft", with_angle(design, other));
                angles.fields.push_back(&each);
                continue;
            }
            const bool alone = part.fields.size() == 1 && own.fields.empty() && own.title != contact_angle_title;
            add_text(own.first, alone ? "" : each.name, each.text(first, number));
            add_text(own.second, alone ? "" : each.name, each.text(second, number));
            own.fields.push_back(&each);
        }
        if (!own.fields.empty()) found.push_back(std::move(own));
    }
    return found;
}

} // namespace hygroloom
