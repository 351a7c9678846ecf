// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/textile_canvas.h"

#include "ui/appearance.h"
#include "ui/quantity.h"

#include <QElapsedTimer>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

constexpr int still_after_ms = 160;
constexpr double slow_picture = 0.12;      // s: then the coarse mesh is drawn while moving
constexpr double too_slow_for_samples = 0.25; // s, without multisampling

} // namespace

TextileCanvas::TextileCanvas(QWidget* parent)
    : QOpenGLWidget(parent)
{
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Picture of the woven fabric"));
    setAccessibleDescription(tr("Drag to turn, middle button or Shift and drag to move, wheel to zoom. F fits, 1, 3 and 7 look from the front, "
                                "the right and the top."));
    still_.setSingleShot(true);
    still_.setInterval(still_after_ms);
    connect(&still_, &QTimer::timeout, this, [this] { redraw(false); });
}

TextileCanvas::~TextileCanvas()
{
    makeCurrent();
    sampled_.reset();
    scene_.reset();
    renderer_.release();
    doneCurrent();
}

void TextileCanvas::setMesh(std::shared_ptr<const PreviewMesh> mesh)
{
    mesh_ = std::move(mesh);
    if (usable_) {
        // At once: the coarse and the fine mesh may both come before the next picture.
        makeCurrent();
        renderer_.setMesh(mesh_);
        doneCurrent();
    } else {
        mesh_changed_ = true;
    }
    water_changed_ = true;
    if (mesh_ && !(fitted_ && moved_by_hand_) && width() > 1) {
        fit();
    }
    redraw(false);
}

void TextileCanvas::setWater(std::vector<float> values, double maximum)
{
    water_ = std::move(values);
    water_maximum_ = maximum;
    water_changed_ = true;
    redraw(moving_);
}

void TextileCanvas::setLiquid(LiquidSurface surface)
{
    liquid_ = std::move(surface);
    liquid_changed_ = true;
    redraw(moving_);
}

void TextileCanvas::setCaption(const PictureCaption& caption)
{
    caption_ = caption;
    update();
}

void TextileCanvas::setWaterColors(WaterColors colors)
{
    water_colors_ = colors;
    redraw(false);
}

void TextileCanvas::setHighlight(int end, int pick)
{
    if (const QPoint highlight(end, pick); highlight != highlight_) {
        highlight_ = highlight;
        update();
    }
}

void TextileCanvas::fit()
{
    if (mesh_) {
        camera_.fit(mesh_->low(), mesh_->high(), QSizeF(width(), height()));
        fitted_ = true;
        moved_by_hand_ = false;
        redraw(false);
    } else {
        fitted_ = false;
    }
}

void TextileCanvas::lookFrom(double turn, double lift)
{
    camera_.lookFrom(turn, lift);
    fit();
}

QImage TextileCanvas::picture()
{
    redraw(false);
    return grabFramebuffer();
}

void TextileCanvas::initializeGL()
{
    usable_ = renderer_.initialize();
    if (!usable_) {
        Q_EMIT failed(renderer_.problem());
    }
    scene_changed_ = true;
    water_changed_ = true;
    liquid_changed_ = true;
    mesh_changed_ = true;
}

void TextileCanvas::resizeGL(int, int)
{
    scene_changed_ = true;
    if (!moved_by_hand_) {
        fit();
    }
}

PictureColors TextileCanvas::colors() const
{
    PictureColors colors;
    const bool dark = isDark(palette());
    colors.background = dark ? QColor("#191c1f") : QColor("#e9ecee");
    colors.warp = QColor("#f0e8d8");
    colors.weft = QColor("#e2d5bb");
    colors.water = water_colors_;
    return colors;
}

void TextileCanvas::redraw(bool moving)
{
    moving_ = moving;
    scene_changed_ = true;
    if (moving) {
        still_.start();
    } else {
        still_.stop();
    }
    update();
}

void TextileCanvas::drawScene()
{
    if (std::exchange(mesh_changed_, false)) {
        renderer_.setMesh(mesh_);
    }
    if (std::exchange(water_changed_, false)) {
        renderer_.setWater(mesh_ ? mesh_->patchValues(water_) : std::vector<float>(), water_maximum_);
    }
    if (std::exchange(liquid_changed_, false)) {
        renderer_.setLiquid(liquid_);
    }
    const QSize pixels = size() * devicePixelRatioF();
    const bool samples = !moving_ && still_seconds_ < too_slow_for_samples;
    if (!scene_ || scene_->size() != pixels) {
        scene_ = std::make_unique<QOpenGLFramebufferObject>(pixels, QOpenGLFramebufferObject::Depth);
        sampled_.reset();
    }
    if (samples && !sampled_) {
        QOpenGLFramebufferObjectFormat format;
        format.setAttachment(QOpenGLFramebufferObject::Depth);
        format.setSamples(4);
        sampled_ = std::make_unique<QOpenGLFramebufferObject>(pixels, format);
    }
    QOpenGLFramebufferObject& target = samples ? *sampled_ : *scene_;
    target.bind();
    QElapsedTimer timer;
    timer.start();
    renderer_.draw(camera_, pixels, QSizeF(size()), colors(), moving_ && still_seconds_ > slow_picture);
    if (!moving_) {
        context()->functions()->glFinish();
        still_seconds_ = 1e-3 * static_cast<double>(timer.elapsed()) / (samples ? 2.5 : 1);
    }
    target.release();
    if (samples) {
        QOpenGLFramebufferObject::blitFramebuffer(scene_.get(), sampled_.get());
    }
    scene_changed_ = false;
}

void TextileCanvas::paintGL()
{
    if (usable_) {
        if (scene_changed_) {
            drawScene();
        }
        // nullptr is the context's own default; this widget has one of its own.
        auto* extra = context()->extraFunctions();
        extra->glBindFramebuffer(GL_READ_FRAMEBUFFER, scene_->handle());
        extra->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
        const int w = scene_->width(), h = scene_->height();
        extra->glBlitFramebuffer(0, 0, w, h, 0, 0, w, h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        extra->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
    }
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    drawOverlay(painter);
}

void TextileCanvas::mousePressEvent(QMouseEvent* event)
{
    drag_ = event->button();
    dragged_from_ = event->position();
    panning_ = event->button() == Qt::MiddleButton || event->button() == Qt::RightButton
        || (event->button() == Qt::LeftButton && event->modifiers() & Qt::ShiftModifier);
}

void TextileCanvas::mouseMoveEvent(QMouseEvent* event)
{
    if (drag_ == Qt::NoButton) {
        hover(event->position());
        return;
    }
    const QPointF pixels = event->position() - dragged_from_;
    dragged_from_ = event->position();
    moved_by_hand_ = true;
    if (panning_) {
        camera_.pan(pixels, QSizeF(size()));
    } else {
        camera_.orbit(pixels);
    }
    redraw(true);
}

void TextileCanvas::mouseReleaseEvent(QMouseEvent*)
{
    drag_ = Qt::NoButton;
    if (moving_) {
        redraw(false);
    }
}

void TextileCanvas::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (const auto point = pointUnder(event->position())) {
        camera_.centreOn(*point);
        moved_by_hand_ = true;
        redraw(false);
    }
}

void TextileCanvas::wheelEvent(QWheelEvent* event)
{
    moved_by_hand_ = true;
    camera_.zoom(std::pow(1.0015, event->angleDelta().y()), event->position(), QSizeF(size()));
    redraw(true);
}

void TextileCanvas::leaveEvent(QEvent*)
{
    hover(QPointF(-1, -1));
}

void TextileCanvas::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange) {
        redraw(false);
    }
    QOpenGLWidget::changeEvent(event);
}

std::optional<QVector3D> TextileCanvas::pointUnder(const QPointF& at) const
{
    if (!mesh_ || !rect().contains(at.toPoint())) {
        return std::nullopt;
    }
    const Ray ray = camera_.ray(at, QSizeF(size()));
    const float surface = 0.5F * (ray.from.z() >= 0 ? mesh_->high().z() : mesh_->low().z());
    if (std::abs(ray.direction.z()) < 1e-3F) {
        return std::nullopt;
    }
    const float along = (surface - ray.from.z()) / ray.direction.z();
    const QVector3D point = ray.from + along * ray.direction;
    const QVector3D low = mesh_->low(), high = mesh_->high();
    if (along < 0 || point.x() < low.x() || point.x() > high.x() || point.y() < low.y() || point.y() > high.y()) {
        return std::nullopt;
    }
    return point;
}

void TextileCanvas::hover(const QPointF& at)
{
    pointer_ = at;
    QPoint found(-1, -1);
    if (const auto point = pointUnder(at)) {
        const QVector3D low = mesh_->low();
        const TextileRegion& request = mesh_->request.patch;
        const TextileRegion& whole = mesh_->request.whole;
        const int end = static_cast<int>((point->x() - low.x()) / (1000 * mesh_->textile.warp.pitch));
        const int pick = static_cast<int>((point->y() - low.y()) / (1000 * mesh_->textile.weft.pitch));
        found = {std::clamp(end, 0, mesh_->textile.ends() - 1) + request.first_end - whole.first_end,
                 std::clamp(pick, 0, mesh_->textile.picks() - 1) + request.first_pick - whole.first_pick};
    }
    if (found != hovered_) {
        hovered_ = found;
        Q_EMIT crossingHovered(found.x(), found.y());
    }
    update();
}

} // namespace hygroloom
