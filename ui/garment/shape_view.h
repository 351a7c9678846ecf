// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The garment in space. Dragging turns it, middle button or Shift and dragging move it, the wheel zooms, a click pins a place,
// a fabric can be dropped on a panel.
#pragma once

#include "ui/garment/garment_drawing.h"
#include "ui/picture/camera.h"

#include <QOpenGLBuffer>
#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>
#include <QOpenGLWidget>

namespace hygroloom {

class PanelDrop;

class ShapeView : public QOpenGLWidget {
    Q_OBJECT
public:
    explicit ShapeView(QWidget* parent = nullptr);
    ~ShapeView() override;

    void setDrawing(std::shared_ptr<const GarmentDrawing> drawing);
    void setPaint(std::shared_ptr<const GarmentPaint> paint);
    void setPin(const GarmentSpot& spot);
    const Camera& camera() const { return camera_; }
    void setCamera(const Camera& camera);
    void fit();
    /// 0: the front, 90: the wearer's left side, 180: the back.
    void lookFrom(double turn);
    void zoomBy(double factor);
    void zoomAt(double factor, const QPointF& at);
    /// Of the nearest cloth under a pixel.
    GarmentSpot spotAt(const QPointF& pixel) const;
    /// Whether fabrics may be dropped.
    void setEditable(bool editable) { setAcceptDrops(editable); }
    QImage picture() { return grabFramebuffer(); }
    /// Why nothing is drawn; empty otherwise.
    const QString& problem() const { return problem_; }

Q_SIGNALS:
    void hovered(const GarmentSpot& spot);
    void clicked(const GarmentSpot& spot);
    void fabricDropped(int panel, const QString& fabric);
    void cameraMoved(const Camera& camera);

protected:
    void initializeGL() override;
    void paintGL() override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void release();
    void loadShape();
    void loadPaint();
    void drawCloth();
    void drawPin();
    void moved();

    std::shared_ptr<const GarmentDrawing> drawing_;
    std::shared_ptr<const GarmentPaint> paint_;
    std::vector<QVector3D> places_; ///< mm, of the shape's places as the camera has them: z upwards
    Camera camera_;
    QVector3D low_, high_;
    bool fits_ = true; ///< until the user moves
    GarmentSpot pin_;

    QOpenGLFunctions_3_3_Core* gl_ = nullptr;
    QOpenGLShaderProgram program_;
    QOpenGLVertexArrayObject array_;
    QOpenGLBuffer vertices_{QOpenGLBuffer::VertexBuffer}, indices_{QOpenGLBuffer::IndexBuffer};
    struct Part {
        int first = 0, count = 0; ///< indices of its triangles
    };
    std::vector<Part> parts_;
    Part edges_;
    std::vector<unsigned> textures_;
    bool shape_changed_ = false, paint_changed_ = false;
    QString problem_;
    QPointF pressed_, dragged_;
    bool moving_ = false;
    PanelDrop* drop_;
};

} // namespace hygroloom
