// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// One picture of a garment with its caption: in 3D, flat, or both.
#pragma once

#include "ui/garment/garment_drawing.h"
#include "ui/picture/camera.h"

#include <QWidget>

class QSplitter;

namespace hygroloom {

class ElidedLabel;
class FlatView;
class ShapeView;

class GarmentPane : public QWidget {
    Q_OBJECT
public:
    enum class Sides { both, shape, flat };

    explicit GarmentPane(QWidget* parent = nullptr);

    void setCaption(const QString& text);
    ElidedLabel& caption() { return *caption_; }
    void show(const std::shared_ptr<const GarmentDrawing>& drawing, const std::shared_ptr<const GarmentPaint>& paint);
    const std::shared_ptr<const GarmentDrawing>& drawing() const { return drawing_; }
    void setSides(Sides sides);
    /// 3D over flat, in a narrow pane.
    void setStacked(bool stacked);
    /// Whether fabrics may be dropped on its panels.
    void setEditable(bool editable);
    void setPin(const GarmentSpot& spot);
    FlatView& flat() { return *flat_; }
    /// nullptr: this display has no OpenGL.
    ShapeView* shape() { return shape_; }
    QImage picture();

Q_SIGNALS:
    void hovered(const GarmentSpot& spot);
    void clicked(const GarmentSpot& spot);
    void fabricDropped(const QString& panel, const QString& fabric);

private:
    std::shared_ptr<const GarmentDrawing> drawing_;
    ElidedLabel* caption_;
    QSplitter* sides_;
    FlatView* flat_;
    ShapeView* shape_ = nullptr;
};

} // namespace hygroloom
