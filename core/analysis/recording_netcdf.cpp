// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/recording_netcdf.h"

#include "core/analysis/cell_map.h"
#include "core/analysis/netcdf_file.h"
#include "core/analysis/series_keys.h"
#include "core/base/error.h"
#include "core/base/units.h"
#include "core/base/version.h"
#include "core/project/atomic_file.h"

#include <fstream>

namespace hygroloom {
namespace {

constexpr MapSide sides[] = {MapSide::top, MapSide::bottom, MapSide::total};

/// What does not change: where the segments lie, x, y and z of each, and what they are.
struct Segments {
    std::vector<std::int32_t> weft, top, end, pick;
    std::vector<float> places[3]; ///< mm

    explicit Segments(const Textile& textile)
    {
        const auto n = static_cast<std::size_t>(textile.segments());
        for (std::vector<std::int32_t>* numbers : {&weft, &top, &end, &pick}) numbers->resize(n);
        for (std::vector<float>& along : places) along.resize(n);
        for (const YarnKind kind : {YarnKind::warp, YarnKind::weft})
            for (int of_end = 0; of_end < textile.ends(); ++of_end)
                for (int of_pick = 0; of_pick < textile.picks(); ++of_pick) {
                    const auto i = static_cast<std::size_t>(textile.segment(kind, of_end, of_pick));
                    weft[i] = kind == YarnKind::weft;
                    top[i] = textile.warp_up(of_end, of_pick) == (kind == YarnKind::warp);
                    end[i] = of_end;
                    pick[i] = of_pick;
                    const double place[] = {textile.x_of_end(of_end), textile.y_of_pick(of_pick),
                                            textile.height_at_crossing(kind, of_end, of_pick)};
                    for (std::size_t k = 0; k < 3; ++k) places[k][i] = static_cast<float>(mm_from_metre(place[k]));
                }
    }
};

/// Of cells, mm from the sample's middle.
std::vector<double> middles(int cells, double cell, double sample)
{
    std::vector<double> places;
    for (int k = 0; k < cells; ++k) places.push_back(mm_from_metre((k + 0.5) * cell - 0.5 * sample));
    return places;
}

/// "water_free_kg" as "kg".
std::string unit_in(const std::string& key)
{
    const std::string last = key.substr(key.rfind('_') + 1);
    for (const auto& [ending, unit] :
         {std::pair{"kg", "kg"}, {"g", "g"}, {"s", "s"}, {"j", "J"}, {"mm", "mm"}, {"c", "degC"}, {"pct", "%"}})
        if (last == ending) return unit;
    return "1";
}

/// One after the other as they are described.
class File {
public:
    File(const Recording& recording, const Metrics& metrics, int crossings, std::ostream& to)
        : recording_(recording), run_(recording.run()), first_(recording.frame(0)), start_(start_of_maps(run_, first_)),
          map_(cell_map(run_.textile, first_, start_, MapSide::top, crossings)), crossings_(crossings),
          series_(values_of_all(metrics.series)), file_(to, "time", static_cast<std::size_t>(recording.frames()))
    {
    }

    void write(const std::function<bool(double)>& progress)
    {
        describe();
        put_places();
        for (int k = 0; k < recording_.frames(); ++k) {
            put_frame(k);
            if (!progress(static_cast<double>(k + 1) / recording_.frames())) throw Cancelled();
        }
    }

private:
    using Values = std::vector<std::pair<std::string, std::vector<double>>>;
    Values values_of_all(const Series& series) const
    {
        Values all;
        for (const SeriesKey& key : series_keys())
            if (std::vector<double> values = values_of(key, series);
                key.values != &Series::time && values.size() == static_cast<std::size_t>(recording_.frames()))
                all.emplace_back(key.key, std::move(values));
        return all;
    }
    void describe()
    {
        for (const auto& [name, text] : {std::pair<const char*, std::string>{"title", run_.fabric + ", " + run_.experiment},
                                         {"source", std::string("Hygroloom ") + program_version()},
                                         {"fabric", run_.fabric},
                                         {"experiment", run_.experiment},
                                         {"fidelity", name_of(run_.plan.fidelity)},
                                         {"backend", run_.backend},
                                         {"device", run_.device},
                                         {"date", run_.date}})
            file_.attribute(name, text);
        const int segment = file_.dimension("segment", static_cast<std::size_t>(run_.textile.segments())),
                  side = file_.dimension("side", 3), y = file_.dimension("y", static_cast<std::size_t>(map_.rows)),
                  x = file_.dimension("x", static_cast<std::size_t>(map_.columns));
        using enum NetcdfType;
        file_.variable("x", number, false, {x}, "mm", "along the weft");
        file_.variable("y", number, false, {y}, "mm", "along the warp");
        file_.variable("side", whole, false, {side}, "1", "0 top, 1 bottom, 2 both");
        file_.variable("weft", whole, false, {segment}, "1", "0 of the warp, 1 of the weft");
        file_.variable("top", whole, false, {segment}, "1", "1 where it lies on the upper face");
        file_.variable("end", whole, false, {segment}, "1");
        file_.variable("pick", whole, false, {segment}, "1");
        for (const char* name : {"x_mm", "y_mm", "z_mm"}) file_.variable(name, single, false, {segment}, "mm");
        file_.variable("time", number, true, {}, "s", "time");
        file_.variable("water_map", number, true, {side, y, x}, "g/m2", "water over the start");
        for (const FrameField& field : frame_fields) file_.variable(field.name, single, true, {segment}, field.unit);
        for (const auto& [key, values] : series_) file_.variable(key, number, true, {}, unit_in(key), title_of_series(key));
        for (const LedgerColumn& column : ledger_columns)
            if (column.value != &Ledger::time) file_.variable(column.name, number, true, {}, unit_in(column.name));
        file_.write_head();
    }
    void put_places()
    {
        const Segments segments(run_.textile);
        const std::int32_t numbers[] = {0, 1, 2};
        file_.put(std::span<const double>(middles(map_.columns, map_.cell_width, run_.textile.ends() * run_.textile.warp.pitch)));
        file_.put(std::span<const double>(middles(map_.rows, map_.cell_height, run_.textile.picks() * run_.textile.weft.pitch)));
        file_.put(std::span<const std::int32_t>(numbers));
        for (const auto* of : {&segments.weft, &segments.top, &segments.end, &segments.pick}) file_.put(std::span<const std::int32_t>(*of));
        for (const std::vector<float>& along : segments.places) file_.put(std::span<const float>(along));
    }
    void put_number(double value) { file_.put(std::span<const double>(&value, 1)); }
    void put_frame(int number)
    {
        const Frame frame = recording_.frame(number);
        put_number(frame.time);
        for (const MapSide side : sides) {
            std::vector<double> water = cell_map(run_.textile, frame, start_, side, crossings_).water;
            for (double& value : water) value *= 1e3; // g
            file_.put(std::span<const double>(water));
        }
        for (const FrameField& field : frame_fields) file_.put(std::span<const float>(field.in(frame)));
        for (const auto& [key, values] : series_) put_number(values[static_cast<std::size_t>(number)]);
        for (const LedgerColumn& column : ledger_columns)
            if (column.value != &Ledger::time) put_number(frame.ledger.*column.value);
    }

    const Recording& recording_;
    const RunRecord& run_;
    Frame first_, start_;
    CellMap map_;
    int crossings_;
    Values series_;
    NetcdfWriter file_;
};

} // namespace

void write_netcdf(const Recording& recording, const Metrics& metrics, int crossings_per_cell, const std::filesystem::path& path,
                  const std::function<bool(double)>& progress)
{
    write_file_with(path, [&](const std::filesystem::path& temporary) {
        std::ofstream to(temporary, std::ios::binary);
        File(recording, metrics, crossings_per_cell, to).write(progress);
        to.close();
        if (!to) throw FileError(path.string() + ": The file cannot be written.");
    });
}

} // namespace hygroloom
