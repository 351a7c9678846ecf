// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The files that a project names by their path from its own folder: patterns and meshes of garments, sweat rates, rates over time.
#pragma once

#include "core/design/design.h"

#include <QString>

namespace hygroloom {

/// How a project in a folder names a file: by the path from there; in full without a folder, or where no path leads there.
QString sourceFrom(const QString& folder, const QString& file);

/// The same design in another folder: each file that it names from the one is named from the other. Neither folder need be there; without
/// the first nothing changes, without the second files are named in full. What is named in full stays so.
Design movedSources(Design design, const QString& from, const QString& to);

} // namespace hygroloom
