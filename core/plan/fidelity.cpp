// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/plan/fidelity.h"

#include "core/base/error.h"
#include "core/base/words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace hygroloom {
namespace {

constexpr const char* drop_models[] = {"auto", "cap", "particles"};

// clang-format off
constexpr KnobInfo table[] = {
    {.name = "particles_per_droplet", .value = &Knobs::particles_per_droplet, .unit = "",
     .at = {1000, 2000, 8000, 8000}, .least = 8, .most = 1e6, .whole = true, .cheaper = 4000, .finer = 16000,
     .meaning = "most particles in one drop; a quarter of it where no yarn absorbs and settle_share is over 0; fewer in a tiny drop"},
    {.name = "fibre_shells", .value = &Knobs::fibre_shells, .unit = "",
     .at = {4, 5, 8, 16}, .least = 1, .most = largest_shell_count, .whole = true, .cheaper = 5, .finer = 12,
     .meaning = "radial cells in a fibre"},
    {.name = "crossings_per_cell", .value = &Knobs::crossings_per_cell, .unit = "",
     .at = {2, 1, 1, 1}, .least = 1, .most = 8, .whole = true, .cheaper = 4, .finer = 2,
     .meaning = "neighbouring ends (and picks) simulated as one bundle; 1 where free liquid, sweat or fine stripes need single yarns"},
    {.name = "crossings_per_even_cell", .value = &Knobs::crossings_per_even_cell, .unit = "",
     .at = {8, 8, 8, 1}, .least = 1, .most = 8, .whole = true, .cheaper = 8, .finer = 2,
     .meaning = "smallest bundle where the whole cloth changes evenly, except at its edges: drying, conditioning"},
    {.name = "network_step_limit_s", .value = &Knobs::network_step_limit, .unit = "s",
     .at = {4e-3, 2e-3, 1e-3, 0.25e-3}, .least = 1e-5, .most = 1, .whole = false, .cheaper = 2e-3, .finer = 0.5e-3,
     .meaning = "longest time step of the yarns while there is free liquid; a quarter of it while a drop flows into cloth with the closure pores"},
    {.name = "saturation_change", .value = &Knobs::saturation_change, .unit = "",
     .at = {0.4, 0.2, 0.1, 0.03}, .least = 1e-3, .most = 1, .whole = false, .cheaper = 0.2, .finer = 0.05,
     .meaning = "target change of saturation in one time step of the yarns while there is free liquid or a pool; twice that where liquid spreads from a spot by suction"},
    {.name = "step_error", .value = &Knobs::step_error, .unit = "",
     .at = {5e-3, 2e-3, 5e-4, 1e-4}, .least = 1e-7, .most = 0.1, .whole = false, .cheaper = 1e-3, .finer = 2.5e-4,
     .meaning = "largest error of a time step without free liquid, as a share of the water and heat at stake"},
    {.name = "liquid_step_factor", .value = &Knobs::liquid_step_factor, .unit = "",
     .at = {1, 1, 1, 1}, .least = 0.1, .most = 1, .whole = false, .cheaper = 1, .finer = 0.5,
     .meaning = "time step of the free liquid, as a share of the longest that flow, viscosity and surface waves allow"},
    {.name = "steps_between_absorption", .value = &Knobs::steps_between_absorption, .unit = "",
     .at = {8, 8, 8, 1}, .least = 1, .most = 64, .whole = true, .cheaper = 16, .finer = 4,
     .meaning = "steps of the free liquid per step in which yarns absorb it", .old_name = "steps_between_drinks"},
    {.name = "density_tolerance", .value = &Knobs::density_tolerance, .unit = "",
     .at = {0.02, 0.02, 0.01, 0.01}, .least = 1e-4, .most = 0.2, .whole = false, .cheaper = 0.02, .finer = 0.005,
     .meaning = "largest mean error of the liquid's density after its pressure is corrected"},
    {.name = "settle_share", .value = &Knobs::settle_share, .unit = "",
     .at = {0.05, 0.03, 0.01, 0}, .least = 0, .most = 0.5, .whole = false, .cheaper = 0.02, .finer = 0.005,
     .meaning = "share of the liquid at rest that yarns absorb before its flow is computed again; 0: its flow is always computed"},
    {.name = "rest_tolerance", .value = &Knobs::rest_tolerance, .unit = "",
     .at = {2e-3, 1e-3, 1e-4, 1e-6}, .least = 0, .most = 0.1, .whole = false, .cheaper = 1e-3, .finer = 1e-5,
     .meaning = "change of the air's humidity at which the computed area grows; 0: all of the sample is computed"},
    {.name = "double_precision", .value = &Knobs::double_precision, .unit = "",
     .at = {0, 0, 0, 0}, .least = 0, .most = 1, .whole = true, .cheaper = 0, .finer = 1,
     .meaning = "1: the liquid's particles are in double precision, on a CPU; 0: single precision"},
    {.name = "free_liquid", .value = &Knobs::free_liquid, .unit = "",
     .at = {0, 2, 2, 2}, .least = 0, .most = 2, .whole = true, .cheaper = 0, .finer = 1,
     .meaning = "drops as particles that flow, or as caps that stand with a contact line; auto: as caps where the plan allows it",
     .words = drop_models},
    {.name = "room_voxels", .value = &Knobs::room_voxels, .unit = "",
     .at = {16, 24, 28, 32}, .least = 0, .most = 48, .whole = true, .cheaper = 16, .finer = 32,
     .meaning = "voxels from yarn to yarn in which the room between them is drawn, from 28 on with Stokes flow; 0: a formula that knows no weave"},
    {.name = "neglected_share", .value = &Knobs::neglected_share, .unit = "",
     .at = {0.02, 0.01, 0.001, 0}, .least = 0, .most = 0.5, .whole = false, .cheaper = 0.01, .finer = 0,
     .meaning = "a part of the physics that changes the water or a rate by less than this share is left out"},
};
// clang-format on

std::string all_names()
{
    std::string names;
    for (const KnobInfo& knob : table) names += (names.empty() ? "" : ", ") + std::string(knob.name);
    return names;
}

[[noreturn]] void refuse(const KnobInfo& knob, const std::string& given)
{
    if (!knob.words.empty())
        throw Error(fmt::format("fidelity.{}: It must be {}; {} was given.", knob.name,
                                fmt::join(knob.words.begin(), knob.words.end(), " or "), given));
    throw Error(fmt::format("fidelity.{}: It must be {} from {:g} to {:g}{}{}; {} was given.", knob.name,
                            knob.whole ? "a whole number" : "a number", knob.least, knob.most, *knob.unit ? " " : "", knob.unit, given));
}

} // namespace

const char* name_of(Fidelity fidelity)
{
    constexpr const char* names[] = {"live", "draft", "standard", "reference"};
    return names[static_cast<int>(fidelity)];
}

Fidelity fidelity_from_name(const std::string& name)
{
    for (Fidelity f : all_fidelities)
        if (name == name_of(f)) return f;
    throw Error("The fidelity must be live, draft, standard or reference; \"" + name + "\" was given.");
}

std::span<const KnobInfo> knob_table() { return table; }

Knobs knobs_of(Fidelity fidelity)
{
    Knobs knobs;
    for (const KnobInfo& knob : table) knobs.*knob.value = knob.at[static_cast<int>(fidelity)];
    return knobs;
}

std::string text_of(const KnobInfo& knob, double value)
{
    const auto number = static_cast<std::size_t>(value);
    if (number < knob.words.size()) return knob.words[number];
    return fmt::format("{:g}{}{}", value, *knob.unit ? " " : "", knob.unit);
}

const KnobInfo& knob_named(const std::string& name)
{
    std::vector<std::string> names;
    for (const KnobInfo& knob : table) {
        if (name == knob.name || (!name.empty() && name == knob.old_name)) return knob;
        names.emplace_back(knob.name);
    }
    throw Error(fmt::format("fidelity.{}: There is no such knob{} There are: {}.", name, did_you_mean(name, names), all_names()));
}

void require_in_range(const KnobInfo& knob, double value)
{
    if (!(value >= knob.least && value <= knob.most) || (knob.whole && value != std::floor(value)))
        refuse(knob, fmt::format("{:g}", value));
}

double value_of(const KnobInfo& knob, const std::string& text)
{
    const auto word = std::find(knob.words.begin(), knob.words.end(), text);
    if (word != knob.words.end()) return static_cast<double>(word - knob.words.begin());
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto [last, failure] = std::from_chars(text.data(), end, value);
    if (failure != std::errc() || last != end || !knob.words.empty()) refuse(knob, "\"" + text + "\"");
    require_in_range(knob, value);
    return value;
}

std::string values_of(const KnobInfo& knob, const char* between)
{
    std::string text;
    for (double value : knob.at)
        text += (text.empty() ? "" : between) + (knob.words.empty() ? fmt::format("{:g}", value) : text_of(knob, value));
    return text;
}

void set_knob(KnobSettings& settings, const std::string& name, const std::string& text)
{
    const KnobInfo& knob = knob_named(name);
    settings[knob.name] = value_of(knob, text);
}

Knobs with_settings(Knobs knobs, const KnobSettings& settings)
{
    for (const auto& [name, value] : settings) {
        const KnobInfo& knob = knob_named(name);
        require_in_range(knob, value);
        knobs.*knob.value = value;
    }
    return knobs;
}

std::vector<const KnobInfo*> changed_knobs(const Knobs& before, const Knobs& after)
{
    std::vector<const KnobInfo*> changed;
    for (const KnobInfo& knob : table)
        if (before.*knob.value != after.*knob.value) changed.push_back(&knob);
    return changed;
}

} // namespace hygroloom
