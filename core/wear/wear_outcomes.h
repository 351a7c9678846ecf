// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a worn garment came to, as a list of numbers with their names and units, made from one table. The command line, files, reports,
// comparisons, studies, Python and the window read it.
#pragma once

#include "core/analysis/intervals.h"
#include "core/wear/wear_metrics.h"

namespace hygroloom {

/// A part of a garment at one moment.
struct WearAt {
    const WearMetrics& metrics;
    const WearPart& part;
    const WearNow& now;
};

/// What a number of a part is.
struct WearNumber {
    OutcomeInfo info; ///< without its part
    std::optional<double> (*value)(const WearAt& at);
    std::optional<int> decimals = {}; ///< in a table of parts; none: such a table leaves it out
    bool over_time = false;           ///< files have it of every frame
    bool of_whole_only = false;
    const char* missing = ""; ///< why there is no value, in a clause
};

/// In the order of files.
const std::vector<WearNumber>& wear_numbers();
/// Of that key. Precondition: there is one.
const WearNumber& wear_number(const std::string& key);
/// Of every frame so far, in the number's unit; NaN where there is none.
std::vector<double> course_of(const WearMetrics& metrics, const WearPart& part, const std::string& key);

/// At the last frame, of all parts: of the whole garment, of its panels, whose keys begin with "panels/front/", and of the zones of the
/// body with "zones/chest/". Precondition: there is a frame.
std::vector<Outcome> outcomes_of(const WearMetrics& metrics);
/// Of one part, with keys as they are.
std::vector<Outcome> outcomes_of(const WearMetrics& metrics, const WearPart& part);

/// Keys and curves of a part begin with its prefix: "" of the whole garment, "panels/front/", "zones/chest/".
struct WearPartName {
    std::string prefix, title; ///< title: "panel front"; of the whole garment empty
    bool operator==(const WearPartName&) const = default;
};
/// Of what a run of a garment gave, the whole first.
std::vector<WearPartName> parts_in(const std::vector<Outcome>& outcomes);
/// The numbers by which garments are compared, of the whole or of a part. The first ranks by default.
std::vector<OutcomeInfo> compared_by_wear(const WearPartName& part = {});
/// The numbers of which curves are kept, of the whole or of a part.
std::vector<OutcomeInfo> worn_curves(const WearPartName& part = {});
/// All of these of all parts, by key, at the times (s). Precondition: there is a frame.
std::map<std::string, std::vector<double>> courses_of(const WearMetrics& metrics, const std::vector<double>& times);

/// As `simulate --json` prints it. intervals: of replicates, by key; none: of one run, whose error is not known.
std::string wear_json(const WearMetrics& metrics, const std::map<std::string, Interval>& intervals = {});
/// A number as tables of parts print it, in the reader's unit: with the decimals of its column, and 0 without a sign. Precondition: the
/// number has decimals.
std::string text_in_table(const WearNumber& number, double value, const ReaderUnits& units = {});
/// A table for people: a row for each panel and zone.
std::string table_of_parts(const WearMetrics& metrics);

} // namespace hygroloom
