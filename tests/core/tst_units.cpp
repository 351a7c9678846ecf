// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/base/text.h"
#include "core/base/units.h"

#include <QTest>

using namespace hygroloom;

namespace tst_units {
namespace {
bool near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }
} // namespace

class TestUnits : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void twentiesCottonCountIsTwentyNinePointFiveTex()
    {
        QVERIFY(near(tex_from_ne(20), 29.525, 1e-9));
        QVERIFY(near(ne_from_tex(29.525), 20, 1e-9));
    }
    void countsTurnBackIntoThemselves()
    {
        for (double tex : {0.5, 8.3, 29.5, 1000.0}) {
            QVERIFY(near(tex_from_ne(ne_from_tex(tex)), tex, 1e-12 * tex));
            QVERIFY(near(tex_from_nm(nm_from_tex(tex)), tex, 1e-12 * tex));
            QVERIFY(near(tex_from_denier(denier_from_tex(tex)), tex, 1e-12 * tex));
        }
    }
    void metricCountTenIsHundredTex() { QVERIFY(near(tex_from_nm(10), 100, 1e-12)); }
    void seventyFiveDenierIsEightPointThreeTex() { QVERIFY(near(tex_from_denier(75), 8.3333333, 1e-6)); }
    void thirtyFivePerCentimetreIsEightyEightPointNinePerInch()
    {
        QVERIFY(near(per_inch_from_per_cm(35), 88.9, 1e-9));
        QVERIFY(near(per_cm_from_per_inch(88.9), 35, 1e-9));
    }
    void waterFreezesAtTwoHundredSeventyThreeKelvin() { QCOMPARE(kelvin_from_celsius(0), 273.15); }
    void bytesArePrintedInTheUnitThatReadsBest()
    {
        QCOMPARE(bytes_text(80), std::string("0.1 kB"));
        QCOMPARE(bytes_text(820e3), std::string("820 kB"));
        QCOMPARE(bytes_text(999.6e3), std::string("1.0 MB"));
        QCOMPARE(bytes_text(34.4e6), std::string("34 MB"));
        QCOMPARE(bytes_text(1.25e9 - 1), std::string("1.2 GB"));
        QCOMPARE(bytes_text(123456e9), std::string("123456 GB"));
    }
    void theRemainingTimeIsPrintedOnceSomethingIsKnown()
    {
        QVERIFY(!time_left(0.001, 600) && !time_left(0.5, 0.1) && !time_left(0, 0));
        QCOMPARE(*time_left(0.25, 30), 90.0);
        QCOMPARE(*time_left(1, 30), 0.0);
    }
    void aMicrolitreIsACubicMillimetre() { QVERIFY(near(cubic_metre_from_ul(1), 1e-9, 1e-24)); }
};

} // namespace tst_units

QTEST_APPLESS_MAIN(tst_units::TestUnits)
#include "tst_units.moc"
