// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/experiment_rows.h"

#include "core/analysis/report_inputs.h"
#include "core/project/project_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hygroloom {
namespace {

class ExperimentWriter {
public:
    explicit ExperimentWriter(const ReaderUnits& units) : units_(units) {}

    std::string number(double value, const std::string& unit) const
    {
        const ReaderUnit own = reader_unit(units_, unit);
        return fmt::format("{:.10g} {}", own.of(value), own.unit); // as it was given, which a reader's unit may make longer
    }
    std::string climate(const Climate& air) const
    {
        return fmt::format("{}, {:.10g} % relative humidity, air at {}", number(air.temperature_c, "°C"), 100 * air.relative_humidity,
                           number(air.air_speed_m_s, "m/s"));
    }
    /// "2 × 15 µl, at 0, 5 s"; other volumes follow.
    std::string drops(const std::vector<Droplet>& droplets) const
    {
        const ReaderUnit seconds = reader_unit(units_, "s");
        std::string text;
        for (std::size_t i = 0; i < droplets.size();) {
            std::size_t end = i;
            std::string times;
            for (; end < droplets.size() && droplets[end].volume_ul == droplets[i].volume_ul; ++end)
                times += fmt::format("{}{:.10g}", end > i ? ", " : "", seconds.of(droplets[end].time_s));
            text += fmt::format("{}{}{}, at {} {}", i > 0 ? "; " : "", end > i + 1 ? fmt::format("{} × ", end - i) : "",
                                number(droplets[i].volume_ul, "µl"), times, seconds.unit);
            i = end;
        }
        return text.empty() ? "none" : text;
    }
    std::string feed(const Experiment& e) const
    {
        std::string text = number(e.volume_ul, "µl");
        if (uses_field(e.type, "feed_s")) text += " in " + number(e.feed_s, "s");
        if (drops_of_feed(e) > 0) text += fmt::format(", in {} drops", drops_of_feed(e));
        return text;
    }

private:
    const ReaderUnits& units_;
};

/// How water comes to the cloth.
std::pair<std::string, std::string> supply_row(const Experiment& e, const ExperimentWriter& write)
{
    switch (info_of(e.type).source) {
    case WaterSource::drops: return {e.droplets.size() == 1 ? "drop" : "drops", write.drops(e.droplets)};
    case WaterSource::pool: return {"feed", write.feed(e)};
    case WaterSource::bath: return {"end in the liquid", write.number(e.immersion_mm, "mm")};
    case WaterSource::cloth: return {"water at the start", write.number(e.initial_water_g_m2, "g/m²")};
    case WaterSource::air: return {"climate before", write.climate(e.initial)};
    case WaterSource::face:
        return {e.from_top ? "feed of the top face" : "feed of the bottom face", write.number(e.rate_g_m2_h, "g/(m² h)")};
    }
    return {};
}

} // namespace

ExperimentRows experiment_rows(const RunRecord& run, const Experiment& e, const ReaderUnits& units)
{
    const ExperimentWriter write(units);
    const ExperimentTypeInfo& info = info_of(e.type);
    const std::string standard = info.standard, title = info.title;
    ExperimentRows rows{{"type", standard.empty() ? title : title + " (" + standard + ")"}};
    if (info.source != WaterSource::air) {
        std::string liquid = e.liquid;
        if (const Liquid* found = find_liquid(run.design, e.liquid))
            liquid += fmt::format(": {:.4g} mN/m, {:.4g} mPa s at 20 °C", found->surface_tension_mn_m, found->viscosity_mpa_s);
        rows.emplace_back("liquid", liquid);
    }
    rows.push_back(supply_row(e, write));
    rows.emplace_back("climate", write.climate(e.climate));
    for (const ClimateMoment& later : e.climates)
        rows.emplace_back("climate after " + write.number(later.time_s, "s"), write.climate(later.climate));
    const auto [across, along] = e.sample_mm;
    rows.emplace_back(is_strip(e.type) ? "strip" : "sample",
                      write.number(across, "mm") + " × " + write.number(along, "mm") +
                          (is_strip(e.type) ? e.along_weft ? ", along the weft" : ", along the warp" : ""));
    rows.emplace_back("duration", write.number(e.duration_s, "s"));
    rows.emplace_back("wicking model", std::string(name_of(e.closure)) + (e.swelling ? ", fibres swell" : ""));
    rows.emplace_back("fidelity", name_of(run.plan.fidelity));
    return rows;
}

ExperimentRows experiment_rows(const WornCandidate& worn, const ReaderUnits& units)
{
    ExperimentRows rows = inputs_in_words(json_from_design(worn.used).at("experiments").at(0), units);
    rows.emplace_back("fidelity and backend", worn.how);
    return rows;
}

} // namespace hygroloom
