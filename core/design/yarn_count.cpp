// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/yarn_count.h"

#include "core/base/text.h"
#include "core/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

namespace hygroloom {

namespace {

struct System {
    CountSystem system;
    const char* shown;
    double (*tex)(double count);
    double (*count)(double tex);
    bool of_mass; ///< mass of a length, in which a stroke names filaments
};

double same(double tex) { return tex; }

constexpr System systems[] = {{CountSystem::tex, "tex", same, same, true},
                              {CountSystem::ne, "Ne", tex_from_ne, ne_from_tex, false},
                              {CountSystem::nm, "Nm", tex_from_nm, nm_from_tex, false},
                              {CountSystem::denier, "den", tex_from_denier, denier_from_tex, true},
                              {CountSystem::dtex, "dtex", [](double d) { return 0.1 * d; }, [](double tex) { return 10 * tex; }, true}};

const System& system_of(CountSystem wanted)
{
    return *std::find_if(std::begin(systems), std::end(systems), [wanted](const System& s) { return s.system == wanted; });
}

// Reasons to refuse a text, as parts of a sentence.
constexpr const char* unreadable = "it cannot be read";
constexpr const char* no_unit = "it needs a unit";
constexpr const char* wrong_plies = "a yarn has 1 to 6 plies";
constexpr const char* wrong_filaments = "a yarn of filaments has 2 to 100000 of them";
constexpr const char* wrong_size = "a yarn has 0.05 to 50000 tex";
static_assert(most_plies == 6 && fewest_filaments == 2 && most_filaments == 100000 && least_tex == 0.05 && most_tex == 50000);

enum class Sign { number, unit, filaments, stroke, times };

struct Piece {
    Sign sign;
    double number = 0;
    CountSystem system = CountSystem::tex;
};

/// Longer words before those that they begin with.
struct Word {
    std::string_view spelling;
    Sign sign;
    CountSystem system = CountSystem::tex;
};
constexpr Word words[] = {{"denier", Sign::unit, CountSystem::denier},
                          {"dtex", Sign::unit, CountSystem::dtex},
                          {"tex", Sign::unit, CountSystem::tex},
                          {"nec", Sign::unit, CountSystem::ne},
                          {"ne", Sign::unit, CountSystem::ne},
                          {"nm", Sign::unit, CountSystem::nm},
                          {"den", Sign::unit, CountSystem::denier},
                          {"td", Sign::unit, CountSystem::denier},
                          {"d", Sign::unit, CountSystem::denier},
                          {"s", Sign::unit, CountSystem::ne}, // "60s" of cotton
                          {"filaments", Sign::filaments},
                          {"fil", Sign::filaments},
                          {"f", Sign::filaments},
                          {"x", Sign::times},
                          {"*", Sign::times},
                          {"\xc3\x97", Sign::times}, // ×
                          {"/", Sign::stroke}};

/// Of kinds of blanks that a text may bring from elsewhere: no-break and thin ones.
constexpr std::string_view blanks[] = {" ", "\t", "\xc2\xa0", "\xe2\x80\xaf", "\xe2\x80\x89"};

/// One text, read to the end or refused.
class CountReader {
public:
    CountReader(std::string_view text, std::optional<CountSystem> bare) : text_(text), bare_(bare)
    {
        std::string small(text);
        for (char& letter : small) letter = letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
        cut(small);
    }

    YarnCount read()
    {
        const auto times = std::find_if(pieces_.begin(), pieces_.end(), [](const Piece& p) { return p.sign == Sign::times; });
        Group left(pieces_.begin(), times), right;
        if (times != pieces_.end()) {
            right.assign(times + 1, pieces_.end());
            if (is_number_of_plies(left) && !(is_number_of_plies(right) && !has_unit(right))) std::swap(left, right);
            if (!is_number_of_plies(right)) refuse(wrong_plies);
        }
        YarnCount count = single(left, !right.empty());
        if (!right.empty()) count.plies = static_cast<int>(number_in(right));
        require_sound(count);
        return count;
    }

private:
    using Group = std::vector<Piece>;

    [[noreturn]] void refuse(const char* why) const
    {
        throw CountError(fmt::format("\"{}\" is no yarn count: {}. Write it as {}.", cut_text(text_, 40), why, count_forms), why);
    }

    void cut(std::string_view rest)
    {
        const auto skip = [&rest](std::string_view begin) {
            const bool found = rest.starts_with(begin);
            if (found) rest.remove_prefix(begin.size());
            return found;
        };
        while (!rest.empty()) {
            if (std::any_of(std::begin(blanks), std::end(blanks), skip)) continue;
            if (rest.front() >= '0' && rest.front() <= '9') {
                pieces_.push_back({Sign::number, cut_number(rest)});
                continue;
            }
            const auto word = std::find_if(std::begin(words), std::end(words), [&](const Word& w) { return skip(w.spelling); });
            if (word == std::end(words)) refuse(unreadable);
            pieces_.push_back({word->sign, 0, word->system});
        }
        if (pieces_.empty()) refuse(unreadable);
    }

    double cut_number(std::string_view& rest) const
    {
        std::string digits(rest.substr(0, rest.find_first_not_of("0123456789.,")));
        rest.remove_prefix(digits.size());
        std::replace(digits.begin(), digits.end(), ',', '.');
        double number = 0;
        const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
        if (failure != std::errc() || end != digits.data() + digits.size()) refuse(unreadable);
        return number;
    }

    static bool has_unit(const Group& group)
    {
        return std::any_of(group.begin(), group.end(), [](const Piece& p) { return p.sign == Sign::unit; });
    }
    static bool can_be_plies(double number) { return number >= 1 && number <= most_plies && number == std::floor(number); }
    static double number_in(const Group& group)
    {
        return std::find_if(group.begin(), group.end(), [](const Piece& p) { return p.sign == Sign::number; })->number;
    }
    /// One whole number, to which a unit that is meant for the other side of "x" may stand next: "14.8 x 2 tex".
    static bool is_number_of_plies(const Group& group)
    {
        const auto numbers = std::count_if(group.begin(), group.end(), [](const Piece& p) { return p.sign == Sign::number; });
        const auto others =
            std::count_if(group.begin(), group.end(), [](const Piece& p) { return p.sign != Sign::number && p.sign != Sign::unit; });
        return numbers == 1 && others == 0 && can_be_plies(number_in(group));
    }

    /// The system that is named, once or not at all.
    std::optional<CountSystem> system_named() const
    {
        std::optional<CountSystem> named;
        for (const Piece& piece : pieces_) {
            if (piece.sign != Sign::unit) continue;
            if (named) refuse("it names two units");
            named = piece.system;
        }
        return named;
    }

    struct Numbers {
        std::vector<double> plain;
        std::optional<double> filaments; ///< beside an f
    };

    /// Numbers with strokes between them, some of them marked as filaments.
    Numbers numbers_of(const Group& group) const
    {
        Numbers numbers;
        bool after_stroke = true;
        for (std::size_t i = 0; i < group.size(); ++i) {
            const Sign sign = group[i].sign;
            if (sign == Sign::unit) continue;
            if (sign == Sign::times) refuse("it names the plies twice");
            if (sign == Sign::stroke) {
                if (after_stroke) refuse(unreadable);
                after_stroke = true;
                continue;
            }
            std::optional<double> marked;
            if (sign == Sign::filaments) { // f48
                if (i + 1 == group.size() || group[i + 1].sign != Sign::number) refuse(unreadable);
                marked = group[++i].number;
            } else if (i + 1 < group.size() && group[i + 1].sign == Sign::filaments &&
                       (i + 2 == group.size() || group[i + 2].sign != Sign::number)) { // 36F
                marked = group[i++].number;
            }
            if (marked ? numbers.filaments.has_value() : !after_stroke) refuse(unreadable);
            if (marked)
                numbers.filaments = marked;
            else
                numbers.plain.push_back(group[i].number);
            after_stroke = false;
        }
        if (after_stroke || numbers.plain.empty()) refuse(unreadable);
        return numbers;
    }

    YarnCount single(const Group& group, bool plies_known) const
    {
        const Numbers numbers = numbers_of(group);
        const std::optional<CountSystem> named = system_named();
        const std::size_t plain = numbers.plain.size();
        if (!named && plain == 1 && !bare_) refuse(no_unit);
        const CountSystem chosen = named ? *named : plain == 1 ? *bare_ : CountSystem::ne;
        const System& system = system_of(chosen);
        return system.of_mass ? of_mass(system, numbers, plies_known) : of_length(system, numbers, named.has_value(), plies_known);
    }

    YarnCount of_length(const System& system, const Numbers& numbers, bool named, bool plies_known) const
    {
        const std::size_t plain = numbers.plain.size();
        if (numbers.filaments) refuse("filaments go with den, dtex or tex");
        if (plain == 1) return {checked(system, numbers.plain[0]), 1, {}};
        if (plain > 2 || plies_known) refuse("it names the plies twice");
        double count = numbers.plain[0], plies = numbers.plain[1];
        if (can_be_plies(count) && (!can_be_plies(plies) || count < plies)) std::swap(count, plies);
        if (!can_be_plies(plies)) { refuse(named ? wrong_plies : no_unit); }
        return {checked(system, count), static_cast<int>(plies), {}};
    }

    YarnCount of_mass(const System& system, const Numbers& numbers, bool plies_known) const
    {
        YarnCount count{checked(system, numbers.plain[0]), 1, {}};
        std::vector<double> behind(numbers.plain.begin() + 1, numbers.plain.end());
        std::optional<double> filaments = numbers.filaments;
        if (!filaments && !behind.empty()) {
            filaments = behind.front();
            behind.erase(behind.begin());
            if (system.system == CountSystem::tex && behind.empty() && can_be_plies(*filaments))
                refuse("a stroke after tex may mean plies or filaments; write × 2 or f2");
        }
        if (behind.size() > (plies_known ? 0U : 1U)) refuse("it names the plies twice");
        if (!behind.empty() && !can_be_plies(behind.front())) refuse(wrong_plies);
        if (!behind.empty()) count.plies = static_cast<int>(behind.front());
        if (!filaments) return count;
        if (*filaments != std::floor(*filaments) || *filaments < fewest_filaments || *filaments > most_filaments) refuse(wrong_filaments);
        count.filaments = static_cast<int>(*filaments);
        return count;
    }

    double checked(const System& system, double number) const
    {
        if (!(number > 0)) refuse(wrong_size);
        return system.tex(number);
    }

    void require_sound(const YarnCount& count) const
    {
        if (!(count.tex() >= least_tex && count.tex() <= most_tex)) refuse(wrong_size);
        if (count.filaments && *count.filaments > most_filaments / count.plies) refuse(wrong_filaments);
    }

    std::string_view text_;
    std::optional<CountSystem> bare_;
    std::vector<Piece> pieces_;
};

} // namespace

YarnCount read_yarn_count(std::string_view text, std::optional<CountSystem> bare) { return CountReader(text, bare).read(); }

void set_count(Yarn& yarn, const YarnCount& count)
{
    yarn.linear_density_tex = count.tex();
    yarn.diameter_mm.reset();
    yarn.plies = count.plies;
    if (count.filaments) yarn.filament_count = *count.filaments * count.plies;
}

std::string count_text(double tex, int plies, std::optional<int> filaments, CountSystem wanted)
{
    const System& system = system_of(wanted);
    const std::string number = brief_text(system.count(tex / plies), 4);
    if (!system.of_mass)
        return plies > 1 ? fmt::format("{} {}/{}", system.shown, number, plies) : fmt::format("{} {}", system.shown, number);
    std::string text = number;
    const bool whole = filaments && *filaments % plies == 0; // else no single yarn has a number of them
    if (whole && wanted != CountSystem::tex) text += fmt::format("/{}", *filaments / plies);
    text += fmt::format(" {}", system.shown);
    if (whole && wanted == CountSystem::tex) text += fmt::format(" f{}", *filaments / plies);
    return plies > 1 ? fmt::format("{} × {}", text, plies) : text;
}

} // namespace hygroloom
