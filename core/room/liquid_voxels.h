// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Which voxels of a drawn layer hold liquid, and which lie beside which.
#pragma once

#include "core/room/drawn_layer.h"

#include <optional>

namespace hygroloom {

constexpr double nearest_wall = 0.15; ///< of a voxel's side: a skin is not taken for nearer to its middle

class LiquidVoxels {
public:
    struct Place {
        int x, y, z;
    };
    /// Of a layer whose yarns have grown so much (m), which must outlive it. air: of each voxel, whether it holds air; empty: none does.
    /// spacing: voxels of what flows over the cloth, and as many below it, in a stack of such layers without end; none: one layer, whose
    /// faces are its last voxels.
    LiquidVoxels(const DrawnLayer& layer, double growth, const std::vector<std::uint8_t>& air = {}, std::optional<int> spacing = {})
        : layer_(layer), growth_(growth), number_(layer.grid.size(), -1), is_stack_(spacing.has_value()),
          first_(layer.first() - spacing.value_or(0)), last_(layer.last() + spacing.value_or(0))
    {
        for (int z = first_; z <= last_; ++z)
            for (int y = 0; y < layer.grid.ny; ++y)
                for (int x = 0; x < layer.grid.nx; ++x) {
                    const std::size_t i = layer.grid.at(x, y, z);
                    if (static_cast<double>(layer.outside[i]) <= growth || (!air.empty() && air[i])) continue;
                    number_[i] = static_cast<int>(places_.size());
                    places_.push_back({x, y, z});
                }
    }
    const std::vector<Place>& places() const { return places_; }
    std::size_t at(const Place& p) const { return layer_.grid.at(p.x, p.y, p.z); }
    /// Place in places(); less than 0: no liquid.
    int number(const Place& p) const { return number_[at(p)]; }
    /// m, from its middle to the nearest skin; less than 0 within a yarn.
    double outside(const Place& p) const { return static_cast<double>(layer_.outside[at(p)]) - growth_; }
    /// Layers of voxels in which they lie.
    int layers() const { return last_ - first_ + 1; }
    /// On its lower or upper side along x, y or z (0, 1, 2); nothing beyond the faces, but the next layer of a stack.
    std::optional<Place> beside(Place p, int axis, int step) const
    {
        (axis == 0 ? p.x : axis == 1 ? p.y : p.z) += step;
        layer_.grid.wrap(p.x, p.y);
        if (p.z >= first_ && p.z <= last_) return p;
        if (!is_stack_) return {};
        p.z = p.z < first_ ? last_ : first_;
        return p;
    }

private:
    const DrawnLayer& layer_;
    double growth_;
    std::vector<int> number_;
    bool is_stack_;
    int first_, last_;
    std::vector<Place> places_;
};

} // namespace hygroloom
