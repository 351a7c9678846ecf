// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/base/error.h"
#include "core/base/version.h"
#include "core/plan/bundles.h"
#include "core/plan/plan_json.h"
#include "core/project/project_file.h"
#include "core/run/frame_changes.h"
#include "core/run/recording.h"
#include "core/run/recording_layout.h"

#include <cmath>
#include <optional>

namespace hygroloom {

namespace {

template <typename Number> void write_field(RunFileWriter& file, const char* name, const std::vector<Number>& numbers, const char* unit)
{
    file.field(name, std::span<const Number>(numbers), unit);
}

void write_textile(RunFileWriter& file, const Textile& textile)
{
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
    write_field(file, "textile/yarn", yarn, "1");
    write_field(file, "textile/kind", kind, "1"); // 0 warp, 1 weft
    write_field(file, "textile/end", end_of, "1");
    write_field(file, "textile/pick", pick_of, "1");
    write_field(file, "textile/length", length, "m");
    write_field(file, "textile/position", position, "m"); // x, y and z of each
}

void write_provenance(RunFileWriter& file, const RunRecord& run)
{
    const std::pair<const char*, std::string> texts[] = {{"program", std::string("Hygroloom ") + program_version()},
                                                         {"version", program_version()},
                                                         {"commit", program_commit()},
                                                         {"fabric", run.fabric},
                                                         {"experiment", run.experiment},
                                                         {"backend", run.backend},
                                                         {"device", run.device},
                                                         {"fidelity", name_of(run.plan.fidelity)},
                                                         {"plan", plan_json(run.plan)},
                                                         {"date", run.date},
                                                         {"answers", run.answers},
                                                         {"seed", std::to_string(run.seed)}};
    for (const auto& [name, text] : texts) file.text(std::string("provenance/") + name, text);
    file.number("provenance/threads", run.threads);
    for (const auto& [name, time] : stored_acts(run.acts))
        if (*time) file.number(name, **time);
}

/// Drops that stand as caps: where they are, and base, height and volume of each.
void write_caps(RunRow& row, const std::vector<FrameCap>& caps)
{
    std::vector<float> place, size;
    for (const FrameCap& cap : caps) {
        for (double value : {cap.x, cap.y, cap.face}) place.push_back(static_cast<float>(value));
        for (double value : {cap.base, cap.height, cap.volume}) size.push_back(static_cast<float>(value));
    }
    row.field("cap_place", std::span<const float>(place));
    row.field("cap_size", std::span<const float>(size));
}

std::span<const float> flat(const std::vector<std::array<float, 3>>& places)
{
    return {places.empty() ? nullptr : places[0].data(), 3 * places.size()};
}

/// changes: of the frames before; none where all are whole.
void write_frame(RunRow& row, const Frame& frame, ChangesWriter* changes)
{
    row.number("water_top_kg", frame.water_top);
    row.number("water_bottom_kg", frame.water_bottom);
    if (!changes || !changes->write(row, frame))
        for (const FrameField& field : frame_fields) row.field(field.name, std::span<const float>(field.in(frame)));
    if (!frame.positions.empty()) {
        row.field("particle_position", flat(frame.positions));
        row.field("particle_velocity", flat(frame.velocities));
    }
    if (!frame.caps.empty()) write_caps(row, frame.caps);
    if (!frame.wet.empty()) row.field("wet", std::span<const float>(frame.wet[0].first, wet_numbers * frame.wet.size()));
}

std::vector<RunColumn> columns_of_frames()
{
    std::vector<RunColumn> columns{{"water_top_kg"}, {"water_bottom_kg"}, {follows_column}};
    for (const FrameField& field : frame_fields) columns.push_back({field.name, field.unit});
    for (const auto& [name, unit] :
         {std::pair{"particle_position", "m"}, {"particle_velocity", "m/s"}, {"cap_place", "m"}, {"cap_size", "m, m, m3"}, {"wet", "1"}})
        columns.push_back({name, unit});
    return columns;
}

/// Of each field of a frame.
std::size_t values_of(const RunRecord& run, bool in_bundles)
{
    if (!in_bundles) return static_cast<std::size_t>(run.textile.segments());
    const auto yarns = [&](int single) { return static_cast<std::size_t>(bundles_of(single, run.plan.bundling()).count); };
    return 2 * yarns(run.plan.region.ends) * yarns(run.plan.region.picks);
}

} // namespace

struct RecordingWriter::File {
    RunFileWriter file;
    std::optional<ChangesWriter> changes; ///< of frames, where some hold these
};

RecordingWriter::RecordingWriter(const std::filesystem::path& path, const RunRecord& run, bool in_bundles)
    : file_(new File{{path, recording_format, columns_of_frames()}, {}})
{
    RunFileWriter& file = file_->file;
    file.text("design", format_project(run.design));
    file.number("in_bundles", in_bundles);
    write_provenance(file, run);
    write_textile(file, run.textile);
    if (keeps_changes(values_of(run, in_bundles), run.plan.shown_ends > 0)) file_->changes.emplace(file, in_bundles);
}

RecordingWriter::~RecordingWriter() = default;

void RecordingWriter::append(const Frame& frame)
{
    if (frame.unsolved_lines > 0) file_->file.number("provenance/unsolved_lines", frame.unsolved_lines);
    file_->file.append(frame.time, frame.ledger,
                       [&](RunRow& row) { write_frame(row, frame, file_->changes ? &*file_->changes : nullptr); });
}

void RecordingWriter::commit_when_due() { file_->file.commit_when_due(); }

void RecordingWriter::note_device(const std::string& device) { file_->file.text("provenance/all_devices", device); }

void RecordingWriter::note_switched_on(const SwitchedPart& part)
{
    const std::string place = "provenance/switched_on/" + part.name + "/";
    file_->file.number(place + "share", part.share);
    file_->file.number(place + "limit", part.limit);
    if (part.estimate) file_->file.number(place + "estimate", *part.estimate);
    if (!part.kept_off.empty()) file_->file.text(place + "kept_off", part.kept_off);
    file_->file.number(place + "time_s", part.time); // the last: readers ask for it first
}

void RecordingWriter::finish(double wall)
{
    file_->file.finish(wall);
    file_.reset();
}

} // namespace hygroloom
