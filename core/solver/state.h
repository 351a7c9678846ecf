// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Views of a running scene's arrays: pointers and counts, on whichever machine holds them. A stage is a functor over such views.
#pragma once

#include "core/base/lanes.h"
#include "core/physics/particle_steps.h"
#include "core/scene/scene.h"

namespace hygroloom::inline HL_PRECISION {

using Packs = Vec3T<Pack>;
HL_FN Vec3 sum_beside(const Packs& packs) { return {sum_beside(packs.x), sum_beside(packs.y), sum_beside(packs.z)}; }
HL_FN Vec3 sum_of(const Packs& packs) { return {sum_of(packs.x), sum_of(packs.y), sum_of(packs.z)}; }

/// Threads at the sample's sides that a step leaves out, because nothing happens there yet.
struct Unvisited {
    int ends_before = 0, ends_after = 0;
    int picks_before = 0, picks_after = 0;

    HL_FN bool any() const { return ends_before + ends_after + picks_before + picks_after > 0; }
};

/// One yarn's segments that a step visits: first to last - 1.
struct YarnLine {
    const YarnParameters& yarn;
    int first;
    int last;
    bool is_warp;
    bool starts, stops; ///< whether the yarn's own start and end are among them
};

struct Crossing {
    int end, pick;
};

/// The cloth's yarns: lines of segments, all ends, then all picks. A yarn is of one type along its whole length.
/// Stages go through the visited lines, crossings and segments by an index of their own.
struct Yarns {
    int ends = 0;
    int picks = 0;
    int warp_types = 1;
    int weft_types = 1;
    const std::uint8_t* type = nullptr;           ///< of each line
    const YarnParameters* parameters = nullptr;   ///< per type: the warp's, then the weft's
    const CrossingParameters* crossing = nullptr; ///< warp type x weft_types + weft type
    Unvisited unvisited;

    HL_FN int crossings() const { return ends * picks; }
    HL_FN int visited_ends() const { return ends - unvisited.ends_before - unvisited.ends_after; }
    HL_FN int visited_picks() const { return picks - unvisited.picks_before - unvisited.picks_after; }
    HL_FN int visited_lines() const { return visited_ends() + visited_picks(); }
    HL_FN int visited_crossings() const { return visited_ends() * visited_picks(); }
    HL_FN int visited_segments() const { return 2 * visited_crossings(); }
    HL_FN bool is_warp(int segment) const { return segment < crossings(); }
    HL_FN int line_of(int segment) const { return is_warp(segment) ? segment / picks : ends + (segment - crossings()) / ends; }
    HL_FN int type_of_end(int end) const { return type[end]; }
    HL_FN int type_of_pick(int pick) const { return type[ends + pick]; }
    HL_FN const YarnParameters& yarn_of(int segment) const { return parameters[type[line_of(segment)]]; }
    HL_FN const CrossingParameters& crossing_at(int end, int pick) const
    {
        return crossing[type_of_end(end) * weft_types + type_of_pick(pick) - warp_types];
    }
    HL_FN YarnLine visited_line(int index) const
    {
        const Unvisited& out = unvisited;
        if (index < visited_ends()) {
            const int end = out.ends_before + index, first = end * picks;
            return {parameters[type[end]], first + out.picks_before, first + picks - out.picks_after, true,
                    out.picks_before == 0, out.picks_after == 0};
        }
        const int pick = out.picks_before + index - visited_ends(), first = crossings() + pick * ends;
        return {parameters[type[ends + pick]], first + out.ends_before, first + ends - out.ends_after, false,
                out.ends_before == 0,          out.ends_after == 0};
    }
    /// Crossings are visited in strips of some ends, so that those side by side in the order lie side by side along picks, too.
    HL_FN Crossing visited_place(int index) const
    {
        constexpr int strip = 8;
        const int height = visited_picks(), first = index / (strip * height) * strip;
        const int width = visited_ends() - first < strip ? visited_ends() - first : strip, place = index - first * height;
        return {unvisited.ends_before + first + place % width, unvisited.picks_before + place / width};
    }
    HL_FN int visited_crossing(int index) const
    {
        if (!unvisited.any()) return index;
        return (unvisited.ends_before + index / visited_picks()) * picks + unvisited.picks_before + index % visited_picks();
    }
    HL_FN int visited_segment(int index) const
    {
        if (!unvisited.any()) return index;
        if (index < visited_crossings()) return visited_crossing(index);
        const int weft = index - visited_crossings();
        return crossings() + (unvisited.picks_before + weft / visited_ends()) * ends + unvisited.ends_before + weft % visited_ends();
    }
};

/// One value per segment unless said. Liquid and vapour are masses, so that what leaves one segment enters another exactly.
struct Segments : Yarns {
    int shells = 0;
    const double* length = nullptr;
    const std::uint8_t* warp_up = nullptr; ///< per crossing
    const float* warp_up_share = nullptr;  ///< per crossing, of those that it stands for; null: each is one
    const std::uint8_t* fed = nullptr;     ///< whether it stays full; null: none does
    double* pores = nullptr;               ///< m3
    double* supplied = nullptr;            ///< kg since the start by hanging in liquid; null where none does
    double* liquid = nullptr;              ///< kg
    double* vapour = nullptr;              ///< kg
    double* warmth = nullptr;              ///< K over the climate
    double* regain = nullptr;              ///< per shell, from the fibre's middle outwards
    double* bound = nullptr;               ///< kg in the fibres: see bound_water(); who changes regain keeps it up to date
    std::int64_t* absorbed = nullptr;      ///< quanta taken from particles since the last network step
    int* contact = nullptr;                ///< note of the particle that touches, or none: see note_of()
    double* uptake = nullptr;              ///< m3: how much more water fibres took in the last exchange per kg/m3 more of pore vapour
    double* evaporated = nullptr;          ///< kg to the air since the start
    double* released = nullptr;            ///< J by phase change since the start
    double* lost = nullptr;                ///< J to the air since the start
    double* work0 = nullptr;               ///< scratch of what goes along lines
    double* work1 = nullptr;
    double* work2 = nullptr;
    double* flux = nullptr; ///< kg that crossed to the next segment along the yarn in this step

    HL_FN int warp_of(int end, int pick) const { return end * picks + pick; }
    HL_FN int weft_of(int end, int pick) const { return crossings() + pick * ends + end; }
    HL_FN int crossing_of(int segment) const
    {
        if (segment < crossings()) return segment;
        const int weft = segment - crossings();
        return (weft % ends) * picks + weft / ends;
    }
};

/// How far something happens: its largest end, its largest pick, and both counted from the sample's other side.
struct Reach {
    int* farthest;

    HL_FN void include(const Yarns& yarns, int crossing) const
    {
        const int end = crossing / yarns.picks, pick = crossing % yarns.picks;
        atomic_max(farthest, end);
        atomic_max(farthest + 1, pick);
        atomic_max(farthest + 2, yarns.ends - 1 - end);
        atomic_max(farthest + 3, yarns.picks - 1 - pick);
    }
};

constexpr int no_particle = 0x7fffffff;
constexpr int no_wall = -1;
constexpr int vessel_wall = -2;

/// What a particle has of the cloth round it: the share of the space that is yarn, as far as a kernel sees it, and how it changes.
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

/// One value per particle.
struct Particles {
    int room = 0;         ///< for so many; behind them is a place that is far from all
    Real mass = 0;        ///< kg, of each that is full
    Real per_quantum = 0; ///< of its mass
    Real support = 0;     ///< m, of the kernel of pressure and viscosity
    Real reach = 0;       ///< m, of the kernel of the surface; as far as neighbours are listed and walls are felt
    Real spacing = 0;     ///< m
    Vec3* position = nullptr;
    Vec3* velocity = nullptr;
    // What neighbours read.
    Quad* place = nullptr;          ///< position, and the pressure (Pa) that keeps the liquid from being pressed together
    Quad* motion = nullptr;         ///< velocity, and size
    Quad* standing = nullptr;       ///< position, and size
    Quad* predicted = nullptr;      ///< position at the step's end, so far, and size
    Quad* surface = nullptr;        ///< tilt (Pa m) and pull (Pa) of the surface's energy: see SurfaceEnergy
    Vec3* force = nullptr;          ///< acceleration by all but pressure
    Vec3* pressure_force = nullptr; ///< acceleration
    Vec3* wall_normal = nullptr;    ///< out of the nearest yarn or the vessel
    Real* wall_distance = nullptr;  ///< to its skin, at least
    int* wall_segment = nullptr;    ///< within half a spacing, or no_wall, or vessel_wall
    Real* allowed = nullptr;        ///< kg/m3 over the rest density that this step need not correct
    Real* mirrored = nullptr;       ///< Pa, of the liquid that a vessel's wall stands for; null: no vessel
    Real* stress = nullptr;         ///< Pa s since the last frame, mean of the normal stresses; null: nobody asks
    ClothField* cloth = nullptr;
    ClothExpansion* cloth_from = nullptr;
    std::int64_t* content = nullptr; ///< quanta of water it still holds
    std::uint8_t* alive = nullptr;
    // Neighbours are listed for several steps, with a skin beyond where they count, and particles keep their order so long. Lists are
    // whole packs, filled up with the one that is far away.
    int* near = nullptr;          ///< room for most_near slots each: within the support and the skin
    int* distant = nullptr;       ///< room for most_distant slots each: the others
    int* near_first = nullptr;    ///< pack with which each begins on a CPU: close behind another, which is quicker to go through
    int* distant_first = nullptr; ///< the same of the others
    int* near_count = nullptr;    ///< slots in use, whole packs
    int* distant_count = nullptr; ///< slots in use, whole packs
    Real* slope = nullptr;        ///< of near pairs, this step: the kernel's over SplineUnits::slope and the distance, times the size
    Real* listed_x = nullptr;     ///< where particles were when neighbours were listed; axes apart, so packs are read as they lie
    Real* listed_y = nullptr;
    Real* listed_z = nullptr;

    /// How full it is, and so how large: yarns drink from it, and it shrinks.
    HL_FN Real size(int i) const { return static_cast<Real>(content[i]) * per_quantum; }
    /// Whether a vessel's wall is near.
    HL_FN bool at_wall(int i) const { return wall_segment[i] == vessel_wall; }
};

/// Where sorting brings particles in another order.
struct SortedParticles {
    Vec3* position = nullptr;
    Vec3* velocity = nullptr;
    Quad* place = nullptr;
    Vec3* wall_normal = nullptr;
    Real* wall_distance = nullptr;
    int* wall_segment = nullptr;
    Real* mirrored = nullptr;
    Real* stress = nullptr;
    ClothExpansion* cloth_from = nullptr;
    std::int64_t* content = nullptr;

    /// The particles there; what has no order between steps is the same.
    HL_FN Particles of(Particles p) const
    {
        p.position = position;
        p.velocity = velocity;
        p.place = place;
        p.wall_normal = wall_normal;
        p.wall_distance = wall_distance;
        p.wall_segment = wall_segment;
        p.mirrored = mirrored;
        p.stress = stress;
        p.cloth_from = cloth_from;
        p.content = content;
        return p;
    }
};

constexpr int usual_near = 64, usual_distant = 112; // at most, at rest and with a skin

/// A box that holds liquid, wide open at its top; a plate if its sides are far away.
struct Vessel {
    bool present = false;
    Vec3 low, high;
    Real wetting = 0; ///< cosine of the contact angle
};

/// Cells are so many times narrower along x: particles of a row of cells lie side by side, and at its ends fewer are looked at in vain.
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
