// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/plan/fidelity.h"

#include "core/base/error.h"
#include "core/project/json_reader.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace hygroloom {
namespace {

// clang-format off
constexpr KnobInfo table[] = {
    {"particles_per_droplet", &Knobs::particles_per_droplet, "", 8, 1e6, true, 4000, 16000,
     "particles of one drop, at most; a quarter where no yarn drinks and liquid may sleep, fewer in a tiny drop"},
    {"fibre_shells", &Knobs::fibre_shells, "", 1, largest_shell_count, true, 5, 12,
     "radial cells in a fibre"},
    {"crossings_per_cell", &Knobs::crossings_per_cell, "", 1, 8, true, 4, 2,
     "ends, and picks, that are simulated as one bundle; 1 where free liquid, sweat or fine stripes need single yarns"},
    {"crossings_per_even_cell", &Knobs::crossings_per_even_cell, "", 1, 8, true, 8, 2,
     "the same, at least, where all of the cloth but its edges is alike: drying, conditioning"},
    {"network_step_limit_s", &Knobs::network_step_limit, "s", 1e-5, 1, false, 10e-3, 2.5e-3,
     "longest step of the yarns while free liquid is about"},
    {"saturation_change", &Knobs::saturation_change, "", 1e-3, 1, false, 0.2, 0.05,
     "change of saturation that a step of the yarns aims at while free liquid or pools are about"},
    {"step_error", &Knobs::step_error, "", 1e-7, 0.1, false, 1e-3, 2.5e-4,
     "share of the water and heat at stake that a step without free liquid may misplace"},
    {"liquid_step_factor", &Knobs::liquid_step_factor, "", 0.1, 1, false, 1, 0.5,
     "step of the free liquid over the longest that flow, viscosity and surface waves allow"},
    {"steps_between_drinks", &Knobs::steps_between_drinks, "", 1, 64, true, 16, 4,
     "steps of the free liquid in which yarns drink from it once"},
    {"density_tolerance", &Knobs::density_tolerance, "", 1e-4, 0.2, false, 0.02, 0.005,
     "mean error of the liquid's density at which its pressure is found well enough"},
    {"settle_share", &Knobs::settle_share, "", 0, 0.5, false, 0.02, 0.005,
     "share of liquid at rest that yarns drink before it settles anew; 0: it never sleeps"},
    {"rest_tolerance", &Knobs::rest_tolerance, "", 0, 0.1, false, 1e-3, 1e-5,
     "change of the air's humidity at which the visited region grows; 0: all of the sample is visited"},
    {"double_precision", &Knobs::double_precision, "", 0, 1, true, 0, 1,
     "whether the liquid's particles are in double precision, 0 or 1; such a run goes to a CPU"},
    {"neglected_share", &Knobs::neglected_share, "", 0, 0.5, false, 0.01, 0,
     "share of the water, or of a rate, below which a part of the physics is left out"},
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
    throw Error(fmt::format("fidelity.{}: It must be {} from {:g} to {:g}{}{}; {} was given.", knob.name,
                            knob.whole ? "a whole number" : "a number", knob.least, knob.most, *knob.unit ? " " : "", knob.unit, given));
}

} // namespace

const char* name_of(Fidelity fidelity)
{
    constexpr const char* names[] = {"draft", "standard", "reference"};
    return names[static_cast<int>(fidelity)];
}

Fidelity fidelity_from_name(const std::string& name)
{
    for (Fidelity f : {Fidelity::draft, Fidelity::standard, Fidelity::reference})
        if (name == name_of(f)) return f;
    throw Error("The fidelity must be draft, standard or reference; \"" + name + "\" was given.");
}

std::span<const KnobInfo> knob_table() { return table; }

/// Points on the ladder of fidelities; each value stands here once, in the order of Knobs.
Knobs knobs_of(Fidelity fidelity)
{
    switch (fidelity) {
    case Fidelity::draft: return {2000, 5, 1, 8, 20e-3, 0.2, 2e-3, 1, 8, 0.02, 0.03, 1e-3, 0, 0.01};
    case Fidelity::standard: return {8000, 8, 1, 8, 5e-3, 0.1, 5e-4, 1, 8, 0.01, 0.01, 1e-4, 0, 0.001};
    case Fidelity::reference: return {8000, 16, 1, 1, 1e-3, 0.03, 1e-4, 1, 1, 0.01, 0.0, 1e-6, 0, 0.0};
    }
    return {};
}

const KnobInfo& knob_named(const std::string& name)
{
    std::vector<std::string> names;
    for (const KnobInfo& knob : table) {
        if (name == knob.name) return knob;
        names.emplace_back(knob.name);
    }
    const std::string near = nearest_word(name, names);
    throw Error(fmt::format("fidelity.{}: There is no such knob{} There are: {}.", name,
                            near.empty() ? "." : fmt::format("; did you mean \"{}\"?", near), all_names()));
}

void require_in_range(const KnobInfo& knob, double value)
{
    if (!(value >= knob.least && value <= knob.most) || (knob.whole && value != std::floor(value)))
        refuse(knob, fmt::format("{:g}", value));
}

void set_knob(KnobSettings& settings, const std::string& name, const std::string& text)
{
    const KnobInfo& knob = knob_named(name);
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto [last, failure] = std::from_chars(text.data(), end, value);
    if (failure != std::errc() || last != end) refuse(knob, "\"" + text + "\"");
    require_in_range(knob, value);
    settings[name] = value;
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
