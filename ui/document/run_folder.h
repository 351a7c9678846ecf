// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The folder beside a project that holds its runs: one recording each, numbered, and the list of those marked "keep".
#pragma once

#include <QString>
#include <QStringList>

#include <functional>

namespace hygroloom {

/// The one name of a folder that links reach by several.
QString oneSpelling(const QString& folder);
/// name.hygro-runs beside name.hygro, in one spelling.
QString runFolderOf(const QString& project);
/// The file in it with the numbers of replicates, which have no recording of their own.
QString replicatesIn(const QString& folder);
/// Recordings with content, by number.
QStringList recordingsIn(const QString& folder);
/// Whether anything lies there, also a recording that is just beginning.
bool holdsRuns(const QString& folder);
/// Removes what a window that is gone left of runs of which nothing was recorded; nobody may be writing there.
void clearEmptyRuns(const QString& folder);
/// The number in its name; 0 without.
int runNumber(const QString& recording);

/// Makes the folder, and in it an empty file under the next free number, so that nobody else takes the name. Throws Error.
QString reserveRun(const QString& folder);
/// Removes a reserved name that no run took, and the folder when nothing is left in it.
void releaseRun(const QString& recording);

/// Called with the share that is copied; false stops the copying.
using CopyStep = std::function<bool(double share)>;
/// A copy in place of the file there, which stays until the copy is complete. Throws Error; Cancelled where a step stops it.
void copyRecording(const QString& from, const QString& to, const CopyStep& step = {});

/// Puts a recording of another folder into this one under the next free number, with its mark. Returns its path there. Throws Error;
/// nothing is then changed.
enum class Bring { copy, move };
/// At once, by sharing its bytes; empty where the file system cannot.
QString linkRun(const QString& recording, const QString& folder, Bring how);
/// Copies what cannot share its bytes, which may take minutes.
QString bringRun(const QString& recording, const QString& folder, Bring how, const CopyStep& step = {});
/// Deletes a recording of a project and its mark. Throws Error.
void deleteRun(const QString& recording);

bool isMarked(const QString& recording);
/// Throws Error.
void setMarked(const QString& recording, bool marked);

} // namespace hygroloom
