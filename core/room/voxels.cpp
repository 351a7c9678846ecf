// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/room/voxels.h"

#include <array>
#include <limits>
#include <numeric>

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
            if (line[static_cast<std::size_t>(j)] < nothing_near) add(j, line);
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

/// Lines of voxels of one length.
class Lines {
public:
    Lines(std::size_t length, bool repeat) : n_(length), reach_(repeat ? (n_ + 1) / 2 : 0), line_(n_ + 2 * reach_) {}
    /// at: number of each of its voxels.
    template <typename At> void transform(std::vector<int>& squared, const At& at)
    {
        for (std::size_t i = 0; i < n_; ++i) line_[reach_ + i] = squared[at(i)];
        for (std::size_t i = 0; i < reach_; ++i) {
            line_[i] = line_[i + n_];
            line_[reach_ + n_ + i] = line_[reach_ + i];
        }
        envelope_.lower(line_, static_cast<int>(reach_));
        for (std::size_t i = 0; i < n_; ++i) squared[at(i)] = line_[reach_ + i];
    }

private:
    std::size_t n_, reach_; // no nearest lies farther
    std::vector<int> line_;
    Envelope envelope_;
};

void transform_along(const VoxelGrid& grid, const Axis& axis, std::vector<int>& squared)
{
    if (axis.length < 2) return;
    Lines lines(static_cast<std::size_t>(axis.length), axis.repeats);
    const std::size_t block = axis.stride * static_cast<std::size_t>(axis.length);
    for (std::size_t first = 0; first < grid.size(); first += block)
        for (std::size_t start = first; start < first + axis.stride; ++start)
            lines.transform(squared, [&](std::size_t i) { return start + i * axis.stride; });
}

/// Rows along x that go on in each other, until they come back to the first.
void transform_skewed(const VoxelGrid& grid, std::vector<int>& squared)
{
    const int apart = std::gcd(grid.skew, grid.ny), rows = grid.ny / apart;
    std::vector<std::size_t> at(static_cast<std::size_t>(rows) * static_cast<std::size_t>(grid.nx));
    Lines lines(at.size(), true);
    for (int first = 0; first < apart; ++first) {
        for (std::size_t i = 0; i < at.size(); ++i) {
            int x = static_cast<int>(i), y = first;
            grid.wrap(x, y);
            at[i] = grid.at(x, y, 0);
        }
        for (int z = 0; z < grid.nz; ++z) lines.transform(squared, [&, layer = grid.at(0, 0, z)](std::size_t i) { return layer + at[i]; });
    }
}

} // namespace

std::vector<int> squared_distances(const VoxelGrid& grid, const std::vector<std::uint8_t>& marked)
{
    std::vector<int> squared(grid.size());
    for (std::size_t i = 0; i < squared.size(); ++i) squared[i] = marked[i] ? 0 : nothing_near;
    const auto [x, y, z] = axes_of(grid);
    if (grid.repeats && grid.skew > 0)
        transform_skewed(grid, squared);
    else
        transform_along(grid, x, squared);
    transform_along(grid, y, squared);
    transform_along(grid, z, squared);
    return squared;
}

} // namespace hygroloom
