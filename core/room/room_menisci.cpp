// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/room/room_menisci.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

constexpr double blur_in_voxels = 2;
constexpr int margin = 8; // voxels of air above and below the cloth

std::vector<double> gaussian(double spread, double side)
{
    const int reach = static_cast<int>(std::ceil(3 * spread / side));
    std::vector<double> kernel;
    double sum = 0;
    for (int i = -reach; i <= reach; ++i) {
        kernel.push_back(std::exp(-0.5 * std::pow(i * side / spread, 2)));
        sum += kernel.back();
    }
    for (double& weight : kernel) weight /= sum;
    return kernel;
}

/// added += weight * values, of so many.
void add(double* added, const double* values, double weight, std::size_t count)
{
    for (std::size_t i = 0; i < count; ++i) added[i] += weight * values[i];
}

} // namespace

RestingLiquid::RestingLiquid(const DrawnLayer& layer, double growth, double cosine)
    : grid_(layer.grid), below_(std::max(0, layer.margin - margin)), side_(layer.side()),
      blurs_(blur_in_voxels * side_), kernel_{gaussian(blurs_, layer.dx), gaussian(blurs_, layer.dy), gaussian(blurs_, layer.dz)}
{
    grid_.nz -= 2 * below_;
    first_ = grid_.at(0, 0, layer.first() - below_);
    last_ = grid_.at(0, 0, layer.last() + 1 - below_);
    per_cost_ = 0.5 * std::sqrt(2 * pi) * blurs_ / side_; // a flat surface, so far from the middle
    const std::size_t all = grid_.size(), from = grid_.at(0, 0, below_);
    open_.resize(all);
    std::vector<double> warp(all), weft(all);
    for (std::size_t i = 0; i < all; ++i) {
        const double open = std::clamp(0.5 + (static_cast<double>(layer.outside[from + i]) - growth) / side_, 0.0, 1.0);
        open_[i] = open;
        (layer.nearest_is_warp[from + i] ? warp : weft)[i] = 1 - open;
        if (open > 0) voxels_.push_back(i);
        if (i >= first_ && i < last_) room_ += open;
    }
    blur(warp, near_warp_);
    blur(weft, near_weft_);
    blur(open_, without_); // beyond the grid is nothing: so far from the cloth comes no liquid
    for (std::size_t i = 0; i < all; ++i) without_[i] -= cosine * (near_warp_[i] + near_weft_[i]);
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

void RestingLiquid::blur(const std::vector<double>& values, std::vector<double>& blurred)
{
    const int nx = grid_.nx, ny = grid_.ny, nz = grid_.nz;
    const auto row = static_cast<std::size_t>(nx), plane = row * static_cast<std::size_t>(ny);
    const auto reach = [&](int axis) { return static_cast<int>(kernel_[axis].size() / 2); };
    const auto weight = [&](int axis, int offset) { return kernel_[axis][static_cast<std::size_t>(offset + reach(axis))]; };
    between_.assign(values.size(), 0);
    blurred.assign(values.size(), 0);
    for (int z = 0; z < nz; ++z)
        for (int k = std::max(-reach(2), -z); k <= std::min(reach(2), nz - 1 - z); ++k)
            add(&between_[grid_.at(0, 0, z)], &values[grid_.at(0, 0, z + k)], weight(2, k), plane);
    const auto turn = [](int i, int n) { return ((i % n) + n) % n; };
    for (int z = 0; z < nz; ++z)
        for (int y = 0; y < ny; ++y)
            for (int k = -reach(1); k <= reach(1); ++k)
                add(&blurred[grid_.at(0, y, z)], &between_[grid_.at(0, turn(y + k, ny), z)], weight(1, k), row);
    between_ = blurred;
    const int beyond = reach(0);
    line_.resize(row + 2 * static_cast<std::size_t>(beyond));
    for (int z = 0; z < nz; ++z)
        for (int y = 0; y < ny; ++y) {
            for (int x = -beyond; x < nx + beyond; ++x) {
                int from_x = x, from_y = y;
                if (x < 0 || x >= nx) grid_.wrap(from_x, from_y);
                line_[static_cast<std::size_t>(x + beyond)] = between_[grid_.at(from_x, from_y, z)];
            }
            double* to = &blurred[grid_.at(0, y, z)];
            std::fill(to, to + row, 0.0);
            for (int k = 0; k <= 2 * beyond; ++k) add(to, &line_[static_cast<std::size_t>(k)], weight(0, k - beyond), row);
        }
}

/// So that the liquid takes so many voxels: Newton's rounds, of a function made of straight pieces.
void RestingLiquid::shift_to(double voxels)
{
    constexpr int rounds = 8;
    constexpr double precise = 1e-5, farthest = 0.05;
    for (int round = 0; round < rounds; ++round) {
        double sum = 0, falls = 0;
        for (const std::size_t i : voxels_) {
            const double share = share_of_liquid(i), open = open_[i];
            if (share >= 1) {
                sum += open;
            } else if (share > 0) {
                sum += open * share;
                falls += open * per_cost_;
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
        for (const std::size_t i : voxels_) costs_[i] = without_[i] - 2 * costs_[i];
        shift_to(saturation * room_);
        double moved = 0;
        for (const std::size_t i : voxels_) {
            const double now = open_[i] * std::clamp(share_of_liquid(i), 0.0, 1.0);
            moved += std::abs(now - liquid_[i]);
            liquid_[i] = now;
        }
        if (round >= fewest && moved < still * room_) return;
    }
}

double RestingLiquid::curvature() const { return shift_ * std::sqrt(2 * pi) / blurs_; }

double RestingLiquid::wetted(const std::vector<double>& near) const
{
    double overlap = 0;
    for (const std::size_t i : voxels_) overlap += liquid_[i] * near[i];
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
