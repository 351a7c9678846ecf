// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// reference: the schema of projects; every verb and option as Markdown for the user's guide, as a man page and as completion of shells,
// from the option table itself.
#include "app/cli_reference.h"

#include "app/cli.h"
#include "core/project/project_schema.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

namespace hygroloom {
namespace {

/// "-o", "--output"; a positional argument is in capitals, as in the usage line.
std::vector<std::string> names_of(const CLI::Option& option)
{
    std::vector<std::string> names;
    for (const std::string& name : option.get_snames()) names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
    if (!names.empty()) return names;
    std::string name = option.get_name(true);
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return {name};
}

/// "TEXT:{auto,cpu}" is "auto, cpu", "INT:INT in [1 - 9]" is "1 to 9", "FLOAT:SECONDS" is "seconds".
std::string value_of(const CLI::Option& option)
{
    std::string type = option.get_type_name();
    type.erase(0, type.find(':') + 1);
    const auto replace = [&](const std::string& from, const std::string& to) {
        for (std::size_t at = type.find(from); at != std::string::npos; at = type.find(from, at + to.size()))
            type.replace(at, from.size(), to);
    };
    const bool words = type.starts_with('{');
    for (const char* left_out : {"INT in ", "FLOAT in ", "{", "}", "[", "]"}) replace(left_out, "");
    replace(",", ", ");
    replace(" - ", " to ");
    if (type == "UINT" || type == "INT") type = "whole number";
    return words || type.find('=') != std::string::npos ? type : CLI::detail::to_lower(type);
}

std::vector<std::string> choices_of(const CLI::Option& option)
{
    const std::string type = option.get_type_name();
    const std::size_t opens = type.find('{'), closes = type.find('}');
    return opens == std::string::npos ? std::vector<std::string>() : CLI::detail::split(type.substr(opens + 1, closes - opens - 1), ',');
}

DescribedOption described(const CLI::Option& option)
{
    DescribedOption said;
    const bool flag = option.get_expected_max() == 0;
    said.names = names_of(option);
    said.positional = option.get_positional();
    said.required = option.get_required();
    said.meaning = option.get_description();
    if (flag) return said;
    said.value = value_of(option);
    said.choices = choices_of(option);
    said.takes_path = said.value == "file" || said.value == "folder";
    if (!said.required && option.get_default_str() != "[]") said.usual = option.get_default_str();
    return said;
}

/// A cell of a Markdown table.
std::string cell(const std::string& text)
{
    std::string escaped;
    for (const char c : text) {
        if (c == '|') escaped += '\\';
        escaped += c == '\n' ? ' ' : c;
    }
    return escaped;
}

std::string options_table(const DescribedVerb& verb)
{
    std::string text = "| Option | Value | Default | Meaning |\n| --- | --- | --- | --- |\n";
    for (const DescribedOption& option : verb.options)
        text += fmt::format("| `{}` | {} | {} | {} |\n", fmt::join(option.names, "`, `"), cell(option.value),
                            option.required ? "required" : cell(option.usual), cell(option.meaning));
    return text;
}

std::string reference(const CLI::App& app)
{
    std::string text = fmt::format("# Command-line reference\n\n{} `hygroloom-cli VERB --help` prints the same for one verb. "
                                   "The examples use what [the guide's first page](index.md) makes.\n\n",
                                   app.get_description());
    for (const DescribedVerb& verb : described_verbs(app)) {
        text += fmt::format("## {}\n\n{}.\n\n", verb.name, verb.meaning);
        if (verb.name == "tradeoff" || verb.name == "calibrate")
            text += "<!-- not run: it takes minutes -->\n\n"; // a word to the test of the guide
        if (!verb.example.empty()) text += "```sh\n" + verb.example + "\n```\n\n";
        if (!verb.notes.empty()) text += verb.notes + "\n\n";
        text += options_table(verb) + "\n";
    }
    text += "## Knobs\n\n`--set fidelity.<knob>=value` changes one of the numbers that `--fidelity` sets together.\n\n"
            "| Knob | live | draft | standard | reference | Unit | Meaning |\n| --- | --- | --- | --- | --- | --- | --- |\n";
    for (const KnobInfo& knob : knob_table())
        text += fmt::format("| `{}` | {} | {} | {} |\n", knob.name, values_of(knob, " | "), knob.unit, cell(knob.meaning));
    return text;
}

struct Form {
    const char* name;
    std::string (*written)(const CLI::App&);
};
constexpr Form forms[] = {{"markdown", reference},   {"man", manual_page},
                          {"bash", bash_completion}, {"zsh", zsh_completion},
                          {"fish", fish_completion}, {"schema", [](const CLI::App&) { return project_schema().dump(2) + "\n"; }}};

} // namespace

std::vector<DescribedOption> described_options(const CLI::App& app)
{
    std::vector<DescribedOption> options;
    for (const CLI::Option* option : app.get_options())
        if (!option->get_group().empty()) options.push_back(described(*option));
    return options;
}

std::vector<DescribedVerb> described_verbs(const CLI::App& app)
{
    std::vector<DescribedVerb> verbs;
    for (const CLI::App* of : app.get_subcommands([](const CLI::App* verb) { return !verb->get_group().empty(); })) {
        DescribedVerb verb{of->get_name(), of->get_description(), "", "", described_options(*of)};
        // The footer's first paragraph: an example and notes. Tables may follow it.
        const std::string footer = of->get_footer(), example = "Example: ";
        verb.notes = footer.substr(0, footer.find("\n\n"));
        if (verb.notes.starts_with(example)) {
            const std::size_t line = std::min(verb.notes.find('\n'), verb.notes.size());
            verb.example = verb.notes.substr(example.size(), line - example.size());
            verb.notes.erase(0, line + 1);
        }
        verbs.push_back(std::move(verb));
    }
    return verbs;
}

void add_reference(CLI::App& app, Verb& chosen)
{
    CLI::App& verb = *app.add_subcommand(
        "reference", "Every verb and option, as Markdown, as a man page or as completion of a shell; or the JSON schema of projects");
    verb.group(""); // not in the list of verbs: it is for the guide and for packages
    auto form = std::make_shared<std::string>("markdown");
    std::vector<std::string> names;
    for (const Form& known : forms) names.emplace_back(known.name);
    verb.add_option("--as", *form, "What is written")->check(CLI::IsMember(names));
    verb.callback([&chosen, &app, form] {
        chosen = [&app, form] {
            for (const Form& known : forms)
                if (*form == known.name) print_result("{}", known.written(app));
            return int{exit_ok};
        };
    });
}

} // namespace hygroloom
