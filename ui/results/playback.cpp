// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/playback.h"

#include "core/base/error.h"
#include "core/run/recording.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>

namespace hygroloom {

namespace {

constexpr std::size_t most_bytes = 512u << 20;

std::size_t bytes_of(const Frame& frame)
{
    return sizeof(Frame) +
           4 * (frame.saturation.size() + frame.liquid.size() + frame.regain.size() + frame.vapour.size() + frame.temperature.size()) +
           12 * (frame.positions.size() + frame.velocities.size());
}

/// Frame after frame; those that cannot be read are passed over and named at the end.
class Reading {
public:
    explicit Reading(const Recording& recording) : recording_(recording), problems_(recording.problems()) {}
    /// The next one that can be read, from an index on, which becomes its own; nullptr: none is left.
    std::shared_ptr<const Frame> next(int& index)
    {
        for (; index < recording_.frames(); ++index) {
            try {
                return std::make_shared<const Frame>(recording_.frame(index));
            } catch (const Error& error) {
                problems_.emplace_back(error.what());
            }
        }
        return nullptr;
    }
    /// As a text for people; empty without any.
    QString problems() const
    {
        constexpr std::size_t most = 5;
        QString text;
        for (std::size_t i = 0; i < std::min(problems_.size(), most); ++i) { text += QString::fromStdString(problems_[i]) + "\n"; }
        if (problems_.size() > most) { text += Playback::tr("%1 more frames are left out.").arg(problems_.size() - most); }
        return text.trimmed();
    }

private:
    const Recording& recording_;
    std::vector<std::string> problems_;
};

double maximum_of(const Frame& frame)
{
    return frame.saturation.empty() ? 0 : *std::max_element(frame.saturation.begin(), frame.saturation.end());
}

} // namespace

Playback::Playback(QObject* parent) : ShownRun(parent) {}

void Playback::reset()
{
    ++generation_;
    reader_.drop();
    scanner_.drop();
    run_.reset();
    path_.clear();
    live_ = false;
    whole_ = false;
    follow_ = true;
    times_.clear();
    places_.clear();
    kept_.clear();
    kept_bytes_ = 0;
    first_.reset();
    frame_.reset();
    metrics_.reset();
    maximum_saturation_ = 0;
    current_ = -1;
    recording_.reset();
}

void Playback::stopOpening()
{
    ++opening_;
    scanner_.drop();
}

void Playback::discard()
{
    stopOpening();
    reset();
    Q_EMIT runChanged();
    Q_EMIT framesChanged();
    Q_EMIT metricsChanged();
    Q_EMIT frameShown();
}

void Playback::move(const QString& from, const QString& to)
{
    if (path_ == from) { path_ = to; }
}

void Playback::begin(const std::shared_ptr<const RunRecord>& run, const QString& path)
{
    stopOpening();
    reset();
    run_ = run;
    path_ = path;
    live_ = true;
    Q_EMIT runChanged();
    Q_EMIT framesChanged();
    Q_EMIT metricsChanged();
}

void Playback::append(const std::shared_ptr<const Frame>& frame, const std::shared_ptr<const Metrics>& metrics)
{
    if (!live_) { return; }
    const int index = frames();
    times_.push_back(frame->time);
    places_.push_back(index);
    metrics_ = metrics;
    maximum_saturation_ = std::max(maximum_saturation_, maximum_of(*frame));
    if (!first_) { first_ = frame; }
    remember(index, frame);
    Q_EMIT framesChanged();
    Q_EMIT metricsChanged();
    if (follow_) { present(index, frame); }
}

void Playback::complete(const std::shared_ptr<const RunRecord>& run)
{
    if (live_) { run_ = run; }
}

void Playback::end()
{
    whole_ = whole_ || live_;
    live_ = false;
    Q_EMIT framesChanged();
    Q_EMIT metricsChanged();
    Q_EMIT measured();
    Q_EMIT ended();
}

double Playback::duration() const
{
    if (run_ && live_) {
        if (const Experiment* experiment = find_experiment(run_->design, run_->experiment)) { return experiment->duration_s; }
    }
    return times_.empty() ? 0 : times_.back();
}

int Playback::expectedFrames() const
{
    const double interval = run_ && live_ ? run_->plan.frame_interval : 0;
    return interval > 0 ? std::max(frames(), static_cast<int>(std::lround(duration() / interval)) + 1) : frames();
}

void Playback::bring()
{
    if (const auto found = kept_.find(places_[static_cast<std::size_t>(current_)]); found != kept_.end()) {
        present(current_, found->second);
    } else {
        read(current_);
    }
}

void Playback::remember(int place, const std::shared_ptr<const Frame>& frame)
{
    if (kept_.emplace(place, frame).second) { kept_bytes_ += bytes_of(*frame); }
    const int shown = current_ >= 0 ? places_[static_cast<std::size_t>(current_)] : -1;
    // Frames farthest in time from the one shown are dropped first.
    while (kept_bytes_ > most_bytes && kept_.size() > 2) {
        auto farthest = kept_.begin();
        if (std::abs(kept_.rbegin()->first - shown) > std::abs(farthest->first - shown) && kept_.rbegin()->first != place) {
            farthest = std::prev(kept_.end());
        }
        kept_bytes_ -= bytes_of(*farthest->second);
        kept_.erase(farthest);
    }
}

void Playback::present(int index, const std::shared_ptr<const Frame>& frame)
{
    current_ = index;
    frame_ = frame;
    Q_EMIT frameShown();
}

void Playback::read(int index)
{
    if (live_) {
        // The nearest frame in memory stands in.
        auto near = kept_.lower_bound(index);
        if (near == kept_.end() && !kept_.empty()) { near = std::prev(near); }
        if (near != kept_.end()) { present(near->first, near->second); }
        return;
    }
    const std::string path = path_.toStdString();
    const int place = places_[static_cast<std::size_t>(index)];
    reader_.run([this, place, path, of = generation_, recording = recording_](const NewestJob::Turn& turn) mutable {
        try {
            if (!recording) { recording = std::make_shared<Recording>(path); }
            auto frame = std::make_shared<const Frame>(recording->frame(place));
            turn.deliver([this, place, of, frame, recording] {
                if (of != generation_) { return; }
                recording_ = recording;
                remember(place, frame);
                if (current_ >= 0 && places_[static_cast<std::size_t>(current_)] == place) { present(current_, frame); }
            });
        } catch (const std::exception& error) {
            const QString sentence = QString::fromStdString(error.what());
            turn.deliver([this, of, place, sentence] {
                if (of != generation_) { return; }
                if (leaveOut(place) && whole_) { Q_EMIT failed(sentence); } // else the scan names it
            });
        }
    });
}

/// A frame that cannot be read is no time to go to.
bool Playback::leaveOut(int place)
{
    const auto found = std::find(places_.begin(), places_.end(), place);
    if (found == places_.end()) { return false; }
    const auto index = found - places_.begin();
    times_.erase(times_.begin() + index);
    places_.erase(found);
    const bool was_shown = current_ == index;
    if (current_ > index || current_ >= frames()) { --current_; }
    Q_EMIT framesChanged();
    if (was_shown) { show(current_); }
    return true;
}

void Playback::open(const QString& path) { scan(path); }

void Playback::scan(const QString& path)
{
    scanner_.run([this, path, opening = ++opening_](const NewestJob::Turn& turn) {
        try {
            const Recording recording(path.toStdString());
            Reading reading(recording);
            const auto run = std::make_shared<const RunRecord>(recording.run());
            std::vector<double> times;
            for (const Ledger& ledger : recording.ledgers()) { times.push_back(ledger.time); }
            times.resize(static_cast<std::size_t>(recording.frames()));
            std::vector<int> places(times.size());
            std::iota(places.begin(), places.end(), 0);
            int firstIndex = 0;
            auto first = reading.next(firstIndex);
            times.erase(times.begin(), times.begin() + firstIndex); // those before it cannot be read
            places.erase(places.begin(), places.begin() + firstIndex);
            // reset() outdates this job; from here on only another request may stop it.
            auto generation = std::make_shared<long>(-1);
            turn.deliver([this, opening, run, times, places, first, firstIndex, path, generation] {
                if (opening != opening_) { return; } // another run has begun or is being opened
                reset();
                *generation = generation_;
                run_ = run;
                path_ = path;
                times_ = times;
                places_ = places;
                first_ = first;
                if (first) { remember(firstIndex, first); }
                Q_EMIT runChanged();
                Q_EMIT framesChanged();
                Q_EMIT metricsChanged();
                Q_EMIT opened(path);
                show(frames() - 1);
            });
            MetricsCollector collector;
            collector.start(*run);
            double maximum = 0;
            const int frames = recording.frames();
            for (int index = firstIndex; index < frames && opening == opening_; ++index) {
                const int wanted = index;
                if (const auto frame = index == firstIndex ? first : reading.next(index)) {
                    collector.add(*frame);
                    maximum = std::max(maximum, maximum_of(*frame));
                }
                for (int bad = wanted; bad < std::min(index, frames); ++bad) {
                    turn.deliver([this, generation, bad] {
                        if (*generation == generation_) { leaveOut(bad); }
                    });
                }
                const bool whole = index >= frames - 1;
                if (index % 25 != 24 && !whole) { continue; }
                turn.deliver([this, generation, maximum, whole, metrics = std::make_shared<const Metrics>(collector.metrics())] {
                    if (*generation == generation_) {
                        metrics_ = metrics;
                        whole_ = whole;
                        maximum_saturation_ = maximum;
                        Q_EMIT metricsChanged();
                        if (whole) { Q_EMIT measured(); }
                    }
                });
            }
            if (!reading.problems().isEmpty()) {
                turn.deliver([this, opening, sentence = reading.problems()] {
                    if (opening == opening_) { Q_EMIT failed(sentence); }
                });
            }
        } catch (const std::exception& error) {
            const QString sentence = QString::fromStdString(error.what());
            turn.deliver([this, opening, sentence] {
                if (opening == opening_) { Q_EMIT failed(sentence); }
            });
        }
    });
}

} // namespace hygroloom
