// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/labels.h"

#include <utility>

namespace hygroloom {

Yarn without_labels(Yarn yarn)
{
    yarn.color.reset();
    yarn.price.reset();
    yarn.library_yarn.clear();
    return yarn;
}

Fabric without_labels(Fabric fabric)
{
    for (Yarn* yarn : yarns_of(fabric)) *yarn = without_labels(std::move(*yarn));
    return fabric;
}

Design without_labels(Design design)
{
    for (Fabric& fabric : design.fabrics) fabric = without_labels(std::move(fabric));
    return design;
}

} // namespace hygroloom
