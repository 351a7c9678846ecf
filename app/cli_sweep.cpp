// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// sweep: studies of many points.
#include "app/cli_sweep.h"

#include "app/cli_interrupt.h"
#include "app/cli_wear.h"

#include "core/base/text.h"
#include "core/base/words.h"
#include "core/project/project_file.h"
#include "gpu/backends.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <unistd.h>

namespace hygroloom {
namespace {

using Json = nlohmann::ordered_json;

/// Progress of a study, as a bar on a terminal.
class StudyBar {
public:
    explicit StudyBar(bool quiet) : shown_(!quiet && isatty(STDERR_FILENO)) {}
    ~StudyBar() { clear(); }
    StudyBar(const StudyBar&) = delete;
    StudyBar& operator=(const StudyBar&) = delete;

    void show(const StudyProgress& progress)
    {
        if (!shown_) return;
        constexpr int width = 30;
        const double all = progress.rows > 0 ? static_cast<double>(progress.rows) : 1;
        const double share = (static_cast<double>(progress.kept) + progress.share * (all - static_cast<double>(progress.kept))) / all;
        const int full = static_cast<int>(share * width);
        const std::optional<double> to_go = time_left(progress.share, progress.wall);
        draw_line(fmt::format("[{}{}] {} of {} runs{}, {:.0f} s{}", std::string(static_cast<std::size_t>(full), '#'),
                              std::string(static_cast<std::size_t>(width - full), '.'), progress.ended, progress.rows,
                              progress.failed > 0 ? fmt::format(", {} failed", progress.failed) : "", progress.wall,
                              to_go ? fmt::format(", about {:.0f} s left", *to_go) : ""));
    }
    void clear()
    {
        if (shown_) draw_line("");
    }

private:
    bool shown_;
};

/// Which slice "3/64" is. Throws Stop.
std::pair<int, int> slice_of(const std::string& text)
{
    int task = 0, tasks = 0;
    const char* const end = text.data() + text.size();
    auto [slash, failure] = std::from_chars(text.data(), end, task);
    if (failure == std::errc() && slash != end && *slash == '/') {
        const auto [last, wrong] = std::from_chars(slash + 1, end, tasks);
        if (wrong == std::errc() && last == end && task >= 1 && task <= tasks && tasks <= 1'000'000) return {task, tasks};
    }
    throw Stop(exit_usage, fmt::format("--task: This must be i/n, a slice from 1/n to n/n, as 3/64; given is \"{}\".", text));
}

void print_issues(const std::string& file, const std::vector<Issue>& issues)
{
    for (const Issue& issue : issues) print_issue(file, issue);
    if (has_error(issues)) throw Stop(exit_invalid, file + ": The study has errors; nothing was computed.");
}

StudyFolder read_given(const SweepOptions& options)
{
    Design design = load_project(options);
    require_valid(design, options);
    Study study;
    try {
        study = read_study(options.study);
    } catch (const FileError& error) {
        throw Stop(exit_invalid, error.what());
    }
    for (const auto& [knob, value] : knob_settings(options)) study.knobs[knob] = value;
    print_issues(options.study, validate(study, design));
    if (is_of_garments(study, design)) design = with_absolute_files(design, folder_of(options.project));
    return {design, study, "", ""};
}

StudyShares shares_of(const SweepOptions& options, const StudyNeeds& needs)
{
    const std::string backend = as_usage([&] { return expected_backend(backend_for(options.backend, knob_settings(options))); });
    return backend == "cpu" ? shares_on_cpu(options.jobs, options.threads, usable_threads(), needs)
                            : StudyShares{options.jobs, options.threads};
}

Json outcome_json(const SweepOptions& options, const StudyFolder& study, const StudyOutcome& outcome)
{
    const StudyProgress& progress = outcome.progress;
    Json json{{"format", "hygroloom-sweep"}, {"version", 1}, {"folder", options.folder}, {"rows", progress.rows}};
    json["done"] = progress.ended - progress.failed;
    json["failed"] = progress.failed;
    json["missing"] = progress.rows - progress.ended;
    json["cancelled"] = outcome.cancelled;
    json["wall_s"] = progress.wall;
    json["failures"] = Json::array();
    const auto replicates = static_cast<std::size_t>(study.study.replicates);
    const std::vector<std::string> fabrics = fabrics_of(study.study, study.design), experiments = experiments_of(study.study, study.design);
    for (const auto& [row, reason] : outcome.failures) {
        const std::size_t run = row / replicates;
        json["failures"].push_back({{"point", run / experiments.size() / fabrics.size()},
                                    {"replicate", row % replicates},
                                    {"fabric", fabrics[run / experiments.size() % fabrics.size()]},
                                    {"experiment", experiments[run % experiments.size()]},
                                    {"reason", reason}});
    }
    return json;
}

/// On stdout and stderr, once the rows are there.
void give_outcome(const SweepOptions& options, const StudyFolder& study, const StudyOutcome& outcome)
{
    const Json json = outcome_json(options, study, outcome);
    constexpr std::size_t most_named = 20;
    for (std::size_t i = 0; i < std::min(json["failures"].size(), most_named); ++i) {
        const Json& failure = json["failures"][i];
        const auto fabric = failure["fabric"].get<std::string>();
        print_note("Point {} failed, replicate {}, {}{}: {}\n", failure["point"].get<std::size_t>(),
                   failure["replicate"].get<std::size_t>(), fabric.empty() ? fabric : fabric + ", ",
                   failure["experiment"].get<std::string>(), failure["reason"].get<std::string>());
    }
    if (outcome.progress.failed > most_named) print_note("{} more failed.\n", outcome.progress.failed - most_named);
    if (options.json) {
        print_json(json);
    } else {
        const StudyProgress& progress = outcome.progress;
        print_result("{} of {} runs done, {} failed, {:.1f} s\n", progress.ended - progress.failed, progress.rows, progress.failed,
                     progress.wall);
        if (options.task.empty()) print_result("{}/results.csv\n", options.folder);
    }
}

int run_sweep(const SweepOptions& options)
{
    const StudyFolder study = given_study(options);
    StudyOptions how;
    how.resume = options.resume || options.retry_failed || !options.task.empty();
    how.retry_failed = options.retry_failed;
    how.memory = memory_rule(options);
    if (!options.task.empty()) std::tie(how.task, how.tasks) = slice_of(options.task);
    const StudyNeeds needs = as_usage([&] { return study_needs(study.design, study.study, options.folder, how); });
    const std::string shortage = ask_for_memory("One run of this study", static_cast<double>(needs.bytes_each), how.memory);
    if (!options.quiet && !shortage.empty()) print_note("{}\n", shortage);
    const auto scenes = static_cast<int>(std::max<std::size_t>(needs.rows, 1));
    announce_scenes(options.jobs, scenes);
    const StudyShares shares = shares_of(options, needs);
    how.threads = shares.threads;
    const auto places = open_places(options, options.jobs > 0 ? options.jobs : shares.jobs, scenes, needs.bytes_each);

    std::atomic<bool> cancel{false};
    RunQueue queue;
    const LastWords words = failure_words(
        options.json, exit_cancelled,
        fmt::format("Cancelled. {} keeps every run that has ended; --resume goes on, --merge makes the table of them.", options.folder));
    StudyOutcome outcome;
    {
        const InterruptCancels cancels(cancel, &words);
        StudyBar bar(options.quiet);
        StudyCallbacks callbacks;
        callbacks.progress = [&](const StudyProgress& progress) { bar.show(progress); };
        callbacks.note = [&](const std::string& sentence) {
            bar.clear();
            print_note("{}\n", sentence);
        };
        outcome = run_study(study.design, study.study, options.folder, how, queue, places, cancel, callbacks);
        last_words = nullptr; // what is left ends by itself
    }
    if (outcome.cancelled) {
        write_note(words.note);
        if (options.json) write_result(words.result);
        return exit_cancelled;
    }
    if (options.task.empty()) merge_study(options.folder);
    give_outcome(options, study, outcome);
    if (options.task.empty() && study.study.sensitivity != Sensitivity::none) analyse_after_run(options);
    return outcome.progress.failed > 0 ? exit_failed : exit_ok;
}

int sweep(const SweepOptions& options)
{
    if (options.folder.empty()) throw Stop(exit_usage, "--output: This must be the name of a folder; given is an empty text.");
    if (options.slurm) return submit_to_slurm(options);
    if (options.merge) return merge_rows(options);
    if (options.analyse) return analyse_rows(options);
    if (!options.predict.empty()) return predict_rows(options);
    if (!options.suggest.empty()) return suggest_points(options);
    return run_sweep(options);
}

} // namespace

StudyFolder study_folder(const SweepOptions& options)
{
    try {
        return read_study_folder(options.folder);
    } catch (const FileError& error) {
        throw Stop(exit_invalid, error.what());
    }
}

StudyFolder given_study(const SweepOptions& options)
{
    if (options.project.empty() && options.study.empty()) {
        if (!options.sets.empty())
            throw Stop(exit_usage, "--set: A folder's study stays as it is; give a project and --study to run another one.");
        return study_folder(options);
    }
    if (options.project.empty()) throw Stop(exit_usage, "A project is missing; give its file before the options.");
    if (options.study.empty()) throw Stop(exit_usage, "--study: The study file is missing.");
    return read_given(options);
}

int merge_rows(const SweepOptions& options)
{
    study_folder(options); // says what is wrong with it
    const MergeResult merged = merge_study(options.folder);
    if (options.json)
        print_json(Json{{"format", "hygroloom-sweep"},
                        {"version", 1},
                        {"folder", options.folder},
                        {"rows", merged.rows},
                        {"done", merged.ended - merged.failed},
                        {"failed", merged.failed},
                        {"missing", merged.rows - merged.ended}});
    else
        print_result("{}/results.csv: {} of {} rows, {} failed\n", options.folder, merged.ended, merged.rows, merged.failed);
    if (!merged.missing.empty())
        print_note("{} rows are missing, of the points {}. Run them with --resume.\n", merged.rows - merged.ended, merged.missing);
    return merged.missing.empty() && merged.failed == 0 ? exit_ok : exit_failed;
}

void add_sweep(CLI::App& app, Verb& chosen)
{
    auto options = std::make_shared<SweepOptions>();
    CLI::App& verb = *app.add_subcommand("sweep", "Run a study of many points: change values of a project and see what follows");
    verb.footer("Example: hygroloom-cli sweep cloth.hygro --study study.json -o swept\n"
                "The folder receives results.csv and study.sqlite, a row for each point, fabric, experiment and replicate.\n"
                "Ctrl-C keeps the finished runs; hygroloom-cli sweep -o out --resume goes on.\n"
                "What matters most? hygroloom-cli sweep -o out --analyse");
    add_project_options(verb, *options, false);
    verb.remove_option(verb.get_option("--fabric"));
    verb.get_option("project")->required(false);
    options->takes_knobs = true;
    verb.add_option("--study", options->study, "Study file: factors, design, fabrics, experiments, metrics")->type_name("FILE");
    verb.add_option("-o,--output", options->folder, "Folder for the results")->required()->type_name("FOLDER");
    verb.add_flag("--resume", options->resume, "Run what is missing in the folder; without a project the folder's own study");
    verb.add_flag("--retry-failed", options->retry_failed, "The same, and once more the runs that failed");
    verb.add_option("--jobs", options->jobs,
                    "Runs at the same time; 0: one a core on a CPU, up to 16 on each GPU. Results do not depend on it")
        ->check(CLI::Range(0, 1024));
    verb.add_option("--backend", options->backend, "Backend: auto, cpu or cuda")->check(CLI::IsMember({"auto", "cpu", "cuda"}));
    verb.add_option("--threads", options->threads, "CPU threads of each run; 0: the cores shared among the jobs")
        ->check(CLI::Range(0, 1024));
    add_force_option(verb, *options);
    verb.add_option("--task", options->task, "Run only slice i of n, without a table at the end; many may run side by side")
        ->type_name("I/N");
    verb.add_flag("--merge", options->merge, "Make the table from the rows that all tasks have left in the folder");
    verb.add_flag("--analyse", options->analyse, "Sensitivities and a predicting surface from the folder's results");
    verb.add_option("--predict", options->predict,
                    "Metrics that the surface predicts where factors have these values; the others are in the middle")
        ->type_name("PATH=VALUE")
        ->allow_extra_args(false);
    verb.add_option(
            "--suggest", options->suggest,
            "Points that are worth computing next, such as \"minimise absorbency_time_s subject to maximum_wetted_radius_top_mm <= 12\"")
        ->type_name("GOAL");
    verb.add_option("--count", options->count, "Points to suggest")->check(CLI::Range(1, 100));
    verb.add_flag("--slurm", options->slurm,
                  "Submit the study as a job array of Slurm, instead of running it here; squeue and scancel see to it");
    verb.add_option("--sbatch", options->sbatch, "Options for sbatch, such as \"--partition=long --time=2:00:00\"")->type_name("OPTIONS");
    verb.add_option("--tasks", options->tasks, "Tasks of the job array; 0: so that each has enough to do")->check(CLI::Range(0, 100000));
    verb.add_flag("--gpus", options->gpus, "One GPU for each task of the job array");
    verb.callback([&chosen, options] { chosen = [options] { return sweep(*options); }; });
}

} // namespace hygroloom
