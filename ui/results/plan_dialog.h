// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// "What is modelled, and why": a plan in words, of the next run or of the one that is shown.
#pragma once

#include "core/run/runner.h"

#include <QDialog>

namespace hygroloom {

class PlanDialog : public QDialog {
    Q_OBJECT
public:
    /// Of the next run.
    PlanDialog(const ModelPlan& plan, const QString& fabric, const QString& experiment, QWidget* parent = nullptr);
    /// Of a run that was made, also what it did otherwise than was planned.
    explicit PlanDialog(const RunRecord& run, QWidget* parent = nullptr);

private:
    void fill(const QString& html);
};

QString fidelityName(Fidelity fidelity);
/// "about 40 s", "about 3 min".
QString roughDuration(double seconds);
/// "12 s of 60 s simulated in 3 s, 9 s left."
QString progressText(const RunProgress& progress, bool paused = false);
/// "about 20 s, 45 MB of memory, error 3 %" and where that comes from; safe as HTML.
QString expectation(const ModelPlan& plan);
/// The same in few words, to stand beside a choice: "about 57 s, 35 MB, error 0.7 %".
QString shortExpectation(const ModelPlan& plan);
/// How near to the reference a result is expected to be: "expected numerical error 4.8 %", or that it is not known, or that it is the
/// reference's.
QString expectedError(const ModelPlan& plan);

} // namespace hygroloom
