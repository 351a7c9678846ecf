// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Recordings for Python: a frame is read when it is asked for, and its values become numpy arrays without a copy.
#include "app/python/arrays.h"
#include "app/python/bindings.h"
#include "app/python/unlocked.h"

#include "core/analysis/cell_map.h"
#include "core/analysis/series_keys.h"
#include "core/run/recording.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <cmath>
#include <limits>
#include <mutex>
#include <optional>

namespace hygroloom::python {
namespace {

/// One thread reads at a time, without Python's lock.
class SharedRecording {
public:
    explicit SharedRecording(const std::string& path) : name_(path), recording_(path)
    {
        if (recording_.frames() == 0) throw FileError(path + ": The recording has no frames.");
    }

    const Recording& about() const { return recording_; } ///< what opening it told

    Frame frame(int index, const std::vector<FrameField>& fields)
    {
        const std::lock_guard lock(mutex_);
        require(index);
        return recording_.frame(index, fields);
    }

    CellMap map(int index, MapSide side, int crossings_per_cell)
    {
        const std::lock_guard lock(mutex_);
        require(index);
        const RunRecord& run = recording_.run();
        if (!start_) start_ = start_of_maps(run, recording_.frame(0));
        return cell_map(run.textile, recording_.frame(index), *start_, side, crossings_per_cell);
    }

    /// Of all frames; those that cannot be read are left out, and named.
    struct Measured {
        Series series;
        std::vector<int> frames; ///< that the series are of
        std::vector<std::string> problems;
    };
    Measured measured()
    {
        const std::lock_guard lock(mutex_);
        MetricsCollector collector;
        collector.start(recording_.run());
        Measured result;
        for (int k = 0; k < recording_.frames(); ++k) {
            try {
                collector.add(recording_.frame(k));
                result.frames.push_back(k);
            } catch (const FileError& error) {
                result.problems.emplace_back(error.what());
            }
        }
        result.series = collector.metrics().series;
        return result;
    }

private:
    void require(int index) const
    {
        if (index < 0 || index >= recording_.frames())
            throw py::index_error(fmt::format("{}: There is no frame {}; the recording has {}.", name_, index, recording_.frames()));
    }

    std::string name_;
    std::mutex mutex_;
    Recording recording_;
    std::optional<Frame> start_;
};

std::vector<FrameField> fields_named(const std::vector<std::string>& names)
{
    std::vector<FrameField> fields;
    for (const std::string& name : names) {
        const auto found =
            std::find_if(std::begin(frame_fields), std::end(frame_fields), [&](const FrameField& f) { return f.name == name; });
        if (found == std::end(frame_fields)) throw Error(fmt::format("A frame has no field \"{}\".", name));
        fields.push_back(*found);
    }
    return fields;
}

py::array caps_of(const std::vector<FrameCap>& caps)
{
    std::vector<std::array<double, 6>> rows;
    rows.reserve(caps.size());
    for (const FrameCap& cap : caps) rows.push_back({cap.x, cap.y, cap.face, cap.base, cap.height, cap.volume});
    return array_of(std::move(rows));
}

py::dict frame_of(SharedRecording& recording, int index, const std::vector<std::string>& names)
{
    const std::vector<FrameField> fields = fields_named(names);
    Frame frame;
    {
        const Unlocked no_python;
        frame = recording.frame(index, fields);
    }
    py::dict values;
    for (const FrameField& field : fields) values[field.name] = array_of(std::move(field.in(frame)));
    values["time"] = frame.time;
    values["water_top"] = frame.water_top;
    values["water_bottom"] = frame.water_bottom;
    values["particle_position"] = array_of(std::move(frame.positions));
    values["particle_velocity"] = array_of(std::move(frame.velocities));
    values["caps"] = caps_of(frame.caps);
    return values;
}

/// kg/m2; the first row at the bottom.
py::array map_of(SharedRecording& recording, int index, const std::string& side, int crossings_per_cell)
{
    CellMap map;
    {
        const Unlocked no_python;
        map = recording.map(index, map_side_from_name(side), crossings_per_cell);
    }
    return array_of(std::move(map.water), {map.rows, map.columns});
}

/// Those that the run's type of experiment has.
std::vector<SeriesKey> keys_of(const SharedRecording& recording)
{
    const RunRecord& run = recording.about().run();
    const ExperimentType type = find_experiment(run.design, run.experiment)->type;
    std::vector<SeriesKey> keys;
    for (const SeriesKey& key : series_keys())
        if (key.of_all || (key.values == &Series::wick_height ? is_strip(type) : type == ExperimentType::moisture_management))
            keys.push_back(key);
    return keys;
}

/// Pairs of key and title.
py::list series_titles(const SharedRecording& recording)
{
    py::list titles;
    for (const SeriesKey& key : keys_of(recording)) titles.append(py::make_tuple(key.key, text(title_of_series(key.key))));
    return titles;
}

/// Each by its key, NaN where a frame cannot be read; and which those are.
py::tuple series_of(SharedRecording& recording)
{
    SharedRecording::Measured measured;
    {
        const Unlocked no_python;
        measured = recording.measured();
    }
    py::dict series;
    for (const SeriesKey& key : keys_of(recording)) {
        const std::vector<double> values = values_of(key, measured.series);
        std::vector<double> all(static_cast<std::size_t>(recording.about().frames()), std::numeric_limits<double>::quiet_NaN());
        for (std::size_t k = 0; k < values.size(); ++k) all[static_cast<std::size_t>(measured.frames[k])] = values[k];
        series[key.key] = array_of(std::move(all));
    }
    py::list problems;
    for (const std::string& problem : measured.problems) problems.append(text(problem));
    return py::make_tuple(series, problems);
}

/// A row per frame.
py::dict ledger_of(const SharedRecording& recording)
{
    py::dict ledger;
    for (const LedgerColumn& column : ledger_columns) {
        std::vector<double> values;
        for (const Ledger& of : recording.about().ledgers()) values.push_back(of.*column.value);
        ledger[column.name] = array_of(std::move(values));
    }
    return ledger;
}

/// Of each segment: system (0 warp, 1 weft), end, pick, and its middle, m.
py::dict segments_of(const SharedRecording& recording)
{
    const Textile& textile = recording.about().run().textile;
    const auto n = static_cast<std::size_t>(textile.segments());
    std::vector<std::uint8_t> system(n), top(n);
    std::vector<std::int32_t> ends(n), picks(n);
    std::vector<std::array<double, 3>> middles(n);
    for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
        for (int end = 0; end < textile.ends(); ++end)
            for (int pick = 0; pick < textile.picks(); ++pick) {
                const auto i = static_cast<std::size_t>(textile.segment(kind, end, pick));
                system[i] = kind == YarnKind::weft;
                top[i] = textile.warp_up(end, pick) == (kind == YarnKind::warp);
                ends[i] = end;
                picks[i] = pick;
                middles[i] = {textile.x_of_end(end), textile.y_of_pick(pick), textile.height_at_crossing(kind, end, pick)};
            }
    py::dict segments;
    segments["system"] = array_of(std::move(system));
    segments["top"] = array_of(std::move(top));
    segments["end"] = array_of(std::move(ends));
    segments["pick"] = array_of(std::move(picks));
    segments["middle"] = array_of(std::move(middles));
    return segments;
}

py::dict about(const SharedRecording& recording)
{
    const Recording& file = recording.about();
    const RunRecord& run = file.run();
    py::dict all;
    all["fabric"] = text(run.fabric);
    all["experiment"] = text(run.experiment);
    all["type"] = name_of(find_experiment(run.design, run.experiment)->type);
    all["fidelity"] = name_of(run.plan.fidelity);
    all["backend"] = text(run.backend);
    all["device"] = text(run.device);
    all["seed"] = run.seed;
    all["date"] = text(run.date);
    all["wall_s"] = run.wall;
    all["finished"] = file.finished();
    all["ends"] = run.textile.ends();
    all["picks"] = run.textile.picks();
    all["yarns_per_cell"] = run.textile.yarns_per_cell();
    all["end_pitch_mm"] = 1e3 * run.textile.warp.pitch;
    all["pick_pitch_mm"] = 1e3 * run.textile.weft.pitch;
    all["frames"] = file.frames();
    py::list problems;
    for (const std::string& problem : file.problems()) problems.append(text(problem));
    all["problems"] = problems;
    return all;
}

/// Pairs of name and unit.
py::list field_list()
{
    py::list fields;
    for (const FrameField& field : frame_fields) fields.append(py::make_tuple(field.name, field.unit));
    return fields;
}

} // namespace

void add_recordings(py::module_& module)
{
    py::class_<SharedRecording>(module, "Recording")
        .def(py::init([](const std::string& path) {
            const Unlocked no_python;
            return std::make_unique<SharedRecording>(path);
        }))
        .def("about", &about)
        .def("design", [](const SharedRecording& recording) { return recording.about().run().design; })
        .def("segments", &segments_of)
        .def("ledger", &ledger_of)
        .def("frame", &frame_of)
        .def("map", &map_of)
        .def("series", &series_of)
        .def("series_titles", &series_titles);
    module.def("frame_fields", &field_list);
}

} // namespace hygroloom::python
