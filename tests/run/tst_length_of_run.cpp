// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a run finds at a time depends neither on how long it goes on nor on when frames are taken, nor on the sample's size while water is
// far from its edges.
#include "core/verify/set_ups.h"
#include "tests/support/run.h"

#include <QTest>

using namespace hygroloom;

namespace tst_length_of_run {
namespace {

/// All parts on: whether a part is needed may depend on how long the run is.
RunOptions options(Fidelity fidelity, double frame_interval, double drops_as)
{
    RunOptions options;
    options.fidelity = fidelity;
    options.frame_interval = frame_interval;
    options.forced = {{"sorption", true}, {"vapour", true}, {"heat", true}};
    if (drops_as > 0) options.knobs = {{"free_liquid", drops_as}, {"particles_per_droplet", 300}};
    return options;
}

const Frame* frame_at(const Run& run, double time)
{
    for (const Frame& frame : run.frames)
        if (std::abs(frame.time - time) < 1e-9 * time) return &frame;
    return nullptr;
}

} // namespace

class TestLengthOfRun : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aLongerRunFindsTheSameOnItsWay_data()
    {
        QTest::addColumn<int>("type");
        QTest::addColumn<double>("time"); // s
        QTest::addColumn<int>("fidelity");
        QTest::addColumn<double>("drops_as");
        const auto row = [](const char* name, ExperimentType type, double time, Fidelity fidelity, double drops_as = 0) {
            QTest::newRow(name) << static_cast<int>(type) << time << static_cast<int>(fidelity) << drops_as;
        };
        row("a drop that stands as a cap", ExperimentType::droplet, 1.0, Fidelity::live, 1);
        row("a drop of particles", ExperimentType::droplet, 0.06, Fidelity::draft, 2);
        row("a strip", ExperimentType::vertical_wicking, 2.0, Fidelity::draft);
        row("a strip, live", ExperimentType::vertical_wicking, 2.0, Fidelity::live);
        row("liquid that is fed", ExperimentType::horizontal_wicking, 2.0, Fidelity::live);
        row("sweat", ExperimentType::sweat, 20.0, Fidelity::draft);
        row("drying", ExperimentType::drying, 300.0, Fidelity::draft);
    }
    void aLongerRunFindsTheSameOnItsWay()
    {
        QFETCH(int, type);
        QFETCH(double, time);
        QFETCH(int, fidelity);
        QFETCH(double, drops_as);
        Experiment experiment = standard_experiment(static_cast<ExperimentType>(type));
        experiment.sample_mm = {6, 6};
        if (type == static_cast<int>(ExperimentType::vertical_wicking)) experiment.sample_mm = {2, 20};
        if (type == static_cast<int>(ExperimentType::droplet)) {
            Droplet drop;
            drop.volume_ul = 0.3;
            drop.height_mm = 0.3;
            experiment.droplets = {drop};
        }
        experiment.duration_s = time;
        Design design = design_of(library_fabric("Textile F"), experiment);
        const auto level = static_cast<Fidelity>(fidelity);
        const Run shorter = run(design, options(level, time / 8, drops_as));
        design.experiments[0].duration_s = 4 * time;
        const Run longer = run(design, options(level, time / 2, drops_as));
        const Frame *a = frame_at(shorter, time), *b = frame_at(longer, time);
        QVERIFY(a && b);
        for (const FrameField& field : frame_fields) QVERIFY2(field.in(*a) == field.in(*b), field.name);
        QVERIFY(a->positions == b->positions);
        QCOMPARE(a->ledger.water_free, b->ledger.water_free);
        QCOMPARE(a->ledger.water_liquid, b->ledger.water_liquid);
        QCOMPARE(a->ledger.water_bound, b->ledger.water_bound);
        QCOMPARE(a->ledger.water_evaporated, b->ledger.water_evaporated);
        QVERIFY(a->ledger.water_delivered > 0);
        QVERIFY(std::abs(a->ledger.water_imbalance()) < 1e-12 * a->ledger.water_delivered);
    }
    void aLargerSampleHasTheSameStain_data()
    {
        QTest::addColumn<QString>("fabric");
        QTest::addColumn<int>("fidelity");
        QTest::addColumn<double>("volume"); // ul
        QTest::addColumn<double>("within");
        QTest::addColumn<double>("in_time_within");
        const auto row = [](const char* name, const char* fabric, Fidelity fidelity, double volume, double within, double in_time_within) {
            QTest::newRow(name) << fabric << static_cast<int>(fidelity) << volume << within << in_time_within;
        };
        row("poplin, live", "Poplin shirting", Fidelity::live, 2, 0.02, 0.02);
        row("twill, live", "Denim", Fidelity::live, 5, 0.02, 0.02);
        row("twill, draft", "Textile F", Fidelity::draft, 2, 0.005, 0.03); // particles fall with chance: other seeds differ as much
    }
    void aLargerSampleHasTheSameStain()
    {
        QFETCH(QString, fabric);
        QFETCH(int, fidelity);
        QFETCH(double, volume);
        QFETCH(double, within);
        QFETCH(double, in_time_within);
        Experiment experiment = standard_experiment(ExperimentType::droplet);
        experiment.droplets[0].volume_ul = volume;
        experiment.duration_s = 2;
        RunOptions how;
        how.fidelity = static_cast<Fidelity>(fidelity);
        std::vector<double> radii, times;
        for (double side : {15.0, 15.4, 17.3, 19.9}) { // odd and even numbers of ends, of picks, and halves of those
            experiment.sample_mm = {side, side};
            const Run found = run(design_of(library_fabric(fabric.toStdString()), experiment), how);
            radii.push_back(found.metrics.equal_area_radius_top);
            times.push_back(found.metrics.absorbency_time.value_or(0));
        }
        const auto alike = [](const std::vector<double>& found, double part, const char* unit) {
            const auto [least, most] = std::minmax_element(found.begin(), found.end());
            QVERIFY2(*least > 0 && *most < (1 + part) * *least, qPrintable(QString("%1 to %2 %3").arg(*least).arg(*most).arg(unit)));
        };
        alike(radii, within, "m");
        if (!QTest::currentTestFailed()) alike(times, in_time_within, "s");
    }
};

} // namespace tst_length_of_run

QTEST_GUILESS_MAIN(tst_length_of_run::TestLengthOfRun)
#include "tst_length_of_run.moc"
