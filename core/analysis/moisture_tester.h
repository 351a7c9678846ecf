// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The moisture management tester as an instrument (AATCC 195): rings of pins on both faces, what they read of a frame, and the indices that
// follow from their readings (Yao et al. 2006). What is not public of the instrument is assumed and said: see tester_assumptions().
#pragma once

#include "core/analysis/management.h"
#include "core/scene/frame.h"
#include "core/scene/scene.h"

#include <array>
#include <string>

namespace hygroloom {

constexpr int tester_rings = 7;          ///< of each face: one in the middle, then one every ring_step
constexpr double ring_step = 5e-3;       ///< m
constexpr double ring_band = 1e-3;       ///< m, width of what a ring reads, inwards from it; an assumption
constexpr double sensor_depth = 0.15;    ///< of the thickness, from each face, to which the cones of its pins reach; an assumption
constexpr double wet_content = 5;        ///< % of the dry mass, above which a ring reads wet; an assumption
constexpr double tester_interval = 0.1;  ///< s, from sample to sample
constexpr double share_of_largest = 0.5; ///< of the rise within the feed, over which absorption is initial; an assumption

/// Water beyond that at the start in the band of each ring, % of the dry mass there of that face's yarns, both down to sensor_depth.
using RingContents = std::array<double, tester_rings>;

/// What both faces read at one time.
struct TesterReading {
    RingContents top{}, bottom{};
};

/// The pins over a cloth's middle: which segments each ring of each face reads.
class TesterPins {
public:
    TesterPins() = default;
    /// finishes: whether those of the faces act.
    TesterPins(const Textile& textile, bool finishes);

    /// Liquid in the pores and what the fibres took up since the start, of the segments on each face. Where a face has no finish the
    /// depth to which pins read changes nothing: a segment holds the same everywhere.
    TesterReading read(const Frame& frame, const std::vector<float>& regain_at_start) const;

private:
    struct Pin {
        std::size_t segment;
        int ring;
        bool on_top;
        double fibres; ///< kg, dry
        double liquid; ///< per dry mass down to sensor_depth, over that of the segment
    };
    std::vector<Pin> pins_;
    std::array<RingContents, 2> dry_{}; ///< kg, top and bottom
};

/// Content that a face shows: mean over its rings, each weighted with its own content; of rings that are alike their own, %.
double face_content(const RingContents& rings);

/// How the pump delivers the solution.
struct TesterFeed {
    double end = 0;           ///< s
    double drop_interval = 0; ///< s, from drop to drop; 0: it flows evenly
};

/// The test's indices. time in s, rising, one reading for each; between them readings change linearly. With fewer than two times all
/// indices are 0. A feed in drops says nothing of what happens between two of them: absorption rates are taken from contents that are
/// averaged over the last interval, to an interval after the pump stops, and rings that one drop reaches count with the way that it gained.
ManagementIndices tester_indices(const std::vector<double>& time, const std::vector<TesterReading>& readings, const TesterFeed& feed);

/// What the indices rest on that no public text of the method says, in sentences. drop: ul, 0 of a pool; frame_interval: s.
std::vector<std::string> tester_assumptions(double drop_ul, const TesterFeed& feed, double frame_interval);

} // namespace hygroloom
