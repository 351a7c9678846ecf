// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Cloth simulated in bundles of yarns: it holds as much, answers as the single yarns do, and is shown yarn by yarn.
#include "core/base/error.h"
#include "core/plan/bundles.h"
#include "core/run/plan_run.h"
#include "core/run/recording.h"
#include "core/scene/coarse_scene.h"
#include "tests/support/device.h"
#include "tests/support/run.h"
#include "tests/support/spot_design.h"

#include <QTemporaryDir>
#include <QTest>

#include <numeric>

using namespace hygroloom;

namespace {

/// Cotton of unequal setts, whose numbers of ends and picks few numbers divide, in one experiment named "drop".
Design small(ExperimentType type, double duration)
{
    Design design = drop_design();
    design.fabrics[0].picks_per_cm = 0.8 * design.fabrics[0].ends_per_cm;
    Experiment experiment = standard_experiment(type);
    experiment.name = "drop";
    experiment.closure = Closure::paper;
    experiment.drop_ul = 0;
    experiment.sample_mm = {9.6, 7};
    experiment.duration_s = duration;
    design.experiments = {experiment};
    return design;
}

Scene scene_of(const Design& design)
{
    const Experiment& experiment = design.experiments[0];
    const ModelPlan plan = plan_run(design, design.fabrics[0], experiment, Fidelity::draft);
    return build_scene(design, build_textile(design, design.fabrics[0], plan.region), experiment, plan, 1);
}

ModelPlan plan_in_bundles(const Design& design, double of)
{
    return plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::draft, {},
                    {{"crossings_per_cell", of}, {"crossings_per_even_cell", 1}});
}

RunOptions in_bundles(double of) { return draft({}, {{"crossings_per_cell", of}, {"crossings_per_even_cell", 1}}); }

/// visit(segment, its yarn, the yarn it crosses)
template <typename Visit> void each_segment(const Scene& scene, const Visit& visit)
{
    const auto ends = static_cast<std::size_t>(scene.cloth.ends), picks = static_cast<std::size_t>(scene.cloth.picks);
    for (std::size_t end = 0; end < ends; ++end)
        for (std::size_t pick = 0; pick < picks; ++pick) {
            const YarnParameters &warp = scene.cloth.yarns[scene.cloth.type[end]], &weft = scene.cloth.yarns[scene.cloth.type[ends + pick]];
            visit(end * picks + pick, warp, weft);
            visit(ends * picks + pick * ends + end, weft, warp);
        }
}

std::size_t crossing_of(const Scene& scene, std::size_t segment)
{
    const auto crossings = static_cast<std::size_t>(scene.cloth.crossings()), ends = static_cast<std::size_t>(scene.cloth.ends);
    if (segment < crossings) return segment;
    return (segment - crossings) % ends * static_cast<std::size_t>(scene.cloth.picks) + (segment - crossings) / ends;
}

/// What a scene has in all; of the faces, the part that absorbs.
struct Totals {
    double face = 0, pores = 0, fibres = 0, liquid = 0, bound = 0, top = 0, bottom = 0, width = 0, height = 0, fed = 0;
};
Totals totals(const Scene& scene)
{
    Totals t;
    t.face = scene.cloth.cell_area * scene.cloth.crossings();
    t.width = scene.cloth.warp_pitch * scene.cloth.ends;
    t.height = scene.cloth.weft_pitch * scene.cloth.picks;
    each_segment(scene, [&](std::size_t i, const YarnParameters& yarn, const YarnParameters&) {
        const double fibres = yarn.fibre_area * scene.cloth.length[i] * yarn.fibre_density;
        t.pores += scene.cloth.pores.empty() ? yarn.pore_area * scene.cloth.length[i] : scene.cloth.pores[i];
        t.fibres += fibres;
        t.bound += fibres * yarn.initial_regain;
        const std::size_t crossing = crossing_of(scene, i);
        const double warp =
            scene.cloth.warp_up_share.empty() ? scene.cloth.warp_up[crossing] : static_cast<double>(scene.cloth.warp_up_share[crossing]);
        const bool is_warp = i < static_cast<std::size_t>(scene.cloth.crossings());
        t.top += yarn.face_area * (is_warp ? warp : 1 - warp);
        t.bottom += yarn.face_area * (is_warp ? 1 - warp : warp);
        if (!scene.cloth.start.liquid.empty()) t.liquid += scene.cloth.start.liquid[i];
        if (!scene.supply.fed.empty() && scene.supply.fed[i] != 0) t.fed += yarn.pore_area * scene.cloth.length[i];
    });
    return t;
}

bool alike(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance * std::abs(b); }

/// Root mean square distance of the liquid from the sample's middle, m.
double reach_of(const Scene& fine, const Frame& frame)
{
    double water = 0, moment = 0;
    for (int end = 0; end < fine.cloth.ends; ++end)
        for (int pick = 0; pick < fine.cloth.picks; ++pick) {
            const double x = (end - 0.5 * (fine.cloth.ends - 1)) * fine.cloth.warp_pitch,
                         y = (pick - 0.5 * (fine.cloth.picks - 1)) * fine.cloth.weft_pitch;
            for (int i : {end * fine.cloth.picks + pick, fine.cloth.crossings() + pick * fine.cloth.ends + end}) {
                const auto liquid = static_cast<double>(frame.liquid[static_cast<std::size_t>(i)]);
                water += liquid;
                moment += liquid * (x * x + y * y);
            }
        }
    return std::sqrt(moment / water);
}

/// Advances a scene in bundles and shows it as the single yarns.
std::vector<Frame> frames_in_bundles(const Scene& fine, int of, const std::vector<double>& times)
{
    const auto backend = make_cpu_backend();
    if (of == 1) return frames_at(*backend, fine, times);
    const Scene coarse = coarsened(fine, {of});
    std::vector<Frame> frames;
    for (Frame& frame : frames_at(*backend, coarse, times)) frames.push_back(refined(std::move(frame), coarse, fine, {of}));
    return frames;
}

/// A device that fails when it is asked for its frame for so many times.
class FailingBackend : public Device {
public:
    explicit FailingBackend(int fails_at) : left_(fails_at) {}
    Frame frame() override
    {
        if (--left_ == 0) throw DeviceError("The device failed.");
        return cpu_->frame();
    }

private:
    int left_;
};

void rows_of_bundles(std::initializer_list<int> sizes)
{
    QTest::addColumn<int>("of");
    for (int of : sizes) QTest::addRow("%d", of) << of;
}

} // namespace

class TestCoarseScene : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// Outer bundles that have more, or fewer, yarns than they stand for hold what those hold, and give it back to them.
    void theEdgesOfWholeBundlesHoldWhatIsThere()
    {
        Design design = small(ExperimentType::drying, 60);
        design.experiments[0].initial_water_g_m2 = 90;
        design.experiments[0].sample_mm = {29, 24}; // 100 by 66
        const Scene fine = scene_of(design);
        const Bundling four{4, true};
        const Bundles ends = bundles_of(fine.cloth.ends, four);
        QVERIFY(ends.size() == 4 && ends.held(0) != 4);
        const Scene coarse = coarsened(fine, four);
        const Totals a = totals(coarse), b = totals(fine);
        QVERIFY(b.liquid > 0 && b.bound > 0);
        for (double Totals::*total : {&Totals::pores, &Totals::fibres, &Totals::liquid, &Totals::bound})
            QVERIFY2(alike(a.*total, b.*total, 1e-12), qPrintable(QString("%1 %2").arg(a.*total, 0, 'g', 17).arg(b.*total, 0, 'g', 17)));
        for (float share : coarse.cloth.warp_up_share) QCOMPARE(share, 0.5f); // plain weave
        const auto backend = make_cpu_backend();
        backend->load(coarse);
        const Frame cells = backend->frame(), yarns = refined(cells, coarse, fine, four);
        const auto sum = [](const std::vector<float>& values) { return std::accumulate(values.begin(), values.end(), 0.0); };
        QCOMPARE(yarns.liquid.size(), static_cast<std::size_t>(fine.cloth.segments()));
        QVERIFY(sum(cells.liquid) > 0 && alike(sum(yarns.liquid), sum(cells.liquid), 1e-6));
    }
    void aCoarseClothHoldsAsMuch_data() { rows_of_bundles({1, 2, 3, 4, 5, 8}); }
    void aCoarseClothHoldsAsMuch()
    {
        QFETCH(int, of);
        Design design = small(ExperimentType::drying, 60);
        design.experiments[0].initial_water_g_m2 = 90;
        design.fabrics[0].weave = weave_from_pattern("twill 2/1"); // segments of several lengths
        for (bool own_pores : {false, true}) {
            Scene fine = scene_of(design);
            if (own_pores)
                for (int i = 0; i < fine.cloth.segments(); ++i) fine.cloth.pores.push_back(1e-12 * (1 + i % 7));
            QVERIFY(*std::max_element(fine.cloth.length.begin(), fine.cloth.length.end()) >
                    1.001 * *std::min_element(fine.cloth.length.begin(), fine.cloth.length.end()));
            const Scene coarse = coarsened(fine, {of});
            QCOMPARE(coarse.cloth.ends, bundles_of(fine.cloth.ends, {of}).count);
            QCOMPARE(coarse.cloth.type.size(), static_cast<std::size_t>(coarse.cloth.ends + coarse.cloth.picks));
            QCOMPARE(coarse.cloth.length.size(), static_cast<std::size_t>(coarse.cloth.segments()));
            QCOMPARE(coarse.cloth.warp_up.size(), static_cast<std::size_t>(coarse.cloth.crossings()));
            const Totals a = totals(coarse), b = totals(fine);
            QVERIFY(b.liquid > 0 && b.bound > 0);
            for (double Totals::*total :
                 {&Totals::face, &Totals::pores, &Totals::fibres, &Totals::liquid, &Totals::bound, &Totals::width, &Totals::height})
                QVERIFY2(alike(a.*total, b.*total, 1e-12),
                         qPrintable(QString("%1 %2").arg(a.*total, 0, 'g', 17).arg(b.*total, 0, 'g', 17)));
            for (double Totals::*total : {&Totals::top, &Totals::bottom}) QVERIFY(alike(a.*total, b.*total, 1e-7)); // shares are floats
        }
    }
    void theFineClothHasNumbersThatFewDivide() // or the claim above would be about whole bundles only
    {
        const Scene fine = scene_of(small(ExperimentType::drying, 60));
        for (int of : {3, 4, 8}) QVERIFY2(fine.cloth.ends % of != 0 || fine.cloth.picks % of != 0, qPrintable(QString::number(of)));
    }
    void aBundleConductsAsItsYarnsSideBySide()
    {
        Design design = small(ExperimentType::drying, 60);
        design.experiments[0].sample_mm = {8, 10}; // 28 ends and picks
        const Scene fine = scene_of(design), coarse = coarsened(fine, {2});
        QCOMPARE(fine.cloth.ends, 2 * coarse.cloth.ends);
        QCOMPARE(fine.cloth.picks, 2 * coarse.cloth.picks);
        for (std::size_t k = 0; k < fine.cloth.crossing.size(); ++k) {
            QCOMPARE(coarse.cloth.crossing[k].liquid_conductance, 4 * fine.cloth.crossing[k].liquid_conductance);
            QCOMPARE(coarse.cloth.crossing[k].heat_conductance, 4 * fine.cloth.crossing[k].heat_conductance);
            QCOMPARE(coarse.cloth.crossing[k].vapour_conductance, 4 * fine.cloth.crossing[k].vapour_conductance);
        }
        for (std::size_t k = 0; k < fine.cloth.yarns.size(); ++k) { // twice as thick, twice as long; per metre and yarn what it was
            QCOMPARE(coarse.cloth.yarns[k].pore_area, 2 * fine.cloth.yarns[k].pore_area);
            QCOMPARE(coarse.cloth.yarns[k].open_vapour, 2 * fine.cloth.yarns[k].open_vapour);
            QCOMPARE(coarse.cloth.yarns[k].face_area, 4 * fine.cloth.yarns[k].face_area);
            QCOMPARE(coarse.cloth.yarns[k].intake_flux, fine.cloth.yarns[k].intake_flux);
            QCOMPARE(coarse.cloth.yarns[k].suction_radius, fine.cloth.yarns[k].suction_radius);
            QCOMPARE(coarse.cloth.yarns[k].liquid_diffusivity, fine.cloth.yarns[k].liquid_diffusivity);
        }
        QVERIFY(alike(coarse.cloth.length[0], 2 * fine.cloth.length[0], 1e-12));
        for (float share : coarse.cloth.warp_up_share) QCOMPARE(share, 0.5f); // plain weave
    }
    void aStripHangsAboutAsDeep_data() { rows_of_bundles({2, 3, 4, 8}); }
    void aStripHangsAboutAsDeep()
    {
        QFETCH(int, of);
        Design design = small(ExperimentType::vertical_wicking, 1);
        design.experiments[0].sample_mm = {4, 40};
        for (double immersion : {0.2, 3.0}) {
            design.experiments[0].immersion_mm = immersion;
            const Scene fine = scene_of(design), coarse = coarsened(fine, {of});
            const double row = totals(coarse).pores / coarse.cloth.picks;
            const double fed = totals(coarse).fed, wanted = totals(fine).fed;
            QVERIFY2(fed > 0 && std::abs(fed - wanted) <= std::max(0.5 * row, row - wanted) * (1 + 1e-9),
                     qPrintable(QString("%1 %2").arg(fed / row).arg(wanted / row)));
        }
    }
    void evenClothTakesTheSameCourse_data()
    {
        QTest::addColumn<int>("type");
        QTest::addColumn<int>("of");
        for (int of : {2, 3, 4}) {
            QTest::addRow("drying, %d", of) << static_cast<int>(ExperimentType::drying) << of;
            QTest::addRow("conditioning, %d", of) << static_cast<int>(ExperimentType::conditioning) << of;
        }
    }
    /// With its edges closed each cell of an even cloth goes through the same equations as each segment, all masses times as large; what
    /// differs is where the iterations of a step stop (1e-8) and how frames round (6e-8). Open edges can make at most the difference that
    /// they make at all.
    void evenClothTakesTheSameCourse()
    {
        QFETCH(int, type);
        QFETCH(int, of);
        const double duration = type == static_cast<int>(ExperimentType::drying) ? 1500 : 900;
        const Design design = small(static_cast<ExperimentType>(type), duration);
        const std::vector<double> times{0.2 * duration, 0.6 * duration, duration};
        double open_evaporated[2] = {};
        for (bool closed : {true, false}) {
            Scene fine = scene_of(design);
            fine.cloth.face_only = closed;
            fine.rules.step_error = 0; // the same steps, or what their lengths do would show, which follow their error
            fine.rules.network_step = fine.rules.calm_network_step = 2;
            fine.rules.step_share = 0;
            fine.rules.saturation_change = 1;
            const std::vector<Frame> single = frames_in_bundles(fine, 1, times), bundled = frames_in_bundles(fine, of, times);
            for (std::size_t k = 0; k < times.size(); ++k) {
                const Ledger &a = bundled[k].ledger, &b = single[k].ledger;
                QVERIFY(alike(a.water_initial, b.water_initial, 1e-12));
                QVERIFY(std::abs(a.water_imbalance()) <= 1e-9 * (std::abs(b.water_evaporated) + b.water_initial));
                open_evaporated[closed] = b.water_evaporated;
                if (!closed) continue;
                QVERIFY2(alike(a.water_evaporated, b.water_evaporated, 1e-5),
                         qPrintable(QString("%1 %2").arg(a.water_evaporated).arg(b.water_evaporated)));
                for (std::size_t i = 0; i < single[k].regain.size(); ++i) {
                    QVERIFY(std::abs(bundled[k].saturation[i] - single[k].saturation[i]) <= 1e-5f);
                    QVERIFY(std::abs(bundled[k].regain[i] - single[k].regain[i]) <= 1e-6f);
                    QVERIFY(std::abs(bundled[k].temperature[i] - single[k].temperature[i]) <= 1e-3f);
                }
            }
            if (!closed) {
                const double differs = std::abs(bundled.back().ledger.water_evaporated - open_evaporated[0]),
                             edges = std::abs(open_evaporated[0] - open_evaporated[1]);
                qInfo("of %.4g mg: in bundles %.2g more or less, edges make %.2g", 1e6 * open_evaporated[0], 1e6 * differs, 1e6 * edges);
                QVERIFY(differs < edges);
            }
        }
    }
    void aSpotSpreadsAsFarAndTheMoreSoTheFinerTheCells()
    {
        const Design design = spot_design("cotton", 0.3, 2);
        const Scene fine = scene_of(design);
        std::vector<double> reaches, bound;
        for (int of : {1, 2, 4}) {
            const Frame end = frames_in_bundles(fine, of, {2})[0];
            reaches.push_back(reach_of(fine, end));
            bound.push_back(end.ledger.water_bound);
            qInfo("in bundles of %d: reach %.4g mm, %.4g mg in fibres, %.4g mg evaporated", of, 1e3 * reaches.back(), 1e6 * bound.back(),
                  1e6 * end.ledger.water_evaporated);
        }
        const double two = std::abs(reaches[1] / reaches[0] - 1), four = std::abs(reaches[2] / reaches[0] - 1);
        QVERIFY2(two < 0.03, qPrintable(QString::number(two)));
        QVERIFY2(two < four && four < 0.1, qPrintable(QString("%1 %2").arg(two).arg(four)));
        QVERIFY(alike(bound[1], bound[0], 0.03));
    }
    void aStripWicksAsHigh_data() { rows_of_bundles({2, 3, 4}); }
    void aStripWicksAsHigh() // but for where in its cell the water line and the front stand: half a cell each
    {
        QFETCH(int, of);
        Design design = small(ExperimentType::vertical_wicking, 20);
        design.experiments[0].sample_mm = {3, 40};
        const Run single = run(design, in_bundles(1)), bundled = run(design, in_bundles(of));
        const double cell = of * 1e-2 / design.fabrics[0].picks_per_cm;
        const double high = single.metrics.wicking->height, found = bundled.metrics.wicking->height;
        qInfo("%.4g mm and in bundles %.4g mm, cells of %.3g mm", 1e3 * high, 1e3 * found, 1e3 * cell);
        QVERIFY(high > 5 * cell && std::abs(found - high) <= cell);
    }
    void framesShowEveryYarnAndAddUp_data() { rows_of_bundles({2, 3, 8}); }
    void framesShowEveryYarnAndAddUp()
    {
        QFETCH(int, of);
        Design design = small(ExperimentType::moisture_management, 6);
        design.experiments[0].volume_ul = 5;
        design.experiments[0].feed_s = 3;
        RunOptions options = in_bundles(of);
        options.forced = {{"sorption", true}, {"vapour", true}, {"heat", true}};
        const Run result = run(design, options);
        const Scene fine = scene_of(design);
        QCOMPARE(result.record.plan.crossings_per_cell, of);
        QCOMPARE(result.record.plan.segments, fine.cloth.segments());
        for (const Frame& frame : result.frames) {
            for (const auto* values : {&frame.saturation, &frame.liquid, &frame.regain, &frame.vapour, &frame.temperature})
                QCOMPARE(values->size(), static_cast<std::size_t>(fine.cloth.segments()));
            const Ledger& l = frame.ledger;
            QVERIFY(std::abs(l.water_imbalance()) <= 1e-9 * (l.water_delivered + l.water_initial));
            double liquid = 0, bound = 0, start = 0;
            each_segment(fine, [&](std::size_t i, const YarnParameters& yarn, const YarnParameters&) {
                const double fibres = yarn.fibre_area * yarn.fibre_density * fine.cloth.length[i];
                liquid += static_cast<double>(frame.liquid[i]);
                bound += fibres * static_cast<double>(frame.regain[i]);
                start += fibres * yarn.initial_regain;
                QVERIFY(frame.saturation[i] >= 0 && frame.saturation[i] <= 1.000001f);
            });
            QVERIFY(alike(liquid, l.water_liquid, 1e-4)); // frames are rounded
            QVERIFY(alike(bound, l.water_bound, 1e-4));
            QVERIFY(std::abs(frame.water_top + frame.water_bottom - (liquid + bound - start)) <= 1e-4 * l.water_bound);
        }
        QVERIFY(result.frames.back().ledger.water_liquid > 0.5 * result.frames.back().ledger.water_delivered);
        QVERIFY(result.frames.back().water_top > 0 && result.frames.back().water_bottom > 0);
        const Frame& start = result.frames.front(); // regain is rounded to 6e-8
        QVERIFY(std::abs(start.water_top) + std::abs(start.water_bottom) <= 1.2e-7 * start.ledger.water_bound);
    }
    void shellsAreShownToo()
    {
        Scene fine = scene_of(small(ExperimentType::conditioning, 60));
        fine.rules.shows_shells = true;
        const Frame frame = frames_in_bundles(fine, 3, {60})[0];
        const auto shells = static_cast<std::size_t>(fine.rules.fibre_shells);
        QVERIFY(shells > 1);
        QCOMPARE(frame.shells.size(), shells * static_cast<std::size_t>(fine.cloth.segments()));
        for (std::size_t i = 0; i < frame.regain.size(); ++i) {
            const auto inside = frame.shells.begin() + static_cast<std::ptrdiff_t>(i * shells),
                       outside = inside + fine.rules.fibre_shells - 1;
            QVERIFY(*inside < frame.regain[i] && frame.regain[i] < *outside); // moist air comes in from the skin
        }
    }
    void yarnsStaySingleWhereTheyDifferWithinACell_data()
    {
        QTest::addColumn<Design>("design");
        QTest::addColumn<std::string>("reason");
        QTest::newRow("drop") << drop_design() << std::string("free liquid meets single yarns.");
        QTest::newRow("sweat") << small(ExperimentType::sweat, 10) << std::string("sweat wets yarns where they lie on one face.");
    }
    void yarnsStaySingleWhereTheyDifferWithinACell()
    {
        QFETCH(Design, design);
        QFETCH(std::string, reason);
        const ModelPlan plan = plan_in_bundles(design, 2);
        QCOMPARE(plan.crossings_per_cell, 1);
        QVERIFY2(plan.resolution_reason.ends_with(
                     "Each crossing stays a cell of its own, although the fidelity would put 2 ends and picks into one: " + reason),
                 plan.resolution_reason.c_str());
        QVERIFY(plan_in_bundles(design, 1).resolution_reason.find("Each crossing stays") == std::string::npos);
    }
    void stripesAreBundledWhereNoBundleMixesThem_data()
    {
        QTest::addColumn<int>("first");
        QTest::addColumn<int>("second");
        QTest::addColumn<int>("of");
        QTest::addColumn<int>("comes_to");
        QTest::newRow("finer than a bundle") << 1 << 1 << 2 << 1;
        QTest::newRow("no multiple of a bundle") << 3 << 2 << 2 << 1;
        QTest::newRow("whole bundles") << 4 << 4 << 2 << 2;
        QTest::newRow("whole bundles of four") << 4 << 4 << 4 << 4;
    }
    void stripesAreBundledWhereNoBundleMixesThem()
    {
        QFETCH(int, first);
        QFETCH(int, second);
        QFETCH(int, of);
        QFETCH(int, comes_to);
        Design design = spot_design("cotton", 0.5, 1);
        Fabric& fabric = design.fabrics[0];
        fabric.ends_per_cm = fabric.picks_per_cm = 30; // 48 of each
        fabric.extra_yarns.push_back(fabric.warp);
        fabric.extra_yarns[0].material = {{"polyester", 1.0}};
        fabric.warp_order = {{0, first}, {1, second}};
        const ModelPlan plan = plan_in_bundles(design, of);
        QCOMPARE(plan.crossings_per_cell, comes_to);
        QCOMPARE(plan.resolution_reason.ends_with(": bundles of that size would mix different yarns."), comes_to == 1);
        if (comes_to == 1) return;
        const Scene fine = build_scene(design, build_textile(design, fabric, plan.region), design.experiments[0], plan, 1);
        const Scene coarse = coarsened(fine, {of});
        QCOMPARE(coarse.cloth.ends * of, fine.cloth.ends);
        for (int end = 0; end < fine.cloth.ends; ++end)
            QCOMPARE(coarse.cloth.type[static_cast<std::size_t>(end / of)], fine.cloth.type[static_cast<std::size_t>(end)]);
        QVERIFY(alike(totals(coarse).fibres, totals(fine).fibres, 1e-12));
    }
    void aRecordingHoldsTheKnobAndSingleYarns()
    {
        RunOptions options = in_bundles(2);
        options.recording = folder_.filePath("bundles.hygrorec").toStdString();
        const Design design = small(ExperimentType::conditioning, 60);
        const Run result = run(design, options);
        const Recording recording(options.recording);
        QCOMPARE(recording.run().plan.crossings_per_cell, 2);
        QCOMPARE(recording.run().plan.knobs.crossings_per_cell, 2.0);
        QCOMPARE(recording.frame(recording.frames() - 1).regain, result.frames.back().regain);
    }
    void aCancelledRunLeavesWhatItCameTo()
    {
        RunOptions options = in_bundles(2);
        options.recording = folder_.filePath("cancelled.hygrorec").toStdString();
        const Design design = small(ExperimentType::conditioning, 600);
        const auto backend = make_cpu_backend();
        RunControl control;
        RunCallbacks callbacks;
        std::size_t seen = 0;
        callbacks.frame = [&](std::shared_ptr<const Frame> frame) {
            ++seen;
            control.cancel = frame->time >= 30;
        };
        QVERIFY_EXCEPTION_THROWN(run_experiment(design, "cloth", "drop", options, *backend, control, callbacks), Cancelled);
        const Recording recording(options.recording);
        QCOMPARE(static_cast<std::size_t>(recording.frames()), seen);
        QCOMPARE(recording.frame(recording.frames() - 1).regain.size(), static_cast<std::size_t>(recording.run().textile.segments()));
    }
    void aRunInBundlesGoesOnOnTheCpu()
    {
        const Design design = small(ExperimentType::conditioning, 120);
        RunOptions options = in_bundles(2);
        const Run whole = run(design, options);
        options.may_go_on_on_cpu = true;
        FailingBackend failing(30);
        const Run moved = run(design, options, failing);
        QVERIFY(moved.record.device.find("; from ") != std::string::npos);
        QCOMPARE(moved.frames.size(), whole.frames.size());
        QCOMPARE(moved.frames.back().regain, whole.frames.back().regain);
        QCOMPARE(moved.frames.back().temperature, whole.frames.back().temperature);
    }
    void aStateOfBundlesGoesOnToTheSameBytes()
    {
        const Scene coarse = coarsened(scene_of(small(ExperimentType::drying, 300)), {3});
        const auto one = make_cpu_backend(), other = make_cpu_backend();
        frames_at(*one, coarse, {100});
        other->load(coarse);
        other->go_on_from(one->state());
        for (Backend* backend : {one.get(), other.get()})
            for (double reached = 100; reached < 300;) reached = backend->advance(300);
        QCOMPARE(other->frame().saturation, one->frame().saturation);
        QCOMPARE(other->frame().temperature, one->frame().temperature);
    }
    void aPartThatWasLeftOutComesOn()
    {
        const Design design = spot_design("polyester", 0.9955, 200);
        RunOptions options[2] = {in_bundles(1), in_bundles(2)};
        for (RunOptions& o : options) o.forced = {{"heat", false}}; // one part is enough
        const Run single = run(design, options[0]), bundled = run(design, options[1]);
        QCOMPARE(bundled.record.plan.crossings_per_cell, 2);
        QVERIFY(!single.record.switched_on.empty());
        QCOMPARE(bundled.record.switched_on.size(), single.record.switched_on.size());
        for (std::size_t k = 0; k < single.record.switched_on.size(); ++k) {
            const SwitchedPart &a = bundled.record.switched_on[k], &b = single.record.switched_on[k];
            qInfo("%s at %.3g s, with single yarns at %.3g s", a.name.c_str(), a.time, b.time);
            QCOMPARE(a.name, b.name);
            QVERIFY(a.kept_off.empty() && alike(a.time, b.time, 0.2));
        }
        const Ledger &a = bundled.frames.back().ledger, &b = single.frames.back().ledger;
        QVERIFY(std::abs(a.water_imbalance()) <= 1e-9 * a.water_delivered);
        QVERIFY2(alike(a.water_evaporated, b.water_evaporated, 0.1),
                 qPrintable(QString("%1 %2").arg(a.water_evaporated).arg(b.water_evaporated)));
    }

private:
    QTemporaryDir folder_;
};

QTEST_APPLESS_MAIN(TestCoarseScene)
#include "tst_coarse_scene.moc"
