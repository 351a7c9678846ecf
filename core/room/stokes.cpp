// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/room/stokes.h"

#include "core/base/error.h"
#include "core/room/liquid_voxels.h"

#include <Eigen/Sparse>
#include <unsupported/Eigen/IterativeSolvers>

#include <algorithm>
#include <array>
#include <cmath>

namespace hygroloom {
namespace {

using Numbers = Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;

/// Of velocities as a Laplacian has it, of pressures nothing.
class StokesPreconditioner {
public:
    StokesPreconditioner() = default;
    template <typename Any> explicit StokesPreconditioner(const Any& matrix) { compute(matrix); }
    void of_velocities(const Matrix& laplacian)
    {
        velocities_ = laplacian.rows();
        cholesky_.compute(laplacian);
    }
    template <typename Any> StokesPreconditioner& analyzePattern(const Any&) { return *this; }
    template <typename Any> StokesPreconditioner& factorize(const Any&) { return *this; }
    template <typename Any> StokesPreconditioner& compute(const Any&) { return *this; }
    Eigen::ComputationInfo info() const { return Eigen::Success; }
    Numbers solve(const Numbers& right) const
    {
        Numbers found = right;
        found.head(velocities_) = cholesky_.solve(right.head(velocities_));
        return found;
    }

private:
    Eigen::Index velocities_ = 0;
    Eigen::IncompleteCholesky<double, Eigen::Lower, Eigen::NaturalOrdering<int>> cholesky_;
};

/// Velocities stand on the sides between voxels of liquid, pressures in their middles. Lengths in sides of a voxel.
class StokesFlow {
public:
    StokesFlow(const DrawnLayer& layer, double growth, std::optional<int> spacing = {}, double drag = 0)
        : layer_(layer), liquid_(layer, growth, {}, spacing), drag_(drag * layer.side() * layer.side())
    {
        const double side = layer.side();
        length_ = {layer.dx / side, layer.dy / side, layer.dz / side};
        for (int axis = 0; axis < 3; ++axis) {
            first_[static_cast<std::size_t>(axis)] = static_cast<int>(sides_.size());
            velocity_[static_cast<std::size_t>(axis)].assign(layer.grid.size(), -1);
            for (const Place& p : liquid_.places()) {
                const auto before = liquid_.beside(p, axis, -1);
                if (!before || liquid_.number(*before) < 0) continue;
                velocity_[static_cast<std::size_t>(axis)][liquid_.at(p)] = static_cast<int>(sides_.size());
                sides_.push_back({p, *before});
            }
        }
        first_[3] = static_cast<int>(sides_.size());
    }
    double permeability(bool along_warp) const;
    FlowThrough through() const;

private:
    using Place = LiquidVoxels::Place;
    struct Side {
        Place here, before;
    };
    /// What the velocity on a side loses to what lies beside it; the neighbour's number, or none where that stands still or slips.
    struct Beside {
        double couples = 0;
        int next = -1;
    };
    Beside beside(const Side& side, int own, int axis, int step) const
    {
        const double per_area = 1 / (length_[static_cast<std::size_t>(axis)] * length_[static_cast<std::size_t>(axis)]);
        const auto here = liquid_.beside(side.here, axis, step), before = liquid_.beside(side.before, axis, step);
        if (!here || !before) return {axis == own ? per_area : 0.0, -1};
        const int next = velocity_[static_cast<std::size_t>(own)][liquid_.at(*here)];
        if (next >= 0) return {per_area, next};
        const double there = 0.5 * (liquid_.outside(*here) + liquid_.outside(*before)),
                     inside = 0.5 * (liquid_.outside(side.here) + liquid_.outside(side.before));
        const double part = there < 0 && inside > 0 ? std::clamp(inside / (inside - there), nearest_wall, 1.0) : 1.0;
        return {per_area / part, -1};
    }

    /// Velocities under a unit force along an axis, with so much of the residual left. Throws Error where more is left.
    Numbers driven_along(int driven, double residual) const;

    const DrawnLayer& layer_;
    LiquidVoxels liquid_; // a pressure in each
    double drag_;
    std::array<double, 3> length_{};
    std::array<std::vector<int>, 3> velocity_; // number of the one on each voxel's lower side
    std::array<int, 4> first_{};
    std::vector<Side> sides_; // with a velocity: all along x, then y, then z
};

Numbers StokesFlow::driven_along(int driven, double residual) const
{
    const int velocities = first_[3], all = velocities + static_cast<int>(liquid_.places().size());
    std::vector<Eigen::Triplet<double>> laplacian, whole;
    Numbers right = Numbers::Zero(all);
    for (int axis = 0; axis < 3; ++axis)
        for (int u = first_[static_cast<std::size_t>(axis)]; u < first_[static_cast<std::size_t>(axis) + 1]; ++u) {
            const Side& side = sides_[static_cast<std::size_t>(u)];
            double diagonal = drag_;
            for (int across = 0; across < 3; ++across)
                for (int step : {-1, 1}) {
                    const Beside next = beside(side, axis, across, step);
                    diagonal += next.couples;
                    if (next.next >= 0) laplacian.emplace_back(u, next.next, -next.couples);
                }
            laplacian.emplace_back(u, u, diagonal);
            const double gradient = 1 / length_[static_cast<std::size_t>(axis)];
            for (const auto& [place, sign] : {std::pair{side.here, 1.0}, std::pair{side.before, -1.0}}) {
                const int p = velocities + liquid_.number(place);
                whole.emplace_back(u, p, sign * gradient);
                whole.emplace_back(p, u, sign * gradient);
            }
            if (axis == driven) right[u] = 1;
        }
    Matrix of_velocities(velocities, velocities), matrix(all, all);
    of_velocities.setFromTriplets(laplacian.begin(), laplacian.end());
    whole.insert(whole.end(), laplacian.begin(), laplacian.end());
    matrix.setFromTriplets(whole.begin(), whole.end());
    Eigen::MINRES<Matrix, Eigen::Lower | Eigen::Upper, StokesPreconditioner> solver;
    solver.preconditioner().of_velocities(of_velocities);
    solver.setTolerance(residual);
    solver.setMaxIterations(3000);
    solver.compute(matrix);
    const Numbers found = solver.solve(right);
    if (solver.info() != Eigen::Success)
        throw Error("The flow between the drawn yarns could not be computed: its equations were not solved.");
    return found.head(velocities);
}

double StokesFlow::permeability(bool along_warp) const
{
    if (first_[3] == 0) return 0;
    const int driven = along_warp ? 1 : 0;
    const auto from = static_cast<std::size_t>(driven);
    Numbers along = Numbers::Zero(first_[3]);
    along.segment(first_[from], first_[from + 1] - first_[from]).setOnes();
    const double flow = along.dot(driven_along(driven, 1e-5)), side = layer_.side();
    return flow * side * side / (layer_.grid.nx * layer_.grid.ny * static_cast<double>(liquid_.layers()));
}

FlowThrough StokesFlow::through() const
{
    if (first_[3] == first_[2]) return {};
    const Numbers found = driven_along(2, 1e-4);
    struct Section {
        double speed = 0, momentum = 0, energy = 0;
    };
    std::vector<Section> sections(static_cast<std::size_t>(layer_.grid.nz));
    for (int u = first_[2]; u < first_[3]; ++u) {
        const double speed = found[u];
        Section& section = sections[static_cast<std::size_t>(sides_[static_cast<std::size_t>(u)].here.z)];
        section.speed += speed;
        section.momentum += speed * speed;
        section.energy += speed * speed * speed;
    }
    const double area = static_cast<double>(layer_.grid.nx) * layer_.grid.ny, side = layer_.side();
    double mean = 0;
    for (const Section& section : sections) mean += section.speed / (area * liquid_.layers());
    if (!(mean > 0)) return {};
    FlowThrough through{liquid_.layers() * layer_.dz / (mean * side * side), 0};
    for (const Section& section : sections)
        through.loss =
            std::max(through.loss, section.energy / (area * mean * mean * mean) - 2 * section.momentum / (area * mean * mean) + 1);
    return through;
}

} // namespace

double stokes_permeability(const DrawnLayer& layer, double growth, bool along_warp)
try {
    return StokesFlow(layer, growth).permeability(along_warp);
} catch (const Error& error) {
    throw Error(std::string(error.what()) + " Choose the fidelity draft, which does without it.");
}

FlowThrough flow_through(const DrawnLayer& layer, double growth, double drag)
{
    const double pitch = std::sqrt(layer.per_end * layer.dx * layer.per_pick * layer.dy);
    const int spacing = std::clamp(static_cast<int>(std::lround((pitch / 6 + std::max(0.0, growth)) / layer.dz)), 1, layer.margin);
    return StokesFlow(layer, growth, spacing, drag).through();
}

} // namespace hygroloom
