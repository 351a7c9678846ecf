// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/project/wif_draft.h"

#include "core/base/error.h"
#include "core/project/wif_private.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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
        look_at_head();
        look_at_contents();
        first_ = first_index();
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

    void look_at_head()
    {
        if (!file_.find("WIF")) {
            warn("The section [WIF] that should open the file is missing; the file was read all the same.");
            return;
        }
        const auto version = file_.value("WIF", "Version");
        if (!version)
            note("The file does not say its version; it was read as WIF 1.1.");
        else if (*version != "1.1" && *version != "1.0")
            note(fmt::format("The file says that it is WIF {}; it was read as WIF 1.1.", cut_text(*version, 40)));
        const auto date = file_.value("WIF", "Date");
        if (date && *date != "April 20, 1997")
            note(fmt::format("The file's date is \"{}\", where the format requires April 20, 1997; it has no meaning.",
                             cut_text(*date, 60)));
    }

    void look_at_contents()
    {
        const WifSection* contents = file_.find("CONTENTS");
        if (!contents) {
            warn("The section [CONTENTS] is missing; the sections that are there were read.");
            return;
        }
        std::string missing, undeclared;
        const auto list = [](std::string& names, const std::string& name) {
            if (names.size() < 200) names += (names.empty() ? "[" : ", [") + cut_text(name, 60) + "]";
        };
        std::vector<std::string> declared;
        std::map<std::string, const WifSection*> by_name;
        for (const WifSection& section : file_.sections) by_name.emplace(section.name, &section);
        for (const WifEntry& entry : contents->entries) {
            const std::string name = capitals(entry.key);
            if (!truth(entry.value).value_or(false)) continue;
            declared.push_back(name);
            const auto found = by_name.find(name);
            const WifSection* section = found == by_name.end() ? nullptr : found->second;
            if (!section || (section->entries.empty() && section->lines.size() <= 1)) list(missing, name);
        }
        std::sort(declared.begin(), declared.end());
        for (const WifSection& section : file_.sections)
            if (section.name != "WIF" && section.name != "CONTENTS" && !section.entries.empty() &&
                !std::binary_search(declared.begin(), declared.end(), section.name))
                list(undeclared, section.name);
        if (!missing.empty()) note(fmt::format("[CONTENTS] declares sections that are missing or empty: {}.", missing));
        if (!undeclared.empty()) note(fmt::format("[CONTENTS] does not declare sections that are there, and were read: {}.", undeclared));
    }

    /// 1, but 0 where a program counted from 0.
    int first_index()
    {
        const auto program = file_.value("WIF", "Source Program");
        bool from_zero = program && capitals(*program).find("GLASSNER") != std::string::npos;
        const auto has_zero = [&](const char* section) {
            const WifSection* found = file_.find(section);
            return found && std::any_of(found->entries.begin(), found->entries.end(),
                                        [](const WifEntry& entry) { return whole_number(entry.key) == 0; });
        };
        from_zero = from_zero || (has_zero("THREADING") && (has_zero("TREADLING") || has_zero("LIFTPLAN")));
        if (from_zero)
            warn("The file counts threads, shafts, treadles and colours from 0, where the format counts from 1; that was set right.");
        return from_zero ? 0 : 1;
    }

    /// The value of each thread (or treadle) of a section, by index from 0.
    std::vector<std::string_view> by_index(const std::string& name, int most)
    {
        std::vector<std::string_view> values;
        const WifSection* section = file_.find(name);
        if (!section) return values;
        int unreadable = 0, beyond = 0;
        for (const WifEntry& entry : section->entries) {
            const auto index = whole_number(entry.key);
            if (!index || *index < first_) {
                ++unreadable;
            } else if (*index - first_ >= most) {
                ++beyond;
            } else {
                const auto at = static_cast<std::size_t>(*index - first_);
                if (values.size() <= at) values.resize(at + 1);
                values[at] = entry.value;
            }
        }
        if (unreadable > 0)
            warn(fmt::format("{} of [{}] without a number before the = {} left out.", counted(unreadable, "entry", "entries"), name,
                             unreadable == 1 ? "was" : "were"));
        if (beyond > 0)
            warn(fmt::format("{} of [{}] beyond number {} {} left out.", counted(beyond, "entry", "entries"), name, most,
                             beyond == 1 ? "was" : "were"));
        return values;
    }

    Lists lists(const std::string& name, int most)
    {
        Lists result;
        int unreadable = 0, beyond = 0;
        for (std::string_view value : by_index(name, most)) {
            std::vector<int>& list = result.emplace_back();
            if (value.empty()) continue;
            for (std::string_view part : parted(value, ',')) {
                const auto number = whole_number(part);
                if (!number && trimmed(part).empty()) continue;
                if (!number || *number < 0)
                    ++unreadable;
                else if (*number - first_ >= most_shafts)
                    ++beyond;
                else if (*number >= first_) // 0 stands for none
                    list.push_back(*number - first_);
            }
            std::sort(list.begin(), list.end()); // a number twice means nothing more
            list.erase(std::unique(list.begin(), list.end()), list.end());
        }
        if (unreadable > 0) warn(fmt::format("{} of [{}] left out: no number.", counted(unreadable, "value", "values"), name));
        if (beyond > 0) warn(fmt::format("{} of [{}] left out: greater than {}.", counted(beyond, "value", "values"), name, most_shafts));
        return result;
    }

    int count(const char* section, const char* key, int otherwise)
    {
        const auto value = file_.value(section, key);
        if (!value) return otherwise;
        const auto number = whole_number(*value);
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

    void read_draft(Draft& draft)
    {
        if (!file_.find("WEAVING")) warn("The section [WEAVING] is missing; shafts and treadles were counted, and the shed rises.");
        draft.rising_shed = truth(file_.value("WEAVING", "Rising Shed").value_or("true")).value_or(true);
        draft.threading = lists("THREADING", most_imported_threads);
        if (used_size(draft.threading) == 0)
            refuse("The section [THREADING] is missing or empty, so it is not known which shaft carries each end.");
        fit_threads("WARP", "ends", "are threaded", "are on no shaft and stay down", draft.threading);

        Lists liftplan = lists("LIFTPLAN", most_imported_threads);
        Lists tie_up = lists("TIEUP", most_shafts), treadling = lists("TREADLING", most_imported_threads);
        const bool lifts = used_size(liftplan) > 0, treads = used_size(treadling) > 0 && used_size(tie_up) > 0;
        if (lifts && treads) note("The file has a liftplan as well as a tie-up with a treadling; the liftplan counts.");
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

    static std::optional<std::array<double, 3>> triple(std::string_view text)
    {
        const auto parts = parted(text, ',');
        if (parts.size() != 3) return {};
        std::array<double, 3> value{};
        for (std::size_t i = 0; i < 3; ++i) {
            const auto number = real_number(parts[i]);
            if (!number) return {};
            value[i] = *number;
        }
        return value;
    }

    void read_palette()
    {
        std::vector<std::optional<std::array<double, 3>>> table;
        double most = 0;
        const auto read = [&](const char* name) {
            for (std::string_view value : by_index(name, most_imported_threads)) {
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
            const auto parts = parted(*range, ',');
            const auto first = real_number(parts[0]), second = parts.size() > 1 ? real_number(parts[1]) : std::nullopt;
            if (first && second && parts.size() == 2 && *second > *first) {
                low_ = *first;
                high_ = *second;
            } else if (first && parts.size() == 1 && *first > 0) {
                high_ = *first;
                note(fmt::format("The colours' range is given by one number, {}; it was read as 0 to {}.", *first, *first));
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
        const auto index = whole_number(value.substr(0, comma));
        if (index && *index >= first_ && static_cast<std::size_t>(*index - first_) < palette_.size()) {
            color = palette_[static_cast<std::size_t>(*index - first_)];
            if (color) return true;
        }
        const auto own = comma == std::string_view::npos ? std::nullopt : triple(value.substr(comma + 1));
        if (own) color = scaled(*own);
        return own.has_value();
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
        const auto colors = by_index(system + " COLORS", most_imported_threads);
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
            usual = real_number(*value);
            if (!usual || *usual <= 0) {
                warn(fmt::format("[{}] {} is \"{}\", which is no length; it was left out.", system, key, cut_text(*value, 40)));
                usual.reset();
            }
        }
        const auto own = by_index(system + " " + capitals(key), most_imported_threads);
        double sum = 0;
        int known = 0;
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
            std::optional<double> length = i < own.size() && !own[i].empty() ? real_number(own[i]) : usual;
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
        const std::string name = unit ? capitals(*unit) : std::string();
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
    int first_ = 1;
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
