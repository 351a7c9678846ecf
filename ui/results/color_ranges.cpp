// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/color_ranges.h"

#include "core/base/round_up.h"

namespace hygroloom {

std::optional<ValueRange> ColorRanges::of(ShownQuantity quantity) const
{
    const std::optional<ValueRange>& values = at(quantity).values;
    if (values && quantity == ShownQuantity::water) { return ValueRange{0, rounded_up(values->high)}; }
    return values;
}

double ColorRanges::mostWater() const
{
    const std::optional<ValueRange> water = of(ShownQuantity::water);
    return water ? water->high : 1;
}

void ColorRanges::widen(ShownQuantity quantity, const ValueRange& values)
{
    if (quantity == ShownQuantity::water && !(values.high > 0)) { return; } // dry cloth has no scale
    Known& known = known_[static_cast<std::size_t>(quantity)];
    const ValueRange wide = known.values ? united(*known.values, values) : values;
    if (known.values && wide == *known.values) { return; }
    if (known.values && kept_) {
        const ValueRange shown = *of(quantity);
        if (known.passed || (wide.low >= shown.low && wide.high <= shown.high)) { return; }
        known.passed = true;
    } else {
        known.values = wide;
    }
    Q_EMIT changed();
}

void ColorRanges::setKept(bool kept)
{
    if (kept == kept_) { return; }
    kept_ = kept;
    if (!kept) {
        for (Known& known : known_) { known.passed = false; }
        Q_EMIT fitWanted(); // what went beyond is told again
    }
    Q_EMIT changed();
}

void ColorRanges::fit()
{
    known_ = {};
    Q_EMIT fitWanted();
    Q_EMIT changed();
}

void ColorRanges::clear()
{
    known_ = {};
    kept_ = false;
    Q_EMIT changed();
}

QString legendTitle(const QString& quantity, const ColorRanges& ranges, ShownQuantity shown)
{
    if (!ranges.kept()) { return quantity; }
    return ranges.passed(shown) ? ColorRanges::tr("%1, kept ▲").arg(quantity) : ColorRanges::tr("%1, kept").arg(quantity);
}

} // namespace hygroloom
