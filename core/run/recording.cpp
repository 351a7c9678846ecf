// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/run/recording.h"

#include "core/base/error.h"
#include "core/base/utf8.h"
#include "core/plan/bundles.h"
#include "core/plan/plan_json.h"
#include "core/project/project_file.h"
#include "core/run/frame_changes.h"
#include "core/run/recording_layout.h"
#include "core/scene/coarse_scene.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>

namespace hygroloom {

namespace {

constexpr std::uint64_t base_frame_bytes = 80 << 20;

double time_from(const RunFileReader& file, const char* name)
{
    const double time = file.number(name);
    if (!std::isfinite(time) || time < 0) throw FileError(fmt::format("\"{}\" is no time.", name));
    return time;
}

/// In order of time.
std::vector<SwitchedPart> read_switched_on(const RunFileReader& file)
{
    std::vector<SwitchedPart> parts;
    for (const char* name : {"sorption", "vapour", "heat"}) {
        const std::string place = std::string("provenance/switched_on/") + name + "/";
        if (!file.has(place + "time_s")) continue;
        parts.push_back({name, file.number(place + "time_s"), file.number(place + "share"), file.number(place + "limit")});
        if (file.has(place + "estimate")) parts.back().estimate = file.number(place + "estimate");
        if (file.has(place + "kept_off")) parts.back().kept_off = file.text(place + "kept_off");
    }
    std::stable_sort(parts.begin(), parts.end(), [](const SwitchedPart& a, const SwitchedPart& b) { return a.time < b.time; });
    return parts;
}

std::uint64_t seed_from(const std::string& text)
{
    std::uint64_t seed = 0;
    const char* const end = text.data() + text.size();
    if (const auto [last, failure] = std::from_chars(text.data(), end, seed); failure != std::errc() || last != end)
        throw FileError("\"provenance/seed\" is not a whole number.");
    return seed;
}

/// All but the textile and what follows from the design. Returns the project that was run.
std::string read_provenance(const RunFileReader& file, RunRecord& run)
{
    const auto text = [&](const char* name) { return file.text(std::string("provenance/") + name); };
    run.fabric = text("fabric");
    run.experiment = text("experiment");
    run.backend = text("backend");
    run.device = in_one_line(text(file.has("provenance/all_devices") ? "all_devices" : "device"));
    run.plan = plan_from_json(text("plan"));
    run.switched_on = read_switched_on(file);
    for (const auto& [name, time] : stored_acts(run.acts))
        if (file.has(name)) *time = time_from(file, name);
    run.date = in_one_line(text("date"));
    run.answers = file.has("provenance/answers") ? text("answers") : std::string();
    if (file.has("provenance/unsolved_lines")) run.unsolved_lines = file.number("provenance/unsolved_lines");
    run.seed = seed_from(text("seed"));
    run.threads = static_cast<int>(file.count("provenance/threads", 0, 1'000'000));
    return file.text("design");
}

/// Ends, or picks, as they were simulated.
int simulated(int yarns, const ModelPlan& plan) { return bundles_of(yarns, plan.bundling()).count; }

/// Whether frames show cells. Throws FileError where those cannot be. Precondition: the region can be.
bool shows_cells(const ModelPlan& plan)
{
    const int ends = plan.shown_ends, picks = plan.shown_picks;
    if (plan.crossings_per_cell < 1 || plan.crossings_per_cell > largest_yarn_order)
        throw FileError("the recording's bundles of yarns cannot be; it is damaged.");
    if (ends == 0 && picks == 0) return false;
    if (ends < 0 || picks < 0 || ends > simulated(plan.region.ends, plan) || picks > simulated(plan.region.picks, plan) || ends == 0 ||
        picks == 0)
        throw FileError("the recording's cells do not lie in its sample; it is damaged.");
    return true;
}

void rebuild_textile(RunRecord& run, const std::string& project)
{
    run.design = parse_project(project, "the recording's design");
    const Fabric* fabric = find_fabric(run.design, run.fabric);
    const Experiment* experiment = find_experiment(run.design, run.experiment);
    const Validation valid = validate_and_fit(run.design);
    if (!fabric || !experiment || has_error(valid.issues)) throw FileError("the recording's design is not valid; it is damaged.");
    const TextileRegion& region = run.plan.region;
    const TextileRegion most = region_of_run(*fabric, *experiment);
    const auto is_place = [](int yarns) { return yarns >= 0 && yarns <= most_yarns_before; };
    // Older recordings have odd numbers, too.
    if (region.ends < 1 || region.picks < 1 || region.ends > most.ends + 1 || region.picks > most.picks + 1 ||
        !is_place(region.first_end) || !is_place(region.first_pick))
        throw FileError("the recording's region does not lie in its sample; it is damaged.");
    const auto place = static_cast<std::size_t>(fabric - run.design.fabrics.data());
    run.textile = textile_of_run(run.design, *fabric, *experiment, region, valid.fabrics[place].get());
    if (shows_cells(run.plan)) run.textile = in_cells(run.textile, run.plan.shown_ends, run.plan.shown_picks);
}

} // namespace

struct Recording::File {
    explicit File(const std::filesystem::path& path) : name(path.string()), file(path) {}

    std::string name;
    RunFileReader file;
    RunRecord run;
    bool finished = false;
    bool in_bundles = false;                  ///< its frames' values
    std::optional<YarnsOfBundles> of_bundles; ///< of these, from the first frame that is read
    std::optional<ChangesReader> changes;     ///< where some frames hold these
    std::vector<StoredFrame> frames;
    std::vector<Ledger> ledgers; ///< of the frames
    std::vector<std::string> problems;

    void leave_out(std::int64_t number, const std::string& why)
    {
        problems.push_back(fmt::format("{}: Frame {} is left out: {}", name, number, why));
    }
    void note_ledgers()
    {
        ledgers.clear();
        for (const StoredFrame& frame : frames) ledgers.push_back(frame.ledger);
    }
    void read();
    /// Bytes that the values of one frame may take.
    std::uint64_t room() const { return base_frame_bytes + 3 * file.size(); }
    std::vector<float> values_of(const StoredRow& row, const StoredFrame& stored, const FrameField& field, std::size_t count);
    Frame values_of(const StoredFrame& stored, std::span<const FrameField> fields);
};

/// Which segments were wet along each end of a cloth that is shown in cells.
std::vector<WetEnd> read_wet(const StoredRow& row, int ends, int picks)
{
    std::vector<WetEnd> wet(static_cast<std::size_t>(ends));
    const std::vector<float> numbers = row.floats("wet", wet_numbers * wet.size());
    std::memcpy(static_cast<void*>(wet.data()), numbers.data(), numbers.size() * sizeof(float));
    for (const WetEnd& end : wet)
        for (int face = 0; face < 2; ++face) {
            const float first = end.first[face], last = end.last[face];
            const float count = end.count[face], places = end.places[face], squares = end.squares[face], length = last - first;
            const bool holds = first < 0
                                   ? first == -1 && last == -1 && count == 0 && places == 0 && squares == 0
                                   : first <= last && last < static_cast<float>(picks) && count >= 1 && count <= length + 1 &&
                                         places >= 0 && places <= count * length && squares >= 0 && squares <= count * length * length;
            if (!holds) throw FileError("its wet crossings do not lie in the sample.");
        }
    return wet;
}

std::vector<FrameCap> read_caps(const StoredRow& row)
{
    constexpr std::size_t most_caps = 1000;
    constexpr float largest = 10; // m, m3
    const std::vector<float> place = row.triples("cap_place", most_caps), size = row.triples("cap_size", most_caps);
    for (const std::vector<float>* numbers : {&place, &size})
        for (float number : *numbers)
            if (!(std::abs(number) < largest)) throw FileError(fmt::format("a cap of it is {:g} m large, or away.", number));
    if (place.size() != size.size()) throw FileError(fmt::format("it has {} caps, and sizes of {}.", place.size() / 3, size.size() / 3));
    std::vector<FrameCap> caps;
    for (std::size_t i = 0; i < place.size(); i += 3)
        caps.push_back({place[i], place[i + 1], size[i], place[i + 2], size[i + 1], size[i + 2]});
    return caps;
}

std::vector<float> Recording::File::values_of(const StoredRow& row, const StoredFrame& stored, const FrameField& field, std::size_t count)
{
    if (row.has(follows_column)) {
        if (!changes) throw FileError("it holds changes, and the recording does not say how.");
        return changes->values(file, stored.number, field.name, count);
    }
    const bool is_older = field.absent && !file.has_column(field.name);
    return is_older ? std::vector<float>(count, *field.absent) : row.floats(field.name, count);
}

Frame Recording::File::values_of(const StoredFrame& stored, std::span<const FrameField> fields)
{
    std::vector<std::string> names{"water_top_kg",      "water_bottom_kg", follows_column, "particle_position",
                                   "particle_velocity", "cap_place",       "cap_size",     "wet"};
    for (const FrameField& field : fields) names.push_back(field.name);
    const StoredRow row = file.row(stored.number, names);
    Frame frame;
    frame.time = stored.time;
    frame.ledger = stored.ledger;
    frame.water_top = row.number("water_top_kg");
    frame.water_bottom = row.number("water_bottom_kg");
    if (in_bundles && !of_bundles) of_bundles.emplace(run.textile, run.plan.bundling());
    const std::size_t n = of_bundles ? of_bundles->segments() : static_cast<std::size_t>(run.textile.segments());
    for (const FrameField& field : fields) field.in(frame) = values_of(row, stored, field, n);
    const std::uint64_t left = room() - sizeof(float) * std::size(frame_fields) * n; // the constructor saw that they fit
    const std::size_t most = left / (4 * sizeof frame.positions[0]);
    const auto triples = [&](const char* name) { return row.has(name) ? row.triples(name, most) : std::vector<float>(); };
    const std::vector<float> x = triples("particle_position"), v = triples("particle_velocity");
    if (x.size() != v.size()) throw FileError(fmt::format("it has {} particles, and velocities of {}.", x.size() / 3, v.size() / 3));
    for (std::size_t i = 0; i < x.size(); i += 3) {
        frame.positions.push_back({x[i], x[i + 1], x[i + 2]});
        frame.velocities.push_back({v[i], v[i + 1], v[i + 2]});
    }
    if (run.plan.shown_ends > 0) {
        frame.wet = read_wet(row, simulated(run.plan.region.ends, run.plan), simulated(run.plan.region.picks, run.plan));
        frame.wet_picks = simulated(run.plan.region.picks, run.plan);
    }
    if (row.has("cap_place")) frame.caps = read_caps(row);
    if (!of_bundles) return frame; // a conditional expression would copy it
    return of_bundles->refined(std::move(frame));
}

/// All but the frames' values.
void Recording::File::read()
{
    if (const std::string format = file.text("format"); format != recording_format)
        throw FileError(format == wear_format ? "this is the recording of a worn garment, not of a sample."
                                              : "this is not the recording of a sample.");
    const std::string project = read_provenance(file, run);
    finished = file.has("wall_s");
    if (finished) run.wall = file.number("wall_s");
    in_bundles = file.count("in_bundles", 0, 1) == 1;
    frames = file.frames([this](std::int64_t number, const std::string& why) { leave_out(number, why); });
    note_ledgers();
    if (file.has("changes/back")) changes.emplace(file);
    file.release();
    rebuild_textile(run, project);
    if (sizeof(float) * std::size(frame_fields) * static_cast<std::uint64_t>(run.textile.segments()) > room())
        throw FileError(
            fmt::format("the recording's cloth has {} segments; a file of this size cannot hold their values.", run.textile.segments()));
}

Recording::Recording(const std::filesystem::path& path)
try : file_(std::make_unique<File>(path)) {
    file_->read();
} catch (const Error& e) {
    throw FileError(path.string() + ": " + e.what());
} catch (const std::logic_error&) {
    throw FileError(path.string() + ": the recording is damaged.");
} catch (const std::bad_alloc&) {
    throw FileError(path.string() + ": the memory does not suffice to read it.");
}

Recording::~Recording() = default;
Recording::Recording(Recording&&) noexcept = default;

const RunRecord& Recording::run() const { return file_->run; }
bool Recording::finished() const { return file_->finished; }
bool Recording::is_being_written() const { return file_->file.is_being_written() && !file_->finished; }
int Recording::frames() const { return static_cast<int>(file_->frames.size()); }
const std::vector<Ledger>& Recording::ledgers() const { return file_->ledgers; }
const std::vector<std::string>& Recording::problems() const { return file_->problems; }

Frame Recording::frame(int index, std::span<const FrameField> fields) const
{
    const StoredFrame& stored = file_->frames[static_cast<std::size_t>(index)];
    try {
        return file_->values_of(stored, fields);
    } catch (const FileError& error) {
        throw FileError(fmt::format("{}: Frame {} cannot be read: {}", file_->name, stored.number, error.what()));
    }
}

void Recording::read_frames(const std::function<bool(const Frame&)>& see)
{
    std::vector<StoredFrame> good;
    bool goes_on = true;
    for (StoredFrame& stored : file_->frames) {
        try {
            const Frame frame = goes_on ? file_->values_of(stored, frame_fields) : Frame();
            goes_on = goes_on && see(frame);
            good.push_back(std::move(stored));
        } catch (const FileError& error) {
            file_->leave_out(stored.number, error.what());
        }
    }
    file_->frames = std::move(good);
    file_->note_ledgers();
}

} // namespace hygroloom
