// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Why one fabric is better than another: how much of the difference of a number each of the inputs that differ makes. Fabrics that have
// some parts of the one and some of the other (mixtures) are run for it.
#pragma once

#include "core/analysis/comparison.h"
#include "core/analysis/page.h"
#include "core/design/fabric_parts.h"

#include <cstdint>
#include <functional>

namespace hygroloom {

/// Which parts are the other fabric's: bit i stands for part i of a plan. 0 is the fabric itself.
using Mixture = std::uint32_t;

/// Parts of two fabrics that are exchanged together: one, or several that do not fit without each other.
struct Exchange {
    std::string title; ///< "warp sett and warp count"
    std::string first, second;
    std::vector<const PartField*> fields;
    bool several = false;
};

/// More parts are exchanged one at a time: all mixtures of n parts are 2^n.
constexpr std::size_t most_parts_in_all_orders = 4;

struct WhyPlan {
    std::string fabric, against, experiment;
    std::vector<Exchange> parts;   ///< that differ; none: the fabrics are alike
    bool all_orders = true;        ///< else one at a time, in either fabric
    std::vector<Mixture> mixtures; ///< to be run beside the two fabrics
    std::vector<std::string> notes;
};

/// units: of the inputs in its texts. Parts whose exchange alone is refused by validate() are joined with the part that makes it sound.
/// Precondition: validate() found no error, the design has both fabrics and the experiment.
WhyPlan plan_why(const Design& design, const std::string& fabric, const std::string& against, const std::string& experiment,
                 bool replicates, const ReaderUnits& units = {});

/// The mixture under the fabric's name, alone with the experiment.
Design mixed(const Design& design, const WhyPlan& plan, Mixture mixture);

/// What one part makes.
struct Contribution {
    std::string title, first, second;
    std::vector<std::string> keys; ///< of the project file, that differ
    bool several = false;
    Compared compared; ///< difference: fabric less the other; better: in favour of the fabric
    /// Of exchanging it alone in the fabric, and in the other fabric, likewise fabric less other; none: it shows nothing there.
    std::optional<Compared> alone_in_fabric, alone_in_other;
};

struct Why {
    std::string fabric, against;
    OutcomeInfo metric;
    int replicates = 1;
    bool all_orders = true;
    int fabrics = 2;               ///< that were run, the two among them
    std::optional<Compared> whole; ///< none: the numbers do not allow it
    std::string nothing;           ///< why there are no contributions, in a sentence, see nothing_of(); empty: there are
    bool not_shown = false;        ///< that is because the whole difference is none that shows
    std::vector<Contribution> parts;
    std::optional<Compared> together; ///< what the parts do beyond each by itself; none: the contributions hold it
    std::vector<std::string> notes;
};

/// Each part's share of value(0) - value(all parts). In all orders: Shapley's (1953), which add up to it. One at a time: the mean of the
/// exchange in the fabric and in the other; what is left is what the parts do together.
std::vector<double> contributions_of(std::size_t parts, bool all_orders, const std::function<double(Mixture)>& value);

/// Without contributions, from the runs of the two fabrics alone: whether there is anything to explain.
Why why_of(const WhyPlan& plan, const OutcomeInfo& metric, const Candidate& fabric, const Candidate& against, int replicates);

/// With contributions, from the runs of all mixtures of the plan. Replicates in which one of the runs has no such number are left out. A
/// contribution's numerical error is the mean of those of the differences it consists of, as compared() has them; that of what the parts do
/// together adds all as squares, as if they were independent (an assumption).
Why explain(const WhyPlan& plan, const OutcomeInfo& metric, const Candidate& fabric, const Candidate& against,
            const std::map<Mixture, Candidate>& mixtures, int replicates);

// Contributions are in the reader's units, inputs as the plan has them.
/// "-0.10 ± 0.02 s"
std::string with_unit(const OutcomeInfo& metric, const Compared& compared, const ReaderUnits& units = {});
/// Whether two fabrics differ, in a sentence.
std::string heading_of(const Why& why, const ReaderUnits& units = {});
/// Why there are no contributions, in a sentence; empty: there are.
std::string nothing_of(const Why& why, const ReaderUnits& units = {});
/// One for each contribution, in words, the largest first; then what they rest on.
std::vector<std::string> sentences_of(const Why& why, const ReaderUnits& units = {});
/// "makes it 0.10 ± 0.02 s shorter, which is better"; "has no effect that this simulation can show (…)"
std::string in_words(const Why& why, const Compared& compared, bool plural = false, const ReaderUnits& units = {});
/// "makes it shorter, better"; "no effect shown"
std::string effect_words(const OutcomeInfo& metric, const Compared& compared);

/// A row of the table: a contribution, what the parts do together, the whole difference.
struct WhyLine {
    std::string title, first, second;
    const Compared* compared = nullptr; ///< in the Why
    bool whole = false;
};
/// The largest contribution first. Precondition: why.nothing is empty. They point into the why.
std::vector<WhyLine> lines_of(const Why& why);

/// A table, then the sentences.
std::string why_text(const Why& why);
/// With bars, for a report.
PageBlocks why_blocks(const Why& why, const ReaderUnits& units = {});

} // namespace hygroloom
