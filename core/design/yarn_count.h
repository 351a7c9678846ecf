// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Yarn counts as the trade writes them: "Ne 60/2", "2/60 Nm", "150/48 den", "14.8 tex × 2".
#pragma once

#include "core/base/error.h"
#include "core/design/yarn.h"

#include <string>
#include <string_view>

namespace hygroloom {

/// Ne and Nm grow as yarns become finer; the others are masses of a length.
enum class CountSystem { tex, ne, nm, denier, dtex };

struct YarnCount {
    double single_tex = 0;        ///< of each single yarn
    int plies = 1;                ///< a count that says nothing of plies is that of a single yarn
    std::optional<int> filaments; ///< of each single yarn, where the text names them

    double tex() const { return single_tex * plies; } ///< of the whole yarn
};

/// A text that is no count. reason: why, as the middle of a sentence; one of few fixed ones, so that it can be translated.
struct CountError : Error {
    CountError(const std::string& sentence, std::string why) : Error(sentence), reason(std::move(why)) {}
    std::string reason;
};

/// Reads a count. Without regard to capitals and blanks; decimals with point or comma; plies after "x", "×" or "*".
/// - "Ne 60/2", "60/2", "2/60 Nm", "60s/2": the smaller number is that of the plies; without a system it is Ne, as in the trade.
/// - "150/48 den", "75D/36F", "167 dtex f48 x 2": after the stroke, or beside f, stand the filaments of a single yarn.
/// - "14.8 tex × 2".
/// bare: of a number alone, such as "30"; without it, one is refused. Throws CountError, which says what may be written.
YarnCount read_yarn_count(std::string_view text, std::optional<CountSystem> bare = std::nullopt);

/// The yarn takes the count; its diameter follows from it. Filaments that the count does not name stay.
void set_count(Yarn& yarn, const YarnCount& count);

/// A yarn's count as read_yarn_count() reads it, with four digits: "Ne 60/2", "150/48 den × 2". tex: of the whole yarn.
std::string count_text(double tex, int plies, std::optional<int> filaments, CountSystem system);

/// The forms that may be written, for help and complaints.
inline const char* const count_forms = "Ne 60/2, Nm 2/100, 150/48 den, 167 dtex f48 or 14.8 tex × 2";

} // namespace hygroloom
