// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Completion of verbs, options and their values in bash, zsh and fish, from the option table.
#include "app/cli_reference.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace hygroloom {
namespace {

constexpr const char* head = "# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime\n"
                             "# Written by `hygroloom-cli reference --as {}`.\n";

/// With a backslash before each of these characters.
std::string escaped(const std::string& text, const std::string& characters)
{
    std::string result;
    for (const char c : text) {
        if (characters.find(c) != std::string::npos) result += '\\';
        result += c;
    }
    return result;
}

/// Within single quotes of bash and zsh.
std::string quoted(const std::string& text)
{
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

std::vector<std::string> all_names(const std::vector<DescribedOption>& options)
{
    std::vector<std::string> names;
    for (const DescribedOption& option : options)
        if (!option.positional) names.insert(names.end(), option.names.begin(), option.names.end());
    return names;
}

/// Of a verb's options that take a value, the pattern "verb -o"|"verb --output" of a bash case.
std::string bash_case(const std::string& verb, const DescribedOption& option)
{
    std::vector<std::string> patterns;
    for (const std::string& name : option.names) patterns.push_back(fmt::format("\"{} {}\"", verb, name));
    return fmt::format("{}", fmt::join(patterns, "|"));
}

std::string bash_verb(const DescribedVerb& verb)
{
    std::string text, first;
    bool files = false, others = false; // among what stands without a name
    for (const DescribedOption& option : verb.options) {
        if (option.positional && !option.choices.empty() && !others)
            first =
                fmt::format("    \"{0} {0}\") if [[ $word == -* ]]; then words=\"{1}\"; else words=\"{2}\"; compopt +o default; fi ;;\n",
                            verb.name, fmt::join(all_names(verb.options), " "), fmt::join(option.choices, " "));
        others = others || option.positional;
        files = files || (option.positional && option.takes_path);
        if (option.positional || option.value.empty()) continue;
        const std::string pattern = bash_case(verb.name, option);
        if (option.takes_path)
            text += fmt::format("    {}) ;;\n", pattern);
        else if (option.choices.empty())
            text += fmt::format("    {}) compopt +o default ;;\n", pattern);
        else
            text += fmt::format("    {}) words=\"{}\" ;;\n", pattern, fmt::join(option.choices, " "));
    }
    return text + first +
           fmt::format("    \"{} \"*) [[ $word == -* ]] && words=\"{}\"{} ;;\n", verb.name, fmt::join(all_names(verb.options), " "),
                       files ? "" : " || compopt +o default");
}

/// "(-o --output)"{-o,--output}"[meaning]:value:_files"
std::string zsh_option(const DescribedOption& option)
{
    const std::string meaning = escaped(option.meaning, "[]:\\");
    std::string action;
    if (!option.value.empty()) {
        action = fmt::format(":{}:", escaped(option.value, ":\\"));
        if (option.takes_path) action += "_files";
        if (!option.choices.empty()) action += fmt::format("({})", fmt::join(option.choices, " "));
    }
    if (option.positional) return quoted(fmt::format("{}{}", option.required ? "" : ":", action));
    const std::string rest = quoted(fmt::format("[{}]{}", meaning, action));
    const bool repeats = option.value.find('=') != std::string::npos; // as --set
    if (option.names.size() == 1) return (repeats ? quoted("*") : "") + option.names.front() + rest;
    return fmt::format("'({})'{{{}}}{}", fmt::join(option.names, " "), fmt::join(option.names, ","), rest);
}

std::string fish_option(const DescribedVerb& verb, const DescribedOption& option)
{
    const auto in_quotes = [](const std::string& text) { return "'" + escaped(text, "'\\") + "'"; };
    std::string text = fmt::format("complete -c hygroloom-cli -n '__fish_seen_subcommand_from {}'", verb.name);
    if (option.positional && !option.choices.empty())
        return fmt::format(
            "complete -c hygroloom-cli -n '__fish_seen_subcommand_from {0}; and not __fish_seen_subcommand_from {1}' -a '{1}'\n", verb.name,
            fmt::join(option.choices, " "));
    if (option.positional) return option.takes_path ? text + " -F\n" : "";
    for (const std::string& name : option.names) text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    if (option.takes_path)
        text += " -r -F";
    else if (!option.value.empty())
        text += " -x";
    if (!option.choices.empty()) text += fmt::format(" -a '{}'", fmt::join(option.choices, " "));
    return text + " -d " + in_quotes(option.meaning) + "\n";
}

} // namespace

std::string bash_completion(const CLI::App& app)
{
    std::string cases, verbs;
    for (const DescribedVerb& verb : described_verbs(app)) {
        verbs += (verbs.empty() ? "" : " ") + verb.name;
        cases += bash_verb(verb);
    }
    return fmt::format(head, "bash") + fmt::format(R"(_hygroloom_cli()
{{
    local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} verb="" words="" i
    for ((i = 1; i < COMP_CWORD; ++i)); do
        [[ ${{COMP_WORDS[i]}} == -* ]] || {{ verb=${{COMP_WORDS[i]}}; break; }}
    done
    COMPREPLY=()
    case "$verb $before" in
    " "*) words="{} {}" ;;
{}    esac
    [[ -z $words ]] || mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}}
complete -o default -F _hygroloom_cli hygroloom-cli
)",
                                                   verbs, fmt::join(all_names(described_options(app)), " "), cases);
}

std::string zsh_completion(const CLI::App& app)
{
    std::string verbs, cases;
    for (const DescribedVerb& verb : described_verbs(app)) {
        verbs += fmt::format("    {}\n", quoted(verb.name + ":" + verb.meaning));
        cases += fmt::format("  {}) _arguments", verb.name);
        for (const DescribedOption& option : verb.options) cases += " \\\n    " + zsh_option(option);
        cases += " ;;\n";
    }
    std::string own;
    for (const DescribedOption& option : described_options(app)) own += " \\\n    " + zsh_option(option);
    return "#compdef hygroloom-cli\n" + fmt::format(head, "zsh") +
           fmt::format(R"(local -a verbs
if (( CURRENT == 2 )); then
  verbs=(
{}  )
  _describe verb verbs
  _arguments{}
  return
fi
shift words
(( CURRENT-- ))
case $words[1] in
{}esac
)",
                       verbs, own, cases);
}

std::string fish_completion(const CLI::App& app)
{
    std::string text = fmt::format(head, "fish") + "complete -c hygroloom-cli -f\n";
    const DescribedVerb own{"", "", "", "", described_options(app)};
    for (const DescribedOption& option : own.options) {
        std::string line = fish_option(own, option);
        const std::string seen = "'__fish_seen_subcommand_from '";
        text += line.replace(line.find(seen), seen.size(), "__fish_use_subcommand");
    }
    for (const DescribedVerb& verb : described_verbs(app)) {
        text += fmt::format("complete -c hygroloom-cli -n __fish_use_subcommand -a {} -d '{}'\n", verb.name, escaped(verb.meaning, "'\\"));
        for (const DescribedOption& option : verb.options) text += fish_option(verb, option);
    }
    return text;
}

} // namespace hygroloom
