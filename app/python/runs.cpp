// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// One run, one recording's numbers, and the cases of verify, for Python. Results are JSON, as the command line prints it.
#include "app/python/bindings.h"
#include "app/python/machine.h"

#include "core/analysis/card.h"
#include "core/analysis/metrics_json.h"
#include "core/analysis/outcomes.h"
#include "core/base/units.h"
#include "core/queue/card_runs.h"
#include "core/run/recording.h"
#include "core/verify/verify_json.h"
#include "core/wear/wear_outcomes.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <pybind11/stl.h>

#include <filesystem>

namespace hygroloom::python {
namespace {

using Json = nlohmann::ordered_json;

/// What the package makes a run's results from.
struct Results {
    std::string metrics;                 ///< JSON, as `simulate --json` prints it
    std::string outcomes;                ///< JSON: each number's key, title with its part, unit, and why it is missing
    std::vector<std::string> notes = {}; ///< what limits the numbers, in sentences
    std::vector<std::string> warnings = {};
    double end = 0; ///< s, of the last frame
    bool finished = true;

    py::tuple tuple() const
    {
        py::list all_notes, all_warnings;
        for (const std::string& note : notes) all_notes.append(text(note));
        for (const std::string& warning : warnings) all_warnings.append(text(warning));
        return py::make_tuple(text(metrics), text(outcomes), all_notes, all_warnings, end, finished);
    }
};

std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

Json outcome_list(const std::vector<Outcome>& outcomes)
{
    Json list = Json::array();
    for (const Outcome& outcome : outcomes) {
        Json row{{"metric", outcome.key}, {"title", full_title(outcome)}, {"unit", outcome.unit}};
        row["value"] = outcome.text.empty() ? (outcome.value ? Json(*outcome.value) : Json(nullptr)) : Json(outcome.text);
        row["missing"] = outcome.missing;
        row["grade"] = outcome.grade ? Json(*outcome.grade) : Json(nullptr);
        list.push_back(row);
    }
    return list;
}

Results results_of(const RunRecord& run, const Metrics& metrics)
{
    Results results{dumped(metrics_value(run, metrics)), dumped(outcome_list(outcomes_of(run, metrics))), notes_of(run.plan)};
    for (std::string& note : notes_of(metrics)) results.notes.push_back(std::move(note));
    results.end = metrics.ledger.time;
    return results;
}

Results run_sample(const Design& design, const std::string& fabric_name, const std::string& experiment_name, const RunArguments& arguments,
                   Watch& watch)
{
    if (arguments.cell_mm > 0 || !arguments.detail.empty()) throw Error("cell_mm and detail work with experiments of the type wear.");
    RunOptions how = run_options(arguments);
    how.shown_side = metre_from_mm(arguments.shown_mm);
    const auto fitted = require_valid(design);
    const Experiment& experiment = chosen_experiment(design, experiment_name);
    const Fabric& fabric = chosen_fabric(design, fabric_name);
    how.textile = std::make_shared<const Textile>(textiles_of_runs(design, fitted, {fabric.name}, experiment).front());
    const std::unique_ptr<Backend> backend = open_backend(arguments);
    RunJob job{std::make_shared<const Design>(design), experiment.name, fabric.name, {}, how};
    std::string shortage;
    job.beside.memory_is_short = [&](const std::string& sentence) { shortage = sentence; };
    job.beside.progress = [&](const RunProgress& progress) { watch.tell(share_of(progress), in_words(progress)); };
    const FinishedRun finished = std::move(*run_job(job, *backend, watch.control).sample);
    Results results = results_of(finished.run, finished.metrics);
    if (!shortage.empty()) results.warnings.push_back(shortage);
    if (!finished.device_failure.empty()) results.warnings.push_back(finished.device_failure);
    return results;
}

/// folder: of the project, from where it names a garment's files.
Results run_worn(const Design& design, const WearExperiment& wear, const std::string& folder, const RunArguments& arguments, Watch& watch)
{
    if (!arguments.physics.empty() || arguments.seed != RunArguments{}.seed)
        throw Error("A worn garment takes neither physics nor seed: its panels name their fabrics, and nothing of it is left to chance.");
    require_valid(design);
    const std::unique_ptr<Backend> backend = open_backend(arguments);
    Results results{};
    RunJob job{std::make_shared<const Design>(design), wear.name, {}, std::filesystem::absolute(folder), garment_options(arguments)};
    job.beside.memory_is_short = job.beside.device_failed = [&](const std::string& sentence) { results.warnings.push_back(sentence); };
    job.beside.progress = [&](const RunProgress& progress) { watch.tell(share_of(progress), in_words(progress)); };
    const FinishedGarment finished = *run_job(job, *backend, watch.control).garment;
    results.notes = finished.issues;
    results.metrics = wear_json(*finished.metrics);
    results.outcomes = dumped(outcome_list(outcomes_of(*finished.metrics)));
    results.end = finished.metrics->ledger().time;
    return results;
}

py::tuple simulate(const Design& design, const std::string& fabric, const std::string& experiment, const std::string& folder,
                   const py::dict& how, const py::object& progress)
{
    const RunArguments arguments = run_arguments(how);
    std::optional<std::string> worn;
    if (const WearExperiment* wear = chosen_wear(design, experiment)) worn = wear->name;
    if (worn && !fabric.empty())
        throw Error(fmt::format("The experiment \"{}\" is one on a garment, whose panels name their fabrics; leave fabric out.", *worn));
    const auto run = [=](Watch& watch) {
        return worn ? run_worn(design, *find_wear(design, *worn), folder, arguments, watch)
                    : run_sample(design, fabric, experiment, arguments, watch);
    };
    return watched(progress, run).tuple();
}

Results measured_garment(const std::string& path, const Watch& watch)
{
    const WearRecording recording(path);
    WearMetrics metrics(recording.record().layout);
    if (recording.frames() == 0) throw FileError(path + ": The recording has no frames.");
    for (int k = 0; k < recording.frames(); ++k) {
        if (watch.control.cancel) throw Cancelled();
        metrics.add(recording.frame(k));
    }
    Results results{wear_json(metrics), dumped(outcome_list(outcomes_of(metrics)))};
    results.end = metrics.ledger().time;
    results.finished = recording.finished();
    return results;
}

Results measured(const std::string& path, const Watch& watch)
{
    if (WearRecording::is_one(path)) return measured_garment(path, watch);
    Recording recording(path);
    MetricsCollector collector;
    collector.start(recording.run());
    const int frames = std::max(1, recording.frames());
    int seen = 0;
    recording.read_frames([&](const Frame& frame) {
        collector.add(frame);
        watch.tell(static_cast<double>(++seen) / frames, fmt::format("{} of {} frames", seen, frames));
        return !watch.control.cancel;
    });
    if (watch.control.cancel) throw Cancelled();
    if (recording.frames() == 0) throw FileError(path + ": The recording has no frames.");
    Results results = results_of(recording.run(), collector.metrics());
    results.warnings = recording.problems();
    results.finished = recording.finished();
    return results;
}

/// A backend that ends its work when it is asked to.
class StoppableBackend : public Backend {
public:
    StoppableBackend(std::unique_ptr<Backend> backend, const std::atomic<bool>& stop) : backend_(std::move(backend)), stop_(stop) {}
    std::string name() const override { return backend_->name(); }
    std::string device() const override { return backend_->device(); }
    void set_threads(int threads) override { backend_->set_threads(threads); }
    void load(const Scene& scene) override
    {
        obey();
        backend_->load(scene);
    }
    void unload() override { backend_->unload(); }
    double advance(double until) override
    {
        obey();
        return backend_->advance(until);
    }
    Frame frame() override { return backend_->frame(); }
    std::future<Frame> take_frame() override { return backend_->take_frame(); }
    void stay() override { backend_->stay(); }
    std::vector<std::byte> state() override { return backend_->state(); }
    void go_on_from(const std::vector<std::byte>& state) override { backend_->go_on_from(state); }
    void squeeze(double share) override { backend_->squeeze(share); }
    long liquid_steps() const override { return backend_->liquid_steps(); }
    int particles() const override { return backend_->particles(); }

private:
    void obey() const
    {
        if (stop_) throw Cancelled();
    }
    std::unique_ptr<Backend> backend_;
    const std::atomic<bool>& stop_;
};

py::str verify(const std::string& name, const std::map<std::string, std::string>& changes, const py::dict& how)
{
    const RunArguments arguments = run_arguments(how);
    const auto run = [=](Watch& watch) {
        StoppableBackend backend(open_backend(arguments), watch.control.cancel);
        return dumped(report_value(run_verify_case(name, changes, backend)));
    };
    return text(watched(py::none(), run));
}

/// JSON, as the verb card prints it. runs: tests, see card_test_keys().
py::str card(const Design& design, const std::string& fabric, const std::vector<std::string>& runs, int replicates, const std::string& keep,
             const py::dict& how, const py::object& progress)
{
    const RunArguments arguments = run_arguments(how);
    const auto made = [=](Watch& watch) {
        CardRuns what{card_test_keys(runs), run_options(arguments), replicates, keep};
        const auto fitted = require_valid(design);
        const Fabric& chosen = chosen_fabric(design, fabric);
        Card card = card_of(design, chosen, *fitted[static_cast<std::size_t>(&chosen - design.fabrics.data())]);
        if (what.tests.empty()) return dumped(card_json(card));
        const CardJobs jobs = card_jobs(design, chosen, card.numbers, what);
        const std::size_t count = jobs.jobs.size() * static_cast<std::size_t>(replicates);
        ManyRuns all(watch, count);
        ComparedWatch telling;
        telling.begins = [&all](std::size_t i, RunJob& job) {
            job.beside.progress = [&all, i](const RunProgress& done) { all.tell(i, share_of(done)); };
        };
        telling.ended = [&all](std::size_t i) { all.end(i); };
        RunQueue queue;
        std::shared_ptr<RunPlaces> places;
        if (count > 0) places = open_places(arguments, 0, static_cast<int>(count), static_cast<std::size_t>(jobs.bytes));
        card.numbers = run_card_jobs(jobs, replicates, queue, places, watch.control.cancel, telling);
        if (watch.control.cancel) throw Cancelled();
        return dumped(card_json(card));
    };
    return text(watched(progress, made));
}

py::str verify_list()
{
    Json list = Json::array();
    for (const VerifyCase& c : verify_cases())
        list.push_back({{"case", c.name}, {"about", c.about}, {"parameters", parameters_value(c.parameters)}});
    return text(dumped(list));
}

} // namespace

void add_runs(py::module_& module)
{
    module.def("simulate", &simulate);
    module.def("measure", [](const std::string& path, const py::object& progress) {
        return watched(progress, [path](Watch& watch) { return measured(path, watch); }).tuple();
    });
    module.def("card", &card);
    module.def("verify", &verify);
    module.def("verify_list", &verify_list);
}

} // namespace hygroloom::python
