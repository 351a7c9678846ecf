// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The man page hygroloom-cli(1), from the option table.
#include "app/cli_reference.h"

#include "app/cli.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace hygroloom {
namespace {

/// Text that roff takes as it is: no requests, no escapes, no hyphens in the place of minus signs.
std::string roff(const std::string& text)
{
    std::string escaped;
    for (const char c : text) {
        const bool opens = escaped.empty() || escaped.back() == '\n';
        if (opens && (c == '.' || c == '\'')) escaped += "\\&";
        if (c == '\\') {
            escaped += "\\e";
            continue;
        }
        if (c == '-') escaped += '\\';
        escaped += c;
    }
    return escaped;
}

std::string bold(const std::string& text) { return "\\fB" + roff(text) + "\\fR"; }
std::string slanted(const std::string& text) { return "\\fI" + roff(text) + "\\fR"; }

std::string placeholder(const DescribedOption& option)
{
    if (option.choices.empty()) return slanted(option.value);
    std::vector<std::string> words;
    for (const std::string& word : option.choices) words.push_back(bold(word));
    return fmt::format("{}", fmt::join(words, "|"));
}

std::string synopsis(const DescribedVerb& verb)
{
    std::string text = fmt::format(".B hygroloom\\-cli {}\n", roff(verb.name));
    for (const DescribedOption& option : verb.options) {
        const std::string shown = option.positional      ? slanted(option.names.back())
                                  : option.value.empty() ? bold(option.names.back())
                                                         : bold(option.names.back()) + " " + placeholder(option);
        if (option.names.back() != "--help") text += option.required ? shown + "\n" : "[" + shown + "]\n";
    }
    return text;
}

std::string entry(const DescribedOption& option)
{
    std::vector<std::string> names;
    for (const std::string& name : option.names) names.push_back(option.positional ? slanted(name) : bold(name));
    std::string text = fmt::format(".TP\n{}", fmt::join(names, ", "));
    if (!option.positional && !option.value.empty()) text += " " + placeholder(option);
    text += "\n" + roff(option.meaning) + ".\n";
    if (!option.usual.empty()) text += "Default: " + roff(option.usual) + ".\n";
    return text;
}

/// Each line of notes is a sentence or more; on a page they flow together.
std::string section(const DescribedVerb& verb)
{
    std::string text = fmt::format(".SS {}\n{}.\n.PP\n{}", verb.name, roff(verb.meaning), synopsis(verb));
    if (!verb.notes.empty()) text += ".PP\n" + roff(verb.notes) + "\n";
    if (!verb.example.empty()) text += ".PP\nExample:\n.PP\n.RS 4\n.nf\n" + roff(verb.example) + "\n.fi\n.RE\n";
    for (const DescribedOption& option : verb.options) text += entry(option);
    return text;
}

std::string knobs()
{
    std::string text = ".SH KNOBS\n" + bold("--set fidelity.") + slanted("knob") + bold("=") + slanted("value") +
                       " changes one of the numbers that " + bold("--fidelity") +
                       " sets together. Behind each stand its values at live, draft, standard and reference.\n";
    for (const KnobInfo& knob : knob_table())
        text +=
            fmt::format(".TP\n{}: {}{}{}\n{}.\n", bold(knob.name), values_of(knob), *knob.unit ? " " : "", knob.unit, roff(knob.meaning));
    return text;
}

std::string exit_codes()
{
    const std::pair<ExitCode, const char*> codes[] = {{exit_ok, "The verb did what was asked."},
                                                      {exit_failed, "It failed; a sentence on the standard error says why."},
                                                      {exit_usage, "The arguments are wrong."},
                                                      {exit_invalid, "The project or another input file is not valid."},
                                                      {exit_no_device, "The requested GPU cannot be used."},
                                                      {exit_cancelled, "Ctrl\\-C or a polite kill cancelled it."}};
    std::string text = ".SH EXIT STATUS\n";
    for (const auto& [code, meaning] : codes) text += fmt::format(".TP\n.B {}\n{}\n", int(code), meaning);
    return text;
}

} // namespace

std::string manual_page(const CLI::App& app)
{
    std::string summary = app.get_description();
    summary.front() = CLI::detail::to_lower(summary.substr(0, 1)).front();
    summary.pop_back();
    std::string text = ".\\\" SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime\n"
                       ".\\\" Written by `hygroloom-cli reference --as man`.\n"
                       ".TH HYGROLOOM\\-CLI 1 \"\" \"Hygroloom " HYGROLOOM_VERSION "\" \"User Commands\"\n"
                       ".SH NAME\nhygroloom\\-cli \\- ";
    text += roff(summary) + "\n.SH SYNOPSIS\n.B hygroloom\\-cli\n.I VERB\n.RI [ OPTIONS ]\n";
    text += ".SH DESCRIPTION\n.B hygroloom\\-cli\nruns one task for each verb. Results go to the standard output, everything else to the "
            "standard error.\nIt uses no network. It writes the files that its arguments name. In $XDG_CACHE_HOME/hygroloom it keeps how "
            "long runs "
            "took and what it found of the rooms between yarns; that folder may be deleted.\n.SH OPTIONS\n";
    for (const DescribedOption& option : described_options(app)) text += entry(option);
    text += ".SH VERBS\n";
    for (const DescribedVerb& verb : described_verbs(app)) text += section(verb);
    return text + knobs() + exit_codes() +
           ".SH SEE ALSO\n.BR hygroloom (1)\n.PP\nThe guide is in /usr/share/hygroloom/help, in the window under F1.\n";
}

} // namespace hygroloom
