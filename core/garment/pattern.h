// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A garment's pattern, whatever file it comes from: flat panels, the seams between their edges and, where there is one, its draped shape.
#pragma once

#include "core/base/vec3.h"
#include "core/design/garment.h" // body_zones()

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace hygroloom {

using FlatPlace = std::array<double, 2>; ///< m, of the flat panel, y along the pattern's +y
/// Of the triangle a b c; positive when they go round counter-clockwise. m2
inline double twice_area(const FlatPlace& a, const FlatPlace& b, const FlatPlace& c)
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// A side of a panel, as a chain of straight pieces; curves are flattened to within 0.02 mm.
struct PanelEdge {
    std::vector<FlatPlace> places; ///< at least two, the first and the last are the panel's corners
};

/// A piece of flat cloth, as seen from outside the garment. Its edges follow each other round it, counter-clockwise.
struct PatternPanel {
    std::string name;
    std::vector<PanelEdge> edges;
    std::array<Vec3d, 3> placed{}; ///< m: where flat (0, 0) stands beside the body, and what a metre along flat x and y adds to it
    bool on_arm = false;           ///< by its name or its place
    std::string layer_of = {};     ///< name of the panel that it is a further layer of; empty: it is none
    int over = -1;                 ///< the panel that lies on its outer side, as the layer before it

    /// Name by which a garment says how it is cut.
    const std::string& cut() const { return layer_of.empty() ? name : layer_of; }
};

/// Two edges that are sewn together. Lengths may differ (ease): places meet at equal shares of both.
struct PatternSeam {
    int panel_a = 0, edge_a = 0;
    int panel_b = 0, edge_b = 0;
    bool reversed = true; ///< the start of one edge meets the end of the other
};

/// The panels in space. Without a drape each stands flat where it was placed.
struct GarmentShape {
    std::vector<Vec3d> places; ///< m; y upwards, z forwards, x to the wearer's left
    std::vector<FlatPlace> flat;
    std::vector<std::array<int, 3>> triangles;
    std::vector<int> panel; ///< of each triangle
};

struct GarmentPattern {
    std::vector<PatternPanel> panels;
    std::vector<PatternSeam> seams;
    GarmentShape shape; ///< of every panel
    bool is_draped = false;
    bool is_placed = true;           ///< its panels stand beside the body; else zones go by the panels' names
    double floor = 0;                ///< m: y of the floor on which the wearer stands
    double uv_scale = 0;             ///< m per unit of the file's flat coordinates; 0: it has none of an unknown unit
    double uv_scale_spread = 0;      ///< of it over edges, relative (median absolute deviation); 0: it is given
    std::vector<std::string> issues; ///< what was not understood, and what was repaired, in sentences
    std::vector<std::string> doubts; ///< those among the issues that make areas and sizes doubtful
};

/// Whether who waits for the reading of a file wants it no more.
using Asked = std::function<bool()>;
/// Reads the source of a garment, or draws the built-in one. base: folder of the project. Throws FileError with a sentence, Cancelled where
/// cancelled says so.
GarmentPattern read_pattern(const Garment& garment, const std::filesystem::path& base, const Asked& cancelled = {});

/// What names of further layers under a panel begin with; their number follows, from 2 on.
inline std::string layer_prefix(const std::string& panel) { return panel + ", layer "; }
/// Adds panels for the second layer and those after it of panels that have some, sewn as the first. Each lies 1 mm nearer to the body than
/// the one before.
void add_layers(GarmentPattern& pattern, const Garment& garment);

/// m2, by the flattened outline.
double area_of(const PatternPanel& panel);
double perimeter_of(const PatternPanel& panel);

/// Which region (its number in body_zones()) a place in space lies on.
int zone_at(const GarmentPattern& pattern, int panel, const Vec3d& place);
/// The same, or where a zone of the garment's own lies over that place of the panel, its number behind them.
int zone_at(const Garment& garment, const GarmentPattern& pattern, int panel, const Vec3d& place, const FlatPlace& flat);
/// mm of air between skin and cloth at a place: of the "shoulder" where that is named and the cloth rests on it, else of the zone.
double gap_at(const Garment& garment, const GarmentPattern& pattern, int panel, const Vec3d& place);

} // namespace hygroloom
