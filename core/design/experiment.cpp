// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/experiment.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

using Table = std::array<ExperimentTypeInfo, experiment_types>;

Experiment usual(const Climate& climate, const char* liquid, std::array<double, 2> sample_mm, double duration_s, double volume_ul = 200)
{
    Experiment e;
    e.climate = climate;
    e.liquid = liquid;
    e.sample_mm = sample_mm;
    e.duration_s = duration_s;
    e.volume_ul = volume_ul;
    return e;
}

/// In the order of ExperimentType.
Table make_table()
{
    Experiment tester = usual({21, 0.65, 0}, "saline", {80, 80}, 120);
    tester.drop_ul = hanging_drop_ul;
    return {{{.key = "droplet",
              .title = "Droplets",
              .standard = "AATCC 79",
              .source = WaterSource::drops,
              .usual = {},
              .fields = {"droplets"},
              .has_usual_duration = false},
             {.key = "moisture_management",
              .title = "Moisture management",
              .standard = "AATCC 195",
              .source = WaterSource::pool,
              .usual = tester,
              .fields = {"feed_s", "drop_ul", "volume_ul"}},
             {.key = "vertical_wicking",
              .title = "Vertical wicking",
              .standard = "AATCC 197",
              .source = WaterSource::bath,
              .usual = usual({21, 0.65, 0.1}, "water", {25, 150}, 600),
              .fields = {"direction", "immersion_mm"},
              .sample_key = "strip_mm"},
             {.key = "horizontal_wicking",
              .title = "Horizontal wicking",
              .standard = "AATCC 198",
              .source = WaterSource::pool,
              .usual = usual({21, 0.65, 0.1}, "water", {100, 100}, 300, 1000),
              .fields = {"volume_ul"}},
             {.key = "drying",
              .title = "Drying",
              .standard = "AATCC 199, 201",
              .source = WaterSource::cloth,
              .usual = usual({21, 0.65, 1}, "water", {50, 50}, 3600),
              .fields = {"initial_water_g_m2"}},
             {.key = "conditioning",
              .title = "Conditioning",
              .standard = "ISO 139",
              .source = WaterSource::air,
              .usual = usual({20, 0.65, 0.1}, "water", {50, 50}, 3600),
              .fields = {"initial"}},
             {.key = "sweat",
              .title = "Sweat",
              .standard = "",
              .source = WaterSource::face,
              .usual = usual({25, 0.5, 0.5}, "sweat", {50, 50}, 600),
              .fields = {"rate_g_m2_h", "side"}}}};
}

WaterSource source_of(ExperimentType type) { return info_of(type).source; }

} // namespace

const ExperimentTypeInfo& info_of(ExperimentType type)
{
    static const Table table = make_table();
    return table[static_cast<std::size_t>(type)];
}

bool uses_field(ExperimentType type, std::string_view key)
{
    const auto& fields = info_of(type).fields;
    return std::any_of(fields.begin(), fields.end(), [&](const char* field) { return field == key; });
}

bool wets_a_spot(ExperimentType type) { return source_of(type) == WaterSource::drops || source_of(type) == WaterSource::pool; }
bool stays_uniform(ExperimentType type) { return source_of(type) == WaterSource::cloth || source_of(type) == WaterSource::air; }
bool changes_everywhere(ExperimentType type) { return stays_uniform(type) || source_of(type) == WaterSource::face; }
bool starts_wet(ExperimentType type) { return source_of(type) == WaterSource::cloth; }
bool is_strip(ExperimentType type) { return source_of(type) == WaterSource::bath; }

const char* name_of(Closure closure)
{
    constexpr const char* names[] = {"paper", "pores"};
    return names[static_cast<int>(closure)];
}

Experiment standard_experiment(ExperimentType type)
{
    Experiment e = info_of(type).usual;
    e.type = type;
    if (!uses_field(type, "droplets")) e.droplets.clear();
    return e;
}

std::array<double, 2> sample_extent_mm(const Experiment& experiment)
{
    const auto [across, along] = experiment.sample_mm;
    if (is_strip(experiment.type) && experiment.along_weft) return {along, across};
    return {across, along};
}

std::vector<Droplet> falling_drops(const Experiment& experiment)
{
    return uses_field(experiment.type, "droplets") ? experiment.droplets : std::vector<Droplet>{};
}

int drops_of_feed(const Experiment& experiment)
{
    if (!uses_field(experiment.type, "drop_ul") || !(experiment.drop_ul > 0)) return 0;
    return static_cast<int>(std::ceil(experiment.volume_ul / experiment.drop_ul * (1 - 1e-12))); // 0.3 / 0.1 is three
}

Climate climate_at(const Experiment& experiment, double time_s)
{
    ClimateMoment before{0, experiment.climate};
    for (const ClimateMoment& after : experiment.climates) {
        if (time_s < after.time_s) {
            const double share = (time_s - before.time_s) / (after.time_s - before.time_s);
            const auto between = [&](double Climate::*value) {
                return before.climate.*value + share * (after.climate.*value - before.climate.*value);
            };
            return {between(&Climate::temperature_c), between(&Climate::relative_humidity), between(&Climate::air_speed_m_s)};
        }
        before = after;
    }
    return before.climate;
}

} // namespace hygroloom
