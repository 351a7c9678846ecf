// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What an edit comes to, while the hand is still on the slider: the experiment on one core, cut to what fits a moment.
#pragma once

#include "core/run/run_options.h"
#include "ui/basics/newest_job.h"
#include "ui/results/live_cut.h"
#include "ui/results/results_panel.h"
#include "ui/results/water_map.h"

#include <map>

namespace hygroloom {

struct Answer {
    std::shared_ptr<const RunRecord> run; ///< with its plan
    FaceMap top, bottom;
    double most = 0;             ///< mostOnFaces() of all its frames, kg/m2
    std::vector<Result> numbers; ///< those by which fabrics are compared come first
    Experiment asked;            ///< the whole; the run's own is what was computed of it
    bool whole = false;          ///< nothing was cut, neither time nor sample nor frames
    bool edge_is_wet = false;
    double wall = 0; ///< s, from the question to the answer

    bool ofAllTime() const;
    bool ofAllCloth() const;
    double wallOfAll() const; ///< s, that the whole may take; a guess: as if time grew with the cloth and with frames
};

class LiveAnswer : public QObject {
    Q_OBJECT
public:
    explicit LiveAnswer(QObject* parent = nullptr);
    ~LiveAnswer() override;

    /// Begins anew with an experiment of a fabric; what is under way for an older question is cancelled. At live the experiment is
    /// cut unless the whole of it is asked for, at other fidelities it is whole. Preconditions: indices within the design.
    void ask(const std::shared_ptr<const Design>& design, int fabric, int experiment, Fidelity fidelity = Fidelity::live,
             bool whole = false);
    /// Of the experiment's next answer, whatever the last took.
    void cutTo(const std::string& experiment, const LiveCut& cut);
    void stop();
    bool working() const { return working_; }

Q_SIGNALS:
    void answered(const std::shared_ptr<const Answer>& answer);
    /// Why there is no answer.
    void refused(const QString& sentence);

private:
    void end(const std::shared_ptr<const Answer>& answer, const QString& refusal);

    std::shared_ptr<RunControl> control_; ///< of what is under way
    std::map<std::string, LiveCut> cuts_; ///< that fit, by experiment
    bool working_ = false;
    NewestJob job_; // last: it ends before the rest goes
};

} // namespace hygroloom
