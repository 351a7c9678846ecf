// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The tests of a card that need a run: how each is done, and which of its numbers stand on the card.
#pragma once

#include "core/analysis/comparison.h"

namespace hygroloom {

struct CardTest {
    std::string key;       ///< as it is asked for: "drying"
    std::string title;     ///< "Drying"
    Experiment experiment; ///< of the same name as the key
};

/// The keys of all, in the order of a card.
const std::vector<std::string>& card_test_keys();
/// As the user lists them: keys, or "all" alone. Throws Error naming those there are.
std::vector<std::string> card_test_keys(const std::vector<std::string>& given);

/// How a test is done on the fabric. known: the card's numbers so far; a cloth that is to dry holds what it held when it had drained.
/// Throws Error where the cloth cannot be tested so. Precondition: card_test_keys() has the key.
CardTest card_test(const std::string& key, const Fabric& fabric, const std::vector<LaboratoryNumber>& known);

/// A test's numbers, or why there are none, behind those that are there. run: how it was run.
void add_test_numbers(LaboratoryNumbers& numbers, const CardTest& test, const Candidate& candidate, const std::string& run);
/// The numbers that add_test_numbers() gives, without values: what a table shows while the test is not done.
std::vector<LaboratoryNumber> unknown_numbers(const CardTest& test);

} // namespace hygroloom
