// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A running scene, written once for every machine. An Executor offers Buffer<T>, for_each, for_each_line, and go_through() for what
// stages decide themselves: see LiquidFlow.
// Liquid and yarns meet at synchronisation points: the liquid takes its small steps up to one, then the yarns take one step.
#pragma once

#include "core/solver/free_liquid_exchange.h"
#include "core/solver/kept_state.h"
#include "core/solver/yarn_network_flow.h"
#include "core/solver/yarn_network_stock.h"
#include "core/solver/yarn_network_supply.h"
#include "core/solver/yarn_network_whole.h"

#include <array>
#include <chrono>

namespace hygroloom::inline HL_PRECISION {

template <typename Executor> class Solver {
public:
    Solver() = default;
    Solver(const Solver&) = delete;
    Solver& operator=(const Solver&) = delete;

    Executor& executor() { return exec_; }
    /// From now on what each stage takes is added up, which waits for each, and for frames too.
    void time_stages()
    {
        exec_.time_stages();
        if constexpr (requires { snapshot_.fetch_at_once(); }) snapshot_.fetch_at_once();
    }
    long liquid_steps() const { return static_cast<long>(liquid_.steps()); }
    long pressure_rounds() const { return static_cast<long>(liquid_.pressure_rounds()); }
    long listings() const { return static_cast<long>(liquid_.listings()); }
    int particles() const { return liquid_.count(); }
    int visited_segments() { return yarns_.visited_segments(); }

    void load(const Scene& scene)
    {
        check(scene);
        scene_ = scene;
        time_ = network_time_ = free_until_ = 0;
        sync_time_ = beside_ = -1;
        delivered_ = 0;
        yarns_.load(scene_);
        liquid_.load(scene_);
        const Stock stock = take_stock();
        snapshot_.fetch();
        const Ledger start = ledger_of(stock, scene_);
        initial_ = start.water_bound + start.water_vapour - scene_.cloth.start.bound;
        delivered_ = start.water_liquid + start.water_free + scene_.cloth.start.bound;
        initial_energy_ = start.energy_stored;
        yarns_.begin_anew(liquid_.is_about());
    }

    /// Towards until, for about the given wall time; what is reached never depends on where a call ends.
    double advance(double until, double wall_seconds)
    {
        const auto start = std::chrono::steady_clock::now();
        if (is_beside() && until != time_ && (until != beside_ || sync_time_ < 0)) come_back();
        while (until - time_ > rounding * until) {
            if (sync_time_ < 0) plan_step(until);
            const double stood = yarns_.seen_standing();
            const bool was_on_top = liquid_.is_on_top();
            if (liquid_.count() > 0) yarns_.expect_liquid();
            while (!liquid_.flow(time_, sync_time_, wall_seconds, yarns_.absorbed()))
                if (elapsed(start) > wall_seconds) return time_;
            time_ = sync_time_;
            yarns_.draw_from_particles(liquid_.offer(time_, yarns_.absorbed()));
            sync_time_ = -1;
            step_yarns(time_ - network_time_, is_beside() || meets_event_ || (!has_own_ends() && time_ >= until));
            note_standing(was_on_top, stood);
            network_time_ = time_;
            if (elapsed(start) > wall_seconds) break;
        }
        return until - time_ > rounding * until ? time_ : until;
    }

    Frame frame() { return frame_of(take_stock()); }
    /// What frame_of() needs to show how things are now. Stresses are summed anew from here on.
    Stock take_stock()
    {
        Stock stock;
        stock.time = time_;
        stock.initial = initial_;
        stock.initial_energy = initial_energy_;
        stock.delivered = delivered_;
        stock.free_until = free_until_;
        liquid_.take_stock(stock);
        yarns_.take_stock(stock);
        snapshot_.take([&](const auto& look_at) {
            yarns_.show(look_at, stock);
            liquid_.show(look_at, stock);
        });
        return stock;
    }
    /// May be called from another thread while advance() goes on, until stock is taken again.
    Frame frame_of(const Stock& stock)
    {
        snapshot_.fetch();
        return hygroloom::frame_of(stock, scene_);
    }

    /// All that the scene has come to, between calls of advance() that reached what they were asked for: at the last end of a step that is
    /// not there for a frame alone, to which the solver comes back.
    std::vector<std::byte> state()
    {
        if (is_beside()) come_back();
        StateSize size;
        pass_state(size);
        StateWriter writer(size.bytes());
        pass_state(writer);
        return writer.take();
    }
    /// After load() of the same scene, or of one with more parts on (see set_parts()), with more drops to come or with other air from then
    /// on, goes on from there. Throws Error if it is another one's.
    void go_on_from(const std::vector<std::byte>& state)
    {
        beside_ = -1;
        StateReader reader(state);
        pass_state(reader);
        yarns_.expect_liquid();
        if (yarns_.jumps_at(time_)) yarns_.begin_anew(liquid_.is_about());
    }
    /// See Backend.
    void stay() { beside_ = -1; }
    void squeeze(double share)
    {
        stay();
        yarns_.squeeze(share);
        yarns_.begin_anew(liquid_.is_about());
    }

private:
    static constexpr double rounding = 1e-9; ///< of a step's length, or of a time that is their sum
    static double elapsed(std::chrono::steady_clock::time_point start)
    {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
    /// After a step, by what was seen standing before it (kg, see YarnNetwork::seen_standing()), whose last part goes evenly within it.
    void note_standing(bool was_on_top, double stood)
    {
        const double stands = yarns_.seen_standing();
        if (was_on_top || liquid_.is_on_top() || yarns_.pool_was_fed() || stands > 0)
            free_until_ = time_;
        else if (stood > 0)
            free_until_ = network_time_ + (time_ - network_time_) * stood / (stood - stands);
    }
    /// Whether steps do not end where frames are taken.
    bool has_own_ends() const { return scene_.rules.step_share > 0; }
    /// Whether steps were left for a frame.
    bool is_beside() const { return beside_ >= 0; }
    void leave_for(double frame)
    {
        typename KeptState<Executor>::Keeper keeper(kept_);
        pass_state(keeper);
        beside_ = sync_time_ = frame;
    }
    void come_back()
    {
        beside_ = -1;
        typename KeptState<Executor>::Returner returner(kept_);
        pass_state(returner);
        yarns_.expect_liquid();
        liquid_.sum_stresses_from(time_);
    }
    /// Releases the drops that are due and chooses when liquid and yarns meet next.
    void plan_step(double until)
    {
        while (liquid_.next_drop() <= time_) {
            if (liquid_.rests()) yarns_.begin_anew(liquid_.is_about());
            delivered_ += liquid_.release_drop();
        }
        const double event = std::min(liquid_.next_drop(), yarns_.next_event(time_)), longest = yarns_.longest_step();
        double end = event;
        if (!has_own_ends()) {
            const double target = std::min(until, event), steps = LiquidRules::steps_to(target - time_, longest);
            end = steps == 1.0 ? target : time_ + (target - time_) / steps;
        } else if (event - time_ > longest * (1 + rounding)) {
            end = time_ + longest; // what comes is not felt before
        }
        meets_event_ = end == event;
        if (until < end)
            leave_for(until);
        else
            sync_time_ = end;
    }
    void step_yarns(double dt, bool frame_due)
    {
        yarns_.stand(liquid_.standing(time_));
        const NetworkStep step = yarns_.begin_step(time_, dt, frame_due, liquid_.is_about());
        liquid_.take_payment(yarns_.segments());
        bool wakes = false;
        if (yarns_.swells(step)) {
            const WaterGivenBack given = yarns_.swell(liquid_.least_given_back(), liquid_.room_for_given_back());
            wakes = liquid_.take_back(given, yarns_.segments(), time_);
        }
        yarns_.exchange(step);
        liquid_.evaporate(yarns_.evaporated_from_drops());
        yarns_.end_step(step, liquid_.is_about(), wakes, delivered_);
    }

    /// Writes or reads all that load() does not find in the scene and that the next step does not find anew.
    template <typename Archive> void pass_state(Archive& archive)
    {
        const auto numbers = [&](auto&... each) { (archive.value(each), ...); };
        numbers(time_, sync_time_, network_time_, delivered_, initial_, initial_energy_, free_until_);
        yarns_.pass_state(archive);
        liquid_.pass_state(archive);
        const std::array<bool, 4> own{scene_.rules.wicking, scene_.rules.sorption, scene_.rules.vapour, scene_.rules.heat};
        std::array<bool, 4> parts = own;
        archive.value(parts);
        if (parts != own) yarns_.change_parts(liquid_.is_about());
    }

    Executor exec_;
    KeptState<Executor> kept_{exec_};
    Scene scene_;
    YarnNetwork<Executor> yarns_{exec_};
    FreeLiquid<Executor> liquid_{exec_};
    typename Executor::Snapshot snapshot_;
    double time_ = 0, sync_time_ = -1, network_time_ = 0;     ///< s
    double beside_ = -1;                                      ///< s, the frame that steps were left for
    bool meets_event_ = false;                                ///< at the end of this step
    double delivered_ = 0, initial_ = 0, initial_energy_ = 0; ///< kg, kg, J
    double free_until_ = 0;                                   ///< s, when drops or pools last stood on the cloth
};

} // namespace hygroloom::inline HL_PRECISION
