// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/compare/recorded_frame.h"

#include "core/base/error.h"

#include <algorithm>

namespace hygroloom {

namespace {

bool isSameRun(const RunRecord& one, const RunRecord& other)
{
    return one.fabric == other.fabric && one.experiment == other.experiment && one.date == other.date &&
           one.textile.ends() == other.textile.ends() && one.textile.picks() == other.textile.picks();
}

} // namespace

Recording recordingOf(const KeptRun& run)
{
    Recording recording(run.path.toStdString());
    if (recording.frames() == 0 || !isSameRun(recording.run(), *run.run)) {
        throw Error(
            RunHistory::tr("The recording %1 holds another run now. Open it again to compare that run.").arg(run.path).toStdString());
    }
    return recording;
}

int frameIndexAt(const Recording& recording, double time)
{
    const auto& ledgers = recording.ledgers();
    const auto after = std::find_if(ledgers.begin(), ledgers.end(), [time](const Ledger& l) { return l.time > time + 1e-9; });
    return std::clamp(static_cast<int>(after - ledgers.begin()) - 1, 0, recording.frames() - 1);
}

double durationOf(const KeptRun& run)
{
    const Experiment* experiment = find_experiment(run.run->design, run.run->experiment);
    const WearExperiment* wear = find_wear(run.run->design, run.run->experiment);
    return experiment ? experiment->duration_s : wear ? wear->duration_s : 0;
}

} // namespace hygroloom
