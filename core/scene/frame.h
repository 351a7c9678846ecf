// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a simulation shows of itself at one moment. Frames are values: nothing in them points back into the solver.
#pragma once

#include "core/base/portable.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace hygroloom {

/// Where all water is, in kg, and what has happened to energy, in J, since the start.
struct Ledger {
    double time = 0;             ///< s
    double water_initial = 0;    ///< in fibres and pores before the first drop
    double water_delivered = 0;  ///< by drops
    double water_free = 0;       ///< liquid outside the yarns
    double water_liquid = 0;     ///< liquid in the yarns' pores
    double water_bound = 0;      ///< in the fibres
    double water_vapour = 0;     ///< in the yarns' pores
    double water_evaporated = 0; ///< to the air, net
    double water_dripped = 0;    ///< fallen off
    double energy_stored = 0;    ///< sensible heat over the climate's temperature
    double energy_released = 0;  ///< by sorption and condensation, less evaporation
    double energy_lost = 0;      ///< to the air, and with water that left
    double energy_delivered = 0; ///< with water that came
    double free_until = -1;      ///< s, when liquid last stood on the cloth; less than 0: not known

    double water_imbalance() const
    {
        return water_initial + water_delivered - water_free - water_liquid - water_bound - water_vapour - water_evaporated - water_dripped;
    }
    double energy_imbalance() const { return energy_stored - energy_released - energy_delivered + energy_lost; }
};

/// A number of the ledger, by the name that recordings have for it; the name ends in the unit. New ones stand at the end: older
/// recordings lack them.
struct LedgerColumn {
    const char* name;
    double Ledger::*value;
};
inline constexpr LedgerColumn ledger_columns[] = {
    {"time_s", &Ledger::time},
    {"water_initial_kg", &Ledger::water_initial},
    {"water_delivered_kg", &Ledger::water_delivered},
    {"water_free_kg", &Ledger::water_free},
    {"water_liquid_kg", &Ledger::water_liquid},
    {"water_bound_kg", &Ledger::water_bound},
    {"water_vapour_kg", &Ledger::water_vapour},
    {"water_evaporated_kg", &Ledger::water_evaporated},
    {"water_dripped_kg", &Ledger::water_dripped},
    {"energy_stored_j", &Ledger::energy_stored},
    {"energy_released_j", &Ledger::energy_released},
    {"energy_lost_j", &Ledger::energy_lost},
    {"energy_delivered_j", &Ledger::energy_delivered},
    {"free_until_s", &Ledger::free_until},
};

/// What a cell of a garment holds: sums over its crossings, made where the segments are.
struct CellSums {
    double top = 0, bottom = 0; ///< kg of liquid and bound water over the start, on each face
    double liquid = 0, bound = 0, vapour = 0;
    double evaporated = 0;                     ///< kg, since the start
    double on_skin = 0;                        ///< kg, under it
    double warmth = 0;                         ///< K over the climate's temperature, mean of its segments
    double stored = 0, released = 0, lost = 0; ///< J, as in the ledger
};

/// What parts that are left out would find in a cloth that is shown in cells: see PartWatch.
struct WetSums {
    double faces = 0;               ///< segments, each by wet_share() of its saturation, as fibres' surfaces count
    double thirst = 0;              ///< kg that the fibres in these can take up in all: see thirst_of()
    double warming = 0;             ///< K, most of a segment whose fibres have taken liquid: see warming_of()
    double warming_from_vapour = 0; ///< K, the same of vapour

    HL_FN void add(const WetSums& more)
    {
        faces += more.faces;
        thirst += more.thirst;
        if (more.warming > warming) warming = more.warming;
        if (more.warming_from_vapour > warming_from_vapour) warming_from_vapour = more.warming_from_vapour;
    }
};

/// A segment counts as wet when liquid fills at least this share of its pores.
constexpr double wet_saturation = 0.05;

/// The wet segments on the faces of one end, top and bottom, where frames show cells: its crossings by their number, sums by how many picks
/// they lie from the first.
struct WetEnd {
    float first[2] = {-1, -1}; ///< less than 0: none is wet
    float last[2] = {-1, -1};
    float count[2] = {0, 0};
    float places[2] = {0, 0};
    float squares[2] = {0, 0};
};
constexpr std::size_t wet_numbers = sizeof(WetEnd) / sizeof(float); ///< of each

/// A drop that stands as a cap, or falls as a ball, m.
struct FrameCap {
    double x = 0, y = 0; ///< from the cloth's middle
    double base = 0;     ///< radius of the face under it; 0: it falls
    double face = 0;     ///< height of the upper face over the middle plane
    double height = 0;   ///< of its top over that face
    double volume = 0;   ///< m3
};

struct Frame {
    double time = 0;           ///< s
    double unsolved_lines = 0; ///< how often the suctions along a yarn were not found, since the start: see PoreRounds
    // One value per segment, in the textile's order.
    std::vector<float> saturation;                    ///< liquid volume / pore volume
    std::vector<float> liquid;                        ///< kg, with its share of that between the yarns
    std::vector<float> regain;                        ///< bound water / dry fibre
    std::vector<float> vapour;                        ///< kg/m3; where it is not modelled as it began, saturated at most
    std::vector<float> temperature;                   ///< K
    std::vector<float> between;                       ///< kg of it between the yarns
    std::map<std::string, std::vector<float>> others; ///< of frame fields without a member here, by their name
    std::vector<float> shells;   ///< regain of every shell of every segment, from the inside; empty unless the scene asks
    std::vector<CellSums> cells; ///< of a garment: see ClothPanels::shown
    std::vector<WetEnd> wet;     ///< of each end as it is simulated, where the cloth is shown in cells (see Cloth::shown_ends); else empty
    int wet_picks = 0;           ///< that are simulated
    WetSums wet_sums;            ///< where the scene asks and the cloth is shown in cells
    // Free liquid.
    std::vector<std::array<float, 3>> positions;  ///< m
    std::vector<std::array<float, 3>> velocities; ///< m/s
    std::vector<float> pressures; ///< Pa, mean since the last frame, by all forces between particles; empty unless the scene asks
    std::vector<FrameCap> caps;   ///< instead of particles
    Ledger ledger;
    // Totals of each face, kg: water over the start in segments that lie on top and at the bottom.
    double water_top = 0;
    double water_bottom = 0;

    void resize_fields(std::size_t segments);
    void round_fields(); ///< see rounded()
};

/// A value that frames show of every segment, by the name that recordings have for it.
struct FrameField {
    const char* name;
    std::vector<float> Frame::*values; ///< none: Frame::others has it
    const char* unit;
    bool is_amount;                ///< of a bundle of yarns the sum is shared out among them; of all else each has the bundle's
    const char* shows = nullptr;   ///< the solver's field of segments that it is a copy of; none: its formula stands in frame_of()
    std::optional<float> absent{}; ///< its value in scenes without that field and in recordings made before it; none: all have it
    float step = 0;                ///< runs show whole multiples of it; 0: they may show less. See rounded()
    int bits = 13;                 ///< and so many significant bits; 0: all

    std::vector<float>& in(Frame& frame) const { return values ? frame.*values : frame.others[name]; }
    const std::vector<float>& in(const Frame& frame) const { return values ? frame.*values : frame.others.at(name); }
};
inline constexpr FrameField frame_fields[] = {
    {"saturation", &Frame::saturation, "1", false, nullptr, {}, 1.0F / 4096, 0},
    {"liquid", &Frame::liquid, "kg", true, nullptr, {}, 0x1p-54F}, // 6e-17 kg: a ball 0.5 µm wide
    {"bound_water", &Frame::regain, "kg/kg", false, nullptr, {}, 0, 14},
    {"vapour_concentration", &Frame::vapour, "kg/m3", false, nullptr, {}, 0, 11},
    {"temperature", &Frame::temperature, "K", false, nullptr, {}, 1.0F / 512, 0},
    {"liquid_between", &Frame::between, "kg", true, nullptr, 0.0F, 0, 12},
};

/// The value as runs show it: to its field's step, and to one part in 8 000 with 13 bits. A recording packs such values to half their size,
/// and what is measured while a run goes on is what is measured from its recording.
inline float rounded(const FrameField& field, float value)
{
    constexpr std::int32_t float_bits = 24; // of which larger multiples have none that are less than a step
    if (field.step > 0 && (field.bits == 0 || value < field.step * (1 << float_bits)))
        value = static_cast<float>(static_cast<int>(value / field.step + 0.5F)) * field.step; // none is less than 0
    if (field.bits == 0) return value;
    const int dropped = float_bits - field.bits;
    const auto bits = std::bit_cast<std::uint32_t>(value) + (1U << (dropped - 1));
    return std::bit_cast<float>(bits & ~((1U << dropped) - 1));
}

inline void Frame::round_fields()
{
    for (const FrameField& field : frame_fields)
        for (float& value : field.in(*this)) value = rounded(field, value);
}

inline void Frame::resize_fields(std::size_t segments)
{
    for (const FrameField& field : frame_fields) field.in(*this).resize(segments);
}

} // namespace hygroloom
