// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// More than a hundred designs from the corners of what validate() accepts: whatever they are, nothing is made, lost or out of its bounds.
#include "core/base/units.h"
#include "core/design/design.h"
#include "core/design/validate.h"
#include "core/physics/heat_moisture.h"
#include "core/project/project_file.h"
#include "core/run/plan_run.h"
#include "core/scene/coarse_scene.h"
#include "core/solver/cpu_solver.h"
#include "core/solver/segments.h"
#include "core/solver/steps/yarn_lines.h"
#include "tests/support/random_design.h"

#include <QTest>

#include <fmt/format.h>

#include <map>

using namespace hygroloom;

namespace tst_extremes {
namespace {

constexpr int chunk_size = 10;
/// About one in five is refused. HYGROLOOM_EXTREMES asks for another number.
int designs()
{
    const int asked = qEnvironmentVariableIntValue("HYGROLOOM_EXTREMES");
    return asked > 0 ? asked : 130;
}
// Steps get longer and cheaper with fewer particles; with those of a draft some drops would take millions of steps.
const KnobSettings few_particles{{"particles_per_droplet", 100}};

ForcedParts random_parts(int index)
{
    Dice dice(index + 1000000); // of their own
    ForcedParts forced;
    if (dice.chance(0.4)) return forced;
    const bool all = dice.chance(0.5);
    for (const char* part : {"wicking", "sorption", "vapour", "heat"})
        if (all || dice.chance(0.4)) forced[part] = all || dice.chance(0.5);
    return forced;
}

double moved_water(const Ledger& l) { return l.water_delivered + l.water_initial + std::abs(l.water_evaporated) + l.water_bound; }
double moved_heat(const Ledger& l)
{
    return std::abs(l.energy_released) + std::abs(l.energy_lost) + std::abs(l.energy_delivered) + std::abs(l.energy_stored);
}
/// What the cloth holds per kelvin, J/K.
double heat_capacity_of(const Scene& scene, const Ledger& l)
{
    double capacity = (l.water_liquid + l.water_bound) * water_specific_heat;
    for (std::size_t i = 0; i < scene.cloth.length.size(); ++i) {
        const int segment = static_cast<int>(i);
        const int line = segment < scene.cloth.crossings() ? segment / scene.cloth.picks
                                                           : scene.cloth.ends + (segment - scene.cloth.crossings()) / scene.cloth.ends;
        capacity += heat_capacity(scene.cloth.yarns[scene.cloth.type[static_cast<std::size_t>(line)]], scene.cloth.length[i], 0);
    }
    return capacity;
}
/// By how much the temperatures of the start and of the air differ, K.
double swing(const Scene& scene)
{
    double lowest = std::min(0.0, scene.cloth.start.warmth), highest = std::max(0.0, scene.cloth.start.warmth);
    for (const AirMoment& air : scene.climate.course) {
        lowest = std::min(lowest, air.air_warmth);
        highest = std::max(highest, air.air_warmth);
    }
    return highest - lowest;
}
/// What may be missing of the energy: a billionth of what was moved, also of what has come and gone with the climate, and what the cloth's
/// heat content is rounded to.
double negligible_heat(const Scene& scene, const Ledger& l)
{
    const double capacity = heat_capacity_of(scene, l);
    return 1e-9 * (moved_heat(l) + capacity * swing(scene)) + std::numeric_limits<double>::epsilon() * capacity * scene.climate.temperature;
}

/// The most a fibre of any of the scene's yarns can bind at any temperature.
double most_regain(const Scene& scene)
{
    double most = 0;
    for (const YarnParameters& yarn : scene.cloth.yarns)
        for (double temperature = 233; temperature < 400; temperature += 1)
            most = std::max(most, equilibrium_regain(yarn.isotherm, 1.0, temperature));
    return most;
}

/// What is wrong with what the room between the yarns holds, in words; each yarn's segment shows its share of a crossing's.
std::string complaint_of_rooms(const Scene& scene, const Frame& frame)
{
    const Yarns yarns = yarns_of(scene);
    const std::size_t ends = static_cast<std::size_t>(scene.cloth.ends), picks = static_cast<std::size_t>(scene.cloth.picks);
    for (std::size_t crossing = 0; crossing < ends * picks; ++crossing) {
        const std::size_t end = crossing / picks, pick = crossing % picks;
        const float at_warp = frame.between[crossing], at_weft = frame.between[ends * picks + pick * ends + end];
        const double volume = yarns.crossing_at(static_cast<int>(end), static_cast<int>(pick)).between.volume;
        const double most = scene.cloth.by_suction ? scene.climate.density * volume * 1.000001 : 0.0;
        if (!(at_warp >= 0 && at_weft >= 0 && static_cast<double>(at_warp) + static_cast<double>(at_weft) <= most))
            return fmt::format("{} and {} kg in the room of crossing {}, which holds {} kg", at_warp, at_weft, crossing, most);
    }
    return {};
}

/// What is wrong with a frame, in words; empty when nothing is.
std::string complaint(const Scene& scene, const Frame& frame, double most)
{
    const Ledger& l = frame.ledger;
    if (!(std::abs(l.water_imbalance()) <= 1e-9 * moved_water(l) + water_quantum))
        return fmt::format("water off by {} of {} kg", l.water_imbalance(), moved_water(l));
    if (!(std::abs(l.energy_imbalance()) <= negligible_heat(scene, l)))
        return fmt::format("energy off by {} of {} J", l.energy_imbalance(), moved_heat(l));
    for (std::size_t i = 0; i < frame.saturation.size(); ++i) {
        if (!(frame.saturation[i] >= 0 && frame.saturation[i] <= 1.000001f))
            return fmt::format("saturation {} of segment {}", frame.saturation[i], i);
        if (!(frame.liquid[i] >= 0)) return fmt::format("liquid {} of segment {}", frame.liquid[i], i);
        if (!(frame.regain[i] >= 0 && frame.regain[i] <= most + 1e-6)) return fmt::format("regain {} of segment {}", frame.regain[i], i);
        if (!(frame.temperature[i] > 233 && frame.temperature[i] < 393))
            return fmt::format("temperature {} K of segment {}", frame.temperature[i], i);
        if (!(frame.vapour[i] >= 0 && std::isfinite(frame.vapour[i]))) return fmt::format("vapour {} of segment {}", frame.vapour[i], i);
        const double saturated = saturation_concentration(static_cast<double>(frame.temperature[i]));
        const double at_first = !scene.rules.vapour || frame.time > 0
                                    ? 1
                                    : std::max({1.0, scene.cloth.start.humidity, scene.climate.humidity}); // has not condensed yet
        if (!(frame.vapour[i] <= 1.00001 * at_first * saturated))
            return fmt::format("vapour {} over saturation {} of segment {}", frame.vapour[i], saturated, i);
    }
    for (const auto& x : frame.positions)
        for (float value : x)
            if (!std::isfinite(value)) return "a particle is nowhere";
    return complaint_of_rooms(scene, frame);
}

} // namespace

class TestExtremes : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void anyDesignStaysBalancedAndBounded_data()
    {
        QTest::addColumn<int>("first");
        QTest::addColumn<int>("end");
        for (int first = 0; first < designs(); first += chunk_size)
            QTest::addRow("from %d", first) << first << std::min(first + chunk_size, designs());
        // A line of pores pressed by a pool; one by its emptying curve; fibres of 1 nm that take liquid without vapour.
        for (int once_broken : {1076, 2852, 2942}) QTest::addRow("%d", once_broken) << once_broken << once_broken + 1;
    }
    void anyDesignStaysBalancedAndBounded()
    {
        QFETCH(int, first);
        QFETCH(int, end);
        int wrong = 0;
        for (int index = first; index < end; ++index) {
            const std::string what = run(index);
            if (!what.empty()) qWarning("%s", what.c_str());
            wrong += !what.empty();
        }
        QCOMPARE(wrong, 0);
    }
    void cleanupTestCase()
    {
        for (const auto& [what, count] : covered_) qInfo("%4d %s", count, what.c_str());
        if (covered_["run"] + covered_["refused"] >= designs()) QVERIFY2(covered_["run"] >= 5 * designs() / 7, "too few designs are valid");
    }

private:
    /// Runs one design; what is wrong with it, with the project to run it again.
    std::string run(int index)
    {
        double simulated = 0;
        const Design design = random_design(index, simulated);
        const auto tell = [&](const std::string& what) { return fmt::format("design {}: {}\n{}", index, what, format_project(design)); };
        for (const Issue& issue : validate(design))
            if (issue.severity == Severity::error) {
                ++covered_["refused"];
                ++covered_["refused: " + issue.code];
                return {};
            }
        const Experiment& experiment = design.experiments[0];
        CpuSolver solver;
        Scene scene;
        try {
            const ModelPlan plan = plan_run(design, design.fabrics[0], experiment, Fidelity::draft, random_parts(index), few_particles);
            scene = build_scene(design, build_textile(design, design.fabrics[0], plan.region), experiment, plan, 1);
            if (plan.crossings_per_cell > 1) scene = coarsened(scene, plan.bundling());
            solver.load(scene);
        } catch (const std::exception& error) {
            if (std::string(error.what()).find("of water at most") != std::string::npos) return {}; // refused, with what fits
            return tell(error.what());
        }
        const auto start = std::chrono::steady_clock::now();
        const double most = most_regain(scene);
        std::string wrong = complaint(scene, solver.frame(), most);
        for (double share : {1e-3, 0.01, 0.1, 0.3, 0.6, 1.0}) {
            double reached = 0;
            while (reached < share * simulated) reached = solver.advance(share * simulated, 0.05);
            if (wrong.empty()) wrong = complaint(scene, solver.frame(), most);
            if (!wrong.empty()) return tell(fmt::format("{} at {} s", wrong, reached));
        }
        const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        if (wall > 5) qInfo("design %d took %.1f s", index, wall);
        cover(design, scene, simulated);
        return {};
    }

    void cover(const Design& design, const Scene& scene, double simulated)
    {
        const Experiment& e = design.experiments[0];
        ++covered_["run"];
        ++covered_[std::string("type ") + name_of(e.type)];
        ++covered_[std::string("closure ") + name_of(e.closure)];
        ++covered_[simulated > longest_of_most ? "long runs" : simulated < 1e-5 ? "runs of 1 us" : "runs of up to 5 s"];
        covered_["a single end or pick"] += scene.cloth.ends == 1 || scene.cloth.picks == 1;
        covered_["contact angle 0"] += design.fabrics[0].contact_angle_deg.value_or(1) < 1e-5;
        covered_["contact angle 90 or more"] += design.fabrics[0].contact_angle_deg.value_or(0) >= 90;
        covered_["humidity 0"] += e.climate.relative_humidity == 0;
        covered_["humidity 100 %"] += e.climate.relative_humidity == 1;
        covered_["humidity over 100 %"] += e.climate.relative_humidity > 1;
        covered_["fibres of their own"] += !design.materials.empty();
        covered_["hairs"] += design.fabrics[0].flyaway.hair_density_per_mm > 0;
        covered_["other weaves than plain"] += design.fabrics[0].weave.ends() > 2;
        covered_["plied yarns"] += design.fabrics[0].warp.plies > 1;
        covered_["yarns that touch"] += !scene.cloth.touching.empty();
        covered_["a course of the climate"] += !e.climates.empty();
        covered_["swelling"] += e.swelling;
        for (const char* part : {"wicking", "sorption", "vapour", "heat"})
            covered_[std::string("with ") + part] += part[0] == 'w'   ? scene.rules.wicking
                                                     : part[0] == 's' ? scene.rules.sorption
                                                     : part[0] == 'v' ? scene.rules.vapour
                                                                      : scene.rules.heat;
    }

    std::map<std::string, int> covered_;
};

} // namespace tst_extremes

QTEST_APPLESS_MAIN(tst_extremes::TestExtremes)
#include "tst_extremes.moc"
