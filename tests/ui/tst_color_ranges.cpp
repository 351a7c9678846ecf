// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// One range of colours for each quantity of a project: it grows, it can be kept, and it can be fitted.
#include "ui/results/color_ranges.h"

#include <QSignalSpy>
#include <QTest>

using namespace hygroloom;

class TestColorRanges : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theRangeGrowsAndDoesNotShrink()
    {
        ColorRanges ranges;
        QSignalSpy changed(&ranges, &ColorRanges::changed);
        QVERIFY(!ranges.of(ShownQuantity::water));
        ranges.widenWater(0); // dry cloth
        QVERIFY(!ranges.of(ShownQuantity::water));
        ranges.widenWater(0.11);
        QCOMPARE(ranges.mostWater(), 0.12);
        ranges.widenWater(0.02);
        QCOMPARE(ranges.mostWater(), 0.12);
        QCOMPARE(changed.count(), 1);
        ranges.widenWater(0.13);
        QCOMPARE(ranges.mostWater(), 0.16);
        QVERIFY(!ranges.of(ShownQuantity::temperature));
        ranges.widen(ShownQuantity::temperature, {290, 295});
        ranges.widen(ShownQuantity::temperature, {292, 300});
        QCOMPARE(*ranges.of(ShownQuantity::temperature), (ValueRange{290, 300}));
        ranges.clear();
        QVERIFY(!ranges.of(ShownQuantity::water) && !ranges.of(ShownQuantity::temperature));
    }

    void aKeptRangeStaysAndSaysWhatGoesBeyond()
    {
        ColorRanges ranges;
        ranges.widenWater(0.11);
        ranges.setKept(true);
        QCOMPARE(legendTitle("Water", ranges, ShownQuantity::water), QString("Water, kept"));
        ranges.widenWater(0.115); // within the round end
        QVERIFY(!ranges.passed(ShownQuantity::water));
        ranges.widenWater(0.5);
        QCOMPARE(ranges.mostWater(), 0.12);
        QVERIFY(ranges.passed(ShownQuantity::water));
        QVERIFY(legendTitle("Water", ranges, ShownQuantity::water) != "Water, kept");
        // No longer kept: who shows more tells it again.
        connect(&ranges, &ColorRanges::fitWanted, &ranges, [&ranges] { ranges.widenWater(0.5); });
        ranges.setKept(false);
        QCOMPARE(ranges.mostWater(), 0.5);
        QCOMPARE(legendTitle("Water", ranges, ShownQuantity::water), QString("Water"));
    }

    void fittingAsksWhoIsSeen()
    {
        ColorRanges ranges;
        ranges.widenWater(3);
        connect(&ranges, &ColorRanges::fitWanted, &ranges, [&ranges] { ranges.widenWater(0.2); });
        ranges.fit();
        QCOMPARE(ranges.mostWater(), 0.2);
    }

    void aQuantityThatWasNotShownYetIsKeptFromItsFirstRangeOn()
    {
        ColorRanges ranges;
        ranges.setKept(true);
        ranges.widenWater(0.1);
        QCOMPARE(ranges.mostWater(), 0.1);
        ranges.widenWater(0.9);
        QCOMPARE(ranges.mostWater(), 0.1);
    }
};

QTEST_MAIN(TestColorRanges)
#include "tst_color_ranges.moc"
