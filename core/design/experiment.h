// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A laboratory experiment on a fabric.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace hygroloom {

constexpr double most_humidity = 2; ///< air may hold up to twice the vapour that saturates it; what is too much condenses on the cloth

struct Climate {
    double temperature_c = 25;
    double relative_humidity = 0.65; ///< 0..1, to most_humidity where the air is more than saturated
    double air_speed_m_s = 0.1;
    bool operator==(const Climate&) const = default;
};

/// The climate at one moment of a course; between moments it changes evenly.
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

/// What textile laboratories measure.
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
/// As the project file has it: "droplet", "moisture_management".
const char* name_of(ExperimentType type);

/// How liquid moves in the pores of the yarns.
enum class Closure {
    kissa,  ///< D = D0 s^2: spreading as Kissa measured it
    li_zhu, ///< D = D0 s^(1/3): pores of all radii, the small ones filled first (Li and Zhu 2003)
    paper   ///< the printed parameters of Mao et al. where they are stable
};
constexpr int closures = 3;
const char* name_of(Closure closure);

/// Only what its type has counts; the rest keeps its default.
struct Experiment {
    std::string name;
    ExperimentType type = ExperimentType::droplet;
    Climate climate;                     ///< at the start
    std::vector<ClimateMoment> climates; ///< later ones, in order of time
    std::string liquid = "water";
    Closure closure = Closure::kissa;
    bool swelling = false;                   ///< fibres that take up water narrow the pores between them
    std::array<double, 2> sample_mm{20, 20}; ///< along the weft, along the warp; of vertical_wicking across and along the strip
    double duration_s = 10;
    std::vector<Droplet> droplets{Droplet{}};
    double volume_ul = 200;          ///< moisture_management, horizontal_wicking
    double feed_s = 20;              ///< moisture_management: how long the pump runs
    double drop_ul = 0;              ///< moisture_management: volume of the drops that the feed falls in; 0: a pool that yarns drink from
    bool along_weft = false;         ///< vertical_wicking: the strip's long side
    double immersion_mm = 10;        ///< vertical_wicking: depth of the strip's end in the liquid
    double initial_water_g_m2 = 100; ///< drying
    Climate initial{20, 0, 0.1};     ///< conditioning: what the sample is in equilibrium with
    double rate_g_m2_h = 300;        ///< sweat
    bool from_top = false;           ///< sweat: the face that is fed; the skin is at the bottom
    bool operator==(const Experiment&) const = default;
};

/// With sample, duration and feed as the type's standard has them.
Experiment standard_experiment(ExperimentType type);

/// Along the weft and along the warp, whichever way a strip is cut.
std::array<double, 2> sample_extent_mm(const Experiment& experiment);

/// The most drops that one experiment may have.
constexpr int most_droplets = 64;
constexpr double fastest_droplet_m_s = 10; ///< raindrops reach 9

/// All drops that fall, of whichever type: those of droplet, or the feed of moisture_management in equal drops, evenly in time.
std::vector<Droplet> falling_drops(const Experiment& experiment);

Climate climate_at(const Experiment& experiment, double time_s);

} // namespace hygroloom
