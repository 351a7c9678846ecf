// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The file beside a project's runs that holds the numbers of replicates, of which there are no recordings, with their curves and maps at
// few times.
#pragma once

#include "core/analysis/comparison.h"

#include <filesystem>

namespace hygroloom {

/// What the numbers of replicates follow from.
struct ReplicateKey {
    Design design; ///< what of the project the runs depend on, see part_of_run(); of a garment without the folders of its files
    std::string fabric, experiment;
    Fidelity fidelity = Fidelity::draft;
    std::uint64_t seed = 1;
    int of = 2; ///< how many there are
    bool operator==(const ReplicateKey&) const = default;
};

struct ReplicateSet {
    ReplicateKey key;
    std::vector<std::string> unknowns; ///< names of the inputs that were drawn
    std::map<int, ReplicateRun> runs;  ///< by number
};

/// The fabric, the experiment and its liquid, and all of the project's materials. Precondition: the design has both.
Design part_of_run(const Design& design, const std::string& fabric, const std::string& experiment);

constexpr int most_replicates = 1000;

std::string format_replicates(const std::vector<ReplicateSet>& sets);
/// Without the sets of a program with another answers_code: its numbers may differ. Trusts nothing in the text; name stands for the file.
/// Throws FileError: where, what is wrong, what is allowed.
std::vector<ReplicateSet> parse_replicates(std::string_view text, const std::string& name);
/// None where there is no file. Throws FileError.
std::vector<ReplicateSet> read_replicates(const std::filesystem::path& path);

/// The set of that key; nullptr: there is none.
const ReplicateSet* find_set(const std::vector<ReplicateSet>& sets, const ReplicateKey& key);
/// Adds what one has to the other, whose set then is the last; a run that both have is that of the other.
void merge(std::vector<ReplicateSet>& sets, const ReplicateSet& other);

/// More than this are of designs that nobody goes back to (an assumption); their numbers stay below 20 MB.
constexpr std::size_t most_kept_sets = 200, most_kept_runs = 20000;
/// Curves and maps take up to 100 kB a run (of a drop 15); of those before the last ones only the numbers are kept.
constexpr std::size_t most_kept_traces = 240;
void drop_older_traces(std::vector<ReplicateSet>& sets);

/// Without those of fabrics and experiments that the design lacks by name; of the others the last ones, up to the numbers above.
std::vector<ReplicateSet> without_leftovers(std::vector<ReplicateSet> sets, const Design& design);

} // namespace hygroloom
