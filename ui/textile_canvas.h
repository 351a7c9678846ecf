// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The OpenGL widget of the viewport: pointer, picture and overlay. Draws on demand only.
#pragma once

#include "ui/textile_renderer.h"

#include <QOpenGLFramebufferObject>
#include <QOpenGLWidget>
#include <QTimer>

namespace hygroloom {

/// What the overlay says; empty texts are left out.
struct PictureCaption {
    QString title;    ///< top left: what is shown
    QString notice;   ///< a state that must not be overlooked: "Results of an earlier design."
    QString legend;   ///< what the colours mean; empty: no legend
    QString unit;
    double legend_maximum = 1;
    double legend_scale = 1; ///< number shown per value stored
};

class TextileCanvas : public QOpenGLWidget {
    Q_OBJECT
public:
    explicit TextileCanvas(QWidget* parent = nullptr);
    ~TextileCanvas() override;

    void setMesh(std::shared_ptr<const PreviewMesh> mesh);
    const std::shared_ptr<const PreviewMesh>& mesh() const { return mesh_; }
    /// Values of the whole's segments.
    void setWater(std::vector<float> values, double maximum);
    void setLiquid(LiquidSurface surface);
    void setCaption(const PictureCaption& caption);
    void setWaterColors(WaterColors colors);
    /// Crossing of the repeat that is pointed at elsewhere; negative for none.
    void setHighlight(int end, int pick);

    void fit();
    void lookFrom(double turn, double lift);
    /// The picture with its overlay, so many times as large.
    QImage picture();

Q_SIGNALS:
    /// Numbered as the whole is, from its first crossing; negative when none is pointed at.
    void crossingHovered(int end, int pick);
    void failed(const QString& sentence);

protected:
    void initializeGL() override;
    void paintGL() override;
    void resizeGL(int width, int height) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    PictureColors colors() const;
    void redraw(bool moving);
    void drawScene();
    void drawOverlay(QPainter& painter);
    void drawAxes(QPainter& painter, const QColor& ink);
    void drawHover(QPainter& painter, const QColor& ink);
    void drawHighlight(QPainter& painter);
    void hover(const QPointF& at);
    std::optional<QVector3D> pointUnder(const QPointF& at) const;

    TextileRenderer renderer_;
    bool usable_ = false;
    Camera camera_;
    bool fitted_ = false;
    bool moved_by_hand_ = false; ///< since the last fit; until then new meshes are fitted
    std::shared_ptr<const PreviewMesh> mesh_;
    bool mesh_changed_ = false;
    std::vector<float> water_;
    double water_maximum_ = 1;
    bool water_changed_ = false;
    LiquidSurface liquid_;
    bool liquid_changed_ = false;
    PictureCaption caption_;
    WaterColors water_colors_ = WaterColors::blue;
    QPoint highlight_{-1, -1};
    QPoint hovered_{-1, -1};
    QPointF pointer_;
    QPointF dragged_from_;
    Qt::MouseButton drag_ = Qt::NoButton;
    bool panning_ = false;
    bool moving_ = false;
    bool scene_changed_ = true;
    double still_seconds_ = 0; ///< what the last still picture took
    QTimer still_;
    std::unique_ptr<QOpenGLFramebufferObject> sampled_;
    std::unique_ptr<QOpenGLFramebufferObject> scene_;
};

} // namespace hygroloom
