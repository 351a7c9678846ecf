// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/garment/mesh_builder.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/base/utf8.h"
#include "core/garment/ears.h"
#include "core/garment/outline.h"

#include <fmt/format.h>

namespace hygroloom {

namespace {

constexpr std::size_t most_names = 10000, longest_panel_name = 100, most_face_corners = 1000;
constexpr double farthest = 1e12; // units of the file

} // namespace

void MeshBuilder::refuse(const std::string& sentence) const { throw FileError(name_ + ": " + sentence); }

void MeshBuilder::expect(std::size_t places, std::size_t triangles) const
{
    if (places > most_mesh_places || triangles > most_mesh_triangles)
        refuse(fmt::format("A mesh has up to {} places and {} triangles; this one has more.", most_mesh_places, most_mesh_triangles));
}

void MeshBuilder::add_place(const Vec3d& place)
{
    for (const double number : {place.x, place.y, place.z})
        if (!(std::abs(number) < farthest)) refuse("A place of the mesh is no number, or beyond 1e12.");
    expect(mesh_.places.size() + 1, 0);
    mesh_.places.push_back(place);
}

void MeshBuilder::add_flat(const FlatPlace& flat)
{
    for (const double number : flat)
        if (!(std::abs(number) < farthest)) refuse("A flat coordinate of the mesh is no number, or beyond 1e12.");
    expect(mesh_.uv.size() + 1, 0);
    mesh_.uv.push_back(flat);
}

void MeshBuilder::name(std::size_t way, std::string_view text)
{
    const std::string label = in_whole_utf8(cut_text(text, longest_panel_name));
    auto& known = names_[way];
    if (known.size() < most_names || known.contains(label))
        now_[way] = known.try_emplace(label, static_cast<int>(known.size())).first->second;
}

void MeshBuilder::add_triangle(const Corner& a, const Corner& b, const Corner& c)
{
    expect(0, mesh_.triangles.size() + 1);
    mesh_.triangles.push_back({a[0], b[0], c[0]});
    mesh_.uv_triangles.push_back({a[1], b[1], c[1]});
    named_.push_back(now_);
}

void MeshBuilder::add_face(const std::vector<Corner>& corners)
{
    if (corners.size() > most_face_corners) refuse(fmt::format("A face has up to {} corners; one has more.", most_face_corners));
    outline_.clear();
    for (const auto& [place, flat] : corners) {
        if (place < 0 || flat < 0 || static_cast<std::size_t>(place) >= places() || static_cast<std::size_t>(flat) >= flats())
            refuse(fmt::format("A face names vertex {}, which is not there; the last is {}, counted from 0.", place,
                               static_cast<long long>(places()) - 1));
        outline_.push_back(mesh_.uv[flat]);
    }
    if (corners.size() < 3) return;
    if (corners.size() == 3) return add_triangle(corners[0], corners[1], corners[2]);
    ears_.clear();
    if (!cut_ears(outline_, ears_, work_)) {
        crossed_ += signed_area(outline_) != 0;
        ears_.clear();
        for (int i = 2; i < static_cast<int>(corners.size()); ++i) ears_.push_back({0, i - 1, i});
    }
    for (const auto& [a, b, c] : ears_) add_triangle(corners[a], corners[b], corners[c]);
}

void MeshBuilder::give_labels()
{
    std::size_t way = 0;
    while (way < 3 && names_[way].size() < 2) ++way;
    for (std::size_t other = 0; way == 3 && other < 3; ++other)
        if (!names_[other].empty()) way = other;
    mesh_.label.assign(named_.size(), -1);
    if (way == 3) return;
    mesh_.labels.resize(names_[way].size());
    for (const auto& [label, number] : names_[way]) mesh_.labels[number] = label;
    for (std::size_t t = 0; t < named_.size(); ++t) mesh_.label[t] = named_[t][way];
}

FlatMesh MeshBuilder::finish(double metre)
{
    if (mesh_.triangles.empty())
        refuse(without_flat_ > 0 ? "The mesh has no flat coordinates (UV); without them its panels are not known."
                                 : "The file has no faces.");
    if (without_flat_ > 0) tell(fmt::format("{} faces have no flat coordinates and were left out.", without_flat_));
    if (crossed_ > 0)
        tell(fmt::format("{} faces cross themselves in their flat coordinates and were cut into triangles from their first corner.",
                         crossed_));
    mesh_.metre = metre;
    give_labels();
    return std::move(mesh_);
}

} // namespace hygroloom
