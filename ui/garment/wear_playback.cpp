// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/garment/wear_playback.h"

#include "core/base/round_up.h"
#include "core/wear/wear_outcomes.h"

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

WearPlayback::WearPlayback(QObject* parent) : ShownRun(parent)
{
    for (const auto signal : {&WearPlayback::scaleChanged, &WearPlayback::pinChanged}) {
        connect(this, signal, this, &ShownRun::metricsChanged);
    }
    connect(this, &ShownRun::framesChanged, this, &ShownRun::metricsChanged);
}

void WearPlayback::begin(const std::shared_ptr<WornRun>& run)
{
    stopOpening();
    take(run);
}

void WearPlayback::take(const std::shared_ptr<WornRun>& run)
{
    run_ = run;
    whole_ = false;
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

void WearPlayback::stopOpening() { ++opening_; }

void WearPlayback::open(const QString& path)
{
    reader_.run([this, path, opening = ++opening_](const NewestJob::Turn& turn) {
        const auto post = [this, opening](std::function<void()> work) {
            mail_.post([this, opening, work = std::move(work)] {
                if (opening == opening_) { work(); } // else another run has begun or is being opened
            });
        };
        try {
            const WearRecording file(path.toStdString());
            const auto run = newWornRun(std::make_shared<const WearRecord>(file.record()));
            run->file = path;
            run->wall = file.wall();
            post([this, run, path] {
                take(run);
                Q_EMIT opened(path);
            });
            WearMetrics metrics(run->layout());
            for (int k = 0; k < file.frames() && opening == opening_ && !turn.outdated(); ++k) {
                const auto frame = std::make_shared<const WearFrame>(file.frame(k));
                metrics.add(*frame);
                post([this, frame, most = mostWater(run->layout(), *frame), now = std::make_shared<const WearMetrics>(metrics)] {
                    append(frame, now, most);
                });
            }
            post([this] { setWhole(); });
        } catch (const std::exception& error) {
            post([this, sentence = QString::fromUtf8(error.what())] { Q_EMIT failed(sentence); });
        }
    });
}

void WearPlayback::end()
{
    if (!live()) { return; }
    const double before = most();
    run_->live = false;
    held_ = {};
    if (!run_->frames.empty()) { run_->duration = run_->frames.back()->time; }
    if (most() != before) { Q_EMIT scaleChanged(); }
    setWhole();
}

void WearPlayback::setWhole()
{
    whole_ = true;
    Q_EMIT framesChanged();
    Q_EMIT measured();
}

void WearPlayback::clear()
{
    kept_.reset();
    discard();
}

void WearPlayback::discard()
{
    stopOpening();
    run_.reset();
    pair();
    current_ = -1;
    pin_ = {};
    Q_EMIT runChanged();
    Q_EMIT framesChanged();
}

void WearPlayback::keepAsA()
{
    if (live() || frames() == 0) { return; }
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

/// The handle of a timeline moves on evenly while frames come.
int WearPlayback::expectedFrames() const
{
    const WearExperiment* wear = live() ? find_wear(run_->record->design, run_->layout().experiment) : nullptr;
    return wear ? std::max(frames(), static_cast<int>(wear_times(*wear).size())) : frames();
}

QList<QPointF> WearPlayback::curveOf(const WornRun& run) const
{
    QList<QPointF> points;
    const bool share = value_ == WearValue::share;
    if (pin_.panel >= 0) {
        const int cell = run_ ? run.lookup->at(sameSpot(run_->layout(), run.layout(), pin_)) : -1;
        if (cell < 0) { return points; }
        const GarmentCell& at = run.layout().cells[static_cast<std::size_t>(cell)];
        for (const auto& frame : run.frames) {
            const double water = frame->water(static_cast<std::size_t>(cell));
            points << QPointF(frame->time, share ? 100 * water / at.capacity : 1e3 * water / at.area);
        }
    } else if (run.metrics) {
        const WearPart& all = run.metrics->all();
        const WearNumber& number = wear_number(share ? "share_of_capacity" : "water_g_m2");
        for (const WearNow& now : all.course) {
            points << QPointF(now.time, shown(number.info, number.value({*run.metrics, all, now}).value_or(0)).value);
        }
    }
    return points;
}

std::vector<TimePlot> WearPlayback::plots() const
{
    const bool share = value_ == WearValue::share, pinned = pin_.panel >= 0;
    const QString about = pinned ? (share ? tr("Share of capacity at the pin") : tr("Water at the pin"))
                                 : (share ? tr("Share of the garment's capacity") : tr("Water in the garment"));
    TimePlot plot;
    plot.unit = share ? QStringLiteral("%") : tr("g/m²");
    plot.title = about + ", " + plot.unit;
    plot.lines.push_back({kept_ ? "B" : "", kept_ ? "B" : about, run_ ? curveOf(*run_) : QList<QPointF>()});
    if (kept_) { plot.lines.push_back({"A", "A", curveOf(*kept_)}); }
    return {plot};
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

bool isGarmentRecording(const QString& path) { return WearRecording::is_one(path.toStdString()); }

} // namespace hygroloom
