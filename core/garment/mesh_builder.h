// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the readers of meshes share: what they hand over is checked, faces are cut into triangles, names tell panels apart.
#pragma once

#include "core/garment/flat_mesh.h"

#include <map>

namespace hygroloom {

/// A mesh while its file is read. Everything throws FileError, with the file's name.
class MeshBuilder {
public:
    using Corner = std::array<int, 2>; ///< numbers of a place and of a flat coordinate, from 0

    explicit MeshBuilder(std::string name) : name_(std::move(name)) {}
    void add_place(const Vec3d& place);
    void add_flat(const FlatPlace& flat);
    std::size_t places() const { return mesh_.places.size(); }
    std::size_t flats() const { return mesh_.uv.size(); }
    /// Refuses what would be more than a mesh may have.
    void expect(std::size_t places, std::size_t triangles) const;

    /// Names the faces that follow in one of three ways. The first way in which there are several names tells panels apart.
    void name(std::size_t way, std::string_view text);
    /// A simple polygon in flat coordinates, cut there by its ears; one that is none, as a fan. Fewer than 3 corners are left out.
    void add_face(const std::vector<Corner>& corners);
    void add_face_without_flat() { ++without_flat_; }
    void tell(std::string sentence) { mesh_.issues.push_back(std::move(sentence)); }

    /// metre: m of the file's unit, 0: it does not say.
    FlatMesh finish(double metre);
    [[noreturn]] void refuse(const std::string& sentence) const;

private:
    void add_triangle(const Corner& a, const Corner& b, const Corner& c);
    void give_labels();

    std::string name_;
    FlatMesh mesh_;
    std::array<std::map<std::string, int>, 3> names_;
    std::array<int, 3> now_{-1, -1, -1};
    std::vector<std::array<int, 3>> named_; ///< of each triangle, in each way
    std::size_t without_flat_ = 0, crossed_ = 0;
    std::size_t work_ = 200'000'000; ///< comparisons of corners that are left
    std::vector<FlatPlace> outline_;
    std::vector<std::array<int, 3>> ears_;
};

} // namespace hygroloom
