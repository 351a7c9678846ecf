// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the writers of single formats share; see mesh_file.h.
#pragma once

#include "core/project/export_options.h"
#include "core/project/output_file.h"

#include <array>

namespace hygroloom {

/// All yarns of one colour.
struct YarnMaterial {
    std::string name; ///< "warp", "weft", "extra_1"
    Color color;
};

/// One export. Nothing in it changes but the work done.
struct ExportJob {
    const Textile& textile;
    const ExportOptions& options;
    MeshFormat format;
    std::vector<YarnMaterial> materials;
    std::vector<int> material_of_yarn; ///< all ends, then all picks
    std::vector<Color> water;          ///< per segment; empty without a water map
    std::string shown;                 ///< the file as the user named it
    const ExportProgress* progress = nullptr;

    bool lines() const { return options.mesh.detail == MeshDetail::centreline; }
    bool wet() const { return !water.empty(); }
    int material(YarnKind kind, int yarn) const
    {
        return material_of_yarn[static_cast<std::size_t>(kind == YarnKind::warp ? yarn : textile.ends() + yarn)];
    }
    /// Of one vertex: its segment's water, or its yarn's own colour.
    Color color(YarnKind kind, int yarn, int segment) const
    {
        return wet() ? water[static_cast<std::size_t>(segment)] : materials[static_cast<std::size_t>(material(kind, yarn))].color;
    }
    /// The segment of a centreline's point.
    int segment_of_point(YarnKind kind, int yarn, std::size_t point) const;
    MeshSize size_of(YarnKind kind, int yarn) const { return stream_size(textile, options.mesh, kind, yarn); }
};

ExportJob export_job(const Textile& textile, const Fabric& fabric, const ExportOptions& options, MeshFormat format);

/// Reports the progress and throws Cancelled.
void tell(const ExportJob& job, double share);

/// All yarns' pieces in order, or their middle lines as meshes that have positions and segments only. Throws Cancelled.
void for_each_piece(const ExportJob& job, const std::function<void(const YarnMesh& piece)>& take);

/// A yarn's curves: its middle line, or its fibres.
struct YarnCurves {
    YarnKind kind = YarnKind::warp;
    int yarn = 0;
    std::vector<std::size_t> points; ///< of each curve
    std::vector<double> radii;       ///< of each curve, m
    std::vector<float> positions;    ///< x y z per point, m
    std::vector<int> segments;       ///< per point
};
void for_each_curves(const ExportJob& job, const std::function<void(const YarnCurves& curves)>& take);
struct CurveCount {
    std::size_t curves = 0;
    std::size_t points = 0;
};
CurveCount curve_count(const ExportJob& job, YarnKind kind, int yarn);

template <typename Act> void for_each_yarn(const Textile& textile, Act act)
{
    for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
        for (int yarn = 0; yarn < textile.system(kind).count; ++yarn) act(kind, yarn);
}

/// Of linear light, from sRGB.
double linear_light(std::uint8_t value);

// Each writes the job's format; bytes_of says how many bytes that takes.
void write_obj(const ExportJob& job, const std::filesystem::path& path, const std::filesystem::path& materials,
               const std::string& materials_name);
void write_ply(const ExportJob& job, const std::filesystem::path& path);
void write_stl(const ExportJob& job, const std::filesystem::path& path);
double obj_bytes(const ExportJob& job, const ExportEstimate& size);
double ply_bytes(const ExportJob& job, const ExportEstimate& size);
double stl_bytes(const ExportEstimate& size);

/// Where the parts of a GLB or glTF lie.
struct GltfLayout {
    struct Yarn {
        YarnKind kind;
        int yarn;
        std::size_t buffer;
        std::uint64_t vertices_at, indices_at;
        MeshSize size;
        std::array<float, 3> low{}, high{};
    };
    std::vector<Yarn> yarns;
    std::vector<std::uint64_t> buffers; ///< bytes of each
    bool yarn_too_large = false;        ///< for one buffer of a .gltf
};
GltfLayout gltf_layout(const ExportJob& job);
/// Its length does not depend on the numbers measured while writing.
std::string gltf_json(const ExportJob& job, const GltfLayout& layout, const std::vector<std::string>& buffer_names);
void write_glb(const ExportJob& job, const std::filesystem::path& path);
void write_gltf(const ExportJob& job, const std::filesystem::path& path, const std::vector<std::filesystem::path>& buffers,
                const std::vector<std::string>& buffer_names);
constexpr std::uint64_t glb_overhead = 12 + 8 + 8; ///< header and two chunk headers

void write_bcc(const ExportJob& job, const std::filesystem::path& path);
void write_usda(const ExportJob& job, const std::filesystem::path& path);
double bcc_bytes(const ExportEstimate& size);
double usda_bytes(const ExportJob& job, const ExportEstimate& size);

/// FBX and Collada, through Assimp.
void write_scene(const ExportJob& job, const std::filesystem::path& path);
double scene_bytes(const ExportJob& job, const ExportEstimate& size);
double scene_memory(const ExportJob& job, const ExportEstimate& size);

} // namespace hygroloom
