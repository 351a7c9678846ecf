// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/garment/wear_playback.h"

#include "core/base/round_up.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

/// g/m2, of the cell that can hold the most.
double mostCapacity(const WearLayout& layout)
{
    double most = 0;
    for (const GarmentCell& cell : layout.cells) {
        if (cell.area > 0) { most = std::max(most, 1e3 * cell.capacity / cell.area); }
    }
    return most;
}

} // namespace

double scaleEndOfRun(double most, double share_of_time, double capacity)
{
    const double at_end = share_of_time > 0 ? most / std::min(1.0, share_of_time) : most;
    return rounded_up(std::max(most, std::min(at_end, capacity)));
}

void WearPlayback::begin(const std::shared_ptr<WornRun>& run)
{
    run_ = run;
    current_ = -1;
    follow_ = true;
    held_ = {};
    if (pin_.panel >= static_cast<int>(run->layout().panels.size())) { pin_ = {}; }
    pair();
    Q_EMIT runChanged();
    Q_EMIT framesChanged();
}

void WearPlayback::append(const std::shared_ptr<const WearFrame>& frame, const std::shared_ptr<const WearMetrics>& metrics,
                          const MostWater& most)
{
    if (!run_) { return; }
    const double before = this->most();
    run_->frames.push_back(frame);
    run_->metrics = metrics;
    run_->most_water = std::max(run_->most_water, most.areal);
    run_->most_share = std::max(run_->most_share, most.share);
    if (!run_->live) { run_->duration = std::max(run_->duration, frame->time); }
    holdScale(frame->time);
    if (this->most() != before) { Q_EMIT scaleChanged(); }
    Q_EMIT framesChanged();
    if (follow_) {
        current_ = frames() - 1;
        Q_EMIT frameShown();
    }
}

void WearPlayback::end()
{
    if (!run_) { return; }
    const double before = most();
    run_->live = false;
    held_ = {};
    if (!run_->frames.empty()) { run_->duration = run_->frames.back()->time; }
    if (most() != before) { Q_EMIT scaleChanged(); }
    Q_EMIT framesChanged();
}

void WearPlayback::clear()
{
    kept_.reset();
    discard();
}

void WearPlayback::discard()
{
    run_.reset();
    pair();
    current_ = -1;
    pin_ = {};
    Q_EMIT runChanged();
    Q_EMIT framesChanged();
}

void WearPlayback::keepAsA()
{
    if (!run_ || run_->live || run_->frames.empty()) { return; }
    kept_ = run_;
    pair();
    Q_EMIT runChanged();
}

void WearPlayback::dropA()
{
    kept_.reset();
    pair();
    Q_EMIT runChanged();
}

void WearPlayback::move(const QString& from, const QString& to)
{
    for (const auto& run : {run_, kept_}) {
        if (run && run->file == from) { run->file = to; }
    }
}

double WearPlayback::time() const
{
    const auto shown = frame();
    return shown ? shown->time : 0;
}

double WearPlayback::duration() const { return run_ ? run_->duration : 0; }

void WearPlayback::show(int frame)
{
    if (frame < 0 || frame >= frames()) { return; }
    follow_ = run_->live && frame == frames() - 1;
    current_ = frame;
    Q_EMIT frameShown();
}

std::shared_ptr<const WearFrame> WearPlayback::frame() const
{
    return current_ >= 0 && current_ < frames() ? run_->frames[static_cast<std::size_t>(current_)] : nullptr;
}

std::shared_ptr<const WearFrame> WearPlayback::keptFrame() const
{
    const int at = kept_ ? kept_->frameAt(time()) : -1;
    return at >= 0 ? kept_->frames[static_cast<std::size_t>(at)] : nullptr;
}

void WearPlayback::setValue(WearValue value)
{
    if (value == value_) { return; }
    value_ = value;
    Q_EMIT scaleChanged();
}

double WearPlayback::most() const
{
    if (ownSteps()) { return ownSteps()->back(); }
    if (const auto& set = most_[static_cast<std::size_t>(value_)]) { return *set; }
    const auto held = [this](const std::shared_ptr<WornRun>& run) {
        return !run ? 0 : value_ == WearValue::share ? run->most_share : run->most_water;
    };
    return std::max(held_[static_cast<std::size_t>(value_)], rounded_up(std::max(held(run_), held(kept_))));
}

/// Colours of one time can be compared with those of another while a run goes on.
void WearPlayback::holdScale(double time)
{
    if (!run_->live || !(run_->duration > 0)) { return; }
    const double passed = time / run_->duration;
    constexpr double least = 1e-3; // g/m2 and a share, from which on the next frames can be told
    const auto hold = [&](WearValue value, double most, double capacity) {
        double& end = held_[static_cast<std::size_t>(value)];
        if (!(most > least)) { return; }
        // After an early burst less is expected, of which low colours alone would tell little.
        const double expected = scaleEndOfRun(most, passed, capacity);
        if (most > end || expected < 0.5 * end) { end = expected; }
    };
    hold(WearValue::water, run_->most_water, mostCapacity(run_->layout()));
    hold(WearValue::share, run_->most_share, 1);
}

void WearPlayback::pair()
{
    places_ = run_ && kept_ ? samePlaces(*run_, *kept_) : std::vector<int>();
    most_difference_ = {};
    measured_ = 0;
}

std::vector<double> WearPlayback::difference() const
{
    const auto newest = frame(), kept = keptFrame();
    if (!newest || !kept) { return {}; }
    return differences(cellValues(run_->layout(), *newest, value_), cellValues(kept_->layout(), *kept, value_), places_);
}

/// Each frame once.
void WearPlayback::measureDifference() const
{
    for (; run_ && kept_ && measured_ < frames(); ++measured_) {
        const WearFrame& newest = *run_->frames[static_cast<std::size_t>(measured_)];
        const int at = kept_->frameAt(newest.time);
        if (at < 0) { continue; }
        for (const WearValue value : {WearValue::water, WearValue::share}) {
            double& most = most_difference_[static_cast<std::size_t>(value)];
            for (const double less :
                 differences(cellValues(run_->layout(), newest, value),
                             cellValues(kept_->layout(), *kept_->frames[static_cast<std::size_t>(at)], value), places_)) {
                if (std::abs(less) > most) { most = std::abs(less); }
            }
        }
    }
}

double WearPlayback::mostDifference() const
{
    measureDifference();
    return rounded_up(most_difference_[static_cast<std::size_t>(value_)]);
}

void WearPlayback::setMost(std::optional<double> most)
{
    most_[static_cast<std::size_t>(value_)] = most;
    Q_EMIT scaleChanged();
}

WearSteps WearPlayback::steps() const
{
    const double end = most();
    return ownSteps() ? *ownSteps() : even_steps(end > 0 ? end : 1);
}

void WearPlayback::setSteps(WearValue value, const std::optional<WearSteps>& steps)
{
    std::optional<WearSteps>& own = steps_[static_cast<std::size_t>(value)];
    if (own == steps) { return; }
    own = steps;
    Q_EMIT scaleChanged();
}

void WearPlayback::setPin(const GarmentSpot& spot)
{
    pin_ = spot;
    Q_EMIT pinChanged();
}

} // namespace hygroloom
