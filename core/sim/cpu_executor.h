// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Runs stages on the CPU's threads. Every stage writes only its own element or adds integers, so the number of threads
// cannot change a result.
#pragma once

#include "core/base/portable.h"
#include "core/sim/stage_clock.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <memory>
#include <numeric>
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
        std::vector<T> download() const { return values_; }
        T read(std::size_t index) const { return values_[index]; }
        void write(std::size_t index, T value) { values_[index] = value; }
        /// Overwrites part of the array, which must be long enough.
        void write_range(std::size_t first, const std::vector<T>& values)
        {
            std::copy(values.begin(), values.end(), values_.begin() + static_cast<std::ptrdiff_t>(first));
        }
        T* data() { return values_.data(); }
        std::size_t size() const { return values_.size(); }
        void swap(Buffer& other) { values_.swap(other.values_); }

    private:
        std::vector<T> values_;
    };

    void set_threads(int threads)
    {
        constexpr int all = tbb::task_arena::automatic;
        arena_ = std::make_unique<tbb::task_arena>(threads > 0 ? threads : all);
    }

    /// From now on what each stage takes is added up; not before.
    void time_stages() { stage_clock_ = std::make_unique<StageClock>(); }
    std::vector<StageTime> stage_times() const { return stage_clock_ ? stage_clock_->times() : std::vector<StageTime>(); }

    /// Calls stage(i) for 0 <= i < count and returns the sum of what the stage returns, if anything; the name is for stage_times().
    template <typename Stage> std::int64_t for_each(const char* name, int count, const Stage& stage)
    {
        const StageLap lap(stage_clock_.get(), name);
        constexpr int grain = 64;
        if (count <= grain) return run_range(stage, 0, count);
        std::int64_t sum = 0;
        arena_->execute([&] {
            tbb::parallel_for(tbb::blocked_range<int>(0, count, grain), [&](const tbb::blocked_range<int>& range) {
                const std::int64_t part = run_range(stage, range.begin(), range.end());
                if (part != 0) atomic_add(&sum, part);
            });
        });
        return sum;
    }

    /// Sorts keys (0 <= key <= largest) keeping equal ones in order; order[i] is where the new i-th came from.
    void sort_by_key(Buffer<int>& keys, Buffer<int>& order, int count, int largest)
    {
        const StageLap lap(stage_clock_.get(), "sort");
        places_.assign(static_cast<std::size_t>(largest) + 2, 0);
        for (int i = 0; i < count; ++i) ++places_[static_cast<std::size_t>(keys.data()[i]) + 1];
        std::partial_sum(places_.begin(), places_.end(), places_.begin());
        sorted_.resize(static_cast<std::size_t>(count));
        for (int i = 0; i < count; ++i) {
            const int place = places_[static_cast<std::size_t>(keys.data()[i])]++;
            order.data()[place] = i;
            sorted_[static_cast<std::size_t>(place)] = keys.data()[i];
        }
        std::copy(sorted_.begin(), sorted_.end(), keys.data());
    }

private:
    template <typename Stage> static std::int64_t run_range(const Stage& stage, int begin, int end)
    {
#ifdef __x86_64__
        // Stages that work on packs say so; they run several times as fast with whole packs in a register, to the same last bit.
        if constexpr (requires { Stage::wide; }) {
            static const bool has_wide = __builtin_cpu_supports("avx2");
            if (has_wide) return run_wide(stage, begin, end);
        }
#endif
        return run_all(stage, begin, end);
    }
    /// Works on a copy of the stage, which nothing else can change meanwhile.
    template <typename Stage> static inline std::int64_t run_all(const Stage stage, int begin, int end)
    {
        std::int64_t sum = 0;
        for (int i = begin; i < end; ++i) {
            if constexpr (std::is_void_v<decltype(stage(i))>)
                stage(i);
            else
                sum += stage(i);
        }
        return sum;
    }
#ifdef __x86_64__
    template <typename Stage>
    __attribute__((target("avx2"), flatten, noinline)) static std::int64_t run_wide(const Stage& stage, int begin, int end)
    {
        return run_all(stage, begin, end);
    }
#endif

    std::unique_ptr<tbb::task_arena> arena_ = std::make_unique<tbb::task_arena>();
    std::unique_ptr<StageClock> stage_clock_; // none: nothing is timed
    std::vector<int> places_, sorted_;
};

} // namespace hygroloom
