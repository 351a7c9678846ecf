// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Goes through lines of comma-separated fields without copying what has no quotes in it.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace hygroloom {

/// Fields of a line, as RFC 4180 has them but for line breaks within.
class CsvRows {
public:
    explicit CsvRows(std::string_view text) : text_(text) {}

    /// Goes to the next line that ends; false: there is none. A last line that is torn is left out.
    bool next_line()
    {
        const std::size_t end = text_.find('\n');
        if (end == std::string_view::npos) return false;
        line_ = text_.substr(0, end);
        if (line_.ends_with('\r')) line_.remove_suffix(1);
        text_.remove_prefix(end + 1);
        ++number_;
        left_ = true;
        return true;
    }
    /// The next field of the line; none: it has no more. Valid until the next call.
    std::optional<std::string_view> next_field()
    {
        if (!left_) return std::nullopt;
        if (line_.starts_with('"')) return quoted();
        const std::size_t comma = line_.find(',');
        const std::string_view field = line_.substr(0, comma);
        go_on_after(comma);
        return field;
    }
    std::size_t line_number() const { return number_; } ///< from 1
    std::string_view line() const { return line_; }
    bool ends_whole() const { return text_.empty(); }

private:
    std::string_view quoted()
    {
        inside_.clear();
        std::size_t at = 1;
        for (; at < line_.size(); ++at) {
            if (line_[at] != '"') {
                inside_ += line_[at];
            } else if (at + 1 < line_.size() && line_[at + 1] == '"') {
                inside_ += line_[at++];
            } else {
                break;
            }
        }
        go_on_after(line_.find(',', at));
        return inside_;
    }
    void go_on_after(std::size_t comma)
    {
        left_ = comma != std::string_view::npos;
        line_.remove_prefix(left_ ? comma + 1 : line_.size());
    }

    std::string_view text_, line_;
    std::string inside_;
    std::size_t number_ = 0;
    bool left_ = false;
};

/// The number that a whole field is; none: it is not.
template <typename Number = double> std::optional<Number> number_of(std::string_view field)
{
    Number number{};
    const auto [end, failure] = std::from_chars(field.data(), field.data() + field.size(), number);
    if (failure != std::errc() || end != field.data() + field.size()) return std::nullopt;
    return number;
}

/// Words and the places that they were given.
class WordList {
public:
    std::uint32_t place_of(std::string_view word)
    {
        if (last_ < words_.size() && words_[last_] == word) return last_; // most repeat the one before
        const auto [at, fresh] = places_.try_emplace(std::string(word), static_cast<std::uint32_t>(words_.size()));
        if (fresh) words_.emplace_back(word);
        return last_ = at->second;
    }
    const std::vector<std::string>& words() const { return words_; }

private:
    std::vector<std::string> words_;
    std::unordered_map<std::string, std::uint32_t> places_;
    std::uint32_t last_ = 0;
};

} // namespace hygroloom
