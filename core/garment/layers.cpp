// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/garment/pattern.h"

#include <algorithm>

namespace hygroloom {
namespace {

constexpr double apart = 1e-3; ///< m, of layers as they are drawn

/// Adds a panel's triangles again, the given way nearer to the body, for another panel.
void add_inside(GarmentShape& shape, int panel, int inner, double way)
{
    std::vector<Vec3d> normals(shape.places.size());
    std::vector<int> copy(shape.places.size(), -1);
    const std::size_t triangles = shape.triangles.size();
    for (std::size_t t = 0; t < triangles; ++t) {
        if (shape.panel[t] != panel) continue;
        const auto at = [&](std::size_t k) { return static_cast<std::size_t>(shape.triangles[t][k]); };
        const Vec3d normal = cross(shape.places[at(1)] - shape.places[at(0)], shape.places[at(2)] - shape.places[at(0)]);
        for (std::size_t k = 0; k < 3; ++k) normals[at(k)] = normals[at(k)] + normal;
    }
    for (std::size_t t = 0; t < triangles; ++t) {
        if (shape.panel[t] != panel) continue;
        std::array<int, 3> corners = shape.triangles[t];
        for (int& corner : corners) {
            const auto from = static_cast<std::size_t>(corner);
            if (copy[from] < 0) {
                copy[from] = static_cast<int>(shape.places.size());
                const double size = length(normals[from]);
                const Vec3d place = shape.places[from];
                shape.places.push_back(size > 0 ? place - (way / size) * normals[from] : place);
                shape.flat.push_back(FlatPlace(shape.flat[from]));
            }
            corner = copy[from];
        }
        shape.triangles.push_back(corners);
        shape.panel.push_back(inner);
    }
}

} // namespace

void add_layers(GarmentPattern& pattern, const Garment& garment)
{
    std::vector<std::vector<int>> layers; // of each panel, from the outside on
    const int count = static_cast<int>(pattern.panels.size());
    for (int panel = 0; panel < count; ++panel) {
        const PanelCut* cut = garment.cut_of(pattern.panels[panel].name);
        std::vector<int>& own = layers.emplace_back(1, panel);
        for (int layer = 2; cut != nullptr && layer <= cut->layers; ++layer) {
            PatternPanel inner = pattern.panels[panel];
            inner.layer_of = inner.name;
            inner.name = layer_prefix(inner.name) + std::to_string(layer);
            inner.over = own.back();
            own.push_back(static_cast<int>(pattern.panels.size()));
            pattern.panels.push_back(std::move(inner));
            add_inside(pattern.shape, panel, own.back(), (layer - 1) * apart);
        }
    }
    const std::vector<PatternSeam> seams = pattern.seams;
    for (const PatternSeam& seam : seams) {
        const std::vector<int>&a = layers[seam.panel_a], &b = layers[seam.panel_b];
        for (std::size_t layer = 1; layer < std::max(a.size(), b.size()); ++layer) {
            PatternSeam inner = seam;
            inner.panel_a = a[std::min(layer, a.size() - 1)];
            inner.panel_b = b[std::min(layer, b.size() - 1)];
            pattern.seams.push_back(inner);
        }
    }
}

} // namespace hygroloom
