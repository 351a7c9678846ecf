// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/wear/garment_run.h"

#include "core/base/error.h"
#include "core/base/moment.h"
#include "core/run/presence.h"
#include "core/solver/backend.h"

#include <chrono>
#include <optional>

namespace hygroloom {

FinishedGarment run_garment(const GarmentParts& parts, const RunOptions& options, Backend& backend, RunControl& control,
                            const RunCallbacks& beside, const WornCallbacks& worn)
{
    const auto start = std::chrono::steady_clock::now();
    const Presence presence;
    const GarmentScene garment = garment_scene(parts, resolution_of(options));
    if (control.cancel) throw Cancelled();
    if (!garment.memory_is_short.empty() && beside.memory_is_short) beside.memory_is_short(garment.memory_is_short);
    backend.set_threads(options.threads);
    const auto record = std::make_shared<const WearRecord>(
        WearRecord{*parts.design, wear_layout(parts, garment), name_of(options.fidelity), backend.name(), backend.device(), date_now()});
    std::optional<WearWriter> recording;
    if (!options.recording.empty()) recording.emplace(options.recording, *record);
    WearPlan plan = plan_wear(garment, *parts.wear, options.fidelity);
    const GarmentTime estimated = plan.time;
    expect_as_learned(plan.time, backend.name());
    if (worn.planned) worn.planned(plan);
    if (worn.started) worn.started(record);
    const auto metrics = std::make_shared<WearMetrics>(record->layout);
    FinishedGarment finished{record, metrics, {}, parts.pattern.issues, 0, estimated, true, {}};
    WearCallbacks each;
    each.frame = [&](const std::shared_ptr<const WearFrame>& frame) {
        metrics->add(*frame);
        if (recording) recording->append(*frame);
        if (worn.frame) worn.frame(frame, *metrics);
        finished.last = frame;
    };
    each.progress = beside.progress;
    each.device_failed = [&](const std::string& sentence) {
        finished.device_failure = sentence;
        if (beside.device_failed) beside.device_failed(sentence);
    };
    each.device_changed = [&](const std::string& added) {
        if (recording) recording->note_device(record->device + added);
    };
    run_wear(garment, *parts.wear, backend, control, each, options);
    finished.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (recording) recording->finish(finished.wall);
    finished.fair = options.threads == 0 && presence.alone() && finished.device_failure.empty();
    return finished;
}

void learn_time(const FinishedGarment& finished)
{
    if (finished.fair) learn_time(finished.estimated, finished.wall, finished.record->backend, finished.record->device);
}

} // namespace hygroloom
