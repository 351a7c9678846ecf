// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Everything a backend ever sees of a run: plain numbers and flat arrays in SI units.
#pragma once

#include "core/base/units.h"
#include "core/geometry/textile.h"
#include "core/physics/liquid.h"
#include "core/physics/sorption.h"
#include "core/plan/model_plan.h"
#include "core/scene/suction.h"

#include <optional>

namespace hygroloom {

constexpr double water_quantum = 0x1.0p-64; ///< kg; liquid passes from particles to yarns in whole quanta, so nothing is lost to rounding

/// What the moisture model needs to know of one type of yarn.
struct YarnParameters {
    double pore_area = 0;           ///< m2, of the section
    double fibre_area = 0;          ///< m2
    double fibre_radius = 0;        ///< m
    double fibre_density = 0;       ///< kg/m3
    double fibre_specific_heat = 0; ///< J/(kg K)
    double fibre_conductivity = 0;  ///< W/(m K)
    Isotherm isotherm;
    FibreDiffusivity diffusivity;
    double sorption_heat_scale = 1; ///< of the law of sorption heats
    double vapour_diffusivity = 0;  ///< m2/s in the pores, tortuosity included
    double open_vapour = 0;         ///< m4/s, diffusivity of vapour in air times the open cross-section beside a yarn
    bool absorbs = false;           ///< liquid through its skin
    double face_area = 0;           ///< m2 of one segment's skin that absorbs from drops
    double adhesion = 0;            ///< J/m2, work of adhesion
    double liquid_diffusivity = 0;  ///< where liquid flows by saturation: m2/s at saturation, tortuosity included; 0: does not wick
    double fall = 0;                ///< s, see PoreFlow
    double suction_radius = 0;      ///< m, pore radius / cos(contact angle): smaller sucks harder
    double intake_flux = 0;         ///< kg/(m2 s) through the skin of a dry yarn
    WettedPores on_face[2];         ///< where liquid flows by suction: of what lies at the bottom, and on top
    double flow_along = 0;          ///< m4/(Pa s), permeability times section over viscosity
    double face_conductance = 0;    ///< m3/(Pa s), from liquid on one segment's skin
    double initial_regain = 0;
    double resting_regain = 0; ///< in equilibrium with the climate: a segment that has it and no liquid is not visited
};

/// How a warp and a weft yarn touch at a crossing.
struct CrossingParameters {
    double liquid_conductance = 0; ///< kg/s for a unit difference of spreading potential
    double heat_conductance = 0;   ///< W/K
    double vapour_conductance = 0; ///< m3/s
    double warp_rise = 0;          ///< m, of the warp's centreline over the middle plane where it is up, or under it
    double weft_rise = 0;
    BetweenParameters between{}; ///< where liquid flows by suction
};

/// Air and liquid.
struct ClimateParameters {
    double temperature = 0;     ///< K, of the air at the start: what warmth counts from; the liquid's numbers are for it
    double air_warmth = 0;      ///< K, of the air over temperature
    double vapour = 0;          ///< kg/m3 far from the fabric
    double humidity = 0;        ///< 0..1
    double heat_transfer = 0;   ///< W/(m2 K), radiation included
    double mass_transfer = 0;   ///< m/s
    double air_speed = 0;       ///< m/s
    double radiation = 0;       ///< W/(m2 K), the part of heat_transfer that drops exchange, too
    FlowOfWarmLiquid flow;      ///< counted from temperature
    double surface_tension = 0; ///< N/m
    double viscosity = 0;       ///< Pa s
    double density = 0;         ///< kg/m3
};

/// Air over a face, or over both as one, at a place of a garment.
struct FaceAir {
    double air_warmth = 0;    ///< K, over the climate's temperature
    double vapour = 0;        ///< kg/m3
    double heat_transfer = 0; ///< W/(m2 K), radiation included
    double mass_transfer = 0; ///< m/s
};

/// The cloth's water and warmth at the start.
struct ClothStart {
    std::vector<double> liquid;  ///< kg per segment; empty: dry
    std::vector<double> between; ///< kg in the room of each crossing; empty: dry
    double film = 0;             ///< kg that stand on both faces, evenly
    double bound = 0;            ///< kg of the fibres' water at the start that was added for the experiment
    double warmth = 0;           ///< K, of the sample over the climate's temperature
    double humidity = -1;        ///< of its pores; less than 0: the climate's
};

/// The shape of one type of yarn as the liquid meets it.
struct ContactShape {
    double half_height = 0; ///< m, at a crossing
    double half_width = 0;  ///< m
    /// Per type it crosses before, type it crosses after and whether it changes sides between them (the order of YarnSystem::paths):
    /// height, slope, half height, half width of every sample from crossing to crossing.
    std::vector<float> profiles;
};

/// Panels of a garment in one cloth, each clipped to its outline. They lie one behind the other along the picks, so that a pick is of one
/// panel and an end goes through all of them in pieces. Segments outside all panels are not there: nothing visits them.
struct ClothPanels {
    int count = 0;                   ///< 0: the cloth is one whole rectangle, and all else here is empty
    std::vector<int> first, last;    ///< segments of each piece of a yarn, first to last - 1: all pieces of the warp, then all of the weft
    int warp_pieces = 0;             ///< how many of them
    std::vector<int> crossings;      ///< those that are there, in order
    std::vector<std::uint8_t> panel; ///< of each pick
    std::vector<double> cell_area;   ///< m2 of fabric per crossing of each panel
    std::vector<std::uint8_t> skin_on_top; ///< of each panel, whether its top face lies on the skin
    std::vector<std::uint8_t> air;         ///< of each crossing, its place in airs
    std::vector<FaceAir> airs;             ///< one for each fabric and gap to the skin
    // Pieces of one system that seams join are solved together, as chains of places.
    std::vector<int> order;      ///< segment of each place, chain after chain: all of the warp's, then all of the weft's
    std::vector<int> chain_ends; ///< past the last place of each chain
    int warp_chains = 0;         ///< how many are of the warp
    /// As SeamJoint, from each place to the next across a seam; less than 0: along the yarn. A chain whose last place has them is a ring:
    /// they lead to its first.
    std::vector<double> joint_yarns, joint_rooms;
    std::vector<float> rise;     ///< m, of each segment, by which the next one along its yarn lies higher
    std::vector<int> shown;      ///< crossings of each cell that frames show, cell after cell
    std::vector<int> shown_ends; ///< past the last crossing of each cell
};

/// Two places at the borders of panels that are sewn together.
struct SeamJoint {
    int a = 0, b = 0; ///< segments
    double yarns = 0; ///< m3/(Pa s), between their pores
    double rooms = 0; ///< m3/(Pa s), between the rooms of their crossings
};

/// Seams in groups in which no crossing comes twice: those of a group act at once.
struct ClothSeams {
    std::vector<SeamJoint> joints;
    std::vector<int> group_ends; ///< past the last joint of each group
};

/// Two crossings of layers that lie on each other. What passes between yarns passes half from warp to warp, half from weft to weft; what
/// passes from a room into yarns, half into each.
struct LayerJoint {
    int a = 0, b = 0;
    double yarns = 0;     ///< m3/(Pa s), where they touch
    double rooms = 0;     ///< m3/(Pa s), between the rooms of both
    double a_room_to = 0; ///< m3/(Pa s), from the room of a into the yarns of b
    double b_room_to = 0; ///< m3/(Pa s), from the room of b into the yarns of a
    double heat = 0;      ///< W/K
    double vapour = 0;    ///< m3/s
};

/// Layers in groups in which no crossing comes twice: those of a group act at once.
struct ClothLayers {
    std::vector<LayerJoint> joints;
    std::vector<int> group_ends; ///< past the last joint of each group
};

/// One patch of ends x picks: its yarns in segments, one from crossing to crossing, all of the warp's before all of the weft's.
struct Cloth {
    int ends = 0;
    int picks = 0;
    std::vector<double> length;   ///< m, one per segment
    std::vector<double> pores;    ///< m3, one per segment; empty: its yarn's pore area times its length
    std::vector<float> shift;     ///< m, of each segment's middle beside its yarn's place; empty: none
    std::vector<double> touching; ///< m3/(Pa s), from each segment to the one beside it; 0: apart; empty: no yarns touch
    /// Of the room at each segment's crossing, its permeability along the segment over that of its types: by its place in the weave. Empty:
    /// all are alike.
    std::vector<float> room_along;
    std::vector<std::uint8_t> warp_up;     ///< one per crossing, end x picks + pick
    std::vector<float> warp_up_share;      ///< of the crossings that each stands for; empty: each is one
    int threads_per_cell = 1;              ///< ends, and picks, that each stands for, about
    int shown_ends = 0, shown_picks = 0;   ///< cells in which frames show it; 0: each segment. At most as many as there are of each
    double cell_area = 0;                  ///< m2 of fabric per crossing
    double half_thickness = 0;             ///< m
    double warp_pitch = 0, weft_pitch = 0; ///< m, from end to end and from pick to pick
    int warp_types = 1;
    std::vector<YarnParameters> yarns;        ///< per type: the warp's, then the weft's
    std::vector<ContactShape> shapes;         ///< of the same types
    int profile_samples = 0;                  ///< of each of their profiles
    std::vector<CrossingParameters> crossing; ///< warp type x weft_types() + weft type
    std::vector<std::uint8_t> type;           ///< place in yarns of each end (in each panel in turn), then of each pick
    bool by_suction = false;                  ///< liquid flows by suctions, in yarns and between them, instead of by saturation in yarns
    bool face_only = false;                   ///< the sample's edge is closed to vapour and heat
    double swelling = 0;                      ///< m3 by which fibres grow per kg of water that they bind
    double gravity_along_warp = 0;            ///< m/s2 towards pick 0
    double gravity_along_weft = 0;            ///< m/s2 towards end 0
    ClothStart start;
    ClothPanels panels;
    ClothSeams seams;
    ClothLayers layers;

    int crossings() const { return ends * picks; }
    int segments() const { return 2 * crossings(); }
    /// m of a yarn of mean thickness that has as much fibre as a segment of it.
    double fibre_length(std::size_t segment, const YarnParameters& yarn) const
    {
        return pores.empty() ? length[segment] : pores[segment] / yarn.pore_area;
    }
    int weft_types() const { return static_cast<int>(yarns.size()) - warp_types; }
};

/// The air at a time; between two of them it changes evenly.
struct AirMoment {
    double time = 0;          ///< s
    double air_warmth = 0;    ///< K, over the climate's temperature
    double humidity = 0;      ///< 0..1
    double heat_transfer = 0; ///< W/(m2 K)
    double mass_transfer = 0; ///< m/s
    double air_speed = 0;     ///< m/s
};

/// Air and liquid at the start, and how the air changes.
struct SceneClimate : ClimateParameters {
    std::vector<AirMoment> course; ///< the first at 0 s; empty: constant
};
AirMoment air_at(const SceneClimate& climate, double time);
/// The air of a climate in a scene of this textile and experiment, from a time (s) on.
AirMoment air_of(const Climate& air, double time, const Textile& textile, const Experiment& experiment);

struct SceneDroplet {
    double time = 0;   ///< s
    double volume = 0; ///< m3
    Vec3d centre;      ///< m, from the cloth's middle
    double speed = 0;  ///< m/s, downwards
    double turn = 0;   ///< of the lattice that its particles begin on, about the vertical, 0 .. pi / 2
};

/// Liquid fed onto a face as one standing pool, which the yarns under it absorb.
struct ScenePool {
    double start = 0, end = 0; ///< s
    double rate = 0;           ///< m3/s
    bool top = true;
    double drop = 0;  ///< m3, in which it comes, each when the rate has delivered it; 0: evenly
    double least = 0; ///< m3: it covers at least the base of a half ball of so much, however little stands

    /// m3 that came until a time, s; a drop just after its own, at which a step ends.
    double delivered(double time) const;
    /// s: the next time after this at which it begins or ends or a drop comes; infinite where there is none.
    double next_change(double time) const;
};

/// How much a skin under the cloth sweats from a time on.
struct SweatMoment {
    double time = 0;   ///< s
    double factor = 1; ///< of SkinSupply::rate
};

/// A zone of the skin at a time; between two of them it changes evenly, two at one time are a jump.
struct SkinMoment {
    double time = 0;   ///< s
    double rate = 0;   ///< m/s
    double warmth = 0; ///< K, over the climate's temperature
};

/// What one of the panels' airs is mixed from.
struct SkinAir {
    std::size_t zone = 0;    ///< of SkinSupply::zones, to which its inner face looks
    double outer = 0;        ///< W/(m2 K), from the air outside
    double outer_warmth = 0; ///< K, of that air over the climate's temperature
    double to_skin = 0;      ///< W/(m2 K)

    double warmth(double of_skin) const { return (outer * outer_warmth + to_skin * of_skin) / (outer + to_skin); }
};

/// A skin that sweats onto the face that lies on it. What the cloth does not take stays on the skin, and what the skin does not hold drips.
struct SkinSupply {
    std::vector<double> rate;        ///< m/s (m3 of liquid per m2 and s) at each crossing; empty: there is no skin
    std::vector<SweatMoment> course; ///< the first at 0 s
    double holds = 0;                ///< m of liquid
    // Where zones change on their own; else all is empty.
    std::vector<std::vector<SkinMoment>> zones; ///< each with one moment at least
    std::vector<std::uint8_t> zone;             ///< of each crossing, its place in zones: then rate is that at the start
    std::vector<SkinAir> airs;                  ///< of each of the panels' airs; empty: the skin's warmth does not change

    double factor_at(double time) const;
    bool has_zones() const { return !zones.empty(); }
    SkinMoment zone_at(std::size_t zone, double time) const;
    /// As rate and ClothPanels::airs are at a time.
    std::vector<double> rates_at(double time) const;
    std::vector<FaceAir> airs_at(std::vector<FaceAir> airs, double time) const;
    /// m/s, the most that each crossing's skin ever sweats; with the course's factor.
    std::vector<double> most_rates() const;
    /// s: the next time after this at which the factor changes, or how a zone changes; infinite where there is none.
    double next_change(double time) const;
    /// Whether the factor or a zone jumps then.
    bool jumps_at(double time) const;
};

/// Liquid that comes to the cloth while the scene runs.
struct Supply {
    std::vector<SceneDroplet> droplets; ///< in order of time
    std::vector<ScenePool> pools;       ///< in the middle of the sample
    std::vector<std::uint8_t> fed;      ///< per segment, whether it hangs in liquid and stays full; empty: none does
    double sweat = 0;                   ///< m/s (m3 of liquid per m2 and s) fed to one face
    bool sweat_on_top = false;
    SkinSupply skin;
};

/// A smooth box, open at its top, with liquid inside; a plate if its sides are far away. It stands over the cloth.
struct SceneVessel {
    Vec3d low, high;     ///< m
    double adhesion = 0; ///< J/m2, work of adhesion
};

/// Whether drops stand on the cloth as caps with a contact line, not as particles, and the angles that they show on the upper face.
struct SceneCaps {
    bool on = false;
    double advancing = 0, receding = 0; ///< rad
};

/// Free liquid that is there from the start, and what holds it.
struct FreeLiquidStart {
    std::vector<Vec3d> places;     ///< m
    std::vector<Vec3d> velocities; ///< m/s
    double particle_volume = 0;    ///< m3; drops that come later are made of the same; 0 and no places: follows from the drops
    std::optional<SceneVessel> vessel;
    double gravity = gravity_acceleration; ///< m/s2, downwards, on the free liquid
};

/// Which parts of the physics are computed, how finely, and what frames show of it.
struct StepRules {
    bool wicking = true, sorption = true, vapour = true, heat = true;
    int particles_per_droplet = 0;
    int fibre_shells = 1;
    double network_step = 0;       ///< s, longest while drops are about
    double calm_network_step = 0;  ///< s, longest without drops; 0: the same
    double step_share = 0;         ///< longest without drops, as a share of the time so far; steps then have ends of their own, and frames
                                   ///< are taken beside them. 0: steps have no such limit, and end where frames are taken
    double rest_tolerance = 0;     ///< deviation from the air's humidity, or from its temperature in tens of kelvin, that counts as rest;
                                   ///< the visited region grows where there is more. 0: all of the sample is visited
    double step_error = 0;         ///< largest error of a step, over the water and the heat at stake; 0: not watched
    double saturation_change = 0;  ///< largest a step aims at, for the step's length
    int suction_rounds = 220;      ///< at most, for the suctions along a line where liquid flows by them
    bool whole_flow = false;       ///< whether warp and weft flow at once by suction, in one system of equations; else one after the other
    double suction_error = 1e-6;   ///< of what pores can hold: so much the suctions of all may then leave open; masses go by fluxes
    double liquid_step_factor = 1; ///< on the longest stable step of the free liquid
    int steps_between_absorption = 1; ///< of the free liquid, between times at which yarns absorb from it
    double density_tolerance = 0.01;
    bool double_precision = false; ///< of the free liquid's particles
    double settle_share = 0;       ///< of the free liquid at rest that yarns absorb before it settles anew; 0: it takes all its steps
    bool shows_shells = false;     ///< whether frames show the regain of each shell
    bool shows_pressure = false;   ///< whether frames show the free liquid's pressure
    bool shows_wet_sums = false;   ///< whether frames of a cloth that is shown in cells show what watched parts would find
    bool shows_segments = true;    ///< whether frames of a garment show its segments, too, not its cells alone
};

struct Scene {
    Cloth cloth;
    SceneClimate climate;
    Supply supply;
    FreeLiquidStart liquid;
    SceneCaps caps;
    StepRules rules;
};

/// Throw Error with a sentence where a part does not fit together.
void check(const Cloth& cloth);
void check(const SceneClimate& climate);
void check(const Supply& supply);
void check(const FreeLiquidStart& liquid);
void check(const StepRules& rules);
void check(const Scene& scene);

/// Switches parts on and off as the plan has them; nothing else of the scene, and nothing of its start, changes.
void set_parts(Scene& scene, const ModelPlan& plan);

/// Precondition: plan_model() made the plan for these.
Scene build_scene(const Design& design, const Textile& textile, const Experiment& experiment, const ModelPlan& plan, std::uint64_t seed);

} // namespace hygroloom
