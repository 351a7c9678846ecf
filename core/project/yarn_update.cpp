// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Yarns of a design beside those of a library: which are the same, and what an update brings.
#include "core/project/field_json.h"
#include "core/project/library.h"

#include <fmt/format.h>

#include <algorithm>

namespace hygroloom {
namespace {

/// Whether both names mean the same substance.
bool same_substance(const Design& a, const std::string& name_a, const Design& b, const std::string& name_b)
{
    const Material *one = find_material(a, name_a), *other = find_material(b, name_b);
    if (!one || !other) return name_a == name_b;
    Material named = *one;
    named.name = other->name;
    named.based_on = other->based_on;
    return named == *other;
}

bool same_fibres(const Design& a, const Yarn& one, const Design& b, const Yarn& other)
{
    return std::equal(
        one.material.begin(), one.material.end(), other.material.begin(), other.material.end(),
        [&](const MaterialShare& x, const MaterialShare& y) { return x.share == y.share && same_substance(a, x.name, b, y.name); });
}

bool same_core(const Design& a, const Yarn& one, const Design& b, const Yarn& other)
{
    if (!one.core || !other.core) return one.core.has_value() == other.core.has_value();
    return one.core->share == other.core->share && same_substance(a, one.core->material, b, other.core->material);
}

std::string core_text(const Yarn& yarn)
{
    return yarn.core ? fmt::format("{} {:g} %", yarn.core->material, 100 * yarn.core->share) : std::string();
}

bool is_said(const LibraryYarn& by, const std::string& key)
{
    return key != "fibres_per_yarn" && std::find(by.unsaid.begin(), by.unsaid.end(), key) == by.unsaid.end() &&
           (key != "price" || by.yarn().price);
}

/// Of a yarn without plies the plies have no twist, and nothing has a direction that is not twisted.
bool has(const Yarn& yarn, const std::string& key)
{
    if (key.starts_with("ply_") && yarn.plies < 2) return false;
    return (key != "twist_direction" || yarn.twist_per_m > 0) && (key != "ply_twist_direction" || yarn.ply_twist_per_m > 0);
}

std::string text_of_field(const Field<Yarn>& field, const Yarn& yarn)
{
    const auto number = field_value(field, yarn);
    if (!number) return {};
    if (!field.is_number()) return json_of_field(field, yarn).get<std::string>();
    const auto& units = trade_units(field.unit());
    const std::string_view unit = units.empty() ? std::string_view() : units.front().spellings.front();
    return unit.empty() ? fmt::format("{:.6g}", *number) : fmt::format("{:.6g} {}", *number, unit);
}

/// What the library's yarn does not say is as it was.
Yarn updated(Design& design, const Yarn& before, const LibraryYarn& by)
{
    Yarn yarn = take_yarn(design, by);
    yarn.color = before.color;
    for (const Field<Yarn>& field : fields_of<Yarn>())
        if (!is_said(by, field.key)) set_field(field, yarn, field_value(field, before));
    return yarn;
}

} // namespace

const std::vector<std::string>& unsaid_keys()
{
    static const std::vector<std::string> keys{"twist_per_m",    "twist_direction", "ply_twist_per_m", "ply_twist_direction",
                                               "packing_factor", "yarn_class",      "irregularity_cv"};
    return keys;
}

std::vector<YarnChange> changes_of_yarn(const Design& design, const Yarn& yarn, const LibraryYarn& of)
{
    std::vector<YarnChange> changes;
    const Yarn& other = of.yarn();
    if (!same_fibres(design, yarn, of.design, other)) changes.push_back({"material", "Fibres", fibres_text(yarn), fibres_text(other)});
    if (!same_core(design, yarn, of.design, other)) changes.push_back({"core", "Core", core_text(yarn), core_text(other)});
    for (const Field<Yarn>& field : fields_of<Yarn>()) {
        if (!is_said(of, field.key) || (!has(yarn, field.key) && !has(other, field.key))) continue;
        if (field_value(field, yarn) == field_value(field, other)) continue;
        changes.push_back({field.key, field.label, text_of_field(field, yarn), text_of_field(field, other)});
    }
    return changes;
}

bool same_yarn(const Design& design, const Yarn& yarn, const LibraryYarn& as)
{
    const std::vector<YarnChange> changes = changes_of_yarn(design, yarn, as);
    return std::all_of(changes.begin(), changes.end(), [](const YarnChange& each) { return each.key == "price"; });
}

std::vector<std::string> fabrics_with(const Design& design, const LibraryYarn& yarn)
{
    std::vector<std::string> names;
    for (Fabric fabric : design.fabrics) {
        const std::vector<Yarn*> own = yarns_of(fabric);
        if (std::any_of(own.begin(), own.end(), [&](const Yarn* each) { return same_yarn(design, *each, yarn); }))
            names.push_back(fabric.name);
    }
    return names;
}

int replace_yarn(Design& design, const LibraryYarn& old, const LibraryYarn& by)
{
    std::vector<Yarn*> replaced;
    int fabrics = 0;
    for (Fabric& fabric : design.fabrics) {
        const std::size_t before = replaced.size();
        for (Yarn* yarn : yarns_of(fabric))
            if (same_yarn(design, *yarn, old)) replaced.push_back(yarn);
        fabrics += replaced.size() > before ? 1 : 0;
    }
    if (replaced.empty()) return 0;
    const Yarn taken = take_yarn(design, by);
    for (Yarn* yarn : replaced) {
        Yarn now = taken;
        now.color = yarn->color;
        now.fibres_per_yarn = yarn->fibres_per_yarn;
        *yarn = now;
    }
    return fabrics;
}

std::vector<YarnUpdate> update_yarns(Design& design, const std::vector<LibraryYarn>& library)
{
    std::vector<YarnUpdate> updates;
    for (Fabric& fabric : design.fabrics) {
        const std::vector<Yarn*> yarns = yarns_of(fabric);
        for (std::size_t i = 0; i < yarns.size(); ++i) {
            Yarn& yarn = *yarns[i];
            if (yarn.library_yarn.empty()) continue;
            YarnUpdate update{fabric.name,
                              i == 0   ? "warp"
                              : i == 1 ? "weft"
                                       : fmt::format("extra_yarns[{}]", i - 2),
                              yarn.library_yarn,
                              false,
                              {}};
            const auto by = std::find_if(library.begin(), library.end(), [&](const auto& each) { return each.name == yarn.library_yarn; });
            update.is_missing = by == library.end();
            if (!update.is_missing) update.changes = changes_of_yarn(design, yarn, *by);
            if (!update.is_missing && update.changes.empty()) continue;
            if (!update.is_missing) yarn = updated(design, yarn, *by);
            updates.push_back(std::move(update));
        }
    }
    return updates;
}

} // namespace hygroloom
