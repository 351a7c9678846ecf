// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/live_answer.h"

#include "core/analysis/measured_run.h"
#include "core/base/error.h"
#include "core/design/validate.h"
#include "core/run/plan_run.h"
#include "gpu/backends.h"
#include "ui/basics/issue_text.h"

#include <algorithm>
#include <chrono>
#include <limits>

namespace hygroloom {

namespace {

constexpr int cells_across = 2; // crossings, of a map
// Of a cut answer and of others: each asks for a step at least, and for a look at all of the cloth.
constexpr double frames = 20, usual_frames = 100;
constexpr double all_of_it = std::numeric_limits<double>::infinity(); // s, of an experiment

/// whole: with the frames of any other run.
std::shared_ptr<Answer> answerTo(const Design& design, Fidelity fidelity, bool whole, RunControl& control)
{
    RunOptions options;
    options.fidelity = fidelity;
    options.threads = 1;
    const Experiment& experiment = design.experiments[0];
    const double duration = experiment.duration_s;
    options.frame_interval = whole ? 0 : std::max((duration - beginOf(experiment)) / frames, duration / usual_frames);
    std::shared_ptr<const Frame> first, last;
    std::optional<RunRecord> record;
    std::optional<Frame> start; // of the maps
    double most = 0;
    RunCallbacks callbacks;
    callbacks.started = [&](const RunRecord& run) { record = run; };
    callbacks.frame = [&](const std::shared_ptr<const Frame>& frame) {
        if (!first) {
            first = frame;
            start = start_of_maps(*record, *first);
        }
        last = frame;
        most = std::max(most, mostOnFaces(record->textile, *frame, *start, cells_across));
    };
    const auto backend = make_backend("cpu");
    auto answer = std::make_shared<Answer>();
    const FinishedRun finished = run_and_measure(design, design.fabrics[0].name, experiment.name, options, *backend, control, callbacks);
    answer->run = std::make_shared<const RunRecord>(finished.run);
    answer->top = faceMap(*answer->run, *last, *first, MapSide::top, cells_across);
    answer->bottom = faceMap(*answer->run, *last, *first, MapSide::bottom, cells_across);
    answer->most = most;
    answer->numbers = resultsOf(*answer->run, finished.metrics, !whole);
    answer->edge_is_wet = finished.metrics.edge_time.has_value();
    return answer;
}

/// s, that the whole experiment may take: as planned for its whole time on the cut sample, times the share of the cloth.
double wallOfAll(const Design& design, int fabric, int experiment, const LiveCut& cut)
{
    const auto area = [](const Experiment& of) { return of.sample_mm[0] * of.sample_mm[1]; };
    const Design part = cutDesign(design, fabric, experiment, {.length = all_of_it, .halvings = cut.halvings});
    const ModelPlan plan = plan_run(part, part.fabrics[0], part.experiments[0], Fidelity::live);
    return plan.expected_seconds * area(design.experiments[static_cast<std::size_t>(experiment)]) / area(part.experiments[0]);
}

} // namespace

bool Answer::ofAllTime() const { return run->design.experiments[0].duration_s >= asked.duration_s; }

bool Answer::ofAllCloth() const { return run->design.experiments[0].sample_mm == asked.sample_mm; }

LiveAnswer::LiveAnswer(const std::optional<LiveCut>& cut, QObject* parent) : QObject(parent), cut_(cut) {}

LiveAnswer::~LiveAnswer() { stop(); }

void LiveAnswer::ask(const std::shared_ptr<const Design>& design, int fabric, int experiment, Fidelity fidelity, bool whole)
{
    stop();
    control_ = std::make_shared<RunControl>();
    working_ = true;
    const Experiment& asked = design->experiments.at(static_cast<std::size_t>(experiment));
    const Fabric& cloth = design->fabrics.at(static_cast<std::size_t>(fabric));
    const bool cuts = fidelity == Fidelity::live && !whole;
    const LiveCut first = cuts ? cut_.value_or(cutOf(cloth, asked)) : LiveCut{.length = all_of_it};
    job_.run([this, design, fabric, experiment, fidelity, cuts, cut = first, control = control_](const NewestJob::Turn& turn) mutable {
        const auto begun = std::chrono::steady_clock::now();
        std::shared_ptr<Answer> answer;
        QString refusal;
        try {
            refusal = firstError(validate(cutDesign(*design, fabric, experiment, {.length = all_of_it})));
            for (bool fits = !refusal.isEmpty(); !fits;) {
                const Design one = cutDesign(*design, fabric, experiment, cut);
                const QString error = firstError(validate(one));
                if (error.isEmpty()) { answer = answerTo(one, fidelity, !cuts, *control); }
                if (cut.halvings == 0) { refusal = error; }
                fits = cut.halvings == 0 || (error.isEmpty() && !answer->edge_is_wet);
                if (!fits) { --cut.halvings; } // so little is no experiment, or water has reached its edge
            }
            if (answer) {
                answer->asked = design->experiments[static_cast<std::size_t>(experiment)];
                answer->whole = !cuts;
                answer->wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
                answer->wall_of_all = cuts ? wallOfAll(*design, fabric, experiment, cut) : answer->wall;
            }
        } catch (const Cancelled&) {
            return;
        } catch (const std::bad_alloc&) {
            refusal = tr("Not enough memory for this experiment. Choose a smaller sample.");
        } catch (const std::exception& error) {
            refusal = QString::fromStdString(error.what());
        }
        if (!refusal.isEmpty()) { answer.reset(); }
        turn.deliver([this, control, answer, refusal] {
            if (control == control_) { end(answer, refusal); }
        });
    });
}

void LiveAnswer::end(const std::shared_ptr<const Answer>& answer, const QString& refusal)
{
    working_ = false;
    if (answer) {
        Q_EMIT answered(answer);
    } else {
        Q_EMIT refused(refusal);
    }
}

void LiveAnswer::stop()
{
    if (control_) { control_->cancel = true; }
    control_.reset();
    working_ = false;
    job_.drop();
}

} // namespace hygroloom
