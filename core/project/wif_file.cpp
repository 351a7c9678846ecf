// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/project/wif_file.h"

#include "core/base/error.h"
#include "core/base/utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>

namespace hygroloom {

namespace {

constexpr std::string_view blanks = " \t\f\v\r";

void append_utf8(std::string& text, unsigned code)
{
    if (code < 0x80) {
        text += static_cast<char>(code);
    } else if (code < 0x800) {
        text += static_cast<char>(0xC0 | (code >> 6));
        text += static_cast<char>(0x80 | (code & 0x3F));
    } else {
        text += static_cast<char>(0xE0 | (code >> 12));
        text += static_cast<char>(0x80 | ((code >> 6) & 0x3F));
        text += static_cast<char>(0x80 | (code & 0x3F));
    }
}

std::string from_windows_1252(std::string_view bytes)
{
    // 0x80 to 0x9F; the five that have no character become the replacement character.
    static constexpr std::array<unsigned, 32> high{0x20AC, 0xFFFD, 0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
                                                   0x2039, 0x0152, 0xFFFD, 0x017D, 0xFFFD, 0xFFFD, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
                                                   0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0xFFFD, 0x017E, 0x0178};
    std::string text;
    for (char byte : bytes) {
        const auto code = static_cast<unsigned char>(byte);
        append_utf8(text, code >= 0x80 && code < 0xA0 ? high[code - 0x80u] : code);
    }
    return text;
}

std::string in_utf8(std::string_view bytes) { return is_utf8(bytes) ? std::string(bytes) : from_windows_1252(bytes); }

bool is_foreign(std::string_view name) { return !name.empty() && !is_wif_section(name); }

bool all_digits(std::string_view text)
{
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::string section_name(std::string_view text)
{
    std::string name;
    for (std::string_view word : parted(text, ' '))
        if (!trimmed(word).empty()) name += (name.empty() ? "" : " ") + capitals(trimmed(word));
    return name;
}

std::string_view without_comment(std::string_view value)
{
    const std::size_t at = value.find(';');
    return at == std::string_view::npos ? value : trimmed(value.substr(0, at));
}

/// Puts line after line where it belongs.
class Sorter {
public:
    explicit Sorter(WifFile& file) : file_(file) {}

    void take(std::string_view raw)
    {
        const std::string_view line = trimmed(raw);
        if (!line.empty() && line.front() == '[' && line.find(']') != std::string_view::npos && header(line, raw)) return;
        if (here_ && is_foreign(here_->name)) {
            here_->lines.push_back(raw);
            take_entry(line);
            return;
        }
        if (line.empty() || line.front() == ';') return;
        if (!take_entry(line)) stray();
    }

private:
    /// False for marks such as "[12]Border", which are left to the section they stand in.
    bool header(std::string_view line, std::string_view raw)
    {
        const std::size_t close = line.find(']');
        const std::string_view inside = trimmed(line.substr(1, close - 1)), after = without_comment(trimmed(line.substr(close + 1)));
        if (all_digits(inside)) return false;
        if (inside.find('=') != std::string_view::npos) { // "[Version=1.1]"
            if (!here_) here_ = &section("WIF");
            take_entry(inside);
            remark(fmt::format("The line \"{}\" is an entry in brackets; it was read as an entry.", cut_text(line, 60)));
            return true;
        }
        const std::string name = section_name(inside);
        if (name.empty()) return false;
        if (!after.empty())
            remark(fmt::format("Words after the section's name [{}] were left out: \"{}\".", cut_text(name, 60), cut_text(after, 60)));
        const bool known = places_.count(name) > 0;
        here_ = &section(name);
        if (known && !is_foreign(name)) remark(fmt::format("The section [{}] stands twice; both were read, the later one counts.", name));
        if (is_foreign(name)) here_->lines.push_back(raw);
        return true;
    }

    WifSection& section(const std::string& name)
    {
        const auto [place, fresh] = places_.try_emplace(name, file_.sections.size());
        if (fresh) file_.sections.push_back({name, {}, {}, 0});
        return file_.sections[place->second];
    }

    bool take_entry(std::string_view line)
    {
        if (!here_) return false;
        const std::size_t sign = line.find('=');
        if (sign == std::string_view::npos || sign == 0) return false;
        const bool free_text = here_->name == "TEXT" || here_->name == "NOTES" || is_foreign(here_->name);
        const std::string_view value = trimmed(line.substr(sign + 1));
        here_->entries.push_back({trimmed(line.substr(0, sign)), free_text ? value : without_comment(value)});
        return true;
    }

    void stray()
    {
        if (here_)
            ++here_->strays;
        else if (!reported_++)
            remark("The file begins with text that stands in no section; it was left out.");
    }

    void remark(std::string sentence)
    {
        if (file_.remarks.size() < 50) file_.remarks.push_back({Severity::warning, std::move(sentence)});
    }

    WifFile& file_;
    WifSection* here_ = nullptr; // into file_.sections, set anew whenever a section is added
    std::map<std::string, std::size_t> places_;
    int reported_ = 0;
};

void remark_on_head(WifFile& file)
{
    if (!file.find("WIF")) {
        file.remarks.push_back(
            {Severity::warning, "The section [WIF] that should open the file is missing; the file was read all the same."});
        return;
    }
    const auto version = file.value("WIF", "Version");
    if (!version)
        file.remarks.push_back({Severity::note, "The file does not say its version; it was read as WIF 1.1."});
    else if (first_word(*version) != "1.1" && first_word(*version) != "1.0")
        file.remarks.push_back(
            {Severity::note, fmt::format("The file says that it is WIF {}; it was read as WIF 1.1.", cut_text(*version, 40))});
    const auto date = file.value("WIF", "Date");
    if (date && *date != "April 20, 1997")
        file.remarks.push_back(
            {Severity::note,
             fmt::format("The file's date is \"{}\", where the format requires April 20, 1997; it has no meaning.", cut_text(*date, 60))});
}

void remark_on_contents(WifFile& file)
{
    const WifSection* contents = file.find("CONTENTS");
    if (!contents) {
        file.remarks.push_back({Severity::warning, "The section [CONTENTS] is missing; the sections that are there were read."});
        return;
    }
    std::string missing, undeclared, unclear;
    const auto list = [](std::string& names, const std::string& name) {
        if (names.size() < 200) names += (names.empty() ? "[" : ", [") + cut_text(name, 60) + "]";
    };
    std::vector<std::string> declared;
    std::map<std::string, const WifSection*> by_name;
    for (const WifSection& section : file.sections) by_name.emplace(section.name, &section);
    for (const WifEntry& entry : contents->entries) {
        const std::string name = capitals(entry.key);
        if (!truth(entry.value)) list(unclear, name);
        if (!truth(entry.value).value_or(false)) continue;
        declared.push_back(name);
        const auto found = by_name.find(name);
        const WifSection* section = found == by_name.end() ? nullptr : found->second;
        if (!section || (section->entries.empty() && section->lines.size() <= 1)) list(missing, name);
    }
    std::sort(declared.begin(), declared.end());
    for (const WifSection& section : file.sections)
        if (section.name != "WIF" && section.name != "CONTENTS" && !section.entries.empty() &&
            !std::binary_search(declared.begin(), declared.end(), section.name))
            list(undeclared, section.name);
    if (!unclear.empty())
        file.remarks.push_back({Severity::warning, fmt::format("[CONTENTS] says neither true nor false of {}; false was taken.", unclear)});
    if (!missing.empty())
        file.remarks.push_back({Severity::note, fmt::format("[CONTENTS] declares sections that are missing or empty: {}.", missing)});
    if (!undeclared.empty())
        file.remarks.push_back(
            {Severity::note, fmt::format("[CONTENTS] does not declare sections that are there, and were read: {}.", undeclared)});
}

} // namespace

bool is_wif_section(std::string_view name)
{
    static constexpr std::array<std::string_view, 36> known{"WIF",
                                                            "CONTENTS",
                                                            "TRANSLATIONS",
                                                            "COLOR PALETTE",
                                                            "COLOR TABLE",
                                                            "WARP SYMBOL PALETTE",
                                                            "WEFT SYMBOL PALETTE",
                                                            "WARP SYMBOL TABLE",
                                                            "WEFT SYMBOL TABLE",
                                                            "WARP SYMBOLS",
                                                            "WEFT SYMBOLS",
                                                            "TEXT",
                                                            "NOTES",
                                                            "WEAVING",
                                                            "WARP",
                                                            "WEFT",
                                                            "THREADING",
                                                            "TIEUP",
                                                            "TREADLING",
                                                            "LIFTPLAN",
                                                            "WARP COLORS",
                                                            "WEFT COLORS",
                                                            "WARP SPACING",
                                                            "WEFT SPACING",
                                                            "WARP SPACING ZOOM",
                                                            "WEFT SPACING ZOOM",
                                                            "WARP THICKNESS",
                                                            "WEFT THICKNESS",
                                                            "WARP THICKNESS ZOOM",
                                                            "WEFT THICKNESS ZOOM",
                                                            "BITMAP IMAGE",
                                                            "BITMAP FILE",
                                                            "BITMAP IMAGE DATA",
                                                            "BITMAP FILE DATA",
                                                            "BITMAP DATA",
                                                            "PROFILE"};
    return std::find(known.begin(), known.end(), name) != known.end();
}

const WifSection* WifFile::find(std::string_view name) const
{
    for (const WifSection& section : sections)
        if (section.name == name) return &section;
    return nullptr;
}

std::optional<std::string_view> WifFile::value(std::string_view section, std::string_view key) const
{
    const WifSection* found = find(section);
    if (!found) return {};
    for (auto entry = found->entries.rbegin(); entry != found->entries.rend(); ++entry)
        if (entry->key.size() == key.size() && capitals(entry->key) == capitals(key))
            return entry->value.empty() ? std::nullopt : std::optional(entry->value);
    return {};
}

std::string decoded_text(std::string_view bytes, const std::string& name)
{
    if (bytes.size() > largest_import_bytes) throw FileError(name + ": The file is larger than 64 MiB; no draft is.");
    if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"))
        throw FileError(name + ": The text is UTF-16; save it as plain text (UTF-8) and import it again.");
    if (bytes.find('\0') != std::string_view::npos) throw FileError(name + ": This is no text file: it holds bytes of value 0.");
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
    return in_utf8(bytes);
}

std::string name_of_file(const std::string& path) { return in_one_line(in_utf8(std::filesystem::path(path).stem().string())); }

std::string_view take_line(std::string_view& text)
{
    const std::string_view line = text.substr(0, std::min(text.find_first_of("\n\r"), text.size()));
    text.remove_prefix(line.size());
    text.remove_prefix(text.starts_with("\r\n") ? 2 : text.empty() ? 0 : 1);
    return line;
}

WifFile parse_wif(std::string_view text)
{
    WifFile file;
    Sorter sorter(file);
    while (!text.empty()) sorter.take(take_line(text));
    for (const WifSection& section : file.sections)
        if (section.strays > 0)
            file.remarks.push_back({Severity::warning, fmt::format("{} {} of [{}] left out: not of the form key=value.", section.strays,
                                                                   section.strays == 1 ? "line" : "lines", section.name)});
    remark_on_head(file);
    remark_on_contents(file);
    return file;
}

std::optional<int> whole_number(std::string_view text)
{
    text = trimmed(text);
    int value = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc() || end != text.data() + text.size()) return {};
    return value;
}

std::optional<double> real_number(std::string_view text)
{
    std::string number(trimmed(text).substr(0, 64));
    if (std::count(number.begin(), number.end(), ',') == 1 && number.find('.') == std::string::npos) number[number.find(',')] = '.';
    double value = 0;
    const auto [end, failure] = std::from_chars(number.data(), number.data() + number.size(), value);
    if (failure != std::errc() || end != number.data() + number.size() || number.empty() || !std::isfinite(value)) return {};
    return value;
}

std::string_view first_word(std::string_view text)
{
    text = trimmed(text);
    return text.substr(0, std::min(text.find_first_of(" \t\f\v\r;"), text.size()));
}

std::optional<int> leading_whole(std::string_view text, std::string_view* rest)
{
    text = trimmed(text);
    int value = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    const bool goes_on =
        !text.empty() && (std::isalnum(static_cast<unsigned char>(text.front())) != 0 || text.front() == '.' || text.front() == '-');
    if (failure != std::errc() || goes_on) return {};
    if (rest) *rest = trimmed(text);
    return value;
}

std::optional<double> leading_real(std::string_view text) { return real_number(first_word(text)); }

std::optional<bool> truth(std::string_view text)
{
    const std::string word = capitals(first_word(text));
    if (word == "TRUE" || word == "YES" || word == "ON" || word == "1" || word == "T" || word == "Y") return true;
    if (word == "FALSE" || word == "NO" || word == "OFF" || word == "0" || word == "F" || word == "N") return false;
    return {};
}

std::vector<std::string_view> parted(std::string_view text, char separator)
{
    std::vector<std::string_view> parts;
    while (true) {
        const std::size_t end = text.find(separator);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

std::string_view trimmed(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string capitals(std::string_view text)
{
    std::string upper(text);
    for (char& c : upper)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return upper;
}

} // namespace hygroloom
