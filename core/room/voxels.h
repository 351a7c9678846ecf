// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A block of voxels, and distances in it. Lengths in voxels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hygroloom {

/// A block of voxels; x runs fastest.
struct VoxelGrid {
    int nx = 1, ny = 1, nz = 1;
    bool repeats = false;  ///< in x and y, as cloth does
    bool sections = false; ///< each layer of z is a section of its own: balls are discs in it
    int skew = 0;          ///< of what repeats: beyond its last x it begins anew, so many voxels of y higher; 0 .. ny - 1

    std::size_t size() const { return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny) * static_cast<std::size_t>(nz); }
    std::size_t at(int x, int y, int z) const
    {
        return (static_cast<std::size_t>(z) * static_cast<std::size_t>(ny) + static_cast<std::size_t>(y)) * static_cast<std::size_t>(nx) +
               static_cast<std::size_t>(x);
    }
    /// Of what repeats: brings a place beside the block to the one within that it is alike.
    void wrap(int& x, int& y) const
    {
        for (; x < 0; x += nx) y += skew;
        for (; x >= nx; x -= nx) y -= skew;
        if (y < 0 || y >= ny) y = ((y % ny) + ny) % ny;
    }
};

constexpr int nothing_near = 1 << 28; ///< squared distance where there is nothing to be near to

/// Squared distance of each voxel's middle to the nearest marked one's, exact: a lower envelope of parabolas along each axis in turn
/// (Felzenszwalb and Huttenlocher 2012).
std::vector<int> squared_distances(const VoxelGrid& grid, const std::vector<std::uint8_t>& marked);

} // namespace hygroloom
