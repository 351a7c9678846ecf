// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Liquid at rest in the room between yarns, free to leave it by both faces. Lengths in m.
#pragma once

#include "core/physics/between_yarns.h"
#include "core/room/drawn_layer.h"

namespace hygroloom {

/// A given volume of liquid moves until its surfaces cost least: those to the air, less what the wetted skin of the yarns gains. Threshold
/// dynamics: energies of surfaces as overlaps blurred by a Gaussian (Esedoglu and Otto 2015, with a solid as Xu, Wang and Wang 2017 have
/// it), of 1.6 voxels. What it finds depends on where the liquid was before.
class RestingLiquid {
public:
    /// cosine: of the contact angle, on all yarns.
    RestingLiquid(const DrawnLayer& layer, double growth, double cosine);
    /// The room is full, to its faces.
    void fill();
    /// Rests when it holds so much of the room. More than some gets up over the faces.
    void hold(double saturation);
    /// 1/m, twice the menisci's mean curvature: suction over surface tension.
    double curvature() const;
    /// m2 for each m3 of the room, of skin that the liquid wets.
    double wetted_warp() const { return wetted(near_warp_); }
    double wetted_weft() const { return wetted(near_weft_); }

private:
    void blur(const std::vector<float>& values, std::vector<float>& blurred);
    void widen(std::size_t beyond);
    double share_of_liquid(std::size_t voxel) const
    {
        return 0.5 - (static_cast<double>(costs_[voxel]) + shift_) * static_cast<double>(shares_[voxel]);
    }
    void cost_at(std::size_t voxel);
    void shift_to(double voxels);
    double wetted(const std::vector<float>& near) const;

    VoxelGrid grid_; // the layer's, less so many voxels of air above and below
    int below_;
    double side_, blurs_; // m
    float cosine_;
    double per_cost_ = 0;          // of a voxel that a surface cuts, by the cost of liquid at its middle
    std::vector<float> kernel_[3]; // of the blur along each axis
    std::vector<float> open_;      // of each voxel, what is outside the yarns
    std::vector<float> near_warp_, near_weft_;
    std::vector<float> beside_;          // what is open about each voxel
    std::vector<float> without_, costs_; // of liquid at each voxel: where there is none beside, and as it lies
    std::vector<float> shares_;          // per_cost_ of each voxel, less or more where a skin cuts it
    std::vector<float> liquid_, wide_, between_;
    std::vector<std::size_t> voxels_;  // that are open
    std::size_t first_ = 0, last_ = 0; // of the cloth
    double room_ = 0;                  // voxels of it
    double shift_ = 0;                 // of the costs, by the suction
};

/// Of a room, as full ones empty and as dry ones fill. yarns' cosine: reference_cosine.
RoomStates states_of_room(RestingLiquid& liquid);

} // namespace hygroloom
