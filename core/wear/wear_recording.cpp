// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/wear/wear_recording.h"

#include "core/base/error.h"
#include "core/base/utf8.h"
#include "core/project/project_file.h"
#include "core/run/hdf5_reader.h"
#include "core/run/recording_layout.h"
#include "core/run/recording_source.h"
#include "core/run/recording_target.h"
#include "core/wear/wear_layout_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace h5 = hdf5;

namespace {

constexpr const char* wear_format = "hygroloom-wear-recording";
constexpr int wear_version = 1;
constexpr long most_vertices = 20'000'000;
constexpr double most_far = 1000;                         // m, of places in space
constexpr double least_amount = 1e-20, most_amount = 1e6; // m2 or kg, of cells

/// What cells hold that is written as numbers.
struct CellColumn {
    const char* name;
    const char* unit;
    double (*of)(const GarmentCell&);
    void (*set)(GarmentCell&, float);
};
constexpr CellColumn cell_columns[] = {
    {"panel", "1", [](const GarmentCell& c) -> double { return c.panel; }, [](GarmentCell& c, float v) { c.panel = static_cast<int>(v); }},
    {"end", "1", [](const GarmentCell& c) -> double { return c.end; }, [](GarmentCell& c, float v) { c.end = static_cast<int>(v); }},
    {"pick", "1", [](const GarmentCell& c) -> double { return c.pick; }, [](GarmentCell& c, float v) { c.pick = static_cast<int>(v); }},
    {"zone", "1", [](const GarmentCell& c) -> double { return c.zone; }, [](GarmentCell& c, float v) { c.zone = static_cast<int>(v); }},
    {"x", "m", [](const GarmentCell& c) { return c.place.x; }, [](GarmentCell& c, float v) { c.place.x = static_cast<double>(v); }},
    {"y", "m", [](const GarmentCell& c) { return c.place.y; }, [](GarmentCell& c, float v) { c.place.y = static_cast<double>(v); }},
    {"z", "m", [](const GarmentCell& c) { return c.place.z; }, [](GarmentCell& c, float v) { c.place.z = static_cast<double>(v); }},
    {"area", "m2", [](const GarmentCell& c) { return c.area; }, [](GarmentCell& c, float v) { c.area = static_cast<double>(v); }},
    {"capacity", "kg", [](const GarmentCell& c) { return c.capacity; },
     [](GarmentCell& c, float v) { c.capacity = static_cast<double>(v); }},
    {"skin_contact", "W/(m2 K)", [](const GarmentCell& c) { return c.skin_contact; },
     [](GarmentCell& c, float v) { c.skin_contact = static_cast<double>(v); }},
};

void write_values(hid_t group, const char* name, const std::vector<float>& values, const char* unit)
{
    h5::write_floats(group, name, values.data(), values.size(), 1, unit);
}

std::vector<float> as_floats(const std::vector<double>& values) { return {values.begin(), values.end()}; }

void write_shape(hid_t file, const GarmentShape& shape)
{
    const h5::Handle group = h5::create_group(file, "shape");
    std::vector<float> places, flat, corners;
    for (std::size_t i = 0; i < shape.places.size(); ++i) {
        for (double value : {shape.places[i].x, shape.places[i].y, shape.places[i].z}) places.push_back(static_cast<float>(value));
        for (double value : shape.flat[i]) flat.push_back(static_cast<float>(value));
    }
    for (std::size_t t = 0; t < shape.triangles.size(); ++t) {
        for (int corner : shape.triangles[t]) corners.push_back(static_cast<float>(corner));
        corners.push_back(static_cast<float>(shape.panel[t]));
    }
    h5::write_number(group.get(), "vertices", static_cast<double>(shape.places.size()));
    h5::write_number(group.get(), "triangles", static_cast<double>(shape.triangles.size()));
    write_values(group.get(), "places", places, "m");
    write_values(group.get(), "flat", flat, "m");
    write_values(group.get(), "corners", corners, "1");
}

/// Throws FileError where the shape takes more memory than 120 MB and three times the file: what is packed may claim to be any size.
GarmentShape read_shape(hid_t file, std::size_t panels, std::uint64_t file_bytes)
{
    const h5::Handle group = h5::open_group(file, "shape");
    const long vertices = h5::read_count(group.get(), "vertices", 0, most_vertices),
               triangles = h5::read_count(group.get(), "triangles", 0, most_vertices);
    constexpr std::uint64_t base_bytes = 120'000'000;
    GarmentShape shape;
    const std::uint64_t bytes = static_cast<std::uint64_t>(vertices) * (sizeof shape.places[0] + sizeof shape.flat[0]) +
                                static_cast<std::uint64_t>(triangles) * (sizeof shape.triangles[0] + 5 * sizeof shape.panel[0]);
    if (bytes > base_bytes + 3 * file_bytes)
        throw FileError(
            fmt::format("its shape of {} vertices and {} triangles is too large for the file; it is damaged.", vertices, triangles));
    const std::vector<float> places = h5::read_floats(group.get(), "places", static_cast<hsize_t>(3 * vertices)),
                             flat = h5::read_floats(group.get(), "flat", static_cast<hsize_t>(2 * vertices)),
                             corners = h5::read_floats(group.get(), "corners", static_cast<hsize_t>(4 * triangles));
    shape.places.reserve(static_cast<std::size_t>(vertices));
    shape.flat.reserve(static_cast<std::size_t>(vertices));
    shape.triangles.reserve(static_cast<std::size_t>(triangles));
    shape.panel.reserve(static_cast<std::size_t>(triangles));
    for (const std::vector<float>* all : {&places, &flat})
        if (std::any_of(all->begin(), all->end(), [](float at) { return !(std::abs(at) <= static_cast<float>(most_far)); }))
            throw FileError(fmt::format("its shape reaches farther than {:g} m; it is damaged.", most_far));
    for (std::size_t i = 0; i < static_cast<std::size_t>(vertices); ++i) {
        shape.places.push_back(
            {static_cast<double>(places[3 * i]), static_cast<double>(places[3 * i + 1]), static_cast<double>(places[3 * i + 2])});
        shape.flat.push_back({static_cast<double>(flat[2 * i]), static_cast<double>(flat[2 * i + 1])});
    }
    for (std::size_t t = 0; t < static_cast<std::size_t>(triangles); ++t) {
        const auto number = [&](std::size_t k, double below) {
            const auto value = static_cast<double>(corners[4 * t + k]);
            if (!(value >= 0 && value < below)) throw FileError("a triangle of its shape names what does not exist; it is damaged.");
            return static_cast<int>(value);
        };
        const auto most = static_cast<double>(vertices);
        shape.triangles.push_back({number(0, most), number(1, most), number(2, most)});
        shape.panel.push_back(number(3, static_cast<double>(panels)));
    }
    return shape;
}

std::vector<GarmentCell> read_cells(hid_t file, const WearLayout& layout)
{
    const std::size_t zones = body_zones().size() + layout.own_zones.size();
    const h5::Handle group = h5::open_group(file, "cells");
    const auto count = static_cast<std::size_t>(h5::read_count(group.get(), "count", 1, most_layout_cells));
    std::vector<GarmentCell> cells;
    for (const CellColumn& column : cell_columns) {
        const std::vector<float> values = h5::read_floats(group.get(), column.name, count);
        cells.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            if (column.unit == std::string_view("1") && !(values[i] >= 0 && values[i] < 1e6F))
                throw FileError("a cell lies nowhere; it is damaged.");
            column.set(cells[i], values[i]);
        }
    }
    for (GarmentCell& cell : cells) {
        const auto is_amount = [](double value) { return value >= least_amount && value <= most_amount; };
        if (static_cast<std::size_t>(cell.panel) >= layout.panels.size() || static_cast<std::size_t>(cell.zone) >= zones ||
            !(is_amount(cell.area) && is_amount(cell.capacity)))
            throw FileError("a cell is of no panel or no zone, or holds nothing; it is damaged.");
        const PanelGrid& grid = layout.panels[static_cast<std::size_t>(cell.panel)].grid;
        if (cell.end >= grid.ends || cell.pick >= grid.picks) throw FileError("a cell lies outside its panel; it is damaged.");
        cell.flat = grid.middle(cell.end, cell.pick);
    }
    return cells;
}

} // namespace

struct WearWriter::File {
    explicit File(const std::filesystem::path& path) : name(path.string()), target(path) {}

    std::string name;
    RecordingTarget target; // outlives what the library has open in it
    h5::Handle file, ledger;
    int frames = 0;
    int kept_frames = 0; ///< that took effect

    /// What fails leaves the recording as it was before, and nothing is added to it any more.
    template <typename Write> void attempt(Write write)
    {
        h5::silence();
        try {
            write();
        } catch (const FileError& error) {
            if (target.failure().empty()) target.give_up(error.what());
            throw FileError(
                fmt::format("{}: {}; {} of its frames can be read.", name, target.failure(), target.in_place() ? kept_frames : 0));
        }
    }
    void close(bool is_whole)
    {
        ledger.reset();
        file.reset();
        target.commit(RecordingTarget::Commit::now, is_whole || frames > 1);
    }
};

WearWriter::WearWriter(const std::filesystem::path& path, const WearRecord& record) : file_(std::make_unique<File>(path))
{
    file_->attempt([&] {
        file_->file = h5::create_file(file_->target, "the recording cannot be created");
        const hid_t file = file_->file.get();
        h5::write_text(file, "format", wear_format);
        h5::write_number(file, "version", wear_version);
        h5::write_text(file, "design", format_project(record.design));
        h5::write_text(file, "layout", layout_json(record.layout));
        const h5::Handle provenance = h5::create_group(file, "provenance");
        for (const auto& [name, value] :
             {std::pair{"fidelity", record.fidelity}, {"backend", record.backend}, {"device", record.device}, {"date", record.date}})
            h5::write_text(provenance.get(), name, value);
        const h5::Handle cells = h5::create_group(file, "cells");
        h5::write_number(cells.get(), "count", static_cast<double>(record.layout.cells.size()));
        for (const CellColumn& column : cell_columns) {
            std::vector<float> values;
            for (const GarmentCell& cell : record.layout.cells) values.push_back(static_cast<float>(column.of(cell)));
            write_values(cells.get(), column.name, values, column.unit);
        }
        write_shape(file, record.layout.shape);
        h5::create_group(file, "frames");
        std::string names;
        for (const LedgerColumn& column : ledger_columns) names += (names.empty() ? "" : ",") + std::string(column.name);
        file_->ledger = h5::create_table(file, "ledger", std::size(ledger_columns), names);
    });
}

WearWriter::~WearWriter()
{
    if (!file_ || !file_->file.get() || file_->frames == 0 || !file_->target.failure().empty()) return;
    try {
        file_->close(false);
    } catch (const FileError&) {
        // the frames before can be read
    }
}

void WearWriter::append(const WearFrame& frame)
{
    file_->attempt([&] {
        {
            const h5::Handle frames = h5::open_group(file_->file.get(), "frames");
            const h5::Handle group = h5::create_group(frames.get(), frame_name(file_->frames));
            write_values(group.get(), "inside", as_floats(frame.inside), "kg");
            write_values(group.get(), "outside", as_floats(frame.outside), "kg");
            write_values(group.get(), "evaporated", as_floats(frame.evaporated), "kg");
            write_values(group.get(), "temperature", frame.temperature, "K");
            write_values(group.get(), "on_skin", as_floats(frame.on_skin), "kg");
        }
        std::vector<double> row;
        for (const LedgerColumn& column : ledger_columns) row.push_back(frame.ledger.*column.value);
        h5::append_row(file_->ledger.get(), row);
        ++file_->frames;
        if (H5Fflush(file_->file.get(), H5F_SCOPE_GLOBAL) < 0) throw FileError("the recording cannot be written");
        if (file_->target.commit(RecordingTarget::Commit::may_wait, file_->frames > 1)) file_->kept_frames = file_->frames;
    });
}

void WearWriter::finish(double wall)
{
    file_->attempt([&] {
        h5::write_number(file_->file.get(), "wall_s", wall);
        file_->close(true);
        file_->target.sync();
    });
    file_.reset();
}

struct WearRecording::File {
    explicit File(const std::filesystem::path& path) : name(path.string()), source(path) {}
    std::string name;
    RecordingSource source; // outlives what the library has open in it
    h5::Handle file;
    WearRecord record;
    double wall = 0;
    std::vector<Ledger> ledgers;

    void open()
    {
        if (!source.begins_as_hdf5()) throw FileError("this is not a Hygroloom recording.");
        file = h5::open_file(source, "this is not a Hygroloom recording, or it is damaged.");
        const hid_t id = file.get();
        if (!h5::exists(id, "format") || h5::read_text(id, "format") != wear_format)
            throw FileError("this is not the recording of a worn garment.");
        h5::read_count(id, "version", 1, wear_version);
        record.design = parse_project(h5::read_text(id, "design"), "the recording's design");
        record.layout = layout_from(h5::read_text(id, "layout"), "the recording's layout");
        const h5::Handle provenance = h5::open_group(id, "provenance");
        for (const auto& [name_of, text] :
             {std::pair{"fidelity", &record.fidelity}, {"backend", &record.backend}, {"device", &record.device}, {"date", &record.date}})
            *text = in_one_line(h5::read_text(provenance.get(), name_of));
        record.layout.cells = read_cells(id, record.layout);
        record.layout.shape = read_shape(id, record.layout.panels.size(), source.size());
        if (h5::has_number(id, "wall_s")) wall = h5::read_number(id, "wall_s");
        read_ledgers();
    }
    void read_ledgers();
};

/// Up to where there is no frame any more: what the ledger claims beyond is not read.
void WearRecording::File::read_ledgers()
{
    constexpr hsize_t block = 256;
    const h5::Handle groups = h5::open_group(file.get(), "frames");
    const h5::Table table(file.get(), "ledger", std::size(ledger_columns), std::size(ledger_columns));
    for (hsize_t first = 0; first < table.rows(); first += block) {
        const hsize_t count = std::min(block, table.rows() - first);
        bool some = false;
        for (hsize_t k = first; k < first + count && !some; ++k) some = h5::exists(groups.get(), frame_name(static_cast<int>(k)));
        if (!some) break;
        const std::vector<double> rows = table.read(first, count);
        for (hsize_t k = 0; k < count; ++k) {
            Ledger ledger;
            for (std::size_t c = 0; c < std::size(ledger_columns); ++c) {
                const double value = rows[k * std::size(ledger_columns) + c];
                if (!std::isfinite(value)) throw FileError(fmt::format("row {} of its ledger is not finite; it is damaged.", first + k));
                ledger.*ledger_columns[c].value = value;
            }
            ledgers.push_back(ledger);
        }
    }
    if (ledgers.empty()) throw FileError("it has no frame.");
}

bool WearRecording::is_one(const std::filesystem::path& path)
{
    h5::silence();
    try {
        File file(path);
        if (!file.source.begins_as_hdf5()) return false;
        file.file = h5::open_file(file.source, "");
        return h5::exists(file.file.get(), "format") && h5::read_text(file.file.get(), "format") == wear_format;
    } catch (const std::exception&) { // with too little memory for a text, too
        return false;
    }
}

WearRecording::WearRecording(const std::filesystem::path& path)
{
    h5::silence();
    try {
        file_ = std::make_unique<File>(path);
        file_->open();
    } catch (const FileError& error) {
        throw FileError(path.string() + ": " + error.what());
    } catch (const std::bad_alloc&) {
        throw FileError(path.string() + ": the memory does not suffice to read it.");
    }
}
WearRecording::~WearRecording() = default;
WearRecording::WearRecording(WearRecording&&) noexcept = default;

const WearRecord& WearRecording::record() const { return file_->record; }
double WearRecording::wall() const { return file_->wall; }
bool WearRecording::is_being_written() const { return file_->source.is_being_written() && !finished(); }
int WearRecording::frames() const { return static_cast<int>(file_->ledgers.size()); }
double WearRecording::time_of(int frame) const { return file_->ledgers[static_cast<std::size_t>(frame)].time; }

WearFrame WearRecording::frame(int index) const
{
    h5::silence();
    try {
        const h5::Handle frames = h5::open_group(file_->file.get(), "frames");
        const h5::Handle group = h5::open_group(frames.get(), frame_name(index));
        const auto cells = static_cast<hsize_t>(file_->record.layout.cells.size());
        const auto values = [&](const char* name) { return h5::read_floats(group.get(), name, cells); };
        const auto doubles = [&](const char* name) {
            const std::vector<float> read = values(name);
            return std::vector<double>(read.begin(), read.end());
        };
        WearFrame frame;
        frame.ledger = file_->ledgers[static_cast<std::size_t>(index)];
        frame.time = frame.ledger.time;
        frame.inside = doubles("inside");
        frame.outside = doubles("outside");
        frame.evaporated = doubles("evaporated");
        frame.temperature = values("temperature");
        frame.on_skin = doubles("on_skin");
        return frame;
    } catch (const FileError& error) {
        throw FileError(fmt::format("{}: frame {}: {}", file_->name, index, error.what()));
    }
}

} // namespace hygroloom
