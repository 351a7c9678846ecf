// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A run of a worn garment as the window keeps it: what stays the same, its frames, its numbers.
#pragma once

#include "core/wear/wear_map.h"
#include "core/wear/wear_metrics.h"
#include "core/wear/wear_recording.h"
#include "core/wear/worn_candidate.h"
#include "ui/garment/garment_drawing.h"

namespace hygroloom {

/// The cell under a flat place, and the cell that each pixel of a panel's picture shows.
class CellLookup {
public:
    explicit CellLookup(const WearLayout& layout);
    /// The cell there, or next to there; -1: none.
    int at(const GarmentSpot& spot) const;
    /// Of a panel, ends x picks, a row for each pick; -1: nothing is shown.
    const std::vector<int>& pixels(std::size_t panel) const { return pixels_[panel]; }

private:
    const WearLayout& layout_;
    std::vector<std::vector<int>> pixels_;
};

/// What the colours say.
enum class WearValue { water, share };

/// The most that any cell holds.
struct MostWater {
    double areal = 0; ///< g/m2
    double share = 0; ///< of its capacity
};

struct WornRun {
    std::shared_ptr<const WearRecord> record;
    std::shared_ptr<const GarmentDrawing> drawing;
    std::shared_ptr<const CellLookup> lookup;
    std::vector<std::shared_ptr<const WearFrame>> frames;
    std::shared_ptr<const WearMetrics> metrics; ///< of all frames so far; nullptr before the first
    double most_water = 0;                      ///< g/m2, of any cell in any frame
    double most_share = 0;                      ///< of its capacity, the same
    double duration = 0;                        ///< s
    double wall = 0;                            ///< s, that it took; 0: it did not come to its end
    bool live = false;
    QString file; ///< its recording; empty: there is none

    const WearLayout& layout() const { return record->layout; }
    /// The last frame at or before a time; -1: none, or the run has ended before it.
    int frameAt(double time) const;
};

/// What it came to, for comparisons; nullptr where there is nothing.
std::shared_ptr<const Candidate> numbersOf(const WornRun& run);

/// From a run's record. The drawing and the lookup take a while.
std::shared_ptr<WornRun> newWornRun(std::shared_ptr<const WearRecord> record);

/// Of each cell: g/m2, or the share of its capacity. As wear_map() says of single cells.
std::vector<double> cellValues(const WearLayout& layout, const WearFrame& frame, WearValue what);
MostWater mostWater(const WearLayout& layout, const WearFrame& frame);

/// Which of the yarns runs down at a cell, in words: "warp", "weft", "bias, 38° from the warp", or that the cloth lies level.
QString directionWords(const WornRun& run, int cell);

/// How large the cells are, in the window's language; recordings say it in English.
QString cellsText(const std::string& cells_in_words);

/// Panels in the eight steps.
std::shared_ptr<const GarmentPaint> waterPaint(const WornRun& run, const std::vector<double>& values, const WearSteps& steps);
/// Panels in colours of less and more.
std::shared_ptr<const GarmentPaint> differencePaint(const WornRun& run, const std::vector<double>& values, double most);
/// A place of one garment as the place on the panel of that name in another; nowhere where that has none.
GarmentSpot sameSpot(const WearLayout& from, const WearLayout& to, const GarmentSpot& spot);
/// Of each cell of one run the cell of the other at the same place of the panel of that name; -1: there is none.
std::vector<int> samePlaces(const WornRun& one, const WornRun& other);
/// Of each cell its value less that of the other run at the same place; NaN where that has no cell.
std::vector<double> differences(const std::vector<double>& values, const std::vector<double>& others, const std::vector<int>& places);

} // namespace hygroloom
