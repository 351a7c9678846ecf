// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/plan/switched_part.h"

#include <fmt/format.h>

namespace hygroloom {
namespace {

const char* what_it_is(const SwitchedPart& part)
{
    if (part.name == "heat") return "how much temperature could change a rate or the water";
    if (part.name == "sorption") return "what the fibres could take up where the cloth had got wet";
    return part.estimate ? "what would evaporate in all where the cloth had got wet"
                         : "what fibres exchange with the changing air comes and goes as vapour; what they could take up";
}

} // namespace

std::string in_words(const SwitchedPart& part)
{
    const std::string expected =
        part.estimate ? fmt::format("; the plan had expected {:.3g} % at most", 100 * *part.estimate) : std::string();
    const std::string over =
        fmt::format("{} came to {:g} %, over the {:g} % that may be left out", what_it_is(part), 100 * part.share, 100 * part.limit);
    const char* name = part.name == "heat" ? "Heat" : part.name == "vapour" ? "Vapour" : "Sorption";
    if (part.kept_off.empty())
        return fmt::format("{} was left out until {:.3g} s and is modelled from there on: {}{}.", name, part.time, over, expected);
    return fmt::format("{} came over the limit at {:.3g} s; it was not modelled, for {}: {}{}.", name, part.time, part.kept_off, over,
                       expected);
}

} // namespace hygroloom
