// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The free liquid: predictive-corrective incompressible SPH (Solenthaler and Pajarola 2009), gathered, one functor per pass.
#pragma once

#include "core/physics/fluid_forces.h"
#include "core/physics/sph_kernels.h"
#include "core/solver/steps/neighbours.h"

#include <limits>

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

/// Particles of drops that nothing touches: each drop as a whole, exactly.
struct Fall {
    Particles p;
    Real dt, gained; ///< s; m/s, by which they get faster
    HL_FN void operator()(int i) const
    {
        p.position[i] += dt * (p.velocity[i] - Vec3{0, 0, Real(0.5) * gained});
        p.velocity[i].z -= gained;
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
        constexpr float endless = std::numeric_limits<float>::infinity();
        const auto speed = static_cast<float>(length(p.velocity[i]));
        atomic_max_of_all(fastest, ordered_bits(speed < endless ? speed : endless)); // also where it is no number
    }
};

} // namespace hygroloom::inline HL_PRECISION
