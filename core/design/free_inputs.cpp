// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/free_inputs.h"

#include "core/base/error.h"
#include "core/base/words.h"
#include "core/design/validate.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace hygroloom {
namespace {

struct Kind {
    const char *key, *title;
    std::optional<double> Uncertainty::*uncertainty;
    std::optional<double> Calibrated::Before::*before;
};

constexpr std::array<Kind, 3> kinds{
    {{"contact_angle_deg", "contact angle", &Uncertainty::contact_angle_deg, &Calibrated::Before::contact_angle_deg},
     {"receding_angle_deg", "receding angle", &Uncertainty::receding_angle_deg, &Calibrated::Before::receding_angle_deg},
     {"packing_factor", "packing factor", &Uncertainty::packing_factor, &Calibrated::Before::packing_factor}}};

const Kind& kind_named(const std::string& key)
{
    for (const Kind& kind : kinds)
        if (key == kind.key) return kind;
    throw Error(fmt::format("There is no input \"{}\" to fit{} There are contact_angle_deg, receding_angle_deg and packing_factor.", key,
                            did_you_mean(key, free_input_keys())));
}

std::size_t place_of(const Design& design, const std::string& fabric)
{
    return static_cast<std::size_t>(find_fabric(design, fabric) - design.fabrics.data());
}

/// Precondition: the fabric's fibres share it.
double angle_in_use(const Design& design, const Fabric& fabric)
{
    return fabric.contact_angle_deg.value_or(find_material(design, fabric.warp.material.front().name)->contact_angle_deg);
}

/// Of the yarns whose packing is open.
void set_packing(Fabric& fabric, double packing)
{
    for (Yarn* yarn : yarns_of(fabric))
        if (!(yarn->diameter_mm && yarn->linear_density_tex) && (fabric.uncertainty.packing_factor || !yarn->packing_factor))
            yarn->packing_factor = packing;
}

/// A name that no material of the project or the library has.
std::string free_name(const Design& design, const std::string& wanted)
{
    std::string name = wanted;
    for (int k = 2; find_material(design, name); ++k) name = fmt::format("{} ({})", wanted, k);
    return name;
}

/// Whether the project's fibre of that name is one that an earlier calibration made for the fabric: it is made of it, and nothing else is.
bool is_own(const Design& design, std::size_t at, const std::string& name)
{
    const std::string ending = " of " + design.fabrics[at].name;
    const bool named_so = name.ends_with(ending) || name.find(ending + " (") != std::string::npos;
    const auto named = [&name](const auto& each) { return each.name == name; };
    const auto made_of_it = [&](const Fabric& fabric) {
        const auto in = [&](const Yarn& yarn) { return std::any_of(yarn.material.begin(), yarn.material.end(), named); };
        return in(fabric.warp) || in(fabric.weft) || std::any_of(fabric.extra_yarns.begin(), fabric.extra_yarns.end(), in);
    };
    for (std::size_t i = 0; i < design.fabrics.size(); ++i)
        if (made_of_it(design.fabrics[i]) != (i == at)) return false;
    return named_so && design.fabrics[at].calibrated && std::any_of(design.materials.begin(), design.materials.end(), named);
}

void set_receding_angle(Design& design, std::size_t at, double angle)
{
    const double in_use = angle_in_use(design, design.fabrics[at]);
    for (Material& fibre : design.materials)
        if (is_own(design, at, fibre.name)) {
            fibre.contact_angle_deg = in_use;
            fibre.receding_angle_deg = std::min(angle, in_use);
        }
    std::vector<std::pair<std::string, std::string>> own; // fibre, the fabric's own
    Fabric& fabric = design.fabrics[at];
    for (Yarn* yarn : yarns_of(fabric))
        for (MaterialShare& part : yarn->material) {
            if (is_own(design, at, part.name)) continue;
            const auto known = std::find_if(own.begin(), own.end(), [&](const auto& pair) { return pair.first == part.name; });
            if (known != own.end()) {
                part.name = known->second;
                continue;
            }
            Material fibre = *find_material(design, part.name);
            fibre.based_on = find_library_material(library_name(fibre)) ? library_name(fibre) : fibre.based_on;
            fibre.name = free_name(design, part.name + " of " + fabric.name);
            fibre.contact_angle_deg = in_use;
            fibre.receding_angle_deg = std::min(angle, in_use);
            own.emplace_back(part.name, fibre.name);
            part.name = fibre.name;
            design.materials.push_back(std::move(fibre));
        }
}

bool fits(const Design& design, std::size_t at, double packing)
{
    Design other = design;
    set_packing(other.fabrics[at], packing);
    return validate_and_fit(other).fabrics[at] != nullptr;
}

/// Towards an end of the range, up to where the yarns still fit.
double fitting(const Design& design, std::size_t at, double given, double end)
{
    if (fits(design, at, end)) return end;
    double good = given, bad = end;
    constexpr int halvings = 10; // to a thousandth of the range
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (good + bad);
        (fits(design, at, middle) ? good : bad) = middle;
    }
    return good;
}

} // namespace

const std::vector<std::string>& free_input_keys()
{
    static const std::vector<std::string> keys{kinds[0].key, kinds[1].key, kinds[2].key};
    return keys;
}

FreeInput free_input(const Design& design, const Fabric& fabric, const std::string& key)
{
    const Kind& kind = kind_named(key);
    FreeInput input{key, kind.title, {}, 0, 0, 0};
    bool found = false;
    for (const UnknownInput& unknown : unknown_inputs(design, fabric)) {
        if (unknown.key != key) continue;
        if (found && (unknown.low != input.low || unknown.given != input.given || unknown.high != input.high))
            throw Error(fmt::format("The {} of {} is not one number, as its yarns or fibres differ; one measurement cannot tell them "
                                    "apart.{}",
                                    kind.title, fabric.name,
                                    key == "contact_angle_deg" ? " Give the fabric a contact_angle_deg of its own." : ""));
        found = true;
        input.unit = unknown.unit;
        input.low = unknown.low;
        input.given = unknown.given;
        input.high = unknown.high;
    }
    if (!found)
        throw Error(fmt::format("The {} of {} is known, so that there is nothing to fit; give the fabric an uncertainty.{} to let it "
                                "differ.",
                                kind.title, fabric.name, key));
    const std::size_t at = place_of(design, fabric.name);
    if (key == "receding_angle_deg") { // unknown is how far it lies below the contact angle
        const double contact = angle_in_use(design, fabric);
        input = {key,
                 kind.title,
                 input.unit,
                 std::max(0.0, contact - input.high),
                 std::max(0.0, contact - input.given),
                 std::max(0.0, contact - input.low)};
    }
    if (key == "packing_factor") {
        input.low = fitting(design, at, input.given, input.low);
        input.high = fitting(design, at, input.given, input.high);
    }
    return input;
}

Design with_inputs(const Design& design, const std::string& fabric, const std::vector<FreeInput>& inputs, const std::vector<double>& values)
{
    Design other = design;
    const std::size_t at = place_of(design, fabric);
    std::optional<double> receding; // after the contact angle that it lies below
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (inputs[i].key == "contact_angle_deg") other.fabrics[at].contact_angle_deg = values[i];
        if (inputs[i].key == "packing_factor") set_packing(other.fabrics[at], values[i]);
        if (inputs[i].key == "receding_angle_deg") receding = values[i];
    }
    if (receding) set_receding_angle(other, at, *receding);
    return other;
}

std::optional<double>& uncertainty_of(Fabric& fabric, const std::string& key) { return fabric.uncertainty.*kind_named(key).uncertainty; }
std::optional<double>& before_of(Calibrated& calibrated, const std::string& key) { return calibrated.before.*kind_named(key).before; }

} // namespace hygroloom
