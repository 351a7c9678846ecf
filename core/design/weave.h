// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A weave: the repeat of up (warp over weft) and down crossings, as on point paper.
#pragma once

#include "core/design/draft.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace hygroloom {

/// Copyable; the matrix is shared and never changes once made.
class Weave {
public:
    Weave(); ///< plain
    /// up holds picks rows of ends values, first pick first; a row is one pick.
    Weave(int ends, int picks, std::vector<std::uint8_t> up, std::string pattern = {});

    int ends() const { return ends_; }
    int picks() const { return picks_; }
    /// Whether the warp end lies over the pick; indices may run past the repeat, and below zero.
    bool warp_up(int end, int pick) const;
    /// The name it was made from ("twill 2/1 Z"), empty for a free matrix.
    const std::string& pattern() const { return pattern_; }
    /// What it was drawn down from, null for a pattern or a free matrix. See draft.h.
    const std::shared_ptr<const Draft>& draft() const { return draft_; }
    /// Rows of ends, first pick first; 1 = warp up.
    const std::vector<std::uint8_t>& crossings() const { return *up_; }
    bool same_matrix(const Weave& other) const;
    /// A copy with one crossing turned over; it has neither pattern name nor draft.
    Weave toggled(int end, int pick) const;

    /// Same matrix, same pattern name, same draft.
    friend bool operator==(const Weave& a, const Weave& b);
    friend Weave weave_from_draft(Draft draft);

private:
    int ends_ = 0;
    int picks_ = 0;
    std::shared_ptr<const std::vector<std::uint8_t>> up_;
    std::string pattern_;
    std::shared_ptr<const Draft> draft_;
};

/// Of all steps from a crossing to the next along the ends (or along the picks), the share where the yarn changes sides: 1 for plain.
double share_of_changes(const Weave& weave, bool along_warp);

/// How much wider a yarn lies than where it changes sides at every crossing, mean over its crossings: 1 + 0.1 (n - 1) in floats over n
/// yarns, 1.3 at most. An assumption.
double widening_by_floats(const Weave& weave, bool along_warp);

/// "plain", "twill 2/1 Z", "satin 5/2", "waffle 8", ...; throws Error with a sentence that lists the forms.
Weave weave_from_pattern(const std::string& pattern);

/// Patterns of one kind to offer in a list, each accepted by weave_from_pattern() and its result's pattern().
struct WeaveGroup {
    std::string name; ///< "Twills"
    std::vector<std::string> patterns;
};
const std::vector<WeaveGroup>& weave_catalogue();

/// All of the catalogue in one list.
const std::vector<std::string>& common_weave_patterns();

} // namespace hygroloom
