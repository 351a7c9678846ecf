// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "app/cli_usage.h"

#include "core/base/words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace hygroloom {
namespace {

std::vector<const CLI::App*> verbs_of(const CLI::App& app)
{
    return app.get_subcommands([](const CLI::App*) { return true; });
}

const CLI::App* verb_named(const CLI::App& app, const std::string& name)
{
    const std::vector<const CLI::App*> verbs = verbs_of(app);
    const auto found = std::find_if(verbs.begin(), verbs.end(), [&](const CLI::App* verb) { return verb->get_name() == name; });
    return found == verbs.end() ? nullptr : *found;
}

/// Those that the help lists.
std::vector<std::string> listed_verbs(const CLI::App& app)
{
    std::vector<std::string> names;
    for (const CLI::App* verb : verbs_of(app))
        if (!verb->get_group().empty()) names.push_back(verb->get_name());
    return names;
}

/// "hygroloom-cli garment import".
std::string full_name(const CLI::App& app)
{
    return app.get_parent() ? full_name(*app.get_parent()) + " " + app.get_name() : app.get_name();
}

/// The verb that the words name, as far as they do, and the first word that names none where one must.
struct Named {
    const CLI::App* verb;
    std::string unknown = {};
};
Named named(const CLI::App& app, const std::vector<std::string>& words)
{
    const CLI::App* at = &app;
    for (const std::string& word : words) {
        if (word.starts_with('-')) continue;
        const CLI::App* next = verb_named(*at, word);
        if (!next) return {at, verbs_of(*at).empty() ? std::string() : word};
        at = next;
    }
    return {at};
}

std::string unknown_option(const CLI::App& verb, const std::string& option)
{
    std::vector<std::string> known;
    for (const CLI::Option* each : verb.get_options())
        for (const std::string& name : each->get_lnames()) known.push_back("--" + name);
    return fmt::format("{} has no option \"{}\"{}", full_name(verb), option, did_you_mean(option, known));
}

/// "FABRIC" of a word, "--study" of an option.
std::string name_of(const CLI::Option& option)
{
    std::string name = option.get_name(option.get_positional());
    if (option.get_positional()) std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
    return name.substr(name.rfind(',') + 1);
}

std::string what_is_missing(const CLI::App& verb)
{
    const std::vector<std::string> verbs = listed_verbs(verb);
    if (!verbs.empty()) return fmt::format("{} needs a verb: {}.", full_name(verb), fmt::join(verbs, ", "));
    for (const CLI::Option* option : verb.get_options())
        if (option->get_required() && option->count() == 0)
            return fmt::format("{} needs {}: {}.", full_name(verb), name_of(*option), option->get_description());
    return {};
}

/// That the words give an empty text, as an empty variable of a shell does.
std::string empty_text(const std::vector<std::string>& given)
{
    for (std::size_t i = 0; i < given.size(); ++i) {
        const std::string& word = given[i];
        const bool is_option = word.size() > 3 && word.starts_with("--") && word.find('=') == word.size() - 1;
        if (!word.empty() && !is_option) continue;
        const std::string before = is_option ? word.substr(0, word.size() - 1) : i > 0 && given[i - 1].starts_with('-') ? given[i - 1] : "";
        return before.empty() ? "One of the words is an empty text. Give a name, or leave it out."
                              : before + ": This is an empty text. Give a value, or leave the option out.";
    }
    return {};
}

const CLI::App& chosen_verb(const CLI::App& app)
{
    const std::vector<const CLI::App*> parsed = app.get_subcommands([](const CLI::App* verb) { return verb->parsed(); });
    return parsed.empty() ? app : chosen_verb(*parsed.front());
}

} // namespace

std::string fault_of(const CLI::App& app, const std::vector<std::string>& given)
{
    if (std::string empty = empty_text(given); !empty.empty()) return empty;
    const Named by = named(app, given);
    if (!by.unknown.empty()) {
        const std::vector<std::string> verbs = listed_verbs(*by.verb);
        return fmt::format("There is no verb \"{}\"{} The verbs are: {}.", by.unknown, did_you_mean(by.unknown, verbs),
                           fmt::join(verbs, ", "));
    }
    for (std::size_t i = 0; i < given.size() && given[i] != "--"; ++i) {
        const std::string option = given[i].substr(0, given[i].find('='));
        if (!option.starts_with("--")) continue;
        const CLI::Option* known = by.verb->get_option_no_throw(option);
        if (!known) return unknown_option(*by.verb, option);
        if (known->get_items_expected_max() > 0 && option == given[i]) ++i; // its value, which may begin as an option does
    }
    return {};
}

std::string fault_of(const CLI::App& app, const CLI::ParseError& failure)
{
    const CLI::App& verb = chosen_verb(app);
    if (dynamic_cast<const CLI::RequiredError*>(&failure)) return what_is_missing(verb);
    if (!dynamic_cast<const CLI::ExtrasError*>(&failure)) return {};
    const std::vector<std::string> left = app.remaining(true);
    if (left.empty()) return {};
    if (left.front().starts_with('-')) return unknown_option(verb, left.front());
    return fmt::format("{} takes no further word \"{}\".", full_name(verb), left.front());
}

std::string where_to_read(const CLI::App& app, const std::vector<std::string>& given)
{
    return fmt::format("See {} --help.", full_name(*named(app, given).verb));
}

std::string help_on(const CLI::App& app, const std::vector<std::string>& words)
{
    const CLI::App& verb = *named(app, words).verb;
    return verb.get_formatter()->make_help(&verb, full_name(verb), CLI::AppFormatMode::Normal);
}

} // namespace hygroloom
