// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A mesh with flat coordinates as a pattern: its islands are panels, what meets in space is sewn.
#include "core/base/error.h"
#include "core/base/words.h"
#include "core/garment/flat_mesh.h"
#include "core/garment/odd_shapes.h"
#include "core/garment/outline.h"
#include "core/garment/readers.h"
#include "core/project/atomic_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace hygroloom {

namespace {

constexpr double sharp = 0.5;       // radian: where an outline turns by more, an edge ends; an assumption
constexpr double meeting = 5e-4;    // m: outlines that lie so near in space are sewn
constexpr double most_unlike = 0.1; // of a given unit and the lengths in space
constexpr double least_area = 1e-5; // m2: smaller islands are buttons and threads, not panels

/// m of a unit of flat coordinates; 0: it follows from lengths.
double metre_of(UvUnit unit)
{
    switch (unit) {
    case UvUnit::millimetre: return 1e-3;
    case UvUnit::centimetre: return 1e-2;
    case UvUnit::metre: return 1;
    case UvUnit::from_lengths: break;
    }
    return 0;
}

/// A side of an outline.
struct PanelSide {
    int panel = 0, at = 0; ///< of the loop
};

class MeshReader {
public:
    MeshReader(const FlatMesh& mesh, const std::string& name, UvUnit unit)
        : mesh_(mesh), name_(name), unit_(unit), found_(islands_of(mesh, name))
    {
    }
    GarmentPattern read();

private:
    void find_scales();
    double metre_in_space(double ratio);
    void stand_up();
    void find_outlines();
    void name_panels();
    void find_meetings();
    PanelSide partner(std::size_t k, std::size_t i) const;
    void split();
    void sew();
    void make_shape_of_mesh();
    void tell();
    Vec3d place_of(int corner) const { return found_.places[static_cast<std::size_t>(found_.corners[corner].place)]; }
    const std::vector<int>& loop_of(std::size_t panel) const { return found_.islands[kept_[panel]].loop; }
    const FlatPlace& flat_of(int corner) const { return found_.corners[corner].uv; }

    const FlatMesh& mesh_;
    const std::string& name_;
    UvUnit unit_;
    FlatIslands found_;
    GarmentPattern pattern_;
    std::vector<std::size_t> kept_;                       ///< islands that are panels
    std::vector<std::vector<int>> numbers_;               ///< of each panel's outline: places that meet have one
    std::multimap<std::pair<int, int>, PanelSide> sides_; ///< by the numbers of their ends
    std::vector<std::vector<int>> edge_of_;               ///< of each panel's sides
};

/// m of the file's unit in space, where the format has none: by the flat coordinates' unit, or by the size: from 0.25 to 2.5 m of cm or mm.
double MeshReader::metre_in_space(double ratio)
{
    if (mesh_.metre > 0) return mesh_.metre;
    const double given = metre_of(unit_);
    double best = 1;
    if (given > 0) {
        // ratio is flat units per unit of space: cloth of one unit of space is ratio * given metres long.
        for (const double unit : {1.0, 0.1, 0.01, 0.001})
            if (std::abs(std::log(ratio * given / unit)) < std::abs(std::log(ratio * given / best))) best = unit;
        return best;
    }
    Vec3d least{1e300, 1e300, 1e300}, most{-1e300, -1e300, -1e300};
    for (const Vec3d& p : found_.places) {
        least = {std::min(least.x, p.x), std::min(least.y, p.y), std::min(least.z, p.z)};
        most = {std::max(most.x, p.x), std::max(most.y, p.y), std::max(most.z, p.z)};
    }
    const Vec3d size = most - least;
    const double largest = std::max({size.x, size.y, size.z});
    const double unit = largest <= 5 ? 1 : largest <= 250 ? 0.01 : 0.001;
    pattern_.issues.push_back(fmt::format("The file has no unit of length; by its size of {:.4g} it was taken to be in {}.", largest,
                                          unit == 1      ? "metres"
                                          : unit == 0.01 ? "centimetres"
                                                         : "millimetres"));
    return unit;
}

void MeshReader::find_scales()
{
    const FlatScale lengths = common_scale(found_); // of the file's unit of space
    if (!(lengths.middle > 0)) throw FileError(name_ + ": The mesh's flat coordinates have no size.");
    const double metre = metre_in_space(1 / lengths.middle), from_lengths = metre * lengths.middle, given = metre_of(unit_);
    pattern_.uv_scale = given > 0 ? given : from_lengths;
    pattern_.uv_scale_spread = given > 0 ? 0 : lengths.spread;
    if (given > 0 && std::abs(from_lengths / given - 1) > most_unlike)
        pattern_.issues.push_back(
            fmt::format("By the lengths in space one unit of the flat coordinates is {:.4g} mm, by uv_unit {:g} mm; uv_unit is used.",
                        1000 * from_lengths, 1000 * given));
    for (Vec3d& place : found_.places) place = metre * place;
    if (!(given > 0) && take_own_scales(found_, from_lengths)) {
        pattern_.uv_scale = pattern_.uv_scale_spread = 0;
        pattern_.issues.emplace_back(
            "Flat coordinates have another scale from panel to panel, as where each fills a texture; the scales of "
            "each panel, across and along, were taken from its own lengths in space.");
        return;
    }
    if (pattern_.uv_scale_spread > 0.05)
        pattern_.issues.push_back(
            fmt::format("The scale of the flat coordinates differs by over {:.0f} % on half of the cloth; the cloth is stretched, or its "
                        "flat coordinates are not a pattern's.",
                        100 * pattern_.uv_scale_spread));
    for (FlatCorner& corner : found_.corners)
        for (double& number : corner.uv) number *= pattern_.uv_scale;
}

/// Turns a mesh that stands along z.
void MeshReader::stand_up()
{
    Vec3d least{1e300, 1e300, 1e300}, most{-1e300, -1e300, -1e300};
    for (const Vec3d& p : found_.places) {
        least = {std::min(least.x, p.x), std::min(least.y, p.y), std::min(least.z, p.z)};
        most = {std::max(most.x, p.x), std::max(most.y, p.y), std::max(most.z, p.z)};
    }
    const Vec3d size = most - least;
    if (!(size.z > 1.5 * size.y && size.y > 1e-6)) return;
    for (Vec3d& p : found_.places) p = {p.x, p.z, -p.y};
    pattern_.issues.emplace_back(
        "The garment was taken to stand along z, since it is higher there than along y; it was turned to stand along y.");
}

void MeshReader::find_outlines()
{
    for (std::size_t i = 0; i < found_.islands.size(); ++i) {
        const Island& island = found_.islands[i];
        std::vector<FlatPlace> outline;
        for (const int corner : island.loop) outline.push_back(flat_of(corner));
        if (outline.size() < 3 || std::abs(signed_area(outline)) < least_area) continue;
        kept_.push_back(i);
    }
    if (kept_.empty()) throw FileError(name_ + ": No island of the flat coordinates is as large as a panel.");
    if (kept_.size() < found_.islands.size())
        pattern_.issues.push_back(fmt::format("{} islands of less than 10 mm2 were left out.", found_.islands.size() - kept_.size()));
}

void MeshReader::name_panels()
{
    std::set<std::string> taken;
    std::map<std::string, int> used;
    std::vector<std::string> wishes;
    for (const std::size_t i : kept_) {
        std::map<int, int> votes;
        for (const int t : found_.islands[i].triangles) ++votes[mesh_.label.empty() ? -1 : mesh_.label[t]];
        const auto most = std::max_element(votes.begin(), votes.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
        const bool named = most->first >= 0 && !mesh_.labels[most->first].empty();
        wishes.push_back(named ? mesh_.labels[most->first] : std::string());
        ++used[wishes.back()];
    }
    for (std::size_t k = 0; k < kept_.size(); ++k) {
        // A name that all share is the garment's.
        const bool own = !wishes[k].empty() && !(used.size() == 1 && kept_.size() > 1);
        const std::string name =
            own ? free_name(wishes[k], [&taken](const std::string& wish) { return taken.contains(wish); }) : fmt::format("panel_{}", k + 1);
        taken.insert(name);
        pattern_.panels.emplace_back();
        pattern_.panels.back().name = name;
    }
}

/// Gives places of outlines that meet in space one number.
class Meetings {
public:
    int number_of(const Vec3d& p)
    {
        const std::array<long long, 3> own{std::llround(p.x / meeting), std::llround(p.y / meeting), std::llround(p.z / meeting)};
        for (long long x = -1; x <= 1; ++x)
            for (long long y = -1; y <= 1; ++y)
                for (long long z = -1; z <= 1; ++z) {
                    const auto cell = cells_.find({own[0] + x, own[1] + y, own[2] + z});
                    if (cell == cells_.end()) continue;
                    for (const int number : cell->second)
                        if (length(places_[number] - p) <= meeting) return number;
                }
        cells_[own].push_back(static_cast<int>(places_.size()));
        places_.push_back(p);
        return static_cast<int>(places_.size()) - 1;
    }

private:
    std::map<std::array<long long, 3>, std::vector<int>> cells_;
    std::vector<Vec3d> places_;
};

void MeshReader::find_meetings()
{
    Meetings meetings;
    numbers_.resize(kept_.size());
    for (std::size_t k = 0; k < kept_.size(); ++k) {
        for (const int corner : loop_of(k)) numbers_[k].push_back(meetings.number_of(place_of(corner)));
        for (std::size_t i = 0; i < numbers_[k].size(); ++i) {
            const auto [a, b] = std::minmax(numbers_[k][i], numbers_[k][(i + 1) % numbers_[k].size()]);
            if (a != b) sides_.emplace(std::pair(a, b), PanelSide{static_cast<int>(k), static_cast<int>(i)});
        }
    }
}

/// The side that one is sewn to; panel -1: none.
PanelSide MeshReader::partner(std::size_t k, std::size_t i) const
{
    const auto [a, b] = std::minmax(numbers_[k][i], numbers_[k][(i + 1) % numbers_[k].size()]);
    const auto [first, last] = sides_.equal_range({a, b});
    int tried = 0;
    for (auto other = first; other != last && tried < 8; ++other, ++tried)
        if (other->second.panel != static_cast<int>(k) || other->second.at != static_cast<int>(i)) return other->second;
    return {-1, -1};
}

/// Edges end at corners and where the panel beyond changes; where one ends, so does the one that it is sewn to.
void MeshReader::split()
{
    std::set<int> ends;
    for (std::size_t k = 0; k < kept_.size(); ++k) {
        const std::vector<int>& loop = loop_of(k);
        const std::size_t count = loop.size();
        for (std::size_t i = 0; i < count; ++i) {
            const FlatPlace &p = flat_of(loop[(i + count - 1) % count]), &q = flat_of(loop[i]), &r = flat_of(loop[(i + 1) % count]);
            const double ax = q[0] - p[0], ay = q[1] - p[1], bx = r[0] - q[0], by = r[1] - q[1];
            const bool corner = std::abs(std::atan2(ax * by - ay * bx, ax * bx + ay * by)) > sharp;
            if (corner || partner(k, (i + count - 1) % count).panel != partner(k, i).panel) ends.insert(numbers_[k][i]);
        }
        const bool none = std::none_of(numbers_[k].begin(), numbers_[k].end(), [&ends](int number) { return ends.contains(number); });
        if (none) ends.insert(numbers_[k][0]); // it is round, as a patch
    }
    edge_of_.resize(kept_.size());
    for (std::size_t k = 0; k < kept_.size(); ++k) {
        const std::vector<int>& loop = loop_of(k);
        const std::size_t count = loop.size();
        std::size_t begin = 0;
        while (begin < count && !ends.contains(numbers_[k][begin])) ++begin;
        std::vector<PanelEdge>& edges = pattern_.panels[k].edges;
        edge_of_[k].resize(count);
        for (std::size_t step = 0; step < count; ++step) {
            const std::size_t i = (begin + step) % count;
            if (step == 0 || ends.contains(numbers_[k][i])) edges.push_back({{flat_of(loop[i])}});
            edges.back().places.push_back(flat_of(loop[(i + 1) % count]));
            edge_of_[k][i] = static_cast<int>(edges.size()) - 1;
        }
    }
}

void MeshReader::sew()
{
    std::set<std::array<int, 4>> sewn;
    for (std::size_t k = 0; k < kept_.size(); ++k)
        for (std::size_t i = 0; i < edge_of_[k].size(); ++i) {
            const PanelSide other = partner(k, i);
            if (other.panel < 0) continue;
            const auto m = static_cast<std::size_t>(other.panel), n = static_cast<std::size_t>(other.at);
            std::array<int, 4> pair{static_cast<int>(k), edge_of_[k][i], other.panel, edge_of_[m][n]};
            if (std::pair(pair[2], pair[3]) < std::pair(pair[0], pair[1])) pair = {pair[2], pair[3], pair[0], pair[1]};
            if (sewn.insert(pair).second) pattern_.seams.push_back({pair[0], pair[1], pair[2], pair[3], numbers_[k][i] != numbers_[m][n]});
        }
}

void MeshReader::make_shape_of_mesh()
{
    for (std::size_t k = 0; k < kept_.size(); ++k) {
        std::map<int, int> numbers;
        double sx = 0, sy = 0, count = 0, xx = 0, xy = 0, yy = 0;
        Vec3d middle{}, by_x{}, by_y{};
        const auto each = [&](auto act) {
            for (const auto& [corner, number] : numbers) act(flat_of(corner), place_of(corner));
        };
        for (const int t : found_.islands[kept_[k]].triangles) {
            std::array<int, 3> triangle{};
            for (std::size_t c = 0; c < 3; ++c) {
                const int corner = found_.triangles[t][c];
                const auto [at, fresh] = numbers.try_emplace(corner, static_cast<int>(pattern_.shape.flat.size()));
                triangle[c] = at->second;
                if (!fresh) continue;
                pattern_.shape.flat.push_back(flat_of(corner));
                pattern_.shape.places.push_back(place_of(corner));
            }
            pattern_.shape.triangles.push_back(triangle);
            pattern_.shape.panel.push_back(static_cast<int>(k));
        }
        each([&](const FlatPlace& flat, const Vec3d& place) {
            sx += flat[0];
            sy += flat[1];
            middle += place;
            ++count;
        });
        sx /= count;
        sy /= count;
        middle = (1 / count) * middle;
        each([&](const FlatPlace& flat, const Vec3d& place) {
            const double x = flat[0] - sx, y = flat[1] - sy;
            xx += x * x;
            xy += x * y;
            yy += y * y;
            by_x += x * (place - middle);
            by_y += y * (place - middle);
        });
        const double whole = xx * yy - xy * xy; // least squares
        if (!(whole > 0)) continue;
        std::array<Vec3d, 3>& placed = pattern_.panels[k].placed;
        placed[1] = (1 / whole) * (yy * by_x - xy * by_y);
        placed[2] = (1 / whole) * (xx * by_y - xy * by_x);
        placed[0] = middle - sx * placed[1] - sy * placed[2];
    }
}

/// What was repaired, or looks wrong.
void MeshReader::tell()
{
    std::size_t mirrored = 0;
    int turned = 0;
    for (std::size_t k = 0; k < kept_.size(); ++k) {
        const Island& island = found_.islands[kept_[k]];
        const std::string& panel = pattern_.panels[k].name;
        mirrored += island.mirrored;
        turned += island.turned;
        if (island.folded > 0)
            pattern_.issues.push_back(
                fmt::format("The panel \"{}\" has {} triangles that lie folded over in its flat coordinates.", panel, island.folded));
        if (island.holes > 0)
            pattern_.issues.push_back(
                fmt::format("The panel \"{}\" has {} holes; its outline goes round them, and they count as cloth.", panel, island.holes));
    }
    if (mirrored > 0)
        pattern_.issues.push_back(fmt::format("{} of {} panels had mirrored flat coordinates, as seen from inside; they were turned over.",
                                              mirrored, kept_.size()));
    if (turned > 0)
        pattern_.issues.push_back(fmt::format("{} triangles faced the other way than those around them; they were turned.", turned));
    if (found_.doubled > 0)
        pattern_.issues.push_back(fmt::format(
            "{} triangles lie on others with the same corners, as in a mesh with two faces; they were left out.", found_.doubled));
    if (found_.shared_sides > 0)
        pattern_.issues.push_back(
            fmt::format("{} sides belong to more than two triangles; the mesh is no single layer of cloth there.", found_.shared_sides));
    pattern_.issues.insert(pattern_.issues.end(), mesh_.issues.begin(), mesh_.issues.end());
    std::vector<std::vector<FlatPlace>> outlines; // as the file has them
    for (std::size_t k = 0; k < kept_.size(); ++k) {
        outlines.push_back(outline_of(pattern_.panels[k]));
        if (found_.islands[kept_[k]].mirrored)
            for (FlatPlace& place : outlines.back()) place[0] = -place[0];
    }
    tell_overlaps(pattern_, outlines);
}

GarmentPattern MeshReader::read()
{
    find_scales();
    stand_up();
    find_outlines();
    name_panels();
    find_meetings();
    split();
    sew();
    make_shape_of_mesh();
    tell();
    pattern_.is_draped = true;
    tell_odd_shapes(pattern_);
    find_body(pattern_);
    return std::move(pattern_);
}

} // namespace

GarmentPattern pattern_from_obj(std::string_view text, const std::string& name, UvUnit unit)
{
    const FlatMesh mesh = mesh_from_obj(text, name);
    return MeshReader(mesh, name, unit).read();
}

namespace {

FlatMesh mesh_of(const std::filesystem::path& path, const Asked& cancelled)
{
    const std::string name = path.string();
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char letter) { return std::tolower(letter); });
    if (ending == ".obj") return mesh_from_obj(read_file(path, largest_mesh_bytes), name);
    if (ending == ".ply") return mesh_from_ply(read_file(path, largest_mesh_bytes), name);
    if (ending == ".glb" || ending == ".gltf") return mesh_from_gltf(path);
    if (ending == ".fbx" || ending == ".dae") return mesh_apart(path, ending.substr(1), cancelled);
    throw FileError(fmt::format("{}: A garment is read from .json, .obj, .glb, .gltf, .fbx, .ply or .dae; given is \"{}\".", name, ending));
}

} // namespace

GarmentPattern pattern_from_mesh(const std::filesystem::path& path, UvUnit unit, const Asked& cancelled)
{
    const FlatMesh mesh = mesh_of(path, cancelled);
    return MeshReader(mesh, path.string(), unit).read();
}

} // namespace hygroloom
