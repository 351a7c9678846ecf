// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Sentences of core, which speak in the units of files, as the reader reads them.
#pragma once

#include "core/design/issue.h"

#include <QString>

namespace hygroloom {

/// The sentence with its lengths (mm), setts (/cm) and counts (tex) in the units of the preferences, with three digits. What stands in
/// quotation marks is somebody's name, and stays.
QString inReadersUnits(const QString& sentence);

/// What an issue says, to be shown.
QString issueText(const Issue& issue);

} // namespace hygroloom
