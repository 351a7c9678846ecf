// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The free liquid: predictive-corrective incompressible SPH (Solenthaler and Pajarola 2009), gathered, one functor per pass.
#pragma once

#include "core/physics/fluid_forces.h"
#include "core/physics/sph_kernels.h"
#include "core/sim/state.h"

namespace hygroloom {

/// Of the last step's pressure, the loop begins with so much; with all of it pressure waves grow.
constexpr Real kept_pressure = Real(0.5);

struct LiquidParameters {
    Real density = 0;             ///< kg/m3, at rest
    Real kinematic_viscosity = 0; ///< m2/s
    Real surface_tension = 0;     ///< N/m
    Real gravity = 0;             ///< m/s2, downwards
    SurfaceEnergy surface;
    Vessel vessel;
    Real kept_excess = 0; ///< part of the density that is too much at a step's start which may be left at its end
};

/// Where no particle is. Lists are filled up with a place that stands there.
HL_FN Quad far_away() { return {Real(1e6), Real(1e6), Real(1e6), 0}; }

struct FindCell {
    Particles p;
    CellGrid g;
    HL_FN void operator()(int i) const
    {
        const Vec3& x = p.position[i];
        g.key[i] = p.alive[i] ? (g.cell_z(x.z) * g.ny + g.cell_y(x.y)) * g.nx + g.cell_x(x.x) : g.cells();
    }
};

/// After sorting by cell: the first particle of each cell, for every cell up to and including the dead's.
struct FindCellStarts {
    CellGrid g;
    int count;
    HL_FN void operator()(int i) const
    {
        const int before = i == 0 ? -1 : g.key[i - 1];
        const int own = i == count ? g.cells() : g.key[i];
        for (int cell = before + 1; cell <= own; ++cell) g.start[cell] = i;
    }
};

/// The cells between which particles are, as maxima: of minus x, y and z, and of x, y and z.
struct FindBox {
    Particles p;
    CellGrid g;
    int* box;
    HL_FN void operator()(int i) const
    {
        if (!p.alive[i]) return;
        const Vec3& x = p.position[i];
        const int cell[3] = {g.whole(x.x - g.origin.x, g.whole_x), g.whole(x.y - g.origin.y, g.whole_y),
                             g.whole(x.z - g.origin.z, g.whole_z)};
        for (int k = 0; k < 3; ++k) {
            atomic_max(box + k, -cell[k]);
            atomic_max(box + 3 + k, cell[k]);
        }
    }
};

/// Brings particles into cell order. What lies behind the living is far away from then on.
struct Reorder {
    const int* order;
    const Vec3* position;
    const Vec3* velocity;
    const Vec3* wall_normal;
    const Real* wall_distance;
    const int* wall_segment;
    const Quad* place;
    const Real* stress;
    const std::int64_t* content;
    const int* key;
    int dead_key;
    Particles to;
    HL_FN void operator()(int i) const
    {
        const int from = order[i];
        to.position[i] = position[from];
        to.velocity[i] = velocity[from];
        to.wall_normal[i] = wall_normal[from];
        to.wall_distance[i] = wall_distance[from];
        to.wall_segment[i] = wall_segment[from];
        to.content[i] = content[from];
        if (stress) to.stress[i] = stress[from];
        to.alive[i] = key[i] != dead_key;
        const Vec3 &x = position[from], &v = velocity[from];
        to.place[i] = to.alive[i] ? Quad{x.x, x.y, x.z, place[from].w} : far_away();
        to.motion[i] = {v.x, v.y, v.z, 0};
        to.predicted[i] = to.place[i];
    }
};

/// Lists the neighbours of each particle; particles are in the order of cells.
struct FindNeighbours {
    Particles p;
    CellGrid g;
    static constexpr bool wide = true;

    /// How many were found within the support and beyond it.
    struct Found {
        int near, distant;
    };
    HL_FN void operator()(int i) const
    {
        const Vec3 x = p.position[i];
        const Real reach = p.reach;
        const int x0 = g.inside(g.cell_x(x.x - reach), g.nx), x1 = g.inside(g.cell_x(x.x + reach), g.nx);
        const int y0 = g.inside(g.cell_y(x.y - reach), g.ny), y1 = g.inside(g.cell_y(x.y + reach), g.ny);
        const int z0 = g.inside(g.cell_z(x.z - reach), g.nz), z1 = g.inside(g.cell_z(x.z + reach), g.nz);
        int* slots = p.neighbours + static_cast<std::int64_t>(i) * largest_neighbour_count;
        Found found{0, 0};
        for (int z = z0; z <= z1; ++z)
            for (int y = y0; y <= y1; ++y) {
                const int row = (z * g.ny + y) * g.nx; // cells along x lie side by side, and so do their particles
                append(i, x, g.start[row + x0], g.start[row + x1 + 1], slots, found);
            }
        p.near_count[i] = found.near;
        p.distant_count[i] = found.distant;
        for (; found.near % lanes != 0; ++found.near) slots[found.near] = p.count;
        for (; found.distant % lanes != 0; ++found.distant) slots[largest_neighbour_count - 1 - found.distant] = p.count;
    }
    HL_FN void append(int i, const Vec3& x, int first, int end, int* slots, Found& found) const
    {
        constexpr int room = largest_neighbour_count - 3 * lanes; // for a pack more and for what both ends are filled up with
        const Real within = p.support * p.support, reach = p.reach * p.reach;
        for (int j = first; j < end; j += lanes) {
            if (found.near + found.distant > room) found.distant = found.distant > lanes ? found.distant - lanes : 0; // the near ones count
            if (found.near > room) return;
            const Quads other = load(p.place + j);
            const Pack dx = x.x - other.x, dy = x.y - other.y, dz = x.z - other.z;
            const Pack distance2 = dx * dx + dy * dy + dz * dz;
            for (int l = 0; l < lanes; ++l) {
                const Real d2 = lane_of(distance2, l);
                const bool other_one = j + l != i && j + l < end;
                slots[found.near] = j + l; // stays if it is one
                found.near += d2 < within && other_one;
                slots[largest_neighbour_count - 1 - found.distant] = j + l;
                found.distant += d2 >= within && d2 < reach && other_one;
            }
        }
    }
};

/// Calls visit(slots) with one pack after the other of the neighbours of i within the support.
template <typename F> HL_FN void for_neighbours(const Particles& p, int i, const F& visit)
{
    const int* slots = p.neighbours + static_cast<std::int64_t>(i) * largest_neighbour_count;
    const int count = p.near_count[i];
    for (int k = 0; k < count; k += lanes) visit(slots + k);
}

/// The same with the other neighbours of i, up to the reach.
template <typename F> HL_FN void for_distant_neighbours(const Particles& p, int i, const F& visit)
{
    const int* end = p.neighbours + (static_cast<std::int64_t>(i) + 1) * largest_neighbour_count;
    const int count = p.distant_count[i];
    for (int k = 0; k < count; k += lanes) visit(end - k - lanes);
}

using Packs = Vec3T<Pack>;
HL_FN Packs between(const Quad& own, const Quads& others) { return {own.x - others.x, own.y - others.y, own.z - others.z}; }
HL_FN Vec3 sum_of(const Packs& packs) { return {sum_of(packs.x), sum_of(packs.y), sum_of(packs.z)}; }

/// The liquid's share of the space round each particle and how it changes, where a wall counts as liquid; and the pull and the tilt
/// that follow.
struct FindSurface {
    Particles p;
    LiquidParameters liquid;
    static constexpr bool wide = true;

    HL_FN void operator()(int i) const
    {
        const Real volume = p.mass / liquid.density;
        const Quad own = p.place[i];
        Pack kernels{};
        Packs slopes{};
        const auto add = [&](const int* slots) {
            const Packs d = between(own, gather(p.place, slots));
            const Pack r = root(dot(d, d));
            kernels += spline_kernel(r, p.reach);
            slopes += spline_gradient_factor(r, p.reach) * d;
        };
        for_neighbours(p, i, add);
        for_distant_neighbours(p, i, add);
        Real share = volume * (spline_kernel(Real(0), p.reach) + sum_of(kernels)) + p.cloth[i].surface_share;
        Vec3 slope = volume * sum_of(slopes) + p.cloth[i].surface_slope;
        if (p.at_wall(i)) {
            share += kernel_beyond_plane(p.wall_distance[i], p.reach);
            slope -= kernel_in_plane(p.wall_distance[i], p.reach) * p.wall_normal[i];
        }
        const Vec3 tilt = liquid.surface.tilt(slope);
        p.surface[i] = {tilt.x, tilt.y, tilt.z, liquid.surface.pull(share)};
    }
};

/// Surface force of a pack of neighbours on a particle, over the square of their volume.
HL_FN Packs surface_forces(const Particles& p, const Quad& own, const Quad& place, const int* slots)
{
    const Quads theirs = gather(p.surface, slots);
    return surface_force<Pack>(own.w + theirs.w, between(own, theirs), between(place, gather(p.place, slots)), p.reach);
}

/// Accelerations by gravity, viscosity (Monaghan's pair form), surface tension and adhesion. Departs from the paper: eq. 5's cohesion
/// presses a drop a hundred times harder than its surface tension does. A wall counts as liquid, so that it attracts with what its work
/// of adhesion is over the surface tension, or repels.
struct FindForces {
    Particles p;
    LiquidParameters liquid;
    Yarns yarns;
    static constexpr bool wide = true;

    HL_FN void operator()(int i) const
    {
        const Real volume = p.mass / liquid.density;
        const Real smallest = Real(0.01) * p.support * p.support;
        const Quad place = p.place[i], motion = p.motion[i], surface = p.surface[i];
        Pack kernels{};
        Packs drag{}, cohesion{};
        for_neighbours(p, i, [&](const int* slots) {
            const Packs d = between(place, gather(p.place, slots));
            const Pack r2 = dot(d, d), r = root(r2);
            kernels += spline_kernel(r, p.support);
            drag += dot(between(motion, gather(p.motion, slots)), d) / (r2 + smallest) * spline_gradient_factor(r, p.support) * d;
            cohesion += surface_forces(p, surface, place, slots);
        });
        for_distant_neighbours(p, i, [&](const int* slots) { cohesion += surface_forces(p, surface, place, slots); });
        Vec3 a = Real(10) * liquid.kinematic_viscosity * volume * sum_of(drag) + (volume / liquid.density) * sum_of(cohesion);
        a.z -= liquid.gravity;
        const ClothField& cloth = p.cloth[i];
        a +=
            (Real(1) / liquid.density) * (surface.w * cloth.surface_slope - cloth.bent({surface.x, surface.y, surface.z}) + cloth.adhesion);
        Real excess = p.mass * (spline_kernel(Real(0), p.support) + sum_of(kernels)) + liquid.density * (cloth.share - Real(1));
        if (p.at_wall(i)) {
            const Real distance = p.wall_distance[i];
            excess += liquid.density * kernel_beyond_plane(distance, p.support);
            const Real adhesion =
                p.wall_segment[i] >= 0 ? static_cast<Real>(yarns.yarn_of(p.wall_segment[i]).adhesion) : liquid.vessel.adhesion;
            const Real push =
                surface_force_of_wall(surface.w, dot(Vec3{surface.x, surface.y, surface.z}, p.wall_normal[i]), distance, p.reach) -
                (distance > 0 ? wall_pull(adhesion - liquid.surface_tension, distance, p.support) : Real(0));
            a += (push / liquid.density) * p.wall_normal[i];
        }
        p.force[i] = a;
        p.allowed[i] = excess > 0 ? liquid.kept_excess * excess : Real(0);
    }
};

struct PredictPosition {
    Particles p;
    Real dt;
    HL_FN void operator()(int i) const
    {
        const Vec3 v = p.velocity[i] + dt * (p.force[i] + p.pressure_force[i]);
        const Vec3 x = p.position[i] + dt * v;
        p.predicted[i] = {x.x, x.y, x.z, 0};
    }
};

/// Density at the predicted places raises the pressure. What is new in a step is corrected in it; what was there before, over the
/// longest step: a short one would throw particles apart that a wall or another of them has pushed together. Errors are summed in
/// millionths so that the sum has no order.
struct CorrectPressure {
    Particles p;
    LiquidParameters liquid;
    Real stiffness;          ///< Pa per kg/m3, delta of the method
    std::int64_t* error_sum; ///< millionths of the rest density
    static constexpr bool wide = true;

    HL_FN void operator()(int i) const
    {
        const Quad own = p.predicted[i];
        Pack kernels{};
        for_neighbours(p, i, [&](const int* slots) {
            const Packs d = between(own, gather(p.predicted, slots));
            kernels += spline_kernel(root(dot(d, d)), p.support);
        });
        const Vec3 moved = Vec3{own.x, own.y, own.z} - p.position[i];
        Real density = p.mass * (spline_kernel(Real(0), p.support) + sum_of(kernels)) +
                       liquid.density * (p.cloth[i].share + dot(p.cloth[i].slope, moved));
        if (p.at_wall(i)) { density += liquid.density * kernel_beyond_plane(p.wall_distance[i] + dot(moved, p.wall_normal[i]), p.support); }
        const Real excess = density - liquid.density;
        p.place[i].w = positive(p.place[i].w + stiffness * (excess - p.allowed[i]));
        if (excess > 0) atomic_add(error_sum, static_cast<std::int64_t>(excess / liquid.density * Real(1e6)));
    }
};

/// A wall carries the pressure of the particle before it, as if the liquid went on behind it.
struct FindPressureForce {
    Particles p;
    LiquidParameters liquid;
    static constexpr bool wide = true;

    HL_FN void operator()(int i) const
    {
        const Quad own = p.place[i];
        Packs push{};
        for_neighbours(p, i, [&](const int* slots) {
            const Quads others = gather(p.place, slots);
            const Packs d = between(own, others);
            push += (own.w + others.w) * spline_gradient_factor(root(dot(d, d)), p.support) * d;
        });
        // The cloth only bounds the density: its own force is what does no work where the density stays.
        Vec3 a = -(p.mass / (liquid.density * liquid.density)) * sum_of(push) - (own.w / liquid.density) * p.cloth[i].slope;
        if (p.at_wall(i)) a += (Real(2) * own.w / liquid.density * kernel_in_plane(p.wall_distance[i], p.support)) * p.wall_normal[i];
        p.pressure_force[i] = a;
    }
};

/// Pressure as a gauge would show it: the virial of surface and pressure forces between particles (Irving and Kirkwood 1950), half of
/// each pair's to each.
struct FindStress {
    Particles p;
    LiquidParameters liquid;
    HL_FN void operator()(int i) const
    {
        const Real volume = p.mass / liquid.density;
        const Quad own = p.place[i], surface = p.surface[i];
        Pack sum{};
        const auto add_surface = [&](const int* slots) {
            sum += dot(surface_forces(p, surface, own, slots), between(own, gather(p.place, slots)));
        };
        for_neighbours(p, i, [&](const int* slots) {
            const Quads others = gather(p.place, slots);
            const Packs d = between(own, others);
            const Pack r2 = dot(d, d);
            sum -= (own.w + others.w) * spline_gradient_factor(root(r2), p.support) * r2;
            add_surface(slots);
        });
        for_distant_neighbours(p, i, add_surface);
        p.stress[i] = volume * sum_of(sum) / Real(6);
    }
};

struct MoveParticles {
    Particles p;
    Real dt;
    int* fastest; ///< bits of the greatest speed; speeds are positive, so their bits order like integers
    HL_FN void operator()(int i) const
    {
        p.velocity[i] += dt * (p.force[i] + p.pressure_force[i]);
        p.position[i] += dt * p.velocity[i];
        p.place[i].w *= kept_pressure;
        union {
            float speed;
            int bits;
        } fast;
        fast.speed = static_cast<float>(length(p.velocity[i]));
        atomic_max(fastest, fast.bits);
    }
};

} // namespace hygroloom
