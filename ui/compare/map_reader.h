// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The maps of compared runs at one time, with what their replicates add: read from recordings, away from the window's thread.
#pragma once

#include "core/analysis/replicate_range.h"
#include "ui/compare/recorded_frame.h"
#include "ui/results/water_map.h"

namespace hygroloom {

struct MapsRequest {
    std::vector<KeptRun> runs;         ///< of differences the baseline's is the last
    std::vector<Candidate> candidates; ///< of each run, with its replicates
    MapSide side = MapSide::top;
    double share = 1; ///< of the experiment's time
    bool differences = false;
};

struct MapsRead {
    std::vector<FaceMap> maps;                   ///< of each run
    std::vector<std::optional<MapRange>> ranges; ///< of its replicates, where they keep maps of this time
    std::vector<std::optional<PairedMap>> pairs; ///< of each run but the baseline, against it
    std::vector<Candidate> candidates;           ///< as asked for, with the maps of replicates that were recorded
    double share = 1;                            ///< that is shown: of differences of replicates the nearest of which they keep maps
};

/// outdated(): whether nobody waits for it any more. Throws Error.
MapsRead readMaps(MapsRequest request, const std::function<bool()>& outdated);

/// Number of the traced share that is nearest.
std::size_t nearestTraced(double share);

} // namespace hygroloom
