// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A calculated number in a label: short on the label, as it was computed where it is pointed at.
#pragma once

#include "ui/basics/quantity.h"

#include <QLabel>

#include <vector>

namespace hygroloom {

/// One value, or several that belong together: "0.12 × 0.135 mm". The label's own tip, which explains it, comes first.
inline void showNumbers(QLabel& label, const std::vector<double>& values, const QString& unit, const QString& between = " × ")
{
    constexpr char own_tip[] = "own tip";
    if (!label.property(own_tip).isValid()) { label.setProperty(own_tip, label.toolTip()); }
    QStringList shorts, fulls;
    const UserUnit user = userUnit(unit);
    for (const double value : values) {
        shorts << significant(value * user.per_one);
        fulls << inFull(value * user.per_one);
    }
    const QString behind = user.unit.isEmpty() ? QString() : QChar(0x00a0) + user.unit;
    label.setText(shorts.join(between) + behind);
    label.setToolTip(label.property(own_tip).toString() + "<p>" + (fulls.join(between) + behind).toHtmlEscaped() + "</p>");
}

} // namespace hygroloom
