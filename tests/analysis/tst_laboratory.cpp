// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Results of laboratory tests read from curves made up so that each is known.
#include "core/analysis/laboratory.h"

#include <QTest>

#include <cmath>

using namespace hygroloom;

namespace {

std::vector<double> times(double step, double end)
{
    std::vector<double> time;
    for (int i = 0; i * step <= end + 1e-9; ++i) time.push_back(i * step);
    return time;
}

template <typename Law> std::vector<double> along(const std::vector<double>& time, Law law)
{
    std::vector<double> values;
    for (double t : time) values.push_back(law(t));
    return values;
}

bool near(const std::optional<double>& value, double expected, double tolerance)
{
    return value && std::abs(*value - expected) <= tolerance;
}

} // namespace

class TestLaboratory : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void wickingByTheRootOfTimeHasItsRate()
    {
        const auto time = times(1, 600);
        const auto rising = along(time, [](double t) { return 4e-3 * std::sqrt(t); });
        const WickingResult r = wicking_result(time, rising, rising);
        QVERIFY(std::abs(r.height - 4e-3 * std::sqrt(600)) < 1e-12);
        QVERIFY(near(r.rate, 4e-3, 1e-9));
        const WickingResult full = wicking_result(time, along(time, [](double t) { return std::min(8e-3, 4e-3 * std::sqrt(t)); }), rising);
        QVERIFY(std::abs(*full.rate - 4e-3) < 1e-9);                                          // the strip's end stops it
        QVERIFY(!wicking_result(time, along(time, [](double) { return 0.0; }), rising).rate); // nothing rose
        QVERIFY(!wicking_result({}, {}, {}).rate);
    }
    void heightsAndWaterAreReadAfterTheMinutesOfTheStandard()
    {
        const auto time = times(7, 1000); // 300 s and 600 s lie between two of them
        const auto height = along(time, [](double t) { return 2e-5 * t; }), water = along(time, [](double t) { return 3e-5 * t; });
        const WickingResult r = wicking_result(time, height, water);
        QVERIFY(r.after[0] && r.after[1] && !r.after[2]); // it ended before 30 min
        QVERIFY(near(r.after[0]->height, 6e-3, 1e-12) && near(r.after[0]->water, 9e-3, 1e-12));
        QVERIFY(near(r.after[1]->height, 12e-3, 1e-12) && near(r.after[1]->water, 18e-3, 1e-12));
        const auto whole = times(10, 600); // ends with 10 min
        QVERIFY(wicking_result(whole, whole, whole).after[1]);
    }
    void dryingHasItsRateAndItsEnd()
    {
        // 5 g on a quarter of a square metre: 2 mg/s until a fifth is left, then ever slower.
        const auto time = times(10, 4000);
        const auto left = along(time, [](double t) { return t < 2000 ? 5e-3 - 2e-6 * t : 1e-3 * std::exp(-(t - 2000) / 500); });
        const auto temperature = along(time, [](double t) { return t < 300 ? 294 : t < 2000 ? 289.5 : 294.0; });
        const DryingResult r = drying_result(time, left, temperature, 0.25);
        QVERIFY(near(r.rate, 8e-6, 1e-12));
        QVERIFY(near(r.index, 2e-6 / 5e-3, 1e-9));
        QVERIFY(near(r.steady_temperature, 289.5, 1e-9));
        QVERIFY(near(r.time_to_dry, 2000 + 500 * std::log(5), 1));
    }
    void theConstantRateEndsWhereItFalls()
    {
        // 2 mg/s until half is left, which the fibres hold and give off ever slower.
        const auto time = times(10, 4000);
        const auto left = along(time, [](double t) { return t < 1250 ? 5e-3 - 2e-6 * t : 2.5e-3 * std::exp(-(t - 1250) / 1250); });
        const auto temperature = along(time, [](double t) { return t < 300 ? 294 : t < 1250 ? 289.5 : 294.0; });
        const DryingResult r = drying_result(time, left, temperature, 0.25);
        QVERIFY(near(r.rate, 8e-6, 0.005 * 8e-6));
        QVERIFY(near(r.steady_temperature, 289.5, 0.5));
        const DryingResult cut = drying_result({time.begin(), time.begin() + 160}, left, temperature, 0.25); // before 30 % are left
        QVERIFY(cut.rate && r.rate && *cut.rate == *r.rate);
    }
    void aConstantRateHoldsToTheEnd()
    {
        for (const double interval : {0.5, 1.0, 3.0, 7.0}) { // 80 % is left at a sample, or just before or after it
            const auto time = times(interval, 2100);
            const auto left = along(time, [](double t) { return std::max(0.0, 1.1e-3 * (1 - t / 2000)); });
            const DryingResult r = drying_result(time, left, along(time, [](double) { return 290.0; }), 0.25);
            QVERIFY(near(r.rate, 1.1e-3 / 2000 / 0.25, 1e-9 * 2.2e-6));
        }
    }
    void whatDidNotDryHasNoEnd()
    {
        const auto time = times(1, 100);
        const DryingResult r = drying_result(time, along(time, [](double t) { return 1e-3 - 5e-6 * t; }), time, 1);
        QVERIFY(!r.time_to_dry && !r.rate && !r.steady_temperature);
        QVERIFY(!drying_result({0, 1}, {0, 0}, {0, 0}, 1).time_to_dry); // no water to begin with
    }
    void conditioningHasItsHalfTime()
    {
        const auto time = times(1, 1000);
        const auto regain = along(time, [](double t) { return 0.1 - 0.08 * std::exp(-t / 100); });
        const auto warm = along(time, [](double t) { return 293 + 0.2 * t * std::exp(-t / 50); });
        const ConditioningResult r = conditioning_result(time, regain, warm, along(time, [](double) { return 293.0; }));
        QCOMPARE(r.regain_start, 0.1 - 0.08);
        QVERIFY(near(r.half_time, 100 * std::log(2), 0.01));
        QVERIFY(std::abs(r.peak_rise - 10 / std::exp(1.0)) < 1e-9);
        QVERIFY(r.settled);
        const auto slow = along(time, [](double t) { return 0.1 - 1e-5 * t; }); // drying, and still at it
        const ConditioningResult s = conditioning_result(time, slow, warm, warm);
        QVERIFY(near(s.half_time, 500, 1e-6) && !s.settled);
        QCOMPARE(s.peak_rise, 0.0);
        const auto level = along(time, [](double) { return 0.1; });
        QVERIFY(!conditioning_result(time, level, warm, warm).half_time);
        QVERIFY(conditioning_result(time, level, warm, warm).settled);
    }
};

QTEST_APPLESS_MAIN(TestLaboratory)
#include "tst_laboratory.moc"
