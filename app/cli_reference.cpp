// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// reference: every verb and option as Markdown, from the option table itself, for the user's guide.
#include "app/cli.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace hygroloom {
namespace {

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

/// "`-o`, `--output`"; a positional argument is in capitals, as in the usage line.
std::string names_of(const CLI::Option& option)
{
    if (option.get_positional() || option.nonpositional()) {
        std::string names;
        for (const std::string& name : option.get_snames()) names += (names.empty() ? "`-" : ", `-") + name + "`";
        for (const std::string& name : option.get_lnames()) names += (names.empty() ? "`--" : ", `--") + name + "`";
        if (!names.empty()) return names;
    }
    std::string name = option.get_name(true);
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return "`" + name + "`";
}

/// "TEXT:{auto,cpu}" is "auto, cpu", "INT:INT in [1 - 9]" is "1 to 9", "FLOAT:SECONDS" is "seconds".
std::string values_of(const CLI::Option& option)
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

std::string options_table(const CLI::App& verb)
{
    std::string text = "| Option | Value | Default | Meaning |\n| --- | --- | --- | --- |\n";
    for (const CLI::Option* option : verb.get_options()) {
        if (option->get_group().empty()) continue;
        const bool flag = option->get_expected_max() == 0;
        const std::string preset = option->get_default_str();
        const std::string usual = option->get_required() ? "required" : flag || preset == "[]" ? "" : preset;
        text += fmt::format("| {} | {} | {} | {} |\n", names_of(*option), flag ? "" : cell(values_of(*option)), cell(usual),
                            cell(option->get_description()));
    }
    return text;
}

/// The first paragraph of a verb's footer: its example and its notes.
std::string notes_of(const CLI::App& verb)
{
    const std::string footer = verb.get_footer();
    const std::string first = footer.substr(0, footer.find("\n\n"));
    const std::size_t line = first.find('\n');
    const std::string example = "Example: ";
    if (!first.starts_with(example)) return first.empty() ? "" : first + "\n\n";
    std::string text = "```sh\n" + first.substr(example.size(), line - example.size()) + "\n```\n\n";
    if (line != std::string::npos) text += first.substr(line + 1) + "\n\n";
    return text;
}

std::string reference(const CLI::App& app)
{
    std::string text =
        fmt::format("# Command-line reference\n\n{} `hygroloom-cli VERB --help` prints the same for one verb.\n\n", app.get_description());
    for (const CLI::App* verb : app.get_subcommands([](const CLI::App* of) { return !of->get_group().empty(); }))
        text += fmt::format("## {}\n\n{}.\n\n{}{}\n", verb->get_name(), verb->get_description(), notes_of(*verb), options_table(*verb));
    text += "## Knobs\n\n`--set fidelity.<knob>=value` changes one of the numbers that `--fidelity` sets together.\n\n"
            "| Knob | draft | standard | reference | Unit | Meaning |\n| --- | --- | --- | --- | --- | --- |\n";
    const Knobs draft = knobs_of(Fidelity::draft), standard = knobs_of(Fidelity::standard), finest = knobs_of(Fidelity::reference);
    for (const KnobInfo& knob : knob_table())
        text += fmt::format("| `{}` | {:g} | {:g} | {:g} | {} | {} |\n", knob.name, draft.*knob.value, standard.*knob.value,
                            finest.*knob.value, knob.unit, cell(knob.meaning));
    return text;
}

} // namespace

void add_reference(CLI::App& app, Verb& chosen)
{
    CLI::App& verb = *app.add_subcommand("reference", "Every verb and option as Markdown");
    verb.group(""); // not in the list of verbs: it is for the guide
    verb.callback([&chosen, &app] {
        chosen = [&app] {
            print_result("{}", reference(app));
            return int{exit_ok};
        };
    });
}

} // namespace hygroloom
