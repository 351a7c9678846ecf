// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/unknowns.h"

#include "core/base/random.h"
#include "core/base/units.h"
#include "core/design/validate.h"
#include "core/design/yarn_class.h"
#include "core/design/yarn_sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <set>

namespace hygroloom {
namespace {

constexpr double usual_angle_off = 10; ///< degrees either way of a finish or of a user's fibre, as of most finishes of the library
constexpr double least_hysteresis = 10, most_hysteresis = 30; ///< degrees, of fibres that do not swell; an assumption

/// Of the yarn's fibres, in words; equal for yarns of equal fibres.
std::string fibres_of(const Yarn& yarn)
{
    std::string names;
    for (const MaterialShare& part : yarn.material) names += (names.empty() ? "" : " and ") + part.name;
    return names;
}

UnknownInput within(std::string name, double given, double low, double high, const char* unit, std::string source)
{
    return {std::move(name), std::min(low, given), given, std::max(high, given), unit, std::move(source), {}};
}

UnknownInput either_way(std::string name, double given, double off, double least, double most, const char* unit, std::string source)
{
    return within(std::move(name), given, std::max(least, given - off), std::min(most, given + off), unit, std::move(source));
}

const char* given_by_user = "the project's uncertainty";

UnknownInput finish_angle(const Fabric& fabric)
{
    const double off = fabric.uncertainty.contact_angle_deg.value_or(usual_angle_off);
    return either_way("contact angle of the finish on " + fibres_of(fabric.warp), *fabric.contact_angle_deg, off, 0, 180, "°",
                      fabric.uncertainty.contact_angle_deg ? given_by_user : "usual width of a finish's range in the library");
}

UnknownInput fibre_angle(const Fabric& fabric, const Material& material)
{
    const std::string name = "contact angle on " + material.name;
    const double given = material.contact_angle_deg;
    if (fabric.uncertainty.contact_angle_deg)
        return either_way(name, given, *fabric.uncertainty.contact_angle_deg, 0, 180, "°", given_by_user);
    const Material* library = find_library_material(library_name(material));
    if (!library || library->contact_angle_deg != given)
        return either_way(name, given, usual_angle_off, 0, 180, "°", "usual width of a finish's range in the library");
    const AngleRange range = contact_angle_range(library->name);
    return within(name, given, range.low, range.high, "°", range.source);
}

/// How far the receding angle lies below the contact angle, whatever that is.
UnknownInput hysteresis(const Fabric& fabric, const Material& material)
{
    const std::string name = "contact angle hysteresis on " + material.name;
    const double assumed = assumed_hysteresis_deg(material);
    const double given = material.receding_angle_deg ? std::max(0.0, material.contact_angle_deg - *material.receding_angle_deg) : assumed;
    if (fabric.uncertainty.receding_angle_deg)
        return either_way(name, std::min(given, 180.0), *fabric.uncertainty.receding_angle_deg, 0, 180, "°", given_by_user);
    if (material.receding_angle_deg || assumed >= 180) return within(name, given, given, given, "°", "");
    return within(name, given, least_hysteresis, most_hysteresis, "°", "assumption of the library for fibres that do not swell");
}

/// Equal for equal yarns, so that fabrics of the same yarn share the unknown.
UnknownInput packing(const Design& design, const Fabric& fabric, const Yarn& yarn)
{
    const std::string size =
        yarn.linear_density_tex ? fmt::format("{:g} tex", *yarn.linear_density_tex) : fmt::format("{:g} mm", yarn.diameter_mm.value_or(0));
    const YarnClass kind = yarn_class_of(design, yarn);
    const std::string made = kind == YarnClass::ring ? "" : fmt::format("{} ", info_of(kind).title);
    const std::string plies = yarn.plies > 1 ? fmt::format(" x {}", yarn.plies) : std::string();
    const std::string name =
        fmt::format("packing of the {}yarn of {}, {}{}, {:g} turns/m", made, fibres_of(yarn), size, plies, yarn.twist_per_m);
    const double given = packing_of(design, yarn);
    if (fabric.uncertainty.packing_factor)
        return either_way(name, given, *fabric.uncertainty.packing_factor, loosest_packing, densest_packing, "", given_by_user);
    if (yarn.packing_factor) return within(name, given, given, given, "", "");
    return within(name, given, given - 0.05, std::min(given + 0.1, densest_packing), "",
                  "yarns of a class, soft to hard spun; an assumption");
}

bool leaves_packing_open(const Yarn& yarn) { return !(yarn.diameter_mm && yarn.linear_density_tex); }

std::vector<const Material*> fibres_in(const Design& design, const Fabric& fabric)
{
    std::set<std::string> seen;
    std::vector<const Material*> fibres;
    Fabric copy = fabric;
    for (const Yarn* yarn : yarns_of(copy))
        for (const MaterialShare& part : yarn->material)
            if (seen.insert(part.name).second) fibres.push_back(find_material(design, part.name));
    return fibres;
}

double value_at(const UnknownInput& input, double place)
{
    return place < 0.5 ? input.low + 2 * place * (input.given - input.low) : input.given + (2 * place - 1) * (input.high - input.given);
}

/// The project's own material of that name, made from the library's where there is none.
Material& own_material(Design& design, const std::string& name)
{
    for (Material& material : design.materials)
        if (material.name == name) return material;
    design.materials.push_back(*find_library_material(name));
    return design.materials.back();
}

using Value = std::function<double(const UnknownInput&)>;

/// as_given: the design that nothing has been drawn in, of whose fibres another fabric may have been drawn before.
void draw_angles(const Design& as_given, Design& design, Fabric& fabric, const Value& value)
{
    const Fabric given = fabric;
    if (given.contact_angle_deg) fabric.contact_angle_deg = value(finish_angle(given));
    const double moved = given.contact_angle_deg ? *fabric.contact_angle_deg - *given.contact_angle_deg : 0;
    for (std::optional<double>* face : {&fabric.finish_face, &fabric.finish_back})
        if (*face) *face = std::clamp(**face + moved, 0.0, 180.0);
    for (const Material* fibre : fibres_in(as_given, given)) {
        const Material& before = *fibre;
        Material& own = own_material(design, before.name);
        if (!given.contact_angle_deg) own.contact_angle_deg = value(fibre_angle(given, before));
        const UnknownInput off = hysteresis(given, before);
        const double in_use = fabric.contact_angle_deg.value_or(own.contact_angle_deg);
        if (off.high > off.low)
            own.receding_angle_deg = std::max(0.0, in_use - value(off));
        else if (before.receding_angle_deg)
            own.receding_angle_deg = std::max(0.0, in_use - off.given);
    }
}

void draw_packing(Design& design, std::size_t fabric, const Value& value)
{
    const Design before = design;
    const Fabric given = design.fabrics[fabric];
    for (Yarn* yarn : yarns_of(design.fabrics[fabric])) {
        if (!leaves_packing_open(*yarn)) continue;
        const UnknownInput input = packing(design, given, *yarn);
        if (!(input.high > input.low)) continue;
        yarn->yarn_class = yarn_class_of(design, *yarn); // which a packing that is drawn would change
        yarn->packing_factor = value(input);
    }
    if (!validate_and_fit(design).fabrics[fabric]) design = before;
}

void draw_places(Experiment& experiment, const Fabric& fabric, const Replicate& replicate)
{
    const double repeat[2] = {10.0 * fabric.weave.ends() / fabric.ends_per_cm, 10.0 * fabric.weave.picks() / fabric.picks_per_cm}; // mm
    for (Droplet& drop : experiment.droplets)
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const double off = place_in_range(replicate, axis == 0 ? "drop along the weft" : "drop along the warp") - 0.5;
            const double edge = std::max(std::abs(drop.at_mm[axis]), 0.5 * experiment.sample_mm[axis] - 0.5);
            drop.at_mm[axis] = std::clamp(drop.at_mm[axis] + off * repeat[axis], -edge, edge);
        }
}

std::uint64_t stream_of(const std::string& name) // FNV-1a (Fowler, Noll, Vo)
{
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    return hash;
}

} // namespace

std::vector<UnknownInput> unknown_inputs(const Design& design, const Fabric& fabric)
{
    std::vector<UnknownInput> all;
    std::set<std::string> seen;
    const auto add = [&](UnknownInput input, const char* key) {
        input.key = key;
        if (input.high > input.low && seen.insert(input.name).second) all.push_back(std::move(input));
    };
    if (fabric.contact_angle_deg) add(finish_angle(fabric), "contact_angle_deg");
    for (const Material* fibre : fibres_in(design, fabric)) {
        if (!fabric.contact_angle_deg) add(fibre_angle(fabric, *fibre), "contact_angle_deg");
        add(hysteresis(fabric, *fibre), "receding_angle_deg");
    }
    Fabric copy = fabric;
    for (const Yarn* yarn : yarns_of(copy))
        if (leaves_packing_open(*yarn)) add(packing(design, fabric, *yarn), "packing_factor");
    return all;
}

double place_in_range(const Replicate& replicate, const std::string& name)
{
    if (replicate.number == 0) return 0.5;
    const std::uint64_t stream = stream_of(name);
    const int strata = replicate.of - 1;
    std::vector<std::uint64_t> order(static_cast<std::size_t>(strata));
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](std::uint64_t a, std::uint64_t b) {
        return random_bits(replicate.seed, stream, a) < random_bits(replicate.seed, stream, b);
    });
    const auto own = static_cast<std::uint64_t>(replicate.number - 1);
    const double within = random_uniform(replicate.seed, stream, static_cast<std::uint64_t>(strata) + own);
    return (static_cast<double>(order[own]) + within) / strata;
}

Drawn drawn(const Design& design, const std::vector<std::string>& fabrics, const Replicate& replicate)
{
    Drawn drawn{design, replicate.seed + static_cast<std::uint64_t>(replicate.number), {}, {}};
    if (replicate.of == 1) return drawn;
    const Value value = [&](const UnknownInput& input) { return value_at(input, place_in_range(replicate, input.name)); };
    for (const std::string& name : fabrics) {
        const auto at = static_cast<std::size_t>(find_fabric(design, name) - design.fabrics.data());
        for (const UnknownInput& input : unknown_inputs(design, design.fabrics[at])) {
            if (std::find(drawn.names.begin(), drawn.names.end(), input.name) != drawn.names.end()) continue;
            drawn.names.push_back(input.name);
            drawn.places.push_back(place_in_range(replicate, input.name));
        }
        if (replicate.number == 0) continue;
        draw_angles(design, drawn.design, drawn.design.fabrics[at], value);
        draw_packing(drawn.design, at, value);
    }
    return drawn;
}

Drawn drawn(const Design& design, const std::string& fabric, const std::string& experiment, const Replicate& replicate)
{
    Drawn made = drawn(design, std::vector{fabric}, replicate);
    if (replicate.number == 0 || replicate.of == 1) return made;
    draw_places(made.design.experiments[static_cast<std::size_t>(find_experiment(design, experiment) - design.experiments.data())],
                *find_fabric(design, fabric), replicate);
    return made;
}

} // namespace hygroloom
