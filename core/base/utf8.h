// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Whether bytes are UTF-8, and texts of strangers made fit to be shown.
#pragma once

#include <string>
#include <string_view>

namespace hygroloom {

bool is_utf8(std::string_view text);

/// With the replacement character in the place of each byte that belongs to no character.
std::string in_whole_utf8(std::string_view bytes);

/// For a terminal: UTF-8, with the replacement character for what is no text, such as escape codes, or turns a text's direction. Line
/// breaks and tabs stay.
std::string printable(std::string_view bytes);

/// The same in one line: without line breaks.
std::string in_one_line(std::string_view bytes);

} // namespace hygroloom
