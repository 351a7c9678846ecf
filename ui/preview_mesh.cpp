// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/preview_mesh.h"

#include "core/base/units.h"
#include "core/geometry/mesh.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

struct Level {
    int samples;
    int sides;
};

// From finest to coarsest.
constexpr Level levels[] = {{10, 20}, {8, 16}, {6, 12}, {4, 12}, {4, 8}, {3, 8}, {2, 8}, {2, 4}};

std::size_t triangles_per_crossing(const Level& level)
{
    return static_cast<std::size_t>(2 * 2 * level.samples * level.sides);
}

const Level& level_within(const Textile& textile, std::size_t budget)
{
    for (const Level& level : levels) {
        if (mesh_size(textile, level.samples, level.sides).triangles <= budget) {
            return level;
        }
    }
    return *std::rbegin(levels);
}

std::shared_ptr<const PreviewMesh> mesh_at(const PreviewRequest& request, const Textile& textile, const QVector3D& offset, const Level& level)
{
    const YarnMesh yarns = mesh_yarns(textile, level.samples, level.sides);
    auto mesh = std::make_shared<PreviewMesh>();
    mesh->request = request;
    mesh->textile = textile;
    mesh->offset = offset;
    mesh->indices = yarns.indices;
    mesh->vertices.resize(yarns.segment_of_vertex.size());
    for (std::size_t i = 0; i < mesh->vertices.size(); ++i) {
        PreviewVertex& vertex = mesh->vertices[i];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            vertex.position[axis] = static_cast<float>(mm_from_metre(yarns.positions[3 * i + axis])) + offset[static_cast<int>(axis)];
            vertex.normal[axis] = yarns.normals[3 * i + axis];
        }
        vertex.along = yarns.uvs[2 * i];
        vertex.around = yarns.uvs[2 * i + 1];
        vertex.segment = static_cast<std::uint32_t>(yarns.segment_of_vertex[i]);
    }
    return mesh;
}

} // namespace

QVector3D PreviewMesh::high() const
{
    return offset
        + QVector3D(static_cast<float>(mm_from_metre(0.5 * textile.ends() * textile.warp.pitch)),
                    static_cast<float>(mm_from_metre(0.5 * textile.picks() * textile.weft.pitch)),
                    static_cast<float>(mm_from_metre(textile.half_thickness())));
}

QVector3D PreviewMesh::low() const
{
    return 2 * offset - high();
}

std::vector<float> PreviewMesh::patchValues(const std::vector<float>& values) const
{
    std::vector<float> picked;
    const TextileRegion& whole = request.whole;
    const auto crossings = static_cast<std::size_t>(whole.ends) * static_cast<std::size_t>(whole.picks);
    if (values.size() < 2 * crossings) {
        return picked;
    }
    const int end0 = request.patch.first_end - whole.first_end;
    const int pick0 = request.patch.first_pick - whole.first_pick;
    picked.reserve(static_cast<std::size_t>(textile.segments()));
    for (int end = 0; end < textile.ends(); ++end) {
        for (int pick = 0; pick < textile.picks(); ++pick) {
            picked.push_back(values[static_cast<std::size_t>(end0 + end) * static_cast<std::size_t>(whole.picks) + static_cast<std::size_t>(pick0 + pick)]);
        }
    }
    for (int pick = 0; pick < textile.picks(); ++pick) {
        for (int end = 0; end < textile.ends(); ++end) {
            picked.push_back(values[crossings + static_cast<std::size_t>(pick0 + pick) * static_cast<std::size_t>(whole.ends) + static_cast<std::size_t>(end0 + end)]);
        }
    }
    return picked;
}

TextileRegion patch_of_repeats(const Weave& weave, int crossings)
{
    const auto count = [crossings](int repeat) {
        const int repeats = static_cast<int>(std::ceil(0.66 * crossings / repeat));
        return std::clamp(repeats * repeat, 2, crossings);
    };
    return {0, 0, count(weave.ends()), count(weave.picks())};
}

TextileRegion patch_within(const TextileRegion& whole, std::size_t triangle_budget, int centre_end, int centre_pick)
{
    const double most = std::max(4.0, static_cast<double>(triangle_budget) / static_cast<double>(triangles_per_crossing(*std::rbegin(levels))));
    TextileRegion patch = whole;
    const double crossings = static_cast<double>(whole.ends) * whole.picks;
    if (crossings <= most) {
        return patch;
    }
    // A square as far as the sample is wide enough for one.
    const double side = std::sqrt(most);
    patch.ends = std::min(whole.ends, static_cast<int>(whole.picks < side ? most / whole.picks : side));
    patch.picks = std::min(whole.picks, static_cast<int>(most / patch.ends));
    patch.first_end = whole.first_end + std::clamp(centre_end - patch.ends / 2, 0, whole.ends - patch.ends);
    patch.first_pick = whole.first_pick + std::clamp(centre_pick - patch.picks / 2, 0, whole.picks - patch.picks);
    return patch;
}

void build_preview(const PreviewRequest& request, const std::function<bool()>& outdated,
                   const std::function<void(std::shared_ptr<const PreviewMesh>)>& deliver)
{
    const Fabric& fabric = request.design->fabrics[static_cast<std::size_t>(request.fabric)];
    const Textile textile = build_textile(*request.design, fabric, request.patch);
    const auto middle = [](int first, int count, int wholeFirst, int wholeCount) { return first + 0.5 * count - wholeFirst - 0.5 * wholeCount; };
    const QVector3D offset(
        static_cast<float>(mm_from_metre(textile.warp.pitch) * middle(request.patch.first_end, request.patch.ends, request.whole.first_end, request.whole.ends)),
        static_cast<float>(mm_from_metre(textile.weft.pitch) * middle(request.patch.first_pick, request.patch.picks, request.whole.first_pick, request.whole.picks)),
        0);
    const Level& fine = level_within(textile, request.triangle_budget);
    const Level& coarse = level_within(textile, request.triangle_budget / 6);
    if (&coarse != &fine) {
        deliver(mesh_at(request, textile, offset, coarse));
        if (outdated()) {
            return;
        }
    }
    const auto mesh = std::const_pointer_cast<PreviewMesh>(mesh_at(request, textile, offset, fine));
    mesh->fine = true;
    deliver(mesh);
}

} // namespace hygroloom
