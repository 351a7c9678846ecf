// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A metric is one row here, its computation in laboratory.cpp, moisture_tester.cpp or metrics.cpp, and its test.
#include "core/analysis/outcomes.h"

#include "core/base/units.h"
#include "core/physics/caps.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hygroloom {
namespace {

using M = const Metrics&;
using Value = std::optional<double>;

/// A row of the table.
struct Metric {
    OutcomeInfo info;
    Value (*value)(M) = nullptr;
    const char* missing = "";
    int ManagementGrades::*grade = nullptr;
    const char* (*remark)(M) = nullptr;
    const char* (*text)(M) = nullptr;
};

/// Rows that apply together.
struct MetricGroup {
    bool (*applies)(M);
    std::vector<Metric> rows;
};

struct TypeMetrics {
    std::vector<const MetricGroup*> groups;
    std::vector<const char*> compared_by; ///< keys; the first ranks by default
    PlotName subject;
    void (*compute)(Metrics&, const Experiment&, double area) = nullptr; ///< see compute_results()
};

constexpr Better more = Better::more, less = Better::less, neither = Better::neither;

Value scaled(const Value& value, double factor) { return value ? Value(*value * factor) : std::nullopt; }

/// A tester's rings lie 5 mm apart and are wet or dry; what its pins read, or where there are none the stain's radius.
double ring_mm(M m, FaceIndices ManagementIndices::*face, double radius)
{
    if (m.management) return ((*m.management).*face).maximum_wetted_radius;
    return 5.0 * std::floor(mm_from_metre(radius) / 5.0 + 1e-9);
}

Value of_shape(M m, double StainShape::*number) { return m.shape ? Value((*m.shape).*number) : std::nullopt; }
constexpr const char* no_shape = "the stain is too small, or shown in cells";

/// kg that are rounding beside what was delivered.
bool negligible(double water, M m) { return water < 1e-9 * m.ledger.water_delivered; }

const MetricGroup& stain()
{
    using G = ManagementGrades;
    static const MetricGroup group{
        [](M) { return true; },
        {{{"equal_area_radius_mm", "stain radius by area", "top", "mm", more},
          [](M m) -> Value { return mm_from_metre(m.equal_area_radius_top); }},
         {{"equal_area_radius_bottom_mm", "stain radius by area", "bottom", "mm", more},
          [](M m) -> Value { return mm_from_metre(m.equal_area_radius_bottom); }},
         {{"wetted_area_mm2", "area of the stain", "top", "mm²", more},
          [](M m) -> Value { return 1e6 * pi * m.equal_area_radius_top * m.equal_area_radius_top; }},
         {{"maximum_wetted_radius_top_mm", "wetted radius", "top", "mm", more},
          [](M m) -> Value { return mm_from_metre(m.maximum_wetted_radius_top); }},
         {{"maximum_wetted_radius_bottom_mm", "wetted radius", "bottom", "mm", more},
          [](M m) -> Value { return mm_from_metre(m.maximum_wetted_radius_bottom); }},
         {{"maximum_wetted_radius_top_ring_mm", "wetted radius in 5 mm rings", "top", "mm", more, true},
          [](M m) -> Value { return ring_mm(m, &ManagementIndices::top, m.maximum_wetted_radius_top); },
          "",
          &G::maximum_wetted_radius_top},
         {{"maximum_wetted_radius_bottom_ring_mm", "wetted radius in 5 mm rings", "bottom", "mm", more, true},
          [](M m) -> Value { return ring_mm(m, &ManagementIndices::bottom, m.maximum_wetted_radius_bottom); },
          "",
          &G::maximum_wetted_radius_bottom},
         {{"wetted_area_ellipse_warp_mm", "ellipse of equal moments on top, semi-axis along warp", "", "mm", neither},
          [](M m) -> Value { return mm_from_metre(m.wetted_area_ellipse_warp); }},
         {{"wetted_area_ellipse_weft_mm", "ellipse of equal moments on top, semi-axis along weft", "", "mm", neither},
          [](M m) -> Value { return mm_from_metre(m.wetted_area_ellipse_weft); }},
         {{"stain_aspect", "aspect of the stain on top", "", "", neither}, [](M m) { return of_shape(m, &StainShape::aspect); }, no_shape},
         {{"stain_armness", "arms of the stain on top", "", "", neither}, [](M m) { return of_shape(m, &StainShape::armness); }, no_shape},
         {{"stain_solidity", "solidity of the stain on top", "", "", neither},
          [](M m) { return of_shape(m, &StainShape::solidity); },
          no_shape},
         {{"time_of_arrest_s", "stain at rest from", "", "s", neither},
          [](M m) { return m.time_of_arrest; },
          "no 10 s without growth before the end"},
         {{"water_between_yarns_g", "water between the yarns", "", "g", neither},
          [](M m) -> Value { return negligible(m.water_between_yarns, m) ? 0.0 : 1e3 * m.water_between_yarns; }},
         {{"water_shed_below_g", "water shed below", "", "g", neither}, [](M m) -> Value { return 1e3 * m.ledger.water_dripped; }}}};
    return group;
}

const MetricGroup& absorbency()
{
    static const MetricGroup group{[](M m) { return m.ledger.water_delivered > 0; },
                                   {{{"absorbency_time_s", "absorbency time", "", "s", less},
                                     [](M m) { return m.absorbency_time; },
                                     "liquid is left on the cloth, or falls through it",
                                     nullptr,
                                     [](M m) {
                                         return m.ledger.water_dripped > unseen_share * m.ledger.water_delivered
                                                    ? "some of the liquid dripped off instead of being absorbed"
                                                    : "";
                                     }}}};
    return group;
}

const MetricGroup& area_growth()
{
    static const MetricGroup group{[](M) { return true; },
                                   {{{"wick_rate_mm2_s", "wicking rate", "", "mm²/s", more, false, false, true},
                                     [](M m) { return scaled(m.horizontal_rate, 1e6); },
                                     "nothing is wet"}}};
    return group;
}

const MetricGroup& management()
{
    using G = ManagementGrades;
    constexpr const char* dry = "this face stayed dry";
    static const MetricGroup group{
        [](M m) { return m.management.has_value(); },
        {{{"wetting_time_top_s", "wetting time", "top", "s", less},
          [](M m) { return m.management->top.wetting_time; },
          dry,
          &G::wetting_time_top},
         {{"wetting_time_bottom_s", "wetting time", "bottom", "s", less},
          [](M m) { return m.management->bottom.wetting_time; },
          dry,
          &G::wetting_time_bottom},
         {{"absorption_rate_top_pct_s", "absorption rate", "top", "%/s", more, false, false, true},
          [](M m) -> Value { return m.management->top.absorption_rate; },
          "",
          &G::absorption_rate_top},
         {{"absorption_rate_bottom_pct_s", "absorption rate", "bottom", "%/s", more, false, false, true},
          [](M m) -> Value { return m.management->bottom.absorption_rate; },
          "",
          &G::absorption_rate_bottom},
         {{"spreading_speed_top_mm_s", "spreading speed by 5 mm rings", "top", "mm/s", more, false, false, true},
          [](M m) -> Value { return m.management->top.spreading_speed; },
          "",
          &G::spreading_speed_top},
         {{"spreading_speed_bottom_mm_s", "spreading speed by 5 mm rings", "bottom", "mm/s", more, false, false, true},
          [](M m) -> Value { return m.management->bottom.spreading_speed; },
          "",
          &G::spreading_speed_bottom},
         {{"one_way_transport_pct", "one-way transport", "", "%", more, false, true, true},
          [](M m) -> Value { return m.management->one_way_transport; },
          "",
          &G::one_way_transport},
         {{"ommc", "overall capability (OMMC)", "", "", more, false, false, true},
          [](M m) -> Value { return m.management->ommc; },
          "",
          &G::ommc},
         {{"fabric_class", "class", "", "", neither, false, false, true}, nullptr, "", nullptr, nullptr, [](M m) {
              return fabric_class(*m.management);
          }}}};
    return group;
}

const MetricGroup& rise()
{
    static const MetricGroup group{
        [](M m) { return m.wicking.has_value(); },
        {{{"wick_height_mm", "height", "", "mm", more}, [](M m) -> Value { return mm_from_metre(m.wicking->height); }},
         {{"wick_rate_mm_s05", "wicking rate", "", "mm/√s", more},
          [](M m) { return scaled(m.wicking->rate, 1e3); },
          "the liquid did not rise"}}};
    return group;
}

/// After the i-th of rise_minutes.
template <std::size_t i> const MetricGroup& rise_after()
{
    static const std::string minutes = std::to_string(rise_minutes[i]);
    static const MetricGroup group{
        [](M m) { return m.wicking && m.wicking->after[i]; },
        {{{"wick_height_" + minutes + "_min_mm", "height after " + minutes + " min", "", "mm", more},
          [](M m) -> Value { return mm_from_metre(m.wicking->after[i]->height); }},
         {{"wick_water_" + minutes + "_min_mg_mm", "water drawn in after " + minutes + " min, per width", "", "mg/mm", more},
          [](M m) -> Value { return 1e3 * m.wicking->after[i]->water; }}}};
    return group;
}

const MetricGroup& drying()
{
    constexpr const char* early = "less than 70 % of the water has dried";
    static const MetricGroup group{
        [](M m) { return m.drying.has_value(); },
        {{{"drying_rate_g_m2_h", "steady drying rate", "", "g/(m² h)", more},
          [](M m) { return scaled(m.drying->rate, g_m2_h_per_kg_m2_s); },
          early},
         {{"drying_index_pct_min", "drying index", "", "%/min", more}, [](M m) { return scaled(m.drying->index, 100 * 60); }, early},
         {{"water_at_start_g_m2", "water at the start", "", "g/m²", neither},
          [](M m) { return scaled(m.water_at_start, 1e3); },
          "nothing is wet"},
         {{"time_to_dry_s", "time to dry", "", "s", less}, [](M m) { return m.drying->time_to_dry; }, "more than 4 % of the water is left"},
         {{"surface_temperature_steady_c", "steady temperature", "", "°C", less, false, true},
          [](M m) { return m.drying->steady_temperature ? Value(celsius_from_kelvin(*m.drying->steady_temperature)) : Value(); },
          early}}};
    return group;
}

const MetricGroup& conditioning()
{
    static const MetricGroup group{
        [](M m) { return m.conditioning.has_value(); },
        {{{"regain_start", "regain at the start", "", "kg/kg", neither}, [](M m) -> Value { return m.conditioning->regain_start; }},
         {{"regain_end", "regain at the end", "", "kg/kg", more},
          [](M m) -> Value { return m.conditioning->regain_end; },
          "",
          nullptr,
          [](M m) { return m.conditioning->settled ? "" : "still changing"; }},
         {{"regain_half_time_s", "half-change time", "", "s", less, false, false, true},
          [](M m) { return m.conditioning->half_time; },
          "the regain did not change"},
         {{"temperature_peak_rise_c", "peak warming above air", "", "K", less, false, true},
          [](M m) -> Value { return m.conditioning->peak_rise; }}}};
    return group;
}

void compute_management(Metrics& m, const Experiment& experiment, double)
{
    const Series& s = m.series;
    const int drops = drops_of_feed(experiment);
    const TesterFeed feed{experiment.feed_s, drops > 0 ? experiment.feed_s / drops : 0.0};
    m.management = tester_indices(s.time, s.tester, feed);
    double interval = 0; // longest between frames while the pump runs
    for (std::size_t i = 1; i < s.time.size() && s.time[i] <= experiment.feed_s; ++i)
        interval = std::max(interval, s.time[i] - s.time[i - 1]);
    m.assumed = tester_assumptions(experiment.drop_ul, feed, interval);
}

void compute_wicking(Metrics& m, const Experiment& experiment, double area)
{
    const double width = area / metre_from_mm(experiment.sample_mm[1]);
    std::vector<double> water;
    for (const double delivered : m.series.delivered) water.push_back(delivered / width);
    m.wicking = wicking_result(m.series.time, m.series.wick_height, water);
}

/// Area of the stain's ellipse over the time in which its circle grew to 95 %.
void compute_horizontal_rate(Metrics& m, const Experiment&, double)
{
    const std::vector<double>& radius = m.series.radius_top;
    if (radius.empty() || radius.back() <= 0) return;
    const double area = pi * m.wetted_area_ellipse_warp * m.wetted_area_ellipse_weft;
    for (std::size_t i = 0; i < radius.size() && !m.horizontal_rate; ++i)
        if (radius[i] >= 0.95 * m.maximum_wetted_radius_top && m.series.time[i] > 0) m.horizontal_rate = area / m.series.time[i];
}

void compute_drying(Metrics& m, const Experiment&, double area)
{
    std::vector<double> left;
    for (double evaporated : m.series.evaporated) left.push_back(m.ledger.water_delivered - evaporated);
    m.water_at_start = m.ledger.water_delivered / area;
    m.drying = drying_result(m.series.time, left, m.series.temperature_mean, area);
}

void compute_conditioning(Metrics& m, const Experiment&, double)
{
    const Series& s = m.series;
    m.conditioning = conditioning_result(s.time, s.regain_mean, s.temperature_mean, s.air_temperature);
}

/// In the order of ExperimentType.
const TypeMetrics& metrics_of(ExperimentType type)
{
    constexpr const char *top = "equal_area_radius_mm", *bottom = "equal_area_radius_bottom_mm";
    // One finger of a stain moves the circle round it more.
    constexpr const char *circle_top = "maximum_wetted_radius_top_mm", *circle_bottom = "maximum_wetted_radius_bottom_mm";
    static const std::array<TypeMetrics, experiment_types> table{
        {/* droplet */ {{&stain(), &absorbency()}, {top, bottom, "absorbency_time_s", circle_top, circle_bottom}, PlotName::radius},
         /* moisture_management */
         {{&stain(), &management()},
          {"ommc", "one_way_transport_pct", "spreading_speed_bottom_mm_s", "absorption_rate_bottom_pct_s", "wetting_time_top_s"},
          PlotName::content,
          compute_management},
         /* vertical_wicking */
         {{&rise(), &rise_after<0>(), &rise_after<1>(), &rise_after<2>()},
          {"wick_height_mm", "wick_rate_mm_s05"},
          PlotName::height,
          compute_wicking},
         /* horizontal_wicking */
         {{&stain(), &absorbency(), &area_growth()},
          {"wick_rate_mm2_s", top, "absorbency_time_s", circle_top},
          PlotName::radius,
          compute_horizontal_rate},
         /* drying */
         {{&drying()}, {"time_to_dry_s", "drying_rate_g_m2_h", "surface_temperature_steady_c"}, PlotName::temperature, compute_drying},
         /* conditioning */
         {{&conditioning()}, {"regain_half_time_s", "regain_end", "temperature_peak_rise_c"}, PlotName::temperature, compute_conditioning},
         /* sweat */ {{&stain()}, {bottom, top, circle_bottom, circle_top}, PlotName::faces}}};
    return table[static_cast<std::size_t>(type)];
}

int rank_of(const std::string& key, const TypeMetrics& type)
{
    const auto& keys = type.compared_by;
    const auto found = std::find(keys.begin(), keys.end(), key);
    return found == keys.end() ? 0 : static_cast<int>(found - keys.begin()) + 1;
}

Outcome outcome_of(const Metric& metric, M m, bool part)
{
    Outcome outcome;
    static_cast<OutcomeInfo&>(outcome) = metric.info;
    if (metric.text) outcome.text = metric.text(m);
    if (metric.value) outcome.value = metric.value(m);
    if (!outcome.value) outcome.missing = metric.missing;
    if (outcome.value && !std::isfinite(*outcome.value)) {
        outcome.value.reset();
        outcome.missing = "the computed value is not a finite number";
    }
    if (part && outcome.of_whole_test) {
        outcome.value.reset();
        outcome.text.clear();
        outcome.missing = "only a part of the test is there";
    }
    if (metric.remark) outcome.remark = metric.remark(m);
    if (metric.grade && m.management && !part) outcome.grade = management_grades(*m.management).*metric.grade;
    return outcome;
}

/// mg; what is below 1e-6 mg is rounding and shown as 0.
double mg_of(double kg)
{
    const double mg = 1e6 * kg;
    return std::abs(mg) < 1e-6 ? 0.0 : mg;
}

} // namespace

void compute_results(Metrics& metrics, const Experiment& experiment, double area)
{
    if (const auto compute = metrics_of(experiment.type).compute) compute(metrics, experiment, area);
}

const Plot& subject_plot(ExperimentType type) { return plot_named(metrics_of(type).subject); }

std::string full_title(const OutcomeInfo& info) { return info.part.empty() ? info.title : info.title + ", " + info.part; }

std::vector<Outcome> outcomes_of(const RunRecord& run, const Metrics& metrics, bool part)
{
    const Experiment* experiment = find_experiment(run.design, run.experiment);
    const TypeMetrics& type = metrics_of(experiment ? experiment->type : ExperimentType::droplet);
    part = part || is_part_of_test(run, metrics);
    std::vector<Outcome> outcomes;
    for (const MetricGroup* group : type.groups) {
        if (!group->applies(metrics)) continue;
        for (const Metric& metric : group->rows) {
            outcomes.push_back(outcome_of(metric, metrics, part));
            outcomes.back().rank = rank_of(metric.info.key, type);
        }
    }
    return outcomes;
}

bool is_part_of_test(const RunRecord& run, const Metrics& metrics)
{
    const Experiment* experiment = find_experiment(run.design, run.experiment);
    constexpr double rounding = 1e-6;
    return experiment && !metrics.series.time.empty() && metrics.series.time.back() < experiment->duration_s * (1 - rounding);
}

bool is_shown(const Outcome& outcome) { return !outcome.in_rings || outcome.grade; }

ShownValue shown(const OutcomeInfo& info, double value)
{
    return info.unit == "kg/kg" ? ShownValue{100 * value, "%"} : ShownValue{value, info.unit};
}

std::vector<OutcomeInfo> compared_by(ExperimentType type)
{
    const TypeMetrics& of = metrics_of(type);
    std::vector<OutcomeInfo> infos(of.compared_by.size());
    for (const MetricGroup* group : of.groups)
        for (const Metric& metric : group->rows)
            if (const int rank = rank_of(metric.info.key, of); rank > 0) infos[static_cast<std::size_t>(rank - 1)] = metric.info;
    return infos;
}

std::vector<OutcomeInfo> reported_by(ExperimentType type)
{
    std::vector<OutcomeInfo> infos;
    for (const MetricGroup* group : metrics_of(type).groups)
        for (const Metric& metric : group->rows)
            if (metric.value) infos.push_back(metric.info);
    return infos;
}

bool may_be_negative(const std::string& key)
{
    for (int type = 0; type < experiment_types; ++type)
        for (const MetricGroup* group : metrics_of(static_cast<ExperimentType>(type)).groups)
            for (const Metric& metric : group->rows)
                if (metric.info.key == key) return metric.info.may_be_negative;
    return true;
}

std::vector<BalanceRow> water_balance(const Ledger& l)
{
    const bool from_air = l.water_evaporated < 0;
    return {{"water delivered", mg_of(l.water_delivered), "mg"},
            {"free water", mg_of(l.water_free), "mg"},
            {"water in the pores", mg_of(l.water_liquid), "mg"},
            {"water absorbed by the fibres", mg_of(l.water_bound + l.water_vapour - l.water_initial), "mg"},
            {from_air ? "water taken from the air" : "water evaporated", mg_of(from_air ? -l.water_evaporated : l.water_evaporated), "mg"},
            {"water dripped off", mg_of(l.water_dripped), "mg"}};
}

std::vector<BalanceRow> balance_check(const Ledger& l)
{
    constexpr double mj = 1e3;
    return {{"water imbalance", mg_of(l.water_imbalance()), "mg"},
            {"energy released", mj * l.energy_released, "mJ"},
            {"energy imbalance", mj * l.energy_imbalance(), "mJ"}};
}

} // namespace hygroloom
