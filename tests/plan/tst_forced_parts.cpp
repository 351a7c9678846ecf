// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Every decision of a plan forced both ways and compared: what it models matters more than the share that may be left out, what it leaves
// out matters less, and forcing what it decided itself changes no byte.
#include "tests/support/run.h"
#include "tests/support/spot_design.h"

#include <QTest>

using namespace hygroloom;

namespace {

/// A pool of a microlitre, on cotton or on polyester that is wetted well.
Design sample(ExperimentType type, double duration)
{
    Design design = drop_design(35);
    Experiment experiment = standard_experiment(type);
    experiment.closure = Closure::paper; // steps of pores end otherwise with each part, which matters by up to 2 %
    experiment.sample_mm = {5, 5};
    experiment.duration_s = duration;
    design.experiments = {experiment};
    return design;
}

Run run(const Design& design, const ForcedParts& forced, const KnobSettings& knobs) { return run(design, draft(forced, knobs)); }

/// kg of liquid and bound water in a segment.
double water_in(const Run& run, YarnKind kind, int end, int pick)
{
    const Textile& textile = run.record.textile;
    const YarnType& type = textile.type(kind, kind == YarnKind::warp ? end : pick);
    const auto i = static_cast<std::size_t>(textile.segment(kind, end, pick));
    const double fibres = type.area * type.packing * type.fibre.density_kg_m3 * textile.segment_length(kind, end, pick);
    return static_cast<double>(run.end().liquid[i]) + static_cast<double>(run.end().regain[i]) * fibres;
}

/// How much two runs differ, in the plan's terms: the water that is elsewhere or in another state at the end, over the water at stake, or
/// 2 % for every kelvin.
double difference(const Run& a, const Run& b)
{
    const Ledger &x = a.end().ledger, &y = b.end().ledger;
    double water = 0, warmth = 0;
    for (int end = 0; end < a.record.textile.ends(); ++end)
        for (int pick = 0; pick < a.record.textile.picks(); ++pick)
            for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
                water += 0.5 * std::abs(water_in(a, kind, end, pick) - water_in(b, kind, end, pick));
    for (double change : {x.water_delivered - y.water_delivered, x.water_free - y.water_free, x.water_liquid - y.water_liquid,
                          x.water_bound - y.water_bound, x.water_evaporated - y.water_evaporated})
        water = std::max(water, std::abs(change));
    for (std::size_t i = 0; i < a.end().temperature.size(); ++i)
        warmth = std::max(warmth, static_cast<double>(std::abs(a.end().temperature[i] - b.end().temperature[i])));
    return std::max(water / a.record.plan.water_at_stake, 0.02 * warmth);
}

} // namespace

class TestForcedParts : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aDecisionHoldsWhenForcedBothWays_data()
    {
        QTest::addColumn<Design>("design");
        QTest::addColumn<QString>("part");
        QTest::addColumn<bool>("on");
        QTest::addColumn<ForcedParts>("others");
        QTest::addColumn<double>("neglected");
        const Design cotton = spot_design("cotton", 0.65, 10);
        QTest::newRow("a drop falls") << drop_design(35, 0.1) << "liquid" << true << ForcedParts{} << 0.01;
        QTest::newRow("yarns wick") << cotton << "wicking" << true << ForcedParts{} << 0.01;
        QTest::newRow("no yarn wicks") << drop_design(120, 0.1) << "wicking" << false << ForcedParts{} << 0.01;
        QTest::newRow("cotton absorbs") << cotton << "sorption" << true << ForcedParts{} << 0.01;
        QTest::newRow("a humidity step") << sample(ExperimentType::conditioning, 600) << "sorption" << true << ForcedParts{} << 0.01;
        QTest::newRow("polyester absorbs little")
            << spot_design("polyester", 0.65, 1) << "sorption" << false << ForcedParts{{"vapour", false}} << 0.1;
        QTest::newRow("it dries") << spot_design("polyester", 0.5, 50) << "vapour" << true << ForcedParts{} << 0.01;
        QTest::newRow("a humidity step's vapour") << sample(ExperimentType::conditioning, 600) << "vapour" << true << ForcedParts{} << 0.01;
        QTest::newRow("it hardly dries") << spot_design("polyester", 0.999, 50) << "vapour" << false << ForcedParts{} << 0.01;
        QTest::newRow("fibres warm") << cotton << "heat" << true << ForcedParts{} << 0.01;
        QTest::newRow("hardly any cooling") << spot_design("polyester", 0.9955, 50) << "heat" << false << ForcedParts{{"vapour", true}}
                                            << 0.01;
        QTest::newRow("a small stain") << cotton << "growth" << true << ForcedParts{} << 0.01;
        QTest::newRow("wet all over") << sample(ExperimentType::drying, 600) << "growth" << false << ForcedParts{} << 0.01;
    }
    void aDecisionHoldsWhenForcedBothWays()
    {
        QFETCH(Design, design);
        QFETCH(QString, part);
        QFETCH(bool, on);
        QFETCH(ForcedParts, others);
        QFETCH(double, neglected);
        const KnobSettings knobs{{"neglected_share", neglected}, {"particles_per_droplet", 200}};
        const auto forced = [&](bool value) {
            ForcedParts parts = others;
            parts[part.toStdString()] = value;
            return run(design, parts, knobs);
        };
        const Run left = run(design, others, knobs), same = forced(on), other = forced(!on);
        QCOMPARE(left.record.plan.on(part.toStdString()), on);
        QCOMPARE(other.record.plan.on(part.toStdString()), !on);
        QVERIFY(left.record.switched_on.empty());
        QCOMPARE(left.end().saturation, same.end().saturation);
        QCOMPARE(left.end().regain, same.end().regain);
        QCOMPARE(left.end().temperature, same.end().temperature);
        QVERIFY(left.end().positions == same.end().positions);
        const double matters = difference(left, other);
        qInfo("matters by %.3g %%", 100 * matters);
        const bool saves_only = part == "growth"; // never changes what comes out
        QVERIFY2((matters > neglected) == (on && !saves_only), qPrintable(QString::number(matters)));
    }
    void aPartThatIsOffLeavesItsQuantityAlone()
    {
        const Design design = spot_design("cotton", 0.65, 10);
        const Run dry = run(drop_design(35, 0.1), {{"liquid", false}}, {}), still = run(design, {{"wicking", false}}, {});
        QCOMPARE(dry.end().ledger.water_delivered, 0.0);
        const auto wet = [](const Run& run) {
            return std::count_if(run.end().saturation.begin(), run.end().saturation.end(), [](float s) { return s > 0; });
        };
        QVERIFY(wet(still) > 0 && wet(still) < wet(run(design, {}, {})) / 2); // under the pool only
        const Run full = run(design, {{"sorption", false}, {"heat", false}, {"vapour", false}}, {});
        QCOMPARE(full.end().ledger.water_bound + full.end().ledger.water_vapour, full.end().ledger.water_initial);
        QCOMPARE(full.end().ledger.water_evaporated, 0.0);
        for (float t : full.end().temperature) QCOMPARE(t, static_cast<float>(kelvin_from_celsius(21)));
    }
};

QTEST_GUILESS_MAIN(TestForcedParts)
#include "tst_forced_parts.moc"
