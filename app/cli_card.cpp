// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// card: the technical card of a fabric, with the numbers that a laboratory measures.
#include "app/cli_interrupt.h"
#include "app/cli_replicates.h"
#include "app/cli_report.h"

#include "core/analysis/card.h"
#include "core/project/atomic_file.h"
#include "core/queue/card_runs.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace hygroloom {
namespace {

struct CardOptions : RunVerbOptions {
    std::string output;
    CardRequest request;
    std::string runs; ///< tests, separated by commas
    std::string fidelity = "live";
    int replicates = 1;
    std::string keep;
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
    const auto kilograms = [&card](double grams_per_metre) {
        return fmt::format("{:.4g} kg for {:g} m", 1e-3 * grams_per_metre * told_length_m(card), told_length_m(card));
    };
    for (const YarnConsumption& use : card.technical.yarns) {
        const std::string cost = use.cost_per_metre ? fmt::format("cost {:.3g} per m", *use.cost_per_metre) : "no price";
        print_result("  {:<44} {:>7.4g} g/m     {:.3g} tex, crimp {:.3g} %, take-up {:.3g} %, {}{}\n", name_of(use), use.grams_per_metre,
                     use.tex, use.crimp_percent, use.take_up_percent(), kilograms(use.grams_per_metre),
                     has_prices(card) ? ", " + cost : std::string());
    }
    print_result("  {:<44} {:>7.4g} g/m     of {:.4g} cm, {}\n", "yarn, together", card.technical.grams_per_metre, card.technical.width_cm,
                 kilograms(card.technical.grams_per_metre));
    if (card.technical.yarn_cost_per_metre)
        print_result("  {:<44} {:>7.4g} per m   in the currency of the prices\n", "yarn cost", *card.technical.yarn_cost_per_metre);
    for (const LaboratoryNumber& number : card.numbers.found) {
        const std::string run = number.run.empty() ? std::string() : " (" + number.run + ")";
        print_result("  {:<44} {:>7} {:<12} {:<18} {}{}\n", number.title, value_text(number), number.unit, range_text(number.estimate),
                     number.standard, run);
    }
    for (const std::string& sentence : sentences_below(card)) print_result("  {}\n", sentence);
}

/// Adds the numbers of the tests that were asked for. Whether none was stopped.
bool run_tests(Card& card, const Design& design, const Fabric& fabric, const CardRuns& what, const CardOptions& options)
{
    make_folder(options.keep);
    CardJobs jobs = card_jobs(design, fabric, card.numbers, what);
    std::atomic<bool> cancel{false};
    const InterruptCancels cancels(cancel);
    RunQueue queue;
    const std::size_t runs = jobs.jobs.size() * static_cast<std::size_t>(what.replicates);
    std::shared_ptr<RunPlaces> places;
    if (runs > 0) places = open_places(options, 0, static_cast<int>(runs), static_cast<std::size_t>(jobs.bytes));
    RunBar bar(options.quiet, runs);
    ComparedWatch watch;
    watch.begins = [&](std::size_t i, RunJob& job) { job.beside = shown_in(bar, i, job.experiment); };
    watch.ended = [&](std::size_t i) { bar.end(i); };
    card.numbers = run_card_jobs(jobs, what.replicates, queue, places, cancel, watch);
    return !cancel;
}

CardRuns runs_of(const CardOptions& options)
{
    CardRuns what;
    what.tests = as_usage([&] { return card_test_keys(words_of(options.runs)); });
    what.how = run_options(options);
    what.how.fidelity = as_usage([&] { return fidelity_from_name(options.fidelity); });
    what.how.may_go_on_on_cpu = true;
    what.replicates = options.replicates;
    what.kept = options.keep;
    return what;
}

int card(const CardOptions& options)
{
    check_name(options.output);
    const CardRuns what = runs_of(options);
    const Design design = load_project(options);
    const FittedFabrics fitted = require_valid(design, options);
    const Fabric& fabric = chosen_fabric(design, options);
    const FittedFabric& own = *fitted[static_cast<std::size_t>(&fabric - design.fabrics.data())];
    Card found = card_of(design, fabric, own, options.request);
    const bool whole = what.tests.empty() || run_tests(found, design, fabric, what, options);
    if (!options.output.empty()) write_card(found, design, fabric, own, options.output);
    if (options.json)
        print_json(card_json(found));
    else if (options.output.empty())
        print_card(found);
    else if (!options.quiet)
        print_note("{}\n", options.output);
    if (!whole) print_note("Cancelled; numbers of tests that did not end are missing.\n");
    return whole ? exit_ok : exit_cancelled;
}

} // namespace

void add_card(CLI::App& app, Verb& verb)
{
    auto options = std::make_shared<CardOptions>();
    CLI::App& card_verb =
        *app.add_subcommand("card", "Technical card of a fabric: construction, yarn for a metre, numbers of a laboratory");
    card_verb.footer("Example: hygroloom-cli card cloth.hygro --fabric \"Textile F\" -o card.html\n"
                     "With what needs runs, a minute or two: hygroloom-cli card cloth.hygro --fabric \"Textile F\" --runs all");
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
    card_verb
        .add_option("--runs", options->runs,
                    "Tests to run for their numbers, separated by commas: absorbency, wicking_warp, wicking_weft, management, drying, "
                    "regain; or all")
        ->type_name("TESTS");
    card_verb.add_option("--fidelity", options->fidelity, "With --runs: how finely to compute")
        ->type_name("{live,draft,standard,reference}")
        ->capture_default_str();
    add_replicates_option(card_verb, options->replicates, " of each test");
    card_verb
        .add_option("--keep", options->keep,
                    "With --runs: folder of their recordings; one of the same cloth there stands for a run, at the fidelity or a finer one")
        ->type_name("FOLDER");
    add_physics_option(card_verb, *options);
    add_machine_options(card_verb, *options);
    card_verb.callback([&verb, options] { verb = [options] { return card(*options); }; });
}

} // namespace hygroloom
