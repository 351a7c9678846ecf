// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Sentences of core in the reader's language and units.
#pragma once

#include "core/design/issue.h"

#include <QString>

#include <vector>

namespace hygroloom {

/// Amounts whose unit the preferences choose have three digits.
QString messageText(const Message& message);

/// What an issue says, to be shown.
QString issueText(const Issue& issue);

/// What the first error says; empty: there is none.
QString firstError(const std::vector<Issue>& issues);

} // namespace hygroloom
