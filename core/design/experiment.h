// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A laboratory experiment on a fabric, and the table of the types there are.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace hygroloom {

constexpr double most_humidity = 2; ///< air may hold up to twice the vapour that saturates it; the excess condenses on the cloth

struct Climate {
    double temperature_c = 25;
    double relative_humidity = 0.65; ///< 0..1, to most_humidity where the air is more than saturated
    double air_speed_m_s = 0.1;
    bool operator==(const Climate&) const = default;
};

/// The climate at one time of a course; between two times it changes linearly.
struct ClimateMoment {
    double time_s = 0;
    Climate climate;
    bool operator==(const ClimateMoment&) const = default;
};

struct Droplet {
    double volume_ul = 15;
    double time_s = 0;
    std::array<double, 2> at_mm{0, 0}; ///< from the sample's centre: along the weft, along the warp
    double height_mm = 2;              ///< of the drop's lowest point over the fabric
    double speed_m_s = 0;              ///< downwards, when it appears
    bool operator==(const Droplet&) const = default;
};

/// What textile laboratories measure. What is known of each stands in the table: see info_of().
enum class ExperimentType {
    droplet,             ///< drops fall on the cloth; AATCC 79
    moisture_management, ///< a feed on the top face between sensors; AATCC 195
    vertical_wicking,    ///< a strip hangs in the liquid; AATCC 197
    horizontal_wicking,  ///< a volume on a flat sample; AATCC 198
    drying,              ///< a wet sample dries; AATCC 199 and 201
    conditioning,        ///< a step from one climate to another; after ISO 139
    sweat                ///< one face is fed evenly
};
constexpr int experiment_types = 7;

/// How liquid moves in the pores of the yarns.
enum class Closure {
    paper, ///< the printed parameters of Mao et al. where they are stable
    pores  ///< in yarns and between them, with threshold, residual and hysteresis (physics/pores.h)
};
constexpr int closures = 2;
const char* name_of(Closure closure);

/// Fields that its type does not use keep their defaults.
struct Experiment {
    std::string name;
    ExperimentType type = ExperimentType::droplet;
    Climate climate;                     ///< at the start
    std::vector<ClimateMoment> climates; ///< later ones, in order of time
    std::string liquid = "water";
    Closure closure = Closure::pores;
    bool swelling = false;                   ///< fibres that take up water grow, into the room between yarns and into the pores
    std::array<double, 2> sample_mm{20, 20}; ///< along the weft, along the warp; of vertical_wicking across and along the strip
    double duration_s = 10;
    std::vector<Droplet> droplets{Droplet{}};
    double volume_ul = 200;          ///< moisture_management, horizontal_wicking
    double feed_s = 20;              ///< moisture_management: how long the pump runs
    double drop_ul = 0;              ///< moisture_management: largest volume of a drop that the feed comes in; 0: it flows evenly
    bool along_weft = false;         ///< vertical_wicking: the strip's long side
    double immersion_mm = 10;        ///< vertical_wicking: depth of the strip's end in the liquid
    double initial_water_g_m2 = 100; ///< drying
    Climate initial{20, 0, 0.1};     ///< conditioning: what the sample is in equilibrium with
    double rate_g_m2_h = 300;        ///< sweat
    bool from_top = false;           ///< sweat: the face that is fed; the skin is at the bottom
    bool operator==(const Experiment&) const = default;
};

/// How the water of an experiment comes to the cloth.
enum class WaterSource {
    drops, ///< free drops fall
    pool,  ///< a feed on the middle of the cloth
    bath,  ///< one end of a strip hangs in the liquid
    cloth, ///< the cloth is wet at the start
    air,   ///< vapour alone
    face   ///< one face is fed evenly
};

/// A row of the table of types. Reading, writing and validating follow from it.
struct ExperimentTypeInfo {
    const char* key;      ///< in the project file
    const char* title;    ///< "Vertical wicking"
    const char* standard; ///< the test method it follows, "AATCC 197"; empty: none
    WaterSource source;
    Experiment usual;                ///< climate, liquid, sample, feed and duration of the standard
    std::vector<const char*> fields; ///< keys of the project file that only some types have, in its order: rows, droplets, initial
    bool has_usual_duration = true;  ///< otherwise the project file must give one
    const char* sample_key = "sample_mm";
};

const ExperimentTypeInfo& info_of(ExperimentType type);
/// As in the project file: "droplet", "moisture_management".
inline const char* name_of(ExperimentType type) { return info_of(type).key; }
/// Whether the type uses a field, by its key in the project file.
bool uses_field(ExperimentType type, std::string_view key);

/// Whether the liquid wets the middle of the cloth and leaves a stain.
bool wets_a_spot(ExperimentType type);
/// Whether all of the cloth changes from the start.
bool changes_everywhere(ExperimentType type);
/// Whether all of the cloth but its edges stays alike.
bool stays_uniform(ExperimentType type);
/// Whether the cloth is wet at the start.
bool starts_wet(ExperimentType type);
/// Whether the sample is a strip that hangs in the liquid.
bool is_strip(ExperimentType type);

/// With sample, duration and feed of the type's standard.
Experiment standard_experiment(ExperimentType type);

/// Along the weft and along the warp, for either direction of a strip.
std::array<double, 2> sample_extent_mm(const Experiment& experiment);

/// The most drops that one experiment may have.
constexpr int most_droplets = 64;
constexpr int most_drops_of_feed = 4000;
constexpr double fastest_droplet_m_s = 10; ///< raindrops reach 9

/// All drops that fall.
std::vector<Droplet> falling_drops(const Experiment& experiment);
/// The equal drops that a feed comes in, each when the pump has delivered it, the last when it stops. 0: it flows evenly.
int drops_of_feed(const Experiment& experiment);
/// What hangs from a tube before it falls, by its weight and the liquid's surface (Tate 1864): 15 to 50 ul from tubes of 1 to 3 mm.
constexpr double hanging_drop_ul = 25;

Climate climate_at(const Experiment& experiment, double time_s);

} // namespace hygroloom
