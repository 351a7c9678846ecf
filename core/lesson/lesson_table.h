// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The cloths of a lesson side by side, simulated in threads of their own as time goes by, or slower; anybody may act on them meanwhile.
#pragma once

#include "core/lesson/running_cloth.h"

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace hygroloom {

/// The clock goes on as long as all cloths can follow; where they cannot, it waits for the slowest.
class LessonTable {
public:
    static constexpr double slow_motion = 0.1; ///< of real time

    /// Cloths are laid out one after the other by the threads: view() has none until then. 0 threads: one for each of the machine's.
    LessonTable(std::vector<LessonCloth> cloths, const Climate& air, int threads = 0);
    ~LessonTable();
    LessonTable(const LessonTable&) = delete;
    LessonTable& operator=(const LessonTable&) = delete;

    int cloths() const { return static_cast<int>(places_.size()); }
    /// Simulated time per real time; 0: it stands.
    void set_speed(double speed);
    /// s of simulated time, now.
    double clock();
    /// Simulated time per real time over the last second or so while the clock went; the speed where cloths follow.
    double pace();
    /// nullptr until the cloth is laid out.
    std::shared_ptr<const ClothView> view(int cloth);
    /// Why a cloth could not be laid out or went wrong, in a sentence; empty: all is well.
    std::string failure(int cloth);

    /// As of RunningCloth; done as soon as the cloth has come to its next look, also while the clock stands.
    void drop(int cloth, double x, double y, double volume);
    void blow(const Climate& air);
    void tilt(double degrees);
    void squeeze();
    /// What a recording has to hold; called in its thread as soon as it can be, also of a cloth that went wrong, and at the latest while
    /// the table goes. A cloth without a view has none.
    void record(int cloth, std::function<void(RecordedCloth)> take);

private:
    using Act = std::function<void(RunningCloth&)>;
    using Take = std::function<void(RecordedCloth)>;
    struct Place {
        LessonCloth cloth;
        std::unique_ptr<RunningCloth> running;
        std::shared_ptr<const ClothView> view;
        std::string failure;
        std::vector<Act> acts;
        std::vector<Take> takes; ///< recordings that were asked for
        double time = 0;         ///< s, reached
        bool busy = false;
    };

    void tell(Place& place, Act act);
    void tell_all(const Act& act);
    void go_on();
    Place* next_place();
    void work();
    void work_on(Place& place, const std::vector<Act>& acts, double until);
    static std::string serve(const Place& place, const std::vector<Take>& takes);

    std::mutex guard_;
    std::condition_variable changed_;
    std::vector<Place> places_;
    Climate air_;
    double speed_ = 1;
    double clock_ = 0; // s, simulated
    double pace_ = 1;
    double paced_ = 1; // the speed that the pace is of; more than 0
    std::chrono::steady_clock::time_point seen_ = std::chrono::steady_clock::now();
    std::atomic<bool> stop_{false};
    std::vector<std::thread> threads_; // the last member
};

} // namespace hygroloom
