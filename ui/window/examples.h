// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Where the examples that ship with the program are.
#pragma once

#include <QString>

namespace hygroloom {

/// The folder of examples: of the source tree when running from the build, else of the installation; empty when there is none.
QString examplesFolder();
/// The example shown at the first start; one is built in. Empty when there is none.
QString shippedExample();

} // namespace hygroloom
