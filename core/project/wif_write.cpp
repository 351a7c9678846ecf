// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A fabric as a WIF 1.1 file, as plain as loom software wants it: CRLF, every thread listed, no blanks round "=".
#include "core/design/drawdown.h"
#include "core/design/yarn_sections.h"
#include "core/project/atomic_file.h"
#include "core/project/project_json.h"
#include "core/project/wif_draft.h"
#include "core/project/wif_private.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace hygroloom {

namespace {

constexpr long most_written_threads = 20000; ///< when weave and colours have no common repeat below it

/// The threads of one system: as many as weave and colours repeat after together, and each one's yarn.
std::vector<int> yarns_of(const std::vector<YarnRun>& order, int weave_repeat)
{
    std::vector<int> once;
    for (const YarnRun& run : order) once.insert(once.end(), static_cast<std::size_t>(std::max(run.count, 0)), run.yarn);
    if (once.empty()) once.push_back(0);
    const long own = static_cast<long>(once.size()), common = std::lcm(own, static_cast<long>(weave_repeat));
    const long count =
        common <= most_written_threads ? common : std::min<long>(2 * std::max<long>(own, weave_repeat), most_imported_threads);
    std::vector<int> yarns;
    for (long thread = 0; thread < count; ++thread) yarns.push_back(once[thread % own]);
    return yarns;
}

std::string numbers(const std::vector<int>& indices)
{
    std::string text;
    for (int index : indices) text.append(text.empty() ? "" : ",").append(std::to_string(index + 1));
    return text.empty() ? "0" : text;
}

class Writing {
public:
    Writing(const Design& design, const Fabric& fabric) : design_(design), fabric_(fabric) {}

    std::string text()
    {
        const bool had_liftplan = fabric_.weave.draft() && !fabric_.weave.draft()->liftplan.empty();
        const Draft given = fabric_.weave.draft() ? *fabric_.weave.draft() : smallest_draft(fabric_.weave);
        const Draft draft = given.shafts > most_tied_shafts ? with_liftplan(given) : given.liftplan.empty() ? given : with_tie_up(given);
        const bool tied = draft.liftplan.empty();
        ends_ = yarns_of(fabric_.warp_order, draft.ends());
        picks_ = yarns_of(fabric_.weft_order, draft.picks());
        collect_colors();

        section("WIF");
        line("Version", "1.1");
        line("Date", "April 20, 1997");
        line("Developers", "wif@mhsoft.com");
        line("Source Program", "Hygroloom");
        contents(draft, tied);
        section("COLOR PALETTE");
        line("Entries", std::to_string(table_.size()));
        line("Form", "RGB");
        line("Range", "0,255");
        section("COLOR TABLE");
        for (std::size_t i = 0; i < table_.size(); ++i)
            line(std::to_string(i + 1), fmt::format("{},{},{}", table_[i].red, table_[i].green, table_[i].blue));
        section("TEXT");
        std::string title = fabric_.name;
        for (char& c : title)
            if (static_cast<unsigned char>(c) < ' ') c = ' ';
        line("Title", title);
        section("WEAVING");
        line("Shafts", std::to_string(draft.shafts));
        line("Treadles", std::to_string(tied ? draft.treadles : 0));
        line("Rising Shed", draft.rising_shed ? "true" : "false");
        system("WARP", ends_, fabric_.warp, fabric_.ends_per_cm);
        system("WEFT", picks_, fabric_.weft, fabric_.picks_per_cm);
        threads("THREADING", draft.threading, ends_.size());
        if (tied) {
            threads("TIEUP", draft.tie_up, draft.tie_up.size());
            threads("TREADLING", draft.treadling, picks_.size());
        } else {
            threads("LIFTPLAN", draft.liftplan, picks_.size());
        }
        colors("WARP COLORS", ends_, fabric_.warp);
        colors("WEFT COLORS", picks_, fabric_.weft);
        own_section(had_liftplan);
        for (const std::string& kept : draft.private_lines) {
            if (kept.starts_with("[")) text_ += "\r\n";
            text_ += kept + "\r\n";
        }
        return std::move(text_);
    }

private:
    void section(std::string_view name) { text_.append(text_.empty() ? "[" : "\r\n[").append(name).append("]\r\n"); }
    void line(std::string_view key, std::string_view value) { text_.append(key).append("=").append(value).append("\r\n"); }

    void contents(const Draft& draft, bool tied)
    {
        section("CONTENTS");
        std::vector<std::string> names{"COLOR PALETTE", "COLOR TABLE", "TEXT", "WEAVING", "WARP", "WEFT", "THREADING"};
        if (tied) {
            names.insert(names.end(), {"TIEUP", "TREADLING"});
        } else {
            names.emplace_back("LIFTPLAN");
        }
        names.insert(names.end(), {"WARP COLORS", "WEFT COLORS", private_section});
        for (const std::string& kept : draft.private_lines)
            if (kept.starts_with("[") && kept.find(']') != std::string::npos) names.push_back(kept.substr(1, kept.find(']') - 1));
        for (const std::string& name : names) line(name, "true");
    }

    const Yarn& yarn(const Yarn& base, int number) const
    {
        const auto index = static_cast<std::size_t>(number - 1);
        return number >= 1 && index < fabric_.extra_yarns.size() ? fabric_.extra_yarns[index] : base;
    }

    /// Where the yarn's colour stands in the table, from 1.
    std::size_t color_number(const Yarn& base, int number)
    {
        const Color color = yarn(base, number).color.value_or(uncoloured);
        const auto at = std::find(table_.begin(), table_.end(), color);
        if (at != table_.end()) return static_cast<std::size_t>(at - table_.begin()) + 1;
        table_.push_back(color);
        return table_.size();
    }

    void collect_colors()
    {
        for (const auto& [threads, base] : {std::pair(&ends_, &fabric_.warp), std::pair(&picks_, &fabric_.weft)}) {
            color_number(*base, 0);
            std::vector<int> different = *threads;
            std::sort(different.begin(), different.end());
            different.erase(std::unique(different.begin(), different.end()), different.end());
            for (int number : different) color_number(*base, number);
        }
    }

    void system(const char* name, const std::vector<int>& threads, const Yarn& base, double per_cm)
    {
        section(name);
        line("Threads", std::to_string(threads.size()));
        line("Color", std::to_string(color_number(base, 0)));
        line("Units", "Centimeters");
        line("Spacing", fmt::format("{:.6g}", 1 / per_cm));
        line("Thickness", fmt::format("{:.6g}", 0.1 * free_yarn(design_, base).diameter));
    }

    void threads(const char* name, const std::vector<std::vector<int>>& lists, std::size_t count)
    {
        section(name);
        for (std::size_t i = 0; i < count; ++i) line(std::to_string(i + 1), numbers(lists[i % lists.size()]));
    }

    void colors(const char* name, const std::vector<int>& threads, const Yarn& base)
    {
        section(name);
        std::vector<std::string> known(fabric_.extra_yarns.size() + 1);
        for (std::size_t i = 0; i < threads.size(); ++i) {
            const auto number = static_cast<std::size_t>(std::max(threads[i], 0));
            std::string& text = known[number < known.size() ? number : 0];
            if (text.empty()) text = std::to_string(color_number(base, threads[i]));
            line(std::to_string(i + 1), text);
        }
    }

    void own_section(bool had_liftplan)
    {
        section(private_section);
        Fabric fabric = fabric_;
        const bool named = !fabric.weave.pattern().empty();
        if (!named) fabric.weave = {}; // it stands above
        Design design;
        design.fabrics.push_back(std::move(fabric));
        line("Fabric", json_from_design(design)["fabrics"][0].dump(-1, ' ', true, ProjectJson::error_handler_t::replace));
        line("Weave", named ? "pattern" : !fabric_.weave.draft() ? "rows" : had_liftplan ? "liftplan" : "draft");
        line("Ends", std::to_string(fabric_.weave.ends()));
        line("Picks", std::to_string(fabric_.weave.picks()));
    }

    const Design& design_;
    const Fabric& fabric_;
    std::vector<int> ends_, picks_; ///< per thread its yarn
    std::vector<Color> table_;
    std::string text_;
};

} // namespace

std::string format_wif(const Design& design, const Fabric& fabric) { return Writing(design, fabric).text(); }

void write_wif(const Design& design, const Fabric& fabric, const std::filesystem::path& path)
{
    write_file(path, format_wif(design, fabric));
}

} // namespace hygroloom
