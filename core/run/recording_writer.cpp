// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Frames are written whole and committed with the ledger's rows that count them, so a cut recording reads up to its last row. A commit
// writes the names of all frames and the last rows anew, however small a frame is: several frames share one.
#include "core/base/error.h"
#include "core/base/version.h"
#include "core/plan/bundles.h"
#include "core/plan/plan_json.h"
#include "core/project/project_file.h"
#include "core/run/frame_changes.h"
#include "core/run/hdf5_reader.h"
#include "core/run/recording.h"
#include "core/run/recording_layout.h"
#include "core/run/recording_target.h"

#include <fmt/format.h>

#include <cmath>
#include <malloc.h>
#include <mutex>
#include <optional>

namespace hygroloom {

namespace h5 = hdf5;

namespace {

std::string column_names()
{
    std::string names;
    for (const LedgerColumn& column : ledger_columns) names += (names.empty() ? "" : ",") + std::string(column.name);
    return names;
}

std::vector<double> row_of(const Ledger& ledger)
{
    std::vector<double> row;
    for (const LedgerColumn& column : ledger_columns) row.push_back(ledger.*column.value);
    return row;
}

/// Packing takes and gives back a quarter of a megabyte for each array. Where the heap shrank and grew each time, that took longer than
/// all else.
void keep_heap()
{
#ifdef __GLIBC__
    constexpr int kept = 32 << 20, largest = 4 << 20; // bytes at its end; of a block that lies in it
    static const bool done = mallopt(M_TRIM_THRESHOLD, kept) != 0 && mallopt(M_MMAP_THRESHOLD, largest) != 0;
    static_cast<void>(done);
#endif
}

void write_textile(hid_t file, const Textile& textile)
{
    const h5::Handle group = h5::create_group(file, "textile");
    const auto n = static_cast<std::size_t>(textile.segments());
    std::vector<int> yarn(n), kind(n), end_of(n), pick_of(n);
    std::vector<double> length(n);
    std::vector<float> position(3 * n);
    const auto shown = [](double m) { return static_cast<float>(std::round(0x1p26 * m) * 0x1p-26); }; // to 15 nm: half the bytes
    for (YarnKind k : {YarnKind::warp, YarnKind::weft})
        for (int end = 0; end < textile.ends(); ++end)
            for (int pick = 0; pick < textile.picks(); ++pick) {
                const auto i = static_cast<std::size_t>(textile.segment(k, end, pick));
                kind[i] = k == YarnKind::weft;
                yarn[i] = k == YarnKind::warp ? end : pick;
                end_of[i] = end;
                pick_of[i] = pick;
                length[i] = textile.segment_length(k, end, pick);
                position[3 * i] = shown(textile.x_of_end(end));
                position[3 * i + 1] = shown(textile.y_of_pick(pick));
                position[3 * i + 2] = shown(textile.height_at_crossing(k, end, pick));
            }
    h5::write_ints(group.get(), "yarn", yarn);
    h5::write_ints(group.get(), "kind", kind); // 0 warp, 1 weft
    h5::write_ints(group.get(), "end", end_of);
    h5::write_ints(group.get(), "pick", pick_of);
    h5::write_doubles(group.get(), "length", length, "m");
    h5::write_floats(group.get(), "position", position.data(), n, 3, "m");
}

void write_provenance(hid_t file, const RunRecord& run)
{
    const h5::Handle provenance = h5::create_group(file, "provenance");
    h5::write_text(provenance.get(), "program", std::string("Hygroloom ") + program_version());
    h5::write_text(provenance.get(), "version", program_version());
    h5::write_text(provenance.get(), "commit", program_commit());
    h5::write_text(provenance.get(), "fabric", run.fabric);
    h5::write_text(provenance.get(), "experiment", run.experiment);
    h5::write_text(provenance.get(), "backend", run.backend);
    h5::write_text(provenance.get(), "device", run.device);
    h5::write_text(provenance.get(), "fidelity", name_of(run.plan.fidelity));
    h5::write_text(provenance.get(), "plan", plan_json(run.plan));
    h5::write_text(provenance.get(), "date", run.date);
    h5::write_text(provenance.get(), "seed", std::to_string(run.seed));
    h5::write_number(provenance.get(), "threads", run.threads);
    for (const auto& [name, time] : stored_acts(run.acts))
        if (*time) h5::write_number(provenance.get(), name, **time);
}

/// Drops that stand as caps: where they are, and base, height and volume of each.
void write_caps(hid_t group, const std::vector<FrameCap>& caps)
{
    std::vector<float> place, size;
    for (const FrameCap& cap : caps) {
        for (double value : {cap.x, cap.y, cap.face}) place.push_back(static_cast<float>(value));
        for (double value : {cap.base, cap.height, cap.volume}) size.push_back(static_cast<float>(value));
    }
    h5::write_floats(group, "cap_place", place.data(), caps.size(), 3, "m");
    h5::write_floats(group, "cap_size", size.data(), caps.size(), 3, "m, m, m3");
}

/// changes: of the frames before; none where all are whole.
void write_frame(hid_t group, const Frame& frame, ChangesWriter* changes)
{
    h5::write_number(group, "time_s", frame.time);
    h5::write_number(group, "water_top_kg", frame.water_top);
    h5::write_number(group, "water_bottom_kg", frame.water_bottom);
    const auto n = frame.saturation.size();
    if (!changes || !changes->write(group, frame))
        for (const FrameField& field : frame_fields) h5::write_floats(group, field.name, field.in(frame).data(), n, 1, field.unit);
    const auto particles = frame.positions.size();
    if (!changes || particles > 0) { // of no other recordings readers take a frame without
        h5::write_floats(group, "particle_position", particles ? frame.positions[0].data() : nullptr, particles, 3, "m");
        h5::write_floats(group, "particle_velocity", particles ? frame.velocities[0].data() : nullptr, particles, 3, "m/s");
    }
    if (!frame.caps.empty()) write_caps(group, frame.caps);
    if (!frame.wet.empty()) h5::write_floats(group, "wet", frame.wet[0].first, wet_numbers * frame.wet.size(), 1, "1");
}

/// Of each field of a frame.
std::size_t values_of(const RunRecord& run, bool in_bundles)
{
    if (!in_bundles) return static_cast<std::size_t>(run.textile.segments());
    const auto yarns = [&](int single) { return static_cast<std::size_t>(bundles_of(single, run.plan.crossings_per_cell).count); };
    return 2 * yarns(run.plan.region.ends) * yarns(run.plan.region.picks);
}

} // namespace

struct RecordingWriter::File {
    explicit File(const std::filesystem::path& path) : name(path.string()), target(path) {}

    std::string name;
    RecordingTarget target; // outlives what the library has open in it
    h5::Handle file;
    h5::Handle ledger;
    std::optional<ChangesWriter> changes; ///< of frames, where some hold these
    std::mutex adding;
    int frames = 0;
    double end = 0;      ///< s, of the last frame
    double kept_end = 0; ///< s, of the last frame that took effect
    bool waits = false;  ///< something was added since the last commit

    hid_t id() const { return file.get(); }
    /// What fails leaves the recording as it was before, and nothing is added to it any more.
    template <typename Write> void attempt(Write write);
    void commit_when_due();
    void close(bool is_whole);
    /// The state that a run begins with is no reason to lose an older recording.
    bool may_replace() const { return frames > 1; }
};

template <typename Write> void RecordingWriter::File::attempt(Write write)
{
    h5::silence();
    try {
        write();
    } catch (const FileError& error) {
        if (target.failure().empty()) target.give_up(error.what());
        throw FileError(fmt::format("{}: {}; {}", name, target.failure(),
                                    target.in_place() ? fmt::format("the recording ends at {:.4g} s and can be read up to there.", kept_end)
                                                      : "nothing was recorded, and what had this name before stays."));
    }
}

void RecordingWriter::File::commit_when_due()
{
    if (!waits || !target.is_due()) return;
    if (H5Fflush(id(), H5F_SCOPE_GLOBAL) < 0) throw FileError("the recording cannot be written");
    if (!target.commit(RecordingTarget::Commit::may_wait, may_replace())) return;
    kept_end = end;
    waits = false;
}

void RecordingWriter::File::close(bool is_whole)
{
    ledger.reset();
    file.reset();
    target.commit(RecordingTarget::Commit::now, is_whole || may_replace());
}

RecordingWriter::RecordingWriter(const std::filesystem::path& path, const RunRecord& run, bool in_bundles)
    : file_(std::make_unique<File>(path))
{
    keep_heap();
    file_->attempt([&] {
        file_->file = h5::create_file(file_->target, "the recording cannot be created");
        const hid_t file = file_->id();
        h5::write_text(file, "format", recording_format);
        const bool shows_cells = run.plan.shown_ends > 0, changes = keeps_changes(values_of(run, in_bundles), shows_cells);
        h5::write_number(file, "version",
                         changes       ? recording_version
                         : in_bundles  ? recording_version_bundles
                         : shows_cells ? recording_version_cells
                                       : recording_version_plain);
        h5::write_text(file, "design", format_project(run.design));
        write_provenance(file, run);
        write_textile(file, run.textile);
        h5::create_group(file, "frames");
        if (changes) file_->changes.emplace(file, in_bundles);
        file_->ledger = h5::create_table(file, "ledger", std::size(ledger_columns), column_names());
    });
}

/// Frames that wait for a reader are not lost.
RecordingWriter::~RecordingWriter()
{
    if (!file_ || !file_->file.get() || file_->frames == 0 || !file_->target.failure().empty()) return;
    try {
        file_->close(false);
    } catch (const FileError&) {
        // the frames before can be read
    }
}

void RecordingWriter::append(const Frame& frame)
{
    const std::lock_guard alone(file_->adding);
    file_->attempt([&] {
        {
            const h5::Handle frames = h5::open_group(file_->id(), "frames");
            const h5::Handle group = h5::create_group(frames.get(), frame_name(file_->frames));
            write_frame(group.get(), frame, file_->changes ? &*file_->changes : nullptr);
        }
        if (frame.unsolved_lines > 0)
            h5::write_number(h5::open_group(file_->id(), "provenance").get(), "unsolved_lines", frame.unsolved_lines);
        h5::append_row(file_->ledger.get(), row_of(frame.ledger));
        ++file_->frames;
        file_->end = frame.time;
        file_->waits = true;
        file_->commit_when_due();
    });
}

void RecordingWriter::commit_when_due()
{
    const std::unique_lock alone(file_->adding, std::try_to_lock);
    if (alone) file_->attempt([&] { file_->commit_when_due(); });
}

void RecordingWriter::note_device(const std::string& device)
{
    const std::lock_guard alone(file_->adding);
    file_->attempt([&] { h5::write_text(h5::open_group(file_->id(), "provenance").get(), "all_devices", device); });
}

void RecordingWriter::note_switched_on(const SwitchedPart& part)
{
    const std::lock_guard alone(file_->adding);
    file_->attempt([&] {
        const h5::Handle provenance = h5::open_group(file_->id(), "provenance");
        const h5::Handle all = h5::exists(provenance.get(), "switched_on") ? h5::open_group(provenance.get(), "switched_on")
                                                                           : h5::create_group(provenance.get(), "switched_on");
        const h5::Handle group = h5::create_group(all.get(), part.name);
        h5::write_number(group.get(), "time_s", part.time);
        h5::write_number(group.get(), "share", part.share);
        h5::write_number(group.get(), "limit", part.limit);
        if (part.estimate) h5::write_number(group.get(), "estimate", *part.estimate);
        if (!part.kept_off.empty()) h5::write_text(group.get(), "kept_off", part.kept_off);
        file_->waits = file_->frames > 0;
        file_->commit_when_due();
    });
}

void RecordingWriter::finish(double wall)
{
    file_->attempt([&] {
        h5::write_number(file_->id(), "wall_s", wall);
        h5::write_number(h5::open_group(file_->id(), "provenance").get(), "wall_s", wall);
        file_->close(true);
        file_->target.sync();
    });
    file_.reset();
}

} // namespace hygroloom
