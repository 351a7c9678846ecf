// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Strips and spots that wick, compared with published curves and directions. Comparisons, not proofs.
#include "core/base/units.h"
#include "core/design/jam.h"
#include "core/run/plan_run.h"
#include "core/verify/fits.h"
#include "core/verify/set_ups.h"

#include <algorithm>

namespace hygroloom {
namespace {

/// A narrow strip, cut along the warp, that hangs in water by its end.
Experiment hanging_strip(double length_mm, double duration)
{
    Experiment strip = standard_experiment(ExperimentType::vertical_wicking);
    strip.sample_mm = {1, length_mm};
    strip.immersion_mm = 5;
    strip.duration_s = duration;
    return strip;
}

/// Height over time of a strip, m and s.
struct Rise {
    std::vector<double> time, height;
    double at(double when) const { return value_at(time, height, when); }
    double exponent(double from, double to) const { return std::log(at(to) / at(from)) / std::log(to / from); }
};
Rise rise_of(const Metrics& metrics) { return {metrics.series.time, metrics.series.wick_height}; }
Rise rise_of(const Fabric& fabric, double length_mm, double duration, Backend& backend)
{
    return rise_of(run_whole(design_of(fabric, hanging_strip(length_mm, duration)), Fidelity::draft, backend).metrics);
}

/// A strip whose scene a case may change before it runs.
struct StripRun {
    RunRecord record;
    Scene scene;

    StripRun(const Fabric& fabric, const Experiment& strip)
    {
        record.design = design_of(fabric, strip);
        const Experiment& experiment = record.design.experiments[0];
        record.fabric = fabric.name;
        record.experiment = experiment.name;
        record.plan = plan_run(record.design, fabric, experiment, Fidelity::draft);
        record.textile = build_textile(record.design, fabric, record.plan.region);
        scene = build_scene(record.design, record.textile, experiment, record.plan, 1);
    }
    Rise rise(double duration, Backend& backend)
    {
        std::vector<double> times;
        for (int i = 1; i <= 60; ++i) times.push_back(duration / 60 * i);
        MetricsCollector collector;
        collector.start(record);
        for (const Frame& frame : frames_at(backend, scene, times)) collector.add(frame);
        return rise_of(collector.metrics());
    }
};

/// Lucas and Washburn with gravity through the points at 60 and 600 s; its worst error at 30, 120 and 300 s, as a share.
double error_of_washburn_with_gravity(const Rise& rise)
{
    const auto duration = [](double part) { return -part - std::log1p(-part); }; // of the rise to a part of the highest, in its own unit
    double low = 1.000001 * rise.at(600), high = 1e3;
    for (int i = 0; i < 200; ++i) {
        const double highest = std::sqrt(low * high);
        (duration(rise.at(600) / highest) > 10 * duration(rise.at(60) / highest) ? low : high) = highest;
    }
    const double highest = std::sqrt(low * high), unit = 600 / duration(rise.at(600) / highest);
    double worst = 0;
    for (double seconds : {30.0, 120.0, 300.0}) {
        double below = 0, above = (1 - 1e-12) * highest;
        for (int i = 0; i < 100; ++i) (unit * duration(0.5 * (below + above) / highest) < seconds ? below : above) = 0.5 * (below + above);
        worst = std::max(worst, std::abs(below / rise.at(seconds) - 1));
    }
    return worst;
}

/// N6: the form of h(t) of finished synthetics.
std::vector<VerifyResult> rise_in_synthetics(const VerifyValues& v, Backend& backend)
{
    const char* in_yarns =
        "above a few centimetres the rooms between yarns hold little, and inside the yarns water rises: these suck by far more than the "
        "weight of that height";
    const double duration = v.at("duration_s").value;
    std::vector<VerifyResult> results;
    for (const auto& [name, fabric] : {std::pair{"polyester", "Sports micro-twill"}, std::pair{"nylon", "Nylon taslan"}}) {
        const Rise rise = rise_of(library_fabric(fabric), 400, duration, backend);
        const std::string word = name;
        results.push_back(between(word + "_exponent_30_60_s", rise.exponent(30, 60), 0.4, 0.52));
        if (duration >= 600) { // shorter ones leave out what comes late
            const VerifyResult late = at_most(word + "_exponent_300_600_s", rise.exponent(300, 600), 0.4);
            results.push_back(known_miss(late, in_yarns, 0.05));
            results.push_back(at_most(word + "_error_of_washburn", error_of_washburn_with_gravity(rise), 0.1));
        }
        results.push_back(between(word + "_w_60_s_mm2_s", 1e6 * rise.at(60) * rise.at(60) / 60, 10, 120));
    }
    return results;
}

/// Plain weave, warp of scoured cotton, weft of a fibre that water does not wet, in strips that hang in water; sett of the warp over that
/// at which it touches.
struct StripOfBoth {
    double weft_saturation = 0; ///< greatest out of the bath, of a strip along the warp
    int along = 0;              ///< pitches that liquid came along the warp out of the bath
    int across = 0;             ///< pitches that liquid came from warp yarn to warp yarn out of the bath, of a strip along the weft
};
StripOfBoth strip_of_cotton_and_pvdf(double closeness, Backend& backend)
{
    Fabric fabric = library_fabric("Textile F");
    const double diameter = *fabric.warp.diameter_mm;
    fabric.ends_per_cm = closeness * 10 / diameter;
    fabric.picks_per_cm = 20;
    fabric.thickness_mm.reset();
    fabric.weft.material = {{"PVDF", 1.0}};
    Material pvdf = library_material("polyester");
    pvdf.name = "PVDF";
    pvdf.based_on = "polyester";
    pvdf.contact_angle_deg = 100;
    StripOfBoth strip;
    for (bool along_weft : {false, true}) {
        Experiment experiment = hanging_strip(40, 60);
        experiment.along_weft = along_weft;
        Design design = design_of(fabric, experiment);
        design.materials.push_back(pvdf);
        const WholeRun run = run_whole(design, Fidelity::draft, backend);
        const Textile& textile = run.record.textile;
        const double pitch = along_weft ? textile.warp.pitch : textile.weft.pitch;
        const auto deep = static_cast<int>(std::lround(metre_from_mm(experiment.immersion_mm) / pitch)); // in the bath
        for (int end = 0; end < textile.ends(); ++end)
            for (int pick = 0; pick < textile.picks(); ++pick) {
                const int beyond = (along_weft ? end : pick) + 1 - deep;
                if (beyond <= 0) continue;
                const auto saturation = [&](YarnKind kind) {
                    return static_cast<double>(run.last.saturation[static_cast<std::size_t>(textile.segment(kind, end, pick))]);
                };
                if (!along_weft) strip.weft_saturation = std::max(strip.weft_saturation, saturation(YarnKind::weft));
                int& reached = along_weft ? strip.across : strip.along;
                if (saturation(YarnKind::warp) >= wet_saturation) reached = std::max(reached, beyond);
            }
    }
    return strip;
}

/// T1
std::vector<VerifyResult> hydrophobic_weft(const VerifyValues&, Backend& backend)
{
    const StripOfBoth open = strip_of_cotton_and_pvdf(0.5, backend), close = strip_of_cotton_and_pvdf(0.75, backend),
                      touching = strip_of_cotton_and_pvdf(1.0, backend);
    return {at_most("weft_saturation", std::max({open.weft_saturation, close.weft_saturation, touching.weft_saturation}), 0.05),
            at_least("pitches_along_warp", std::min({open.along, close.along, touching.along}), 2),
            at_most("pitches_across_apart", std::max(open.across, close.across), 1),
            at_least("pitches_across_touching", touching.across, 2)};
}

/// T5: of scoured cotton, long enough that water does not reach its upper end.
std::vector<VerifyResult> cotton_strip(const VerifyValues&, Backend& backend)
{
    const WholeRun run =
        run_whole(design_of(of_even_yarns(library_fabric("Textile F")), hanging_strip(300, 120)), Fidelity::draft, backend);
    const Rise rise = rise_of(run.metrics);
    std::vector<double> squares;
    for (double h : rise.height) squares.push_back(h * h);
    const Textile& textile = run.record.textile;
    // Water of each whole centimetre from the bath to the height, in yarns and between them.
    const int centimetre = static_cast<int>(std::lround(0.01 / textile.weft.pitch));
    const double bath = metre_from_mm(run.record.design.experiments[0].immersion_mm), pitch = textile.weft.pitch;
    std::vector<double> water;
    for (int low = static_cast<int>(bath / pitch) + 1; (low + centimetre) * pitch <= bath + rise.height.back(); low += centimetre) {
        water.push_back(0);
        for (int end = 0; end < textile.ends(); ++end)
            for (int pick = low; pick < low + centimetre; ++pick)
                for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
                    water.back() += static_cast<double>(run.last.liquid[static_cast<std::size_t>(textile.segment(kind, end, pick))]);
    }
    double least_fall = 1;
    for (std::size_t i = 1; i < water.size(); ++i) least_fall = std::min(least_fall, 1 - water[i] / water[i - 1]);
    return {at_least("straightness_of_h2", fit_line(rise.time, squares).r_squared, 0.97),
            known_miss(at_least("least_fall_of_water_per_cm", least_fall, 0.02),
                       "rooms between yarns empty within the first centimetres; above, the yarns are full, as they hold by far more than "
                       "the weight of "
                       "the height",
                       0.021)};
}

/// T6: the same yarns and sett in three weaves, 120 min or duration_s of wicking and drying.
std::vector<VerifyResult> floats_and_wicking(const VerifyValues& v, Backend& backend)
{
    const double duration = v.at("duration_s").value;
    std::vector<double> early, late; // kg absorbed in 10 min, kg/s after that
    for (const char* weave : {"plain", "twill 2/2 Z", "satin 8/3"}) {
        Fabric fabric = of_even_yarns(library_fabric("Sheeting"));
        fabric.weave = weave_from_pattern(weave);
        fabric.warp_crimp_percent.reset();
        fabric.weft_crimp_percent.reset();
        const Metrics metrics = run_whole(design_of(fabric, hanging_strip(300, duration)), Fidelity::draft, backend).metrics;
        const Series& s = metrics.series;
        std::vector<double> taken;
        for (std::size_t i = 0; i < s.time.size(); ++i)
            taken.push_back(s.yarn_water[i] + s.bound_water[i] - s.bound_water[0] + s.evaporated[i]);
        early.push_back(value_at(s.time, taken, 600));
        late.push_back((taken.back() - early.back()) / (s.time.back() - 600));
    }
    const char* lighter =
        "the rooms of so open a sheeting do not fill by themselves, so that floats change the yarns' way alone; and yarns that crimp less "
        "are less yarn to fill";
    return {known_miss(ratio_at_least("early_twill_over_plain", early[1] / early[0], 1.03), lighter, 0.15),
            known_miss(ratio_at_least("early_satin_over_twill", early[2] / early[1], 1.03), lighter, 0.1),
            {"late_twill_over_plain", late[1] / late[0], 1, 0.1},
            {"late_satin_over_plain", late[2] / late[0], 1, 0.1}};
}

/// Fibres in less order: as wide a spread of pores as the closure knows, of the same fibre surface, and half as many gaps through which a
/// dry bundle wets.
WettedPores disordered(const WettedPores& ordered)
{
    const Retention& holds = ordered.retention;
    const double shape = 0.5 * holds.twice_shape, hysteresis = holds.emptying / holds.entry;
    PoreClosure pores;
    pores.shape = 3;
    pores.entry_suction = (1 - 1 / pores.shape) / (1 - 1 / shape) * holds.entry;
    pores.hysteresis = hysteresis;
    pores.threshold = holds.threshold;
    pores.front_suction = pores.entry_suction * std::pow(pores.threshold, -1 / pores.shape);
    return {retention_of(pores), 0.5 * ordered.gate};
}

/// T7: h2/t of strips in which water has not reached the upper end; well wetted, as scoured cotton is. The measurement was made on yarns:
/// once with the room between them shut off, once as cloth.
std::vector<VerifyResult> order_and_angle(const VerifyValues& v, Backend& backend)
{
    const double duration = v.at("duration_s").value;
    std::vector<VerifyResult> results;
    for (const char* of : {"yarns", "cloth"}) {
        const auto coefficient = [&](double angle, bool in_order) {
            Fabric fabric = library_fabric("Textile F");
            fabric.contact_angle_deg = angle;
            StripRun strip(fabric, hanging_strip(300, duration));
            Cloth& cloth = strip.scene.cloth;
            if (!in_order)
                for (YarnParameters& yarn : cloth.yarns)
                    for (WettedPores& pores : yarn.on_face) pores = disordered(pores);
            if (of == std::string("yarns"))
                for (CrossingParameters& crossing : cloth.crossing) {
                    BetweenParameters& room = crossing.between;
                    room.along_warp = room.along_weft = room.to_warp = room.to_weft = 0;
                }
            const double height = strip.rise(duration, backend).height.back();
            return height * height / duration;
        };
        const double w = coefficient(35, true), by_order = coefficient(35, false) / w, by_angle = coefficient(45, true) / w;
        results.push_back(ratio_at_most(std::string("w_in_disorder_") + of, by_order, 1));
        results.push_back(known_miss(at_most(std::string("angle_over_order_") + of, std::abs(1 - by_angle) / std::abs(1 - by_order), 1),
                                     "suction goes with the cosine of the angle, which 10 degrees change by 14 %; of disorder the closure "
                                     "knows the spread of pores and the gate, but no rougher angle and no broken pores",
                                     of == std::string("yarns") ? 3 : 12));
    }
    return results;
}

/// T8: a level strip that draws from its wet end, at three closenesses of the same yarns.
std::vector<VerifyResult> density_and_wicking(const VerifyValues& v, Backend& backend)
{
    const double duration = v.at("duration_s").value;
    std::vector<VerifyResult> results;
    std::vector<double> rates;
    for (int percent : {70, 85, 100}) {
        Fabric fabric = library_fabric("Sheeting");
        const double limit = jam_gauge(fabric, fit_yarns(Design{}, fabric)).warp.ashenhurst_per_cm;
        fabric.ends_per_cm = fabric.picks_per_cm = 0.01 * percent * limit;
        fabric.warp_crimp_percent.reset();
        fabric.weft_crimp_percent.reset();
        StripRun strip(fabric, hanging_strip(300, duration));
        strip.scene.cloth.gravity_along_warp = 0; // it lies
        const Rise rise = strip.rise(duration, backend);
        std::vector<double> roots;
        for (double time : rise.time) roots.push_back(std::sqrt(time));
        const FittedLine line = fit_line(roots, rise.height);
        rates.push_back(line.slope);
        results.push_back(at_least("straightness_at_" + std::to_string(percent) + "_pct", line.r_squared, 0.98));
    }
    const char* open_rooms =
        "rooms between yarns take part in close cloth alone: in open cloth their two faces cost more than the yarns gain";
    results.push_back(known_miss(ratio_at_most("rate_at_85_over_70_pct", rates[1] / rates[0], 1), open_rooms, 0.1));
    results.push_back(known_miss(ratio_at_most("rate_at_100_over_85_pct", rates[2] / rates[1], 1), open_rooms, 0.3));
    results.push_back(known_miss(ratio_at_most("rate_at_100_over_70_pct", rates[2] / rates[0], 0.95), open_rooms, 0.4));
    return results;
}

} // namespace

std::vector<VerifyCase> measured_wicking_cases()
{
    return {
        {"measured_n6",
         "The form of the rise in strips of finished synthetics: its exponents, Washburn's law with gravity through two points, its speed.",
         {{"duration_s", 600, 60, 600, ""}},
         rise_in_synthetics,
         "Jasper et al., wjasper/Wicking_Tracker, NC State University 2025: knitted nylon and polyester, of unknown construction; the form "
         "alone",
         ""},
        {"measured_t1",
         "Cotton warp, weft that water does not wet: liquid keeps to the warp, and gets across where warp yarns touch.",
         {},
         hydrophobic_weft,
         "Zhu and Takatera, Textile Research Journal 85 (2015) 479, doi 10.1177/0040517514549986",
         ""},
        {"measured_t2",
         "A drop's first spreading over a textured solid.",
         {},
         {},
         "Stapelbroek et al., Soft Matter 2014, doi 10.1039/C3SM52464G",
         "Measured on solids, in the first millisecond. Caps assume its root of time, so that a comparison would show nothing; particles "
         "were "
         "not compared."},
        {"measured_t5",
         "A cotton strip: its height squared is straight over time, and it holds the less water the higher.",
         {},
         cotton_strip,
         "Zhu et al., Fibres and Textiles in Eastern Europe 2015(2), p. 137",
         ""},
        {"measured_t6",
         "Weaves of the same yarns and sett: more floats, faster uptake in 10 min; the same rate from then to the end, 120 min unless it "
         "is shorter.",
         {{"duration_s", 7200, 900, 14400, ""}},
         floats_and_wicking,
         "Lei et al., Polymers 2020, 12(2), 422, doi 10.3390/polym12020422",
         ""},
        {"measured_t7",
         "Disorder of the fibres slows wicking more than 10 degrees of contact angle do.",
         {{"duration_s", 60, 5, 600, ""}},
         order_and_angle,
         "Hollies et al., Textile Research Journal 26 (1956), doi 10.1177/004051755602601102",
         ""},
        {"measured_t8",
         "Level wicking goes with the root of time, and is the slower the denser the yarns stand.",
         {{"duration_s", 120, 10, 1200, ""}},
         density_and_wicking,
         "Measurement of in-plane capillary water flow of fabrics (dew-sensor array), woven cotton and polyester of several densities",
         ""},
    };
}

} // namespace hygroloom
