// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/base/message.h"

#include <fmt/format.h>

namespace hygroloom {
namespace {

template <typename... T> struct Each : T... {
    using T::operator()...;
};
template <typename... T> Each(T...) -> Each<T...>;

std::string behind_number(Stored unit)
{
    const std::string_view word = unit_in_sentences(unit);
    return word.empty() ? "" : " " + std::string(word);
}

std::string shown(const Argument& argument, const std::string& format)
{
    return std::visit(Each{[](const std::string& text) { return text; }, [&](double number) { return formatted(number, format); },
                           [](long number) { return std::to_string(number); },
                           [&](const Amount& amount) { return formatted(amount.value, format) + behind_number(amount.unit); },
                           [&](const Bare& bare) { return formatted(bare.value, format); },
                           [&](const Between& range) {
                               return formatted(range.least, format) + " to " + formatted(range.most, format) + behind_number(range.unit);
                           },
                           [](const UnitAlone& alone) {
                               return std::string(trade_units(alone.unit).front().spellings.front().substr(alone.has_slash ? 0 : 1));
                           },
                           [](const Title& title) { return std::string(title.title); },
                           [](const Message& message) { return english(message); }},
                      argument.value);
}

} // namespace

bool Message::operator==(const Message& other) const { return english(*this) == english(other); }

std::string english(const Message& message) { return filled(message.text, message.arguments, shown); }

std::vector<std::string> english(const std::vector<Message>& messages)
{
    std::vector<std::string> texts;
    for (const Message& message : messages) texts.push_back(english(message));
    return texts;
}

std::string formatted(double number, const std::string& format) { return fmt::format(fmt::runtime(format), number); }

} // namespace hygroloom
