// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A number of the project in one row. Reading, writing, ranges, the schema, the parts of a fabric, forms and reports follow from it.
#pragma once

#include "core/base/trade_units.h"

#include <cstdlib>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <variant>

namespace hygroloom {

/// One of a few words in the project file.
template <typename Owner> struct FieldChoice {
    std::span<const char* const> words;
    int (*get)(const Owner&); ///< which of them; -1: none is given
    void (*set)(Owner&, int); ///< which of them
    bool is_optional = false;
};

/// What must be so that a number changes water.
enum class Need : unsigned {
    pores = 1U << 0U,          ///< the closure pores
    shape_by_twist = 1U << 1U, ///< a yarn whose section follows its twist
    shape_by_class = 1U << 2U, ///< a yarn that is not spun with a given diameter
    drops = 1U << 3U,          ///< drops that fall
    finish = 1U << 4U,         ///< a face with a finish of its own
    spot = 1U << 5U,           ///< a drop or a pool on a face
    vapour = 1U << 6U,         ///< parts of the physics
    sorption = 1U << 7U,
    heat = 1U << 8U,
    liquid = 1U << 9U,        ///< that comes to the cloth
    fibre_angle = 1U << 10U,  ///< contact angles that are those of fibres
    fibre_radius = 1U << 11U, ///< yarns without a count of filaments
    tortuosity = 1U << 12U,   ///< one that is not measured
};

/// All of some.
struct Needs {
    unsigned bits = 0;
    constexpr Needs() = default;
    constexpr Needs(Need need) : bits(static_cast<unsigned>(need)) {}
    constexpr Needs operator|(Needs other) const
    {
        other.bits |= bits;
        return other;
    }
    constexpr bool has(Need need) const { return (bits & static_cast<unsigned>(need)) != 0; }
};
constexpr Needs operator|(Need one, Need other) { return Needs(one) | other; }

/// An optional number that is not given follows from others. The unit is the key's, see stored_kind().
template <typename Owner> struct Field {
    using Value =
        std::variant<double Owner::*, std::optional<double> Owner::*, int Owner::*, std::optional<int> Owner::*, FieldChoice<Owner>>;

    const char* key; ///< in the project file
    Value value;
    const char* label; ///< "Twist": in forms, and in small letters in reports
    const char* title; ///< in sentences: "twist"; of choices empty
    double least = 0, most = 0;
    const char* help = "";                      ///< what it is, in whole sentences: forms and the schema say it
    const char* part = "";                      ///< which part of a fabric it belongs to, see fabric_parts()
    Needs needs = {};                           ///< it changes water only where all of them are so
    bool (*is_written)(const Owner&) = nullptr; ///< whether the project file names it where it is given; without it always

    bool is_number() const { return !std::holds_alternative<FieldChoice<Owner>>(value); }
    bool is_whole() const
    {
        return std::holds_alternative<int Owner::*>(value) || std::holds_alternative<std::optional<int> Owner::*>(value);
    }
    bool is_optional() const
    {
        if (const auto* choice = std::get_if<FieldChoice<Owner>>(&value)) return choice->is_optional;
        return std::holds_alternative<std::optional<double> Owner::*>(value) || std::holds_alternative<std::optional<int> Owner::*>(value);
    }
    Stored unit() const { return stored_kind(key); }
};

/// The rows of a kind of object, in the order of the project file.
template <typename Owner> std::span<const Field<Owner>> fields_of();

/// Precondition: there is such a row.
template <typename Owner> const Field<Owner>& field_named(std::string_view key)
{
    for (const Field<Owner>& field : fields_of<Owner>())
        if (field.key == key) return field;
    std::abort();
}

/// The number that an object has; of a choice, which of its words.
template <typename Owner> std::optional<double> field_value(const Field<Owner>& field, const Owner& owner)
{
    return std::visit(
        [&](const auto& value) -> std::optional<double> {
            if constexpr (std::is_same_v<std::decay_t<decltype(value)>, FieldChoice<Owner>>) {
                const int word = value.get(owner);
                return word < 0 ? std::nullopt : std::optional<double>(word);
            } else {
                return std::optional<double>(owner.*value);
            }
        },
        field.value);
}

/// Nothing takes back an optional number, and leaves another as it is. A whole number is cut off, a choice is one of its words by place.
template <typename Owner> void set_field(const Field<Owner>& field, Owner& owner, std::optional<double> number)
{
    std::visit(
        [&](const auto& value) {
            using Kind = std::decay_t<decltype(value)>;
            if constexpr (std::is_same_v<Kind, FieldChoice<Owner>>) {
                if (number || value.is_optional) value.set(owner, number ? static_cast<int>(*number) : -1);
            } else if constexpr (std::is_same_v<Kind, std::optional<double> Owner::*>) {
                owner.*value = number;
            } else if constexpr (std::is_same_v<Kind, std::optional<int> Owner::*>) {
                owner.*value = number ? std::optional(static_cast<int>(*number)) : std::nullopt;
            } else if constexpr (std::is_same_v<Kind, int Owner::*>) {
                if (number) owner.*value = static_cast<int>(*number);
            } else {
                if (number) owner.*value = *number;
            }
        },
        field.value);
}

} // namespace hygroloom
