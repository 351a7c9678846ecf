// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Text for the terminal: results on stdout, all else on stderr. Names from files cannot command the terminal.
#pragma once

#include <fmt/format.h>
#include <nlohmann/json_fwd.hpp>

#include <cstdio>
#include <string>

namespace hygroloom {

/// Closed streams are opened on nothing, so that no file that is opened later becomes one of them; a broken pipe ends no run by itself,
/// nor does a file that reaches the limit of the shell: that is an error as on a full disk.
void prepare_streams();

/// On stderr. What cannot be written there is dropped; it is no reason to stop.
void write_note(const std::string& text);
/// That stdout takes no more; ends the program. No error, as results_are_written() says it.
struct ResultsLost {};

/// On stdout. Throws ResultsLost.
void write_result(const std::string& text);
/// On stdout, indented. Throws ResultsLost.
void print_json(const nlohmann::ordered_json& json);
/// What was written so far is to be seen now.
void flush_results();
/// Whether stdout took all of the results. Says on stderr when not.
bool results_are_written();

template <typename... Values> void print_note(fmt::format_string<Values...> text, Values&&... values)
{
    write_note(fmt::format(text, std::forward<Values>(values)...));
}

template <typename... Values> void print_result(fmt::format_string<Values...> text, Values&&... values)
{
    write_result(fmt::format(text, std::forward<Values>(values)...));
}

/// A line on a terminal that takes the place of the one before; empty: none does.
void draw_line(const std::string& text);

} // namespace hygroloom
