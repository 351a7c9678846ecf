// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Why one fabric is better than another, in words, as a table and as bars.
#include "core/analysis/comparative.h"
#include "core/analysis/page.h"
#include "core/analysis/svg.h"
#include "core/analysis/why.h"
#include "core/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

Interval interval_of(const Compared& compared)
{
    Interval interval;
    interval.centre = compared.difference;
    interval.low = compared.low;
    interval.high = compared.high;
    return interval;
}

bool is_shown(const Compared& compared) { return compared.verdict != Verdict::no_difference; }
bool is_probable(const Compared& compared)
{
    return compared.verdict == Verdict::probably_better || compared.verdict == Verdict::probably_worse;
}
bool is_good(const Compared& compared) { return compared.verdict == Verdict::better || compared.verdict == Verdict::probably_better; }

/// Of a difference: a degree of 1.8 °F, but no zero of 32.
ReaderUnits of_differences(const ReaderUnits& units)
{
    return [units](const std::string& unit) {
        ReaderUnit own = reader_unit(units, unit);
        own.at_zero = 0;
        return own;
    };
}

/// "0.10 ± 0.02 s", without its sign.
std::string size_of(const OutcomeInfo& metric, Compared compared, const ReaderUnits& units)
{
    const double sign = compared.difference < 0 ? -1 : 1;
    const double low = sign * compared.low, high = sign * compared.high;
    compared.difference *= sign;
    compared.low = std::min(low, high);
    compared.high = std::max(low, high);
    return with_unit(metric, compared, units);
}

bool is_plural(const Contribution& part) { return part.several || (part.title.ends_with('s') && !part.title.ends_with("ss")); }

/// The largest first.
std::vector<const Contribution*> in_order(const Why& why)
{
    std::vector<const Contribution*> parts;
    for (const Contribution& part : why.parts) parts.push_back(&part);
    std::stable_sort(parts.begin(), parts.end(), [](const Contribution* a, const Contribution* b) {
        return std::abs(a->compared.difference) > std::abs(b->compared.difference);
    });
    return parts;
}

std::string basis_of(const Why& why)
{
    const std::string runs = fmt::format("{} fabrics{}", why.fabrics,
                                         why.replicates > 1 ? fmt::format(" in {} replicates each", why.replicates) : std::string());
    if (why.parts.size() == 1) return "Nothing else differs, so the whole difference is its own.";
    if (why.all_orders)
        return fmt::format("Each contribution is the mean over all orders in which the parts can be exchanged (Shapley values), from {}; "
                           "together they are the difference.",
                           runs);
    return fmt::format("Each contribution is the mean of exchanging that part alone in {} and in {}, from {}. What the parts do together "
                       "is the rest of the difference.",
                       why.fabric, why.against, runs);
}

/// Where no contribution shows: what does by itself in one of the fabrics, or that nothing does.
std::vector<std::string> what_shows_alone(const Why& why, const ReaderUnits& units)
{
    std::vector<std::string> sentences;
    for (const Contribution* part : in_order(why))
        for (const auto& [alone, where] : {std::pair(&part->alone_in_fabric, &why.fabric), std::pair(&part->alone_in_other, &why.against)})
            if (*alone)
                sentences.push_back(fmt::format("Exchanged alone in {}, the {} ({} instead of {}) {}.", *where, part->title, part->first,
                                                part->second, in_words(why, **alone, is_plural(*part), units)));
    if (sentences.empty()) return {"No part by itself makes a difference that this simulation can show; only all of them do."};
    sentences.insert(sentences.begin(), "No contribution is a difference that this simulation can show, as each is a mean over several "
                                        "exchanges; single exchanges are.");
    return sentences;
}

/// A bar from 0 for each contribution, with its interval.
PageBlocks bars(const Why& why, const ReaderUnits& units)
{
    constexpr double left = 240, width = 330, line = 24;
    constexpr std::size_t longest_label = 36;
    const std::vector<WhyLine> lines = lines_of(why);
    double low = 0, high = 0;
    for (const WhyLine& each : lines) {
        low = std::min({low, each.compared->low, each.compared->difference});
        high = std::max({high, each.compared->high, each.compared->difference});
    }
    if (!(high > low)) return {};
    const auto x_of = [&](double value) { return left + width * (value - low) / (high - low); };
    std::string body;
    double y = 20;
    for (const WhyLine& each : lines) {
        const Compared& made = *each.compared;
        const char* colour = !is_shown(made) ? "#a8a8a8" : is_good(made) ? "#2a5ca8" : "#b06a20";
        const bool fits = each.title.size() <= longest_label;
        body += svg_text(left - 10, y + 4, "end", fits ? each.title : cut_text(each.title, longest_label) + "…");
        body += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"12\" fill=\"{}\"/>\n",
                            std::min(x_of(0), x_of(made.difference)), y - 6, std::abs(x_of(made.difference) - x_of(0)), colour);
        body += svg_line(x_of(made.low), y, x_of(made.high), y, "#222");
        for (const double end : {made.low, made.high}) body += svg_line(x_of(end), y - 4, x_of(end), y + 4, "#222");
        y += line;
    }
    body += svg_line(x_of(0), 8, x_of(0), y - 8, "#222");
    const ReaderUnit own = of_differences(units)(shown(why.metric, 0).unit);
    body += svg_text(left, y + 4, "start", fmt::format("{:.3g}", own.of(shown(why.metric, low).value)));
    body += svg_text(left + width, y + 4, "end", fmt::format("{:.3g} {}", own.of(shown(why.metric, high).value), own.unit));
    return {
        PageDrawing{svg_begin(600, y + 14) + body + "</svg>",
                    fmt::format("{}, {} less {}. Blue: better for {}; brown: worse; grey: no effect that this simulation can show. Lines: "
                                "intervals.",
                                full_title(why.metric), why.fabric, why.against, why.fabric)}};
}

} // namespace

std::string with_unit(const OutcomeInfo& metric, const Compared& compared, const ReaderUnits& units)
{
    const ReaderUnits own = of_differences(units);
    const std::string unit = own(shown(metric, 0).unit).unit;
    return with_interval(metric, interval_of(compared), own) + (unit.empty() ? "" : " " + unit);
}

std::string nothing_of(const Why& why, const ReaderUnits& units)
{
    if (!why.not_shown) return why.nothing;
    return fmt::format("No difference that this simulation can show ({}): there is nothing to explain.",
                       with_unit(why.metric, *why.whole, units));
}

std::string in_words(const Why& why, const Compared& compared, bool plural, const ReaderUnits& units)
{
    if (!is_shown(compared))
        return fmt::format("{} no effect that this simulation can show ({})", plural ? "have" : "has",
                           with_unit(why.metric, compared, units));
    return fmt::format("{}make{} it {} {}, which is {}", is_probable(compared) ? "probably " : "", plural ? "" : "s",
                       size_of(why.metric, compared, units), comparative(why.metric, compared.difference > 0),
                       is_good(compared) ? "better" : "worse");
}

std::vector<WhyLine> lines_of(const Why& why)
{
    std::vector<WhyLine> lines;
    for (const Contribution* part : in_order(why)) lines.push_back({part->title, part->first, part->second, &part->compared, false});
    if (why.together) lines.push_back({"together", "", "", &*why.together, false});
    lines.push_back({"difference", "", "", &*why.whole, true});
    return lines;
}

std::string heading_of(const Why& why, const ReaderUnits& units)
{
    const std::string title = full_title(why.metric);
    if (!why.whole || !is_shown(*why.whole)) return fmt::format("{} against {}, {}", why.fabric, why.against, title);
    return fmt::format("{} is {} than {}: its {} is {} {}", why.fabric,
                       std::string(is_probable(*why.whole) ? "probably " : "") + (is_good(*why.whole) ? "better" : "worse"), why.against,
                       title, size_of(why.metric, *why.whole, units), comparative(why.metric, why.whole->difference > 0));
}

std::vector<std::string> sentences_of(const Why& why, const ReaderUnits& units)
{
    if (!why.nothing.empty()) {
        std::vector<std::string> sentences = why.notes;
        sentences.insert(sentences.begin(), nothing_of(why, units));
        return sentences;
    }
    std::vector<std::string> sentences;
    for (const Contribution* part : in_order(why))
        sentences.push_back(fmt::format("The {} ({} instead of {}) {}.", part->title, part->first, part->second,
                                        in_words(why, part->compared, is_plural(*part), units)));
    if (why.parts.size() > 1 &&
        std::none_of(why.parts.begin(), why.parts.end(), [](const Contribution& part) { return is_shown(part.compared); }))
        for (std::string& sentence : what_shows_alone(why, units)) sentences.push_back(std::move(sentence));
    if (why.together) sentences.push_back(fmt::format("What the parts do together {}.", in_words(why, *why.together, false, units)));
    sentences.push_back(basis_of(why));
    sentences.insert(sentences.end(), why.notes.begin(), why.notes.end());
    return sentences;
}

std::string effect_words(const OutcomeInfo& metric, const Compared& compared)
{
    if (!is_shown(compared)) return "no effect shown";
    return fmt::format("{}makes it {}, {}", is_probable(compared) ? "probably " : "", comparative(metric, compared.difference > 0),
                       is_good(compared) ? "better" : "worse");
}

std::string why_text(const Why& why)
{
    std::string text = "\nWhy: " + heading_of(why) + "\n";
    if (why.nothing.empty()) {
        std::size_t title = 0, number = 0;
        for (const WhyLine& each : lines_of(why)) {
            title = std::max(title, each.title.size());
            number = std::max(number, with_unit(why.metric, *each.compared).size());
        }
        for (const WhyLine& each : lines_of(why))
            text += fmt::format("    {:<{}}  {:>{}}  {}\n", each.title, title, with_unit(why.metric, *each.compared), number,
                                each.whole ? name_of(why.whole->verdict) : effect_words(why.metric, *each.compared));
    }
    text += "\n";
    for (const std::string& sentence : sentences_of(why)) text += "  " + sentence + "\n";
    return text;
}

PageBlocks why_blocks(const Why& why, const ReaderUnits& units)
{
    PageBlocks blocks = sentence(heading_of(why, units) + ".");
    if (why.nothing.empty()) {
        std::vector<PageRow> rows{row_of_headings({"", why.fabric, why.against, "contribution", ""})};
        for (const WhyLine& each : lines_of(why))
            rows.push_back({{each.title, PageCell::Kind::heading},
                            {each.first},
                            {each.second},
                            {with_unit(why.metric, *each.compared, units), PageCell::Kind::number},
                            {each.whole ? name_of(why.whole->verdict) : effect_words(why.metric, *each.compared)}});
        blocks = joined({blocks, bars(why, units), table(rows)});
    }
    return joined({blocks, list(sentences_of(why, units))});
}

} // namespace hygroloom
