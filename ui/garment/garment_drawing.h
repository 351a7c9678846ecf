// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A garment as the views draw it: its panels laid out on one sheet, and their shape in space.
#pragma once

#include "core/wear/wear_layout.h"

#include <QColor>
#include <QImage>
#include <QPainterPath>
#include <QPointF>
#include <QRectF>

#include <memory>

namespace hygroloom {

struct DrawnPanel {
    std::string name;
    std::vector<FlatPlace> outline; ///< m, counter-clockwise
    FlatPlace on_sheet{};           ///< m: where its flat (0, 0) lies on the sheet
    QPainterPath path;              ///< on the sheet, m, y upwards
};

struct GarmentDrawing {
    std::vector<DrawnPanel> panels;
    std::vector<std::array<int, 2>> sewn; ///< panels that seams join, each two once, the lesser first; of a pattern
    GarmentShape shape;
    QRectF sheet; ///< m, about all panels
    bool is_draped = false;
    std::vector<std::string> issues;

    /// The panel at a place of the sheet; -1: none.
    int panelAt(const QPointF& sheet_place) const;
};

std::shared_ptr<const GarmentDrawing> drawingOf(const GarmentPattern& pattern);
std::shared_ptr<const GarmentDrawing> drawingOf(const WearLayout& layout);

/// What lies on a panel: a picture whose pixel (x, y) has its middle at origin + x across + y along, m of the flat panel. Where it has no
/// colour, and beyond it, the panel is bare.
struct PanelFill {
    QImage image;
    FlatPlace origin{}, across{}, along{};
};

/// What is written on a panel.
struct PanelLabel {
    QString name, fabric;
    double grain = 0; ///< radian, of the warp from the pattern's +y, counter-clockwise
};

struct GarmentPaint {
    std::vector<PanelFill> fills;
    std::vector<PanelLabel> labels;
};

/// Pale colours that are told apart with every kind of colour vision; names stand beside them, and after eight they come again.
QColor fabricColor(int index);

/// The fabrics of a panel's layers in words.
QString clothsOf(const PanelCut& cut);

/// Panels in the colours of their fabrics; bare where a panel has none.
GarmentPaint fabricPaint(const Design& design, const Garment& garment, const GarmentDrawing& drawing);

/// A place of a panel under the pointer.
struct GarmentSpot {
    int panel = -1; ///< -1: none
    FlatPlace flat{};
    bool operator==(const GarmentSpot&) const = default;
};

} // namespace hygroloom
