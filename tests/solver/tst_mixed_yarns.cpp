// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Runs on cloths whose ends or picks are of different yarns: each yarn answers for itself, and no water is lost between them.
#include "core/run/plan_run.h"
#include "core/verify/set_ups.h"
#include "tests/support/drop_design.h"
#include "tests/support/run.h"

#include <QTest>

using namespace hygroloom;

namespace {

/// Cotton with a finish that water runs off.
Material waxed_cotton()
{
    Material material = *find_library_material("cotton");
    material.name = "waxed cotton";
    material.based_on = "cotton";
    material.contact_angle_deg = 110;
    return material;
}

/// The drop's cloth with each fibre's own contact angle; yarn 1 is the fabric's warp of another fibre.
Design two_fibres(const std::string& first, const std::string& second, double duration)
{
    Design design = drop_design(0, duration);
    design.materials.push_back(waxed_cotton());
    Fabric& fabric = design.fabrics[0];
    fabric.contact_angle_deg.reset();
    fabric.warp.material = fabric.weft.material = {{first, 1.0}};
    fabric.extra_yarns.push_back(fabric.warp);
    fabric.extra_yarns[0].material = {{second, 1.0}};
    return design;
}

/// A stripe of 8 cotton ends under the drop in a waxed cloth, 28 ends wide.
Design cotton_stripe_in_wax(double duration)
{
    Design design = two_fibres("waxed cotton", "cotton", duration);
    design.fabrics[0].warp_order = {{0, 10}, {1, 8}, {0, 10}};
    design.experiments[0].closure = Closure::pores; // the closure paper gives wax the angle of cotton
    return design;
}

Design cotton_and_polyester_checks(double duration)
{
    Design design = two_fibres("cotton", "polyester", duration);
    design.fabrics[0].warp_order = {{0, 3}, {1, 2}};
    design.fabrics[0].weft_order = {{1, 1}, {0, 2}};
    return design;
}

std::vector<Frame> run(const Design& design, int threads = 0, const ForcedParts& forced = {})
{
    RunOptions options = draft(forced, {{"particles_per_droplet", 300}}); // what is checked does not depend on how fine a drop is
    options.threads = threads;
    return run(design, options).frames;
}

Textile textile_of(const Design& design)
{
    const auto& sample = design.experiments[0].sample_mm;
    return build_textile(design, design.fabrics[0], region_of_sample(design.fabrics[0], sample[0], sample[1]));
}

void compare_all(const std::vector<Frame>& a, const std::vector<Frame>& b)
{
    QCOMPARE(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
        QCOMPARE(a[k].saturation, b[k].saturation);
        QCOMPARE(a[k].liquid, b[k].liquid);
        QCOMPARE(a[k].regain, b[k].regain);
        QCOMPARE(a[k].vapour, b[k].vapour);
        QCOMPARE(a[k].temperature, b[k].temperature);
        QVERIFY(a[k].positions == b[k].positions);
        QCOMPARE(a[k].ledger.water_bound, b[k].ledger.water_bound);
        QCOMPARE(a[k].ledger.energy_released, b[k].ledger.energy_released);
        QCOMPARE(a[k].water_top, b[k].water_top);
    }
}

} // namespace

class TestMixedYarns : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// Stripes of S and Z twist are yarns of two types to the textile; to water they are one.
    void endsThatDifferInTwistAloneChangeNothing()
    {
        Design striped = drop_design(35, 0.2);
        Fabric& fabric = striped.fabrics[0];
        fabric.weave = weave_from_pattern("twill 2/1 Z");
        const Design plain = striped;
        fabric.extra_yarns.push_back(fabric.warp);
        fabric.extra_yarns[0].twist_direction = TwistDirection::s;
        fabric.warp_order = {{0, 2}, {1, 3}};
        fabric.weft_order = {{0, 1}, {1, 1}};
        QCOMPARE(int(textile_of(striped).warp.types.size()), 2);
        QCOMPARE(int(textile_of(striped).weft.types.size()), 2);
        compare_all(run(striped, 0, {{"vapour", true}}), run(plain, 0, {{"vapour", true}}));
    }
    void ledgersCloseAndContentsStayInBounds_data()
    {
        QTest::addColumn<bool>("waxed");
        QTest::newRow("cotton stripe in wax") << true;
        QTest::newRow("cotton and polyester checks") << false;
    }
    void ledgersCloseAndContentsStayInBounds()
    {
        QFETCH(bool, waxed);
        const std::vector<Frame> frames = run(waxed ? cotton_stripe_in_wax(0.2) : cotton_and_polyester_checks(0.2), 0,
                                              {{"vapour", true}, {"heat", true}, {"sorption", true}});
        for (const Frame& f : frames) {
            QVERIFY(std::abs(f.ledger.water_imbalance()) <= 1e-9 * 2e-6);
            for (std::size_t i = 0; i < f.saturation.size(); ++i) {
                QVERIFY(f.saturation[i] >= 0 && f.saturation[i] <= 1.000001f);
                QVERIFY(f.regain[i] >= 0 && f.regain[i] <= 0.2401f);
                QVERIFY(f.vapour[i] >= 0 && std::isfinite(f.vapour[i]) && std::isfinite(f.temperature[i]));
            }
        }
        const Ledger& end = frames.back().ledger;
        QVERIFY(end.water_liquid > 0.1 * end.water_delivered);
        QVERIFY(end.energy_released != 0);
        QVERIFY(std::abs(end.energy_imbalance()) < 1e-9 * (std::abs(end.energy_released) + std::abs(end.energy_lost)));
    }
    void waterRunsAlongTheStripeThatWicks()
    {
        const Design design = cotton_stripe_in_wax(0.5);
        const Textile textile = textile_of(design);
        const Frame end = run(design).back();
        double along = 0, across = 0, total = 0;
        for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
            for (int e = 0; e < textile.ends(); ++e)
                for (int p = 0; p < textile.picks(); ++p) {
                    const double liquid = static_cast<double>(end.liquid[static_cast<std::size_t>(textile.segment(kind, e, p))]);
                    if (kind == YarnKind::weft || e < 10 || e >= 18) QCOMPARE(liquid, 0.0);
                    total += liquid;
                    across += liquid * textile.x_of_end(e) * textile.x_of_end(e);
                    along += liquid * textile.y_of_pick(p) * textile.y_of_pick(p);
                }
        QVERIFY(total > 0.2 * end.ledger.water_delivered);
        QVERIFY2(along > 4 * across, qPrintable(QString("%1 %2").arg(1e3 * std::sqrt(along / total)).arg(1e3 * std::sqrt(across / total))));
    }
    void symmetricStripesStaySymmetric()
    {
        Design design = two_fibres("cotton", "polyester", 1);
        design.fabrics[0].warp_order = design.fabrics[0].weft_order = {{0, 8}, {1, 5}, {0, 8}};
        const Textile textile = build_textile(design, design.fabrics[0], {0, 0, 21, 21});
        const ModelPlan plan = plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::draft,
                                        {{"liquid", false}, {"wicking", true}, {"sorption", true}, {"vapour", true}, {"heat", true}});
        Scene scene = build_scene(design, textile, design.experiments[0], plan, 1);
        scene.cloth.start.liquid.assign(static_cast<std::size_t>(scene.cloth.segments()), 0.0);
        for (int e = 6; e < 15; ++e)
            for (int p = 6; p < 15; ++p) scene.cloth.start.liquid[static_cast<std::size_t>(textile.segment(YarnKind::warp, e, p))] = 2e-9;
        const auto backend = make_cpu_backend();
        const Frame end = frames_at(*backend, scene, {0.5}).back();
        const auto apart = [&](const std::vector<float>& field, YarnKind kind, int e, int p, int e2, int p2) {
            return std::abs(field[static_cast<std::size_t>(textile.segment(kind, e, p))] -
                            field[static_cast<std::size_t>(textile.segment(kind, e2, p2))]);
        };
        for (const auto* field : {&end.saturation, &end.regain, &end.vapour, &end.temperature}) {
            // Only the direction of the eliminations distinguishes left from right: rounding of doubles, seen through floats.
            const float rounding = 2e-6f * *std::max_element(field->begin(), field->end());
            for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
                for (int e = 0; e < 21; ++e)
                    for (int p = 0; p < 21; ++p) {
                        QVERIFY(apart(*field, kind, e, p, 20 - e, p) <= rounding);
                        QVERIFY(apart(*field, kind, e, p, e, 20 - p) <= rounding);
                    }
        }
        // The stripes do show: next to the border, polyester holds another regain than cotton.
        QVERIFY(apart(end.regain, YarnKind::warp, 7, 3, 8, 3) > 0.01f);
    }
    void threadsDoNotChangeAByte() { compare_all(run(cotton_and_polyester_checks(0.2), 1), run(cotton_and_polyester_checks(0.2), 0)); }
};

QTEST_APPLESS_MAIN(TestMixedYarns)
#include "tst_mixed_yarns.moc"
