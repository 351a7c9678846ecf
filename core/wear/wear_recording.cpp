// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/wear/wear_recording.h"

#include "core/base/error.h"
#include "core/base/utf8.h"
#include "core/project/project_file.h"
#include "core/run/recording_layout.h"
#include "core/run/run_file.h"
#include "core/wear/wear_layout_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

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

constexpr const char* frame_columns[] = {"inside", "outside", "evaporated", "temperature", "on_skin"};

void write_field(RunFileWriter& file, const std::string& name, const std::vector<float>& values, const char* unit)
{
    file.field(name, std::span<const float>(values), unit);
}

void write_shape(RunFileWriter& file, const GarmentShape& shape)
{
    std::vector<float> places, flat, corners;
    for (std::size_t i = 0; i < shape.places.size(); ++i) {
        for (double value : {shape.places[i].x, shape.places[i].y, shape.places[i].z}) places.push_back(static_cast<float>(value));
        for (double value : shape.flat[i]) flat.push_back(static_cast<float>(value));
    }
    for (std::size_t t = 0; t < shape.triangles.size(); ++t) {
        for (int corner : shape.triangles[t]) corners.push_back(static_cast<float>(corner));
        corners.push_back(static_cast<float>(shape.panel[t]));
    }
    file.number("shape/vertices", static_cast<double>(shape.places.size()));
    file.number("shape/triangles", static_cast<double>(shape.triangles.size()));
    write_field(file, "shape/places", places, "m");
    write_field(file, "shape/flat", flat, "m");
    write_field(file, "shape/corners", corners, "1");
}

/// Throws FileError where the shape takes more memory than 120 MB and three times the file: what is packed may claim to be any size.
GarmentShape read_shape(const RunFileReader& file, std::size_t panels)
{
    const long vertices = file.count("shape/vertices", 0, most_vertices), triangles = file.count("shape/triangles", 0, most_vertices);
    constexpr std::uint64_t base_bytes = 120'000'000;
    GarmentShape shape;
    const std::uint64_t bytes = static_cast<std::uint64_t>(vertices) * (sizeof shape.places[0] + sizeof shape.flat[0]) +
                                static_cast<std::uint64_t>(triangles) * (sizeof shape.triangles[0] + 5 * sizeof shape.panel[0]);
    if (bytes > base_bytes + 3 * file.size())
        throw FileError(
            fmt::format("its shape of {} vertices and {} triangles is too large for the file; it is damaged.", vertices, triangles));
    const std::vector<float> places = file.floats("shape/places", static_cast<std::size_t>(3 * vertices)),
                             flat = file.floats("shape/flat", static_cast<std::size_t>(2 * vertices)),
                             corners = file.floats("shape/corners", static_cast<std::size_t>(4 * triangles));
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

std::vector<GarmentCell> read_cells(const RunFileReader& file, const WearLayout& layout)
{
    const std::size_t zones = body_zones().size() + layout.own_zones.size();
    const auto count = static_cast<std::size_t>(file.count("cells/count", 1, most_layout_cells));
    std::vector<GarmentCell> cells;
    for (const CellColumn& column : cell_columns) {
        const std::vector<float> values = file.floats(std::string("cells/") + column.name, count);
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
    RunFileWriter file;
};

WearWriter::WearWriter(const std::filesystem::path& path, const WearRecord& record)
{
    std::vector<RunColumn> columns;
    for (const char* name : frame_columns) columns.push_back({name, name == std::string_view("temperature") ? "K" : "kg"});
    file_.reset(new File{{path, wear_format, columns}});
    RunFileWriter& file = file_->file;
    file.text("design", format_project(record.design));
    file.text("layout", layout_json(record.layout));
    for (const auto& [name, value] :
         {std::pair{"fidelity", record.fidelity}, {"backend", record.backend}, {"device", record.device}, {"date", record.date}})
        file.text(std::string("provenance/") + name, value);
    file.text("provenance/answers", record.answers);
    file.number("cells/count", static_cast<double>(record.layout.cells.size()));
    for (const CellColumn& column : cell_columns) {
        std::vector<float> values;
        for (const GarmentCell& cell : record.layout.cells) values.push_back(static_cast<float>(column.of(cell)));
        write_field(file, std::string("cells/") + column.name, values, column.unit);
    }
    write_shape(file, record.layout.shape);
}

WearWriter::~WearWriter() = default;

void WearWriter::append(const WearFrame& frame)
{
    file_->file.append(frame.time, frame.ledger, [&](RunRow& row) {
        const auto put = [&](const char* name, const auto& values) {
            row.field(name, std::span<const float>(std::vector<float>(values.begin(), values.end())));
        };
        put("inside", frame.inside);
        put("outside", frame.outside);
        put("evaporated", frame.evaporated);
        put("temperature", frame.temperature);
        put("on_skin", frame.on_skin);
    });
}

void WearWriter::note_device(const std::string& device) { file_->file.text("provenance/all_devices", device); }

void WearWriter::finish(double wall)
{
    file_->file.finish(wall);
    file_.reset();
}

struct WearRecording::File {
    explicit File(const std::filesystem::path& path) : name(path.string()), file(path) {}
    std::string name;
    RunFileReader file;
    WearRecord record;
    double wall = 0;
    std::vector<StoredFrame> frames;

    void read()
    {
        if (file.text("format") != wear_format) throw FileError("this is not the recording of a worn garment.");
        record.design = parse_project(file.text("design"), "the recording's design");
        record.layout = layout_from(file.text("layout"), "the recording's layout");
        for (const auto& [name_of, text] :
             {std::pair{"fidelity", &record.fidelity}, {"backend", &record.backend}, {"device", &record.device}, {"date", &record.date}})
            *text = in_one_line(file.text(std::string("provenance/") + name_of));
        record.answers = file.has("provenance/answers") ? file.text("provenance/answers") : std::string();
        if (file.has("provenance/all_devices")) record.device = in_one_line(file.text("provenance/all_devices"));
        record.layout.cells = read_cells(file, record.layout);
        record.layout.shape = read_shape(file, record.layout.panels.size());
        if (file.has("wall_s")) wall = file.number("wall_s");
        frames = file.frames([](std::int64_t, const std::string&) {}); // of what is wrong with a frame the others are shown
        if (frames.empty()) throw FileError("it has no frame.");
        file.release();
    }
};

bool WearRecording::is_one(const std::filesystem::path& path)
{
    try {
        return RunFileReader(path).text("format") == wear_format;
    } catch (const std::exception&) { // with too little memory for a text, too
        return false;
    }
}

WearRecording::WearRecording(const std::filesystem::path& path)
{
    try {
        file_ = std::make_unique<File>(path);
        file_->read();
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
bool WearRecording::is_being_written() const { return file_->file.is_being_written() && !finished(); }
int WearRecording::frames() const { return static_cast<int>(file_->frames.size()); }
double WearRecording::time_of(int frame) const { return file_->frames[static_cast<std::size_t>(frame)].time; }

WearFrame WearRecording::frame(int index) const
{
    const StoredFrame& stored = file_->frames[static_cast<std::size_t>(index)];
    try {
        const StoredRow row = file_->file.row(stored.number, {std::begin(frame_columns), std::end(frame_columns)});
        const auto values = [&](const char* name) { return row.floats(name, file_->record.layout.cells.size()); };
        const auto doubles = [&](const char* name) {
            const std::vector<float> read = values(name);
            return std::vector<double>(read.begin(), read.end());
        };
        WearFrame frame;
        frame.ledger = stored.ledger;
        frame.time = stored.time;
        frame.inside = doubles("inside");
        frame.outside = doubles("outside");
        frame.evaporated = doubles("evaporated");
        frame.temperature = values("temperature");
        frame.on_skin = doubles("on_skin");
        return frame;
    } catch (const FileError& error) {
        throw FileError(fmt::format("{}: frame {}: {}", file_->name, stored.number, error.what()));
    }
}

} // namespace hygroloom
