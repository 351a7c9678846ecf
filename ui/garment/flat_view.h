// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The flat panels on one sheet: colours, names, grain arrows, a scale bar. Wheel zooms, dragging moves, a fabric can be dropped on a panel,
// and zones are outlined by clicks.
#pragma once

#include "ui/garment/zone_pen.h"

#include <QTransform>
#include <QWidget>

namespace hygroloom {

class PanelDrop;

class FlatView : public QWidget {
    Q_OBJECT
public:
    explicit FlatView(QWidget* parent = nullptr);

    void setDrawing(std::shared_ptr<const GarmentDrawing> drawing);
    void setPaint(std::shared_ptr<const GarmentPaint> paint);
    void setChosenPanel(int panel);
    void setPin(const GarmentSpot& spot);
    /// Whether fabrics may be dropped.
    void setEditable(bool editable) { setAcceptDrops(editable); }
    /// Of the wearer's own; outlined over their panels.
    void setZones(std::vector<ZoneOnPanel> zones);
    /// While it outlines, clicks set the corners of a zone. The first corner, a double click or Enter closes it, Backspace takes the last
    /// corner back, Escape ends it.
    void setOutlining(bool outlining);
    bool outlining() const { return pen_.isDown(); }
    void fit();
    void zoomBy(double factor);
    GarmentSpot spotAt(const QPointF& pixel) const;
    /// Where a flat place of a panel is in the picture.
    QPointF pixelOf(const GarmentSpot& spot) const;
    QImage picture();

Q_SIGNALS:
    void hovered(const GarmentSpot& spot);
    void clicked(const GarmentSpot& spot);
    void fabricDropped(int panel, const QString& fabric);
    void zoneOutlined(int panel, const std::vector<FlatPlace>& outline);
    /// With a zone or without.
    void outliningEnded();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    QTransform toPixels() const;
    void addCorner(const QPointF& pixel);
    void closeOutline();
    void zoomAt(double factor, const QPointF& pixel);
    void paintPanel(QPainter& painter, std::size_t panel, const QTransform& view) const;
    void paintLabel(QPainter& painter, std::size_t panel, const QTransform& view) const;

    std::shared_ptr<const GarmentDrawing> drawing_;
    std::shared_ptr<const GarmentPaint> paint_;
    double scale_ = 0; ///< pixels per m; 0: fits
    QPointF middle_;   ///< m, of the sheet, in the middle of the widget
    QPointF pressed_, dragged_, pointer_;
    bool moving_ = false;
    int chosen_ = -1;
    PanelDrop* drop_;
    GarmentSpot pin_;
    std::vector<ZoneOnPanel> zones_;
    ZonePen pen_;
};

} // namespace hygroloom
