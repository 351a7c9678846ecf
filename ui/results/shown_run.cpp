// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/shown_run.h"

#include <algorithm>

namespace hygroloom {

int ShownRun::frameAt(double time) const
{
    int first = 0, last = frames(); // between them lies the first frame after the time
    while (first < last) {
        const int middle = (first + last) / 2;
        if (timeOf(middle) <= time + 1e-9) {
            first = middle + 1;
        } else {
            last = middle;
        }
    }
    return frames() == 0 ? -1 : std::max(0, first - 1);
}

void ShownRun::show(int index)
{
    if (index < 0 || index >= frames()) { return; }
    follow_ = live() && index == frames() - 1;
    current_ = index;
    bring();
}

} // namespace hygroloom
