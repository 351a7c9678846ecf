// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Yarns of a design beside those of a library: which are the same, and what an update brings.
#include "core/project/field_json.h"
#include "core/project/library.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

/// Tables and files round shares.
bool same_share(double one, double other) { return std::abs(one - other) <= 1e-6; }

/// In any order.
bool same_fibres(const Design& a, const Yarn& one, const Design& b, const Yarn& other)
{
    const auto same = [&](const MaterialShare& x, const MaterialShare& y) {
        return same_share(x.share, y.share) && same_substance(a, x.name, b, y.name);
    };
    const auto is_in_other = [&](const MaterialShare& x) {
        return std::any_of(other.material.begin(), other.material.end(), [&](const auto& y) { return same(x, y); });
    };
    const auto is_in_one = [&](const MaterialShare& y) {
        return std::any_of(one.material.begin(), one.material.end(), [&](const auto& x) { return same(x, y); });
    };
    return one.material.size() == other.material.size() && std::all_of(one.material.begin(), one.material.end(), is_in_other) &&
           std::all_of(other.material.begin(), other.material.end(), is_in_one);
}

bool same_core(const Design& a, const Yarn& one, const Design& b, const Yarn& other)
{
    if (!one.core || !other.core) return one.core.has_value() == other.core.has_value();
    return same_share(one.core->share, other.core->share) && same_substance(a, one.core->material, b, other.core->material);
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

/// Linear densities are the same to 1e-4 of them: those that come from counts are rounded.
bool same_value(const Field<Yarn>& field, const Yarn& one, const Yarn& other)
{
    const auto value = field_value(field, one), beside = field_value(field, other);
    if (field.key != std::string_view("linear_density_tex") || !value || !beside) return value == beside;
    return std::abs(*value - *beside) <= 1e-4 * std::max(std::abs(*value), std::abs(*beside));
}

std::string key_of(std::size_t yarn) { return yarn == 0 ? "warp" : yarn == 1 ? "weft" : fmt::format("extra_yarns[{}]", yarn - 2); }

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
        if (same_value(field, yarn, other)) continue;
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

Yarn yarn_in_place(Design& design, const Yarn& before, const LibraryYarn& by)
{
    Yarn yarn = by.yarn();
    if (same_fibres(design, before, by.design, by.yarn()) && same_core(design, before, by.design, by.yarn())) {
        yarn.material = before.material; // by the names that they have here
        yarn.core = before.core;
        yarn.library_yarn = by.name;
    } else {
        yarn = take_yarn(design, by);
    }
    yarn.color = before.color;
    for (const Field<Yarn>& field : fields_of<Yarn>())
        if (!is_said(by, field.key) || same_value(field, before, by.yarn())) set_field(field, yarn, field_value(field, before));
    return yarn;
}

std::vector<YarnUpdate> replace_yarn(Design& design, const LibraryYarn& old, const LibraryYarn& by)
{
    std::vector<YarnUpdate> replaced;
    std::vector<Yarn*> places;
    for (Fabric& fabric : design.fabrics) {
        const std::vector<Yarn*> yarns = yarns_of(fabric);
        for (std::size_t i = 0; i < yarns.size(); ++i) {
            if (!same_yarn(design, *yarns[i], old)) continue;
            places.push_back(yarns[i]);
            replaced.push_back({fabric.name, key_of(i), by.name, false, changes_of_yarn(design, *yarns[i], by)});
        }
    }
    for (Yarn* yarn : places) *yarn = yarn_in_place(design, *yarn, by);
    return replaced;
}

std::vector<YarnUpdate> update_yarns(Design& design, const std::vector<LibraryYarn>& library)
{
    std::vector<YarnUpdate> updates;
    for (Fabric& fabric : design.fabrics) {
        const std::vector<Yarn*> yarns = yarns_of(fabric);
        for (std::size_t i = 0; i < yarns.size(); ++i) {
            Yarn& yarn = *yarns[i];
            if (yarn.library_yarn.empty()) continue;
            YarnUpdate update{fabric.name, key_of(i), yarn.library_yarn, false, {}};
            const auto by = std::find_if(library.begin(), library.end(), [&](const auto& each) { return each.name == yarn.library_yarn; });
            update.is_missing = by == library.end();
            if (!update.is_missing) update.changes = changes_of_yarn(design, yarn, *by);
            if (!update.is_missing && update.changes.empty()) continue;
            if (!update.is_missing) yarn = yarn_in_place(design, yarn, *by);
            updates.push_back(std::move(update));
        }
    }
    return updates;
}

} // namespace hygroloom
