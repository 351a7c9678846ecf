// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/series_keys.h"

#include "core/analysis/plots.h"
#include "core/base/units.h"

namespace hygroloom {

const std::vector<SeriesKey>& series_keys()
{
    constexpr double mm = 1e3, gram = 1e3;
    static const std::vector<SeriesKey> keys{{"time_s", &Series::time},
                                             {"wetted_radius_top_mm", &Series::radius_top, mm},
                                             {"wetted_radius_bottom_mm", &Series::radius_bottom, mm},
                                             {"water_top_g", &Series::water_top, gram},
                                             {"water_bottom_g", &Series::water_bottom, gram},
                                             {"free_water_g", &Series::free_water, gram},
                                             {"yarn_water_g", &Series::yarn_water, gram},
                                             {"bound_water_g", &Series::bound_water, gram},
                                             {"evaporated_g", &Series::evaporated, gram},
                                             {"dripped_g", &Series::dripped, gram},
                                             {"temperature_mean_c", &Series::temperature_mean, 1, -zero_celsius},
                                             {"temperature_min_c", &Series::temperature_min, 1, -zero_celsius},
                                             {"temperature_max_c", &Series::temperature_max, 1, -zero_celsius},
                                             {"regain_mean", &Series::regain_mean},
                                             {"air_temperature_c", &Series::air_temperature, 1, -zero_celsius},
                                             {"wick_height_mm", &Series::wick_height, mm, 0, false},
                                             {"water_content_top_pct", &Series::content_top, 1, 0, false},
                                             {"water_content_bottom_pct", &Series::content_bottom, 1, 0, false}};
    return keys;
}

std::string title_of_series(const std::string& key)
{
    for (const SeriesKey& series : series_keys()) {
        if (series.key != key) continue;
        for (const Plot& plot : all_plots())
            for (const Curve& curve : plot.curves)
                if (curve.values == series.values)
                    return plot.curves.size() == 1 ? plot.title : std::string(plot.title) + ", " + curve.name;
    }
    return key;
}

std::vector<double> values_of(const SeriesKey& of, const Series& series)
{
    std::vector<double> values = series.*of.values;
    for (double& value : values) value = value * of.factor + of.offset;
    return values;
}

} // namespace hygroloom
