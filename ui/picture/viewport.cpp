// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/picture/viewport.h"

#include "core/base/error.h"
#include "core/base/round_up.h"
#include "core/base/units.h"
#include "core/scene/liquid_bodies.h"
#include "ui/basics/preferences.h"
#include "ui/basics/quantity.h"
#include "ui/picture/view_bar.h"

#include <QGuiApplication>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <iterator>
#include <utility>

namespace hygroloom {

namespace {

/// With the pools and drops that the run knows as numbers. run may be nullptr.
LiquidSurface surfaceOf(const Frame& frame, const RunRecord* run)
{
    const Experiment* experiment = run ? find_experiment(run->design, run->experiment) : nullptr;
    return liquid_surface(frame, experiment ? liquid_bodies(frame, *experiment, run->textile.half_thickness()) : frame.caps);
}

} // namespace

Viewport::Viewport(QWidget* parent) : QWidget(parent)
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
        connect(canvas_, &TextileCanvas::meshesWanted, this, &Viewport::fillIn);
        connect(canvas_, &TextileCanvas::yarnSelected, this, [this](const YarnNumber& yarn) {
            if (yarn.yarn < 0) {
                Q_EMIT repeatSelected(-1, -1);
            } else if (const Textile& textile = fabric_->textile; yarn.kind == YarnKind::warp) {
                Q_EMIT repeatSelected((textile.first_end + yarn.yarn) % textile.weave.ends(), -1);
            } else {
                Q_EMIT repeatSelected(-1, (textile.first_pick + yarn.yarn) % textile.weave.picks());
            }
        });
        setFocusProxy(canvas_);
        connect(canvas_, &TextileCanvas::crossingHovered, this, [this](int end, int pick) {
            if (!fabric_ || end < 0) {
                Q_EMIT repeatHovered(-1, -1);
                return;
            }
            const Textile& textile = fabric_->textile;
            Q_EMIT repeatHovered((textile.first_end + end) % textile.weave.ends(), (textile.first_pick + pick) % textile.weave.picks());
        });
    }
    bar_ = new ViewBar(canvas_, this);
    swatch_ = bar_->swatch();
    connect(bar_, &ViewBar::swatchChosen, this, &Viewport::setSwatch);
    connect(&PreferenceNews::instance(), &PreferenceNews::changed, this, &Viewport::refreshCaption); // its unit
    layout->insertWidget(0, bar_);
    if (canvas_) { layout->addWidget(canvas_, 1); }
    setMinimumSize(240, 180);
}

void Viewport::showFabric(const std::shared_ptr<const Design>& design, int fabric, const std::shared_ptr<const FittedFabric>& fitted)
{
    const Fabric& shown = design->fabrics[static_cast<std::size_t>(fabric)];
    PreviewRequest wanted;
    wanted.design = design;
    wanted.fabric = fabric;
    wanted.whole = swatch_region(shown, swatch_sides_mm[swatch_]);
    wanted.fitted = fitted;
    swatch_design_ = design;
    swatch_fabric_ = fabric;
    swatch_fitted_ = wanted.fitted;
    request(Subject::fabric, wanted, QString::fromStdString(shown.name));
}

void Viewport::showSample(const std::shared_ptr<const Design>& design, int fabric, const Experiment& experiment)
{
    const Fabric& shown = design->fabrics[static_cast<std::size_t>(fabric)];
    PreviewRequest wanted;
    wanted.design = design;
    wanted.fabric = fabric;
    wanted.whole = region_of_run(shown, experiment);
    request(Subject::sample, wanted, tr("%1, dry").arg(QString::fromStdString(shown.name)));
}

void Viewport::showRun(const std::shared_ptr<const RunRecord>& run)
{
    const auto& fabrics = run->design.fabrics;
    const auto fabric = std::find_if(fabrics.begin(), fabrics.end(), [&](const Fabric& f) { return f.name == run->fabric; });
    if (fabric == fabrics.end()) {
        showNothing(tr("The recording does not contain its fabric “%1”.").arg(QString::fromStdString(run->fabric)));
        return;
    }
    PreviewRequest wanted;
    wanted.design = std::make_shared<const Design>(run->design);
    wanted.fabric = static_cast<int>(fabric - fabrics.begin());
    wanted.whole = {run->textile.first_end, run->textile.first_pick, run->textile.ends(), run->textile.picks()};
    if (run->plan.shown_ends > 0) {
        wanted.whole = run->plan.region;
        wanted.shown_ends = run->textile.ends();
        wanted.shown_picks = run->textile.picks();
    }
    if (run_ != run) { frame_.reset(); }
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
    // Another subject is framed anew; the sample of a run is framed already.
    const bool same = fitted_subject_ == subject || (fitted_subject_ == Subject::sample && subject == Subject::run);
    SceneView view;
    Framing framing = subject == Subject::fabric ? Framing::few_repeats : Framing::whole;
    if (canvas_) {
        if (same) { framing = canvas_->movedByHand() ? Framing::as_it_is : canvas_->framing(); }
        view = canvas_->sceneView();
    }
    mesher_.run([this, wanted = std::move(wanted), subject, view, framing, same](const NewestJob::Turn& turn) {
        try {
            const auto prepared = prepare_view(wanted, view, framing, [&] { return turn.outdated(); });
            turn.deliver([this, prepared, subject, framing, same] {
                if (subject == subject_ && canvas_ && !same) { canvas_->frameNext(framing); }
                take(prepared, subject);
            });
        } catch (const Error& error) {
            const QString sentence = QString::fromStdString(error.what());
            turn.deliver([this, sentence] { showNothing(sentence); });
        }
    });
}

void Viewport::take(const std::shared_ptr<const PreparedView>& view, Subject subject)
{
    if (subject != subject_) {
        return; // of a view that has been left
    }
    fabric_ = view->fabric;
    fitted_subject_ = subject;
    if (canvas_) {
        canvas_->setView(view);
        showWater();
    }
    bar_->setHalfExtent(fabric_->high());
    Q_EMIT previewUpdated();
}

void Viewport::fillIn()
{
    filler_.run([this, fabric = fabric_, wanted = canvas_->scene().wanted()](const NewestJob::Turn& turn) {
        make_wanted(
            fabric, wanted, [&] { return turn.outdated(); },
            [&](const std::shared_ptr<const PreparedView>& ready) { turn.deliver([this, ready] { canvas_->addMeshes(*ready); }); });
    });
}

void Viewport::showFrame(const std::shared_ptr<const Frame>& frame, double runMaximum)
{
    frame_ = frame;
    run_maximum_ = runMaximum;
    showWater();
}

void Viewport::setRunMaximum(double saturation)
{
    if (std::exchange(run_maximum_, saturation) != saturation && range_ == WaterRange::run) { showWater(); }
}

void Viewport::showWater()
{
    if (!canvas_) { return; }
    if (!frame_ || subject_ != Subject::run) {
        canvas_->setWater({}, 1);
        surfacer_.drop();
        canvas_->setLiquid({});
        refreshCaption();
        return;
    }
    showValues();
    surfacer_.run([this, frame = frame_, run = run_](const NewestJob::Turn& turn) {
        turn.deliver([this, frame, surface = surfaceOf(*frame, run.get())] {
            if (frame_) { canvas_->setLiquid(surface); }
        });
    });
    refreshCaption();
}

void Viewport::showValues()
{
    if (quantity_ != ShownQuantity::water) {
        std::vector<float> shares = segment_values(*frame_, quantity_);
        const double wide = std::max(1e-9, values_.high - values_.low);
        for (float& share : shares) {
            share = static_cast<float>(std::clamp((static_cast<double>(share) - values_.low) / wide, 1e-3, 1.0));
        }
        caption_.legend_maximum = 1;
        canvas_->setWater(std::move(shares), 1);
        return;
    }
    double maximum = 1;
    if (range_ == WaterRange::run) {
        maximum = rounded_up(run_maximum_);
    } else if (range_ == WaterRange::frame && !frame_->saturation.empty()) {
        maximum = rounded_up(*std::max_element(frame_->saturation.begin(), frame_->saturation.end()));
    }
    caption_.legend_maximum = std::min(1.0, maximum);
    canvas_->setWater(frame_->saturation, caption_.legend_maximum);
}

void Viewport::showNothing(const QString& sentence)
{
    mesher_.drop();
    subject_ = Subject::nothing;
    fitted_subject_ = Subject::nothing;
    filler_.drop();
    fabric_.reset();
    frame_.reset();
    caption_ = {};
    caption_.notice = sentence;
    if (canvas_) { canvas_->setView(nullptr); }
    refreshCaption();
}

void Viewport::setNotice(const QString& sentence)
{
    caption_.notice = sentence;
    refreshCaption();
}

void Viewport::setWaterColors(WaterColors colors)
{
    colors_ = colors;
    applyColors();
}

void Viewport::applyColors()
{
    if (!canvas_) { return; }
    const bool damp = quantity_ == ShownQuantity::humidity && colors_ == WaterColors::natural; // no cloth looks humid
    canvas_->setWaterColors(quantity_ == ShownQuantity::temperature ? WaterColors::warmth : damp ? WaterColors::blue : colors_);
}

void Viewport::setQuantity(ShownQuantity quantity, const ValueRange& range)
{
    if (quantity == quantity_ && range == values_) { return; }
    quantity_ = quantity;
    values_ = range;
    applyColors();
    showWater();
}

void Viewport::setWaterRange(WaterRange range)
{
    range_ = range;
    showWater();
}

void Viewport::setHighlight(int end, int pick)
{
    if (canvas_) { canvas_->setHighlight(end, pick); }
}

void Viewport::refreshCaption()
{
    caption_.unit = QStringLiteral("%");
    caption_.legend_scale = 100;
    caption_.legend_zero = 0;
    switch (quantity_) {
    case ShownQuantity::water:
        caption_.legend = tr("Pores filled");
        caption_.pointed = tr("End %1, pick %2 of the pores filled");
        break;
    case ShownQuantity::humidity:
        caption_.legend = tr("Humidity");
        caption_.pointed = tr("Relative humidity in the yarns: end %1, pick %2");
        break;
    case ShownQuantity::temperature: {
        const UserUnit user = userUnit(QStringLiteral("°C"));
        caption_.legend = tr("Temperature");
        caption_.pointed = tr("End %1, pick %2");
        caption_.unit = user.unit;
        caption_.legend_zero = user.of(celsius_from_kelvin(values_.low));
        caption_.legend_scale = user.per_one * (values_.high - values_.low);
        break;
    }
    }
    if (!frame_ || subject_ != Subject::run) { caption_.legend.clear(); }
    if (canvas_) { canvas_->setCaption(caption_); }
}

void Viewport::setSwatch(int choice)
{
    swatch_ = std::clamp(choice, 0, static_cast<int>(std::size(swatch_sides_mm)) - 1);
    if (subject_ == Subject::fabric && swatch_design_) { showFabric(swatch_design_, swatch_fabric_, swatch_fitted_); }
}

void Viewport::lookFrom(double turn, double lift)
{
    if (canvas_) { canvas_->lookFrom(turn, lift); }
}

bool Viewport::pressKey(int key) { return bar_->pressKey(key); }

QImage Viewport::picture(const QString& clock)
{
    if (!canvas_) { return {}; }
    if (frame_ && subject_ == Subject::run && surfacer_.busy()) { // the free liquid of this frame, not of the one before
        surfacer_.drop();
        canvas_->setLiquid(surfaceOf(*frame_, run_.get()));
    }
    caption_.clock = clock;
    canvas_->setCaption(caption_);
    const QImage made = canvas_->picture();
    caption_.clock.clear();
    canvas_->setCaption(caption_);
    return made;
}

} // namespace hygroloom
