// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// card: the technical card of a fabric, with the numbers that a laboratory measures.
#include "app/cli.h"
#include "app/cli_report.h"

#include "core/analysis/card.h"
#include "core/base/text.h"
#include "core/project/atomic_file.h"
#include "core/project/mesh_file.h"
#include "core/project/texture_files.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace hygroloom {
namespace {

struct CardOptions : ProjectOptions {
    std::string output;
    CardRequest request;
};

bool is_csv(const std::string& file) { return CLI::detail::to_lower(std::filesystem::path(file).extension().string()) == ".csv"; }

/// The top face at true scale: as many repeats as make it 20 mm wide and high at least; none where a repeat is larger than pictures are.
std::vector<ReportPicture> pictures_of(const Fabric& fabric, const FittedFabric& fitted)
{
    constexpr double side_mm = 20, dpi = 400;
    const auto repeats = [](double sett, int threads) { return std::max(1, static_cast<int>(std::ceil(side_mm * 0.1 * sett / threads))); };
    const Textile textile = build_textile(
        fabric, fitted,
        region_of_repeats(fabric, repeats(fabric.ends_per_cm, fabric.weave.ends()), repeats(fabric.picks_per_cm, fabric.weave.picks())));
    TextureSize size;
    try {
        size = texture_size(textile, dpi);
    } catch (const Error&) {
        return {};
    }
    const TexturePixels pixels = texture_pixels(textile, fabric, size, 1);
    ReportPicture picture{fabric.name + ", top face", {pixels.columns, pixels.rows, {}}, size.width_mm};
    for (std::size_t i = 0; i < pixels.colour.size(); i += 4)
        for (std::size_t part = 0; part < 3; ++part) {
            const int opacity = pixels.colour[i + 3], white = 255;
            picture.image.rgb.push_back(static_cast<std::uint8_t>((pixels.colour[i + part] * opacity + white * (white - opacity)) / white));
        }
    return {picture};
}

void print_card(const Card& card)
{
    print_result("{}\n", card.fabric);
    for (const YarnUse& use : card.technical.yarns)
        print_result("  {:<34} {:>9.4g} g/m     {:.3g} tex, crimp {:.3g} %, take-up {:.3g} %\n", use.warp ? "warp" : "weft",
                     use.grams_per_metre, use.tex, use.crimp_percent, use.take_up_percent());
    print_result("  {:<34} {:>9.4g} g/m     of {:g} cm\n", "yarn, together", card.technical.grams_per_metre, card.technical.width_cm);
    if (card.technical.yarn_cost_per_metre) print_result("  {:<34} {:>9.4g} a metre\n", "yarn cost", *card.technical.yarn_cost_per_metre);
    for (const LaboratoryNumber& number : card.numbers) {
        const Estimate& e = number.estimate;
        const std::string range = e.low < e.high ? fmt::format("{:.3g} to {:.3g}", e.low, e.high) : std::string();
        print_result("  {:<34} {:>9.3g} {:<9} {:<18} {}\n", cut_text(number.title, 34), e.value, number.unit, range, number.standard);
    }
    for (const std::string& note : card.technical.notes) print_result("  {}\n", note);
}

int card(const CardOptions& options)
{
    if (!is_csv(options.output)) check_report_name(options.output);
    const Design design = load_project(options);
    const FittedFabrics fitted = require_valid(design, options);
    const Fabric& fabric = chosen_fabric(design, options);
    const FittedFabric& own = *fitted[static_cast<std::size_t>(&fabric - design.fabrics.data())];
    const Card found = card_of(design, fabric, own, options.request);
    if (is_csv(options.output))
        write_file(options.output, card_csv(found));
    else if (!options.output.empty())
        write_report_file(options.output, card_page(found, pictures_of(fabric, own)));
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
    card_verb.add_option("-o,--output", options->output, "The card as .html, .pdf, .txt or .csv");
    card_verb.add_option("--width-cm", options->request.width_cm, "Finished width")->check(CLI::Range(1.0, 2000.0))->capture_default_str();
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
