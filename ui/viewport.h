// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The middle of the window: the woven fabric in three dimensions, dry, or with the water of a moment.
#pragma once

#include "core/sim/runner.h"
#include "ui/newest_job.h"
#include "ui/preview_mesh.h"
#include "ui/textile_canvas.h"

#include <QWidget>

class QLabel;

namespace hygroloom {

/// What the colours' range is taken from.
enum class WaterRange { full, run, frame };

/// Builds meshes beside the window; the newest request wins. On platforms that cannot draw with OpenGL it still builds and tells.
class Viewport : public QWidget {
    Q_OBJECT
public:
    explicit Viewport(QWidget* parent = nullptr);

    /// A few repeats of a fabric, dry.
    void showFabric(const std::shared_ptr<const Design>& design, int fabric);
    /// The whole sample of an experiment, before any run.
    void showSample(const std::shared_ptr<const Design>& design, int fabric, const Experiment& experiment);
    /// The region of a run; showFrame() then gives it water.
    void showRun(const std::shared_ptr<const RunRecord>& run);
    void showFrame(const std::shared_ptr<const Frame>& frame, double runMaximum);
    /// Nothing to draw, and what to do about it.
    void showNothing(const QString& sentence);
    void setNotice(const QString& sentence);
    void setWaterColors(WaterColors colors);
    void setWaterRange(WaterRange range);
    void setHighlight(int end, int pick);

    void fit();
    void lookFrom(double turn, double lift);
    /// Null where there is no OpenGL.
    QImage picture();
    const std::shared_ptr<const PreviewMesh>& mesh() const { return mesh_; }

Q_SIGNALS:
    /// The picture shows what was last asked for, coarsely at least.
    void previewUpdated();
    /// A crossing of the weave's repeat; negative for none.
    void repeatHovered(int end, int pick);

private:
    enum class Subject { nothing, fabric, sample, run };
    void request(Subject subject, PreviewRequest request, const QString& title);
    void take(const std::shared_ptr<const PreviewMesh>& mesh, Subject subject);
    void showWater();
    void refreshCaption();

    TextileCanvas* canvas_ = nullptr;
    QLabel* placeholder_ = nullptr;
    std::shared_ptr<const PreviewMesh> mesh_;
    std::shared_ptr<const RunRecord> run_;
    std::shared_ptr<const Frame> frame_;
    double run_maximum_ = 0;
    WaterRange range_ = WaterRange::full;
    Subject subject_ = Subject::nothing;
    Subject fitted_subject_ = Subject::nothing;
    PictureCaption caption_;
    NewestJob mesher_;
    NewestJob surfacer_;
};

} // namespace hygroloom
