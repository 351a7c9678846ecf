// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What an edit comes to, while the hand is still on the slider: the experiment on one core, cut to a part of its time and its sample.
#pragma once

#include "core/run/run_options.h"
#include "ui/basics/newest_job.h"
#include "ui/results/live_cut.h"
#include "ui/results/results_panel.h"
#include "ui/results/water_map.h"

#include <optional>

namespace hygroloom {

struct Answer {
    std::shared_ptr<const RunRecord> run; ///< with its plan
    FaceMap top, bottom;
    double most = 0;             ///< mostOnFaces() of all its frames, kg/m2
    std::vector<Result> numbers; ///< those by which fabrics are compared come first; of a part without indices, grades and classes
    Experiment asked;            ///< the whole; the run's own is what was computed of it
    bool whole = false;          ///< nothing was cut, neither time nor sample nor frames
    bool edge_is_wet = false;
    double wall = 0;        ///< s, from the question to the answer
    double wall_of_all = 0; ///< s, that the whole is expected to take

    bool ofAllTime() const;  ///< the time was not cut
    bool ofAllCloth() const; ///< the sample was not cut
};

class LiveAnswer : public QObject {
    Q_OBJECT
public:
    /// cut: what experiments are cut to; none: cutOf().
    explicit LiveAnswer(const std::optional<LiveCut>& cut = {}, QObject* parent = nullptr);
    ~LiveAnswer() override;

    /// Begins anew with an experiment of a fabric; what is under way for an older question is cancelled. At live the experiment is
    /// cut unless the whole of it is asked for, at other fidelities it is whole. Preconditions: indices within the design.
    void ask(const std::shared_ptr<const Design>& design, int fabric, int experiment, Fidelity fidelity = Fidelity::live,
             bool whole = false);
    void stop();
    bool working() const { return working_; }

Q_SIGNALS:
    void answered(const std::shared_ptr<const Answer>& answer);
    /// Why there is no answer.
    void refused(const QString& sentence);

private:
    void end(const std::shared_ptr<const Answer>& answer, const QString& refusal);

    std::shared_ptr<RunControl> control_; ///< of what is under way
    std::optional<LiveCut> cut_;
    bool working_ = false;
    NewestJob job_; // last: it ends before the rest goes
};

} // namespace hygroloom
