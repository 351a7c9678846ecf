// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/compare/map_reader.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

constexpr int crossings_per_cell = 2;

/// The first replicate is the recorded run, whose maps are in the recording alone.
void addRecordedMaps(Candidate& candidate, const KeptRun& run)
{
    if (candidate.replicates.size() < 2 || !candidate.replicates.front()) { return; }
    std::shared_ptr<const RunTrace>& trace = candidate.replicates.front()->trace;
    if (!trace || !trace->maps.empty()) { return; }
    RunTrace full = *trace;
    full.maps = traced_maps(recordingOf(run));
    trace = std::make_shared<const RunTrace>(std::move(full));
}

} // namespace

std::size_t nearestTraced(double share)
{
    const auto* nearest = std::min_element(std::begin(traced_shares), std::end(traced_shares),
                                           [share](double one, double other) { return std::abs(one - share) < std::abs(other - share); });
    return static_cast<std::size_t>(nearest - std::begin(traced_shares));
}

MapsRead readMaps(MapsRequest request, const std::function<bool()>& outdated)
{
    constexpr double half_a_step = 0.0026; // of the slider
    MapsRead read;
    read.share = request.share;
    const std::size_t at = nearestTraced(request.share), count = request.runs.size();
    for (std::size_t i = 0; i < count && !outdated(); ++i) { addRecordedMaps(request.candidates[i], request.runs[i]); }
    read.candidates = std::move(request.candidates);
    read.pairs.resize(count);
    read.ranges.resize(count);
    for (std::size_t i = 0; request.differences && i + 1 < count && !outdated(); ++i) {
        const MapError error = errorOfMaps(*request.runs[i].run, *request.runs.back().run, request.side);
        read.pairs[i] = paired_map(read.candidates[i], read.candidates.back(), request.side, at, error.share.value_or(0));
        if (read.pairs[i]) { read.share = traced_shares[at]; }
    }
    const bool traced = std::abs(read.share - traced_shares[at]) < half_a_step;
    for (std::size_t i = 0; i < count && !outdated(); ++i) {
        const Recording recording = recordingOf(request.runs[i]);
        const int frame = frameIndexAt(recording, read.share * durationOf(request.runs.front()));
        read.maps.push_back(faceMap(recording.run(), recording.frame(frame), recording.frame(0), request.side, crossings_per_cell));
        if (traced && !request.differences) { read.ranges[i] = map_range(read.candidates[i], request.side, at); }
    }
    return read;
}

} // namespace hygroloom
