// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Which of the known words a misspelt one may have meant.
#pragma once

#include <string>
#include <vector>

namespace hygroloom {

/// The known word with the fewest letters to change, or empty when more than half of the letters, and more than two, would change.
std::string nearest_word(const std::string& word, const std::vector<std::string>& words);

} // namespace hygroloom
