// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Recordings of worn garments for Python.
#include "app/python/arrays.h"
#include "app/python/bindings.h"
#include "app/python/unlocked.h"

#include "core/wear/wear_recording.h"

#include <fmt/format.h>

#include <mutex>

namespace hygroloom::python {
namespace {

/// One thread reads at a time, without Python's lock.
struct SharedWearRecording {
    explicit SharedWearRecording(const std::string& path) : name(path), recording(path)
    {
        if (recording.frames() == 0) throw FileError(path + ": The recording has no frames.");
    }
    std::string name;
    std::mutex mutex;
    WearRecording recording;
};

py::dict frame_of(SharedWearRecording& shared, int index)
{
    if (index < 0 || index >= shared.recording.frames())
        throw py::index_error(
            fmt::format("{}: There is no frame {}; the recording has {}.", shared.name, index, shared.recording.frames()));
    WearFrame frame;
    {
        const Unlocked no_python;
        const std::lock_guard lock(shared.mutex);
        frame = shared.recording.frame(index);
    }
    py::dict values;
    values["inside"] = array_of(std::move(frame.inside));
    values["outside"] = array_of(std::move(frame.outside));
    values["evaporated"] = array_of(std::move(frame.evaporated));
    values["temperature"] = array_of(std::move(frame.temperature));
    values["on_skin"] = array_of(std::move(frame.on_skin));
    return values;
}

/// Of each cell: numbers of its panel and zone, its middle flat and in space, area and capacity; SI.
py::dict cells_of(const SharedWearRecording& shared)
{
    std::vector<std::int32_t> panel, zone;
    std::vector<std::array<double, 2>> flat;
    std::vector<std::array<double, 3>> place;
    std::vector<double> area, capacity;
    for (const GarmentCell& cell : shared.recording.record().layout.cells) {
        panel.push_back(cell.panel);
        zone.push_back(cell.zone);
        flat.push_back({cell.flat[0], cell.flat[1]});
        place.push_back({cell.place.x, cell.place.y, cell.place.z});
        area.push_back(cell.area);
        capacity.push_back(cell.capacity);
    }
    py::dict cells;
    cells["panel"] = array_of(std::move(panel));
    cells["zone"] = array_of(std::move(zone));
    cells["flat"] = array_of(std::move(flat));
    cells["place"] = array_of(std::move(place));
    cells["area"] = array_of(std::move(area));
    cells["capacity"] = array_of(std::move(capacity));
    return cells;
}

py::dict about(const SharedWearRecording& shared)
{
    const WearRecord& record = shared.recording.record();
    py::list panels, fabrics, zones;
    for (const WearPanel& panel : record.layout.panels) {
        panels.append(text(panel.name));
        fabrics.append(text(panel.fabric));
    }
    for (const std::string& zone : record.layout.zone_names()) zones.append(text(zone));
    std::vector<double> times;
    times.reserve(static_cast<std::size_t>(shared.recording.frames()));
    for (int k = 0; k < shared.recording.frames(); ++k) times.push_back(shared.recording.time_of(k));
    py::dict all;
    all["garment"] = text(record.layout.garment);
    all["experiment"] = text(record.layout.experiment);
    all["type"] = "wear";
    all["fidelity"] = text(record.fidelity);
    all["backend"] = text(record.backend);
    all["device"] = text(record.device);
    all["date"] = text(record.date);
    all["wall_s"] = shared.recording.wall();
    all["finished"] = shared.recording.finished();
    all["panels"] = panels;
    all["fabrics"] = fabrics;
    all["zones"] = zones;
    all["frames"] = shared.recording.frames();
    all["times"] = array_of(std::move(times));
    return all;
}

} // namespace

void add_wear_recordings(py::module_& module)
{
    py::class_<SharedWearRecording>(module, "WearRecording")
        .def(py::init([](const std::string& path) {
            const Unlocked no_python;
            return std::make_unique<SharedWearRecording>(path);
        }))
        .def("about", &about)
        .def("design", [](const SharedWearRecording& shared) { return shared.recording.record().design; })
        .def("cells", &cells_of)
        .def("frame", &frame_of);
    module.def("is_wear_recording", [](const std::string& path) { return WearRecording::is_one(path); });
}

} // namespace hygroloom::python
