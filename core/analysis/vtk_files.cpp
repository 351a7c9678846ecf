// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/vtk_files.h"

#include "core/analysis/poly_data.h"
#include "core/base/error.h"
#include "core/base/units.h"
#include "core/project/atomic_file.h"
#include "core/scene/liquid_points.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>

namespace hygroloom {
namespace {

/// What stays the same in all frames: each segment is a line from half-way to the crossing before, over its own, half-way to the next.
struct Lines {
    std::vector<float> points; ///< mm
    std::vector<std::int32_t> connectivity, offsets, segment, end, pick;
    std::vector<std::uint8_t> warp, top;
    std::vector<float> per_dry; ///< 1/kg, of a segment's dry fibre

    explicit Lines(const Textile& textile)
    {
        for (const YarnKind kind : {YarnKind::warp, YarnKind::weft}) {
            const bool is_warp = kind == YarnKind::warp;
            const int yarns = is_warp ? textile.ends() : textile.picks(), crossings = is_warp ? textile.picks() : textile.ends();
            for (int yarn = 0; yarn < yarns; ++yarn) {
                add_point(textile, kind, yarn, 0, -0.5);
                for (int at = 0; at < crossings; ++at) add(textile, kind, is_warp ? yarn : at, is_warp ? at : yarn);
            }
        }
    }
    std::size_t point_count() const { return points.size() / 3; }

private:
    void add_point(const Textile& textile, YarnKind kind, int yarn, int at, double offset)
    {
        const Vec3d centre = yarn_point(textile, kind, yarn, at, offset).centre;
        for (const double place : {centre.x, centre.y, centre.z}) points.push_back(static_cast<float>(mm_from_metre(place)));
    }
    void add(const Textile& textile, YarnKind kind, int of_end, int of_pick)
    {
        const bool is_warp = kind == YarnKind::warp;
        const int yarn = is_warp ? of_end : of_pick, at = is_warp ? of_pick : of_end;
        const auto before = static_cast<std::int32_t>(point_count() - 1);
        add_point(textile, kind, yarn, at, 0);
        add_point(textile, kind, yarn, at, 0.5);
        for (std::int32_t k = 0; k < 3; ++k) connectivity.push_back(before + k);
        offsets.push_back(static_cast<std::int32_t>(connectivity.size()));
        segment.push_back(textile.segment(kind, of_end, of_pick));
        end.push_back(of_end);
        pick.push_back(of_pick);
        warp.push_back(is_warp);
        top.push_back(textile.warp_up(of_end, of_pick) == is_warp);
        const YarnType& type = textile.type(kind, yarn);
        per_dry.push_back(
            static_cast<float>(1 / (type.area * type.packing * type.fibre.density_kg_m3 * textile.segment_length(kind, of_end, of_pick))));
    }
};

void write_yarns(const Lines& lines, const Frame& frame, const std::filesystem::path& path)
{
    const std::size_t n = frame.saturation.size();
    std::vector<float> content(n), vapour(n), temperature(n);
    for (std::size_t i = 0; i < n; ++i) {
        content[i] = frame.regain[i] + frame.liquid[i] * lines.per_dry[i];
        vapour[i] = 1e3f * frame.vapour[i];
        temperature[i] = static_cast<float>(celsius_from_kelvin(static_cast<double>(frame.temperature[i])));
    }
    PolyData file;
    file.begin("CellData");
    file.add("saturation", frame.saturation);
    file.add("water_content_kg_kg", content);
    file.add("regain_kg_kg", frame.regain);
    file.add("vapour_g_m3", vapour);
    file.add("temperature_c", temperature);
    file.add("top", lines.top);
    file.add("warp", lines.warp);
    file.add("end", lines.end);
    file.add("pick", lines.pick);
    file.add("segment", lines.segment);
    file.end("CellData");
    file.begin("Points");
    file.add("Points", lines.points, 3);
    file.end("Points");
    file.begin("Lines");
    file.add("connectivity", lines.connectivity);
    file.add("offsets", lines.offsets);
    file.end("Lines");
    file.write(path, frame.time, {lines.point_count(), 0, n, 0});
}

void write_liquid(const Frame& frame, const std::filesystem::path& path)
{
    const std::vector<std::array<float, 3>> places = liquid_points(frame);
    const std::size_t n = places.size();
    std::vector<float> points, velocity;
    std::vector<std::int32_t> connectivity, offsets;
    for (std::size_t i = 0; i < n; ++i) {
        for (const float place : places[i]) points.push_back(1e3f * place);
        const std::array<float, 3> goes = frame.caps.empty() ? frame.velocities[i] : std::array<float, 3>{}; // caps stand
        velocity.insert(velocity.end(), goes.begin(), goes.end());
        connectivity.push_back(static_cast<std::int32_t>(i));
        offsets.push_back(static_cast<std::int32_t>(i + 1));
    }
    PolyData file;
    file.begin("PointData");
    file.add("velocity_m_s", velocity, 3);
    file.end("PointData");
    file.begin("Points");
    file.add("Points", points, 3);
    file.end("Points");
    file.begin("Verts");
    file.add("connectivity", connectivity);
    file.add("offsets", offsets);
    file.end("Verts");
    file.write(path, frame.time, {n, n, 0, 0});
}

/// Names a time's file, as two programs' ways of telling times ask for it.
class Index {
public:
    explicit Index(std::string name) : name_(std::move(name)) {}
    std::string add(double exact)
    {
        const double time = std::stod(fmt::format("{:.12g}", exact)); // times are sums of steps
        const std::string file = fmt::format("{}_{:06}.vtp", name_, files_.size());
        text_ += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", time, file);
        files_.push_back({{"name", file}, {"time", time}});
        return file;
    }
    /// Of a recording that was written to the folder before.
    void remove_older(const std::filesystem::path& folder) const
    {
        std::error_code failed;
        for (const char* ending : {".pvd", ".vtp.series"})
            if (std::filesystem::remove(folder / (name_ + ending), failed); failed)
                throw FileError((folder / (name_ + ending)).string() + ": The file cannot be removed: " + failed.message() + ".");
    }
    void write(const std::filesystem::path& folder) const
    {
        write_file(folder / (name_ + ".pvd"), "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\">\n<Collection>\n" +
                                                  text_ + "</Collection>\n</VTKFile>\n");
        write_file(folder / (name_ + ".vtp.series"),
                   nlohmann::ordered_json{{"file-series-version", "1.0"}, {"files", files_}}.dump(1) + "\n");
    }

private:
    std::string name_, text_;
    std::vector<nlohmann::ordered_json> files_;
};

} // namespace

int write_vtk(const Recording& recording, const std::filesystem::path& folder, int every, const std::function<bool(double)>& progress)
{
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed) throw FileError(folder.string() + ": The folder cannot be made: " + failed.message() + ".");
    const std::vector<Ledger>& ledgers = recording.ledgers();
    const bool has_liquid = std::any_of(ledgers.begin(), ledgers.end(), [](const Ledger& ledger) { return ledger.water_free > 0; });
    const Lines lines(recording.run().textile);
    Index yarns("yarns"), liquid("liquid");
    yarns.remove_older(folder);
    liquid.remove_older(folder);
    int written = 0;
    const int last = recording.frames() - 1;
    for (int i = 0; i <= last; i = i < last ? std::min(i + every, last) : i + 1) {
        if (!progress(static_cast<double>(i) / recording.frames())) throw Cancelled();
        const Frame frame = recording.frame(i);
        write_yarns(lines, frame, folder / yarns.add(frame.time));
        if (has_liquid) write_liquid(frame, folder / liquid.add(frame.time));
        ++written;
    }
    yarns.write(folder);
    if (has_liquid) liquid.write(folder);
    return written;
}

} // namespace hygroloom
