// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/labels.h"

namespace hygroloom {

Yarn without_labels(Yarn yarn)
{
    yarn.color.reset();
    yarn.price.reset();
    yarn.library_yarn.clear();
    return yarn;
}

} // namespace hygroloom
