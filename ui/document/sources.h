// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The files that a project names by their path from its own folder: patterns and meshes of garments, sweat rates, rates over time.
#pragma once

#include "core/design/design.h"

#include <QString>
#include <QStringList>

namespace hygroloom {

/// How a project in a folder names a file: by the path from there; in full without a folder, or where no path leads there.
QString sourceFrom(const QString& folder, const QString& file);

/// The same design in another folder: each file that it names from the one is named from the other. Neither folder need be there; without
/// the first nothing changes, without the second files are named in full. What is named in full stays so.
Design movedSources(Design design, const QString& from, const QString& to);

/// The folder from which a recorded design names its files: that of the recording, or the one above, as a project's runs lie; empty: its
/// files are in neither.
QString folderOfSources(const Design& recorded, const QString& recording);

/// Copies the files that a design names from a folder to the same places from another one. Returns those that it could not: gone, outside
/// of the folder, or in the place of another file, which stays; all, without the first folder.
QStringList copySources(const Design& design, const QString& from, const QString& to);

} // namespace hygroloom
