// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What comparisons of fabrics and of garments share.
#pragma once

#include "app/cli_fidelity.h"

#include "core/analysis/comparison.h"

#include <filesystem>

namespace hygroloom {

struct CompareOptions : FidelityOptions {
    std::vector<std::string> others;  ///< further projects, of garments
    std::vector<std::string> fabrics; ///< as given
    std::string by;
    std::string output;
    std::string baseline;
    std::string report;
    std::string measured; ///< file
    std::string why;      ///< fabric; empty: no question
    bool card = false;    ///< the numbers of technical cards beside
    int replicates = 1;
    int at_once = 0;
    double cell_mm = 0; ///< of garments
};

/// Without runs: what is compared, and how. names: of the candidates. Throws Stop.
Comparison comparison_of(const CompareOptions& options, const std::string& experiment, std::vector<OutcomeInfo> criteria,
                         const std::vector<std::string>& names);
/// Rewrites the tables; after every run.
void write_numbers(const Comparison& comparison, const std::filesystem::path& folder);
/// Says how many of its runs a comparison that was cancelled has. The exit code.
int exit_code_of(const Comparison& comparison, std::size_t runs);

/// A garment cut from each fabric, or the garments of several projects. wear: of the first project.
int compare_garments(const CompareOptions& options, const Design& design, const WearExperiment& wear);

} // namespace hygroloom
