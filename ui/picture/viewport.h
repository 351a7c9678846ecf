// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The middle of the window: the woven fabric in three dimensions, dry, or with its water at one time.
#pragma once

#include "core/run/runner.h"
#include "core/scene/shown_quantity.h"
#include "ui/basics/newest_job.h"
#include "ui/picture/textile_canvas.h"

#include <QWidget>

class QLabel;

namespace hygroloom {

class ViewBar;

/// What the colours' range is taken from.
enum class WaterRange { full, run, frame };

/// Builds meshes beside the window; the newest request wins. Without OpenGL it still builds, and emits its signals.
class Viewport : public QWidget {
    Q_OBJECT
public:
    explicit Viewport(QWidget* parent = nullptr);

    /// A swatch of a fabric, dry.
    /// Its yarns are fitted unless they already are.
    void showFabric(const std::shared_ptr<const Design>& design, int fabric, const std::shared_ptr<const FittedFabric>& fitted);
    /// The whole sample of an experiment, before any run.
    void showSample(const std::shared_ptr<const Design>& design, int fabric, const Experiment& experiment);
    /// The region of a run; showFrame() then gives it water.
    void showRun(const std::shared_ptr<const RunRecord>& run);
    void showFrame(const std::shared_ptr<const Frame>& frame, double runMaximum);
    /// After more frames of the run are known.
    void setRunMaximum(double saturation);
    /// Nothing to draw, and what to do about it.
    void showNothing(const QString& sentence);
    void setNotice(const QString& sentence);
    void setWaterColors(WaterColors colors);
    void setWaterRange(WaterRange range);
    /// What the colours of a run show; the range is of temperatures, K.
    void setQuantity(ShownQuantity quantity, const ValueRange& range);
    void setHighlight(int end, int pick);
    /// Which side of the swatch: one of those that the bar offers.
    void setSwatch(int choice);

    void lookFrom(double turn, double lift);
    /// What a single key does here; false when it does nothing.
    bool pressKey(int key);
    /// Of the frame that is shown, whole, with its time in a corner unless that is empty. Null where there is no OpenGL.
    QImage picture(const QString& clock = {});
    /// Null until there is one.
    const std::shared_ptr<const PreviewFabric>& shown() const { return fabric_; }
    /// nullptr where there is no OpenGL.
    TextileCanvas* canvas() const { return canvas_; }
    ViewBar& bar() const { return *bar_; }

Q_SIGNALS:
    /// The picture shows the latest request, coarsely at least.
    void previewUpdated();
    /// A crossing of the weave's repeat; negative for none.
    void repeatHovered(int end, int pick);
    /// A yarn of the weave's repeat: its end, or its pick, and the other negative; both negative for none.
    void repeatSelected(int end, int pick);

private:
    enum class Subject { nothing, fabric, sample, run };
    void request(Subject subject, PreviewRequest request, const QString& title);
    void take(const std::shared_ptr<const PreparedView>& view, Subject subject);
    void fillIn();
    void showWater();
    void showValues();
    void applyColors();
    void refreshCaption();

    TextileCanvas* canvas_ = nullptr;
    ViewBar* bar_ = nullptr;
    QLabel* placeholder_ = nullptr;
    std::shared_ptr<const PreviewFabric> fabric_;
    std::shared_ptr<const Design> swatch_design_;
    int swatch_fabric_ = 0;
    std::shared_ptr<const FittedFabric> swatch_fitted_;
    int swatch_ = 0;
    std::shared_ptr<const RunRecord> run_;
    std::shared_ptr<const Frame> frame_;
    double run_maximum_ = 0;
    WaterRange range_ = WaterRange::full;
    ShownQuantity quantity_ = ShownQuantity::water;
    ValueRange values_;
    WaterColors colors_ = WaterColors::blue;
    Subject subject_ = Subject::nothing;
    Subject fitted_subject_ = Subject::nothing;
    PictureCaption caption_;
    NewestJob mesher_;
    NewestJob filler_;
    NewestJob surfacer_;
};

} // namespace hygroloom
