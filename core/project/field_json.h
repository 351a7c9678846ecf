// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Rows of fields in the project's JSON.
#pragma once

#include "core/design/fields.h"
#include "core/project/json_reader.h"

#include <fmt/format.h>

namespace hygroloom {

/// A field that the object does not have stays as it is.
template <typename Owner> void read_field(ObjectReader& object, const Field<Owner>& field, Owner& owner)
{
    std::visit(
        [&](const auto& value) {
            if constexpr (std::is_same_v<std::decay_t<decltype(value)>, FieldChoice<Owner>>) {
                if (object.find(field.key)) value.set(owner, object.word(field.key, value.words));
            } else {
                object.read(field.key, owner.*value);
            }
        },
        field.value);
}
template <typename Owner> void read_fields(ObjectReader& object, Owner& owner)
{
    for (const Field<Owner>& field : fields_of<Owner>()) read_field(object, field, owner);
}

/// The field as the project file writes it. Precondition: it is given.
template <typename Owner> ProjectJson json_of_field(const Field<Owner>& field, const Owner& owner)
{
    const double number = *field_value(field, owner);
    if (const auto* choice = std::get_if<FieldChoice<Owner>>(&field.value)) return choice->words[static_cast<std::size_t>(number)];
    return field.is_whole() ? ProjectJson(static_cast<int>(number)) : ProjectJson(number);
}

/// Writes the fields that are given; of one that starts from another (a fibre of the library's) those that differ.
template <typename Owner> void write_fields(ProjectJson& json, const Owner& owner, const Owner* base = nullptr)
{
    for (const Field<Owner>& field : fields_of<Owner>()) {
        const std::optional<double> number = field_value(field, owner);
        if (!number || (base ? field_value(field, *base) == number : field.is_written && !field.is_written(owner))) continue;
        json[field.key] = json_of_field(field, owner);
    }
}
template <typename Owner> ProjectJson json_of_fields(const Owner& owner)
{
    ProjectJson json = ProjectJson::object();
    write_fields(json, owner);
    return json;
}

} // namespace hygroloom
