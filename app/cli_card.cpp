// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// card: the technical card of a fabric, with the numbers that a laboratory measures.
#include "app/cli.h"
#include "app/cli_report.h"

#include "core/analysis/card.h"
#include "core/project/atomic_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace hygroloom {
namespace {

struct CardOptions : ProjectOptions {
    std::string output;
    CardRequest request;
};

std::string ending_of(const std::string& file) { return CLI::detail::to_lower(std::filesystem::path(file).extension().string()); }

void check_name(const std::string& file)
{
    const std::string ending = ending_of(file);
    const bool known = ending == ".html" || ending == ".pdf" || ending == ".txt" || ending == ".csv" || ending == ".json";
    if (!file.empty() && !known)
        throw Stop(exit_usage, "-o: A card is an .html, .pdf, .txt, .csv or .json file; given is \"" + file + "\".");
    if (ending == ".pdf") check_report_name(file);
}

void write_card(const Card& card, const Design& design, const Fabric& fabric, const FittedFabric& fitted, const std::string& file)
{
    const std::string ending = ending_of(file);
    if (ending == ".csv") return write_file(file, card_csv(card));
    if (ending == ".json") return write_file(file, card_json(card).dump(2) + "\n");
    write_report_file(file, card_page(card, card_pictures(design, fabric, fitted)));
}

void print_card(const Card& card)
{
    print_result("{}\n", card.fabric);
    for (const PageRow& row : construction_rows(card)) print_result("  {:<44} {:>7} {}\n", row[0].text, row[1].text, row[2].text);
    for (const YarnUse& use : card.technical.yarns)
        print_result("  {:<44} {:>7.4g} g/m     {:.3g} tex, crimp {:.3g} %, take-up {:.3g} %\n", name_of(use), use.grams_per_metre, use.tex,
                     use.crimp_percent, use.take_up_percent());
    print_result("  {:<44} {:>7.4g} g/m     of {:.4g} cm\n", "yarn, together", card.technical.grams_per_metre, card.technical.width_cm);
    if (card.technical.yarn_cost_per_metre) print_result("  {:<44} {:>7.4g} a metre\n", "yarn cost", *card.technical.yarn_cost_per_metre);
    for (const LaboratoryNumber& number : card.numbers.found)
        print_result("  {:<44} {:>7} {:<12} {:<18} {}\n", number.title, value_text(number.estimate), number.unit,
                     range_text(number.estimate), number.standard);
    for (const auto* notes : {&card.technical.notes, &card.numbers.missing})
        for (const std::string& note : *notes) print_result("  {}\n", note);
}

int card(const CardOptions& options)
{
    check_name(options.output);
    const Design design = load_project(options);
    const FittedFabrics fitted = require_valid(design, options);
    const Fabric& fabric = chosen_fabric(design, options);
    const FittedFabric& own = *fitted[static_cast<std::size_t>(&fabric - design.fabrics.data())];
    const Card found = card_of(design, fabric, own, options.request);
    if (!options.output.empty()) write_card(found, design, fabric, own, options.output);
    if (options.json)
        print_json(card_json(found));
    else if (options.output.empty())
        print_card(found);
    else if (!options.quiet)
        print_note("{}\n", options.output);
    return exit_ok;
}

} // namespace

void add_card(CLI::App& app, Verb& verb)
{
    auto options = std::make_shared<CardOptions>();
    CLI::App& card_verb =
        *app.add_subcommand("card", "Technical card of a fabric: construction, yarn for a metre, numbers of a laboratory");
    card_verb.footer("Example: hygroloom-cli card cloth.hygro --fabric \"Textile F\" -o card.html");
    add_project_options(card_verb, *options, false);
    card_verb.add_option("-o,--output", options->output, "The card as .html, .pdf, .txt, .csv or .json");
    card_verb.add_option("--width-cm", options->request.width_cm, "Finished width. Default: by the loom's keys, else 150")
        ->check(CLI::Range(1.0, 2000.0));
    card_verb.add_option("--waste-percent", options->request.waste_percent, "Waste of all yarn")
        ->check(CLI::Range(0.0, 100.0))
        ->capture_default_str();
    card_verb.add_option("--tails-cm", options->request.tails_cm, "Weft beyond the reed, both sides together")
        ->check(CLI::Range(0.0, 100.0))
        ->capture_default_str();
    card_verb.add_option("--length-m", options->request.length_m, "Metres that are ordered")
        ->check(CLI::Range(0.0, 1e7))
        ->capture_default_str();
    card_verb.callback([&verb, options] { verb = [options] { return card(*options); }; });
}

} // namespace hygroloom
