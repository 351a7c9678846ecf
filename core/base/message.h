// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A sentence with its arguments, so that the window can say it in the reader's language and units.
#pragma once

#include "core/base/trade_units.h"

#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace hygroloom {

/// A number in the stored unit of its kind, with the unit behind it: "0.2 mm".
struct Amount {
    double value = 0;
    Stored unit = Stored::number;
};
/// A number whose unit the sentence says elsewhere.
struct Bare {
    double value = 0;
    Stored unit = Stored::number;
};
/// "0.1 to 2000 mm"
struct Between {
    double least = 0, most = 0;
    Stored unit = Stored::number;
};
/// "/cm", or behind "per" the "cm" of it.
struct UnitAlone {
    Stored unit = Stored::number;
    bool has_slash = true;
};
/// A number's name: see Field.
struct Title {
    const char* title;
    const char* label;
    Stored unit = Stored::number;
};

struct Argument;

/// text is English, and the name by which translations find the sentence. A gap is {} or {:.3g}, as of fmt; a translation may say which
/// argument stands there: {1:.3g}.
struct Message {
    std::string text;
    std::vector<Argument> arguments;

    bool operator==(const Message& other) const;
};

struct Argument {
    std::variant<std::string, double, long, Amount, Bare, Between, UnitAlone, Title, Message> value;

    Argument(std::string text) : value(std::move(text)) {}
    Argument(const char* text) : value(std::string(text)) {}
    Argument(double number) : value(number) {}
    Argument(int number) : value(long{number}) {}
    Argument(std::size_t number) : value(static_cast<long>(number)) {}
    template <typename T>
    requires std::is_class_v<T> Argument(T other) : value(std::move(other)) {}
};

/// A sentence whose gaps are counted where it is compiled.
template <std::size_t count> struct Sentence {
    const char* text;
    consteval Sentence(const char* said) : text(said)
    {
        std::size_t gaps = 0;
        for (const char* c = said; *c != '\0'; ++c) gaps += *c == '{' ? 1 : 0;
        if (gaps != count) throw "the sentence has another number of gaps";
    }
};
template <typename... A> Message say(Sentence<sizeof...(A)> sentence, A... arguments)
{
    return {sentence.text, {Argument(std::move(arguments))...}};
}

/// What somebody else said, which has no translation.
inline Message quote(std::string text) { return {"{}", {Argument(std::move(text))}}; }

/// The sentence with its gaps filled. shown(argument, format): what stands in a gap; format: "{:.3g}".
template <typename Shown> std::string filled(std::string_view sentence, const std::vector<Argument>& arguments, Shown shown)
{
    std::string text;
    std::size_t next = 0;
    for (std::size_t gap; (gap = sentence.find('{')) != std::string_view::npos;) {
        const std::string_view inside = sentence.substr(gap + 1, sentence.find('}', gap) - gap - 1);
        const std::size_t colon = inside.find(':');
        std::size_t number = next;
        std::from_chars(inside.data(), inside.data() + inside.size(), number);
        text += sentence.substr(0, gap);
        if (number < arguments.size())
            text += shown(arguments[number], colon == std::string_view::npos ? "{}" : "{" + std::string(inside.substr(colon)) + "}");
        next = number + 1;
        sentence.remove_prefix(gap + inside.size() + 2);
    }
    return text + std::string(sentence);
}

/// In English, in the units of files.
std::string english(const Message& message);
std::vector<std::string> english(const std::vector<Message>& messages);

/// A number in one of those formats.
std::string formatted(double number, const std::string& format);

} // namespace hygroloom
