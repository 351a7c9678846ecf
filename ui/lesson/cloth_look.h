// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A cloth on the table from above: its weave in its colours, darker where it is wet.
#pragma once

#include "core/geometry/textile.h"
#include "core/scene/frame.h"

#include <QImage>

namespace hygroloom {

/// Share of a crossing's upper yarn that water covers, 0 .. 1.
std::vector<float> wetShares(const Textile& textile, const Frame& frame);

class ClothLook {
public:
    /// side: of its picture, in device pixels. The cloth may be a little smaller than the picture's last row and column.
    ClothLook(const Fabric& fabric, const Textile& textile, int side);

    int side() const { return dry_.width(); }
    /// As it was last.
    const QImage& now() const { return now_; }
    /// As it is at that frame; the first row is the last pick.
    const QImage& at(const Textile& textile, const Frame& frame);

private:
    QImage dry_, wet_, now_;
    std::vector<int> end_of_, pick_of_; ///< of each column, of each row
};

} // namespace hygroloom
