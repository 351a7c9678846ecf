// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A textile seen from above its top face, point by point: which yarn lies there, how high, and how its skin is inclined.
#pragma once

#include "core/geometry/textile.h"

namespace hygroloom {

/// What is seen at a point.
struct TopPoint {
    bool open = true; ///< no yarn lies there
    YarnKind kind = YarnKind::warp;
    int yarn = 0;          ///< of its system; that before the first and that after the last reach into the region, too
    double height = 0;     ///< m, over the middle plane
    Vec3d normal{0, 0, 1}; ///< unit; x along the weft, y along the warp
};

/// The region of a textile as columns x rows of points in the middles of as many equal fields, row 0 at the largest y. Of a region of whole
/// repeats the last column goes on in the first, and the last row in the first. Yarns are smooth tubes without loops and hairs.
class TopView {
public:
    /// Precondition: columns, rows >= 1.
    TopView(const Textile& textile, int columns, int rows);
    TopPoint at(int column, int row) const;

    double width() const { return width_; } ///< m
    double height() const { return height_; }

private:
    void look(TopPoint& seen, YarnKind kind, int yarn, const YarnPoint& tube, double x, double y) const;

    const Textile& textile_;
    int columns_, rows_;
    double width_, height_;
    std::vector<YarnPoint> warp_, weft_; ///< of each yarn and one more on each side, at each row, and at each column
};

} // namespace hygroloom
