// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/weave.h"

#include "core/base/error.h"

namespace hygroloom {

namespace {

int wrapped(int index, int size)
{
    const int rest = index % size;
    return rest < 0 ? rest + size : rest;
}

} // namespace

Weave::Weave() : Weave(2, 2, {1, 0, 0, 1}, "plain") {}

Weave::Weave(int ends, int picks, std::vector<std::uint8_t> up, std::string pattern)
    : ends_(ends), picks_(picks), pattern_(std::move(pattern))
{
    if (ends < 1 || picks < 1 || up.size() != static_cast<std::size_t>(ends) * static_cast<std::size_t>(picks))
        throw Error("A weave of " + std::to_string(ends) + " ends and " + std::to_string(picks) + " picks cannot have " +
                    std::to_string(up.size()) + " crossings.");
    for (auto& crossing : up) crossing = crossing != 0;
    up_ = std::make_shared<const std::vector<std::uint8_t>>(std::move(up));
}

bool Weave::warp_up(int end, int pick) const
{
    const auto row = static_cast<std::size_t>(wrapped(pick, picks_));
    return (*up_)[row * static_cast<std::size_t>(ends_) + static_cast<std::size_t>(wrapped(end, ends_))] != 0;
}

Weave Weave::toggled(int end, int pick) const
{
    std::vector<std::uint8_t> up = *up_;
    const auto row = static_cast<std::size_t>(wrapped(pick, picks_));
    auto& crossing = up[row * static_cast<std::size_t>(ends_) + static_cast<std::size_t>(wrapped(end, ends_))];
    crossing = !crossing;
    return {ends_, picks_, std::move(up)};
}

bool Weave::same_matrix(const Weave& other) const
{
    return ends_ == other.ends_ && picks_ == other.picks_ && (up_ == other.up_ || *up_ == *other.up_);
}

bool operator==(const Weave& a, const Weave& b)
{
    if (a.pattern_ != b.pattern_ || !a.same_matrix(b)) return false;
    return a.draft_ == b.draft_ || (a.draft_ && b.draft_ && *a.draft_ == *b.draft_);
}

double share_of_changes(const Weave& weave, bool along_warp)
{
    const std::vector<std::uint8_t>& up = weave.crossings();
    const auto ends = static_cast<std::size_t>(weave.ends());
    long changes = 0;
    for (std::size_t row = 0; row < up.size(); row += ends) {
        const std::size_t next_row = row + ends < up.size() ? row + ends : 0;
        for (std::size_t end = 0; end < ends; ++end)
            changes += up[row + end] != (along_warp ? up[next_row + end] : up[row + (end + 1 < ends ? end + 1 : 0)]);
    }
    return static_cast<double>(changes) / static_cast<double>(up.size());
}

} // namespace hygroloom
