// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/run/recording.h"

#include "core/base/error.h"
#include "core/base/utf8.h"
#include "core/plan/bundles.h"
#include "core/plan/plan_json.h"
#include "core/project/project_file.h"
#include "core/run/frame_changes.h"
#include "core/run/hdf5_reader.h"
#include "core/run/recording_layout.h"
#include "core/run/recording_source.h"
#include "core/scene/coarse_scene.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>

namespace hygroloom {

namespace h5 = hdf5;

namespace {

constexpr int most_yarns_before = 100'000'000; ///< a region's place in the fabric
constexpr std::uint64_t base_frame_bytes = 80 << 20;

/// What the file holds of a frame, before the values of its segments.
struct StoredFrame {
    int number = 0; ///< in the file
    h5::Handle group;
    double time = 0;
    Ledger ledger;
};

double time_from(hid_t group, const char* name)
{
    const double time = h5::read_number(group, name);
    if (!std::isfinite(time) || time < 0) throw FileError(fmt::format("\"{}\" is no time.", name));
    return time;
}

/// In order of time; none in recordings of older versions.
std::vector<SwitchedPart> read_switched_on(hid_t provenance)
{
    std::vector<SwitchedPart> parts;
    if (!h5::exists(provenance, "switched_on")) return parts;
    const h5::Handle all = h5::open_group(provenance, "switched_on");
    for (const char* name : {"sorption", "vapour", "heat"}) {
        if (!h5::exists(all.get(), name)) continue;
        const h5::Handle group = h5::open_group(all.get(), name);
        const auto number = [&](const char* which) { return h5::read_number(group.get(), which); };
        parts.push_back({name, number("time_s"), number("share"), number("limit")});
        if (h5::has_number(group.get(), "estimate")) parts.back().estimate = number("estimate");
        if (h5::exists(group.get(), "kept_off")) parts.back().kept_off = h5::read_text(group.get(), "kept_off");
    }
    std::stable_sort(parts.begin(), parts.end(), [](const SwitchedPart& a, const SwitchedPart& b) { return a.time < b.time; });
    return parts;
}

/// Throws FileError where it cannot be a frame's. Older recordings have fewer columns.
Ledger ledger_of(const double* row, std::size_t columns)
{
    Ledger ledger;
    for (std::size_t k = 0; k < columns; ++k) {
        if (!std::isfinite(row[k])) throw FileError(fmt::format("\"{}\" in the ledger is not a finite number.", ledger_columns[k].name));
        ledger.*ledger_columns[k].value = row[k];
    }
    return ledger;
}

StoredFrame stored_frame(hid_t frames, int number, const double* row, std::size_t columns)
{
    StoredFrame frame;
    frame.number = number;
    frame.group = h5::open_group(frames, frame_name(number));
    frame.ledger = ledger_of(row, columns);
    frame.time = h5::read_number(frame.group.get(), "time_s");
    if (frame.time < 0 || std::abs(frame.time - frame.ledger.time) > 1e-6 * (1 + frame.time))
        throw FileError(fmt::format("its time is {:.4g} s, and {:.4g} s in the ledger.", frame.time, frame.ledger.time));
    return frame;
}

std::uint64_t seed_from(const std::string& text)
{
    std::uint64_t seed = 0;
    const char* const end = text.data() + text.size();
    if (const auto [last, failure] = std::from_chars(text.data(), end, seed); failure != std::errc() || last != end)
        throw FileError("\"provenance/seed\" is not a whole number.");
    return seed;
}

/// Throws FileError where it is none that can be read.
double version_of(hid_t file)
{
    if (!h5::exists(file, "format") || h5::read_text(file, "format") != recording_format)
        throw FileError("this is not a Hygroloom recording.");
    const double version = h5::read_number(file, "version");
    if (version > recording_version)
        throw FileError(
            fmt::format("the recording has version {:.0f}; this program reads up to {}. Use a newer program.", version, recording_version));
    return static_cast<double>(h5::read_count(file, "version", 1, recording_version));
}

/// All but the textile and what follows from the design. Returns the project that was run.
std::string read_provenance(hid_t file, RunRecord& run)
{
    const h5::Handle provenance = h5::open_group(file, "provenance");
    const auto text = [&](const char* name) { return h5::read_text(provenance.get(), name); };
    run.fabric = text("fabric");
    run.experiment = text("experiment");
    run.backend = text("backend");
    run.device = in_one_line(text(h5::exists(provenance.get(), "all_devices") ? "all_devices" : "device"));
    run.plan = plan_from_json(text("plan"));
    run.switched_on = read_switched_on(provenance.get());
    for (const auto& [name, time] : stored_acts(run.acts))
        if (h5::has_number(provenance.get(), name)) *time = time_from(provenance.get(), name);
    if (h5::exists(provenance.get(), "date")) run.date = in_one_line(text("date"));
    if (h5::has_number(provenance.get(), "unsolved_lines")) run.unsolved_lines = h5::read_number(provenance.get(), "unsolved_lines");
    run.seed = seed_from(text("seed"));
    run.threads = static_cast<int>(h5::read_count(provenance.get(), "threads", 0, 1'000'000));
    return h5::read_text(file, "design");
}

/// Ends, or picks, as they were simulated.
int simulated(int yarns, const ModelPlan& plan) { return bundles_of(yarns, plan.crossings_per_cell).count; }

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
    const std::array<double, 2> sample = sample_extent_mm(*experiment);
    const TextileRegion most = region_of_sample(*fabric, sample[0], sample[1]);
    const auto is_place = [](int yarns) { return yarns >= 0 && yarns <= most_yarns_before; };
    if (region.ends < 1 || region.picks < 1 || region.ends > most.ends || region.picks > most.picks || !is_place(region.first_end) ||
        !is_place(region.first_pick))
        throw FileError("the recording's region does not lie in its sample; it is damaged.");
    const auto place = static_cast<std::size_t>(fabric - run.design.fabrics.data());
    run.textile = textile_of_run(run.design, *fabric, *experiment, region, valid.fabrics[place].get());
    if (shows_cells(run.plan)) run.textile = in_cells(run.textile, run.plan.shown_ends, run.plan.shown_picks);
}

} // namespace

struct Recording::File {
    explicit File(const std::filesystem::path& path) : name(path.string()), source(path) {}

    std::string name;
    RecordingSource source; // outlives what the library has open in it
    h5::Handle file;
    RunRecord run;
    bool finished = false;
    bool in_bundles = false;                  ///< its frames' values
    std::optional<YarnsOfBundles> of_bundles; ///< of these, from the first frame that is read
    std::optional<ChangesReader> changes;     ///< where some frames hold these
    std::vector<StoredFrame> frames;
    std::vector<Ledger> ledgers; ///< of the frames
    std::vector<std::string> problems;

    void leave_out(int number, const std::string& why)
    {
        problems.push_back(fmt::format("{}: Frame {} is left out: {}", name, number, why));
    }
    void read_frames();
    void require_order();
    /// Bytes that the values of one frame may take.
    std::uint64_t room() const { return base_frame_bytes + 3 * source.size(); }
    std::vector<float> values_of(const StoredFrame& stored, const FrameField& field, std::size_t count);
    Frame values_of(const StoredFrame& stored, std::span<const FrameField> fields);
};

/// Up to where the ledger counts none any more, or none is there any more.
void Recording::File::read_frames()
{
    constexpr hsize_t block = 256;
    constexpr std::size_t most_problems = 1000;
    const h5::Handle groups = h5::open_group(file.get(), "frames");
    constexpr hsize_t columns_of_all = 13;
    const h5::Table table(file.get(), "ledger", columns_of_all, std::size(ledger_columns));
    bool some = true;
    for (hsize_t first = 0; some && first < table.rows(); first += block) {
        const hsize_t count = std::min(block, table.rows() - first);
        const std::vector<double> rows = table.read(first, count);
        some = false;
        for (hsize_t k = 0; k < count && problems.size() < most_problems; ++k) {
            const int number = static_cast<int>(first + k);
            some = some || h5::exists(groups.get(), frame_name(number));
            try {
                frames.push_back(stored_frame(groups.get(), number, rows.data() + k * table.columns(), table.columns()));
            } catch (const FileError& error) {
                leave_out(number, error.what());
            }
        }
    }
}

/// Leaves out frames that do not come after the one before.
void Recording::File::require_order()
{
    std::vector<StoredFrame> in_order;
    for (StoredFrame& frame : frames) {
        if (!in_order.empty() && frame.time <= in_order.back().time)
            leave_out(frame.number, fmt::format("its time, {:.4g} s, does not come after {:.4g} s.", frame.time, in_order.back().time));
        else
            in_order.push_back(std::move(frame));
    }
    frames = std::move(in_order);
    for (const StoredFrame& frame : frames) ledgers.push_back(frame.ledger);
}

/// Which segments were wet along each end of a cloth that is shown in cells.
std::vector<WetEnd> read_wet(hid_t group, int ends, int picks)
{
    std::vector<WetEnd> wet(static_cast<std::size_t>(ends));
    const std::vector<float> numbers = h5::read_floats(group, "wet", wet_numbers * wet.size());
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

std::vector<float> Recording::File::values_of(const StoredFrame& stored, const FrameField& field, std::size_t count)
{
    if (changes) {
        const h5::Handle all = h5::open_group(file.get(), "frames");
        if (auto values = changes->values(all.get(), stored.number, field.name, count)) return std::move(*values);
    }
    const bool is_older = field.absent && !h5::exists(stored.group.get(), field.name);
    return is_older ? std::vector<float>(count, *field.absent) : h5::read_floats(stored.group.get(), field.name, count);
}

Frame Recording::File::values_of(const StoredFrame& stored, std::span<const FrameField> fields)
{
    const hid_t g = stored.group.get();
    Frame frame;
    frame.time = stored.time;
    frame.water_top = h5::read_number(g, "water_top_kg");
    frame.water_bottom = h5::read_number(g, "water_bottom_kg");
    if (in_bundles && !of_bundles) of_bundles.emplace(run.textile, run.plan.crossings_per_cell);
    const std::size_t n = of_bundles ? of_bundles->segments() : static_cast<std::size_t>(run.textile.segments());
    for (const FrameField& field : fields) field.in(frame) = values_of(stored, field, n);
    frame.ledger = stored.ledger;
    const std::uint64_t left = room() - sizeof(float) * std::size(frame_fields) * n; // the constructor saw that they fit
    const hsize_t most = left / (4 * sizeof frame.positions[0]);
    const auto triples = [&](const char* name) {
        return changes && !h5::exists(g, name) ? std::vector<float>() : h5::read_triples(g, name, most);
    };
    const std::vector<float> x = triples("particle_position"), v = triples("particle_velocity");
    if (x.size() != v.size()) throw FileError(fmt::format("it has {} particles, and velocities of {}.", x.size() / 3, v.size() / 3));
    for (std::size_t i = 0; i < x.size(); i += 3) {
        frame.positions.push_back({x[i], x[i + 1], x[i + 2]});
        frame.velocities.push_back({v[i], v[i + 1], v[i + 2]});
    }
    if (run.plan.shown_ends > 0) {
        frame.wet = read_wet(g, simulated(run.plan.region.ends, run.plan), simulated(run.plan.region.picks, run.plan));
        frame.wet_picks = simulated(run.plan.region.picks, run.plan);
    }
    if (h5::exists(g, "cap_place")) {
        constexpr hsize_t most_caps = 1000;
        constexpr float largest = 10; // m, m3
        const std::vector<float> place = h5::read_triples(g, "cap_place", most_caps), size = h5::read_triples(g, "cap_size", most_caps);
        for (const std::vector<float>* numbers : {&place, &size})
            for (float number : *numbers)
                if (!(std::abs(number) < largest)) throw FileError(fmt::format("a cap of it is {:g} m large, or away.", number));
        if (place.size() != size.size())
            throw FileError(fmt::format("it has {} caps, and sizes of {}.", place.size() / 3, size.size() / 3));
        for (std::size_t i = 0; i < place.size(); i += 3)
            frame.caps.push_back({place[i], place[i + 1], size[i], place[i + 2], size[i + 1], size[i + 2]});
    }
    if (!of_bundles) return frame; // a conditional expression would copy it
    return of_bundles->refined(std::move(frame));
}

Recording::Recording(const std::filesystem::path& path)
try : file_(std::make_unique<File>(path)) {
    h5::silence();
    File& f = *file_;
    if (path.extension() == ".hygro" && !f.source.begins_as_hdf5())
        throw FileError(fmt::format("this is a project, not a recording. Run it first: hygroloom-cli simulate {} -o {}.", path.string(),
                                    std::filesystem::path(path).replace_extension(".hygrorec").string()));
    f.file = h5::open_file(f.source, "this is not a recording, or it is damaged or incomplete.");
    const double version = version_of(f.file.get());
    const std::string project = read_provenance(f.file.get(), f.run);
    f.finished = h5::has_number(f.file.get(), "wall_s");
    if (f.finished) f.run.wall = h5::read_number(f.file.get(), "wall_s");
    f.read_frames();
    f.source.release_index();
    f.require_order();
    rebuild_textile(f.run, project);
    if (version > recording_version_bundles) f.changes.emplace(f.file.get());
    f.in_bundles = f.changes ? f.changes->in_bundles() : version == recording_version_bundles;
    if (sizeof(float) * std::size(frame_fields) * static_cast<std::uint64_t>(f.run.textile.segments()) > f.room())
        throw FileError(
            fmt::format("the recording's cloth has {} segments; a file of this size cannot hold their values.", f.run.textile.segments()));
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
bool Recording::is_being_written() const { return file_->source.is_being_written() && !file_->finished; }
int Recording::frames() const { return static_cast<int>(file_->frames.size()); }
const std::vector<Ledger>& Recording::ledgers() const { return file_->ledgers; }
const std::vector<std::string>& Recording::problems() const { return file_->problems; }

Frame Recording::frame(int index, std::span<const FrameField> fields) const
{
    h5::silence();
    const StoredFrame& stored = file_->frames[static_cast<std::size_t>(index)];
    try {
        return file_->values_of(stored, fields);
    } catch (const FileError& error) {
        throw FileError(fmt::format("{}: Frame {} cannot be read: {}", file_->name, stored.number, error.what()));
    }
}

void Recording::read_frames(const std::function<bool(const Frame&)>& see)
{
    h5::silence();
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
    file_->ledgers.clear();
    for (const StoredFrame& frame : file_->frames) file_->ledgers.push_back(frame.ledger);
}

} // namespace hygroloom
