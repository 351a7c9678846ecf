// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The fabric that is drawn, cut into cells of a few crossings. Cells that look alike share one mesh, so a repeat is made once.
#pragma once

#include "core/geometry/textile.h"

#include <QVector3D>

#include <compare>
#include <cstdint>
#include <iterator>
#include <memory>
#include <vector>

namespace hygroloom {

/// Which crossings to draw; frames are numbered by them.
struct PreviewRequest {
    std::shared_ptr<const Design> design;
    int fabric = 0;
    TextileRegion whole;
    std::shared_ptr<const FittedFabric> fitted; ///< the fabric's; nullptr: not fitted yet
    int shown_ends = 0, shown_picks = 0;        ///< cells in place of its yarns, see in_cells(); 0: the yarns themselves
};

/// How round and how smooth the yarns of a level are, and how wide a pitch must be in the picture for it.
struct TubeLevel {
    int samples; ///< rings per crossing
    int sides;
    double pixels;
};
/// From coarse to fine. Level 0 is a flat picture of the repeat and has no tubes; tubes[0] is level 1.
constexpr TubeLevel tubes[] = {{3, 6, 13}, {5, 8, 20}, {5, 12, 30}, {5, 16, 52}, {8, 20, 100}, {12, 28, 200}};
/// After the tubes come single fibres.
constexpr int fibre_level = static_cast<int>(std::size(tubes)) + 1;
constexpr double fibre_pixels = 220;
/// In this belt skins blend into fibres, the more the nearer.
constexpr double fibre_belt_pixels[] = {fibre_pixels, 1.3 * fibre_pixels};
/// Between the flat picture and the first tubes lies a belt where the picture lies over the tubes, the thinner the nearer.
constexpr double belt_pixels[] = {13, 20};
/// The level for a pitch so wide in the picture. A level that is shown stays a little beyond its range.
int level_for(double pitch_pixels, int shown = -1);

/// What a mesh shows. Equal keys, equal meshes.
struct MeshKey {
    int level = 0;
    int end = 0; ///< first crossing, counted from the repeat's beginning
    int pick = 0;
    int ends = 0;
    int picks = 0;
    auto operator<=>(const MeshKey&) const = default;
};

/// A cell by column (along x) and row (along y).
struct Cell {
    int column = 0;
    int row = 0;
};

struct PreviewFabric {
    PreviewRequest request;
    Textile textile;     ///< of the whole
    int period_ends = 1; ///< the fabric repeats after this number of crossings
    int period_picks = 1;
    int cell_ends = 4;
    int cell_picks = 4;
    std::vector<const Yarn*> end_yarns; ///< of each end of the whole, in the request's design
    std::vector<const Yarn*> pick_yarns;

    int columns() const { return (textile.ends() + cell_ends - 1) / cell_ends; }
    int rows() const { return (textile.picks() + cell_picks - 1) / cell_picks; }
    /// The crossings of a cell, counted from the whole's first.
    TextileRegion crossings(Cell cell) const;
    MeshKey key(Cell cell, int level) const;
    /// Millimetres.
    QVector3D low() const;
    QVector3D high() const;
    QVector3D low(const TextileRegion& crossings) const;
    QVector3D high(const TextileRegion& crossings) const;
    QVector3D pitch() const; ///< x, y; z is the thickness
    /// A few repeats in the middle, for the first look.
    TextileRegion first_look() const;
};

/// Precondition: the fabric has no errors.
std::shared_ptr<const PreviewFabric> prepare_fabric(const PreviewRequest& request);

/// The crossings of a square swatch, whole repeats where possible.
TextileRegion swatch_region(const Fabric& fabric, double side_mm);

} // namespace hygroloom
