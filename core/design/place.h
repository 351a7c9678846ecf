// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A place in a project or a study: "fabrics[0].warp.diameter_mm".
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace hygroloom {

class Place {
public:
    using Step = std::variant<std::string, std::size_t>; ///< a key, or which of a list

    Place() = default;
    Place(const char* key) : steps_{std::string(key)} {}

    Place operator/(std::string key) const { return and_then(std::move(key)); }
    Place operator/(const char* key) const { return and_then(std::string(key)); }
    Place operator/(std::size_t number) const { return and_then(number); }

    const std::vector<Step>& steps() const { return steps_; }
    /// The key there; empty where the place ends before, or has a number.
    std::string key(std::size_t step) const
    {
        const auto* key = step < steps_.size() ? std::get_if<std::string>(&steps_[step]) : nullptr;
        return key ? *key : std::string();
    }
    /// The number behind the key that stands at this step.
    std::optional<std::size_t> number(std::size_t step) const
    {
        const auto* number = step + 1 < steps_.size() ? std::get_if<std::size_t>(&steps_[step + 1]) : nullptr;
        return number ? std::optional(*number) : std::nullopt;
    }
    /// Whether it is that place or one within it.
    bool is_in(const Place& other) const
    {
        return steps_.size() >= other.steps_.size() &&
               std::vector(steps_.begin(), steps_.begin() + static_cast<std::ptrdiff_t>(other.steps_.size())) == other.steps_;
    }
    /// With another step in the place of one. Precondition: there is one.
    Place with(std::size_t at, Step step) const
    {
        Place place = *this;
        place.steps_.at(at) = std::move(step);
        return place;
    }
    bool operator==(const Place&) const = default;

    /// As files and the command line write it.
    std::string text() const
    {
        std::string text;
        for (const Step& step : steps_)
            if (const auto* number = std::get_if<std::size_t>(&step))
                text += "[" + std::to_string(*number) + "]";
            else
                text += (text.empty() ? "" : ".") + std::get<std::string>(step);
        return text;
    }

private:
    Place and_then(Step step) const
    {
        Place place = *this;
        place.steps_.push_back(std::move(step));
        return place;
    }

    std::vector<Step> steps_;
};

} // namespace hygroloom
