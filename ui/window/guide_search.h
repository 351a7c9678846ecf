// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Which pages of the user's guide have a given text.
#pragma once

#include <QString>

#include <vector>

namespace hygroloom {

struct GuideHit {
    QString page;    ///< the name of a file in resources/help without its ending
    QString title;   ///< its first heading
    QString context; ///< the text round its first hit, in one line
    int hits = 0;    ///< at least 1
};

/// Pages that have the text, with its words in this order in one paragraph, in upper or lower case: first those whose title has it, then
/// those with the most hits. Spaces at its ends do not count.
std::vector<GuideHit> searchGuide(const QString& text);

} // namespace hygroloom
