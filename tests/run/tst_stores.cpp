// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Wherever water lies it is accounted for: it gives to dry air, and drying tests begin with what they ask for.
#include "core/base/error.h"
#include "core/project/library.h"
#include "tests/support/run.h"

#include "core/verify/set_ups.h"

#include <QTest>

#include <cmath>

using namespace hygroloom;

namespace tst_stores {
namespace {

/// Cloth of the paper's textile F, 12 mm on a side, in warm, dry air.
Design in_dry_air(ExperimentType type, double contact_angle)
{
    Fabric fabric = library_fabric("Textile F");
    fabric.contact_angle_deg = contact_angle;
    Experiment experiment;
    experiment.name = "test";
    experiment.type = type;
    experiment.sample_mm = {12, 12};
    experiment.climate = {35, 0, 0.5};
    Design design;
    design.fabrics = {fabric};
    design.experiments = {experiment};
    return design;
}

Design drop_on(double contact_angle, double duration)
{
    Design design = in_dry_air(ExperimentType::droplet, contact_angle);
    Droplet drop;
    drop.volume_ul = 2;
    drop.height_mm = 0.5;
    design.experiments[0].droplets = {drop};
    design.experiments[0].duration_s = duration;
    return design;
}

/// Water that a store still holds at the start and the end of the later half of a run, which begins when all of it has come.
void fellInTheLaterHalf(const Run& found, double Ledger::*store)
{
    const Ledger &middle = found.frames[found.frames.size() / 2].ledger, &end = found.end().ledger;
    QVERIFY2(middle.*store > 0, "nothing is in the store that is tried");
    QVERIFY2(end.*store < middle.*store && end.water_evaporated > middle.water_evaporated,
             qPrintable(QString("%1 kg, then %2; %3 kg gone, then %4")
                            .arg(middle.*store)
                            .arg(end.*store)
                            .arg(middle.water_evaporated)
                            .arg(end.water_evaporated)));
    QVERIFY(end.water_delivered >= middle.water_delivered * (1 - 1e-15));
    for (const Frame& frame : found.frames) {
        QVERIFY(std::abs(frame.ledger.water_imbalance()) <= 1e-12 * (frame.ledger.water_delivered + frame.ledger.water_initial));
        const double energy = std::abs(frame.ledger.energy_released) + std::abs(frame.ledger.energy_lost) + 1e-9;
        QVERIFY(std::abs(frame.ledger.energy_imbalance()) <= 1e-9 * energy);
    }
}

RunOptions live()
{
    RunOptions options;
    options.fidelity = Fidelity::live;
    return options;
}

} // namespace

class TestStores : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void dropsAsCapsGiveToDryAir() { fellInTheLaterHalf(run(drop_on(120, 60), live()), &Ledger::water_free); }
    void dropsOfParticlesGiveToDryAir()
    {
        RunOptions options = live();
        options.knobs["free_liquid"] = static_cast<double>(DropModel::particles);
        options.knobs["particles_per_droplet"] = 200;
        options.forced["vapour"] = true;
        fellInTheLaterHalf(run(drop_on(120, 4), options), &Ledger::water_free);
    }
    void poolsGiveToDryAir()
    {
        Design design = in_dry_air(ExperimentType::horizontal_wicking, 120);
        design.experiments[0].volume_ul = 5;
        design.experiments[0].duration_s = 60;
        fellInTheLaterHalf(run(design, live()), &Ledger::water_free);
    }
    void filmsGiveToDryAir()
    {
        Design design = in_dry_air(ExperimentType::drying, 35);
        design.experiments[0].initial_water_g_m2 = 450;
        design.experiments[0].duration_s = 60;
        fellInTheLaterHalf(run(design, live()), &Ledger::water_free);
    }
    void yarnsAndRoomsGiveToDryAir()
    {
        Design design = in_dry_air(ExperimentType::drying, 35);
        design.experiments[0].initial_water_g_m2 = 200;
        design.experiments[0].duration_s = 300;
        const Run found = run(design, live());
        fellInTheLaterHalf(found, &Ledger::water_liquid);
        double between = 0;
        for (float water : found.frames.front().between) between += static_cast<double>(water);
        QVERIFY(between > 0);
    }

    /// Cloths of all kinds, and more water than their yarns hold.
    void dryingBeginsWithTheWaterAskedFor()
    {
        int refused = 0, began = 0;
        for (const Preset& preset : shipped_presets())
            for (double water : {30.0, 100.0, 200.0}) {
                Design design = in_dry_air(ExperimentType::drying, 35);
                design.fabrics = {preset.fabric()};
                design.experiments[0].sample_mm = {5, 5};
                design.experiments[0].initial_water_g_m2 = water;
                design.experiments[0].duration_s = 1e-3;
                try {
                    const Run found = run(design, live());
                    const double asked = 1e-3 * water * found.metrics.ledger.water_delivered / *found.metrics.water_at_start; // kg
                    QVERIFY2(std::abs(found.frames.front().ledger.water_delivered / asked - 1) < 1e-12, preset.fabric().name.c_str());
                    QVERIFY2(std::abs(1e3 * *found.metrics.water_at_start / water - 1) < 1e-12, preset.fabric().name.c_str());
                    ++began;
                } catch (const Error& error) {
                    QVERIFY2(std::string(error.what()).find("of water at most") != std::string::npos, error.what());
                    ++refused;
                }
            }
        QVERIFY2(began > 10 * refused, qPrintable(QString("%1 began, %2 hold less").arg(began).arg(refused)));
    }
    void moreThanFitsIsRefusedWithWhatFits()
    {
        Design design = in_dry_air(ExperimentType::drying, 35);
        design.experiments[0].initial_water_g_m2 = 5000;
        try {
            run(design, live());
            QFAIL("5 kg/m2 stay on a shirt");
        } catch (const Error& error) {
            QVERIFY2(QString(error.what()).contains("initial_water_g_m2 is 5000"), error.what());
        }
    }
    void twiceTheWaterTakesTwiceTheTime() // where fibres bind next to nothing
    {
        double times[2];
        for (int twice : {0, 1}) {
            Design design = in_dry_air(ExperimentType::drying, 35);
            design.fabrics = {library_fabric("Sports micro-twill")};
            design.experiments[0].climate = {21, 0.5, 1};
            design.experiments[0].sample_mm = {5, 5};
            design.experiments[0].initial_water_g_m2 = twice == 0 ? 100 : 200;
            design.experiments[0].duration_s = 7200;
            const Run found = run(design, live());
            QVERIFY(found.metrics.drying && found.metrics.drying->time_to_dry);
            times[twice] = *found.metrics.drying->time_to_dry;
        }
        QVERIFY2(times[1] > 1.9 * times[0] && times[1] < 2.1 * times[0], qPrintable(QString("%1 and %2 s").arg(times[0]).arg(times[1])));
    }
};

} // namespace tst_stores

QTEST_GUILESS_MAIN(tst_stores::TestStores)
#include "tst_stores.moc"
