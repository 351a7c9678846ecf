// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Where the colours of maps end: one range for each quantity of a project, whichever workspace shows it.
#pragma once

#include "core/scene/shown_quantity.h"

#include <QObject>

#include <array>
#include <optional>

namespace hygroloom {

/// A range grows to what is shown and never shrinks by itself, so that a colour means the same from one cloth to the next. Kept, it stays.
class ColorRanges : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    /// Of water, kg/m2, from 0 to a round number; of temperatures and humidities, K and shares. None: nothing was shown.
    std::optional<ValueRange> of(ShownQuantity quantity) const;
    /// The end of the water's; 1 where none was shown.
    double mostWater() const;
    /// A map shows values from low to high.
    void widen(ShownQuantity quantity, const ValueRange& values);
    void widenWater(double most) { widen(ShownQuantity::water, {0, most}); }

    bool kept() const { return kept_; }
    void setKept(bool kept);
    /// Whether maps show values beyond a range that is kept: those have its last colour.
    bool passed(ShownQuantity quantity) const { return at(quantity).passed; }
    /// Forgets the ranges; whoever is seen tells anew what it shows.
    void fit();
    /// Of another project.
    void clear();

Q_SIGNALS:
    void changed();
    void fitWanted();

private:
    struct Known {
        std::optional<ValueRange> values;
        bool passed = false;
    };
    const Known& at(ShownQuantity quantity) const { return known_[static_cast<std::size_t>(quantity)]; }

    std::array<Known, 3> known_;
    bool kept_ = false;
};

/// "Water", or "Water, kept" with a mark where a map goes beyond it.
QString legendTitle(const QString& quantity, const ColorRanges& ranges, ShownQuantity shown);

} // namespace hygroloom
