// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/garment/shape_view.h"

#include "ui/basics/preferences.h"
#include "ui/garment/panel_drop.h"
#include "ui/picture/drawing.h"
#include "ui/picture/pointer.h"

#include <QApplication>
#include <QMouseEvent>
#include <QOpenGLVersionFunctionsFactory>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <map>

namespace hygroloom {

namespace {

constexpr std::size_t most_hovered = 300'000; // triangles that are searched at each move of the pointer

struct Vertex {
    QVector3D place, normal;
    float flat[2];
};

/// From a garment's axes (y upwards, z forwards) to the camera's (z upwards, the wearer faces -y), mm.
QVector3D seen(const Vec3d& place)
{
    return {static_cast<float>(1e3 * place.x), static_cast<float>(-1e3 * place.z), static_cast<float>(1e3 * place.y)};
}

/// Sides of a panel's triangles that no other triangle of it has.
std::vector<unsigned> rims(const GarmentShape& shape)
{
    std::map<std::pair<int, int>, int> sides;
    for (const auto& corners : shape.triangles) {
        for (std::size_t k = 0; k < 3; ++k) { ++sides[std::minmax(corners[k], corners[(k + 1) % 3])]; }
    }
    std::vector<unsigned> lines;
    for (const auto& [side, count] : sides) {
        if (count == 1) {
            lines.push_back(static_cast<unsigned>(side.first));
            lines.push_back(static_cast<unsigned>(side.second));
        }
    }
    return lines;
}

} // namespace

ShapeView::ShapeView(QWidget* parent)
    : QOpenGLWidget(parent), drop_(new PanelDrop(this, [this](const QPointF& pixel) { return spotAt(pixel).panel; }))
{
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(60, 60);
    setAccessibleName(tr("The garment in 3D"));
    setAccessibleDescription(
        tr("Drag to turn, middle button or Shift and drag to move, wheel to zoom, click to pin a place. Home shows the "
           "whole garment, 1, 3 and 7 look from the front, the side and the back."));
    camera_.lookFrom(-20, 8);
    connect(drop_, &PanelDrop::dropped, this, &ShapeView::fabricDropped);
}

ShapeView::~ShapeView()
{
    makeCurrent();
    release();
    doneCurrent();
}

void ShapeView::release()
{
    if (gl_ && !textures_.empty()) { gl_->glDeleteTextures(static_cast<int>(textures_.size()), textures_.data()); }
    textures_.clear();
    vertices_.destroy();
    indices_.destroy();
    array_.destroy();
}

void ShapeView::setDrawing(std::shared_ptr<const GarmentDrawing> drawing)
{
    if (drawing == drawing_) { return; }
    const bool first = !drawing_;
    drawing_ = std::move(drawing);
    places_.clear();
    low_ = QVector3D(1e9F, 1e9F, 1e9F);
    high_ = -low_;
    if (drawing_) {
        for (const Vec3d& place : drawing_->shape.places) {
            places_.push_back(seen(place));
            for (int axis = 0; axis < 3; ++axis) {
                low_[axis] = std::min(low_[axis], places_.back()[axis]);
                high_[axis] = std::max(high_[axis], places_.back()[axis]);
            }
        }
        camera_.setReach((high_ - low_).length());
    }
    fits_ = fits_ || first;
    shape_changed_ = true;
    update();
}

void ShapeView::setPaint(std::shared_ptr<const GarmentPaint> paint)
{
    paint_ = std::move(paint);
    paint_changed_ = true;
    update();
}

void ShapeView::setPin(const GarmentSpot& spot)
{
    pin_ = spot;
    update();
}

void ShapeView::setCamera(const Camera& camera)
{
    fits_ = false;
    camera_ = camera;
    update();
}

void ShapeView::fit()
{
    fits_ = true;
    update();
    if (!places_.empty()) {
        camera_.fit(low_, high_, QSizeF(size()));
        Q_EMIT cameraMoved(camera_);
    }
}

void ShapeView::lookFrom(double turn)
{
    camera_.lookFrom(turn, 0);
    fit();
}

void ShapeView::zoomBy(double factor) { zoomAt(factor, QPointF(0.5 * width(), 0.5 * height())); }

/// Beside the cloth to the place of it that is nearest in the picture, so that zooming ends in no empty view.
void ShapeView::zoomAt(double factor, const QPointF& at)
{
    const QSizeF picture(size());
    const QVector3D* nearest = nullptr;
    if (spotAt(at).panel < 0) {
        double least = 0;
        for (const QVector3D& place : places_) {
            if (camera_.depth(place) <= 0) { continue; }
            const QPointF away = camera_.project(place, picture) - at;
            if (const double far = std::hypot(away.x(), away.y()); !nearest || far < least) {
                nearest = &place;
                least = far;
            }
        }
    }
    if (nearest) {
        camera_.zoomInSight(factor, *nearest, picture);
    } else {
        camera_.zoom(factor, at, picture);
    }
    moved();
}

void ShapeView::moved()
{
    fits_ = false;
    update();
    Q_EMIT cameraMoved(camera_);
}

GarmentSpot ShapeView::spotAt(const QPointF& pixel) const
{
    GarmentSpot found;
    if (!drawing_ || places_.empty()) { return found; }
    const Ray ray = camera_.ray(pixel, QSizeF(size()));
    float nearest = 1e30F;
    const GarmentShape& shape = drawing_->shape;
    for (std::size_t t = 0; t < shape.triangles.size(); ++t) {
        const auto& corners = shape.triangles[t];
        const QVector3D &a = places_[static_cast<std::size_t>(corners[0])], &b = places_[static_cast<std::size_t>(corners[1])],
                        &c = places_[static_cast<std::size_t>(corners[2])];
        const QVector3D ab = b - a, ac = c - a, p = QVector3D::crossProduct(ray.direction, ac);
        const float determinant = QVector3D::dotProduct(ab, p);
        if (std::abs(determinant) < 1e-12F) { continue; }
        const QVector3D from = ray.from - a, q = QVector3D::crossProduct(from, ab);
        const float u = QVector3D::dotProduct(from, p) / determinant, v = QVector3D::dotProduct(ray.direction, q) / determinant;
        const float along = QVector3D::dotProduct(ac, q) / determinant;
        if (u < 0 || v < 0 || u + v > 1 || along <= 0 || along >= nearest) { continue; }
        nearest = along;
        found.panel = shape.panel[t];
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const auto at = [&](int corner) { return shape.flat[static_cast<std::size_t>(corner)][axis]; };
            found.flat[axis] = (1 - static_cast<double>(u) - static_cast<double>(v)) * at(corners[0]) +
                               static_cast<double>(u) * at(corners[1]) + static_cast<double>(v) * at(corners[2]);
        }
    }
    return found;
}

void ShapeView::initializeGL()
{
    gl_ = QOpenGLVersionFunctionsFactory::get<QOpenGLFunctions_3_3_Core>(QOpenGLContext::currentContext());
    if (!gl_ || !gl_->initializeOpenGLFunctions()) {
        gl_ = nullptr;
        problem_ = tr("The picture needs OpenGL 3.3, which this display does not provide.");
        return;
    }
    release(); // of a context before
    program_.removeAllShaders();
    problem_ = loadShaders(program_, "garment");
    shape_changed_ = paint_changed_ = true;
}

void ShapeView::loadShape()
{
    shape_changed_ = false;
    parts_.clear();
    edges_ = {};
    if (!drawing_) { return; }
    const GarmentShape& shape = drawing_->shape;
    std::vector<Vertex> vertices(places_.size());
    for (std::size_t i = 0; i < places_.size(); ++i) {
        vertices[i].place = places_[i];
        vertices[i].flat[0] = static_cast<float>(shape.flat[i][0]);
        vertices[i].flat[1] = static_cast<float>(shape.flat[i][1]);
    }
    std::vector<std::vector<unsigned>> of_panel(drawing_->panels.size());
    for (std::size_t t = 0; t < shape.triangles.size(); ++t) {
        const auto& c = shape.triangles[t];
        const std::size_t corner[3] = {static_cast<std::size_t>(c[0]), static_cast<std::size_t>(c[1]), static_cast<std::size_t>(c[2])};
        const QVector3D normal = QVector3D::crossProduct(places_[corner[1]] - places_[corner[0]], places_[corner[2]] - places_[corner[0]]);
        for (const std::size_t k : corner) {
            vertices[k].normal += normal;
            of_panel[static_cast<std::size_t>(shape.panel[t])].push_back(static_cast<unsigned>(k));
        }
    }
    std::vector<unsigned> indices;
    for (const std::vector<unsigned>& part : of_panel) {
        parts_.push_back({static_cast<int>(indices.size()), static_cast<int>(part.size())});
        indices.insert(indices.end(), part.begin(), part.end());
    }
    const std::vector<unsigned> lines = rims(shape);
    edges_ = {static_cast<int>(indices.size()), static_cast<int>(lines.size())};
    indices.insert(indices.end(), lines.begin(), lines.end());
    if (!array_.isCreated()) {
        array_.create();
        vertices_.create();
        indices_.create();
    }
    const QOpenGLVertexArrayObject::Binder bound(&array_);
    vertices_.bind();
    vertices_.allocate(vertices.data(), static_cast<int>(vertices.size() * sizeof(Vertex)));
    indices_.bind();
    indices_.allocate(indices.data(), static_cast<int>(indices.size() * sizeof(unsigned)));
    const int widths[] = {3, 3, 2};
    for (unsigned k = 0; k < 3; ++k) {
        gl_->glEnableVertexAttribArray(k);
        gl_->glVertexAttribPointer(k, widths[k], GL_FLOAT, GL_FALSE, sizeof(Vertex), vertexOffset(k * sizeof(QVector3D)));
    }
}

void ShapeView::loadPaint()
{
    paint_changed_ = false;
    const std::size_t count = paint_ ? paint_->fills.size() : 0;
    while (textures_.size() < count) {
        unsigned made = 0;
        gl_->glGenTextures(1, &made);
        textures_.push_back(made);
    }
    for (std::size_t k = 0; k < count; ++k) {
        QImage image = paint_->fills[k].image.convertToFormat(QImage::Format_ARGB32);
        if (image.isNull()) { continue; }
        gl_->glBindTexture(GL_TEXTURE_2D, textures_[k]);
        for (const unsigned filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
            gl_->glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
        }
        for (const unsigned wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) { gl_->glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE); }
        gl_->glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width(), image.height(), 0, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV,
                          image.constBits());
    }
}

void ShapeView::drawCloth()
{
    program_.bind();
    program_.setUniformValue("view_projection", camera_.projection(QSizeF(size())) * camera_.view());
    program_.setUniformValue("eye", camera_.eye());
    program_.setUniformValue("bare", QVector3D(0.86F, 0.86F, 0.86F));
    program_.setUniformValue("picture", 0);
    const QColor marked = palette().color(QPalette::Highlight);
    const QVector4D mark(static_cast<float>(marked.redF()), static_cast<float>(marked.greenF()), static_cast<float>(marked.blueF()), 0.5F);
    const QOpenGLVertexArrayObject::Binder bound(&array_);
    gl_->glActiveTexture(GL_TEXTURE0);
    for (std::size_t k = 0; k < parts_.size(); ++k) {
        QVector3D to_u(0, 0, -1), to_v(0, 0, -1); // beyond every picture
        if (paint_ && k < paint_->fills.size() && !paint_->fills[k].image.isNull()) {
            const PanelFill& fill = paint_->fills[k];
            const auto onto = [&](const FlatPlace& step, int pixels) {
                const double square = (step[0] * step[0] + step[1] * step[1]) * pixels;
                const double from = (fill.origin[0] * step[0] + fill.origin[1] * step[1]) / square - 0.5 / pixels;
                return QVector3D(static_cast<float>(step[0] / square), static_cast<float>(step[1] / square), static_cast<float>(-from));
            };
            to_u = onto(fill.across, fill.image.width());
            to_v = onto(fill.along, fill.image.height());
            gl_->glBindTexture(GL_TEXTURE_2D, textures_[k]);
        }
        program_.setUniformValue("to_u", to_u);
        program_.setUniformValue("to_v", to_v);
        program_.setUniformValue("line", static_cast<int>(k) == drop_->target() ? mark : QVector4D()); // a dragged fabric would go there
        gl_->glDrawElements(GL_TRIANGLES, parts_[k].count, GL_UNSIGNED_INT,
                            vertexOffset(static_cast<std::size_t>(parts_[k].first) * sizeof(unsigned)));
    }
    program_.setUniformValue("line", QVector4D(0.33F, 0.36F, 0.4F, 1));
    gl_->glDrawElements(GL_LINES, edges_.count, GL_UNSIGNED_INT, vertexOffset(static_cast<std::size_t>(edges_.first) * sizeof(unsigned)));
    program_.release();
}

void ShapeView::paintGL()
{
    const QColor background = pictureColors(palette()).background;
    if (!gl_ || !problem_.isEmpty()) {
        QPainter painter(this);
        painter.fillRect(rect(), background);
        painter.setPen(palette().color(QPalette::WindowText));
        painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap, problem_);
        return;
    }
    if (shape_changed_) { loadShape(); }
    if (paint_changed_) { loadPaint(); }
    if (fits_ && !places_.empty()) { camera_.fit(low_, high_, QSizeF(size())); }
    gl_->glClearColor(static_cast<float>(background.redF()), static_cast<float>(background.greenF()),
                      static_cast<float>(background.blueF()), 1);
    gl_->glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl_->glEnable(GL_DEPTH_TEST);
    gl_->glEnable(GL_POLYGON_OFFSET_FILL); // rims stand out before their cloth
    gl_->glPolygonOffset(1, 1);
    if (!parts_.empty()) { drawCloth(); }
    gl_->glDisable(GL_POLYGON_OFFSET_FILL);
    gl_->glDisable(GL_DEPTH_TEST);
    drawPin();
}

void ShapeView::drawPin()
{
    if (!drawing_ || pin_.panel < 0 || places_.empty()) { return; }
    const GarmentShape& shape = drawing_->shape;
    double nearest = 1e30;
    std::size_t at = 0;
    for (std::size_t t = 0; t < shape.triangles.size(); ++t) {
        if (shape.panel[t] != pin_.panel) { continue; }
        for (const int corner : shape.triangles[t]) {
            const auto k = static_cast<std::size_t>(corner);
            const double far = std::hypot(shape.flat[k][0] - pin_.flat[0], shape.flat[k][1] - pin_.flat[1]);
            if (far < nearest) {
                nearest = far;
                at = k;
            }
        }
    }
    if (nearest > 1e29) { return; }
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF pixel = camera_.project(places_[at], QSizeF(size()));
    const GarmentSpot seen_there = spotAt(pixel);
    constexpr double close = 0.03; // m: what is seen there is the pinned place; else cloth hides it
    const bool hidden =
        seen_there.panel != pin_.panel || std::hypot(seen_there.flat[0] - pin_.flat[0], seen_there.flat[1] - pin_.flat[1]) > close;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(Qt::white, 4));
    painter.drawEllipse(pixel, 6, 6);
    painter.setPen(QPen(QColor("#c41e3a"), 2, hidden ? Qt::DotLine : Qt::SolidLine));
    painter.drawEllipse(pixel, 6, 6);
}

void ShapeView::resizeEvent(QResizeEvent* event)
{
    QOpenGLWidget::resizeEvent(event);
    update();
}

void ShapeView::mousePressEvent(QMouseEvent* event)
{
    pressed_ = dragged_ = event->position();
    moving_ = false;
}

void ShapeView::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons() == Qt::NoButton) {
        if (drawing_ && drawing_->shape.triangles.size() <= most_hovered) { Q_EMIT hovered(spotAt(event->position())); }
        return;
    }
    moving_ = moving_ || (event->position() - pressed_).manhattanLength() >= QApplication::startDragDistance();
    if (!moving_) { return; }
    const QPointF step = event->position() - dragged_;
    dragged_ = event->position();
    switch (dragOf(event->buttons(), event->modifiers())) {
    case PointerDrag::pan: camera_.pan(step, QSizeF(size())); break;
    case PointerDrag::orbit: camera_.orbit(step, 0.5F * (low_ + high_)); break;
    case PointerDrag::none: return;
    }
    moved();
}

void ShapeView::mouseReleaseEvent(QMouseEvent* event)
{
    if (!moving_ && event->button() == Qt::LeftButton) { Q_EMIT clicked(spotAt(event->position())); }
    moving_ = false;
}

void ShapeView::leaveEvent(QEvent* event)
{
    QOpenGLWidget::leaveEvent(event);
    Q_EMIT hovered({});
}

void ShapeView::wheelEvent(QWheelEvent* event) { zoomAt(wheelZoom(event->angleDelta().y()), zoomedAt(event->position(), QSizeF(size()))); }

} // namespace hygroloom
