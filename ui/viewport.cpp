// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/viewport.h"

#include "core/base/error.h"
#include "core/base/units.h"
#include "ui/quantity.h"

#include <QGuiApplication>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

constexpr int patch_crossings = 20;
constexpr std::size_t fabric_triangles = 240000;
constexpr std::size_t sample_triangles = 300000;

} // namespace

Viewport::Viewport(QWidget* parent)
    : QWidget(parent)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    // A QOpenGLWidget on the offscreen platform brings Qt 6.4 down.
    if (QGuiApplication::platformName() == "offscreen" || QGuiApplication::platformName() == "minimal") {
        placeholder_ = new QLabel(tr("This display cannot draw the fabric."));
        placeholder_->setAlignment(Qt::AlignCenter);
        layout->addWidget(placeholder_);
    } else {
        canvas_ = new TextileCanvas;
        layout->addWidget(canvas_);
        setFocusProxy(canvas_);
        connect(canvas_, &TextileCanvas::crossingHovered, this, [this](int end, int pick) {
            if (!mesh_ || end < 0) {
                Q_EMIT repeatHovered(-1, -1);
                return;
            }
            const Weave& weave = mesh_->textile.weave;
            Q_EMIT repeatHovered((mesh_->request.whole.first_end + end) % weave.ends(), (mesh_->request.whole.first_pick + pick) % weave.picks());
        });
    }
    setMinimumSize(240, 180);
}

void Viewport::showFabric(const std::shared_ptr<const Design>& design, int fabric)
{
    const Fabric& shown = design->fabrics[static_cast<std::size_t>(fabric)];
    PreviewRequest wanted;
    wanted.design = design;
    wanted.fabric = fabric;
    wanted.whole = patch_of_repeats(shown.weave, patch_crossings);
    wanted.patch = wanted.whole;
    wanted.triangle_budget = fabric_triangles;
    request(Subject::fabric, wanted, QString::fromStdString(shown.name));
}

void Viewport::showSample(const std::shared_ptr<const Design>& design, int fabric, const Experiment& experiment)
{
    const Fabric& shown = design->fabrics[static_cast<std::size_t>(fabric)];
    PreviewRequest wanted;
    wanted.design = design;
    wanted.fabric = fabric;
    wanted.whole = region_of_sample(shown, experiment.sample_mm[0], experiment.sample_mm[1]);
    wanted.patch = patch_within(wanted.whole, sample_triangles, wanted.whole.ends / 2, wanted.whole.picks / 2);
    wanted.triangle_budget = sample_triangles;
    request(Subject::sample, wanted, tr("%1, dry").arg(QString::fromStdString(shown.name)));
}

void Viewport::showRun(const std::shared_ptr<const RunRecord>& run)
{
    const auto& fabrics = run->design.fabrics;
    const auto fabric = std::find_if(fabrics.begin(), fabrics.end(), [&](const Fabric& f) { return f.name == run->fabric; });
    if (fabric == fabrics.end()) {
        showNothing(tr("The recording does not hold its fabric “%1”.").arg(QString::fromStdString(run->fabric)));
        return;
    }
    PreviewRequest wanted;
    wanted.design = std::make_shared<const Design>(run->design);
    wanted.fabric = static_cast<int>(fabric - fabrics.begin());
    wanted.whole = {run->textile.first_end, run->textile.first_pick, run->textile.ends(), run->textile.picks()};
    int end = wanted.whole.ends / 2, pick = wanted.whole.picks / 2;
    if (const Experiment* experiment = find_experiment(run->design, run->experiment); experiment && !experiment->droplets.empty()) {
        const Droplet& drop = experiment->droplets.front();
        end += static_cast<int>(metre_from_mm(drop.at_mm[0]) / run->textile.warp.pitch);
        pick += static_cast<int>(metre_from_mm(drop.at_mm[1]) / run->textile.weft.pitch);
    }
    wanted.patch = patch_within(wanted.whole, sample_triangles, end, pick);
    wanted.triangle_budget = sample_triangles;
    if (run_ != run) {
        frame_.reset();
    }
    run_ = run;
    request(Subject::run, wanted, QString::fromStdString(run->fabric));
}

void Viewport::request(Subject subject, PreviewRequest wanted, const QString& title)
{
    subject_ = subject;
    caption_.title = title;
    caption_.notice.clear();
    if (subject != Subject::run) {
        run_.reset();
        frame_.reset();
    }
    refreshCaption();
    mesher_.run([this, wanted = std::move(wanted), subject](const NewestJob::Turn& turn) {
        try {
            build_preview(wanted, [&] { return turn.outdated(); },
                          [&](const std::shared_ptr<const PreviewMesh>& mesh) { turn.deliver([this, mesh, subject] { take(mesh, subject); }); });
        } catch (const Error& error) {
            const QString sentence = QString::fromStdString(error.what());
            turn.deliver([this, sentence] { showNothing(sentence); });
        }
    });
}

void Viewport::take(const std::shared_ptr<const PreviewMesh>& mesh, Subject subject)
{
    if (subject != subject_) {
        return; // of a view that has been left
    }
    mesh_ = mesh;
    if (canvas_) {
        canvas_->setMesh(mesh);
        if (fitted_subject_ != subject && !(fitted_subject_ == Subject::sample && subject == Subject::run)) {
            canvas_->fit();
        }
        fitted_subject_ = subject;
        showWater();
    }
    Q_EMIT previewUpdated();
}

void Viewport::showFrame(const std::shared_ptr<const Frame>& frame, double runMaximum)
{
    frame_ = frame;
    run_maximum_ = runMaximum;
    showWater();
}

void Viewport::showWater()
{
    if (!canvas_) {
        return;
    }
    if (!frame_ || subject_ != Subject::run) {
        canvas_->setWater({}, 1);
        surfacer_.drop();
        canvas_->setLiquid({});
        refreshCaption();
        return;
    }
    double maximum = 1;
    if (range_ == WaterRange::run) {
        maximum = roundedUp(run_maximum_);
    } else if (range_ == WaterRange::frame && !frame_->saturation.empty()) {
        maximum = roundedUp(*std::max_element(frame_->saturation.begin(), frame_->saturation.end()));
    }
    caption_.legend_maximum = std::min(1.0, maximum);
    canvas_->setWater(frame_->saturation, caption_.legend_maximum);
    surfacer_.run([this, frame = frame_](const NewestJob::Turn& turn) {
        turn.deliver([this, frame, surface = liquid_surface(*frame)] {
            if (frame_) {
                canvas_->setLiquid(surface);
            }
        });
    });
    refreshCaption();
}

void Viewport::showNothing(const QString& sentence)
{
    mesher_.drop();
    subject_ = Subject::nothing;
    fitted_subject_ = Subject::nothing;
    mesh_.reset();
    frame_.reset();
    caption_ = {};
    caption_.notice = sentence;
    if (canvas_) {
        canvas_->setMesh(nullptr);
    }
    refreshCaption();
}

void Viewport::setNotice(const QString& sentence)
{
    caption_.notice = sentence;
    refreshCaption();
}

void Viewport::setWaterColors(WaterColors colors)
{
    if (canvas_) {
        canvas_->setWaterColors(colors);
    }
}

void Viewport::setWaterRange(WaterRange range)
{
    range_ = range;
    showWater();
}

void Viewport::setHighlight(int end, int pick)
{
    if (canvas_) {
        canvas_->setHighlight(end, pick);
    }
}

void Viewport::refreshCaption()
{
    caption_.legend = frame_ && subject_ == Subject::run ? tr("Pores filled") : QString();
    caption_.unit = QStringLiteral("%");
    caption_.legend_scale = 100;
    if (canvas_) {
        canvas_->setCaption(caption_);
    }
}

void Viewport::fit()
{
    if (canvas_) {
        canvas_->fit();
    }
}

void Viewport::lookFrom(double turn, double lift)
{
    if (canvas_) {
        canvas_->lookFrom(turn, lift);
    }
}

QImage Viewport::picture()
{
    return canvas_ ? canvas_->picture() : QImage();
}

} // namespace hygroloom
