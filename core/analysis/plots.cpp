// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/plots.h"

#include "core/base/units.h"

namespace hygroloom {
const std::vector<Plot>& all_plots()
{
    using S = Series;
    constexpr double mm = 1e3, mg = 1e6;
    static const std::vector<Plot> plots{{"Wetted radius", "mm", {{"top", &S::radius_top}, {"bottom", &S::radius_bottom}}, mm},
                                         {"Height", "mm", {{"height", &S::wick_height}}, mm},
                                         {"Water content", "% of dry mass", {{"top", &S::content_top}, {"bottom", &S::content_bottom}}},
                                         {"Water",
                                          "mg",
                                          {{"free", &S::free_water},
                                           {"in yarns", &S::yarn_water},
                                           {"in fibres", &S::bound_water, true},
                                           {"evaporated", &S::evaporated},
                                           {"dripped off", &S::dripped, false, true}},
                                          mg},
                                         {"Water in the faces", "mg", {{"top", &S::water_top}, {"bottom", &S::water_bottom}}, mg},
                                         {"Temperature",
                                          "°C",
                                          {{"sample", &S::temperature_mean},
                                           {"air", &S::air_temperature},
                                           {"coldest yarn", &S::temperature_min, false, true},
                                           {"warmest yarn", &S::temperature_max, false, true}},
                                          1,
                                          -zero_celsius,
                                          false},
                                         {"Regain", "%", {{"fibres", &S::regain_mean}}, 100}};
    return plots;
}

const Plot& plot_named(PlotName name) { return all_plots()[static_cast<std::size_t>(name)]; }

const Plot& water_plot(ExperimentType type)
{
    return plot_named(info_of(type).source == WaterSource::air ? PlotName::regain : PlotName::water);
}

std::vector<double> plotted(const Plot& plot, const Curve& curve, const Series& series, double water_initial)
{
    std::vector<double> values = series.*curve.values;
    const double before = curve.over_start ? water_initial : 0;
    for (double& value : values) value = plot.factor * (value - before) + plot.offset;
    return values;
}

std::vector<double> plotted(const Plot& plot, const Curve& curve, const Metrics& metrics)
{
    return plotted(plot, curve, metrics.series, metrics.ledger.water_initial);
}

} // namespace hygroloom
