// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A study of many points: which values of a project it changes, how it spreads its points over them, and what it runs at each.
#pragma once

#include "core/design/design.h"
#include "core/design/issue.h"
#include "core/plan/fidelity.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hygroloom {

/// What a factor is set to: a number, or a word as the name of a material is.
struct FactorValue {
    double number = 0;
    bool is_number = true;
    std::string text; ///< as --set takes it, and as the table shows it
    bool operator==(const FactorValue&) const = default;
};
/// With as many digits as it takes to read the same number again.
FactorValue factor_value(double number);
FactorValue factor_value(const std::string& word);

/// How a factor is spread where it has no list of values.
struct FactorDistribution {
    enum class Type { uniform, log_uniform, normal, lognormal, triangular };
    Type type = Type::uniform;
    double mean = 0, sd = 0;         ///< of normal and lognormal, of the value itself
    double mode = 0;                 ///< of triangular
    std::optional<double> low, high; ///< bounds; of normal and lognormal what lies beyond them is left out
    bool operator==(const FactorDistribution&) const = default;
};
const char* name_of(FactorDistribution::Type type);

/// One value of the project that a study changes.
struct Factor {
    std::string path;                ///< as --set takes it, also fidelity.<knob>
    std::vector<FactorValue> values; ///< a list; empty: it is distributed
    FactorDistribution distribution; ///< uniform for a range
    std::optional<double> step;      ///< of a range: only low, low + step, …
    std::optional<int> levels;       ///< on a grid and one at a time; none: as many as the design's points allow
    std::optional<FactorValue> base; ///< where others change one at a time; none: the project's own
    bool is_list() const { return !values.empty(); }
    bool operator==(const Factor&) const = default;
};

enum class Sampling { grid, latin_hypercube, sobol, one_at_a_time };
const char* name_of(Sampling sampling);

/// saltelli: points in the pattern that gives the indices by themselves. surrogate: from a surface fitted to any points.
enum class Sensitivity { none, saltelli, surrogate };

constexpr std::string_view knob_prefix = "fidelity."; ///< of a factor's path that is a knob
constexpr std::size_t most_study_rows = 1'000'000, most_study_factors = 100;

struct Study {
    /// By name; empty: the only one of the project. Of garments each fabric takes the place of all panels' own; empty: as they are.
    std::vector<std::string> fabrics, experiments;
    std::vector<Factor> factors;
    Sampling sampling = Sampling::latin_hypercube;
    std::size_t points = 0;                                ///< asked for; of a grid the most; 0 where the design says it by itself
    std::optional<Fidelity> fidelity = Fidelity::standard; ///< none: auto, the fastest within the error
    double error = 0;                                      ///< with auto, a fraction
    KnobSettings knobs;
    int replicates = 1;
    std::uint64_t seed = 1;
    std::vector<std::string> metrics; ///< keys; empty: what fabrics are compared by on the experiments
    Sensitivity sensitivity = Sensitivity::none;
    bool operator==(const Study&) const = default;
};

/// Reads and checks the form of a study: types, known keys, ranges. Throws FileError: file, field, what is allowed, what was given.
Study read_study(const std::filesystem::path& path);
/// The same from text; name stands for the file in messages.
Study parse_study(std::string_view text, const std::string& name);
/// What parse_study() reads again, two-space indent.
std::string format_study(const Study& study);
void write_study(const Study& study, const std::filesystem::path& path);

/// What does not go together with the project: names, paths, metrics, too many rows. `where` is a path into the study.
std::vector<Issue> validate(const Study& study, const Design& design);

/// Why a factor at a path can change no run of the study, as a sentence: it belongs to a fabric, an experiment, a fibre or a liquid that
/// the study does not run. Empty: it can. Throws Error where there is no such path. Precondition: the project has a fabric and an
/// experiment.
std::optional<Message> out_of_reach(const Study& study, const Design& design, const std::string& path);

/// Whether its experiments are of the type wear. Precondition: those that it names are there.
bool is_of_garments(const Study& study, const Design& design);

/// Those the study runs (an empty name: a garment's own fabrics), and the metrics it lists, with what was left out filled in. Precondition:
/// validate() found no error.
std::vector<std::string> fabrics_of(const Study& study, const Design& design);
std::vector<std::string> experiments_of(const Study& study, const Design& design);
std::vector<std::string> metrics_of(const Study& study, const Design& design);

} // namespace hygroloom
