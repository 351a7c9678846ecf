// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What trades speed for accuracy: four named points on one ladder, and the knobs behind them, each of which may also be set alone.
#pragma once

#include <array>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace hygroloom {

enum class Fidelity { live, draft, standard, reference };
/// From the fastest to the finest.
inline constexpr std::array all_fidelities{Fidelity::live, Fidelity::draft, Fidelity::standard, Fidelity::reference};

const char* name_of(Fidelity fidelity);
/// Throws Error naming the allowed words.
Fidelity fidelity_from_name(const std::string& name);

constexpr int largest_shell_count = 32;

/// A drop as particles that flow, or as a cap that stands with a contact line; automatic: as a cap where the scene allows it.
enum class DropModel { automatic, cap, particles };

/// Every knob's value. Those of a fidelity come from knobs_of().
struct Knobs {
    double particles_per_droplet = 0;    ///< at most; a quarter where no yarn absorbs and liquid may sleep, fewer in a tiny drop
    double fibre_shells = 0;             ///< radial cells in a fibre
    double crossings_per_cell = 0;       ///< ends, and picks, that are simulated as one; where free liquid meets single yarns none are
    double crossings_per_even_cell = 0;  ///< at least, where all of the cloth but its edges is alike
    double network_step_limit = 0;       ///< s, while free liquid is about
    double saturation_change = 0;        ///< that a network step aims at while free liquid or pools are about
    double step_error = 0;               ///< of a step without drops: part of the water and heat at stake that it may misplace
    double liquid_step_factor = 0;       ///< on the limits that flow, viscosity and surface waves set to a step of the liquid
    double steps_between_absorption = 0; ///< of the liquid: yarns absorb from drops in every Nth
    double density_tolerance = 0;        ///< of the pressure loop, fraction
    double settle_share = 0;             ///< of liquid at rest that yarns absorb before it settles anew; 0: it never rests
    double rest_tolerance = 0;           ///< of the air's humidity at the border of what is visited; 0: all of the sample is visited
    double double_precision = 0;         ///< of the liquid's particles: 0 no, 1 yes; the yarns always are
    double free_liquid = 0;              ///< how drops are modelled: see DropModel
    double room_voxels = 0;              ///< per yarn, of the room between yarns as it is drawn; 0: a formula in its place
    double neglected_share = 0;          ///< of the delivered water, or of the wicking rate, below which a part is left out
    bool operator==(const Knobs&) const = default;
};

/// One knob: its name, its values and its range.
struct KnobInfo {
    const char* name; ///< in files and in --set fidelity.<name>=…; with its unit where it has one
    double Knobs::*value;
    const char* unit; ///< "" for a plain number
    double at[4];     ///< at each of all_fidelities
    double least, most;
    bool whole;                ///< only whole numbers
    double cheaper, finer;     ///< one step from standard each, for tradeoff; its own if it is cheapest, two cheaper ones if it is finest
    const char* meaning;       ///< begins small, without a full stop
    const char* old_name = ""; ///< in files and commands of older versions, which is still read
    std::span<const char* const> words{}; ///< that stand for 0, 1, 2, …; empty: it is a number
};

/// All of them, in the order in which they are shown.
std::span<const KnobInfo> knob_table();

Knobs knobs_of(Fidelity fidelity);

/// What the user set: name -> value.
using KnobSettings = std::map<std::string, double>;

/// As people read a value: a word, or a number with its unit.
std::string text_of(const KnobInfo& knob, double value);
/// What a word or a number stands for. Throws Error naming the knob, its range and what was given.
double value_of(const KnobInfo& knob, const std::string& text);
/// Its values at each fidelity, without their unit.
std::string values_of(const KnobInfo& knob, const char* between = ", ");

/// The knob of this name. Throws Error naming the nearest one and all others.
const KnobInfo& knob_named(const std::string& name);
/// Throws Error naming the knob, its range and the value when the number lies outside or must be whole.
void require_in_range(const KnobInfo& knob, double value);
/// Takes up "fibre_shells" and "12". Throws Error as knob_named() and require_in_range() do, also when the text is no number.
void set_knob(KnobSettings& settings, const std::string& name, const std::string& value);

/// The fidelity's knobs with the settings on top. Throws Error as above.
Knobs with_settings(Knobs knobs, const KnobSettings& settings);

/// The knobs that differ.
std::vector<const KnobInfo*> changed_knobs(const Knobs& before, const Knobs& after);

} // namespace hygroloom
