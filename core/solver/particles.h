// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The free liquid of a running scene as particles: the tables of their arrays, and the cells in which neighbours are found.
#pragma once

#include "core/base/lanes.h"
#include "core/physics/particle_steps.h"
#include "core/solver/fields.h"

#include <cstdint>

namespace hygroloom::inline HL_PRECISION {

using Packs = Vec3T<Pack>;
HL_FN Vec3 sum_beside(const Packs& packs) { return {sum_beside(packs.x), sum_beside(packs.y), sum_beside(packs.z)}; }
HL_FN Vec3 sum_of(const Packs& packs) { return {sum_of(packs.x), sum_of(packs.y), sum_of(packs.z)}; }

constexpr int no_wall = -1;
constexpr int vessel_wall = -2;

/// What a particle has of the cloth round it: the share of the space that is yarn, up to a kernel's reach, and how it changes.
struct ClothField {
    Real share = 0;         ///< with the kernel of pressure
    Vec3 slope;             ///< 1/m
    Real surface_share = 0; ///< with the surface's kernel
    Vec3 surface_slope;     ///< 1/m
    Real bend[6] = {};      ///< 1/m2, second slopes of surface_share: xx, yy, zz, xy, yz, zx
    Vec3 adhesion;          ///< N/m3
};

/// What a particle had of the cloth where that was last summed up, and how it changes from there.
struct ClothExpansion {
    Vec3 at{Real(1e6), Real(1e6), Real(1e6)}; ///< far from all: not summed up yet
    ClothField field;
    Real slope_bend[6] = {};    ///< 1/m2, second slopes of share
    Real adhesion_bend[6] = {}; ///< N/m4

    HL_FN static Vec3 times(const Real (&m)[6], const Vec3& v)
    {
        return {m[0] * v.x + m[3] * v.y + m[5] * v.z, m[3] * v.x + m[1] * v.y + m[4] * v.z, m[5] * v.x + m[4] * v.y + m[2] * v.z};
    }
    HL_FN ClothField near(const Vec3& way) const
    {
        ClothField f = field;
        const Vec3 turned = times(slope_bend, way), surface_turned = times(field.bend, way);
        f.share += dot(field.slope + Real(0.5) * turned, way);
        f.slope += turned;
        f.surface_share += dot(field.surface_slope + Real(0.5) * surface_turned, way);
        f.surface_slope += surface_turned;
        f.adhesion += times(adhesion_bend, way);
        return f;
    }
};

/// How many elements an array of the particles has.
enum class ParticleCount {
    particles,        ///< those that there is room for
    packs,            ///< and a pack more, since whole packs are read; where no particle is, places are far from all
    near_slots,       ///< room for most_near of each
    distant_slots,    ///< room for most_distant of each
    vessel_particles, ///< all, where there is a vessel, else none
    shown_pressures   ///< all, where frames show the pressure, else none
};

/// What particles keep from step to step, in the order of their cells; sorting brings it to another side.
template <template <typename> typename Array> struct SortedFields {
    Array<Vec3> position{};
    Array<Vec3> velocity{};
    Array<Quad> place{};         ///< position, and the pressure that keeps the liquid from being pressed together
    Array<Vec3> wall_normal{};   ///< out of the nearest yarn or the vessel
    Array<Real> wall_distance{}; ///< to its skin, at least
    Array<int> wall_segment{};   ///< within half a spacing, or no_wall, or vessel_wall
    Array<Real> mirrored{};      ///< of the liquid that a vessel's wall stands for
    Array<Real> stress{};        ///< since the last frame, mean of the normal stresses
    Array<ClothExpansion> cloth_from{};
    Array<std::int64_t> content{}; ///< quanta of water it still holds

    /// The table: visit(field, the field's array of each state).
    template <typename Visit, typename... States> static constexpr void each(const Visit& visit, States&... of)
    {
        using Row = Field<ParticleCount>;
        using Count = ParticleCount;
        constexpr bool saved = true, shown = true;
        visit(Row{"position", "m", Count::particles, saved, shown}, of.position...);
        visit(Row{"velocity", "m/s", Count::particles, saved, shown}, of.velocity...);
        visit(Row{"place", "m, Pa", Count::packs, saved}, of.place...);
        visit(Row{"wall_normal", "1", Count::particles, saved}, of.wall_normal...);
        visit(Row{"wall_distance", "m", Count::particles, saved}, of.wall_distance...);
        visit(Row{"wall_segment", "1", Count::particles, saved}, of.wall_segment...);
        visit(Row{"mirrored", "Pa", Count::vessel_particles, saved}, of.mirrored...);
        visit(Row{"stress", "Pa s", Count::shown_pressures, saved}, of.stress...);
        visit(Row{"cloth_from", "1/m, N/m3", Count::particles, saved}, of.cloth_from...);
        visit(Row{"content", "2^-64 kg", Count::particles, saved, shown}, of.content...);
    }
};

/// All arrays of the particles: those that are sorted, and what each step finds anew.
template <template <typename> typename Array> struct ParticleFields : SortedFields<Array> {
    Array<std::uint8_t> alive{};
    // What neighbours read.
    Array<Quad> motion{};         ///< velocity, and size
    Array<Quad> standing{};       ///< position, and size
    Array<Quad> predicted{};      ///< position at the step's end, so far, and size
    Array<Quad> surface{};        ///< tilt (Pa m) and pull (Pa) of the surface's energy: see SurfaceEnergy
    Array<Vec3> force{};          ///< acceleration by all but pressure
    Array<Vec3> pressure_force{}; ///< acceleration
    Array<Real> allowed{};        ///< over the rest density, that this step need not correct
    Array<ClothField> cloth{};
    // Neighbours are listed for several steps, with a skin beyond where they count, and particles keep their order that long. Lists are
    // whole packs, filled up with the one that is far away.
    Array<int> near{};          ///< within the support and the skin
    Array<int> distant{};       ///< the others
    Array<int> near_first{};    ///< pack with which each begins on a CPU: close behind another, which is quicker to go through
    Array<int> distant_first{}; ///< the same of the others
    Array<int> near_count{};    ///< slots in use, whole packs
    Array<int> distant_count{}; ///< slots in use, whole packs
    Array<Real> slope{};        ///< of near pairs, this step: the kernel's over SplineUnits::slope and the distance, times the size
    Array<Real> listed_x{}, listed_y{},
        listed_z{}; ///< where particles were when neighbours were listed; axes apart, so packs are read as they lie

    /// The table: visit(field, the field's array of each state).
    template <typename Visit, typename... States> static constexpr void each(const Visit& visit, States&... of)
    {
        using Row = Field<ParticleCount>;
        using Count = ParticleCount;
        constexpr bool saved = true, shown = true;
        SortedFields<Array>::each(visit, of...);
        visit(Row{"alive", "1", Count::particles, saved, shown}, of.alive...);
        visit(Row{"motion", "m/s, 1", Count::packs}, of.motion...);
        visit(Row{"standing", "m, 1", Count::packs}, of.standing...);
        visit(Row{"predicted", "m, 1", Count::packs}, of.predicted...);
        visit(Row{"surface", "Pa m, Pa", Count::packs}, of.surface...);
        visit(Row{"force", "m/s2", Count::particles}, of.force...);
        visit(Row{"pressure_force", "m/s2", Count::particles}, of.pressure_force...);
        visit(Row{"allowed", "kg/m3", Count::particles}, of.allowed...);
        visit(Row{"cloth", "1/m, N/m3", Count::particles}, of.cloth...);
        visit(Row{"near", "1", Count::near_slots}, of.near...);
        visit(Row{"distant", "1", Count::distant_slots}, of.distant...);
        visit(Row{"near_first", "1", Count::particles}, of.near_first...);
        visit(Row{"distant_first", "1", Count::particles}, of.distant_first...);
        visit(Row{"near_count", "1", Count::particles}, of.near_count...);
        visit(Row{"distant_count", "1", Count::particles}, of.distant_count...);
        visit(Row{"slope", "1", Count::near_slots}, of.slope...);
        visit(Row{"listed_x", "m", Count::packs}, of.listed_x...);
        visit(Row{"listed_y", "m", Count::packs}, of.listed_y...);
        visit(Row{"listed_z", "m", Count::packs}, of.listed_z...);
    }
};

/// The particles as stages see them; arrays that the scene does not have are null.
struct Particles : ParticleFields<Pointer> {
    int room = 0;         ///< number of particles that fit; behind them is a place that is far from all
    Real mass = 0;        ///< kg, of each that is full
    Real per_quantum = 0; ///< of its mass
    Real support = 0;     ///< m, of the kernel of pressure and viscosity
    Real reach = 0;       ///< m, of the kernel of the surface; neighbours are listed and walls are felt up to it
    Real spacing = 0;     ///< m

    /// How full it is, and so how large: yarns absorb from it, and it shrinks.
    HL_FN Real size(int i) const { return static_cast<Real>(content[i]) * per_quantum; }
    /// Whether a vessel's wall is near.
    HL_FN bool at_wall(int i) const { return wall_segment[i] == vessel_wall; }
};

/// Where sorting brings particles in another order.
struct SortedParticles : SortedFields<Pointer> {
    /// The particles there; what has no order between steps is the same.
    HL_FN Particles of(Particles p) const
    {
        static_cast<SortedFields<Pointer>&>(p) = *this;
        return p;
    }
};

/// Where no particle is. Lists are filled up with a place that stands there.
HL_FN Quad far_away() { return {Real(1e6), Real(1e6), Real(1e6), 0}; }

constexpr int usual_near = 64, usual_distant = 112; // at most, at rest and with a skin

/// A box that holds liquid, wide open at its top; a plate if its sides are far away.
struct Vessel {
    bool present = false;
    Vec3 low, high;
    Real wetting = 0; ///< cosine of the contact angle
};

/// Cells are narrower along x by this factor: particles of a row of cells lie side by side, and at its ends fewer are looked at in vain.
constexpr int narrower = 2;

/// Cells of half the surface's reach, for finding neighbours: a box of them about the particles. What is outside the whole space that
/// liquid may be in counts to its border.
struct CellGrid {
    Vec3 origin;                               ///< of the whole space
    Real size = 0, per_size = 0;               ///< m and 1/m, of a cell along y and z
    int whole_x = 0, whole_y = 0, whole_z = 0; ///< cells of the whole space
    int shift = 0;                             ///< cells are 2^shift times as wide, where particles lie far apart
    int first_x = 0, first_y = 0, first_z = 0; ///< of the box
    int nx = 0, ny = 0, nz = 0;                ///< its cells
    int* key = nullptr;                        ///< per particle
    int* start = nullptr;                      ///< per cell, first particle; count of cells + 1

    HL_FN int cells() const { return nx * ny * nz; }
    HL_FN static int whole(Real cell, int count) { return cell > 0 ? cell < Real(count) ? static_cast<int>(cell) : count - 1 : 0; }
    HL_FN int inside(int cell, int count) const { return cell < 0 ? 0 : cell < count ? cell : count - 1; }
    /// How far from a cell a place is along an axis, seen from the whole space's origin; a little less, for roundings. A cell at the
    /// border has no end there.
    HL_FN Real gap(Real place, int cell, int whole_count) const
    {
        const int first = cell << shift, end = first + (1 << shift);
        const Real below = first > 0 ? Real(first) * size - place : Real(0), above = end < whole_count ? place - Real(end) * size : Real(0);
        const Real most = below > above ? below : above;
        return positive(most - Real(0.01) * size);
    }
    HL_FN int whole_at_x(Real x) const { return whole((x - origin.x) * (narrower * per_size), whole_x); }
    HL_FN int whole_at_y(Real y) const { return whole((y - origin.y) * per_size, whole_y); }
    HL_FN int whole_at_z(Real z) const { return whole((z - origin.z) * per_size, whole_z); }
    HL_FN int cell_x(Real x) const { return (whole_at_x(x) >> shift) - first_x; }
    HL_FN int cell_y(Real y) const { return (whole_at_y(y) >> shift) - first_y; }
    HL_FN int cell_z(Real z) const { return (whole_at_z(z) >> shift) - first_z; }
};

} // namespace hygroloom::inline HL_PRECISION
