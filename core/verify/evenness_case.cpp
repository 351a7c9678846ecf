// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How uneven a strand of fibres is that lie at random, against fibres that are counted.
#include "core/base/random.h"
#include "core/design/evenness.h"
#include "core/verify/verify.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

/// Fibres of one length and fineness begin anywhere along a strand; the fibres in sections a fibre's length apart are counted.
std::vector<VerifyResult> limit_irregularity_of_strand(const VerifyValues& v, Backend&)
{
    const double fibres = value(v, "fibres_in_section");
    const auto sections = static_cast<std::size_t>(value(v, "sections"));
    const auto all = static_cast<std::uint64_t>(std::llround(fibres * static_cast<double>(sections)));
    std::vector<double> counted(sections, 0); // a section's fibres begin within the length before it
    for (std::uint64_t k = 0; k < all; ++k) counted[static_cast<std::size_t>(random_uniform(1, 0, k) * static_cast<double>(sections))] += 1;
    double squares = 0;
    for (double count : counted) squares += (count - fibres) * (count - fibres);
    const double expected = std::sqrt(squares / static_cast<double>(sections)) / fibres;
    return {{"cv", limit_irregularity(1.0, fibres, 1.0), expected, 0.02 * expected}};
}

} // namespace

std::vector<VerifyCase> evenness_cases()
{
    return {{"limit_irregularity",
             "Coefficient of variation of a strand of alike fibres that lie at random, as a fraction.",
             {{"fibres_in_section", 92.25, 2, 1000, ""}, {"sections", 20000, 1000, 100000, ""}},
             limit_irregularity_of_strand}};
}

} // namespace hygroloom
