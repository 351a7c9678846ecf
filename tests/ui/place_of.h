// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Places of a project by their texts, as tests name them.
#pragma once

#include "core/design/place.h"

#include <QRegularExpression>
#include <QString>

namespace hygroloom {

inline Place placeOf(const QString& path)
{
    static const QRegularExpression step("([a-z_][a-z_0-9]*)|\\[(\\d+)\\]");
    Place place;
    for (auto each = step.globalMatch(path); each.hasNext();) {
        const auto match = each.next();
        place = match.captured(1).isEmpty() ? place / static_cast<std::size_t>(match.captured(2).toULong())
                                            : place / match.captured(1).toStdString();
    }
    return place;
}

} // namespace hygroloom
