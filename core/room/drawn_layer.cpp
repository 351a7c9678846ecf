// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/room/drawn_layer.h"

#include "core/base/units.h"
#include "core/room/yarn_stations.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hygroloom {
namespace {

constexpr double layer_share = 2; // a layer has at least half as many voxels from face to face as the mean pitch
constexpr double reaches = 0.55;  // of the mean pitch
/// Of a layer, at so many in the pitch: a million take 3 to 10 s of a core; fewer where fewer are asked for, so that they can be compared.
double most_voxels_at(int voxels) { return 1e6 * std::min(1.0, std::pow(voxels / 16.0, 3)); }

/// One yarn among the voxels; what leaves the cell comes in on the other side.
class DrawnYarn {
public:
    DrawnYarn(const Textile& textile, YarnKind kind, int yarn, DrawnLayer& layer, double wider)
        : layer_(layer), is_warp_(kind == YarnKind::warp), wider_(wider),
          stations_(textile, kind, yarn, 0.5 * (is_warp_ ? layer.dy : layer.dx), 2),
          reach_(0.5 * textile.type(kind, yarn).section.height + layer.reach)
    {
    }
    void draw()
    {
        const VoxelGrid& g = layer_.grid;
        const int n = is_warp_ ? g.ny : g.nx;
        const double voxel = is_warp_ ? layer_.dy : layer_.dx;
        for (int along = 0; along < n; ++along)
            for (int z = 0; z < g.nz; ++z)
                if (const NearStation near = stations_.nearest((along + 0.5 - 0.5 * n) * voxel, (z + 0.5 - 0.5 * g.nz) * layer_.dz, reach_);
                    near.station)
                    draw_across(along, z, *near.station, near.off);
    }

private:
    void draw_across(int along, int z, const YarnStation& station, double off)
    {
        const VoxelGrid& g = layer_.grid;
        const int n = is_warp_ ? g.nx : g.ny;
        const double voxel = is_warp_ ? layer_.dx : layer_.dy, middle = station.across / voxel + 0.5 * n - 0.5;
        const double flat = station.flat + wider_, wide = (flat + station.half_height + layer_.reach) / voxel;
        for (int c = static_cast<int>(std::ceil(middle - wide)); c <= static_cast<int>(std::floor(middle + wide)); ++c) {
            const double beside = std::max(0.0, std::abs(c - middle) * voxel - flat);
            const auto outside = static_cast<float>(std::hypot(beside, off) - station.half_height);
            int x = is_warp_ ? c : along, y = is_warp_ ? along : c;
            g.wrap(x, y);
            const std::size_t i = g.at(x, y, z);
            if (outside >= layer_.outside[i]) continue;
            layer_.outside[i] = outside;
            layer_.nearest_is_warp[i] = is_warp_;
        }
    }

    DrawnLayer& layer_;
    bool is_warp_;
    double wider_; // on either side
    YarnStations stations_;
    double reach_; // from its centreline, to which it is drawn
};

/// Calls visit(voxel) for those of the cloth.
template <typename Visit> void each_of_cloth(const DrawnLayer& layer, const Visit& visit)
{
    for (int z = layer.first(); z <= layer.last(); ++z)
        for (int y = 0; y < layer.grid.ny; ++y)
            for (int x = 0; x < layer.grid.nx; ++x) visit(layer.grid.at(x, y, z));
}

} // namespace

double DrawnLayer::side() const { return std::cbrt(dx * dy * dz); }

double side_of_cube(const Textile& textile)
{
    return std::min(std::sqrt(textile.warp.pitch * textile.weft.pitch), layer_share * textile.thickness);
}

double cubes_of_crossing(const Textile& textile)
{
    const double area = textile.warp.pitch * textile.weft.pitch, pitch = std::sqrt(area), cube = side_of_cube(textile);
    return area * (textile.thickness + 2 * reaches * pitch) / (cube * cube * cube);
}

double voxels_of_period(double cubes, int voxels) { return std::min(std::pow(voxels, 3) * cubes, most_voxels_at(voxels)); }

DrawnLayer drawn_layer(const Textile& cell, int voxels, int shift, const Widening& wider)
{
    const double pitch = std::sqrt(cell.warp.pitch * cell.weft.pitch), reach = reaches * pitch;
    const double volume = cell.warp.pitch * cell.weft.pitch * cell.crossings() * (cell.thickness + 2 * reach);
    const double voxel = std::cbrt(volume / voxels_of_period(cubes_of_crossing(cell) * cell.crossings(), voxels));
    const auto whole = [&](double length) { return std::max(2, static_cast<int>(std::lround(length / voxel))); };
    DrawnLayer layer;
    layer.per_end = whole(cell.warp.pitch);
    layer.per_pick = whole(cell.weft.pitch);
    const int layers = whole(cell.thickness);
    layer.dx = cell.warp.pitch / layer.per_end;
    layer.dy = cell.weft.pitch / layer.per_pick;
    layer.dz = cell.thickness / layers;
    layer.reach = reach;
    layer.margin = static_cast<int>(std::ceil(layer.reach / layer.dz)) + 1;
    layer.grid = {cell.ends() * layer.per_end, cell.picks() * layer.per_pick, layers + 2 * layer.margin, true, false,
                  shift * layer.per_pick};
    layer.outside.assign(layer.grid.size(), static_cast<float>(layer.reach));
    layer.nearest_is_warp.assign(layer.grid.size(), 0);
    for (int end = 0; end < cell.ends(); ++end) DrawnYarn(cell, YarnKind::warp, end, layer, wider.warp).draw();
    for (int pick = 0; pick < cell.picks(); ++pick) DrawnYarn(cell, YarnKind::weft, pick, layer, wider.weft).draw();
    return layer;
}

double share_outside(const DrawnLayer& layer, double growth)
{
    const double per_side = 1 / layer.side();
    double sum = 0;
    std::size_t voxels = 0;
    each_of_cloth(layer, [&](std::size_t i) {
        sum += std::clamp(0.5 + (static_cast<double>(layer.outside[i]) - growth) * per_side, 0.0, 1.0);
        ++voxels;
    });
    return sum / static_cast<double>(voxels);
}

double growth_to_share(const DrawnLayer& layer, double share)
{
    double low = -layer.reach, high = layer.reach;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        (share_outside(layer, middle) > share ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

namespace {

/// All yarns of a cell, which goes on to all sides.
class DrawnYarns {
public:
    DrawnYarns(const Textile& cell, int shift, double spacing) : cell_(cell), shift_(shift)
    {
        for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
            for (int yarn = 0; yarn < cell.system(kind).count; ++yarn)
                (kind == YarnKind::warp ? warp_ : weft_).emplace_back(cell, kind, yarn, spacing, 2);
    }
    /// Of any number, from a place along it, across the cloth and up, m; no more than reach.
    double outside(YarnKind kind, int yarn, double along, double across, double up, double reach) const
    {
        const YarnSystem& system = cell_.system(kind);
        const int inside = ((yarn % system.count) + system.count) % system.count;
        const YarnStations& stations = (kind == YarnKind::warp ? warp_ : weft_)[static_cast<std::size_t>(inside)];
        if (kind == YarnKind::warp) along = lowered(along, (yarn - inside) / system.count);
        const double half_height = 0.5 * cell_.type(kind, inside).section.height; // the largest
        const NearStation near = stations.nearest(along, up, reach + half_height);
        if (!near.station) return reach;
        const double shift = (yarn - inside) * system.pitch;
        const double beside = std::max(0.0, std::abs(across - near.station->across - shift) - near.station->flat);
        return std::min(reach, std::hypot(beside, near.off) - near.station->half_height);
    }

private:
    /// Where along the cell's end a place of that end lies which is so many cells farther.
    double lowered(double along, int cells) const
    {
        if (cells * shift_ == 0) return along;
        const double length = cell_.picks() * cell_.weft.pitch, down = along - cells * shift_ * cell_.weft.pitch;
        return down - length * std::round(down / length);
    }

    const Textile& cell_;
    int shift_;
    std::vector<YarnStations> warp_, weft_;
};

/// What one yarn adds to the skin and takes from the openings.
class YarnSkinInRoom {
public:
    YarnSkinInRoom(const Textile& textile, const WovenCell& cell, const DrawnYarns& yarns, YarnKind kind, int yarn, double growth)
        : textile_(textile), cell_(cell), yarns_(yarns), kind_(kind), yarn_(yarn), growth_(growth),
          half_thickness_(0.5 * textile.thickness), stations_(textile, kind, yarn, textile.system(other_kind(kind)).pitch / 24, 0),
          spacing_(textile.system(other_kind(kind)).pitch * textile.crossings_along(kind) / static_cast<double>(stations_.all().size()))
    {
    }
    void add_to(RoomSkin& skin) const
    {
        for (const YarnStation& s : stations_.all()) {
            add_outline(s, kind_ == YarnKind::warp ? skin.warp : skin.weft);
            for (double side : {-1.0, 1.0}) { // where it reaches a face
                constexpr double rounding = 1e-3;
                const double reach = s.half_height + growth_, below = half_thickness_ - side * s.up;
                if (below >= reach * (1 + rounding)) continue;
                const double half_chord = s.flat + std::sqrt(std::max(0.0, reach * reach - below * below));
                skin.faces[crossing(s.along, s.across)] -= 2 * half_chord * spacing_;
            }
        }
    }

private:
    bool is_warp() const { return kind_ == YarnKind::warp; }
    /// Numbers of the end and the pick nearest to a place of the cloth.
    std::pair<int, int> threads(double along, double across) const
    {
        const double x = is_warp() ? across : along, y = is_warp() ? along : across;
        return {static_cast<int>(std::floor(x / textile_.warp.pitch + 0.5 * textile_.ends())),
                static_cast<int>(std::floor(y / textile_.weft.pitch + 0.5 * textile_.picks()))};
    }
    std::size_t crossing(double along, double across) const
    {
        const auto [end, pick] = threads(along, across);
        return cell_.crossing(end, pick);
    }
    void add_outline(const YarnStation& s, std::vector<double>& skin) const
    {
        constexpr int pieces = 48;
        const double radius = s.half_height + growth_, flat = s.flat, slant = std::hypot(1.0, s.rise);
        if (radius <= 0) return;
        const double outline = 2 * pi * radius + 4 * flat, step = outline / pieces, area = step * spacing_ * slant;
        for (int k = 0; k < pieces; ++k) {
            const bool lower = 2 * k >= pieces;
            const double at = (k % (pieces / 2) + 0.5) * step, side = lower ? -1.0 : 1.0; // from the middle of a flat on
            const double angle = std::clamp((at - flat) / radius, 0.0, pi);
            const double across = side * (std::clamp(at, 0.0, flat) - std::max(0.0, at - flat - pi * radius) + radius * std::sin(angle)),
                         up = side * radius * std::cos(angle);
            if (is_room(s, across, up)) skin[crossing(s.along, s.across + across)] += area;
        }
    }
    /// Whether a place of the yarn's skin lies between the faces and under no other yarn.
    bool is_room(const YarnStation& s, double across, double up) const
    {
        constexpr double touching = 0.02; // of a half height: where yarns are nearer, fibres close the gap; an assumption
        const double slant = std::hypot(1.0, s.rise), z = s.up + up / slant, along = s.along - up * s.rise / slant,
                     beside = s.across + across;
        if (std::abs(z) >= half_thickness_ * (1 - 1e-3)) return false;
        const double least = growth_ + touching * s.half_height;
        const auto [end, pick] = threads(along, beside);
        for (int step = -1; step <= 1; ++step) {
            if (!(is_warp() && end + step == yarn_) &&
                yarns_.outside(YarnKind::warp, end + step, is_warp() ? along : beside, is_warp() ? beside : along, z, least) < least)
                return false;
            if (!(!is_warp() && pick + step == yarn_) &&
                yarns_.outside(YarnKind::weft, pick + step, is_warp() ? beside : along, is_warp() ? along : beside, z, least) < least)
                return false;
        }
        return true;
    }

    const Textile& textile_;
    const WovenCell& cell_;
    const DrawnYarns& yarns_;
    YarnKind kind_;
    int yarn_;
    double growth_, half_thickness_;
    YarnStations stations_;
    double spacing_;
};

} // namespace

RoomSkin skin_of_room(const Textile& cell, double growth, int shift)
{
    const WovenCell woven{cell.ends(), cell.picks(), shift};
    const DrawnYarns yarns(cell, shift, std::min(cell.warp.pitch, cell.weft.pitch) / 40);
    RoomSkin skin;
    skin.warp.assign(static_cast<std::size_t>(cell.crossings()), 0);
    skin.weft = skin.warp;
    skin.faces.assign(skin.warp.size(), 2 * cell.warp.pitch * cell.weft.pitch);
    for (int end = 0; end < cell.ends(); ++end) YarnSkinInRoom(cell, woven, yarns, YarnKind::warp, end, growth).add_to(skin);
    for (int pick = 0; pick < cell.picks(); ++pick) YarnSkinInRoom(cell, woven, yarns, YarnKind::weft, pick, growth).add_to(skin);
    for (double& face : skin.faces) face = std::max(0.0, face);
    return skin;
}

PartlyFull emptied_by_balls(const DrawnLayer& layer, double growth, double radius)
{
    PartlyFull state;
    std::vector<std::uint8_t> middles(layer.grid.size());
    for (std::size_t i = 0; i < middles.size(); ++i) middles[i] = static_cast<double>(layer.outside[i]) - growth >= radius;
    const std::vector<int> to_middle = squared_distances(layer.grid, middles);
    const double in_voxels = (radius / layer.side()) * (radius / layer.side());
    state.air.assign(middles.size(), 0);
    for (std::size_t i = 0; i < middles.size(); ++i) state.air[i] = static_cast<double>(to_middle[i]) <= in_voxels;
    double room = 0, liquid = 0;
    each_of_cloth(layer, [&](std::size_t i) {
        if (static_cast<double>(layer.outside[i]) <= growth) return;
        room += 1;
        liquid += state.air[i] ? 0 : 1;
    });
    state.saturation = room > 0 ? liquid / room : 1;
    return state;
}

PartlyFull half_full(const DrawnLayer& layer, double growth)
{
    constexpr int rounds = 7;
    constexpr double near_enough = 0.02;
    double low = layer.side(), high = layer.reach - growth;
    PartlyFull state = emptied_by_balls(layer, growth, high);
    for (int i = 0; i < rounds && std::abs(state.saturation - 0.5) > near_enough; ++i) {
        const double middle = std::sqrt(low * high);
        state = emptied_by_balls(layer, growth, middle);
        (state.saturation > 0.5 ? high : low) = middle;
    }
    return state;
}

} // namespace hygroloom
