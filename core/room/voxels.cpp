// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/room/voxels.h"

#include <array>
#include <limits>

namespace hygroloom {
namespace {

/// One line of the transform: least of value[j] + (i - j)^2 over all j.
class Envelope {
public:
    /// Of a line whose first and last `reach` values stand for what lies beyond its ends; the others are replaced.
    void lower(std::vector<int>& line, int reach)
    {
        place_.clear();
        from_.clear();
        const int n = static_cast<int>(line.size());
        for (int j = 0; j < n; ++j)
            if (line[static_cast<std::size_t>(j)] < far_away) add(j, line);
        if (place_.empty()) return;
        result_.resize(line.size());
        std::size_t k = 0;
        for (int i = reach; i < n - reach; ++i) {
            while (k + 1 < place_.size() && from_[k + 1] <= i) ++k;
            const int off = i - place_[k];
            result_[static_cast<std::size_t>(i)] = line[static_cast<std::size_t>(place_[k])] + off * off;
        }
        line.swap(result_);
    }

private:
    void add(int j, const std::vector<int>& line)
    {
        const double own = line[static_cast<std::size_t>(j)];
        double start = -std::numeric_limits<double>::infinity();
        while (!place_.empty()) {
            const int p = place_.back();
            start = 0.5 * ((own - line[static_cast<std::size_t>(p)]) / (j - p) + j + p); // where both are as low
            if (start > from_.back()) break;
            place_.pop_back();
            from_.pop_back();
            start = -std::numeric_limits<double>::infinity();
        }
        place_.push_back(j);
        from_.push_back(start);
    }
    std::vector<int> place_, result_;
    std::vector<double> from_; // where each parabola begins to be the lowest
};

struct Axis {
    std::size_t stride;
    int length;
    bool repeats;
};
std::array<Axis, 3> axes_of(const VoxelGrid& g)
{
    const auto row = static_cast<std::size_t>(g.nx);
    return {{{1, g.nx, g.repeats}, {row, g.ny, g.repeats}, {row * static_cast<std::size_t>(g.ny), g.sections ? 1 : g.nz, false}}};
}

void transform_along(const VoxelGrid& grid, const Axis& axis, std::vector<int>& squared)
{
    if (axis.length < 2) return;
    Envelope envelope;
    const auto n = static_cast<std::size_t>(axis.length), reach = axis.repeats ? (n + 1) / 2 : 0; // no nearest lies farther
    std::vector<int> line(n + 2 * reach);
    const std::size_t block = axis.stride * n;
    for (std::size_t first = 0; first < grid.size(); first += block)
        for (std::size_t start = first; start < first + axis.stride; ++start) {
            for (std::size_t i = 0; i < n; ++i) line[reach + i] = squared[start + i * axis.stride];
            for (std::size_t i = 0; i < reach; ++i) {
                line[i] = line[i + n];
                line[reach + n + i] = line[reach + i];
            }
            envelope.lower(line, static_cast<int>(reach));
            for (std::size_t i = 0; i < n; ++i) squared[start + i * axis.stride] = line[reach + i];
        }
}

} // namespace

std::vector<int> squared_distances(const VoxelGrid& grid, const std::vector<std::uint8_t>& marked)
{
    std::vector<int> squared(grid.size());
    for (std::size_t i = 0; i < squared.size(); ++i) squared[i] = marked[i] ? 0 : far_away;
    for (const Axis& axis : axes_of(grid)) transform_along(grid, axis, squared);
    return squared;
}

} // namespace hygroloom
