// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/looks.h"

#include "core/design/labels.h"

#include <string_view>
#include <utility>

namespace hygroloom {

bool is_look(const Field<Yarn>& row) { return row.part == std::string_view("look"); }

Yarn without_look(Yarn yarn)
{
    static const Yarn usual;
    for (const Field<Yarn>& row : fields_of<Yarn>())
        if (is_look(row)) set_field(row, yarn, field_value(row, usual));
    return without_labels(std::move(yarn));
}

Fabric without_look(Fabric fabric)
{
    for (Yarn* yarn : yarns_of(fabric)) *yarn = without_look(std::move(*yarn));
    return fabric;
}

Design without_look(Design design)
{
    for (Fabric& fabric : design.fabrics) fabric = without_look(std::move(fabric));
    return design;
}

} // namespace hygroloom
