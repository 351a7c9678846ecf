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

double widening_by_floats(const Weave& weave, bool along_warp)
{
    constexpr double each = 0.1, most = 1.3;
    const int threads = along_warp ? weave.ends() : weave.picks(), crossed = along_warp ? weave.picks() : weave.ends();
    const auto up = [&](int thread, int at) {
        return along_warp ? weave.warp_up(thread, at % crossed) : weave.warp_up(at % crossed, thread);
    };
    double sum = 0;
    for (int thread = 0; thread < threads; ++thread) {
        int first = 0; // where a float begins
        while (first < crossed && up(thread, first) == up(thread, first + crossed - 1)) ++first;
        if (first == crossed) { // it never changes sides
            sum += most * crossed;
            continue;
        }
        for (int at = first, length = 1; at < first + crossed; at += length) {
            for (length = 1; at + length < first + crossed && up(thread, at + length) == up(thread, at);) ++length;
            sum += length * std::min(most, 1 + each * (length - 1));
        }
    }
    return sum / (static_cast<double>(threads) * crossed);
}

} // namespace hygroloom
