// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/room/room_menisci.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

constexpr double blur_in_voxels = 1.6;
constexpr int margin = 8; // voxels of air above and below the cloth

/// Weights at no voxels from the middle, at one, two and so on, on either side.
std::vector<float> gaussian(double spread, double side)
{
    const int reach = static_cast<int>(std::ceil(3 * spread / side));
    std::vector<double> kernel;
    double sum = 0;
    for (int i = 0; i <= reach; ++i) {
        kernel.push_back(std::exp(-0.5 * std::pow(i * side / spread, 2)));
        sum += (i > 0 ? 2 : 1) * kernel.back();
    }
    std::vector<float> weights;
    for (const double weight : kernel) weights.push_back(static_cast<float>(weight / sum));
    return weights;
}

/// How many values stand before a place, and behind it, each so far from the next.
struct Beside {
    std::size_t apart, before, behind;
};

/// Of so many values, each with what stands beside it. What is alike on both sides is added first: cloth turned over comes out the same.
template <typename Values> Values weighed(const float* value, const std::vector<float>& weights, const Beside& beside)
{
    const auto apart = static_cast<std::ptrdiff_t>(beside.apart);
    const auto at = [&](std::ptrdiff_t k) { return Eigen::Map<const Values>(value + k * apart); };
    Values sum = weights[0] * at(0);
    const auto both = static_cast<std::ptrdiff_t>(std::min(beside.before, beside.behind)),
               before = static_cast<std::ptrdiff_t>(beside.before), behind = static_cast<std::ptrdiff_t>(beside.behind);
    std::ptrdiff_t k = 1;
    for (; k <= both; ++k) sum += weights[static_cast<std::size_t>(k)] * (at(-k) + at(k));
    for (; k <= std::max(before, behind); ++k) sum += weights[static_cast<std::size_t>(k)] * at(k <= before ? -k : k);
    return sum;
}
void weigh(const float* values, const std::vector<float>& weights, const Beside& beside, float* sums, std::size_t count)
{
    using Block = Eigen::Array<float, 32, 1>; // kept in registers
    using One = Eigen::Array<float, 1, 1>;
    constexpr std::size_t block = Block::SizeAtCompileTime;
    std::size_t i = 0;
    for (; i + block <= count; i += block) Eigen::Map<Block>(sums + i) = weighed<Block>(values + i, weights, beside);
    for (; i < count; ++i) sums[i] = weighed<One>(values + i, weights, beside)[0];
}

} // namespace

RestingLiquid::RestingLiquid(const DrawnLayer& layer, double growth, double cosine)
    : grid_(layer.grid), below_(std::max(0, layer.margin - margin)), side_(layer.side()), blurs_(blur_in_voxels * side_),
      cosine_(static_cast<float>(cosine)), kernel_{gaussian(blurs_, layer.dx), gaussian(blurs_, layer.dy), gaussian(blurs_, layer.dz)}
{
    grid_.nz -= 2 * below_;
    first_ = grid_.at(0, 0, layer.first() - below_);
    last_ = grid_.at(0, 0, layer.last() + 1 - below_);
    per_cost_ = 0.5 * std::sqrt(2 * pi) * blurs_ / side_; // a flat surface, so far from the middle
    const std::size_t all = grid_.size(), from = grid_.at(0, 0, below_);
    open_.resize(all);
    std::vector<float> warp(all), weft(all);
    for (std::size_t i = 0; i < all; ++i) {
        const double open = std::clamp(0.5 + (static_cast<double>(layer.outside[from + i]) - growth) / side_, 0.0, 1.0);
        open_[i] = static_cast<float>(open);
        (layer.nearest_is_warp[from + i] ? warp : weft)[i] = static_cast<float>(1 - open);
        if (open > 0) voxels_.push_back(i);
        if (i >= first_ && i < last_) room_ += open;
    }
    blur(warp, near_warp_);
    blur(weft, near_weft_);
    blur(open_, without_); // beyond the grid is nothing: so far from the cloth comes no liquid
    beside_ = without_;
    shares_.assign(all, static_cast<float>(per_cost_));
    for (std::size_t i = 0; i < all; ++i) without_[i] -= cosine_ * (near_warp_[i] + near_weft_[i]);
    costs_.resize(all);
    fill();
}

void RestingLiquid::fill()
{
    liquid_.assign(open_.size(), 0);
    std::copy(open_.begin() + static_cast<std::ptrdiff_t>(first_), open_.begin() + static_cast<std::ptrdiff_t>(last_),
              liquid_.begin() + static_cast<std::ptrdiff_t>(first_));
    shift_ = 0;
}

void RestingLiquid::blur(const std::vector<float>& values, std::vector<float>& blurred)
{
    const auto row = static_cast<std::size_t>(grid_.nx), rows = static_cast<std::size_t>(grid_.ny), plane = row * rows;
    const auto planes = static_cast<std::size_t>(grid_.nz);
    const std::size_t beyond = kernel_[0].size() - 1, aside = kernel_[1].size() - 1, above = kernel_[2].size() - 1;
    const std::size_t wide = row + 2 * beyond;
    blurred.resize(values.size());
    between_.resize(wide * rows);
    wide_.resize(std::max(plane + 2 * aside * row, wide * rows + 2 * beyond));
    for (std::size_t z = 0; z < planes; ++z) {
        float* middle = &wide_[aside * row];
        weigh(&values[z * plane], kernel_[2], {plane, std::min(z, above), std::min(planes - 1 - z, above)}, middle, plane);
        for (std::size_t y = 0; y < aside; ++y) { // the plane goes on behind its last row, and before its first
            std::copy_n(middle + y % rows * row, row, middle + (rows + y) * row);
            std::copy_n(middle + (rows - 1 - y % rows) * row, row, middle - (y + 1) * row);
        }
        weigh(middle, kernel_[1], {row, aside, aside}, between_.data(), plane);
        widen(beyond);
        weigh(&wide_[beyond], kernel_[0], {1, beyond, beyond}, between_.data(), wide * rows);
        for (std::size_t y = 0; y < rows; ++y) std::copy_n(&between_[y * wide], row, &blurred[z * plane + y * row]);
    }
}

/// Each row of a plane with what stands before it and behind it.
void RestingLiquid::widen(std::size_t beyond)
{
    const int nx = grid_.nx, ny = grid_.ny, more = static_cast<int>(beyond);
    float* to = wide_.data();
    for (int y = 0; y < ny; ++y) {
        const auto take = [&](int first, int end) {
            for (int x = first; x < end; ++x) {
                int from_x = x, from_y = y;
                grid_.wrap(from_x, from_y);
                *to++ = between_[static_cast<std::size_t>(from_y * nx + from_x)];
            }
        };
        take(-more, 0);
        to = std::copy_n(&between_[static_cast<std::size_t>(y * nx)], nx, to);
        take(nx, nx + more);
    }
}

/// What liquid costs at a voxel, of how much lies about it. A skin that cuts a voxel leaves a part of it open, whose middle lies farther
/// from the yarn, and which a surface beside the skin crosses in less than a voxel: where the whole voxel counted, every dry skin would
/// have a film, as liquid costs little there.
void RestingLiquid::cost_at(std::size_t voxel)
{
    const float about = costs_[voxel], open = open_[voxel];
    costs_[voxel] = without_[voxel] - 2 * about;
    if (open >= 1) return;
    constexpr float least = 0.1F; // of that of a flat surface
    const float flat = static_cast<float>(0.5 / per_cost_), beside = beside_[voxel], share = std::min(1.0F, about / beside);
    const float away = (1 + cosine_ - 2 * share) * flat, along = 8 * share * (1 - share) * beside * flat; // by a voxel
    costs_[voxel] += 0.5F * away * (1 - open);
    shares_[voxel] = 1 / std::max(least * flat, std::abs(away) * open + along);
}

/// So that the liquid takes so many voxels: Newton's rounds, of a function made of straight pieces.
void RestingLiquid::shift_to(double voxels)
{
    constexpr int rounds = 8;
    constexpr double precise = 1e-5, farthest = 0.05;
    for (int round = 0; round < rounds; ++round) {
        double sum = 0, falls = 0;
        for (const std::size_t i : voxels_) {
            const double share = share_of_liquid(i), open = static_cast<double>(open_[i]);
            if (share >= 1) {
                sum += open;
            } else if (share > 0) {
                sum += open * share;
                falls += open * static_cast<double>(shares_[i]);
            }
        }
        if (std::abs(sum - voxels) < precise * voxels) return;
        shift_ += std::clamp((sum - voxels) / std::max(falls, 1e-3 * room_), -farthest, farthest);
    }
}

void RestingLiquid::hold(double saturation)
{
    constexpr int most = 200, fewest = 8;
    constexpr double still = 1e-4; // of the room
    for (int round = 0; round < most; ++round) {
        blur(liquid_, costs_);
        for (const std::size_t i : voxels_) cost_at(i);
        shift_to(saturation * room_);
        double moved = 0;
        for (const std::size_t i : voxels_) {
            const auto now = open_[i] * static_cast<float>(std::clamp(share_of_liquid(i), 0.0, 1.0));
            moved += std::abs(static_cast<double>(now - liquid_[i]));
            liquid_[i] = now;
        }
        if (round >= fewest && moved < still * room_) return;
    }
}

double RestingLiquid::curvature() const { return shift_ * std::sqrt(2 * pi) / blurs_; }

double RestingLiquid::wetted(const std::vector<float>& near) const
{
    double overlap = 0;
    for (const std::size_t i : voxels_) overlap += static_cast<double>(liquid_[i] * near[i]);
    return overlap * std::sqrt(2 * pi) / (blurs_ * room_);
}

namespace {

struct Found {
    double saturation, curvature, warp, weft; // skins: for each m3 of the room
};

Found rest(RestingLiquid& liquid, double saturation)
{
    liquid.hold(saturation);
    return {saturation, liquid.curvature(), liquid.wetted_warp(), liquid.wetted_weft()};
}
/// At one of several states that hold ever less; skins as they change between its neighbours.
RestingState state(const std::vector<Found>& all, std::size_t at, std::size_t more, std::size_t less)
{
    const double of = all[more].saturation - all[less].saturation;
    return {all[at].curvature, (all[more].warp - all[less].warp) / of, (all[more].weft - all[less].weft) / of};
}

} // namespace

RoomStates states_of_room(RestingLiquid& liquid)
{
    constexpr double held[] = {almost_full, room_sunk, 0.7, room_knee, 0.45, room_low, 0.2, 0.15, room_rings, 0.06};
    constexpr std::size_t sunk = 1, knee = 3, low = 5, rings = 8; // places of these
    std::vector<Found> down;
    liquid.fill();
    for (const double saturation : held) down.push_back(rest(liquid, saturation));
    std::vector<Found> up{down.back()};
    for (std::size_t k = rings; k > knee; --k) up.push_back(rest(liquid, held[k]));
    std::size_t breaks = low; // where what holds less does so at a smaller suction: there it empties at once
    while (breaks < rings && down[breaks + 1].curvature >= down[breaks].curvature) ++breaks;
    constexpr double noise = 0.02;
    std::size_t fills = 1;
    double most = up.back().curvature;
    for (std::size_t k = up.size() - 1; k-- > 0;) { // the lowest suction that is followed by larger ones, else that of rings
        if (up[k].curvature < most - noise * std::abs(most) && (fills == 1 || up[k].curvature < up[fills].curvature)) fills = k;
        most = std::max(most, up[k].curvature);
    }
    return {state(down, 0, 0, sunk),        state(down, sunk, 0, sunk + 1),     state(down, knee, knee - 1, knee + 1),
            state(down, low, low - 1, low), state(up, fills, fills + 1, fills), state(down, breaks, breaks - 1, breaks)};
}

} // namespace hygroloom
