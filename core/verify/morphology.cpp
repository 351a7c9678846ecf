// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/verify/morphology.h"

#include "core/verify/fits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hygroloom {
namespace {

struct Place {
    int x, y, z;
};
Place place_of(const VoxelGrid& g, std::size_t i)
{
    const auto row = static_cast<std::size_t>(g.nx), layer = row * static_cast<std::size_t>(g.ny);
    return {static_cast<int>(i % row), static_cast<int>(i % layer / row), static_cast<int>(i / layer)};
}

/// Calls visit(index, turns in x, turns in y) for each voxel beside one.
template <typename Visit> void each_beside(const VoxelGrid& g, std::size_t i, const Visit& visit)
{
    const Place p = place_of(g, i);
    for (int step : {-1, 1}) {
        const int x = p.x + step, y = p.y + step, z = p.z + step;
        if (x >= 0 && x < g.nx)
            visit(g.at(x, p.y, p.z), 0, 0);
        else if (g.repeats)
            visit(g.at(x < 0 ? g.nx - 1 : 0, p.y, p.z), step, 0);
        if (y >= 0 && y < g.ny)
            visit(g.at(p.x, y, p.z), 0, 0);
        else if (g.repeats)
            visit(g.at(p.x, y < 0 ? g.ny - 1 : 0, p.z), 0, step);
        if (!g.sections && z >= 0 && z < g.nz) visit(g.at(p.x, p.y, z), 0, 0);
    }
}

bool on_border(const VoxelGrid& g, const Place& p)
{
    if (!g.repeats && (p.x == 0 || p.x == g.nx - 1 || p.y == 0 || p.y == g.ny - 1)) return true;
    return !g.sections && g.nz > 1 && (p.z == 0 || p.z == g.nz - 1);
}

/// The skin of a solid lies nought to half a voxel before the middle of its nearest one: oblique skins have middles close behind them.
double surface_distance(int squared) { return std::sqrt(static_cast<double>(squared)) - 0.25; }

/// Whether a body of liquid meets itself one or more repeats on.
bool hangs_together(const PoreImage& image, const std::vector<std::uint8_t>& liquid)
{
    struct Turns {
        std::int8_t x = 0, y = 0;
        bool seen = false;
    };
    const VoxelGrid& g = image.grid;
    std::vector<Turns> turns(g.size());
    std::vector<std::size_t> waiting;
    bool spans = false;
    for (std::size_t start = 0; start < g.size() && !spans; ++start) {
        if (!liquid[start] || turns[start].seen) continue;
        turns[start].seen = true;
        waiting.assign(1, start);
        while (!waiting.empty() && !spans) {
            const std::size_t here = waiting.back();
            waiting.pop_back();
            each_beside(g, here, [&](std::size_t next, int x, int y) {
                if (!liquid[next]) return;
                const Turns there{static_cast<std::int8_t>(turns[here].x + x), static_cast<std::int8_t>(turns[here].y + y), true};
                if (!turns[next].seen) {
                    turns[next] = there;
                    waiting.push_back(next);
                } else if (turns[next].x != there.x || turns[next].y != there.y) {
                    spans = true;
                }
            });
        }
    }
    return spans;
}

/// What one curve has come to.
struct Air {
    const std::vector<int>& allowed; ///< squared distances from which a ball's middle may be on
    std::vector<std::uint8_t> came;  ///< what a larger ball has brought air to keeps it: on voxels alone that would not be so
    std::vector<std::uint8_t> middles = {};

    void place_balls(double radius)
    {
        middles.resize(allowed.size());
        for (std::size_t i = 0; i < allowed.size(); ++i) middles[i] = allowed[i] > 0 && surface_distance(allowed[i]) >= radius;
    }
    MorphologyPoint spread(const PoreImage& image, double radius)
    {
        const std::vector<int> to_middle = squared_distances(image.grid, middles);
        std::vector<std::uint8_t> liquid(came.size());
        double pores = 0, held = 0;
        for (std::size_t i = 0; i < came.size(); ++i) {
            if (static_cast<double>(to_middle[i]) <= radius * radius) came[i] = 1;
            const bool pore = image.voxels[i] == Voxel::pore;
            liquid[i] = pore && !came[i];
            pores += pore ? 1 : 0;
            held += liquid[i];
        }
        const bool looked_for = image.grid.repeats && !image.grid.sections;
        return {radius, held / pores, looked_for && hangs_together(image, liquid)};
    }
};

} // namespace

std::vector<int> squared_ways_in(const PoreImage& image, const std::vector<int>& to_solid)
{
    const VoxelGrid& g = image.grid;
    std::vector<int> way(g.size(), 0);
    int widest = 0;
    for (std::size_t i = 0; i < g.size(); ++i)
        if (to_solid[i] < nothing_near) widest = std::max(widest, to_solid[i]);
    std::vector<std::vector<std::size_t>> waiting(static_cast<std::size_t>(widest) + 1); // by the way in, the widest first
    const auto enter = [&](std::size_t i, int through) {
        const int wide = std::min({through, to_solid[i], widest});
        if (wide <= way[i]) return;
        way[i] = wide;
        waiting[wide].push_back(i);
    };
    for (std::size_t i = 0; i < g.size(); ++i)
        if (image.voxels[i] == Voxel::outside && on_border(g, place_of(g, i))) enter(i, widest);
    for (std::size_t wide = waiting.size(); wide-- > 1;)
        while (!waiting[wide].empty()) {
            const std::size_t here = waiting[wide].back();
            waiting[wide].pop_back();
            if (way[here] != static_cast<int>(wide)) continue;
            each_beside(g, here, [&](std::size_t next, int, int) { enter(next, way[here]); });
        }
    return way;
}

MorphologyCurves morphology_curves(const PoreImage& image, int radii)
{
    MorphologyCurves curves;
    std::vector<std::uint8_t> solid(image.grid.size());
    for (std::size_t i = 0; i < solid.size(); ++i) solid[i] = image.voxels[i] == Voxel::solid;
    const std::vector<int> fits = squared_distances(image.grid, solid), comes = squared_ways_in(image, fits);
    int widest = 0;
    for (std::size_t i = 0; i < solid.size(); ++i) {
        if (image.voxels[i] == Voxel::pore) curves.pores += 1;
        if (fits[i] < nothing_near) widest = std::max(widest, fits[i]);
    }
    constexpr double least = 1.5, dry = 0.02; // voxels: finer balls are as the grid, not as the pores; saturation
    const double largest = std::max(least, surface_distance(widest));
    Air filling{fits, std::vector<std::uint8_t>(solid.size(), 0)}, emptying{comes, filling.came};
    for (int k = 0; k < radii && curves.pores > 0; ++k) {
        const double radius = largest * std::pow(least / largest, static_cast<double>(k) / (radii - 1));
        filling.place_balls(radius);
        emptying.place_balls(radius);
        const bool alike = filling.middles == emptying.middles && filling.came == emptying.came;
        curves.filling.push_back(filling.spread(image, radius));
        curves.emptying.push_back(alike ? curves.filling.back() : emptying.spread(image, radius));
        if (alike) emptying.came = filling.came;
        if (curves.emptying.back().saturation <= dry) break;
    }
    return curves;
}

double radius_at(const std::vector<MorphologyPoint>& curve, double saturation)
{
    for (std::size_t i = 1; i < curve.size(); ++i) {
        const MorphologyPoint &wide = curve[i - 1], &fine = curve[i];
        if (wide.saturation < saturation || fine.saturation >= saturation) continue;
        const double part = (wide.saturation - saturation) / (wide.saturation - fine.saturation);
        return wide.radius * std::pow(fine.radius / wide.radius, part);
    }
    return std::numeric_limits<double>::quiet_NaN();
}

BrooksCorey fitted_to(const std::vector<MorphologyPoint>& curve)
{
    std::vector<double> saturation, radius;
    for (const MorphologyPoint& p : curve)
        if (p.saturation >= 0.2 && p.saturation <= 0.8) {
            saturation.push_back(std::log(p.saturation));
            radius.push_back(std::log(p.radius));
        }
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    if (radius.size() < 3) return {none, none};
    const FittedLine line = fit_line(saturation, radius);
    return {std::exp(line.at_zero), 1.0 / line.slope};
}

} // namespace hygroloom
