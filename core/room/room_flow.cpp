// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/room/room_flow.h"

#include "core/room/liquid_voxels.h"

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

using Numbers = Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

constexpr double precise = 1e-8; // of the residual
constexpr double anchor = 1e-10; // of a diagonal: fixes the pressure of liquid that touches nothing else

Numbers solved(const Matrix& matrix, const Numbers& right)
{
    Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper,
                             Eigen::IncompleteCholesky<double, Eigen::Lower, Eigen::NaturalOrdering<int>>>
        solver;
    solver.setTolerance(precise);
    solver.setMaxIterations(2000);
    solver.compute(matrix);
    return solver.solve(right);
}

/// The liquid of a room and how mobile it is.
class MobileLiquid {
public:
    MobileLiquid(const DrawnLayer& layer, double growth, const std::vector<std::uint8_t>& air) : layer_(layer), liquid_(layer, growth, air)
    {
        find_mobility(air);
    }
    bool none() const { return liquid_.places().empty(); }

    AlongRoom along(bool warp) const;
    double through() const;

private:
    using Place = LiquidVoxels::Place;
    /// m2, where the liquid of two voxels meets.
    double between(int a, int b) const { return 2 * mobility_[a] * mobility_[b] / (mobility_[a] + mobility_[b]); }
    double side(int axis) const { return axis == 0 ? layer_.dx : axis == 1 ? layer_.dy : layer_.dz; }
    void find_mobility(const std::vector<std::uint8_t>& air);
    /// In a mean gradient of 1 along x or y: what it is beyond that gradient's own.
    Numbers pressure_along(int axis) const;

    const DrawnLayer& layer_;
    LiquidVoxels liquid_;
    Numbers mobility_; // m2
};

/// Rows that come one after the other, each with a diagonal and what lies beside it.
class Rows {
public:
    explicit Rows(std::size_t count) { entries_.reserve(7 * count); }
    void beside(int row, int column, double coupling)
    {
        diagonal_ += coupling;
        if (column != row)
            entries_.emplace_back(row, column, -coupling);
        else
            diagonal_ -= coupling; // a period of one voxel meets itself
    }
    void wall(double coupling) { diagonal_ += coupling; }
    void close(int row, double least)
    {
        entries_.emplace_back(row, row, diagonal_ + anchor * std::max(diagonal_, least));
        diagonal_ = 0;
    }
    Matrix matrix(std::size_t count) const
    {
        const auto n = static_cast<Eigen::Index>(count);
        Matrix made(n, n);
        made.setFromTriplets(entries_.begin(), entries_.end());
        return made;
    }

private:
    std::vector<Eigen::Triplet<double>> entries_;
    double diagonal_ = 0;
};

void MobileLiquid::find_mobility(const std::vector<std::uint8_t>& air)
{
    const std::vector<Place>& places = liquid_.places();
    Rows rows(places.size());
    for (std::size_t k = 0; k < places.size(); ++k) {
        const double own = liquid_.outside(places[k]);
        for (int axis = 0; axis < 3; ++axis)
            for (int step : {-1, 1}) {
                const auto next = liquid_.beside(places[k], axis, step);
                if (!next || (!air.empty() && air[liquid_.at(*next)])) continue; // air lets it slip
                const double per_area = 1 / (side(axis) * side(axis));
                if (liquid_.number(*next) >= 0)
                    rows.beside(static_cast<int>(k), liquid_.number(*next), per_area);
                else
                    rows.wall(per_area / std::clamp(own / (own - liquid_.outside(*next)), nearest_wall, 1.0));
            }
        rows.close(static_cast<int>(k), 1 / (side(0) * side(0)));
    }
    mobility_ = solved(rows.matrix(places.size()), Numbers::Ones(static_cast<Eigen::Index>(places.size())));
}

/// A cell of crossings in a mean gradient of 1 along one system: the permeability that those of its crossings come to.
double joined(const DrawnLayer& layer, const std::vector<double>& along_warp, const std::vector<double>& along_weft, bool warp)
{
    const WovenCell cell = layer.cell();
    const int n = cell.crossings();
    const double shape = layer.per_end * layer.dx / (layer.per_pick * layer.dy); // joint along an end: permeability x width / length
    const auto in_series = [](double a, double b) { return a > 0 && b > 0 ? 2 * a * b / (a + b) : 0.0; };
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
    Numbers right = Numbers::Zero(n);
    double direct = 0;
    const auto join = [&](int from, int to, double conducts, bool driven) {
        matrix(from, from) += conducts;
        matrix(to, to) += conducts;
        matrix(from, to) -= conducts;
        matrix(to, from) -= conducts;
        if (!driven) return;
        right(from) += conducts;
        right(to) -= conducts;
        direct += conducts;
    };
    for (int end = 0; end < cell.ends; ++end)
        for (int pick = 0; pick < cell.picks; ++pick) {
            const std::size_t here = cell.crossing(end, pick), up = cell.crossing(end, pick + 1), beside = cell.crossing(end + 1, pick);
            join(static_cast<int>(here), static_cast<int>(up), shape * in_series(along_warp[here], along_warp[up]), warp);
            join(static_cast<int>(here), static_cast<int>(beside), in_series(along_weft[here], along_weft[beside]) / shape, !warp);
        }
    if (direct <= 0) return 0;
    matrix.diagonal().array() += anchor * matrix.diagonal().maxCoeff();
    const Numbers pressure = matrix.ldlt().solve(right);
    const double flow = direct - right.dot(pressure); // of all joints, each in a pressure difference of 1
    return warp ? flow / (shape * n) : flow * shape / n;
}

Numbers MobileLiquid::pressure_along(int axis) const
{
    const std::vector<Place>& places = liquid_.places();
    const double h = side(axis);
    Rows rows(places.size());
    Numbers right = Numbers::Zero(static_cast<Eigen::Index>(places.size()));
    for (std::size_t k = 0; k < places.size(); ++k) {
        const auto own = static_cast<int>(k);
        for (int a = 0; a < 3; ++a)
            for (int step : {-1, 1}) {
                const auto next = liquid_.beside(places[k], a, step);
                if (!next || liquid_.number(*next) < 0) continue;
                const double conducts = between(own, liquid_.number(*next));
                rows.beside(own, liquid_.number(*next), conducts / (side(a) * side(a)));
                if (a == axis) right[own] += step * conducts / h;
            }
        rows.close(own, mobility_[own] / (h * h));
    }
    return solved(rows.matrix(places.size()), right);
}

AlongRoom MobileLiquid::along(bool warp) const
{
    const std::vector<Place>& places = liquid_.places();
    const int axis = warp ? 1 : 0;
    const double h = side(axis);
    const Numbers pressure = pressure_along(axis);

    // Of each slice of each crossing across the flow: what flows, and the mean gradient.
    struct Slice {
        double flows = 0, gradient = 0, faces = 0;
    };
    const int slices = warp ? layer_.per_pick : layer_.per_end, across = warp ? layer_.per_end : layer_.per_pick;
    const std::size_t crossings = static_cast<std::size_t>(layer_.cell().crossings());
    std::vector<Slice> of_slice(crossings * static_cast<std::size_t>(slices));
    double lower = 0, upper = 0;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const auto next = liquid_.beside(places[k], axis, 1);
        if (!next || liquid_.number(*next) < 0) continue;
        const auto own = static_cast<int>(k);
        const double gradient = 1 + (pressure[liquid_.number(*next)] - pressure[own]) / h;
        const int at = (warp ? places[k].y : places[k].x) % slices;
        Slice& slice = of_slice[static_cast<std::size_t>(layer_.crossing(places[k].x, places[k].y) * slices + at)];
        const double flows = between(own, liquid_.number(*next)) * gradient;
        slice.flows += flows;
        (2 * places[k].z < layer_.first() + layer_.last() ? lower : upper) += flows;
        if (2 * places[k].z == layer_.first() + layer_.last()) { // the layer in the middle is of both
            upper -= 0.5 * flows;
            lower += 0.5 * flows;
        }
        slice.gradient += gradient;
        slice.faces += 1;
    }
    const double section = across * (layer_.last() - layer_.first() + 1.0); // in faces
    AlongRoom found;
    for (std::size_t c = 0; c < crossings; ++c) {
        double flows = 0, gradient = 0, open = 0;
        for (int s = 0; s < slices; ++s) {
            const Slice& slice = of_slice[c * static_cast<std::size_t>(slices) + static_cast<std::size_t>(s)];
            flows += slice.flows / section / slices;
            if (slice.faces <= 0) continue;
            gradient += slice.gradient / slice.faces;
            open += 1;
        }
        found.mean += flows / static_cast<double>(crossings);
        found.places.push_back(gradient > 0 ? flows * open / gradient : 0.0);
    }
    const double half_sections = 0.5 * section * slices * static_cast<double>(crossings);
    found.lower = lower / half_sections;
    found.upper = upper / half_sections;
    constexpr double least = 1e-3; // of the mean: where flow turns back it is no measure of what conducts it
    for (double& place : found.places) place = std::max(place, least * found.mean);
    return found;
}

double MobileLiquid::through() const
{
    const std::vector<Place>& places = liquid_.places();
    const double h = side(2);
    Rows rows(places.size());
    Numbers right = Numbers::Zero(static_cast<Eigen::Index>(places.size()));
    const auto to_face = [&](int own) { return 2 * mobility_[own] / (h * h); }; // half a voxel away; the pressure is 1 on the upper one
    for (std::size_t k = 0; k < places.size(); ++k) {
        const auto own = static_cast<int>(k);
        for (int a = 0; a < 3; ++a)
            for (int step : {-1, 1})
                if (const auto next = liquid_.beside(places[k], a, step); next && liquid_.number(*next) >= 0)
                    rows.beside(own, liquid_.number(*next), between(own, liquid_.number(*next)) / (side(a) * side(a)));
        if (places[k].z == layer_.first()) rows.wall(to_face(own));
        if (places[k].z == layer_.last()) {
            rows.wall(to_face(own));
            right[own] = to_face(own);
        }
        rows.close(own, mobility_[own] / (h * h));
    }
    const Numbers pressure = solved(rows.matrix(places.size()), right);
    double flows = 0; // out of the lower face, per area of a voxel
    for (std::size_t k = 0; k < places.size(); ++k)
        if (places[k].z == layer_.first()) flows += to_face(static_cast<int>(k)) * h * pressure[static_cast<Eigen::Index>(k)];
    const double thickness = h * (layer_.last() - layer_.first() + 1.0);
    return flows * thickness / (static_cast<double>(layer_.grid.nx) * layer_.grid.ny);
}

} // namespace

double permeability_through(const DrawnLayer& layer, double growth)
{
    const MobileLiquid liquid(layer, growth, {});
    return liquid.none() ? 0 : liquid.through();
}

RoomPermeability room_permeability(const DrawnLayer& layer, double growth, const std::vector<std::uint8_t>& air)
{
    const auto crossings = static_cast<std::size_t>(layer.cell().crossings());
    const MobileLiquid liquid(layer, growth, air);
    if (liquid.none()) {
        const AlongRoom nothing{0, 0, 0, std::vector<double>(crossings, 0.0)};
        return {nothing, nothing};
    }
    RoomPermeability found{liquid.along(true), liquid.along(false)};
    for (int round = 0; round < 3; ++round) // each system's joints carry some of the other's flow
        for (bool warp : {true, false}) {
            AlongRoom& own = warp ? found.warp : found.weft;
            const double all = joined(layer, found.warp.places, found.weft.places, warp);
            for (double& place : own.places) place *= all > 0 ? own.mean / all : 0.0;
        }
    return found;
}

} // namespace hygroloom
