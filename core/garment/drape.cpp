// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The draped mesh of a pattern. Its flat coordinates are those of the pattern's panels, each moved (and perhaps turned by right angles) to
// its place on the sheet, all divided by one number, which is found again by the panels' corners.
#include "core/base/error.h"
#include "core/garment/flat_mesh.h"
#include "core/garment/outline.h"
#include "core/garment/readers.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace hygroloom {

namespace {

constexpr double most_difference = 0.02; // of the scales along and across

/// How an island's flat coordinates become a panel's: turned by right angles, perhaps mirrored, scaled on either axis, moved.
struct Fit {
    int turns = 0;
    bool mirrored = false;
    double scale[2] = {1, 1}, move[2] = {0, 0};
    double off = 1e300; ///< m: mean distance of the panel's corners

    FlatPlace turned(FlatPlace uv) const
    {
        if (mirrored) uv[0] = -uv[0];
        for (int i = 0; i < turns; ++i) uv = {-uv[1], uv[0]};
        return uv;
    }
    FlatPlace flat(const FlatPlace& uv) const
    {
        const FlatPlace p = turned(uv);
        return {scale[0] * p[0] + move[0], scale[1] * p[1] + move[1]};
    }
};

struct Box {
    FlatPlace least{1e300, 1e300}, most{-1e300, -1e300};
    void add(const FlatPlace& place)
    {
        for (std::size_t axis = 0; axis < 2; ++axis) {
            least[axis] = std::min(least[axis], place[axis]);
            most[axis] = std::max(most[axis], place[axis]);
        }
    }
};

/// The places of a loop that lie nearest to the corners, under a fit, and how far off they are in the mean.
std::vector<FlatPlace> nearest(const std::vector<FlatPlace>& loop, const std::vector<FlatPlace>& corners, Fit& fit)
{
    std::vector<FlatPlace> found;
    fit.off = 0;
    for (const FlatPlace& corner : corners) {
        double best = 1e300;
        FlatPlace chosen{};
        for (const FlatPlace& uv : loop) {
            const FlatPlace at = fit.flat(uv);
            const double off = std::hypot(at[0] - corner[0], at[1] - corner[1]);
            if (off >= best) continue;
            best = off;
            chosen = fit.turned(uv);
        }
        found.push_back(chosen);
        fit.off += best / static_cast<double>(corners.size());
    }
    return found;
}

/// From the boxes round both, then by the corners' nearest places.
Fit fitted(const std::vector<FlatPlace>& loop, const PatternPanel& panel, int turns, bool mirrored)
{
    Fit fit;
    fit.turns = turns;
    fit.mirrored = mirrored;
    Box island, outline;
    for (const FlatPlace& uv : loop) island.add(fit.turned(uv));
    for (const FlatPlace& place : outline_of(panel)) outline.add(place);
    std::vector<FlatPlace> corners;
    for (const PanelEdge& edge : panel.edges) corners.push_back(edge.places.front());
    for (std::size_t axis = 0; axis < 2; ++axis) {
        fit.scale[axis] = (outline.most[axis] - outline.least[axis]) / std::max(island.most[axis] - island.least[axis], 1e-300);
        fit.move[axis] = outline.least[axis] - fit.scale[axis] * island.least[axis];
    }
    for (int round = 0; round < 8; ++round) {
        const std::vector<FlatPlace> at = nearest(loop, corners, fit);
        for (std::size_t axis = 0; axis < 2; ++axis) {
            double mean_u = 0, mean_x = 0, uu = 0, ux = 0;
            for (std::size_t i = 0; i < at.size(); ++i) {
                mean_u += at[i][axis] / static_cast<double>(at.size());
                mean_x += corners[i][axis] / static_cast<double>(at.size());
            }
            for (std::size_t i = 0; i < at.size(); ++i) {
                uu += (at[i][axis] - mean_u) * (at[i][axis] - mean_u);
                ux += (at[i][axis] - mean_u) * (corners[i][axis] - mean_x);
            }
            if (uu > 0 && ux > 0) fit.scale[axis] = ux / uu;
            fit.move[axis] = mean_x - fit.scale[axis] * mean_u;
        }
    }
    nearest(loop, corners, fit);
    return fit;
}

/// The plain fit, unless another is clearly better.
Fit best_fit(const std::vector<FlatPlace>& loop, const PatternPanel& panel)
{
    Fit best;
    for (const bool mirrored : {false, true})
        for (int turns = 0; turns < 4; ++turns) {
            const Fit fit = fitted(loop, panel, turns, mirrored);
            if (fit.off < 0.7 * best.off - 1e-6) best = fit;
        }
    return best;
}

std::vector<std::string_view> lines_of(std::string_view text)
{
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        while (line.ends_with('\r') || line.ends_with(' ')) line.remove_suffix(1);
        lines.push_back(line);
    }
    while (!lines.empty() && lines.back().empty()) lines.pop_back();
    return lines;
}

/// Of each island the panel that most of its places are named after; -1: none.
std::vector<int> panels_of(const FlatMesh& mesh, const FlatIslands& found, const std::vector<std::string_view>& words,
                           GarmentPattern& pattern)
{
    std::map<std::string_view, int> known;
    for (std::size_t p = 0; p < pattern.panels.size(); ++p) known.emplace(pattern.panels[p].name, static_cast<int>(p));
    std::vector<int> panels, owner(pattern.panels.size(), -1);
    for (const Island& island : found.islands) {
        std::map<int, int> votes;
        for (const int t : island.triangles)
            for (const int place : mesh.triangles[t])
                if (const auto panel = known.find(words[place]); panel != known.end()) ++votes[panel->second];
        int chosen = -1;
        for (const auto& [panel, count] : votes)
            if (chosen < 0 || count > votes[chosen]) chosen = panel;
        const int number = static_cast<int>(panels.size());
        if (chosen >= 0 && owner[chosen] >= 0) {
            const int other = owner[chosen];
            pattern.issues.push_back(
                fmt::format("The drape has the panel \"{}\" in several pieces; the largest is used.", pattern.panels[chosen].name));
            if (found.islands[other].triangles.size() >= island.triangles.size())
                chosen = -1;
            else
                panels[other] = -1;
        }
        if (chosen >= 0) owner[chosen] = number;
        panels.push_back(chosen);
    }
    for (std::size_t p = 0; p < owner.size(); ++p)
        if (owner[p] < 0) pattern.issues.push_back(fmt::format("The drape lacks the panel \"{}\".", pattern.panels[p].name));
    return panels;
}

/// m of the mesh's unit of space: what makes its edges as long as those of the cloth.
double unit_in_space(const FlatMesh& mesh, const std::vector<double>& ratios, GarmentPattern& pattern)
{
    if (mesh.metre > 0) return mesh.metre;
    const double ratio = median_of(ratios); // m of cloth per unit of space
    double best = 1;
    for (const double unit : {1.0, 0.1, 0.01, 0.001})
        if (std::abs(std::log(ratio / unit)) < std::abs(std::log(ratio / best))) best = unit;
    if (std::abs(ratio / best - 1) > 0.3)
        pattern.issues.push_back(fmt::format("The drape's edges are {:.2f} times as long in space as in the cloth.", best / ratio));
    return best;
}

/// One scale of all panels, or a refusal. Moves are found anew for it.
void agree(std::vector<Fit>& fits, const std::vector<int>& panels, GarmentPattern& pattern, const std::string& name)
{
    std::vector<double> across, along, both;
    for (std::size_t i = 0; i < fits.size(); ++i) {
        if (panels[i] < 0) continue;
        across.push_back(fits[i].scale[0]);
        along.push_back(fits[i].scale[1]);
        both.insert(both.end(), {fits[i].scale[0], fits[i].scale[1]});
    }
    if (both.empty()) throw FileError(name + ": No vertex is named after a panel of the pattern.");
    const double x = median_of(across), y = median_of(along), scale = median_of(both);
    if (std::abs(x / y - 1) > most_difference)
        throw FileError(fmt::format(
            "{}: The flat coordinates are scaled differently: one unit is {:.6g} m of cloth across and {:.6g} m along; they may "
            "differ by 2 %.",
            name, x, y));
    pattern.uv_scale = scale;
    pattern.uv_scale_spread = spread_of(both);
    for (Fit& fit : fits)
        for (double& own : fit.scale) own = scale;
}

/// The mesh as the pattern's shape.
void put_into_space(const FlatMesh& mesh, const FlatIslands& found, const std::vector<int>& panels, const std::vector<Fit>& fits,
                    GarmentPattern& pattern)
{
    pattern.shape = {};
    std::vector<double> ratios;
    for (std::size_t i = 0; i < fits.size(); ++i) {
        if (panels[i] < 0) continue;
        std::map<int, int> numbers;
        for (const int t : found.islands[i].triangles) {
            std::array<int, 3> triangle{};
            for (std::size_t k = 0; k < 3; ++k) {
                const int corner = found.triangles[t][k];
                const auto [at, fresh] = numbers.try_emplace(corner, static_cast<int>(pattern.shape.flat.size()));
                triangle[k] = at->second;
                if (!fresh) continue;
                const FlatCorner& given = found.corners[corner];
                pattern.shape.flat.push_back(fits[i].flat(given.uv));
                pattern.shape.places.push_back(found.places[given.place]);
            }
            pattern.shape.triangles.push_back(triangle);
            pattern.shape.panel.push_back(panels[i]);
            const auto a = static_cast<std::size_t>(triangle[0]), b = static_cast<std::size_t>(triangle[1]);
            const double space = length(pattern.shape.places[a] - pattern.shape.places[b]);
            const FlatPlace &p = pattern.shape.flat[a], &q = pattern.shape.flat[b];
            if (space > 0) ratios.push_back(std::hypot(p[0] - q[0], p[1] - q[1]) / space);
        }
    }
    const double metre = unit_in_space(mesh, ratios, pattern);
    for (Vec3d& place : pattern.shape.places) place = metre * place;
}

} // namespace

void take_drape(GarmentPattern& pattern, std::string_view obj, std::string_view segmentation, const std::string& name)
{
    const FlatMesh mesh = mesh_from_obj(obj, name);
    const std::vector<std::string_view> words = lines_of(segmentation);
    if (words.size() != mesh.places.size())
        throw FileError(fmt::format("{}: The mesh has {} vertices, the text beside it names {}; they must agree.", name, mesh.places.size(),
                                    words.size()));
    const FlatIslands found = islands_of(mesh, name);
    const std::vector<int> panels = panels_of(mesh, found, words, pattern);
    std::vector<Fit> fits(found.islands.size());
    std::vector<std::vector<FlatPlace>> loops(fits.size());
    for (std::size_t i = 0; i < fits.size(); ++i) {
        if (panels[i] < 0) continue;
        for (const int corner : found.islands[i].loop) loops[i].push_back(found.corners[corner].uv);
        const PatternPanel& panel = pattern.panels[panels[i]];
        // Both counts are a stranger's; their product is bounded.
        if (loops[i].size() * panel.edges.size() > 2'000'000)
            throw FileError(fmt::format("{}: The outline of \"{}\" has too many places.", name, panel.name));
        fits[i] = best_fit(loops[i], panel);
    }
    agree(fits, panels, pattern, name);
    for (std::size_t i = 0; i < fits.size(); ++i) {
        if (panels[i] < 0) continue;
        const PatternPanel& panel = pattern.panels[panels[i]];
        std::vector<FlatPlace> corners;
        for (const PanelEdge& edge : panel.edges) corners.push_back(edge.places.front());
        const std::vector<FlatPlace> at = nearest(loops[i], corners, fits[i]);
        for (std::size_t axis = 0; axis < 2; ++axis) {
            double move = 0;
            for (std::size_t k = 0; k < at.size(); ++k)
                move += (corners[k][axis] - fits[i].scale[axis] * at[k][axis]) / static_cast<double>(at.size());
            fits[i].move[axis] = move;
        }
        nearest(loops[i], corners, fits[i]);
        if (fits[i].off > 0.005)
            pattern.issues.push_back(fmt::format("The drape's panel \"{}\" is not the pattern's: its corners are {:.1f} mm off.",
                                                 panel.name, 1000 * fits[i].off));
    }
    put_into_space(mesh, found, panels, fits, pattern);
    pattern.is_draped = true;
    pattern.issues.insert(pattern.issues.end(), mesh.issues.begin(), mesh.issues.end());
}

} // namespace hygroloom
