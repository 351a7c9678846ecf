// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Frames are written whole and flushed before the ledger's row that counts them, so a cut recording reads up to its last row.
#include "core/run/recording.h"

#include "core/base/error.h"
#include "core/plan/plan_json.h"
#include "core/project/project_file.h"
#include "core/run/hdf5_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace hygroloom {

namespace h5 = hdf5;

namespace {

constexpr int recording_version = 1;

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

Ledger ledger_of(const std::vector<double>& row)
{
    if (row.size() != std::size(ledger_columns)) throw FileError("The recording's ledger has the wrong number of columns; it is damaged.");
    Ledger ledger;
    for (std::size_t k = 0; k < row.size(); ++k) ledger.*ledger_columns[k].value = row[k];
    return ledger;
}

void write_textile(hid_t file, const Textile& textile)
{
    const h5::Handle group = h5::create_group(file, "textile");
    const auto n = static_cast<std::size_t>(textile.segments());
    std::vector<int> yarn(n), kind(n), end_of(n), pick_of(n);
    std::vector<double> length(n);
    std::vector<float> position(3 * n);
    for (YarnKind k : {YarnKind::warp, YarnKind::weft})
        for (int end = 0; end < textile.ends(); ++end)
            for (int pick = 0; pick < textile.picks(); ++pick) {
                const auto i = static_cast<std::size_t>(textile.segment(k, end, pick));
                kind[i] = k == YarnKind::weft;
                yarn[i] = k == YarnKind::warp ? end : pick;
                end_of[i] = end;
                pick_of[i] = pick;
                length[i] = textile.segment_length(k, end, pick);
                position[3 * i] = static_cast<float>(textile.x_of_end(end));
                position[3 * i + 1] = static_cast<float>(textile.y_of_pick(pick));
                position[3 * i + 2] = static_cast<float>(textile.height_at_crossing(k, end, pick));
            }
    h5::write_ints(group.get(), "yarn", yarn);
    h5::write_ints(group.get(), "kind", kind); // 0 warp, 1 weft
    h5::write_ints(group.get(), "end", end_of);
    h5::write_ints(group.get(), "pick", pick_of);
    h5::write_doubles(group.get(), "length", length, "m");
    h5::write_floats(group.get(), "position", position.data(), n, 3, "m");
}

std::vector<float> pore_shares(const Textile& textile, YarnKind kind)
{
    std::vector<float> shares;
    for (int yarn = 0; yarn < textile.system(kind).count; ++yarn)
        shares.push_back(static_cast<float>(1.0 - textile.type(kind, yarn).packing));
    return shares;
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

std::string frame_name(int index) { return fmt::format("frames/{:06d}", index); }

} // namespace

struct RecordingWriter::File {
    h5::Handle file;
    h5::Handle ledger;
    int frames = 0;
    std::vector<float> warp_pores, weft_pores; ///< pore volume / yarn volume of each end and of each pick
};

RecordingWriter::RecordingWriter(const std::filesystem::path& path, const RunRecord& run) : file_(std::make_unique<File>())
{
    const h5::Quiet quiet;
    std::error_code ignored;
    if (std::filesystem::file_size(path, ignored) > 0 && !ignored && H5Fis_hdf5(path.c_str()) <= 0)
        throw FileError(path.string() +
                        ": there is a file of this name already and it is no recording. Choose another name for the recording.");
    file_->file = h5::Handle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose,
                             path.string() + ": the recording cannot be created. Check that the folder exists and can be written to.");
    const hid_t file = file_->file.get();
    h5::write_text(file, "format", "hygroloom-recording");
    h5::write_number(file, "version", recording_version);
    h5::write_text(file, "design", format_project(run.design));
    {
        const h5::Handle provenance = h5::create_group(file, "provenance");
        h5::write_text(provenance.get(), "program", std::string("Hygroloom ") + HYGROLOOM_VERSION);
        h5::write_text(provenance.get(), "version", HYGROLOOM_VERSION);
        h5::write_text(provenance.get(), "commit", HYGROLOOM_COMMIT);
        h5::write_text(provenance.get(), "fabric", run.fabric);
        h5::write_text(provenance.get(), "experiment", run.experiment);
        h5::write_text(provenance.get(), "backend", run.backend);
        h5::write_text(provenance.get(), "device", run.device);
        h5::write_text(provenance.get(), "fidelity", name_of(run.plan.fidelity));
        h5::write_text(provenance.get(), "plan", plan_json(run.plan));
        h5::write_text(provenance.get(), "date", run.date);
        h5::write_text(provenance.get(), "seed", std::to_string(run.seed));
        h5::write_number(provenance.get(), "threads", run.threads);
    }
    write_textile(file, run.textile);
    h5::create_group(file, "frames");
    file_->warp_pores = pore_shares(run.textile, YarnKind::warp);
    file_->weft_pores = pore_shares(run.textile, YarnKind::weft);
    file_->ledger = h5::create_table(file, "ledger", std::size(ledger_columns), column_names());
    H5Fflush(file, H5F_SCOPE_GLOBAL);
}

RecordingWriter::~RecordingWriter() = default;

void RecordingWriter::append(const Frame& frame)
{
    const h5::Quiet quiet;
    {
        const h5::Handle group = h5::create_group(file_->file.get(), frame_name(file_->frames));
        const hid_t g = group.get();
        h5::write_number(g, "time_s", frame.time);
        h5::write_number(g, "water_top_kg", frame.water_top);
        h5::write_number(g, "water_bottom_kg", frame.water_bottom);
        const auto n = frame.saturation.size();
        std::vector<float> fraction;
        fraction.reserve(n);
        const auto along = [&](const std::vector<float>& pores, std::size_t crossed) { // segments are numbered along the yarns
            for (float share : pores)
                for (std::size_t i = 0; i < crossed; ++i) fraction.push_back(frame.saturation[fraction.size()] * share);
        };
        along(file_->warp_pores, file_->weft_pores.size());
        along(file_->weft_pores, file_->warp_pores.size());
        h5::write_floats(g, "liquid_volume_fraction", fraction.data(), n, 1, "1");
        for (const FrameField& field : frame_fields) h5::write_floats(g, field.name, field.in(frame).data(), n, 1, field.unit);
        const auto particles = frame.positions.size();
        h5::write_floats(g, "particle_position", particles ? frame.positions[0].data() : nullptr, particles, 3, "m");
        h5::write_floats(g, "particle_velocity", particles ? frame.velocities[0].data() : nullptr, particles, 3, "m/s");
    }
    if (frame.unsolved_lines > 0)
        h5::write_number(h5::open_group(file_->file.get(), "provenance").get(), "unsolved_lines", frame.unsolved_lines);
    h5::append_row(file_->ledger.get(), row_of(frame.ledger));
    if (H5Fflush(file_->file.get(), H5F_SCOPE_GLOBAL) < 0) throw FileError("The recording cannot be written; the disk may be full.");
    ++file_->frames;
}

void RecordingWriter::note_device(const std::string& device)
{
    const h5::Quiet quiet;
    h5::write_text(h5::open_group(file_->file.get(), "provenance").get(), "all_devices", device);
}

void RecordingWriter::note_switched_on(const SwitchedPart& part)
{
    const h5::Quiet quiet;
    const h5::Handle provenance = h5::open_group(file_->file.get(), "provenance");
    const h5::Handle all = h5::exists(provenance.get(), "switched_on") ? h5::open_group(provenance.get(), "switched_on")
                                                                       : h5::create_group(provenance.get(), "switched_on");
    const h5::Handle group = h5::create_group(all.get(), part.name);
    h5::write_number(group.get(), "time_s", part.time);
    h5::write_number(group.get(), "share", part.share);
    h5::write_number(group.get(), "limit", part.limit);
    if (part.estimate) h5::write_number(group.get(), "estimate", *part.estimate);
    if (!part.kept_off.empty()) h5::write_text(group.get(), "kept_off", part.kept_off);
    H5Fflush(file_->file.get(), H5F_SCOPE_GLOBAL);
}

void RecordingWriter::finish(double wall)
{
    const h5::Quiet quiet;
    h5::write_number(file_->file.get(), "wall_s", wall);
    h5::write_number(h5::open_group(file_->file.get(), "provenance").get(), "wall_s", wall);
    file_->ledger.reset();
    file_->file.reset();
}

struct Recording::File {
    h5::Handle file;
    RunRecord run;
    bool finished = false;
    std::vector<Ledger> ledgers;
};

Recording::Recording(const std::filesystem::path& path)
try : file_(std::make_unique<File>()) {
    const h5::Quiet quiet;
    if (!std::filesystem::exists(path)) throw FileError("there is no such file.");
    if (path.extension() == ".hygro" && H5Fis_hdf5(path.c_str()) <= 0)
        throw FileError(fmt::format("this is a project, not a recording. Run it first: hygroloom-cli simulate {} -o {}.", path.string(),
                                    std::filesystem::path(path).replace_extension(".hygrorec").string()));
    file_->file = h5::Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose,
                             "this is not a recording, or it is damaged or incomplete.");
    const hid_t file = file_->file.get();
    if (!h5::exists(file, "format") || h5::read_text(file, "format") != "hygroloom-recording")
        throw FileError("this is not a Hygroloom recording.");
    const double version = h5::read_number(file, "version");
    if (version > recording_version)
        throw FileError(
            fmt::format("the recording has version {:.0f}; this program reads up to {}. Use a newer program.", version, recording_version));

    RunRecord& run = file_->run;
    run.design = parse_project(h5::read_text(file, "design"), "the recording's design");
    const h5::Handle provenance = h5::open_group(file, "provenance");
    run.fabric = h5::read_text(provenance.get(), "fabric");
    run.experiment = h5::read_text(provenance.get(), "experiment");
    run.backend = h5::read_text(provenance.get(), "backend");
    run.device = h5::read_text(provenance.get(), h5::exists(provenance.get(), "all_devices") ? "all_devices" : "device");
    run.plan = plan_from_json(h5::read_text(provenance.get(), "plan"));
    run.switched_on = read_switched_on(provenance.get());
    if (h5::has_number(provenance.get(), "unsolved_lines")) run.unsolved_lines = h5::read_number(provenance.get(), "unsolved_lines");
    if (h5::exists(provenance.get(), "date")) run.date = h5::read_text(provenance.get(), "date");
    run.seed = std::stoull(h5::read_text(provenance.get(), "seed"));
    run.threads = static_cast<int>(h5::read_number(provenance.get(), "threads"));
    const Fabric* fabric = find_fabric(run.design, run.fabric);
    const Experiment* experiment = find_experiment(run.design, run.experiment);
    const Validation valid = validate_and_fit(run.design);
    if (!fabric || !experiment || has_error(valid.issues)) throw FileError("the recording's design is not valid; it is damaged.");
    const TextileRegion& region = run.plan.region;
    const std::array<double, 2> sample = sample_extent_mm(*experiment);
    const TextileRegion most = region_of_sample(*fabric, sample[0], sample[1]);
    if (region.ends < 1 || region.picks < 1 || region.ends > most.ends || region.picks > most.picks)
        throw FileError("the recording's region does not lie in its sample; it is damaged.");
    const auto place = static_cast<std::size_t>(fabric - run.design.fabrics.data());
    run.textile = textile_of_run(run.design, *fabric, *experiment, region, valid.fabrics[place].get());
    file_->finished = H5Aexists(file, "wall_s") > 0;
    if (file_->finished) run.wall = h5::read_number(file, "wall_s");
    for (const std::vector<double>& row : h5::read_table(file, "ledger")) {
        if (!h5::exists(file, frame_name(static_cast<int>(file_->ledgers.size())))) break;
        file_->ledgers.push_back(ledger_of(row));
    }
} catch (const Error& e) {
    throw FileError(path.string() + ": " + e.what());
} catch (const std::logic_error&) {
    throw FileError(path.string() + ": the recording is damaged.");
}

Recording::~Recording() = default;
Recording::Recording(Recording&&) noexcept = default;

const RunRecord& Recording::run() const { return file_->run; }
bool Recording::finished() const { return file_->finished; }
int Recording::frames() const { return static_cast<int>(file_->ledgers.size()); }
const std::vector<Ledger>& Recording::ledgers() const { return file_->ledgers; }

Frame Recording::frame(int index, std::span<const FrameField> fields) const
{
    const h5::Quiet quiet;
    const h5::Handle group = h5::open_group(file_->file.get(), frame_name(index));
    const hid_t g = group.get();
    Frame frame;
    frame.time = h5::read_number(g, "time_s");
    frame.water_top = h5::read_number(g, "water_top_kg");
    frame.water_bottom = h5::read_number(g, "water_bottom_kg");
    const auto n = static_cast<std::size_t>(file_->run.textile.segments());
    for (const FrameField& field : fields) {
        const bool is_older = field.absent && !h5::exists(g, field.name);
        std::vector<float>& values = field.in(frame);
        values = is_older ? std::vector<float>(n, *field.absent) : h5::read_floats(g, field.name);
        if (values.size() != n) throw FileError("The recording is damaged: a frame has the wrong number of segments.");
    }
    frame.ledger = file_->ledgers[static_cast<std::size_t>(index)];
    const std::vector<float> x = h5::read_floats(g, "particle_position"), v = h5::read_floats(g, "particle_velocity");
    for (std::size_t i = 0; i + 2 < x.size() && i + 2 < v.size(); i += 3) {
        frame.positions.push_back({x[i], x[i + 1], x[i + 2]});
        frame.velocities.push_back({v[i], v[i + 1], v[i + 2]});
    }
    return frame;
}

} // namespace hygroloom
