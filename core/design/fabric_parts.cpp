// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/fabric_parts.h"

#include "core/design/fields.h"
#include "core/design/looks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace hygroloom {
namespace {

constexpr const char* contact_angle_title = "contact angle";

std::string words(double value, const std::string& unit, const NumberText& number)
{
    return number ? number(value, unit) : fmt::format("{:.4g}{}", value, unit);
}
std::string words(const std::string& value, const char*, const NumberText&) { return value; }

std::string words(const std::optional<Color>& color, const char*, const NumberText&)
{
    return color ? fmt::format("#{:02x}{:02x}{:02x}", color->red, color->green, color->blue) : "not given";
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

/// "Twist" as reports write it: "twist".
template <typename Owner> std::string name_of(const Field<Owner>& row)
{
    std::string name = row.label;
    name[0] = static_cast<char>(std::tolower(name[0]));
    return name;
}

template <typename Owner> std::string text_of(const Field<Owner>& row, const Owner& owner, const NumberText& number)
{
    const std::optional<double> value = field_value(row, owner);
    if (!value) return "not given";
    if (const auto* choice = std::get_if<FieldChoice<Owner>>(&row.value)) return choice->words[static_cast<std::size_t>(*value)];
    if (row.is_whole()) return fmt::format("{}", *value);
    const std::string unit(trade_units(row.unit()).front().spellings.front());
    return words(*value, unit.empty() || unit == "°" ? unit : " " + unit, number);
}

std::string words(const std::vector<Yarn>& yarns, const char*, const NumberText& number)
{
    std::string text;
    for (const Yarn& yarn : yarns) {
        text += (text.empty() ? "" : "; ") + words(yarn.material, "", number);
        if (yarn.core) text += ", core of " + words(yarn.core, "", number);
        for (const Field<Yarn>& row : fields_of<Yarn>())
            if (field_value(row, yarn) && !is_look(row) && (!row.is_written || row.is_written(yarn)))
                text += ", " + name_of(row) + " " + text_of(row, yarn, number);
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
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const Yarn& one, const Yarn& other) { return without_look(one) == without_look(other); });
}

/// get(fabric): the value of the key.
template <typename Get> PartField field(std::string key, const char* name, Get get)
{
    return {std::move(key), name, [get](const Fabric& a, const Fabric& b) { return alike(get(a), get(b)); },
            [get](Fabric& to, const Fabric& from) { get(to) = get(from); },
            [get](const Fabric& fabric, const NumberText& number) { return words(get(fabric), "", number); }};
}

/// A row of an object in the fabric; of(fabric): the object.
template <typename Owner, typename Of> PartField field_of_row(const std::string& path, const Field<Owner>& row, Of of)
{
    return {path + row.key, name_of(row),
            [&row, of](const Fabric& a, const Fabric& b) { return field_value(row, of(a)) == field_value(row, of(b)); },
            [&row, of](Fabric& to, const Fabric& from) { set_field(row, of(to), field_value(row, of(from))); },
            [&row, of](const Fabric& fabric, const NumberText& number) { return text_of(row, of(fabric), number); }};
}

/// Each row to the part that it names, or to the one that all of them belong to.
template <typename Owner, typename Of>
void add_rows(std::vector<FabricPart>& parts, const std::string& path, Of of, const std::string& before = {}, const char* all = nullptr)
{
    for (const Field<Owner>& row : fields_of<Owner>()) {
        const std::string title = all ? all : before + row.part;
        const auto part = std::find_if(parts.begin(), parts.end(), [&](const FabricPart& each) { return each.title == title; });
        part->fields.push_back(field_of_row(path, row, of));
        if (row.key != std::string_view("plies")) continue;
        part->fields.back().copy = [of](Fabric& to, const Fabric& from) {
            if constexpr (std::is_same_v<Owner, Yarn>) {
                of(to).plies = of(from).plies;
                of(to).fibres_per_yarn = of(from).fibres_per_yarn; // no fewer drawn fibres than plies are allowed
            }
        };
    }
}

#define OF(member)                                                                                                                         \
    [](auto& fabric) -> auto& { return fabric.member; } // NOLINT(bugprone-macro-parentheses): the name of a member

std::vector<FabricPart> all_parts()
{
    using enum PartActs;
    std::vector<FabricPart> parts{
        {"name", never, {field("name", "", OF(name))}},
        {"warp fibre", always, {field("warp.material", "", OF(warp.material)), field("warp.core", "core", OF(warp.core))}},
        {"warp count", always, {}},
        {"warp construction", always, {}},
        {"warp look",
         never,
         {field("warp.color", "colour", OF(warp.color)), field("warp.library_yarn", "yarn of the library", OF(warp.library_yarn))}},
        {"weft fibre", always, {field("weft.material", "", OF(weft.material)), field("weft.core", "core", OF(weft.core))}},
        {"weft count", always, {}},
        {"weft construction", always, {}},
        {"weft look",
         never,
         {field("weft.color", "colour", OF(weft.color)), field("weft.library_yarn", "yarn of the library", OF(weft.library_yarn))}},
        {"weave", always, {field("weave", "", OF(weave))}},
        {"warp sett", always, {}},
        {"weft sett", always, {}},
        {"stripes",
         always,
         {field("extra_yarns", "yarns", OF(extra_yarns)), field("warp_order", "ends", OF(warp_order)),
          field("weft_order", "picks", OF(weft_order))}},
        {"thickness", always, {}},
        {"crimp", always, {}},
        {"hairs and loops", always, {}},
        {contact_angle_title, always, {}},
        {"finish of the upper face", always, {}},
        {"finish of the lower face", always, {}},
        {"depth of the finish", always, {}},
        {"measured values", always, {}},
        {"ranges of what is not known", in_replicates, {}},
        {"cloth on the loom", never, {}},
        {"origin of fitted values", never, {field("calibrated", "", OF(calibrated))}}};
    add_rows<Yarn>(parts, "warp.", OF(warp), "warp ");
    add_rows<Yarn>(parts, "weft.", OF(weft), "weft ");
    add_rows<Fabric>(
        parts, "", [](auto& fabric) -> auto& { return fabric; });
    add_rows<Flyaway>(parts, "flyaway.", OF(flyaway), {}, "hairs and loops");
    add_rows<Measured>(parts, "", OF(measured), {}, "measured values");
    add_rows<Uncertainty>(parts, "uncertainty.", OF(uncertainty), {}, "ranges of what is not known");
    add_rows<Loom>(parts, "loom.", OF(loom), {}, "cloth on the loom");
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

void add_text(std::string& text, const std::string& name, const std::string& value)
{
    text += (text.empty() ? "" : ", ") + (name.empty() ? value : name + " " + value);
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
            add_text(own.first, alone || each.name == own.title ? "" : each.name, each.text(first, number));
            add_text(own.second, alone || each.name == own.title ? "" : each.name, each.text(second, number));
            own.fields.push_back(&each);
        }
        if (!own.fields.empty()) found.push_back(std::move(own));
    }
    return found;
}

} // namespace hygroloom
