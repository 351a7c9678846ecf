// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/garment/garment_pane.h"

#include "ui/basics/elided_label.h"
#include "ui/garment/flat_view.h"
#include "ui/garment/shape_view.h"

#include <QGuiApplication>
#include <QPainter>
#include <QSplitter>
#include <QVBoxLayout>

namespace hygroloom {

GarmentPane::GarmentPane(QWidget* parent)
    : QWidget(parent), caption_(new ElidedLabel), sides_(new QSplitter(Qt::Horizontal)), flat_(new FlatView)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    caption_->setMargin(4);
    layout->addWidget(caption_);
    layout->addWidget(sides_, 1);
    sides_->setChildrenCollapsible(false);
    // A QOpenGLWidget on the offscreen platform brings Qt 6.4 down.
    if (QGuiApplication::platformName() != "offscreen" && QGuiApplication::platformName() != "minimal") {
        shape_ = new ShapeView;
        sides_->addWidget(shape_);
        connect(shape_, &ShapeView::hovered, this, &GarmentPane::hovered);
        connect(shape_, &ShapeView::clicked, this, &GarmentPane::clicked);
    }
    sides_->addWidget(flat_);
    connect(flat_, &FlatView::hovered, this, &GarmentPane::hovered);
    connect(flat_, &FlatView::clicked, this, &GarmentPane::clicked);
    const auto drop = [this](int panel, const QString& fabric) {
        Q_EMIT fabricDropped(QString::fromStdString(drawing_->panels[static_cast<std::size_t>(panel)].name), fabric);
    };
    connect(flat_, &FlatView::fabricDropped, this, drop);
    if (shape_) { connect(shape_, &ShapeView::fabricDropped, this, drop); }
}

void GarmentPane::setEditable(bool editable)
{
    flat_->setEditable(editable);
    if (shape_) { shape_->setEditable(editable); }
}

void GarmentPane::setCaption(const QString& text) { caption_->setFullText(text); }

void GarmentPane::show(const std::shared_ptr<const GarmentDrawing>& drawing, const std::shared_ptr<const GarmentPaint>& paint)
{
    drawing_ = drawing;
    flat_->setDrawing(drawing);
    flat_->setPaint(paint);
    if (shape_) {
        shape_->setDrawing(drawing);
        shape_->setPaint(paint);
    }
}

void GarmentPane::setSides(Sides sides)
{
    if (!shape_) { return; }
    shape_->setVisible(sides != Sides::flat);
    flat_->setVisible(sides != Sides::shape);
    if (sides == Sides::both) { sides_->setSizes({1000, 1000}); } // halves
}

void GarmentPane::setStacked(bool stacked) { sides_->setOrientation(stacked ? Qt::Vertical : Qt::Horizontal); }

void GarmentPane::setPin(const GarmentSpot& spot)
{
    flat_->setPin(spot);
    if (shape_) { shape_->setPin(spot); }
}

QImage GarmentPane::picture()
{
    const double ratio = devicePixelRatioF();
    QImage image(size() * ratio, QImage::Format_RGB32);
    image.setDevicePixelRatio(ratio);
    render(&image);
    QPainter painter(&image);
    if (shape_ && shape_->isVisible()) { // not in what render() gives
        painter.drawImage(QRect(shape_->mapTo(this, QPoint(0, 0)), shape_->size()), shape_->picture());
    }
    return image;
}

} // namespace hygroloom
