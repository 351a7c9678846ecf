// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the shown run found, as a laboratory would report it of its type of experiment.
#pragma once

#include "ui/results/playback.h"

#include <QScrollArea>

class QGridLayout;
class QLabel;

namespace hygroloom {

/// One line: a name, and what was found or why nothing was. For a number of each face both columns are filled.
struct Result {
    QString name;
    QString value;
    QString bottom = {};
};

/// Of the type of the experiment that was run.
std::vector<Result> resultsOf(const RunRecord& run, const Metrics& metrics);

/// How the numbers came about, in one line: "Draft, expected error 4.8 %, on the CPU, 22/11/2026 18:40, took 5.4 s".
QString originOf(const RunRecord& run, bool live);
/// The same in full, line by line: also the knobs that were set, where the expected error comes from, the parts that were forced, the
/// device.
QStringList originInFull(const RunRecord& run, bool live);

/// Follows a live run.
class ResultsPanel : public QScrollArea {
    Q_OBJECT
public:
    explicit ResultsPanel(Playback& playback, QWidget* parent = nullptr);

    /// All that is shown, line by line, as for the clipboard.
    QString text() const;
    /// Which physics the shown run took into account; nothing without one.
    void showPlan();

private:
    void refresh();

    Playback& playback_;
    QWidget* table_;
    QGridLayout* grid_;
    QLabel* notes_;
    QLabel* origin_;
    std::vector<std::array<QLabel*, 3>> rows_;
};

} // namespace hygroloom
