// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/live_answer.h"

#include "core/base/error.h"
#include "core/design/validate.h"
#include "core/run/runner.h"
#include "gpu/backends.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

namespace hygroloom {

namespace {

constexpr double moment = 0.2;         // s, that an answer may take
constexpr double room_for_more = 0.08; // s; the next longer one takes at most 2.5 times as long
constexpr double shortest = 0.1;       // s, of an experiment
constexpr int cells_across = 2;        // crossings, of a map

/// When the first drop falls, s; 0 where none does.
double beginOf(const Experiment& experiment)
{
    if (!uses_field(experiment.type, "droplets") || experiment.droplets.empty()) { return 0; }
    const auto sooner = [](const Droplet& a, const Droplet& b) { return a.time_s < b.time_s; };
    return std::min_element(experiment.droplets.begin(), experiment.droplets.end(), sooner)->time_s;
}

/// The design with one fabric and one experiment, which lasts so long (s): errors elsewhere do not matter.
Design trimmed(const Design& design, int fabric, int experiment, double length)
{
    Design one = design;
    one.fabrics = {design.fabrics.at(static_cast<std::size_t>(fabric))};
    one.experiments = {design.experiments.at(static_cast<std::size_t>(experiment))};
    one.garments.clear();
    one.wears.clear();
    one.experiments[0].duration_s = length;
    std::erase_if(one.experiments[0].droplets, [length](const Droplet& drop) { return drop.time_s >= length; });
    return one;
}

QString firstError(const Design& design)
{
    for (const Issue& issue : validate(design)) {
        if (issue.severity == Severity::error) { return QString::fromStdString(issue.text); }
    }
    return {};
}

std::shared_ptr<const Answer> answerTo(const Design& design, Fidelity fidelity, double duration, RunControl& control)
{
    const auto begun = std::chrono::steady_clock::now();
    RunOptions options;
    options.fidelity = fidelity;
    options.threads = 1;
    MetricsCollector collector;
    std::shared_ptr<const Frame> first, last;
    std::optional<RunRecord> record;
    std::optional<Frame> start; // of the maps
    double most = 0;
    RunCallbacks callbacks;
    callbacks.started = [&](const RunRecord& run) {
        collector.start(run);
        record = run;
    };
    callbacks.frame = [&](const std::shared_ptr<const Frame>& frame) {
        collector.add(*frame);
        if (!first) {
            first = frame;
            start = start_of_maps(*record, *first);
        }
        last = frame;
        most = std::max(most, mostOnFaces(record->textile, *frame, *start, cells_across));
    };
    callbacks.switched_on = [&](const SwitchedPart& part) { collector.add(part); };
    const auto backend = make_backend("cpu");
    auto answer = std::make_shared<Answer>();
    answer->run = std::make_shared<const RunRecord>(
        run_experiment(design, design.fabrics[0].name, design.experiments[0].name, options, *backend, control, callbacks));
    answer->top = faceMap(*answer->run, *last, *first, MapSide::top, cells_across);
    answer->bottom = faceMap(*answer->run, *last, *first, MapSide::bottom, cells_across);
    answer->most = most;
    answer->numbers = resultsOf(*answer->run, collector.metrics());
    answer->simulated = design.experiments[0].duration_s;
    answer->duration = duration;
    answer->wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    return answer;
}

} // namespace

double lengthThatFits(double simulated, double duration, double wall)
{
    if (wall <= moment && wall >= room_for_more) { return simulated; }
    const bool longer = wall < room_for_more;
    const double decade = std::pow(10.0, std::floor(std::log10(simulated) + 1e-9));
    const std::array<double, 5> round{0.5 * decade, decade, 2 * decade, 5 * decade, 10 * decade};
    double next = simulated;
    if (longer) {
        for (auto r = round.rbegin(); r != round.rend(); ++r) {
            if (*r > simulated * 1.001) { next = *r; }
        }
    } else {
        for (const double r : round) {
            if (r < simulated * 0.999) { next = r; }
        }
    }
    return std::min(duration, std::max(shortest, next));
}

LiveAnswer::LiveAnswer(QObject* parent) : QObject(parent) {}

LiveAnswer::~LiveAnswer() { stop(); }

double LiveAnswer::lengthOf(const Experiment& experiment) const
{
    constexpr double unknown = 1.0; // s
    const auto known = lengths_.find(experiment.name);
    return std::min(experiment.duration_s, beginOf(experiment) + (known == lengths_.end() ? unknown : known->second));
}

void LiveAnswer::ask(const std::shared_ptr<const Design>& design, int fabric, int experiment, Fidelity fidelity, bool whole)
{
    stop();
    control_ = std::make_shared<RunControl>();
    working_ = true;
    const Experiment& asked = design->experiments.at(static_cast<std::size_t>(experiment));
    const bool shortened = fidelity == Fidelity::live && !whole;
    const double length = shortened ? lengthOf(asked) : asked.duration_s;
    job_.run([this, design, fabric, experiment, fidelity, length, shortened, duration = asked.duration_s,
              control = control_](const NewestJob::Turn& turn) {
        std::shared_ptr<const Answer> answer;
        QString refusal;
        try {
            const Design one = trimmed(*design, fabric, experiment, length);
            refusal = firstError(one);
            if (refusal.isEmpty()) { answer = answerTo(one, fidelity, duration, *control); }
        } catch (const Cancelled&) {
            return;
        } catch (const std::bad_alloc&) {
            refusal = tr("Not enough memory for this experiment. Choose a smaller sample.");
        } catch (const std::exception& error) {
            refusal = QString::fromStdString(error.what());
        }
        turn.deliver([this, control, answer, refusal, shortened] {
            if (control == control_) { end(answer, refusal, shortened); }
        });
    });
}

void LiveAnswer::end(const std::shared_ptr<const Answer>& answer, const QString& refusal, bool shortened)
{
    working_ = false;
    if (!answer) {
        Q_EMIT refused(refusal);
        return;
    }
    if (shortened) {
        const double begin = beginOf(answer->run->design.experiments[0]);
        lengths_[answer->run->experiment] = lengthThatFits(answer->simulated - begin, answer->duration - begin, answer->wall);
    }
    Q_EMIT answered(answer);
}

void LiveAnswer::stop()
{
    if (control_) { control_->cancel = true; }
    control_.reset();
    working_ = false;
    job_.drop();
}

} // namespace hygroloom
