// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The free liquid: predictive-corrective incompressible SPH (Solenthaler and Pajarola 2009), gathered, one functor per pass.
#pragma once

#include "core/physics/fluid_forces.h"
#include "core/physics/sph_kernels.h"
#include "core/sim/state.h"

namespace hygroloom {

struct LiquidParameters {
    Real density = 0;             ///< kg/m3, at rest
    Real kinematic_viscosity = 0; ///< m2/s
    Real surface_tension = 0;     ///< N/m
    Real gravity = 0;             ///< m/s2, downwards
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
        to.alive[i] = key[i] != dead_key;
        to.place[i] = to.alive[i] ? Quad{position[from].x, position[from].y, position[from].z, 0} : far_away();
        to.predicted[i] = to.place[i];
    }
};

/// Lists the neighbours of each particle; particles are in the order of cells.
struct FindNeighbours {
    Particles p;
    CellGrid g;
    static constexpr bool wide = true;

    HL_FN void operator()(int i) const
    {
        const Vec3 x = p.position[i];
        const int cx = g.cell_x(x.x), cy = g.cell_y(x.y), cz = g.cell_z(x.z);
        int* slots = p.neighbours + static_cast<std::int64_t>(i) * largest_neighbour_count;
        int found = 0;
        for (int z = cz > 0 ? cz - 1 : 0; z <= cz + 1 && z < g.nz; ++z)
            for (int y = cy > 0 ? cy - 1 : 0; y <= cy + 1 && y < g.ny; ++y) {
                const int row = (z * g.ny + y) * g.nx;
                const int last = cx + 1 < g.nx ? cx + 1 : g.nx - 1;
                // Cells along x lie side by side, and so do their particles.
                found = append(i, x, g.start[row + (cx > 0 ? cx - 1 : 0)], g.start[row + last + 1], slots, found);
            }
        p.neighbour_count[i] = found;
        for (; found % lanes != 0; ++found) slots[found] = p.count;
    }
    HL_FN int append(int i, const Vec3& x, int first, int end, int* slots, int found) const
    {
        const Real reach = p.support * p.support;
        for (int j = first; j < end && found <= largest_neighbour_count - lanes; j += lanes) {
            const Quads other = load(p.place + j);
            const Pack dx = x.x - other.x, dy = x.y - other.y, dz = x.z - other.z;
            const Pack distance2 = dx * dx + dy * dy + dz * dz;
            for (int l = 0; l < lanes; ++l) {
                slots[found] = j + l; // stays if it is one
                found += lane_of(distance2, l) < reach && j + l != i && j + l < end;
            }
        }
        return found;
    }
};

/// Calls add(x, y, z, w) with one pack of neighbours after the other: the vectors from them to i, and what else stands there.
template <typename F> HL_FN void for_neighbours(const Particles& p, int i, const Quad* at, const F& add)
{
    const int* slots = p.neighbours + static_cast<std::int64_t>(i) * largest_neighbour_count;
    const Quad own = at[i];
    const int count = p.neighbour_count[i];
    for (int k = 0; k < count; k += lanes) {
        const Quads other = gather(at, slots + k);
        add(own.x - other.x, own.y - other.y, own.z - other.z, other.w);
    }
}

/// Accelerations by gravity, viscosity (Monaghan's pair form), surface tension and adhesion. Departs from the paper: surface tension
/// comes from a pair force (Tartakovsky and Panchenko 2016) in place of eq. 5, whose cohesion presses a drop a hundred times harder
/// than its surface tension does; a wall attracts with the potential whose depth is the work of adhesion.
struct FindForces {
    Particles p;
    LiquidParameters liquid;
    Yarns yarns;
    HL_FN void operator()(int i) const
    {
        const Real volume = p.mass / liquid.density;
        const Vec3 x = p.position[i], v = p.velocity[i];
        const Real smallest = Real(0.01) * p.support * p.support;
        const Real cohesion = pair_cohesion(liquid.surface_tension, p.spacing, p.support) / p.mass;
        Vec3 a{0, 0, -liquid.gravity};
        const int* slots = p.neighbours + static_cast<std::int64_t>(i) * largest_neighbour_count;
        for (int k = 0; k < p.neighbour_count[i]; ++k) {
            const int j = slots[k];
            const Vec3 d = x - p.position[j];
            const Real r2 = dot(d, d);
            const Real r = std::sqrt(r2);
            const Real drag = Real(10) * liquid.kinematic_viscosity * volume * dot(v - p.velocity[j], d) / (r2 + smallest) *
                              spline_gradient_factor(r, p.support);
            const Real push = r > 0 ? cohesion * pair_force_shape(r, p.support) / r : Real(0);
            a += (drag + push) * d;
        }
        if (p.wall_segment[i] >= 0 && p.wall_distance[i] > 0)
            a -= (wall_pull(static_cast<Real>(yarns.yarn_of(p.wall_segment[i]).adhesion), p.wall_distance[i], p.support) / liquid.density) *
                 p.wall_normal[i];
        p.force[i] = a;
        p.pressure_force[i] = Vec3{};
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

/// Density at the predicted places raises the pressure; errors are summed in millionths so that the sum has no order.
struct CorrectPressure {
    Particles p;
    LiquidParameters liquid;
    Real stiffness;          ///< Pa per kg/m3, delta of the method
    std::int64_t* error_sum; ///< millionths of the rest density
    static constexpr bool wide = true;

    HL_FN void operator()(int i) const
    {
        Pack sum{};
        for_neighbours(p, i, p.predicted,
                       [&](Pack x, Pack y, Pack z, Pack) { sum += spline_kernel(root(x * x + y * y + z * z), p.support); });
        const Real excess = p.mass * (spline_kernel(Real(0), p.support) + sum_of(sum)) - liquid.density;
        p.place[i].w = positive(p.place[i].w + stiffness * excess);
        if (excess > 0) atomic_add(error_sum, static_cast<std::int64_t>(excess / liquid.density * Real(1e6)));
    }
};

struct FindPressureForce {
    Particles p;
    LiquidParameters liquid;
    static constexpr bool wide = true;

    HL_FN void operator()(int i) const
    {
        const Real own = p.place[i].w;
        Pack ax{}, ay{}, az{};
        for_neighbours(p, i, p.place, [&](Pack x, Pack y, Pack z, Pack pressure) {
            const Pack push = (own + pressure) * spline_gradient_factor(root(x * x + y * y + z * z), p.support);
            ax += push * x;
            ay += push * y;
            az += push * z;
        });
        const Real scale = -p.mass / (liquid.density * liquid.density);
        p.pressure_force[i] = {scale * sum_of(ax), scale * sum_of(ay), scale * sum_of(az)};
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
        union {
            float speed;
            int bits;
        } fast;
        fast.speed = static_cast<float>(length(p.velocity[i]));
        atomic_max(fastest, fast.bits);
    }
};

} // namespace hygroloom
