// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/run/learned_times.h"

#include "core/base/error.h"
#include "core/plan/expectation.h"
#include "core/plan/plan_json.h"
#include "core/project/atomic_file.h"
#include "core/project/cache_folder.h"

#include <nlohmann/json.hpp>

#include <unistd.h>

#include <array>
#include <cmath>
#include <mutex>

namespace hygroloom {
namespace {

using Json = nlohmann::ordered_json;

constexpr int version = 3; // in older files plans do not tell the sample's area or what is drawn of its rooms, which estimates need

constexpr std::size_t most_runs = 60, most_bytes = std::size_t{4} << 20U;

/// A garment's run of this machine.
struct GarmentRatio {
    GarmentTime estimated;
    double ratio = 1;
};

struct Kept {
    std::mutex mutex;
    std::filesystem::path file;
    std::filesystem::file_time_type read_at{};           ///< when the file was changed that was read last
    std::map<std::string, std::vector<LearnedRun>> runs; ///< by backend
    std::map<std::string, std::vector<GarmentRatio>> garments;
};

Kept& kept()
{
    static Kept all;
    return all;
}

std::string machine()
{
    std::array<char, 256> name{};
    return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

/// What estimates need of a plan, without its sentences.
Json plan_without_words(ModelPlan plan)
{
    for (PlannedPart& part : plan.parts) part.reason.clear();
    for (auto& [knob, reason] : plan.idle_knobs) reason.clear();
    for (std::string* words : {&plan.fidelity_reason, &plan.region_reason, &plan.resolution_reason, &plan.expectation_source})
        words->clear();
    plan.expected_errors.clear();
    return plan_value(plan);
}

/// Whether a plan that was read gives an estimate: its numbers may be anybody's.
bool is_usable(const ModelPlan& plan)
{
    const double work = rough_work(plan, "cpu");
    return plan.expected_seconds > 0 && std::isfinite(plan.expected_seconds) && work > 0 && std::isfinite(work);
}

/// The file's runs; none where it is missing or not such a file.
std::vector<Json> entries(const std::filesystem::path& file)
{
    std::vector<Json> runs;
    try {
        const Json json = Json::parse(read_file(file, most_bytes));
        if (json.at("format") == "hygroloom-times" && json.at("version") == version)
            for (const Json& run : json.at("runs"))
                if (run.is_object()) runs.push_back(run);
    } catch (const std::exception&) {
        runs.clear();
    }
    return runs;
}

void read_again(Kept& all)
{
    std::error_code missing;
    const auto changed = std::filesystem::last_write_time(all.file, missing);
    if (missing || changed == all.read_at) return;
    all.read_at = changed;
    all.runs.clear();
    all.garments.clear();
    const auto plausible = [](double ratio) { return ratio > 0.01 && ratio < 100; };
    for (const Json& entry : entries(all.file)) {
        try {
            if (entry.at("machine") != machine()) continue;
            const std::string backend = entry.at("backend");
            if (const auto garment = entry.find("garment"); garment != entry.end()) {
                const GarmentTime estimated{fidelity_from_name(garment->at("fidelity")), garment->at("seconds"), {}};
                const double ratio = entry.at("seconds").get<double>() / estimated.seconds;
                if (estimated.seconds > 0 && plausible(ratio)) all.garments[backend].push_back({estimated, ratio});
                continue;
            }
            ModelPlan plan = plan_from_value(entry.at("plan"));
            expect(plan, shipped_measurements(backend));
            const double ratio = entry.at("seconds").get<double>() / plan.expected_seconds;
            if (plausible(ratio) && is_usable(plan)) all.runs[backend].push_back({std::move(plan), ratio});
        } catch (const std::exception&) {
            continue; // an entry of another version, or damaged
        }
    }
}

/// Adds an entry; the newest of a backend stay. what: "plan" or "garment".
void keep(const char* what, const Json& estimated, double seconds, const std::string& backend, const std::string& device)
try {
    Kept& all = kept();
    const std::lock_guard lock(all.mutex);
    if (all.file.empty() || !(seconds > 0)) return;
    std::filesystem::create_directories(all.file.parent_path());
    const ChangeLock only_one(all.file);
    std::vector<Json> list;
    std::size_t of_backend = 1;
    const std::vector<Json> before = entries(all.file);
    for (auto entry = before.rbegin(); entry != before.rend(); ++entry)
        if (entry->value("backend", Json()) != backend || entry->contains(what) == false || of_backend++ < most_runs)
            list.insert(list.begin(), *entry);
    list.push_back(Json{{"machine", machine()}, {"backend", backend}, {"device", device}, {"seconds", seconds}, {what, estimated}});
    write_file(all.file, Json{{"format", "hygroloom-times"}, {"version", version}, {"runs", list}}.dump());
    all.read_at = {};
} catch (const std::exception&) {
    // Without it estimates are as they were.
}

} // namespace

std::filesystem::path usual_learned_times()
{
    const std::filesystem::path cache = cache_folder();
    return cache.empty() ? cache : cache / "times.json";
}

void keep_learned_times(const std::filesystem::path& file)
{
    Kept& all = kept();
    const std::lock_guard lock(all.mutex);
    all.file = file;
    all.read_at = {};
    all.runs.clear();
    all.garments.clear();
}

void learn_time(const RunRecord& run)
{
    if (!(run.wall > 0) || run.threads != 0 || !run.alone) return;
    constexpr double most_set_up = 0.5; // of a run: rooms that were drawn before are found at once, which says nothing of the next program
    if (set_up_seconds(run.plan, run.backend) > most_set_up * run.wall) return;
    keep("plan", plan_without_words(run.plan), run.wall - run.recorded_in, run.backend, run.device);
}

void learn_time(const GarmentTime& estimated, double seconds_taken, const std::string& backend, const std::string& device)
{
    keep("garment", {{"fidelity", name_of(estimated.fidelity)}, {"seconds", estimated.seconds}}, seconds_taken, backend, device);
}

void expect_as_learned(ModelPlan& plan, const std::string& backend)
{
    Kept& all = kept();
    const std::lock_guard lock(all.mutex);
    if (all.file.empty()) return;
    read_again(all);
    if (const auto found = all.runs.find(backend); found != all.runs.end()) correct_time(plan, found->second);
}

void expect_as_learned(GarmentTime& estimated, const std::string& backend)
{
    Kept& all = kept();
    const std::lock_guard lock(all.mutex);
    if (all.file.empty() || !(estimated.seconds > 0)) return;
    read_again(all);
    std::vector<UnlikeRun> runs;
    int same = 0, other = 0;
    for (const GarmentRatio& run : all.garments[backend]) {
        const bool alike = run.estimated.fidelity == estimated.fidelity;
        const double work = std::abs(std::log(estimated.seconds / run.estimated.seconds));
        runs.push_back({work + (alike ? 0.0 : unlike_at_other_fidelity), run.ratio});
        ++(alike ? same : other);
    }
    const std::optional<double> ratio = learned_ratio(runs);
    if (!ratio) return;
    estimated.seconds *= *ratio;
    estimated.learned = learned_text(same, other, *ratio).substr(1);
}

} // namespace hygroloom
