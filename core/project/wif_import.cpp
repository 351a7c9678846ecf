// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A WIF draft as a fabric: its weave reduced to the smallest repeat, its colours as yarns, its numbers as suggestions.
#include "core/base/error.h"
#include "core/design/drawdown.h"
#include "core/design/jam.h"
#include "core/design/weave_analysis.h"
#include "core/project/json_reader.h"
#include "core/project/project_json.h"
#include "core/project/wif_draft.h"
#include "core/project/wif_private.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace hygroloom {

namespace {

constexpr std::size_t most_private_bytes = 1u << 20;

/// What [PRIVATE HYGROLOOM FABRIC] holds, when it can be read.
struct OwnFabric {
    Fabric fabric;
    std::string weave; ///< pattern, rows, draft or liftplan
    int ends = 0, picks = 0;
};

std::optional<OwnFabric> own_fabric(const WifFile& file, const std::string& name, std::vector<ImportLine>& report)
{
    const auto json = file.value(private_section, "Fabric");
    if (!json) return {};
    try {
        ProjectJson project{{"format", "hygroloom-project"}, {"version", 1}};
        project["fabrics"] = ProjectJson::array({parse_json(*json, name)});
        OwnFabric own;
        own.fabric = design_from_json(std::move(project), name).fabrics.at(0);
        own.weave = file.value(private_section, "Weave").value_or("draft");
        own.ends = whole_number(file.value(private_section, "Ends").value_or("")).value_or(0);
        own.picks = whole_number(file.value(private_section, "Picks").value_or("")).value_or(0);
        return own;
    } catch (const FileError& error) {
        report.push_back({Severity::warning, fmt::format("The section [{}] was left out: {}", private_section, error.what())});
        return {};
    }
}

/// Numbers threads so that those that weave alike have the same number.
struct ThreadKinds {
    std::vector<int> ends, picks;
};

ThreadKinds thread_kinds(const Draft& draft, const std::string& name)
{
    std::vector<char> used(static_cast<std::size_t>(draft.shafts));
    std::map<std::vector<int>, int> end_lists;
    Draft small = draft; // one thread of each list
    small.threading.clear();
    ThreadKinds kinds;
    for (std::vector<int> shafts : draft.threading) {
        std::sort(shafts.begin(), shafts.end());
        for (int shaft : shafts) used[shaft] = 1;
        const auto [at, fresh] = end_lists.try_emplace(shafts, static_cast<int>(end_lists.size()));
        if (fresh) small.threading.push_back(shafts);
        kinds.ends.push_back(at->second);
    }
    std::map<std::vector<bool>, int> lifts;
    std::vector<int> first_pick;
    std::vector<bool> lifted(used.size());
    for (int pick = 0; pick < draft.picks(); ++pick) {
        std::fill(lifted.begin(), lifted.end(), false);
        const auto lift = [&](const std::vector<int>& shafts) {
            for (int shaft : shafts)
                if (used[shaft]) lifted[shaft] = true;
        };
        const auto at = static_cast<std::size_t>(pick);
        if (!draft.liftplan.empty()) {
            lift(draft.liftplan[at]);
        } else {
            for (int treadle : draft.treadling[at]) lift(draft.tie_up[treadle]);
        }
        const auto [kind, fresh] = lifts.try_emplace(lifted, static_cast<int>(lifts.size()));
        if (fresh) first_pick.push_back(pick);
        kinds.picks.push_back(kind->second);
    }
    for (const auto& [count, what] : {std::pair(end_lists.size(), "ends"), std::pair(lifts.size(), "picks")})
        if (count > static_cast<std::size_t>(largest_repeat))
            throw FileError(
                fmt::format("{}: The draft has {} different {}; a repeat may have up to {}.", name, count, what, largest_repeat));

    auto& plan = draft.liftplan.empty() ? small.treadling : small.liftplan;
    const auto& all = draft.liftplan.empty() ? draft.treadling : draft.liftplan;
    plan.clear();
    for (int pick : first_pick) plan.push_back(all[pick]);
    const Draft alike = smallest_draft(drawdown(small));
    for (int& end : kinds.ends) end = alike.threading[end].front();
    for (int& pick : kinds.picks) pick = alike.treadling[pick].front();
    return kinds;
}

template <typename Sequence> bool has_period(const Sequence& sequence, int period)
{
    if (period < 1 || static_cast<std::size_t>(period) > sequence.size()) return false;
    return std::equal(sequence.begin() + period, sequence.end(), sequence.begin());
}

/// The repeat of a sequence that may break off within one: the least period that fits in at least twice, else the whole.
template <typename Sequence> int repeat_of(const Sequence& sequence)
{
    const int size = static_cast<int>(sequence.size());
    const int period = least_period(size, [&](int a, int b) { return sequence[a] == sequence[b]; });
    return 2 * period <= size ? period : size;
}

std::string repeats_in_words(int threads, int repeat, const char* name)
{
    if (threads == repeat) return fmt::format("all {} {} are one repeat", threads, name);
    const int rest = threads % repeat;
    return fmt::format("{} {} are {} repeats of {}{}", threads, name, threads / repeat, repeat,
                       rest ? fmt::format(" and {} more", rest) : "");
}

Weave weave_of(const Draft& whole, const std::optional<OwnFabric>& own, const std::string& name, std::vector<ImportLine>& report)
{
    const ThreadKinds kinds = thread_kinds(whole, name);
    int ends = repeat_of(kinds.ends), picks = repeat_of(kinds.picks);
    if (own && has_period(kinds.ends, own->ends)) ends = own->ends;
    if (own && has_period(kinds.picks, own->picks)) picks = own->picks;
    if (ends > largest_repeat || picks > largest_repeat)
        throw FileError(fmt::format("{}: The draft repeats after {} ends and {} picks; a repeat may have up to {}.", name, ends, picks,
                                    largest_repeat));
    report.push_back(
        {Severity::note, fmt::format("The weave repeats after {} ends and {} picks: {}, {}.", ends, picks,
                                     repeats_in_words(whole.ends(), ends, "ends"), repeats_in_words(whole.picks(), picks, "picks"))});
    Draft draft = whole;
    draft.threading.resize(static_cast<std::size_t>(ends));
    (draft.liftplan.empty() ? draft.treadling : draft.liftplan).resize(static_cast<std::size_t>(picks));
    if (own && own->weave == "liftplan") draft = with_liftplan(draft);
    const Weave weave = weave_from_draft(std::move(draft));
    if (!own) return weave;
    if (own->weave == "pattern" && own->fabric.weave.same_matrix(weave)) return own->fabric.weave;
    if (own->weave == "rows") return {weave.ends(), weave.picks(), weave.crossings()};
    return weave;
}

const Yarn& yarn_of(const Fabric& fabric, const Yarn& base, int number)
{
    const auto index = static_cast<std::size_t>(number - 1);
    return number >= 1 && index < fabric.extra_yarns.size() ? fabric.extra_yarns[index] : base;
}

/// Whether the threads' colours in the file are those of the fabric's own order of yarns.
bool colors_agree(const Fabric& fabric, const Yarn& base, const std::vector<YarnRun>& order,
                  const std::vector<std::optional<Color>>& colors)
{
    std::size_t at = 0;
    while (at < colors.size()) {
        const std::size_t before = at;
        for (const YarnRun& run : order.empty() ? std::vector<YarnRun>{{0, 1}} : order)
            for (int i = 0; i < run.count && at < colors.size(); ++i, ++at)
                if (yarn_of(fabric, base, run.yarn).color.value_or(uncoloured) != colors[at].value_or(uncoloured)) return false;
        if (at == before) return false;
    }
    return true;
}

using PackedColor = std::optional<std::uint32_t>;

PackedColor packed(const std::optional<Color>& color)
{
    if (!color) return {};
    return (static_cast<std::uint32_t>(color->red) << 16) | (static_cast<std::uint32_t>(color->green) << 8) | color->blue;
}

/// The commonest colour becomes that of the base yarn, each other one an extra yarn like it.
std::vector<YarnRun> order_of(const std::vector<std::optional<Color>>& colors, Yarn& base, std::vector<Yarn>& extra,
                              std::vector<ImportLine>& report)
{
    std::map<PackedColor, int> counts;
    for (const auto& color : colors) ++counts[packed(color)];
    std::optional<Color> usual = colors.front();
    for (const auto& color : colors)
        if (counts[packed(color)] > counts[packed(usual)]) usual = color;
    base.color = usual;
    std::map<PackedColor, int> numbers{{packed(usual), 0}};
    std::vector<int> yarns;
    bool reported = false;
    for (const auto& color : colors) {
        const auto [number, fresh] = numbers.try_emplace(packed(color), 0);
        if (fresh) {
            Yarn yarn = base;
            yarn.color = color;
            const auto known = std::find(extra.begin(), extra.end(), yarn);
            if (known == extra.end() && extra.size() == most_extra_yarns) {
                if (!reported)
                    report.push_back({Severity::warning, fmt::format("A fabric has up to {} extra yarns; further colours were given "
                                                                     "to the commonest yarn.",
                                                                     most_extra_yarns)});
                reported = true;
            } else {
                number->second = static_cast<int>(known - extra.begin()) + 1;
                if (known == extra.end()) extra.push_back(yarn);
            }
        }
        yarns.push_back(number->second);
    }
    std::vector<YarnRun> order;
    if (numbers.size() == 1) return order;
    yarns.resize(static_cast<std::size_t>(repeat_of(yarns)));
    for (int yarn : yarns) {
        if (!order.empty() && order.back().yarn == yarn)
            ++order.back().count;
        else
            order.push_back({yarn, 1});
    }
    return order;
}

void take_colors(const WifDraft& draft, const std::optional<OwnFabric>& own, Fabric& fabric, std::vector<ImportLine>& report)
{
    if (own && colors_agree(fabric, fabric.warp, fabric.warp_order, draft.warp.colors) &&
        colors_agree(fabric, fabric.weft, fabric.weft_order, draft.weft.colors))
        return;
    fabric.extra_yarns.clear();
    fabric.warp_order = order_of(draft.warp.colors, fabric.warp, fabric.extra_yarns, report);
    fabric.weft_order = order_of(draft.weft.colors, fabric.weft, fabric.extra_yarns, report);
    const auto count = [](const std::vector<YarnRun>& order) {
        std::vector<int> yarns;
        int threads = 0;
        for (const YarnRun& run : order) {
            yarns.push_back(run.yarn);
            threads += run.count;
        }
        std::sort(yarns.begin(), yarns.end());
        return std::pair(std::unique(yarns.begin(), yarns.end()) - yarns.begin(), threads);
    };
    for (const auto& [name, order] : {std::pair("warp", &fabric.warp_order), std::pair("weft", &fabric.weft_order)})
        if (const auto [colors, threads] = count(*order); !order->empty())
            report.push_back({Severity::note, fmt::format("The {} has {} colours, in an order of {} threads.", name, colors, threads)});
}

/// What a file says of a system's threads. Sett and diameter are of one drawing: where one of them is drawn, so is the other.
void suggest(const WifThreads& threads, const char* name, Suggestion& sett, Suggestion& diameter)
{
    if (threads.spacing_cm) {
        const double per_cm = 1 / *threads.spacing_cm;
        sett.value = per_cm;
        if (threads.spacing_default)
            sett.why =
                fmt::format("The {} spacing of {:.3g} cm is what drafting programs write when nobody set one.", name, *threads.spacing_cm);
        else if (!(per_cm >= 0.5 && per_cm <= 500))
            sett.why = fmt::format("The {} spacing of {:.3g} cm is no cloth's; from 0.002 to 2 cm would be.", name, *threads.spacing_cm);
        else
            sett.plausible = true;
    }
    if (threads.thickness_cm) {
        const double mm = 10 * *threads.thickness_cm;
        diameter.value = mm;
        if (threads.thickness_default)
            diameter.why = fmt::format("The {} thickness of {:.3g} mm is what drafting programs write when nobody set one.", name, mm);
        else if (!(mm >= 0.01 && mm <= 10))
            diameter.why = fmt::format("The {} thickness of {:.3g} mm is no yarn's; from 0.01 to 10 mm would be.", name, mm);
        else
            diameter.plausible = true;
    }
    if (threads.spacing_cm && threads.thickness_cm && *threads.thickness_cm > 0.98 * *threads.spacing_cm) {
        const std::string why = fmt::format(
            "The {} thickness of {:.3g} mm fills the spacing of {:.3g} mm, as programs write one number for both to draw the cloth.", name,
            10 * *threads.thickness_cm, 10 * *threads.spacing_cm);
        for (Suggestion* const one : {&sett, &diameter})
            if (one->plausible) *one = {one->value, false, why};
    }
}

/// Setts that yarns of the file's own diameters have no room for are of a drawing, too.
void refuse_jams(DraftImport& draft)
{
    DraftImport taken = draft;
    take_suggestions(taken);
    const Fabric& fabric = taken.fabric;
    const JamGauge gauge =
        jam_gauge(fabric.weave, fabric.ends_per_cm, fabric.picks_per_cm, *fabric.warp.diameter_mm, *fabric.weft.diameter_mm);
    const auto refuse = [](const JamOfSystem& jam, const char* threads, Suggestion& sett, Suggestion& diameter) {
        if (!sett.plausible || jam.peirce_percent <= 100) return;
        const std::string why = fmt::format("The file's {:.3g} {} per cm are {:.0f} % of what there is room for (Peirce) with its yarns.",
                                            jam.sett_per_cm, threads, jam.peirce_percent);
        for (Suggestion* const one : {&sett, &diameter})
            if (one->plausible) *one = {one->value, false, why};
    };
    refuse(gauge.warp, "ends", draft.ends_per_cm, draft.warp_diameter_mm);
    refuse(gauge.weft, "picks", draft.picks_per_cm, draft.weft_diameter_mm);
}

void tell_suggestions(DraftImport& draft)
{
    std::string last;
    for (const auto& [suggestion, what, unit] :
         {std::tuple(&draft.ends_per_cm, "warp sett", "per cm"), std::tuple(&draft.warp_diameter_mm, "warp yarn diameter", "mm"),
          std::tuple(&draft.picks_per_cm, "weft sett", "per cm"), std::tuple(&draft.weft_diameter_mm, "weft yarn diameter", "mm")}) {
        if (!suggestion->value) continue;
        if (suggestion->plausible)
            draft.report.push_back({Severity::note, fmt::format("The file suggests a {} of {:.4g} {}.", what, *suggestion->value, unit)});
        else if (suggestion->why != last)
            draft.report.push_back({Severity::warning, suggestion->why + " Give the real one."});
        last = suggestion->why;
    }
}

/// What other programs wrote for themselves, to be written again.
std::vector<std::string> private_lines(const WifFile& file, std::vector<ImportLine>& report)
{
    std::vector<std::string> lines;
    std::size_t bytes = 0, sections = 0;
    for (const WifSection& section : file.sections) {
        if (is_wif_section(section.name) || section.name == private_section) continue;
        std::size_t size = 0;
        for (std::string_view line : section.lines) size += line.size() + 1;
        if (bytes + size > most_private_bytes) {
            report.push_back(
                {Severity::warning, fmt::format("The private section [{}] is too large to be kept.", cut_text(section.name, 60))});
            continue;
        }
        bytes += size;
        ++sections;
        for (std::string_view line : section.lines)
            if (!trimmed(line).empty()) lines.emplace_back(line);
    }
    if (sections > 0)
        report.push_back({Severity::note, fmt::format("{} private {} of other programs {} kept for export.", sections,
                                                      sections == 1 ? "section" : "sections", sections == 1 ? "is" : "are")});
    return lines;
}

void use_known_materials(Yarn& yarn, const Design& known, std::vector<ImportLine>& report)
{
    for (MaterialShare& share : yarn.material) {
        if (find_material(known, share.name)) continue;
        report.push_back({Severity::warning, fmt::format("The material \"{}\" is not known here; cotton was taken.", share.name)});
        yarn.material = {{"cotton", 1.0}};
        return;
    }
}

std::string fabric_name(const WifFile& file, const std::string& name)
{
    std::string title(file.value("TEXT", "Title").value_or(""));
    if (title.empty()) title = name_of_file(name);
    return title.empty() ? "draft" : cut_text(title, longest_name);
}

void tell_of_text(const WifFile& file, std::vector<ImportLine>& report)
{
    for (const char* key : {"Author", "Address", "EMail", "Telephone", "FAX"})
        if (const auto value = file.value("TEXT", key))
            report.push_back({Severity::note, fmt::format("{}: {} (not kept).", key, cut_text(*value, 200))});
    if (const WifSection* notes = file.find("NOTES"))
        for (std::size_t i = 0; i < std::min<std::size_t>(notes->entries.size(), 20); ++i)
            if (!notes->entries[i].value.empty())
                report.push_back({Severity::note, fmt::format("Note: {} (not kept).", cut_text(notes->entries[i].value, 200))});
}

} // namespace

DraftImport import_wif(std::string_view bytes, const std::string& name, const Design& known)
{
    const std::string text = decoded_text(bytes, name);
    const WifFile file = parse_wif(text);
    DraftImport result;
    std::vector<ImportLine>& report = result.report;
    WifDraft draft = read_wif_draft(file, name, report);
    report.insert(report.begin(), file.remarks.begin(), file.remarks.end());
    report.insert(report.begin(),
                  {Severity::note,
                   fmt::format("Read {} ends on {} shafts and {} picks{}{}.", draft.draft.ends(), draft.draft.shafts, draft.draft.picks(),
                               draft.draft.liftplan.empty() ? fmt::format(" with {} treadles", draft.draft.treadles) : " with a liftplan",
                               draft.draft.rising_shed ? "" : ", on a sinking shed")});
    const std::string version = cut_text(file.value("WIF", "Source Version").value_or(""), 40);
    if (const auto program = file.value("WIF", "Source Program"))
        report.insert(report.begin() + 1, {Severity::note, fmt::format("The file was written by {}{}.", cut_text(*program, 80),
                                                                       version.empty() ? "" : " " + version)});
    std::optional<OwnFabric> own = own_fabric(file, name, report);
    draft.draft.private_lines = private_lines(file, report);

    Fabric& fabric = result.fabric;
    if (own) {
        fabric = own->fabric;
        for (Yarn* yarn : {&fabric.warp, &fabric.weft}) use_known_materials(*yarn, known, report);
        for (Yarn& yarn : fabric.extra_yarns) use_known_materials(yarn, known, report);
        result.numbers_are_ours = true;
        report.push_back({Severity::note, "Sett and yarns are those the fabric had when this program wrote the file."});
    } else {
        fabric.name = fabric_name(file, name);
        fabric.warp.diameter_mm = fabric.weft.diameter_mm = assumed_diameter_mm;
    }
    fabric.weave = weave_of(draft.draft, own, name, report);
    take_colors(draft, own, fabric, report);
    if (!own) {
        suggest(draft.warp, "warp", result.ends_per_cm, result.warp_diameter_mm);
        suggest(draft.weft, "weft", result.picks_per_cm, result.weft_diameter_mm);
        refuse_jams(result);
        tell_suggestions(result);
        report.push_back({Severity::note, assumed_numbers(fabric)});
    }
    tell_of_text(file, report);
    return result;
}

} // namespace hygroloom
