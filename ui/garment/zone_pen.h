// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Zones of the wearer's own on the flat panels: how they are drawn, and the outline of a new one as it grows by clicks.
#pragma once

#include "ui/garment/garment_drawing.h"

#include <QTransform>

class QPainter;
class QPalette;

namespace hygroloom {

struct ZoneOnPanel {
    QString name;
    int panel = 0;
    std::vector<FlatPlace> outline; ///< m
};

/// Those of a garment's zones whose panels a drawing has.
std::vector<ZoneOnPanel> zonesOn(const Garment& garment, const GarmentDrawing& drawing);

/// view: from the sheet to pixels.
void paintZones(QPainter& painter, const std::vector<ZoneOnPanel>& zones, const GarmentDrawing& drawing, const QTransform& view,
                const QPalette& palette);

class ZonePen {
public:
    bool isDown() const { return down_; }
    void setDown(bool down);
    /// A corner at a spot; beside the first one's panel it does not count. on_first: the click closes the outline. Whether that is closed
    /// now.
    bool click(const GarmentSpot& spot, bool on_first);
    /// Takes the last corner back.
    void back();
    bool canClose() const { return outline_.size() >= 3; }
    int panel() const { return panel_; } ///< -1: none yet
    const std::vector<FlatPlace>& outline() const { return outline_; }
    /// With a line to the pointer.
    void paint(QPainter& painter, const GarmentDrawing& drawing, const QTransform& view, const QPointF& pointer) const;

private:
    bool down_ = false;
    int panel_ = -1;
    std::vector<FlatPlace> outline_;
};

} // namespace hygroloom
