// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/lesson/lesson_table.h"

#include "core/base/error.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

namespace hygroloom {
namespace {

constexpr double looks_per_second = 20; // of real time, at each cloth
constexpr double pace_settles = 0.5;    // s
constexpr double follows = 0.9;         // of the speed

} // namespace

LessonTable::LessonTable(std::vector<LessonCloth> cloths, const Climate& air, int threads) : air_(air)
{
    for (LessonCloth& cloth : cloths) {
        places_.emplace_back();
        places_.back().cloth = std::move(cloth);
    }
    const int wanted = std::clamp(threads > 0 ? threads : usable_threads(), 1, std::max(1, this->cloths()));
    for (int k = 0; k < wanted; ++k) threads_.emplace_back([this] { work(); });
}

LessonTable::~LessonTable()
{
    stop_ = true;
    changed_.notify_all();
    for (std::thread& thread : threads_) thread.join();
    for (const Place& place : places_) serve(place, place.takes);
}

void LessonTable::set_speed(double speed)
{
    const std::scoped_lock lock(guard_);
    go_on();
    speed_ = std::max(0.0, speed);
    if (speed_ > 0) {
        const double before = std::exchange(paced_, speed_);
        pace_ = pace_ >= follows * before ? pace_ * speed_ / before : std::min(pace_, speed_); // else as fast as it can
    }
    changed_.notify_all();
}

/// As far as the slowest cloth lets it. The guard is held.
void LessonTable::go_on()
{
    const auto now = std::chrono::steady_clock::now();
    const double passed = std::chrono::duration<double>(now - seen_).count();
    seen_ = now;
    const bool laid_out = std::all_of(places_.begin(), places_.end(), [](const Place& p) { return p.running || !p.failure.empty(); });
    if (!laid_out || speed_ <= 0) return;
    double slowest = clock_ + passed * speed_;
    for (const Place& place : places_)
        if (place.failure.empty()) slowest = std::min(slowest, place.time + 2 * speed_ / looks_per_second);
    const double gone = std::max(0.0, slowest - clock_);
    clock_ += gone;
    const double share = std::min(1.0, passed / pace_settles);
    if (passed > 0) pace_ += share * (gone / passed - pace_);
}

double LessonTable::clock()
{
    const std::scoped_lock lock(guard_);
    go_on();
    return clock_;
}

double LessonTable::pace()
{
    const std::scoped_lock lock(guard_);
    return pace_;
}

std::shared_ptr<const ClothView> LessonTable::view(int cloth)
{
    const std::scoped_lock lock(guard_);
    return places_.at(static_cast<std::size_t>(cloth)).view;
}

std::string LessonTable::failure(int cloth)
{
    const std::scoped_lock lock(guard_);
    return places_.at(static_cast<std::size_t>(cloth)).failure;
}

void LessonTable::tell(Place& place, Act act)
{
    if (place.failure.empty()) place.acts.push_back(std::move(act));
    changed_.notify_all();
}

void LessonTable::tell_all(const Act& act)
{
    const std::scoped_lock lock(guard_);
    for (Place& place : places_) tell(place, act);
}

void LessonTable::drop(int cloth, double x, double y, double volume)
{
    const std::scoped_lock lock(guard_);
    tell(places_.at(static_cast<std::size_t>(cloth)), [=](RunningCloth& running) { running.drop(x, y, volume); });
}

void LessonTable::blow(const Climate& air)
{
    tell_all([air](RunningCloth& running) { running.blow(air); });
}

void LessonTable::tilt(double degrees)
{
    tell_all([degrees](RunningCloth& running) { running.tilt(degrees); });
}

void LessonTable::squeeze()
{
    tell_all([](RunningCloth& running) { running.squeeze(); });
}

void LessonTable::record(int cloth, std::function<void(RecordedCloth)> take)
{
    const std::scoped_lock lock(guard_);
    places_.at(static_cast<std::size_t>(cloth)).takes.push_back(std::move(take));
    changed_.notify_all();
}

/// The one that is farthest behind and has something to do. The guard is held.
LessonTable::Place* LessonTable::next_place()
{
    Place* next = nullptr;
    for (Place& place : places_) {
        const bool goes_on = place.failure.empty() && (!place.running || !place.acts.empty() || place.time < clock_);
        const bool has_work = goes_on || (place.running && !place.takes.empty());
        if (place.busy || !has_work) continue;
        if (!next || (place.running && (!next->running ? false : place.time < next->time)) || (!place.running && next->running))
            next = &place;
    }
    return next;
}

void LessonTable::work()
{
    std::unique_lock lock(guard_);
    while (!stop_) {
        go_on();
        Place* place = next_place();
        if (!place) {
            changed_.wait_for(lock, std::chrono::milliseconds(4));
            continue;
        }
        place->busy = true;
        std::vector<Act> acts = std::move(place->acts);
        place->acts.clear();
        const std::vector<Take> takes = std::move(place->takes);
        place->takes.clear();
        const bool goes_on = place->failure.empty();
        const double until = place->time < clock_ ? std::max(clock_, place->time + speed_ / looks_per_second) : place->time;
        lock.unlock();
        if (goes_on) work_on(*place, acts, until);
        std::string problem = serve(*place, takes);
        lock.lock();
        if (place->failure.empty()) place->failure = std::move(problem);
        place->busy = false;
        changed_.notify_all();
    }
}

/// Without the guard, after the acts. What went wrong before a recording could be taken; who takes one says what came of it.
std::string LessonTable::serve(const Place& place, const std::vector<Take>& takes)
{
    if (!place.running) return {};
    try {
        for (const Take& take : takes) take(place.running->recorded());
    } catch (const std::bad_alloc&) {
        return "Not enough memory for a recording of this cloth.";
    } catch (const std::exception& error) {
        return error.what();
    }
    return {};
}

/// Without the guard; nobody else touches what runs while the place is busy.
void LessonTable::work_on(Place& place, const std::vector<Act>& acts, double until)
{
    std::shared_ptr<const ClothView> view;
    std::string failure;
    double time = 0;
    std::unique_ptr<RunningCloth> made;
    try {
        if (!place.running) made = std::make_unique<RunningCloth>(place.cloth.design, air_);
        RunningCloth& running = made ? *made : *place.running;
        for (const Act& act : acts) act(running);
        if (until > running.time()) running.advance(until, stop_);
        time = running.time();
        view = running.view();
    } catch (const std::bad_alloc&) {
        failure = "Not enough memory for this cloth.";
    } catch (const std::exception& error) {
        failure = error.what();
    }
    const std::scoped_lock lock(guard_);
    if (made) place.running = std::move(made);
    place.failure = failure;
    if (!failure.empty()) return;
    place.view = std::move(view);
    place.time = time;
}

} // namespace hygroloom
