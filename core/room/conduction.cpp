// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/room/conduction.h"

#include "core/base/error.h"

#include <Eigen/Sparse>

#include <algorithm>

namespace hygroloom {
namespace {

using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using Numbers = Eigen::VectorXd;

std::vector<double> conductivities(const DrawnLayer& layer, double growth, double room, double yarns)
{
    std::vector<double> all(layer.grid.size());
    const double per_side = 1 / layer.side();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const double open = std::clamp(0.5 + (static_cast<double>(layer.outside[i]) - growth) * per_side, 0.0, 1.0);
        all[i] = open * room + (1 - open) * yarns;
    }
    return all;
}

} // namespace

double conductivity_through(const DrawnLayer& layer, double growth, double room, double yarns)
{
    const std::vector<double> of = conductivities(layer, growth, room, yarns);
    const VoxelGrid& grid = layer.grid;
    const std::size_t first = grid.at(0, 0, layer.first()), voxels = grid.at(0, 0, layer.last() + 1) - first;
    const auto row = [&](std::size_t voxel) { return static_cast<int>(voxel - first); };
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(7 * voxels);
    std::vector<double> diagonal(voxels, 0);
    Numbers right = Numbers::Zero(static_cast<Eigen::Index>(voxels));
    const auto join = [&](std::size_t a, std::size_t b, double side) { // each pair once
        if (a == b) return;                                            // a period of one voxel meets itself
        const double conducts = 2 * of[a] * of[b] / (of[a] + of[b]) / (side * side);
        entries.emplace_back(row(a), row(b), -conducts);
        entries.emplace_back(row(b), row(a), -conducts);
        diagonal[static_cast<std::size_t>(row(a))] += conducts;
        diagonal[static_cast<std::size_t>(row(b))] += conducts;
    };
    const auto to_face = [&](std::size_t voxel) { return 2 * of[voxel] / (layer.dz * layer.dz); }; // half a voxel away
    for (int z = layer.first(); z <= layer.last(); ++z)
        for (int y = 0; y < grid.ny; ++y)
            for (int x = 0; x < grid.nx; ++x) {
                const std::size_t own = grid.at(x, y, z);
                int beside_x = x + 1, beside_y = y, up_x = x, up_y = y + 1;
                grid.wrap(beside_x, beside_y);
                grid.wrap(up_x, up_y);
                join(own, grid.at(beside_x, beside_y, z), layer.dx);
                join(own, grid.at(up_x, up_y, z), layer.dy);
                if (z < layer.last()) join(own, grid.at(x, y, z + 1), layer.dz);
                if (z == layer.first()) diagonal[static_cast<std::size_t>(row(own))] += to_face(own);
                if (z == layer.last()) {
                    diagonal[static_cast<std::size_t>(row(own))] += to_face(own);
                    right[row(own)] = to_face(own); // the upper face is at 1, the lower one at 0
                }
            }
    for (std::size_t i = 0; i < voxels; ++i) entries.emplace_back(static_cast<int>(i), static_cast<int>(i), diagonal[i]);
    Matrix matrix(static_cast<Eigen::Index>(voxels), static_cast<Eigen::Index>(voxels));
    matrix.setFromTriplets(entries.begin(), entries.end());
    Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper,
                             Eigen::IncompleteCholesky<double, Eigen::Lower, Eigen::NaturalOrdering<int>>>
        solver;
    solver.setTolerance(1e-7);
    solver.compute(matrix);
    const Numbers found = solver.solve(right);
    if (solver.info() != Eigen::Success) throw Error("What the drawn yarns conduct could not be computed: its equations were not solved.");
    double flows = 0; // through the lower face, over the area of a voxel
    for (int i = 0; i < grid.nx * grid.ny; ++i) flows += to_face(first + static_cast<std::size_t>(i)) * layer.dz * found[i];
    const double thickness = layer.dz * (layer.last() - layer.first() + 1.0);
    return flows * thickness / (static_cast<double>(grid.nx) * grid.ny);
}

} // namespace hygroloom
