// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The triangles of a glTF scene, as its nodes and skins put them into space (glTF 2.0 specification, 3.5 to 3.7).
#include "core/base/text.h"
#include "core/base/utf8.h"
#include "core/garment/gltf_file.h"
#include "core/garment/mesh_builder.h"
#include "core/project/json_reader.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>

namespace hygroloom {

namespace {

using Eigen::Matrix4d;

/// How MeshBuilder counts names.
enum : std::size_t { of_node, of_mesh, of_material };

/// Extensions that a file may require. KHR_mesh_quantization: integers where the format has floats, which all attributes may be here.
constexpr std::array known_extensions{"KHR_mesh_quantization"};

class GltfReader {
public:
    explicit GltfReader(const GltfFile& file) : file_(file), mesh_(file.name()) {}
    FlatMesh read()
    {
        place_nodes();
        for (const std::size_t node : drawn()) add_node(node);
        return mesh_.finish(1);
    }

private:
    void place_nodes();
    Matrix4d own_place(const ProjectJson& node) const;
    std::vector<std::size_t> drawn() const;
    void add_node(std::size_t number);
    void add_primitive(const ProjectJson& primitive, const ProjectJson& node, const Matrix4d& place);
    /// Of each vertex; empty without a skin.
    std::vector<Matrix4d> skin(const ProjectJson& node, const ProjectJson& attributes, std::size_t vertices) const;
    /// Vertices of each triangle.
    std::vector<std::array<std::size_t, 3>> faces_of(const ProjectJson& primitive, std::size_t vertices) const;

    const GltfFile& file_;
    MeshBuilder mesh_;
    std::vector<Matrix4d> places_; ///< of nodes, in the world
    std::vector<std::vector<std::size_t>> children_;
    std::vector<bool> is_child_;
};

Matrix4d GltfReader::own_place(const ProjectJson& node) const
{
    if (const std::vector<double> all = file_.numbers(node, "matrix", 16); !all.empty())
        return Matrix4d(Eigen::Map<const Matrix4d>(all.data()));
    Eigen::Affine3d place = Eigen::Affine3d::Identity();
    if (const std::vector<double> move = file_.numbers(node, "translation", 3); !move.empty())
        place.translate(Eigen::Vector3d(move[0], move[1], move[2]));
    if (const std::vector<double> turn = file_.numbers(node, "rotation", 4); !turn.empty())
        place.rotate(Eigen::Quaterniond(turn[3], turn[0], turn[1], turn[2]).normalized());
    if (const std::vector<double> scale = file_.numbers(node, "scale", 3); !scale.empty())
        place.scale(Eigen::Vector3d(scale[0], scale[1], scale[2]));
    return place.matrix();
}

void GltfReader::place_nodes()
{
    const std::size_t count = file_.count("nodes");
    children_.resize(count);
    is_child_.resize(count);
    places_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        places_[i] = own_place(file_.item("nodes", i));
        children_[i] = file_.indices(file_.item("nodes", i), "children");
        for (const std::size_t child : children_[i]) {
            if (child >= count || child == i || is_child_[child])
                file_.refuse(fmt::format("nodes[{}] has the child {}, which is not there, or stands under another node, too.", i, child));
            is_child_[child] = true;
        }
    }
    std::vector<std::size_t> waiting;
    for (std::size_t i = 0; i < count; ++i)
        if (!is_child_[i]) waiting.push_back(i);
    while (!waiting.empty()) {
        const std::size_t node = waiting.back();
        waiting.pop_back();
        for (const std::size_t child : children_[node]) {
            places_[child] = places_[node] * places_[child];
            waiting.push_back(child);
        }
    }
}

/// The nodes of the scene, in the file's order of each level; of all that have no parent where there is no scene.
std::vector<std::size_t> GltfReader::drawn() const
{
    std::vector<std::size_t> nodes;
    if (file_.count("scenes") > 0) {
        std::vector<bool> taken(children_.size());
        for (const std::size_t node : file_.indices(file_.item("scenes", file_.index(file_.root(), "scene").value_or(0)), "nodes")) {
            if (node >= children_.size() || is_child_[node] || taken[node])
                file_.refuse(fmt::format("The scene names nodes[{}], which is not there, stands twice or is no root.", node));
            taken[node] = true;
            nodes.push_back(node);
        }
    } else {
        for (std::size_t i = 0; i < children_.size(); ++i)
            if (!is_child_[i]) nodes.push_back(i);
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes.insert(nodes.end(), children_[nodes[i]].begin(), children_[nodes[i]].end());
    return nodes;
}

void GltfReader::add_node(std::size_t number)
{
    const ProjectJson& node = file_.item("nodes", number);
    const auto mesh_number = file_.index(node, "mesh");
    if (!mesh_number) return;
    const ProjectJson& mesh = file_.item("meshes", *mesh_number);
    mesh_.name(of_node, file_.text(node, "name"));
    mesh_.name(of_mesh, file_.text(mesh, "name"));
    const auto primitives = mesh.find("primitives");
    if (primitives == mesh.end() || !primitives->is_array()) file_.refuse(fmt::format("meshes[{}] has no primitives.", *mesh_number));
    for (const ProjectJson& primitive : *primitives) {
        if (!primitive.is_object() || !primitive.contains("attributes") || !primitive["attributes"].is_object())
            file_.refuse(fmt::format("meshes[{}] has a primitive without attributes.", *mesh_number));
        const auto material = file_.index(primitive, "material");
        mesh_.name(of_material, material ? file_.text(file_.item("materials", *material), "name") : std::string());
        add_primitive(primitive, node, places_[number]);
    }
}

std::vector<Matrix4d> GltfReader::skin(const ProjectJson& node, const ProjectJson& attributes, std::size_t vertices) const
{
    const auto number = file_.index(node, "skin");
    if (!number || !attributes.contains("JOINTS_0") || !attributes.contains("WEIGHTS_0")) return {};
    const ProjectJson& given = file_.item("skins", *number);
    std::vector<Matrix4d> joints;
    for (const std::size_t joint : file_.indices(given, "joints")) {
        if (joint >= places_.size()) file_.refuse(fmt::format("skins[{}] names nodes[{}], which is not there.", *number, joint));
        joints.push_back(places_[joint]);
    }
    if (const auto bind = file_.index(given, "inverseBindMatrices")) {
        const GltfNumbers inverse = file_.accessor(*bind, "MAT4", 65536);
        for (std::size_t i = 0; i < std::min(joints.size(), inverse.count); ++i)
            joints[i] = joints[i] * Matrix4d(Eigen::Map<const Matrix4d>(inverse.at(i)));
    }
    std::vector<Matrix4d> places(vertices, Matrix4d::Zero());
    for (int set = 0; set < 8; ++set) {
        const auto of = file_.index(attributes, fmt::format("JOINTS_{}", set).c_str()),
                   by = file_.index(attributes, fmt::format("WEIGHTS_{}", set).c_str());
        if (!of || !by) break;
        const GltfNumbers joint = file_.accessor(*of, "VEC4", vertices), weight = file_.accessor(*by, "VEC4", vertices);
        for (std::size_t i = 0; i < std::min(joint.count, weight.count); ++i)
            for (std::size_t k = 0; k < 4; ++k) {
                const double w = weight.at(i)[k], j = joint.at(i)[k];
                if (w == 0) continue;
                if (!(j >= 0 && j < static_cast<double>(joints.size())))
                    file_.refuse(fmt::format("A vertex names joint {} of skins[{}], which is not there.", j, *number));
                places[i] += w * joints[j];
            }
    }
    return places;
}

void GltfReader::add_primitive(const ProjectJson& primitive, const ProjectJson& node, const Matrix4d& place)
{
    const ProjectJson& attributes = primitive["attributes"];
    const auto position = file_.index(attributes, "POSITION"), flat = file_.index(attributes, "TEXCOORD_0");
    if (!position) return;
    const GltfNumbers places = file_.accessor(*position, "VEC3", most_mesh_places);
    const std::vector<std::array<std::size_t, 3>> faces = faces_of(primitive, places.count);
    if (!flat) {
        for (std::size_t f = 0; f < faces.size(); ++f) mesh_.add_face_without_flat();
        return;
    }
    const GltfNumbers uv = file_.accessor(*flat, "VEC2", most_mesh_places);
    if (uv.count < places.count)
        file_.refuse(fmt::format("A primitive has {} vertices and {} flat coordinates; they must agree.", places.count, uv.count));
    const std::vector<Matrix4d> skinned = skin(node, attributes, places.count);
    const auto of = [&](std::size_t vertex) -> const Matrix4d& { return skinned.empty() ? place : skinned[vertex]; };
    std::vector<int> numbers(places.count, -1); // primitives may share vertices: only those that this one names are added
    std::vector<MeshBuilder::Corner> corners(3);
    for (std::array<std::size_t, 3> face : faces) {
        // A place that mirrors changes the way round (3.7.4).
        if (of(face[0]).topLeftCorner<3, 3>().determinant() < 0) std::swap(face[1], face[2]);
        for (std::size_t k = 0; k < 3; ++k) {
            int& number = numbers[face[k]];
            if (number < 0) {
                const double* const p = places.at(face[k]);
                const Eigen::Vector4d at = of(face[k]) * Eigen::Vector4d(p[0], p[1], p[2], 1);
                number = static_cast<int>(mesh_.places());
                mesh_.add_place({at.x(), at.y(), at.z()});
                mesh_.add_flat({uv.at(face[k])[0], 1 - uv.at(face[k])[1]}); // glTF counts downwards
            }
            corners[k] = {number, number};
        }
        mesh_.add_face(corners);
    }
}

std::vector<std::array<std::size_t, 3>> GltfReader::faces_of(const ProjectJson& primitive, std::size_t vertices) const
{
    enum Mode : std::size_t { triangles = 4, strip = 5, fan = 6 };
    const std::size_t mode = file_.index(primitive, "mode").value_or(triangles);
    if (mode < triangles) return {}; // points and lines
    const auto listed = file_.index(primitive, "indices");
    const GltfNumbers given = listed ? file_.accessor(*listed, "SCALAR", 3 * most_mesh_triangles) : GltfNumbers{};
    const std::size_t count = listed ? given.count : vertices;
    const auto vertex = [&](std::size_t i) {
        const double number = listed ? given.values[i] : static_cast<double>(i);
        if (!(number >= 0 && number < static_cast<double>(vertices)))
            file_.refuse(fmt::format("A face names vertex {}, which is not there; the last is {}, counted from 0.", number,
                                     static_cast<long long>(vertices) - 1));
        return static_cast<std::size_t>(number);
    };
    std::vector<std::array<std::size_t, 3>> faces(mode == triangles ? count / 3 : count < 3 ? 0 : count - 2);
    mesh_.expect(0, faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f) {
        faces[f] = {3 * f, 3 * f + 1, 3 * f + 2};
        if (mode == strip) faces[f] = {f, f + 1 + f % 2, f + 2 - f % 2};
        if (mode == fan) faces[f] = {f + 1, f + 2, 0};
        for (std::size_t& corner : faces[f]) corner = vertex(corner);
    }
    return faces;
}

void require_readable(const GltfFile& file)
{
    const auto asset = file.root().find("asset");
    const std::string version = asset != file.root().end() && asset->is_object() ? file.text(*asset, "version") : std::string();
    if (!version.starts_with("2."))
        file.refuse(fmt::format("glTF of version 2 is read; asset.version is \"{}\".", in_one_line(cut_text(version, 40))));
    const auto required = file.root().find("extensionsRequired");
    if (required == file.root().end()) return;
    for (const ProjectJson& one : array_in(*required, file.name(), "extensionsRequired")) {
        const std::string extension = text_in(one, file.name(), "extensionsRequired");
        if (std::find(known_extensions.begin(), known_extensions.end(), extension) == known_extensions.end())
            file.refuse(fmt::format("The file requires the extension {}, which is not read here; export it without.",
                                    in_one_line(cut_text(extension, 100))));
    }
}

} // namespace

FlatMesh mesh_from_gltf(const std::filesystem::path& path)
{
    const GltfFile file(path);
    require_readable(file);
    return GltfReader(file).read();
}

} // namespace hygroloom
