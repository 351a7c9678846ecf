// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Any bytes, as a sewing pattern or as a mesh with flat coordinates (OBJ, PLY, GLB, glTF), either are refused with a FileError, or become a
// pattern whose seams name edges that are there and whose shape can be drawn.
#include "core/base/error.h"
#include "core/garment/fill.h"
#include "core/garment/mesh_bytes.h"
#include "core/garment/readers.h"
#include "tests/fuzz/require.h"

#include <cmath>
#include <fstream>
#include <unistd.h>

using namespace hygroloom;

namespace {

void check(GarmentPattern pattern, bool flat)
{
    if (flat) {
        make_flat_shape(pattern);
        find_body(pattern);
    }
    for (const PatternPanel& panel : pattern.panels) {
        require(std::isfinite(area_of(panel)) && std::isfinite(perimeter_of(panel)), "panels have areas");
        for (std::size_t e = 0; e < panel.edges.size(); ++e) {
            require(panel.edges[e].places.size() > 1, "edges have ends");
            require(panel.edges[e].places.back() == panel.edges[(e + 1) % panel.edges.size()].places.front(), "edges follow each other");
        }
    }
    const auto edge = [&](int panel, int number) {
        return panel >= 0 && panel < static_cast<int>(pattern.panels.size()) && number >= 0 &&
               number < static_cast<int>(pattern.panels[static_cast<std::size_t>(panel)].edges.size());
    };
    for (const PatternSeam& seam : pattern.seams)
        require(edge(seam.panel_a, seam.edge_a) && edge(seam.panel_b, seam.edge_b), "seams join edges that are there");
    for (std::size_t t = 0; t < pattern.shape.triangles.size(); ++t)
        for (const int corner : pattern.shape.triangles[t]) {
            require(corner >= 0 && corner < static_cast<int>(pattern.shape.flat.size()), "triangles join places that are there");
            const int zone = zone_at(pattern, pattern.shape.panel[t], pattern.shape.places[static_cast<std::size_t>(corner)]);
            require(zone >= 0 && zone < static_cast<int>(body_zones().size()), "each place has a zone");
        }
}

GarmentPattern from_file(std::string_view bytes, const char* ending)
{
    const std::filesystem::path path = std::filesystem::temp_directory_path() / ("pattern-" + std::to_string(::getpid()) + ending);
    std::ofstream(path, std::ios::binary) << bytes;
    return pattern_from_mesh(path, UvUnit::from_lengths);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    try {
        if (bytes.starts_with("ply") || bytes.starts_with("glTF") || bytes.find("\"asset\"") != std::string_view::npos)
            check(from_file(bytes, bytes.starts_with("ply") ? ".ply" : ".gltf"), false);
        else if (bytes.starts_with("{"))
            check(pattern_from_json(bytes, "input.json"), true);
        else if (bytes.starts_with("HLM"))
            mesh_from_answer(bytes, "input.fbx");
        else
            check(pattern_from_obj(bytes, "input.obj", UvUnit::from_lengths), false);
    } catch (const FileError&) {
    }
    return 0;
}
