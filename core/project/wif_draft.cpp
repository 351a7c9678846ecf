// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/project/wif_draft.h"

#include "core/base/error.h"
#include "core/base/utf8.h"
#include "core/project/wif_counting.h"
#include "core/project/wif_private.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>

namespace hygroloom {

namespace {

using Lists = std::vector<std::vector<int>>;

std::size_t used_size(const Lists& lists)
{
    std::size_t size = lists.size();
    while (size > 0 && lists[size - 1].empty()) --size;
    return size;
}

int greatest(const Lists& lists)
{
    int most = -1;
    for (const std::vector<int>& list : lists)
        for (int value : list) most = std::max(most, value);
    return most;
}

class Reading {
public:
    Reading(const WifFile& file, const std::string& name, std::vector<ImportLine>& report) : file_(file), name_(name), report_(report) {}

    WifDraft read()
    {
        if (!file_.find("WIF") && !file_.find("WEAVING") && !file_.find("THREADING"))
            refuse("This is no WIF file: it has none of the sections [WIF], [WEAVING] and [THREADING].");
        first_ = counting_of(file_);
        if (const std::string names = first_.from_zero(); !names.empty())
            warn(fmt::format("The file counts {} from 0, where the format counts from 1; that was set right.", names));
        WifDraft result;
        read_draft(result.draft);
        read_palette();
        result.warp = read_threads("WARP", result.draft.ends());
        result.weft = read_threads("WEFT", result.draft.picks());
        return result;
    }

private:
    [[noreturn]] void refuse(const std::string& sentence) const { throw FileError(name_ + ": " + sentence); }
    void note(std::string sentence) { report_.push_back({Severity::note, std::move(sentence)}); }
    void warn(std::string sentence) { report_.push_back({Severity::warning, std::move(sentence)}); }

    static std::string counted(int count, const char* one, const char* more)
    {
        return fmt::format("{} {}", count, count == 1 ? one : more);
    }

    /// The value of each thread, treadle or colour of a section, the first of which has that number; from 0.
    std::vector<std::string_view> by_index(const std::string& name, int most, int first)
    {
        std::vector<std::string_view> values;
        const WifSection* section = file_.find(name);
        if (!section) return values;
        int unreadable = 0, before = 0, beyond = 0;
        for (const WifEntry& entry : section->entries) {
            const auto index = whole_number(entry.key);
            if (!index) {
                ++unreadable;
            } else if (*index < first) {
                ++before;
            } else if (*index - first >= most) {
                ++beyond;
            } else {
                const auto at = static_cast<std::size_t>(*index - first);
                if (values.size() <= at) values.resize(at + 1);
                values[at] = entry.value;
            }
        }
        const auto left_out = [&](int count, const std::string& which) {
            if (count > 0)
                warn(fmt::format("{} of [{}] {} {} left out.", counted(count, "entry", "entries"), name, which,
                                 count == 1 ? "was" : "were"));
        };
        left_out(unreadable, "without a number before the =");
        left_out(before, fmt::format("with a number below {}, the first,", first));
        left_out(beyond, fmt::format("beyond number {}", most));
        return values;
    }

    /// The numbers of each entry, less the first that there is.
    Lists lists(const std::string& name, int most, int first_entry, int first)
    {
        Lists result;
        int unreadable = 0, beyond = 0;
        std::string_view unread;
        const auto leave_out = [&](std::string_view value) {
            if (unreadable++ == 0) unread = value;
        };
        for (std::string_view value : by_index(name, most, first_entry)) {
            std::vector<int>& list = result.emplace_back();
            for (std::string_view part : parted(value, ',')) {
                std::string_view rest;
                const auto number = leading_whole(part, &rest);
                if (!number && trimmed(part).empty()) continue;
                if (!number || *number < 0)
                    leave_out(value);
                else if (*number - first >= most_shafts)
                    ++beyond;
                else if (*number >= first) // 0 stands for none
                    list.push_back(*number - first);
                if (!number || rest.empty()) continue;
                if (std::isdigit(static_cast<unsigned char>(rest.front())) != 0) leave_out(value); // not parted by a comma
                break;                                                                             // what follows is a comment
            }
            std::sort(list.begin(), list.end()); // a number twice means nothing more
            list.erase(std::unique(list.begin(), list.end()), list.end());
        }
        if (unreadable > 0)
            warn(fmt::format("{} of [{}] left out, where whole numbers parted by commas are meant; the first is \"{}\".",
                             counted(unreadable, "value", "values"), name, in_one_line(cut_text(unread, 40))));
        if (beyond > 0) warn(fmt::format("{} of [{}] left out: greater than {}.", counted(beyond, "value", "values"), name, most_shafts));
        return result;
    }

    int count(const char* section, const char* key, int otherwise)
    {
        const auto value = file_.value(section, key);
        if (!value) return otherwise;
        const auto number = leading_whole(*value);
        if (number && *number >= 0) return *number;
        warn(fmt::format("[{}] {} is \"{}\", which is no number; it was worked out from the draft.", section, key, cut_text(*value, 40)));
        return otherwise;
    }

    /// Leaves out what follows the last thread that does something, unless this program wrote it; reports threads before it that do
    /// nothing.
    void fit_threads(const char* section, const char* threads, const char* act, const char* idle, Lists& lists)
    {
        std::size_t used = used_size(lists);
        const int declared = count(section, "Threads", static_cast<int>(used));
        const auto listed = static_cast<std::size_t>(declared);
        if (file_.find(private_section) && listed > used && listed <= lists.size()) used = listed;
        if (static_cast<std::size_t>(declared) > used)
            warn(fmt::format("[{}] declares {} threads, but no more than the first {} {}; the rest was left out.", section, declared, used,
                             act));
        else if (static_cast<std::size_t>(declared) < used)
            warn(fmt::format("[{}] declares {} threads, but the draft has {}; all were read.", section, declared, used));
        lists.resize(used);
        const auto is_idle = [](const std::vector<int>& list) { return list.empty(); };
        const auto first = std::find_if(lists.begin(), lists.end(), is_idle);
        if (first != lists.end())
            warn(fmt::format("Among the {}, {} {}, the first of them number {}.", threads, std::count_if(first, lists.end(), is_idle), idle,
                             first - lists.begin() + 1));
    }

    /// What the format calls false when it is absent is true in the drafts of most programs.
    bool rises()
    {
        const auto value = file_.value("WEAVING", "Rising Shed");
        const auto given = value ? truth(*value) : std::nullopt;
        if (given) return *given;
        if (value)
            warn(fmt::format(
                "[WEAVING] Rising Shed is \"{}\", which is neither true nor false; a rising shed was taken. Where it sinks, the "
                "cloth shows its other face.",
                in_one_line(cut_text(*value, 40))));
        else if (file_.find("WEAVING"))
            warn("[WEAVING] does not say Rising Shed, which by the format means that the shed sinks; a rising one was taken, as most "
                 "programs "
                 "mean it. Where it sinks, the cloth shows its other face.");
        return true;
    }

    [[noreturn]] void refuse_threading() const
    {
        const WifSection* const section = file_.find("THREADING");
        if (!section || section->entries.empty())
            refuse("The section [THREADING] is missing or empty, so it is not known which shaft carries each end.");
        const WifEntry& first = section->entries.front();
        refuse(fmt::format(
            "The section [THREADING] names no shaft by a whole number from {}, so it is not known which shaft carries each end; "
            "its first line is \"{}={}\".",
            first_.shafts, in_one_line(cut_text(first.key, 40)), in_one_line(cut_text(first.value, 40))));
    }

    /// Of a file that has a liftplan as well as a tie-up with a treadling: which of them [CONTENTS] declares.
    bool liftplan_counts()
    {
        const auto declares = [this](const char* section) { return truth(file_.value("CONTENTS", section).value_or("")).value_or(false); };
        const bool lifts = declares("LIFTPLAN"), treads = declares("TIEUP") && declares("TREADLING");
        if (treads && !lifts) {
            note("The file has a liftplan as well as a tie-up with a treadling; [CONTENTS] declares the tie-up and the treadling only, so "
                 "they "
                 "count.");
            return false;
        }
        note("The file has a liftplan as well as a tie-up with a treadling; the liftplan counts.");
        return true;
    }

    void read_draft(Draft& draft)
    {
        if (!file_.find("WEAVING")) warn("The section [WEAVING] is missing; shafts and treadles were counted, and the shed rises.");
        draft.rising_shed = rises();
        draft.threading = lists("THREADING", most_imported_threads, first_.ends, first_.shafts);
        if (used_size(draft.threading) == 0) refuse_threading();
        fit_threads("WARP", "ends", "are threaded", "are on no shaft and stay down", draft.threading);

        Lists liftplan = lists("LIFTPLAN", most_imported_threads, first_.picks, first_.shafts);
        Lists tie_up = lists("TIEUP", most_shafts, first_.treadles, first_.shafts),
              treadling = lists("TREADLING", most_imported_threads, first_.picks, first_.treadles);
        const bool treads = used_size(treadling) > 0 && used_size(tie_up) > 0;
        bool lifts = used_size(liftplan) > 0;
        if (lifts && treads) lifts = liftplan_counts();
        if (!lifts && !treads) {
            if (used_size(treadling) > 0)
                refuse("The draft has a treadling but no tie-up ([TIEUP]), so it is not known which shafts a treadle lifts.");
            if (used_size(tie_up) > 0)
                refuse("The draft has a tie-up but no treadling ([TREADLING]), so it is not known what each pick lifts.");
            refuse("The draft has neither a liftplan ([LIFTPLAN]) nor a tie-up with a treadling ([TIEUP], [TREADLING]).");
        }
        const int shafts = std::max(greatest(draft.threading), greatest(lifts ? liftplan : tie_up)) + 1;
        draft.shafts = count("WEAVING", "Shafts", shafts);
        if (draft.shafts < shafts || draft.shafts > most_shafts) {
            warn(fmt::format("[WEAVING] says {} shafts, but the draft uses {}; {} were taken.", draft.shafts, shafts, shafts));
            draft.shafts = shafts;
        }
        if (lifts) {
            draft.liftplan = std::move(liftplan);
            fit_threads("WEFT", "picks", "lift shafts", "lift no shaft", draft.liftplan);
        } else {
            take_treadles(draft, std::move(tie_up), std::move(treadling));
        }
    }

    void take_treadles(Draft& draft, Lists tie_up, Lists treadling)
    {
        const int tied = static_cast<int>(used_size(tie_up));
        draft.treadles = count("WEAVING", "Treadles", tied);
        if (tied > draft.treadles || draft.treadles > most_shafts) {
            warn(fmt::format("[WEAVING] says {} treadles, but [TIEUP] has {}; {} were taken.", draft.treadles, tied, tied));
            draft.treadles = tied;
        } else if (tied < draft.treadles) {
            note(fmt::format("[WEAVING] says {} treadles, but only the first {} have a tie-up; the others lift nothing.", draft.treadles,
                             tied));
        }
        tie_up.resize(static_cast<std::size_t>(draft.treadles));
        int unknown = 0;
        for (std::vector<int>& pick : treadling)
            unknown += static_cast<int>(std::erase_if(pick, [&](int treadle) { return treadle >= draft.treadles; }));
        if (unknown > 0)
            warn(fmt::format("{} in [TREADLING] left out: there is no treadle beyond number {}.", counted(unknown, "treadle", "treadles"),
                             draft.treadles));
        if (used_size(treadling) == 0) refuse("No pick of [TREADLING] presses a treadle that exists.");
        draft.tie_up = std::move(tie_up);
        draft.treadling = std::move(treadling);
        fit_threads("WEFT", "picks", "press treadles", "press no treadle", draft.treadling);
    }

    /// Numbers parted by commas, up to a comment; empty where one cannot be read.
    static std::vector<double> reals(std::string_view text)
    {
        std::vector<double> values;
        for (const std::string_view part : parted(text, ',')) {
            const auto number = leading_real(part);
            if (!number) return {};
            values.push_back(*number);
            if (first_word(part).size() < trimmed(part).size()) break; // what follows is a comment
        }
        return values;
    }

    static std::optional<std::array<double, 3>> triple(std::string_view text)
    {
        const std::vector<double> values = reals(text);
        if (values.size() != 3) return {};
        return std::array{values[0], values[1], values[2]};
    }

    void read_palette()
    {
        std::vector<std::optional<std::array<double, 3>>> table;
        double most = 0;
        const auto read = [&](const char* name) {
            for (std::string_view value : by_index(name, most_imported_threads, 0)) {
                table.push_back(triple(value));
                if (table.back()) most = std::max({most, (*table.back())[0], (*table.back())[1], (*table.back())[2]});
            }
        };
        if (const WifSection* section = file_.find("COLOR TABLE"); section && !section->entries.empty()) {
            read("COLOR TABLE");
        } else if (const WifSection* palette = file_.find("COLOR PALETTE");
                   palette && std::any_of(palette->entries.begin(), palette->entries.end(),
                                          [](const WifEntry& entry) { return whole_number(entry.key) && triple(entry.value); })) {
            const std::size_t before = report_.size();
            read("COLOR PALETTE");
            report_.resize(before); // Entries and Range are no numbers, and need no telling
            warn("The colours stand in [COLOR PALETTE] in place of [COLOR TABLE]; they were read from there.");
        }
        low_ = 0;
        high_ = most > 999 ? 65535 : most > 255 ? 999 : 255;
        if (const auto range = file_.value("COLOR PALETTE", "Range")) {
            const std::vector<double> ends = reals(*range);
            if (ends.size() == 2 && ends[1] > ends[0]) {
                low_ = ends[0];
                high_ = ends[1];
            } else if (ends.size() == 1 && ends[0] > 0) {
                high_ = ends[0];
                note(fmt::format("The colours' range is given by one number, {}; it was read as 0 to {}.", high_, high_));
            } else {
                warn(fmt::format("The colours' range \"{}\" makes no sense; 0 to {} was taken.", cut_text(*range, 40), high_));
            }
        } else if (!table.empty()) {
            warn(fmt::format("The colours' range is missing; 0 to {} was taken.", high_));
        }
        for (const auto& entry : table) palette_.push_back(entry ? std::optional(scaled(*entry)) : std::nullopt);
    }

    Color scaled(const std::array<double, 3>& value) const
    {
        const auto channel = [&](double v) {
            return static_cast<std::uint8_t>(std::lround(255 * std::clamp((v - low_) / (high_ - low_), 0.0, 1.0)));
        };
        return {channel(value[0]), channel(value[1]), channel(value[2])};
    }

    /// "3", or "3,255,0,0" as version 1.0 wrote it. False when it names no colour of the table.
    bool color_in(std::string_view value, std::optional<Color>& color) const
    {
        const std::size_t comma = value.find(',');
        const auto index = leading_whole(value.substr(0, comma));
        if (index && *index >= 0 && static_cast<std::size_t>(*index) < palette_.size()) {
            color = palette_[*index];
            if (color) return true;
        }
        const auto own = comma == std::string_view::npos ? std::nullopt : triple(value.substr(comma + 1));
        if (own) color = scaled(*own);
        return own.has_value();
    }

    /// Of a section beside the draft, which may count otherwise.
    std::vector<std::string_view> by_thread(const std::string& system, const std::string& what)
    {
        const int first = system == "WARP" ? first_.ends : first_.picks;
        const bool from_zero = threads_from_zero(file_, system + what, system);
        return by_index(system + what, most_imported_threads, from_zero ? 0 : first);
    }

    WifThreads read_threads(const std::string& system, int count)
    {
        WifThreads threads;
        std::optional<Color> usual;
        int unknown = 0;
        if (const auto value = file_.value(system, "Color"); value && !color_in(*value, usual))
            warn(fmt::format("[{}] Color is {}, which the colour table does not have; the threads without a colour of their own have none.",
                             system, cut_text(*value, 40)));
        threads.colors.assign(static_cast<std::size_t>(count), usual);
        const auto colors = by_thread(system, " COLORS");
        for (std::size_t i = 0; i < std::min(colors.size(), threads.colors.size()); ++i)
            if (!colors[i].empty() && !color_in(colors[i], threads.colors[i])) ++unknown;
        if (unknown > 0)
            warn(fmt::format("{} of [{} COLORS] not in the colour table; the usual colour was taken.",
                             counted(unknown, "colour", "colours"), system));
        threads.spacing_cm = mean_length(system, "Spacing", count, threads.spacing_default);
        threads.thickness_cm = mean_length(system, "Thickness", count, threads.thickness_default);
        return threads;
    }

    std::optional<double> mean_length(const std::string& system, const char* key, int count, bool& is_default)
    {
        std::optional<double> usual;
        if (const auto value = file_.value(system, key)) {
            usual = leading_real(*value);
            if (!usual || *usual <= 0) {
                warn(fmt::format("[{}] {} is \"{}\", which is no length; it was left out.", system, key, cut_text(*value, 40)));
                usual.reset();
            }
        }
        const auto own = by_thread(system, " " + capitals(key));
        double sum = 0;
        int known = 0;
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
            std::optional<double> length = i < own.size() && !own[i].empty() ? leading_real(own[i]) : usual;
            if (!length || !(*length > 0 && *length < 1e6)) continue;
            sum += *length;
            ++known;
        }
        if (known == 0) return {};
        const double mean = sum / known, cm = mean * unit_cm(system);
        is_default = std::abs(mean - 0.212) < 5e-4 || std::abs(cm - 0.212) < 2e-3; // 12 to the inch
        return cm;
    }

    double unit_cm(const std::string& system)
    {
        const auto unit = file_.value(system, "Units");
        const std::string name = unit ? capitals(first_word(*unit)) : std::string();
        if (name == "CENTIMETERS" || name == "CENTIMETRES") return 1;
        if (name == "INCHES") return 2.54;
        if (name == "DECIPOINTS") return 2.54 / 720;
        if (std::find(no_unit_.begin(), no_unit_.end(), system) == no_unit_.end()) {
            no_unit_.push_back(system);
            warn(fmt::format("[{}] Units is {}, where Decipoints, Inches or Centimeters is meant; centimetres were taken.", system,
                             unit ? "\"" + cut_text(*unit, 40) + "\"" : "missing"));
        }
        return 1;
    }

    const WifFile& file_;
    const std::string& name_;
    std::vector<ImportLine>& report_;
    WifCounting first_;
    std::vector<std::optional<Color>> palette_;
    double low_ = 0, high_ = 255;
    std::vector<std::string> no_unit_;
};

} // namespace

WifDraft read_wif_draft(const WifFile& file, const std::string& name, std::vector<ImportLine>& report)
{
    return Reading(file, name, report).read();
}

} // namespace hygroloom
