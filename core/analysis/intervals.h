// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How sure a number is, from its numerical error and from replicates; and which of two fabrics is better, in words.
#pragma once

#include "core/analysis/outcomes.h"
#include "core/analysis/reader_units.h"
#include "core/base/student.h"

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace hygroloom {

/// Where a number lies. The parts are half widths of intervals of their own, in its unit; they add up as squares.
struct Interval {
    double centre = 0; ///< mean of the replicates
    double low = 0, high = 0;
    double numerical = 0;
    std::optional<double> scatter; ///< of cloths alike but for the seed
    std::optional<double> input;   ///< of what is not known of the cloth, by a linear fit
    std::optional<double> spread;  ///< of both together, where there are too few replicates to part them
    bool numerical_known = true;
    int runs = 1;
};

/// From a number's values in the replicates and where each unknown input lay in them (a row per replicate). numerical: its half width;
/// none: not known. The interval is where one more such cloth is expected: mean +- t s root(1 + 1/n), but not below least. Precondition:
/// one value at least.
Interval interval_of(const std::vector<double>& values, const std::vector<std::vector<double>>& places, std::optional<double> numerical,
                     double least = -std::numeric_limits<double>::infinity());

/// The least that a metric can be: 0 of most.
double least_of(const std::string& metric);

/// By how many standard deviations of its values an interval reaches to either side: of 2 replicates 7.7, of 3 3.4, of 4 2.6, of very many
/// 1.6. Precondition: 2 at least.
double half_width_in_deviations(int replicates);
/// Fewer give intervals that are mostly Student's factor, which hardly falls from here on (an assumption).
constexpr int fewest_useful_replicates = 4;
/// That these are too few, in a sentence; empty: they are not.
std::string few_replicates_text(int replicates);

/// Half width of a metric's numerical error in a run, in the metric's unit, from the measured runs of its kind; none: not known.
std::optional<double> numerical_error(const RunRecord& run, const std::string& metric, double value);

/// By which a number that says how far water has come jumps, as a segment is wet or not: a crossing, mm. 0 for others, also for the height
/// in a strip, which is read between crossings.
double step_of(const RunRecord& run, const std::string& metric);

/// Of all numbers of one run by key: their numerical parts alone.
std::map<std::string, Interval> numerical_intervals(const RunRecord& run, const Metrics& metrics);

/// An interval as people read it: the centre and its half width in the shown unit, with as many decimals as the half width gives sense.
struct ShownInterval {
    double value = 0, half = 0;
    double low = 0, high = 0;
    bool cut = false; ///< it ends at the least that the number can be, so that half of it is not on either side
    int decimals = 0; ///< of all; of an interval without width, those of four digits of the value
    std::string unit;
};
ShownInterval shown(const OutcomeInfo& info, const Interval& interval);
/// The same in a reader's unit.
ShownInterval in_unit(ShownInterval interval, const ReaderUnit& unit);

enum class Verdict { better, probably_better, no_difference, probably_worse, worse };
/// "probably better"
const char* name_of(Verdict verdict);

/// One number of a fabric against the baseline's.
struct Compared {
    std::string metric, fabric, baseline;
    Verdict verdict = Verdict::no_difference;
    double share_of_pairs = 0; ///< that favour the side of the mean difference by more than the numerical error
    double difference = 0;     ///< mean of the pairs, fabric less baseline
    double low = 0, high = 0;  ///< where the mean difference of the two fabrics lies, whatever their unknown inputs are
    int pairs = 0;
};

/// Pairs drawn with the same seed and the same places of the unknown inputs (a row per pair). The interval adds, as squares, the numerical
/// error, what the inputs do, and the error of the mean by scatter. Better, worse: it lies on one side. Probably: the mean differs from 0
/// by more than scatter and numerical error, and so do 80 % of the pairs. numerical: of the difference, half width. Precondition: as many
/// values of both, one at least; better is not neither.
Compared compare_pairs(const std::vector<double>& values, const std::vector<double>& baseline,
                       const std::vector<std::vector<double>>& places, double numerical, Better better);

} // namespace hygroloom
