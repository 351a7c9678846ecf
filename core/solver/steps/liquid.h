// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The free liquid: predictive-corrective incompressible SPH (Solenthaler and Pajarola 2009), gathered, one functor per pass.
#pragma once

#include "core/physics/fluid_forces.h"
#include "core/physics/sph_kernels.h"
#include "core/solver/state.h"

namespace hygroloom::inline HL_PRECISION {

/// Of the last step's pressure, the loop begins with so much; with all of it pressure waves grow.
constexpr Real kept_pressure = Real(0.5);

/// How long a step is, and what follows from that.
struct StepNumbers {
    Real dt = 0;          ///< s
    Real kept_excess = 0; ///< part of the density that is too much at a step's start which may be left at its end
    Real stiffness = 0;   ///< Pa per kg/m3, delta of the method
    Real friction = 0;    ///< of water that slides on yarn, per normal impulse
    Real drag = 0;        ///< on water between yarns, 20 nu dt / r2
};

struct LiquidParameters {
    Real density = 0;             ///< kg/m3, at rest
    Real kinematic_viscosity = 0; ///< m2/s
    Real surface_tension = 0;     ///< N/m
    Real gravity = 0;             ///< m/s2, downwards
    SurfaceEnergy surface;
    Vessel vessel;
    const StepNumbers* step = nullptr;
};

/// Bits of a positive number, which order like integers.
HL_FN int ordered_bits(float positive)
{
    union {
        float value;
        int bits;
    } both;
    both.value = positive;
    return both.bits;
}
HL_FN float from_ordered_bits(int bits)
{
    union {
        int bits;
        float value;
    } both;
    both.bits = bits;
    return both.value;
}

/// Of a spacing, in which displacements are counted.
constexpr int parts_of_spacing = 1 << 20;

/// Where no particle is. Lists are filled up with a place that stands there.
HL_FN Quad far_away() { return {Real(1e6), Real(1e6), Real(1e6), 0}; }

/// What neighbours read, as a step finds it, and how far it is from where neighbours were listed. The dead count for nothing
/// from here on; returns how many they are.
struct BeginStep {
    Particles p;
    Real kept;           ///< of the pressure
    int* moved;          ///< greatest displacements towards x, y, z, -x, -y and -z, in parts of the spacing
    std::int64_t* total; ///< dead
    HL_FN std::int64_t operator()(int i) const
    {
        if (!p.alive[i]) {
            p.place[i] = p.standing[i] = p.predicted[i] = far_away();
            return 1;
        }
        const Vec3 &x = p.position[i], &v = p.velocity[i];
        p.place[i] = {x.x, x.y, x.z, kept * p.place[i].w};
        p.motion[i] = {v.x, v.y, v.z, p.size(i)};
        p.standing[i] = {x.x, x.y, x.z, p.size(i)};
        const Real way[3] = {x.x - p.listed_x[i], x.y - p.listed_y[i], x.z - p.listed_z[i]};
        int whole[6];
        for (int k = 0; k < 3; ++k) {
            const Real parts = way[k] * (Real(parts_of_spacing) / p.spacing), most = Real(1 << 30);
            whole[k] = static_cast<int>(parts > -most ? parts < most ? parts : most : -most);
            whole[3 + k] = -whole[k];
        }
        atomic_max_of_all(moved, whole);
        return 0;
    }
};

/// The greatest displacement since neighbours were listed, relative to that of the middle.
struct FindFarthestMoved {
    Particles p;
    const int* moved; ///< see BeginStep
    int* farthest;    ///< bits of its square, in spacings; positive, so they order like integers
    HL_FN void operator()(int i) const
    {
        if (!p.alive[i]) return;
        const Vec3 middle{middle_moved(0), middle_moved(1), middle_moved(2)};
        const Vec3 way = (Real(1) / p.spacing) * (p.position[i] - Vec3{p.listed_x[i], p.listed_y[i], p.listed_z[i]} - middle);
        atomic_max_of_all(farthest, ordered_bits(static_cast<float>(dot(way, way))));
    }
    HL_FN Real middle_moved(int axis) const
    {
        return static_cast<Real>((0.5 * moved[axis] - 0.5 * moved[axis + 3]) / parts_of_spacing) * p.spacing;
    }
};

struct FindCell {
    Particles p;
    const CellGrid* grid;
    HL_FN void operator()(int i) const
    {
        const CellGrid& g = *grid;
        const Vec3& x = p.position[i];
        g.key[i] = p.alive[i] ? (g.cell_z(x.z) * g.ny + g.cell_y(x.y)) * g.nx + g.cell_x(x.x) : g.cells();
    }
};

/// The cells between which particles are, as maxima: of minus x, y and z, and of x, y and z.
struct FindBox {
    Particles p;
    const CellGrid* grid;
    int* box;
    HL_FN void operator()(int i) const
    {
        if (!p.alive[i]) return;
        const CellGrid& g = *grid;
        const Vec3& x = p.position[i];
        const int cell[3] = {g.whole_at_x(x.x), g.whole_at_y(x.y), g.whole_at_z(x.z)};
        const int ends[6] = {-cell[0], -cell[1], -cell[2], cell[0], cell[1], cell[2]};
        atomic_max_of_all(box, ends);
    }
};

/// Brings particles into cell order. What lies behind the living is far away from then on.
struct Reorder {
    const int* order;
    const int* key;
    const int* dead_key;
    Particles p;
    Particles to;
    static constexpr bool wide = true;

    HL_FN void operator()(int i) const
    {
        const int from = order[i];
        to.position[i] = p.position[from];
        to.velocity[i] = p.velocity[from];
        to.wall_normal[i] = p.wall_normal[from];
        to.wall_distance[i] = p.wall_distance[from];
        to.wall_segment[i] = p.wall_segment[from];
        to.content[i] = p.content[from];
        copy_together(to.cloth_from[i], p.cloth_from[from]);
        if (p.mirrored) to.mirrored[i] = p.mirrored[from];
        if (p.stress) to.stress[i] = p.stress[from];
        to.alive[i] = key[from] != *dead_key;
        const Vec3 &x = p.position[from], &v = p.velocity[from];
        to.place[i] = to.alive[i] ? Quad{x.x, x.y, x.z, p.place[from].w} : far_away();
        to.motion[i] = {v.x, v.y, v.z, to.size(i)};
        to.standing[i] = {to.place[i].x, to.place[i].y, to.place[i].z, to.size(i)};
        to.predicted[i] = far_away(); // a living one's is foreseen before anyone asks for it
        to.listed_x[i] = x.x;
        to.listed_y[i] = x.y;
        to.listed_z[i] = x.z;
    }
};

/// Lists the neighbours of each particle; particles are in the order of cells.
struct FindNeighbours {
    Particles p;
    const CellGrid* grid;
    const Real* skin; ///< m, by which neighbours are listed beyond where they count
    static constexpr bool wide = true;

#if HL_LANE_IS_THREAD
    HL_FN void operator()(int i) const { list(i, p.near + begin_of_list(i, most_near), p.distant + begin_of_list(i, most_distant)); }
#else
    void operator()(int i) const { (*this)(i, i + 1); }
    /// Lists one close behind the other. Where they begin hangs on who lists what; what they say does not.
    void operator()(int first, int last) const
    {
        std::int64_t near = std::int64_t(first) * most_near, distant = std::int64_t(first) * most_distant;
        for (int i = first; i < last; ++i) {
            p.near_first[i] = static_cast<int>(near / lanes);
            p.distant_first[i] = static_cast<int>(distant / lanes);
            list(i, p.near + near, p.distant + distant);
            near += p.near_count[i];
            distant += p.distant_count[i];
        }
    }
#endif

private:
    HL_FN void list(int i, int* near_slots, int* distant_slots) const
    {
        const Vec3 x{p.listed_x[i], p.listed_y[i], p.listed_z[i]};
        const Real near_reach = p.support + *skin, reach = p.reach + *skin, reach2 = reach * reach, support2 = near_reach * near_reach;
        SlotList near{near_slots, most_near}, distant{distant_slots, most_distant}; // too short only where many are pressed together
        for_candidates({*grid, x, reach}, i, [&](const auto& wanted, const auto& j, const Pack& distance2) {
            const auto others = wanted & (distance2 < reach2);
            list_lanes(others & (distance2 < support2), others & (distance2 >= support2), j, near, distant);
        });
        fill_up(near, slot_of(p.room));
        fill_up(distant, slot_of(p.room));
        p.near_count[i] = near.count;
        p.distant_count[i] = distant.count;
    }
    /// Particles side by side, from a row of cells.
    struct Run {
        int first, end;
    };
    /// The cells that the reach of a place may touch.
    struct Cells {
        CellGrid g;
        Vec3 x;
        Real reach;
        int y0, y1, z0, z1;

        HL_FN Cells(const CellGrid& grid, const Vec3& place, Real far) : g(grid), x(place), reach(far)
        {
            y0 = g.inside(g.cell_y(x.y - reach), g.ny), y1 = g.inside(g.cell_y(x.y + reach), g.ny);
            z0 = g.inside(g.cell_z(x.z - reach), g.nz), z1 = g.inside(g.cell_z(x.z + reach), g.nz);
        }
        HL_FN Real gap_y(int y) const { return g.gap(x.y - g.origin.y, y + g.first_y, g.whole_y); }
        HL_FN Real gap_z(int z) const { return g.gap(x.z - g.origin.z, z + g.first_z, g.whole_z); }
        /// Cells along x lie side by side, and so do their particles. Of a row that far away the reach only touches the middle; none if it
        /// is farther.
        HL_FN Run run(int y, int z) const
        {
            const Real far_y = gap_y(y), far_z = gap_z(z), left = reach * reach - far_y * far_y - far_z * far_z;
            if (!(left > 0)) return {0, 0};
            const Real half = root(left);
            const int row = (z * g.ny + y) * g.nx;
            return {g.start[row + g.inside(g.cell_x(x.x - half), g.nx)], g.start[row + g.inside(g.cell_x(x.x + half), g.nx) + 1]};
        }
    };

#if HL_LANE_IS_THREAD
    /// Each lane looks at a row of cells; then all go through what they have found together, whole packs whatever each has.
    template <typename Visit> HL_FN void for_candidates(const Cells& cells, int i, const Visit& visit) const
    {
        const int wide = cells.y1 - cells.y0 + 1, rows = wide * (cells.z1 - cells.z0 + 1);
        const Real per_wide = inverse(Real(wide));
        for (int first = 0, end = largest_beside(rows); first < end; first += lanes) {
            const int row = first + own_lane(), plane = static_cast<int>((Real(row) + Real(0.5)) * per_wide);
            const Run own = row < rows ? cells.run(cells.y0 + row - plane * wide, cells.z0 + plane) : Run{0, 0};
            const int before_end = sum_up_to_lane(own.end - own.first), all = of_lane(before_end, lanes - 1);
            const int first_less_before = own.end - before_end;
            const auto candidate = [&](int k) { return k + of_lane(first_less_before, lane_reaching(before_end, k)); };
            int j = candidate(own_lane());
            Quad other = p.standing[own_lane() < all ? j : i];
            for (int k = own_lane(), left = largest_beside(all); left > 0; left -= lanes, k += lanes) {
                const int next_j = candidate(k + lanes);
                const Quad next = p.standing[k + lanes < all ? next_j : i]; // is on its way while this one is looked at
                const Vec3 d = cells.x - Vec3{other.x, other.y, other.z};
                visit(k < all && j != i, j, dot(d, d));
                j = next_j;
                other = next;
            }
        }
    }
    /// The first lane up to whose own sum there are more than k.
    HL_FN static int lane_reaching(int sum, int k)
    {
        int lane = 0;
        for (int half = lanes / 2; half > 0; half /= 2)
            if (of_lane(sum, lane + half - 1) <= k) lane += half;
        return lane;
    }
#else
    static constexpr int most_runs = 64; // cells are no smaller than half the reach
    template <typename Visit> HL_FN void for_candidates(const Cells& cells, int i, const Visit& visit) const
    {
        Run runs[most_runs + 1];
        const int run_count = find_runs(cells, runs);
        Run now = runs[0];
        for (int run = 0; run < run_count;) {
            const int j = now.first;
            const Vec3& x = cells.x;
            const Pack dx = x.x - load(p.listed_x + j), dy = x.y - load(p.listed_y + j), dz = x.z - load(p.listed_z + j);
            visit(lanes_below(now.end - j) & lanes_but(i - j), j, dx * dx + dy * dy + dz * dz);
            // Runs are short: without branches from one to the next.
            const Run next = runs[run + 1];
            const bool ends = j + lanes >= now.end;
            run += ends;
            now.first = ends ? next.first : j + lanes;
            now.end = ends ? next.end : now.end;
        }
    }
    /// Those with particles; behind them stands an empty one. Rows beside each other along y are the lanes of a pack.
    static int find_runs(const Cells& cells, Run* runs)
    {
        const int wide = cells.y1 - cells.y0 + 1;
        Pack far_y{};
        for (int lane = 0; lane < wide; ++lane) far_y[lane] = cells.gap_y(cells.y0 + lane);
        int count = 0;
        for (int z = cells.z0; z <= cells.z1; ++z) {
            const Real far_z = cells.gap_z(z);
            const Pack left = cells.reach * cells.reach - far_z * far_z - far_y * far_y, half = root(positive(left));
            const Slots first = cells_x(cells, cells.x.x - half), last = cells_x(cells, cells.x.x + half);
            for (int lane = 0; lane < wide; ++lane) {
                const int* row = cells.g.start + (z * cells.g.ny + cells.y0 + lane) * cells.g.nx;
                runs[count] = {row[first[lane]], row[last[lane] + 1]};
                count += int(left[lane] > 0) & int(runs[count].first < runs[count].end);
            }
        }
        runs[count] = {0, 0};
        return count;
    }
    /// The cells that places are in along x, as inside(cell_x()) has one of them.
    static Slots cells_x(const Cells& cells, const Pack& x)
    {
        const CellGrid& g = cells.g;
        const Pack place = positive((x - g.origin.x) * (narrower * g.per_size)), end = Pack{} + Real(g.whole_x - 1);
        const Slots cell = (__builtin_convertvector(place < end ? place : end, Slots) >> g.shift) - g.first_x;
        const Slots low = cell > 0 ? cell : Slots{}, high = Slots{} + (g.nx - 1);
        return low < high ? low : high;
    }
#endif
};

/// The slots of a particle's near neighbours.
HL_FN const int* near_of(const Particles& p, int i)
{
    return p.near + (HL_LANE_IS_THREAD ? begin_of_list(i, most_near) : std::int64_t(p.near_first[i]) * lanes);
}
HL_FN const int* distant_of(const Particles& p, int i)
{
    return p.distant + (HL_LANE_IS_THREAD ? begin_of_list(i, most_distant) : std::int64_t(p.distant_first[i]) * lanes);
}

/// What near pairs keep as long as a step lasts.
HL_FN Real* slope_of(const Particles& p, const int* slots) { return p.slope + (slots - p.near); }

/// Lists lie one close behind the other, and memory is asked for so many slots beyond the own: for near neighbours those of the next three
/// particles, for distant ones of the next.
constexpr int slots_ahead = 128, slots_per_line = 64 / int(sizeof(int));

/// Calls visit(slots) with one pack after the other of the near neighbours of i; with_slopes if it asks for slope_of() them.
template <bool with_slopes = false, typename F> HL_FN void for_neighbours(const Particles& p, int i, const F& visit)
{
    const int* slots = near_of(p, i);
    const int count = p.near_count[i];
    HL_UNROLL_WHOLE
    for (int k = 0; k < usual_near; k += slots_per_line) {
        bring(slots + count + slots_ahead + k);
        if (with_slopes) bring(slope_of(p, slots) + count + slots_ahead + k);
    }
    HL_UNROLL(4)
    for (int k = 0; k < count; k += lanes) visit(slots + k * elements_beside);
}

/// The same with the distant neighbours of i.
template <typename F> HL_FN void for_distant_neighbours(const Particles& p, int i, const F& visit)
{
    const int* slots = distant_of(p, i);
    const int count = p.distant_count[i];
    HL_UNROLL_WHOLE
    for (int k = 0; k < usual_distant; k += slots_per_line) bring(slots + count + slots_ahead + k);
    HL_UNROLL(4)
    for (int k = 0; k < count; k += lanes) visit(slots + k * elements_beside);
}

HL_FN Packs between(const Quad& own, const Quads& others) { return {own.x - others.x, own.y - others.y, own.z - others.z}; }

/// A pack of pairs, and a kernel at their distances.
template <typename Kernel> struct Pairs {
    Packs way;                      ///< m, from the other to the own
    Pack square, inverse, distance; ///< m2, 1/m and m; at the same place next to nothing, and its inverse very large
    Kernel kernel;

    HL_FN Pairs(const Quad& own, const Quads& others, const SplineUnits& units)
        : way(between(own, others)), square(dot(way, way) + units.nothing), inverse(inverse_root(square)),
          distance(root_beside(square, inverse)), kernel(distance * units.per_metre)
    {
    }
};
using NearPairs = Pairs<Spline<Pack>>;
using DistantPairs = Pairs<OuterSpline<Pack>>; ///< farther than half the reach, whatever they have moved since they were listed

/// The liquid's share of the space round each particle and how it changes, where a wall counts as liquid; and the pull and the tilt
/// that follow.
struct FindSurface {
    Particles p;
    LiquidParameters liquid;
    static constexpr bool wide = true;

    HL_FN void operator()(int i) const { finish(i, sum_of(collect(i))); }
    HL_FN PackSums<4> collect(int i) const
    {
        const SplineUnits units(p.reach);
        const Quad own = p.place[i];
        Pack kernels{};
        Packs slopes{};
        const auto add = [&](const auto& pairs, const Pack& sizes) {
            kernels += sizes * pairs.kernel.kernel();
            slopes += sizes * pairs.kernel.slope() * pairs.inverse * pairs.way;
        };
        for_neighbours(p, i, [&](const int* slots) {
            const Quads others = gather(p.standing, slots);
            add(NearPairs(own, others, units), others.w);
        });
        for_distant_neighbours(p, i, [&](const int* slots) {
            const Quads others = gather(p.standing, slots);
            add(DistantPairs(own, others, units), others.w);
        });
        return {{kernels, slopes.x, slopes.y, slopes.z}};
    }
    HL_FN void finish(int i, const Sums<4>& sums) const
    {
        const Real volume = p.mass / liquid.density;
        const SplineUnits units(p.reach);
        const auto& [kernels, x, y, z] = sums.of;
        Real share = volume * (p.size(i) * spline_kernel(Real(0), p.reach) + units.kernel * kernels) + p.cloth[i].surface_share;
        Vec3 slope = volume * units.slope * Vec3{x, y, z} + p.cloth[i].surface_slope;
        if (p.at_wall(i)) {
            const Real of_liquid = wall_share(liquid.vessel.wetting);
            share += of_liquid * kernel_beyond_plane(p.wall_distance[i], p.reach);
            slope -= of_liquid * kernel_in_plane(p.wall_distance[i], p.reach) * p.wall_normal[i];
        }
        const Vec3 tilt = liquid.surface.tilt(slope);
        p.surface[i] = {tilt.x, tilt.y, tilt.z, liquid.surface.pull(share)};
    }
};

/// Surface forces of a pack of neighbours of full size on a particle: see surface_force().
struct SurfaceForces {
    Packs tilt; ///< the particle's less the neighbours'
    SurfaceForce<Pack> force;

    template <typename Kernel>
    HL_FN SurfaceForces(const Particles& p, const Quad& own, const Pairs<Kernel>& pairs, const SplineUnits& units, const int* slots)
    {
        const Quads theirs = gather(p.surface, slots);
        tilt = between(own, theirs);
        force = surface_force(own.w + theirs.w, tilt, pairs.way, pairs.inverse, pairs.kernel, units.per_metre);
    }
};

/// How far from a vessel's wall the density finds a particle: see wall_recess.
HL_FN Real wall_depth(const Particles& p, int i) { return p.wall_distance[i] + wall_recess * p.spacing; }

/// A particle's acceleration by the pressure of the liquid, of which push is the sum over its neighbours, and where it comes to be with it.
HL_FN void predict(const Particles& p, const LiquidParameters& liquid, int i, const Vec3& push)
{
    // The cloth only bounds the density: its own force is what does no work where the density stays.
    Vec3 a = -(p.mass / (liquid.density * liquid.density)) * push - (p.place[i].w / liquid.density) * p.cloth[i].slope;
    if (p.at_wall(i)) {
        a += ((p.place[i].w + p.mirrored[i]) / liquid.density * kernel_in_plane(wall_depth(p, i), p.support)) * p.wall_normal[i];
    }
    p.pressure_force[i] = a;
    const Real dt = liquid.step->dt;
    const Vec3 v = p.velocity[i] + dt * (p.force[i] + a);
    const Vec3 x = p.position[i] + dt * v;
    p.predicted[i] = {x.x, x.y, x.z, p.motion[i].w};
}

/// Accelerations by gravity, viscosity (Monaghan's pair form), surface tension and adhesion. Departs from the paper: eq. 5's cohesion
/// presses a drop a hundred times harder than its surface tension does. A wall counts as liquid, so that it attracts with what its work
/// of adhesion is over the surface tension, or repels. And the acceleration by the pressure that is there already.
struct FindForces {
    Particles p;
    LiquidParameters liquid;
    static constexpr bool wide = true;

    HL_FN void operator()(int i) const { finish(i, sum_of(collect(i))); }
    HL_FN PackSums<7> collect(int i) const
    {
        const Real smallest = Real(0.01) * p.support * p.support;
        const Quad place = p.place[i], motion = p.motion[i], surface = p.surface[i];
        const SplineUnits near(p.support), units(p.reach);
        const Real drag = Real(10) * liquid.kinematic_viscosity * liquid.density * (near.slope / units.slope);
        Pack kernels{};
        Packs forces{}, pressed{};
        for_neighbours<true>(p, i, [&](const int* slots) {
            const Quads others = gather(p.place, slots);
            const NearPairs pairs(place, others, units);
            const Quads motions = gather(p.motion, slots);
            const Pack& sizes = motions.w;
            const Spline<Pack> kernel(pairs.distance * near.per_metre);
            const Pack slope = sizes * kernel.slope() * pairs.inverse;
            store(slope_of(p, slots), slope);
            kernels += sizes * kernel.kernel();
            pressed += (place.w + others.w) * slope * pairs.way;
            const SurfaceForces surfaces(p, surface, pairs, units, slots);
            const Pack friction = quotient(drag * dot(between(motion, motions), pairs.way), pairs.square + smallest) * slope;
            forces += (sizes * surfaces.force.along + friction) * pairs.way;
            forces -= sizes * surfaces.force.against * surfaces.tilt;
        });
        for_distant_neighbours(p, i, [&](const int* slots) {
            const Quads others = gather(p.standing, slots);
            const DistantPairs pairs(place, others, units);
            const SurfaceForces surfaces(p, surface, pairs, units, slots);
            forces += others.w * surfaces.force.along * pairs.way;
            forces -= others.w * surfaces.force.against * surfaces.tilt;
        });
        return {{kernels, forces.x, forces.y, forces.z, pressed.x, pressed.y, pressed.z}};
    }
    HL_FN void finish(int i, const Sums<7>& sums) const
    {
        if (!p.alive[i]) return;
        const Real volume = p.mass / liquid.density;
        const SplineUnits near(p.support), units(p.reach);
        const auto& [kernels, x, y, z, pressed_x, pressed_y, pressed_z] = sums.of;
        const Vec3 force = units.slope * Vec3{x, y, z}, pressure = near.slope * Vec3{pressed_x, pressed_y, pressed_z};
        const Real kernel = near.kernel * kernels;
        const Quad motion = p.motion[i], surface = p.surface[i];
        Vec3 a = (volume / liquid.density) * force;
        a.z -= liquid.gravity;
        const ClothField& cloth = p.cloth[i];
        a += (Real(1) / liquid.density) *
             (surface.w * cloth.surface_slope - ClothExpansion::times(cloth.bend, {surface.x, surface.y, surface.z}) + cloth.adhesion);
        Real excess = p.mass * (motion.w * spline_kernel(Real(0), p.support) + kernel) + liquid.density * (cloth.share - Real(1));
        if (p.at_wall(i)) {
            const Real distance = p.wall_distance[i];
            excess += liquid.density * kernel_beyond_plane(wall_depth(p, i), p.support);
            const Real cosine = liquid.vessel.wetting;
            const Real push =
                wall_share(cosine) *
                    surface_force_of_wall(surface.w, dot(Vec3{surface.x, surface.y, surface.z}, p.wall_normal[i]), distance, p.reach) -
                wall_pull(wall_attraction(cosine) * liquid.surface_tension, distance, p.reach);
            a += (push / liquid.density) * p.wall_normal[i];
        }
        if (p.mirrored) {
            constexpr Real per_step = Real(0.1); // of what they differ by; away from walls all, to begin with when it meets one
            p.mirrored[i] += (p.at_wall(i) ? per_step : Real(1)) * (p.place[i].w / kept_pressure - p.mirrored[i]);
        }
        p.force[i] = a;
        p.allowed[i] = excess > 0 ? liquid.step->kept_excess * excess : Real(0);
        predict(p, liquid, i, pressure);
    }
};

/// Density at the predicted places raises the pressure. What is new in a step is corrected in it; what was there before, over the
/// longest step: a short one would throw particles apart that a wall or another of them has pushed together. Returns by how many
/// millionths of the rest density it is too dense, whole ones so that their sum has no order.
struct CorrectPressure {
    Particles p;
    LiquidParameters liquid;
    std::int64_t* total; ///< too dense by, 1e-6 of the rest density
    static constexpr bool wide = true;

    HL_FN std::int64_t operator()(int i) const { return finish(i, sum_of(collect(i))); }
    HL_FN PackSums<1> collect(int i) const
    {
        const Quad own = p.predicted[i];
        const SplineUnits units(p.support);
        Pack kernels{};
        for_neighbours(p, i, [&](const int* slots) {
            const Quads others = gather(p.predicted, slots);
            kernels += others.w * NearPairs(own, others, units).kernel.kernel();
        });
        return {{kernels}};
    }
    HL_FN std::int64_t finish(int i, const Sums<1>& sums) const
    {
        const Quad own = p.predicted[i];
        const Real kernels = SplineUnits(p.support).kernel * sums.of[0];
        const Vec3 moved = Vec3{own.x, own.y, own.z} - p.position[i];
        Real density = p.mass * (own.w * spline_kernel(Real(0), p.support) + kernels) +
                       liquid.density * (p.cloth[i].share + dot(p.cloth[i].slope, moved));
        if (p.at_wall(i)) { density += liquid.density * kernel_beyond_plane(wall_depth(p, i) + dot(moved, p.wall_normal[i]), p.support); }
        const Real excess = density - liquid.density;
        p.place[i].w = positive(p.place[i].w + liquid.step->stiffness * (excess - p.allowed[i]));
        return excess > 0 ? static_cast<std::int64_t>(excess / liquid.density * Real(1e6)) : 0;
    }
};

/// The acceleration by pressure, and where it takes a particle.
struct FindPressureForce {
    Particles p;
    LiquidParameters liquid;
    static constexpr bool wide = true;

    HL_FN void operator()(int i) const { finish(i, sum_of(collect(i))); }
    HL_FN PackSums<3> collect(int i) const
    {
        const Quad own = p.place[i];
        Packs push{};
        for_neighbours<true>(p, i, [&](const int* slots) {
            const Quads others = gather(p.place, slots);
            push += (own.w + others.w) * load(slope_of(p, slots)) * between(own, others);
        });
        return {{push.x, push.y, push.z}};
    }
    HL_FN void finish(int i, const Sums<3>& sums) const
    {
        const auto& [x, y, z] = sums.of;
        if (p.alive[i]) predict(p, liquid, i, SplineUnits(p.support).slope * Vec3{x, y, z});
    }
};

/// Pressure as a gauge would show it: the virial of surface and pressure forces between particles (Irving and Kirkwood 1950), half of
/// each pair's to each, and the same with what a wall counts as; summed over time, for a single step says little.
struct FindStress {
    Particles p;
    LiquidParameters liquid;
    static constexpr bool wide = true;

    HL_FN void operator()(int i) const { finish(i, sum_of(collect(i))); }
    HL_FN PackSums<2> collect(int i) const
    {
        const Quad own = p.place[i], surface = p.surface[i];
        const SplineUnits units(p.reach);
        Pack pressed{}, pulled{};
        const auto add_surface = [&](const auto& pairs, const Pack& sizes, const int* slots) {
            const SurfaceForces surfaces(p, surface, pairs, units, slots);
            pulled += sizes * (surfaces.force.along * pairs.square - surfaces.force.against * dot(surfaces.tilt, pairs.way));
        };
        for_neighbours<true>(p, i, [&](const int* slots) {
            const Quads others = gather(p.place, slots);
            const NearPairs pairs(own, others, units);
            pressed += (own.w + others.w) * load(slope_of(p, slots)) * pairs.square;
            add_surface(pairs, gather(p.standing, slots).w, slots);
        });
        for_distant_neighbours(p, i, [&](const int* slots) {
            const Quads others = gather(p.standing, slots);
            add_surface(DistantPairs(own, others, units), others.w, slots);
        });
        return {{pulled, pressed}};
    }
    HL_FN void finish(int i, const Sums<2>& sums) const
    {
        const Real volume = p.mass / liquid.density;
        const Quad own = p.place[i], surface = p.surface[i];
        const Real pull = SplineUnits(p.reach).slope * sums.of[0], pressure = SplineUnits(p.support).slope * sums.of[1];
        Real virial = volume * (pull - pressure);
        if (p.at_wall(i)) {
            const Real tilt = dot(Vec3{surface.x, surface.y, surface.z}, p.wall_normal[i]), distance = p.wall_distance[i];
            virial += (own.w + p.mirrored[i]) * slope_virial_beyond_plane(wall_depth(p, i), p.support) +
                      wall_share(liquid.vessel.wetting) * (-surface.w * slope_virial_beyond_plane(distance, p.reach) -
                                                           tilt * curvature_virial_beyond_plane(distance, p.reach));
        }
        p.stress[i] += liquid.step->dt * virial / Real(6);
    }
};

struct MoveParticles {
    Particles p;
    const StepNumbers* step;
    int* fastest; ///< bits of the greatest speed; speeds are positive, so their bits order like integers
    HL_FN void operator()(int i) const
    {
        if (!p.alive[i]) return;
        p.velocity[i] += step->dt * (p.force[i] + p.pressure_force[i]);
        p.position[i] += step->dt * p.velocity[i];
        atomic_max_of_all(fastest, ordered_bits(static_cast<float>(length(p.velocity[i]))));
    }
};

} // namespace hygroloom::inline HL_PRECISION
