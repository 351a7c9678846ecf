// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/garment/ears.h"

#include "core/garment/outline.h"

#include <algorithm>
#include <numeric>

namespace hygroloom {

namespace {

/// What is left of the outline while ears are cut off.
class Rest {
public:
    explicit Rest(const std::vector<FlatPlace>& outline) : outline_(outline), next_(outline.size()), before_(outline.size())
    {
        const int count = static_cast<int>(outline.size());
        FlatPlace least = outline[0], most = outline[0];
        for (int i = 0; i < count; ++i) {
            next_[i] = (i + 1) % count;
            before_[i] = (i + count - 1) % count;
            for (std::size_t axis = 0; axis < 2; ++axis) {
                least[axis] = std::min(least[axis], at(i)[axis]);
                most[axis] = std::max(most[axis], at(i)[axis]);
            }
        }
        const double width = most[0] - least[0], height = most[1] - least[1];
        thin_ = 1e-13 * (width * width + height * height);
        side_ = signed_area(outline) < 0 ? -1 : 1;
    }
    int next(int corner) const { return next_[corner]; }
    int before(int corner) const { return before_[corner]; }
    void cut(int corner)
    {
        next_[static_cast<std::size_t>(before(corner))] = next(corner);
        before_[static_cast<std::size_t>(next(corner))] = before(corner);
    }
    bool is_ear(int corner, std::size_t& work) const
    {
        const FlatPlace &a = at(before(corner)), &b = at(corner), &c = at(next(corner));
        if (!(area(a, b, c) > 0)) return false;
        for (int k = next(next(corner)); k != before(corner); k = next(k)) {
            if (work > 0) --work;
            const FlatPlace& p = at(k);
            if (p == a || p == b || p == c) continue; // the outline touches itself
            if (area(a, b, p) >= -thin_ && area(b, c, p) >= -thin_ && area(c, a, p) >= -thin_) return false;
        }
        return true;
    }

private:
    const FlatPlace& at(int corner) const { return outline_[corner]; }
    double area(const FlatPlace& a, const FlatPlace& b, const FlatPlace& c) const { return side_ * twice_area(a, b, c); }

    const std::vector<FlatPlace>& outline_;
    std::vector<int> next_, before_;
    double thin_ = 0; ///< area by which a place on the ear's side may seem to lie beyond it
    double side_ = 1;
};

} // namespace

bool cut_ears(const std::vector<FlatPlace>& outline, std::vector<std::array<int, 3>>& triangles, std::size_t& work)
{
    if (outline.size() < 3) return false;
    Rest rest(outline);
    int left = static_cast<int>(outline.size()), here = 0, tried = 0;
    while (left > 2) {
        if (tried > left || work == 0) return false;
        const int after = rest.next(here);
        if (!rest.is_ear(here, work)) {
            here = after;
            ++tried;
            continue;
        }
        triangles.push_back({rest.before(here), here, after});
        rest.cut(here);
        --left;
        tried = 0;
        here = rest.next(after); // not the next: fans would be thin
    }
    return true;
}

} // namespace hygroloom
