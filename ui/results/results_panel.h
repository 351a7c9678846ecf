// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The results of the shown run, as a laboratory reports its type of experiment.
#pragma once

#include "core/analysis/page.h"
#include "ui/results/playback.h"

#include <QScrollArea>

class QGridLayout;
class QLabel;

namespace hygroloom {

struct OutcomeInfo;

/// A number's name without its face. The largest radius of a run is called so, for maps show that of their time beside it.
QString outcomeTitle(const OutcomeInfo& info);

/// One line: a name, and a value or why there is none. A number of each face fills both columns.
struct Result {
    QString name;
    QString value;
    QString bottom = {};
    QString full = {}, full_bottom = {}; ///< the numbers as they were computed
    QString about = {};                  ///< what is measured, where another number could be taken for it
};

/// The numbers of the run's type of experiment, then the water balance. part: of a part of the test, without what only the whole tells.
std::vector<Result> resultsOf(const RunRecord& run, const Metrics& metrics, bool part = false);

/// How the numbers were computed, in one line: "Draft, expected numerical error 4.8 %, on the CPU, 22/11/2026 18:40, took 5.4 s".
QString originOf(const RunRecord& run, bool live);
/// The same in full, line by line: also the changed knobs, the source of the expected numerical error, the forced parts, the device.
QStringList originInFull(const RunRecord& run, bool live);

/// Follows a live run.
class ResultsPanel : public QScrollArea {
    Q_OBJECT
public:
    explicit ResultsPanel(Playback& playback, QWidget* parent = nullptr);

    /// All that is shown, line by line, for the clipboard.
    QString text() const;
    /// The shown run as a page of HTML, with maps at the shown time; empty while there is nothing to show.
    ReportPage report() const;
    /// Opens the plan of the shown run, if there is one.
    void showPlan();
    /// How many runs are kept, which can be opened while none is shown.
    void setKept(int runs);
    /// Whether a run of what is chosen is kept while another one is shown.
    void setChosenKept(bool kept);

Q_SIGNALS:
    /// Of the runs that are kept.
    void newestRequested();
    /// The run of what is chosen.
    void chosenRequested();

private:
    void refresh();
    void showKept();

    Playback& playback_;
    QWidget* table_;
    QGridLayout* grid_;
    QLabel* notes_;
    QLabel* kept_; ///< stands for the results while no run is shown
    QLabel* origin_;
    int kept_runs_ = 0;
    bool chosen_is_kept_ = false;
    std::vector<std::array<QLabel*, 3>> rows_;
};

} // namespace hygroloom
