// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Where the examples that ship with the program are.
#pragma once

#include <QString>

namespace hygroloom {

/// The folder of examples: of the source tree when running from the build, else of the installation; empty when there is none.
QString examplesFolder();
/// Whether a project lies in the folder of an installation, where nothing of the user's is written: /usr/share or the like, or the examples
/// beside this program.
bool isInstalled(const QString& path);
/// The example shown at the first start; one is built in. Empty when there is none.
QString shippedExample();

} // namespace hygroloom
