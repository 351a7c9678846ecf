// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Sentences of core in the reader's language and units.
#pragma once

#include "core/design/issue.h"

#include <QString>

namespace hygroloom {

/// Amounts whose unit the preferences choose have three digits.
QString messageText(const Message& message);

/// What an issue says, to be shown.
QString issueText(const Issue& issue);

} // namespace hygroloom
