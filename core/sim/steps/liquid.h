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

/// Brings particles into cell order.
struct Reorder {
    const int* order;
    const Vec3* position;
    const Vec3* velocity;
    const Vec3* wall_normal;
    const Real* wall_distance;
    const int* wall_segment;
    const Real* pressure;
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
        to.pressure[i] = pressure[from];
        if (stress) to.stress[i] = stress[from];
        to.alive[i] = key[i] != dead_key;
    }
};

struct FindNeighbours {
    Particles p;
    CellGrid g;
    HL_FN void operator()(int i) const
    {
        const Vec3 x = p.position[i];
        const Real reach = p.reach, within = p.support * p.support;
        const int x0 = g.cell_x(x.x - reach), x1 = g.cell_x(x.x + reach);
        const int y0 = g.cell_y(x.y - reach), y1 = g.cell_y(x.y + reach);
        const int z0 = g.cell_z(x.z - reach), z1 = g.cell_z(x.z + reach);
        int* slots = p.neighbours + static_cast<std::int64_t>(i) * largest_neighbour_count;
        int near = 0, distant = 0;
        for (int z = z0; z <= z1; ++z)
            for (int y = y0; y <= y1; ++y) {
                const int row = (z * g.ny + y) * g.nx;
                // Cells along x lie side by side, and so do their particles.
                for (int j = g.start[row + x0]; j < g.start[row + x1 + 1]; ++j) {
                    const Vec3 d = x - p.position[j];
                    const Real r2 = dot(d, d);
                    if (!(r2 < reach * reach) || j == i) continue;
                    if (r2 < within) {
                        if (near + distant == largest_neighbour_count && distant > 0) --distant; // in a crowd the near ones count
                        if (near + distant < largest_neighbour_count) slots[near++] = j;
                    } else if (near + distant < largest_neighbour_count) {
                        slots[largest_neighbour_count - ++distant] = j;
                    }
                }
            }
        p.near_count[i] = near;
        p.distant_count[i] = distant;
    }
};

/// Runs a sum over the neighbours of i within the support.
template <typename F> HL_FN void for_neighbours(const Particles& p, int i, const F& add)
{
    const int* slots = p.neighbours + static_cast<std::int64_t>(i) * largest_neighbour_count;
    for (int k = 0; k < p.near_count[i]; ++k) add(slots[k]);
}

/// Runs a sum over the other neighbours of i, up to the reach.
template <typename F> HL_FN void for_distant_neighbours(const Particles& p, int i, const F& add)
{
    const int* slots = p.neighbours + (static_cast<std::int64_t>(i) + 1) * largest_neighbour_count;
    for (int k = 1; k <= p.distant_count[i]; ++k) add(slots[-k]);
}

/// The liquid's share of the space round each particle and how it changes, where a wall counts as liquid; and the pull and the tilt
/// that follow.
struct FindSurface {
    Particles p;
    LiquidParameters liquid;
    HL_FN void operator()(int i) const
    {
        const Real volume = p.mass / liquid.density;
        const Vec3 x = p.position[i];
        Real share = volume * spline_kernel(0, p.reach);
        Vec3 slope;
        const auto add = [&](int j) {
            const Vec3 d = x - p.position[j];
            const Real r = length(d);
            share += volume * spline_kernel(r, p.reach);
            slope += (volume * spline_gradient_factor(r, p.reach)) * d;
        };
        for_neighbours(p, i, add);
        for_distant_neighbours(p, i, add);
        if (p.at_wall(i)) {
            share += kernel_beyond_plane(p.wall_distance[i], p.reach);
            slope -= kernel_in_plane(p.wall_distance[i], p.reach) * p.wall_normal[i];
        }
        p.pull[i] = liquid.surface.pull(share);
        p.tilt[i] = liquid.surface.tilt(slope);
    }
};

/// Accelerations by gravity, viscosity (Monaghan's pair form), surface tension and adhesion. Departs from the paper: eq. 5's cohesion
/// presses a drop a hundred times harder than its surface tension does. A wall counts as liquid, so that it attracts with what its work
/// of adhesion is over the surface tension, or repels.
struct FindForces {
    Particles p;
    LiquidParameters liquid;
    Yarns yarns;
    HL_FN void operator()(int i) const
    {
        const Real volume = p.mass / liquid.density;
        const Vec3 x = p.position[i], v = p.velocity[i];
        const Real smallest = Real(0.01) * p.support * p.support;
        const Real per_force = volume / liquid.density;
        const Real own_pull = p.pull[i];
        const Vec3 own_tilt = p.tilt[i];
        Vec3 a{0, 0, -liquid.gravity};
        Real sum = spline_kernel(0, p.support);
        const auto add_surface = [&](int j) {
            a += per_force * surface_force(own_pull + p.pull[j], own_tilt - p.tilt[j], x - p.position[j], p.reach);
        };
        for_neighbours(p, i, [&](int j) {
            const Vec3 d = x - p.position[j];
            const Real r2 = dot(d, d);
            sum += spline_kernel(std::sqrt(r2), p.support);
            a += (Real(10) * liquid.kinematic_viscosity * volume * dot(v - p.velocity[j], d) / (r2 + smallest) *
                  spline_gradient_factor(std::sqrt(r2), p.support)) *
                 d;
            add_surface(j);
        });
        for_distant_neighbours(p, i, add_surface);
        Real excess = p.mass * sum - liquid.density;
        if (p.at_wall(i)) {
            const Real distance = p.wall_distance[i];
            excess += liquid.density * kernel_beyond_plane(distance, p.support);
            const Real adhesion =
                p.wall_segment[i] >= 0 ? static_cast<Real>(yarns.yarn_of(p.wall_segment[i]).adhesion) : liquid.vessel.adhesion;
            const Real push = surface_force_of_wall(own_pull, dot(own_tilt, p.wall_normal[i]), distance, p.reach) -
                              (distance > 0 ? wall_pull(adhesion - liquid.surface_tension, distance, p.support) : Real(0));
            a += (push / liquid.density) * p.wall_normal[i];
        }
        p.force[i] = a;
        p.allowed[i] = excess > 0 ? liquid.kept_excess * excess : Real(0);
        p.pressure[i] *= kept_pressure;
    }
};

struct PredictPosition {
    Particles p;
    Real dt;
    HL_FN void operator()(int i) const
    {
        const Vec3 v = p.velocity[i] + dt * (p.force[i] + p.pressure_force[i]);
        p.predicted[i] = p.position[i] + dt * v;
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
    HL_FN void operator()(int i) const
    {
        const Vec3 x = p.predicted[i];
        Real sum = spline_kernel(0, p.support);
        for_neighbours(p, i, [&](int j) { sum += spline_kernel(length(x - p.predicted[j]), p.support); });
        Real density = p.mass * sum;
        if (p.at_wall(i))
            density += liquid.density * kernel_beyond_plane(p.wall_distance[i] + dot(x - p.position[i], p.wall_normal[i]), p.support);
        const Real excess = density - liquid.density;
        const Real pressure = p.pressure[i] + stiffness * (excess - p.allowed[i]);
        p.pressure[i] = pressure > 0 ? pressure : Real(0);
        if (excess > 0) atomic_add(error_sum, static_cast<std::int64_t>(excess / liquid.density * Real(1e6)));
    }
};

/// A wall carries the pressure of the particle before it, as if the liquid went on behind it.
struct FindPressureForce {
    Particles p;
    LiquidParameters liquid;
    HL_FN void operator()(int i) const
    {
        const Real scale = p.mass / (liquid.density * liquid.density);
        Vec3 a;
        for_neighbours(p, i, [&](int j) {
            const Vec3 d = p.position[i] - p.position[j];
            a += (scale * (p.pressure[i] + p.pressure[j]) * spline_gradient_factor(length(d), p.support)) * d;
        });
        if (p.at_wall(i))
            a -= (Real(2) * p.pressure[i] / liquid.density * kernel_in_plane(p.wall_distance[i], p.support)) * p.wall_normal[i];
        p.pressure_force[i] = -a;
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
        Real sum = 0;
        const auto add = [&](int j) {
            const Vec3 d = p.position[i] - p.position[j];
            sum += dot(surface_force(p.pull[i] + p.pull[j], p.tilt[i] - p.tilt[j], d, p.reach), d);
        };
        for_neighbours(p, i, [&](int j) {
            const Vec3 d = p.position[i] - p.position[j];
            sum -= (p.pressure[i] + p.pressure[j]) * spline_gradient_factor(length(d), p.support) * dot(d, d);
            add(j);
        });
        for_distant_neighbours(p, i, add);
        p.stress[i] = volume * sum / Real(6);
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
