// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Runs stages on the CPU's threads. Every stage writes only its own element or adds integers, so the number of threads
// cannot change a result.
#pragma once

#include "core/base/fork_join.h"
#include "core/solver/order.h"
#include "core/solver/stage_clock.h"
#include "core/solver/team.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <numeric>
#include <span>
#include <type_traits>
#include <vector>

namespace hygroloom {

class CpuExecutor {
public:
    /// An array where the stages run.
    template <typename T> class Buffer {
    public:
        void resize(std::size_t count) { values_.resize(count); }
        void fill(T value) { std::fill(values_.begin(), values_.end(), value); }
        void upload(const std::vector<T>& values) { values_ = values; }
        const std::vector<T>& download() const { return values_; } ///< to read before stages change it again
        T read(std::size_t index) const { return values_[index]; }
        void write(std::size_t index, T value) { values_[index] = value; }
        /// Overwrites part of the array, which must be long enough.
        void write_range(std::size_t first, const std::vector<T>& values)
        {
            std::copy(values.begin(), values.end(), values_.begin() + static_cast<std::ptrdiff_t>(first));
        }
        T* data() { return values_.data(); }
        const T* data() const { return values_.data(); }
        std::size_t size() const { return values_.size(); }
        void swap(Buffer& other) { values_.swap(other.values_); }

    private:
        std::vector<T> values_;
    };

    /// What a frame is made from. Here arrays are read where they are.
    class Snapshot {
    public:
        template <typename List> void take(const List& list)
        {
            list([]<typename T>(const Buffer<T>& array, std::size_t count) { return std::span<const T>(array.data(), count); });
        }
        void fetch() {}
    };

    void set_threads(int threads)
    {
        constexpr int all = tbb::task_arena::automatic;
        arena_ = std::make_unique<tbb::task_arena>(threads > 0 ? threads : all);
    }

    /// From now on what each stage takes is added up; not before.
    void time_stages() { stage_clock_ = std::make_unique<StageClock>(); }
    std::vector<StageTime> stage_times() const { return stage_clock_ ? stage_clock_->times() : std::vector<StageTime>(); }

    /// Calls stage(i) for 0 <= i < count and adds what it returns, if anything, to its total, if it has one; then next(0). A stage that can
    /// do more at once is called as stage(first, last). The name is for stage_times().
    template <typename Stage, typename Next = Nothing> void for_each(const char* name, int count, const Stage& stage, const Next& next = {})
    {
        const StageLap lap(stage_clock_.get(), name);
        constexpr int grain = 64;
        if (count <= grain)
            run_range(stage, 0, count);
        else
            in_ranges(count, grain, [&](int begin, int end) { run_range(stage, begin, end); });
        next(0);
    }
    template <typename Stage, typename Next = Nothing>
    void for_each(const char* name, const Counted& counted, const Stage& stage, const Next& next = {})
    {
        for_each(name, *counted.count, stage, next);
    }

    /// Calls stage(team, line) for 0 <= line < lines, none of more places than the longest.
    template <typename Stage> void for_each_line(const char* name, int lines, int longest, const Stage& stage)
    {
        const StageLap lap(stage_clock_.get(), name);
        constexpr int grain = 4;
        in_ranges(lines, grain, [&](int begin, int end) {
            const std::unique_ptr<double[]> room(
                new double[static_cast<std::size_t>(Alone::per_place<Stage>) * static_cast<std::size_t>(longest)]);
            go_along(stage, Alone(room.get(), longest), begin, end);
        });
    }

    /// Goes through the body as long as the flag is set.
    template <typename Body> void loop(const Flag* flag, const Body& body)
    {
        while (flag->on) body();
    }
    /// Goes through the body if the flag is set.
    template <typename Body> void when(const Flag* flag, const Body& body)
    {
        if (flag->on) body();
    }
    /// Goes through an order of stages that decide loops and branches; over at most this number of elements. Returns the seconds that took.
    template <typename Order> double go_through(const Order& order, int)
    {
        const auto start = std::chrono::steady_clock::now();
        order(*this);
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    /// Before the first sort; the most keys that there will be.
    void prepare_sort(int, int) {}
    /// The order in which keys (0 <= key <= largest), which a stage finds, rise, equal ones as they stand but for those of the largest:
    /// order[i] is the place of the i-th, and start[key] is where a key begins. start has room for three more.
    template <typename FindKey>
    void sort_into_cells(const FindKey& find_key, const int* key, int* order, int* start, const Counted& counted, const int* largest)
    {
        for_each("find cell", counted, find_key);
        const StageLap lap(stage_clock_.get(), "sort");
        const int count = *counted.count;
        int* next = start + 1; // of each key; in the end where the next key begins
        std::fill_n(start, *largest + 3, 0);
        for (int i = 0; i < count; ++i) ++next[key[i] + 1];
        std::partial_sum(next, next + *largest + 2, next);
        for (int i = 0; i < count; ++i) order[next[key[i]]++] = i;
    }

private:
    /// body(begin, end) for parts of 0 <= i < count on all threads.
    template <typename Body> void in_ranges(int count, int grain, const Body& body)
    {
        ForkJoin loop;
        arena_->execute([&] {
            tbb::parallel_for(tbb::blocked_range<int>(0, count, grain), [&](const tbb::blocked_range<int>& range) {
                const ForkJoin::Task task(loop);
                body(range.begin(), range.end());
            });
        });
    }
    template <typename Stage> static void go_along(const Stage& stage, const Alone& alone, int begin, int end)
    {
#ifdef __x86_64__
        if constexpr (is_wide_along_lines<Stage>) {
            static const bool has_wide = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
            if (has_wide) {
                go_along_wide(stage, alone, begin, end);
                return;
            }
        }
#endif
        for (int line = begin; line < end; ++line) stage(alone, line);
    }
    template <typename Stage> static void run_range(const Stage& stage, int begin, int end)
    {
        if constexpr (std::is_void_v<decltype(stage(0))>)
            sum_range(stage, begin, end);
        else if (const std::int64_t part = sum_range(stage, begin, end); part != 0 && stage.total != nullptr)
            atomic_add(stage.total, part);
    }
    template <typename Stage> static std::int64_t sum_range(const Stage& stage, int begin, int end)
    {
#ifdef __x86_64__
        // Sums over packs run several times as fast with whole packs in a register, and all stages with products added unrounded. With
        // AVX-512 there are twice as many registers, of the same width for floats: the results are the same. Asked for are all of a
        // target's flags, which the processor may have one without another, and the system may keep from programs.
        static const bool has_wide = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
        if constexpr (is_wide<Stage>) {
            static const bool has_many =
                has_wide && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq");
            if (has_many) return run_wide_with_many(stage, begin, end);
        }
        if (has_wide) return run_wide(stage, begin, end);
#endif
        return run_all(stage, begin, end);
    }
    /// Works on a copy of the stage, which nothing else can change meanwhile.
    template <typename Stage> static inline std::int64_t run_all(const Stage stage, int begin, int end)
    {
        std::int64_t sum = 0;
        constexpr bool adds = !std::is_void_v<decltype(stage(0))>;
        if constexpr (requires { stage(begin, end); }) {
            if constexpr (adds)
                sum = stage(begin, end);
            else
                stage(begin, end);
        } else {
            for (int i = begin; i < end; ++i) {
                if constexpr (adds)
                    sum += stage(i);
                else
                    stage(i);
            }
        }
        return sum;
    }
#ifdef __x86_64__
    template <typename Stage>
    __attribute__((target("avx2,fma"), flatten, noinline)) static void go_along_wide(const Stage stage, const Alone& alone, int begin,
                                                                                     int end)
    {
        for (int line = begin; line < end; ++line) stage(alone, line);
    }
    template <typename Stage>
    __attribute__((target("avx2,fma"), flatten, noinline)) static std::int64_t run_wide(const Stage& stage, int begin, int end)
    {
        return run_all(stage, begin, end);
    }
    template <typename Stage>
    __attribute__((target("avx2,fma,avx512f,avx512vl,avx512dq"), flatten, noinline)) static std::int64_t
    run_wide_with_many(const Stage& stage, int begin, int end)
    {
        return run_all(stage, begin, end);
    }
#endif

    std::unique_ptr<tbb::task_arena> arena_ = std::make_unique<tbb::task_arena>();
    std::unique_ptr<StageClock> stage_clock_; // none: nothing is timed
};

} // namespace hygroloom
