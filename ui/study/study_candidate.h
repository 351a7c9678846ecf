// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A row of a study as a fabric of the project.
#pragma once

#include "ui/study/study_data.h"

namespace hygroloom {

class Document;

/// Adds the row's fabric with its factors' values as one step of the history, and chooses it. Returns what became of it, in sentences:
/// the fabric's name, and the factors that are no part of a fabric. Throws Error: the row makes no valid fabric.
QString makeCandidate(Document& document, const StudyData& data, std::size_t row);

} // namespace hygroloom
