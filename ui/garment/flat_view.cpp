// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/garment/flat_view.h"

#include "ui/basics/appearance.h"
#include "ui/basics/color_map.h"
#include "ui/basics/preferences.h"
#include "ui/garment/panel_drop.h"
#include "ui/picture/pointer.h"

#include <QApplication>
#include <QFontInfo>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

constexpr double label_room = 0.95;                       // of a panel's width
constexpr double margin = 28;                             // pixels; the scale bar stands below
constexpr double least_scale = 20, largest_scale = 40000; // pixels per m

/// An arrow along the warp, about a place.
void drawGrain(QPainter& painter, const QPointF& middle, double half, double grain)
{
    const QPointF along(-std::sin(grain), -std::cos(grain));
    const QPointF tip = middle + half * along;
    painter.setPen(QPen(QColor("#c41e3a"), 1.6));
    painter.drawLine(middle - half * along, tip);
    for (const double side : {-0.5, 0.5}) { painter.drawLine(tip, tip + 8 * QPointF(std::sin(grain + side), std::cos(grain + side))); }
}

/// The place on the outlines of the panels that is nearest to a place of the sheet.
QPointF nearestOutline(const GarmentDrawing& drawing, const QPointF& place)
{
    QPointF found;
    double least = -1;
    for (const DrawnPanel& panel : drawing.panels) {
        const QPointF shift(panel.on_sheet[0], panel.on_sheet[1]);
        for (std::size_t k = 0; k < panel.outline.size(); ++k) {
            const FlatPlace &a = panel.outline[k], &b = panel.outline[(k + 1) % panel.outline.size()];
            const QPointF from = QPointF(a[0], a[1]) + shift, along(b[0] - a[0], b[1] - a[1]);
            const double length = QPointF::dotProduct(along, along);
            const double share = length > 0 ? std::clamp(QPointF::dotProduct(place - from, along) / length, 0.0, 1.0) : 0;
            const QPointF at = from + share * along;
            const double far = std::hypot(place.x() - at.x(), place.y() - at.y());
            if (least < 0 || far < least) {
                least = far;
                found = at;
            }
        }
    }
    return found;
}

} // namespace

FlatView::FlatView(QWidget* parent)
    : QWidget(parent), drop_(new PanelDrop(this, [this](const QPointF& pixel) { return spotAt(pixel).panel; }))
{
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(60, 60);
    setAccessibleName(tr("Flat panels of the garment"));
    setAccessibleDescription(tr("Drag to move, wheel to zoom, click to pin a place. Plus and minus zoom, Home shows all panels."));
    connect(drop_, &PanelDrop::dropped, this, &FlatView::fabricDropped);
}

void FlatView::setDrawing(std::shared_ptr<const GarmentDrawing> drawing)
{
    if (drawing == drawing_) { return; }
    const auto is_same = [](const DrawnPanel& a, const DrawnPanel& b) { return a.name == b.name; };
    const bool same =
        drawing && drawing_ && drawing->sheet == drawing_->sheet && std::ranges::equal(drawing->panels, drawing_->panels, is_same);
    drawing_ = std::move(drawing);
    if (!same) {
        scale_ = 0;
        setOutlining(false); // its panel may be another now
    }
    update();
}

void FlatView::setPaint(std::shared_ptr<const GarmentPaint> paint)
{
    paint_ = std::move(paint);
    update();
}

void FlatView::setChosenPanel(int panel)
{
    chosen_ = panel;
    update();
}

void FlatView::setPin(const GarmentSpot& spot)
{
    pin_ = spot;
    update();
}

void FlatView::setZones(std::vector<ZoneOnPanel> zones)
{
    zones_ = std::move(zones);
    update();
}

void FlatView::setOutlining(bool outlining)
{
    if (outlining == pen_.isDown()) { return; }
    pen_.setDown(outlining);
    setCursor(outlining ? Qt::CrossCursor : Qt::ArrowCursor);
    if (outlining) { setFocus(); }
    update();
    if (!outlining) { Q_EMIT outliningEnded(); }
}

void FlatView::addCorner(const QPointF& pixel)
{
    constexpr double near = 8; // pixels
    bool on_first = false;
    if (!pen_.outline().empty()) { on_first = (pixelOf({pen_.panel(), pen_.outline().front()}) - pixel).manhattanLength() <= near; }
    if (pen_.click(spotAt(pixel), on_first)) { closeOutline(); }
    update();
}

void FlatView::closeOutline()
{
    if (!pen_.canClose()) { return; }
    const int panel = pen_.panel();
    const std::vector<FlatPlace> outline = pen_.outline();
    setOutlining(false);
    Q_EMIT zoneOutlined(panel, outline);
}

void FlatView::fit()
{
    scale_ = 0;
    update();
}

void FlatView::zoomBy(double factor) { zoomAt(factor, rect().center()); }

QTransform FlatView::toPixels() const
{
    QPointF middle = middle_;
    double scale = scale_;
    if (!(scale > 0)) {
        const QRectF sheet = drawing_ ? drawing_->sheet : QRectF(0, 0, 1, 1);
        scale = std::min((width() - 2 * margin) / std::max(1e-3, sheet.width()), (height() - 3 * margin) / std::max(1e-3, sheet.height()));
        scale = std::clamp(scale, least_scale, largest_scale);
        middle = sheet.center() - QPointF(0, 0.5 * margin / scale);
    }
    QTransform view;
    view.translate(0.5 * width(), 0.5 * height());
    view.scale(scale, -scale);
    view.translate(-middle.x(), -middle.y());
    return view;
}

/// Beside the panels at the nearest outline, which comes into the picture, so that zooming ends on no empty sheet.
void FlatView::zoomAt(double factor, const QPointF& pixel)
{
    const QTransform before = toPixels();
    QPointF place = before.inverted().map(pixel), stays = pixel;
    if (drawing_ && !drawing_->panels.empty() && drawing_->panelAt(place) < 0) {
        place = nearestOutline(*drawing_, place);
        const QPointF at = before.map(place);
        stays = {std::clamp(at.x(), 0.05 * width(), 0.95 * width()), std::clamp(at.y(), 0.05 * height(), 0.95 * height())};
    }
    scale_ = std::clamp(before.m11() * factor, least_scale, largest_scale);
    const QPointF aside = stays - QPointF(0.5 * width(), 0.5 * height());
    middle_ = place - QPointF(aside.x(), -aside.y()) / scale_;
    update();
}

GarmentSpot FlatView::spotAt(const QPointF& pixel) const
{
    if (!drawing_) { return {}; }
    const QPointF sheet = toPixels().inverted().map(pixel);
    const int panel = drawing_->panelAt(sheet);
    if (panel < 0) { return {}; }
    const FlatPlace& offset = drawing_->panels[static_cast<std::size_t>(panel)].on_sheet;
    return {panel, {sheet.x() - offset[0], sheet.y() - offset[1]}};
}

QPointF FlatView::pixelOf(const GarmentSpot& spot) const
{
    const FlatPlace& offset = drawing_->panels[static_cast<std::size_t>(spot.panel)].on_sheet;
    return toPixels().map(QPointF(spot.flat[0] + offset[0], spot.flat[1] + offset[1]));
}

QImage FlatView::picture()
{
    QImage image(size() * devicePixelRatioF(), QImage::Format_RGB32);
    image.setDevicePixelRatio(devicePixelRatioF());
    render(&image);
    return image;
}

void FlatView::paintPanel(QPainter& painter, std::size_t panel, const QTransform& view) const
{
    const DrawnPanel& drawn = drawing_->panels[panel];
    const QPainterPath path = view.map(drawn.path);
    painter.fillPath(path, isDark(palette()) ? QColor("#3a3f44") : QColor("#f7f7f7"));
    if (paint_ && panel < paint_->fills.size() && !paint_->fills[panel].image.isNull()) {
        const PanelFill& fill = paint_->fills[panel];
        const QTransform onSheet(fill.across[0], fill.across[1], fill.along[0], fill.along[1],
                                 fill.origin[0] - 0.5 * (fill.across[0] + fill.along[0]) + drawn.on_sheet[0],
                                 fill.origin[1] - 0.5 * (fill.across[1] + fill.along[1]) + drawn.on_sheet[1]);
        painter.save();
        painter.setClipPath(path);
        painter.setTransform(onSheet * view);
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.drawImage(QPointF(0, 0), fill.image);
        painter.restore();
    }
    const bool marked = static_cast<int>(panel) == drop_->target() || static_cast<int>(panel) == chosen_;
    painter.setPen(QPen(marked ? palette().color(QPalette::Highlight) : palette().color(QPalette::WindowText), marked ? 2.5 : 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(path);
}

void FlatView::paintLabel(QPainter& painter, std::size_t panel, const QTransform& view) const
{
    const QRectF box = view.mapRect(drawing_->panels[panel].path.boundingRect());
    if (!paint_ || panel >= paint_->labels.size() || box.width() < 24 || box.height() < 24) { return; }
    const PanelLabel& label = paint_->labels[panel];
    drawGrain(painter, box.center() + QPointF(0, 0.12 * box.height()), std::min(40.0, 0.2 * std::min(box.width(), box.height())),
              label.grain);
    const QFontMetricsF metrics(painter.font());
    if (box.width() < 6 * metrics.height()) { return; } // names would hide the panel; the line below the pictures says them
    const QFont usual = painter.font();
    const auto fontFor = [&](const QString& text) { // in smaller letters where the panel is narrow
        constexpr double least = 0.75;              // of the size
        QFont font = usual;
        const double wide = metrics.horizontalAdvance(text), room = label_room * box.width();
        if (wide > room) { font.setPointSizeF(std::max(least, room / wide) * QFontInfo(font).pointSizeF()); }
        return font;
    };
    const bool low = box.height() < 7 * metrics.height();
    double y = low ? box.top() + 4 : box.center().y() - 0.22 * box.height();
    for (const QString& text : {label.name, low ? QString() : label.fabric}) {
        painter.setFont(fontFor(text));
        const QFontMetricsF own(painter.font());
        const QString shown = own.elidedText(text, Qt::ElideMiddle, label_room * box.width());
        const QRectF behind(box.center().x() - 0.5 * own.horizontalAdvance(shown) - 2, y, own.horizontalAdvance(shown) + 4,
                            metrics.height());
        if (shown.isEmpty()) { continue; }
        painter.fillRect(behind, QColor(255, 255, 255, 215)); // ink on paper in every look: fabrics and water are drawn on white
        painter.setPen(QColor("#1c2024"));
        painter.drawText(behind, Qt::AlignCenter, shown);
        y += metrics.height();
    }
    painter.setFont(usual);
}

void FlatView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), isDark(palette()) ? QColor("#191c1f") : QColor("#e9ecee"));
    if (!drawing_) { return; }
    painter.setRenderHint(QPainter::Antialiasing);
    const QTransform view = toPixels();
    for (std::size_t k = 0; k < drawing_->panels.size(); ++k) { paintPanel(painter, k, view); }
    for (std::size_t k = 0; k < drawing_->panels.size(); ++k) { paintLabel(painter, k, view); }
    paintZones(painter, zones_, *drawing_, view, palette());
    pen_.paint(painter, *drawing_, view, pointer_);
    if (pin_.panel >= 0 && pin_.panel < static_cast<int>(drawing_->panels.size())) {
        const QPointF at = pixelOf(pin_);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(Qt::white, 4));
        painter.drawEllipse(at, 6, 6);
        painter.setPen(QPen(QColor("#c41e3a"), 2));
        painter.drawEllipse(at, 6, 6);
    }
    painter.setFont(font());
    drawScaleBar(painter, QPointF(14, height() - 12), 1000 / view.m11(), width(), palette().color(QPalette::WindowText),
                 palette().color(QPalette::Window));
}

void FlatView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    update();
}

void FlatView::mousePressEvent(QMouseEvent* event)
{
    pressed_ = dragged_ = event->position();
    moving_ = false;
}

void FlatView::mouseMoveEvent(QMouseEvent* event)
{
    pointer_ = event->position();
    if (!(event->buttons() & (Qt::LeftButton | Qt::MiddleButton))) {
        if (pen_.isDown()) { update(); }
        Q_EMIT hovered(spotAt(event->position()));
        return;
    }
    moving_ = moving_ || (event->position() - pressed_).manhattanLength() >= QApplication::startDragDistance();
    if (!moving_) { return; }
    const QTransform view = toPixels();
    const QPointF step = event->position() - dragged_;
    middle_ = view.inverted().map(QPointF(0.5 * width(), 0.5 * height()) - step);
    scale_ = view.m11();
    dragged_ = event->position();
    update();
}

void FlatView::mouseReleaseEvent(QMouseEvent* event)
{
    if (!moving_ && event->button() == Qt::LeftButton) {
        if (pen_.isDown()) {
            addCorner(event->position());
        } else {
            Q_EMIT clicked(spotAt(event->position()));
        }
    }
    moving_ = false;
}

void FlatView::mouseDoubleClickEvent(QMouseEvent* event)
{
    mousePressEvent(event);
    if (!pen_.isDown()) { return; }
    closeOutline();
    moving_ = true; // its release is no click
}

void FlatView::keyPressEvent(QKeyEvent* event)
{
    if (!pen_.isDown()) {
        QWidget::keyPressEvent(event);
        return;
    }
    switch (event->key()) {
    case Qt::Key_Escape: setOutlining(false); break;
    case Qt::Key_Return:
    case Qt::Key_Enter: closeOutline(); break;
    case Qt::Key_Backspace:
        pen_.back();
        update();
        break;
    default: QWidget::keyPressEvent(event);
    }
}

void FlatView::leaveEvent(QEvent* event)
{
    QWidget::leaveEvent(event);
    Q_EMIT hovered({});
}

void FlatView::wheelEvent(QWheelEvent* event) { zoomAt(wheelZoom(event->angleDelta().y()), zoomedAt(event->position(), QSizeF(size()))); }

} // namespace hygroloom
