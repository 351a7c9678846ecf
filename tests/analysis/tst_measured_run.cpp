// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/measured_run.h"
#include "tests/support/drop_design.h"

#include <QTest>

#include <cmath>

using namespace hygroloom;

class TestMeasuredRun : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aRunIsMeasuredBesideItsCallbacks()
    {
        const auto backend = make_cpu_backend();
        RunControl control;
        RunOptions options;
        options.fidelity = Fidelity::draft;
        options.knobs = {{"particles_per_droplet", 100}};
        int frames = 0, measured = 0;
        double delivered = 0; // kg
        RunCallbacks beside;
        beside.frame = [&](const std::shared_ptr<const Frame>&) { ++frames; };
        const FinishedRun finished =
            run_and_measure(drop_design(35, 0.02), "cloth", "drop", options, *backend, control, beside,
                            [&](const std::shared_ptr<const Frame>&, const std::shared_ptr<const MetricsCollector>& so_far) {
                                ++measured;
                                delivered = so_far->metrics().ledger.water_delivered;
                            });
        QVERIFY(frames > 1 && finished.device_failure.empty());
        QCOMPARE(measured, frames);
        QCOMPARE(finished.run.fabric, std::string("cloth"));
        QVERIFY(std::abs(finished.metrics.ledger.water_delivered / 2e-6 - 1) < 0.01); // 2 ul of water
        QCOMPARE(delivered, finished.metrics.ledger.water_delivered);
    }
};

QTEST_GUILESS_MAIN(TestMeasuredRun)
#include "tst_measured_run.moc"
