// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/picture/textile_canvas.h"

#include "ui/basics/preferences.h"

#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QOpenGLFunctions>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace hygroloom {

namespace {

constexpr int still_after_ms = 160;
// While it moves a picture that takes longer is drawn with fewer pixels, and as coarse as one so small would be; at rest it is whole.
constexpr double moving_seconds = 0.035;                      // leaves the window its time in 1/15 s
constexpr double moving_shares[] = {1, 0.7, 0.5, 0.35, 0.25}; // of width and height
constexpr int coarsest = static_cast<int>(std::size(moving_shares)) - 1;
constexpr int samples_at_rest = 16;
constexpr int fewest_samples = 4; // before these are there, the first picture stays
constexpr double sampling_seconds = 4;
constexpr int rest_before_samples_ms = 150;   // so that a run's frames, one after the other, are not sampled
constexpr double too_slow_for_samples = 0.25; // s, without multisampling
constexpr double quick_seconds = 0.015;       // a film's picture that takes longer has no multisampling

} // namespace

TextileCanvas::TextileCanvas(QWidget* parent) : QOpenGLWidget(parent)
{
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Picture of the woven fabric"));
    setAccessibleDescription(
        tr("Drag to turn, middle button or Shift and drag to move, wheel to zoom, click to choose a yarn. Arrow keys turn, plus "
           "and minus zoom, square brackets go from yarn to yarn. F shows the whole fabric, 1, 3 and 7 look from the front, "
           "the right and the top."));
    still_.setSingleShot(true);
    still_.setInterval(still_after_ms);
    connect(&still_, &QTimer::timeout, this, [this] { redraw(false); });
    more_.setSingleShot(true);
    connect(&more_, &QTimer::timeout, this, [this] {
        sample_due_ = true;
        update();
    });
    refine_at_rest_ = preferences().refine_at_rest;
    connect(&PreferenceNews::instance(), &PreferenceNews::changed, this, [this] {
        const int before = std::exchange(refine_at_rest_, preferences().refine_at_rest);
        if (before != refine_at_rest_) { changed(); }
    });
    fade_.setSingleShot(true);
    fade_.setInterval(15);
    connect(&fade_, &QTimer::timeout, this, [this] {
        scene_changed_ = true;
        update();
    });
}

TextileCanvas::~TextileCanvas()
{
    makeCurrent();
    sampled_.reset();
    light_.reset();
    coarse_picture_.reset();
    scene_picture_.reset();
    samples_.release();
    renderer_.release();
    doneCurrent();
}

void TextileCanvas::setView(std::shared_ptr<const PreparedView> view)
{
    if (!view) {
        waiting_.reset();
        scene_.setFabric(nullptr);
        hovered_ = {-1, -1};
        selected_ = {};
        redraw(false);
        return;
    }
    waiting_ = std::move(view);
    if (usable_) {
        makeCurrent();
        takeView();
        doneCurrent();
    } else {
        scene_.setFabric(waiting_->fabric);
    }
    changed();
}

/// Needs the context.
void TextileCanvas::takeView()
{
    const auto view = std::exchange(waiting_, nullptr);
    scene_.setFabric(view->fabric);
    renderer_.setFabric(view->fabric);
    for (const CellMesh& mesh : view->meshes) { renderer_.addMesh(mesh); }
    if (view->picture) { renderer_.setPicture(*view->picture); }
    water_changed_ = true;
    const int yarns = selected_.kind == YarnKind::warp ? fabric()->textile.ends() : fabric()->textile.picks();
    if (selected_.yarn >= yarns) { select({}); }
    camera_ = framed(camera_, *fabric(), moved_by_hand_ ? Framing::as_it_is : framing_, QSizeF(size()));
}

void TextileCanvas::addMeshes(const PreparedView& view)
{
    if (!usable_ || view.fabric != fabric()) { return; }
    makeCurrent();
    for (const CellMesh& mesh : view.meshes) { renderer_.addMesh(mesh); }
    if (view.picture) { renderer_.setPicture(*view.picture); }
    doneCurrent();
    scene_changed_ = true;
    update();
}

SceneView TextileCanvas::sceneView() const
{
    SceneView view;
    view.camera = camera_;
    view.size = QSizeF(size());
    view.detail = devicePixelRatioF() * (moving_ ? moving_shares[moving_step_] : 1.0);
    if (moving_ && moving_step_ > 0) { view.finest = fibre_level - 1; }
    view.cut = cut();
    return view;
}

void TextileCanvas::setWater(std::vector<float> values, double maximum)
{
    if (values.empty() && water_.empty()) { return; }
    water_ = std::move(values);
    water_maximum_ = maximum;
    water_changed_ = true;
    changed();
}

void TextileCanvas::setLiquid(LiquidSurface surface)
{
    if (surface.indices.empty() && liquid_.indices.empty()) { return; }
    liquid_ = std::move(surface);
    liquid_changed_ = true;
    changed();
}

void TextileCanvas::setParticlesShown(bool shown)
{
    particles_shown_ = shown;
    changed();
}

void TextileCanvas::setShadowShown(bool shown)
{
    shadow_shown_ = shown;
    changed();
}

void TextileCanvas::setCaption(const PictureCaption& caption)
{
    if (caption == caption_) { return; }
    const bool had_legend = showsLegend();
    caption_ = caption;
    if (showsLegend() != had_legend) {
        changed(); // with or without a shadow
    } else {
        update();
    }
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

void TextileCanvas::frameNext(Framing framing)
{
    framing_ = framing;
    moved_by_hand_ = false;
}

void TextileCanvas::fit(Framing framing)
{
    camera_.showFace();
    frame(framing);
}

void TextileCanvas::frame(Framing framing)
{
    framing_ = framing;
    moved_by_hand_ = false;
    if (fabric()) {
        camera_ = framed(camera_, *fabric(), framing, QSizeF(size()));
        redraw(false);
    }
}

void TextileCanvas::lookFrom(double turn, double lift)
{
    if (moved_by_hand_ && fabric()) {
        camera_ = looking_from(camera_, *fabric(), turn, lift, QSizeF(size()));
        redraw(false);
    } else {
        camera_.lookFrom(turn, lift);
        frame(framing_);
    }
}

void TextileCanvas::setParallel(bool parallel)
{
    camera_.setParallel(parallel);
    redraw(false);
}

void TextileCanvas::setCamera(const Camera& camera)
{
    camera_ = camera;
    moved_by_hand_ = true;
    redraw(false);
}

QImage TextileCanvas::picture()
{
    if (usable_) {
        moving_ = false;
        makeCurrent();
        complete(scene_, renderer_, sceneView());
        doneCurrent();
    }
    redraw(false);
    at_once_ = true;
    QImage picture = grabFramebuffer();
    at_once_ = false;
    return picture;
}

void TextileCanvas::initializeGL()
{
    usable_ = renderer_.initialize();
    const QString problem = usable_ ? samples_.initialize() : renderer_.problem();
    usable_ = problem.isEmpty();
    if (!usable_) { Q_EMIT failed(problem); }
    if (usable_ && waiting_) { takeView(); }
    scene_changed_ = true;
    water_changed_ = true;
    liquid_changed_ = true;
}

void TextileCanvas::resizeGL(int, int)
{
    scene_changed_ = true;
    if (!moved_by_hand_ && framing_ != Framing::as_it_is) { frame(framing_); }
}

PictureColors TextileCanvas::colors() const
{
    PictureColors colors = pictureColors(palette());
    colors.water = water_colors_;
    colors.shadow = shadow_shown_ && !showsLegend() && !section_.isCut();
    return colors;
}

void TextileCanvas::redraw(bool moving)
{
    if (moving && !moving_) { // from what the picture took at rest
        moving_step_ = least_step_ = 0;
        while (moving_step_ < coarsest && still_seconds_ * std::pow(moving_shares[moving_step_], 2) > moving_seconds) { ++moving_step_; }
    }
    moving_ = moving;
    if (moving) {
        still_.start();
    } else {
        still_.stop();
    }
    drawAnew();
}

void TextileCanvas::drawAnew()
{
    scene_changed_ = true;
    more_.stop();
    update();
    if (camera_ != told_) {
        told_ = camera_;
        Q_EMIT cameraMoved();
    }
}

void TextileCanvas::changed()
{
    if (moving_) {
        drawAnew();
    } else {
        redraw(false);
    }
}

void TextileCanvas::drawScene()
{
    if (std::exchange(water_changed_, false)) { renderer_.setWater(water_, water_maximum_); }
    if (std::exchange(liquid_changed_, false)) { renderer_.setLiquid(liquid_); }
    const SceneView view = sceneView();
    const double seconds = was_fading_ && since_drawn_.isValid() ? 1e-3 * static_cast<double>(since_drawn_.elapsed()) : 0;
    since_drawn_.start();
    scene_.update(view, seconds, [this](const MeshKey& key) { return renderer_.has(key); });
    const bool coarse = moving_ && moving_step_ > 0;
    if (coarse) { scene_.settle(); } // cells that fade are drawn twice
    was_fading_ = scene_.fading();
    const bool settled = !moving_ && !was_fading_;
    const QSize whole = size() * devicePixelRatioF();
    const QSize pixels = coarse ? (QSizeF(whole) * moving_shares[moving_step_]).toSize().expandedTo({1, 1}) : whole;
    const bool of_film = rested_.isValid() && rested_.elapsed() < rest_before_samples_ms;
    if (!of_film) film_is_quick_ = still_seconds_ < quick_seconds; // for the whole film
    const bool samples = settled && refines() && still_seconds_ < too_slow_for_samples && (film_is_quick_ || !of_film);
    if (!scene_picture_ || scene_picture_->size() != whole) {
        scene_picture_ = std::make_unique<QOpenGLFramebufferObject>(whole);
        sampled_.reset();
    }
    if (!light_ || light_->size() != pixels) { light_ = lightPicture(pixels); }
    if (samples && !sampled_) { sampled_ = lightPicture(pixels, 4); }
    QOpenGLFramebufferObject& target = samples ? *sampled_ : *light_;
    target.bind();
    QElapsedTimer timer;
    timer.start();
    renderer_.setMarked(selected_);
    renderer_.setParticlesShown(particles_shown_);
    renderer_.draw(view, scene_.batches(), pixels, colors());
    if (settled || moving_) {
        context()->functions()->glFinish();
        const double seconds_taken = 1e-9 * static_cast<double>(timer.nsecsElapsed());
        if (settled) { still_seconds_ = seconds_taken / (samples ? 2.5 : 1); }
        if (moving_) { adaptToMotion(seconds_taken); }
    }
    target.release();
    if (samples) { QOpenGLFramebufferObject::blitFramebuffer(light_.get(), sampled_.get()); }
    if (coarse) {
        if (!coarse_picture_ || coarse_picture_->size() != pixels) { coarse_picture_ = std::make_unique<QOpenGLFramebufferObject>(pixels); }
        renderer_.encode(*light_, *coarse_picture_);
        QOpenGLFramebufferObject::blitFramebuffer(scene_picture_.get(), QRect({0, 0}, whole), coarse_picture_.get(), QRect({0, 0}, pixels),
                                                  GL_COLOR_BUFFER_BIT, GL_LINEAR);
    } else {
        renderer_.encode(*light_, *scene_picture_);
    }
    scene_changed_ = false;
    if (!scene_.wanted().empty()) { Q_EMIT meshesWanted(); }
    if (was_fading_) { fade_.start(); }
    sampled_times_ = 0;
    sample_due_ = false;
    if (settled) {
        samples_.begin(pixels);
        if (samplesWanted() > 0) { more_.start(rest_before_samples_ms); }
        rested_.start();
    } else {
        more_.stop();
    }
}

/// Fewer pixels where the last picture took too long; more where they would still be quick and were not too many in this motion.
void TextileCanvas::adaptToMotion(double seconds)
{
    if (seconds > moving_seconds && moving_step_ < coarsest) {
        moving_step_ = std::min(coarsest, moving_step_ + (seconds > 3 * moving_seconds ? 2 : 1));
        if (scene_.wanted().empty()) { least_step_ = moving_step_; } // else coarser meshes are on their way
    } else if (moving_step_ > least_step_ &&
               seconds * std::pow(moving_shares[moving_step_ - 1] / moving_shares[moving_step_], 2) < 0.7 * moving_seconds) {
        --moving_step_;
    }
}

/// What is saved is refined always.
bool TextileCanvas::refines() const { return at_once_ || refine_at_rest_ != 0; }

/// As many as take a few seconds.
int TextileCanvas::samplesWanted() const
{
    if (!usable_ || !fabric() || !refines()) { return 0; }
    return std::clamp(static_cast<int>(sampling_seconds / std::max(still_seconds_, 1e-3)), fewest_samples, samples_at_rest);
}

/// The picture once more, a share of a pixel beside its place, into the mean.
void TextileCanvas::drawSample()
{
    sample_due_ = false;
    if (!samples_.begun() || sampled_times_ >= samplesWanted()) { return; }
    SceneView view = sceneView();
    view.shift = samples_.nextShift();
    samples_.sample().bind();
    renderer_.draw(view, scene_.batches(), samples_.sample().size(), colors());
    samples_.sample().release();
    samples_.add();
    sampled_times_ = samples_.count();
    if (sampled_times_ >= fewest_samples) { renderer_.encode(samples_.mean(), *scene_picture_); }
    if (sampled_times_ < samplesWanted()) { more_.start(0); }
}

void TextileCanvas::paintGL()
{
    if (usable_) {
        if (scene_changed_) {
            drawScene();
        } else if (sample_due_) {
            drawSample();
        }
        // As few on every machine: the same picture is the same, and a film has a hundred.
        const int few = std::min(fewest_samples, samplesWanted()); // none without cloth
        while (at_once_ && samples_.begun() && sampled_times_ < few) { drawSample(); }
        // nullptr is the context's own default; this widget has one of its own.
        auto* extra = context()->extraFunctions();
        extra->glBindFramebuffer(GL_READ_FRAMEBUFFER, scene_picture_->handle());
        extra->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
        const int w = scene_picture_->width(), h = scene_picture_->height();
        extra->glBlitFramebuffer(0, 0, w, h, 0, 0, w, h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        extra->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
    }
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    drawOverlay(painter);
}

void TextileCanvas::leaveEvent(QEvent*) { hover(QPointF(-1, -1)); }

void TextileCanvas::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange) { redraw(false); }
    QOpenGLWidget::changeEvent(event);
}

} // namespace hygroloom
