// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What is wrong with the words of a call, in sentences that say what to write; and the help on a verb.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace hygroloom {

/// What can be seen before the words are read: a verb or an option that does not exist, an empty text. Empty: nothing.
std::string fault_of(const CLI::App& app, const std::vector<std::string>& given);

/// Why the words of a call cannot be read. Empty where the library's own sentence says it.
std::string fault_of(const CLI::App& app, const CLI::ParseError& failure);

/// Where to read on: "See hygroloom-cli simulate --help."
std::string where_to_read(const CLI::App& app, const std::vector<std::string>& given);

/// Of the verb that the words name, or of the program.
std::string help_on(const CLI::App& app, const std::vector<std::string>& words);

} // namespace hygroloom
