// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/base/error.h"
#include "core/design/weave.h"

#include <QTest>

using namespace hygroloom;

namespace {

/// Rows as on point paper, last pick first.
std::string drawn(const Weave& weave)
{
    std::string text;
    for (int pick = weave.picks() - 1; pick >= 0; --pick) {
        for (int end = 0; end < weave.ends(); ++end) text += weave.warp_up(end, pick) ? '1' : '0';
        if (pick > 0) text += ' ';
    }
    return text;
}

bool refused(const std::string& pattern, const std::string& word)
{
    try {
        weave_from_pattern(pattern);
    } catch (const Error& error) {
        return std::string(error.what()).find(word) != std::string::npos && std::string(error.what()).find("Forms:") != std::string::npos;
    }
    return false;
}

} // namespace

class TestWeave : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void patternsDrawAsInTextbooks_data()
    {
        QTest::addColumn<QString>("pattern");
        QTest::addColumn<QString>("rows");
        QTest::newRow("plain") << "plain"
                               << "01 10";
        QTest::newRow("twill 2/1 Z") << "twill 2/1 Z"
                                     << "011 110 101";
        QTest::newRow("twill 2/1 S") << "twill 2/1 S"
                                     << "011 101 110";
        QTest::newRow("twill 2/2 Z") << "twill 2/2 Z"
                                     << "0011 0110 1100 1001";
        QTest::newRow("twill 2/1/1/1 Z") << "twill 2/1/1/1 Z"
                                         << "01011 10110 01101 11010 10101";
        QTest::newRow("basket 2/1") << "basket 2/1"
                                    << "0011 1100";
        QTest::newRow("warp rib") << "rib 2/2 warp"
                                  << "01 01 10 10";
        QTest::newRow("weft rib") << "rib 2/2 weft"
                                  << "0011 1100";
    }
    void patternsDrawAsInTextbooks()
    {
        QFETCH(QString, pattern);
        QFETCH(QString, rows);
        const Weave weave = weave_from_pattern(pattern.toStdString());
        QCOMPARE(QString::fromStdString(drawn(weave)), rows);
    }
    void twillLinesRiseToTheirSide()
    {
        for (const char* pattern : {"twill 2/1 Z", "twill 2/2 Z", "twill 3/1/1/2 Z", "twill 2/1 S", "twill 4/4 S"}) {
            const Weave weave = weave_from_pattern(pattern);
            const int side = weave.pattern().back() == 'Z' ? 1 : -1;
            for (int end = 0; end < weave.ends(); ++end)
                for (int pick = 0; pick < weave.picks(); ++pick) QCOMPARE(weave.warp_up(end + side, pick + 1), weave.warp_up(end, pick));
        }
    }
    void satinHasOneBindingPointPerEnd()
    {
        for (const char* pattern : {"satin 5/2", "satin 5/3", "satin 8/3", "satin 7/4"}) {
            const Weave weave = weave_from_pattern(pattern);
            for (int end = 0; end < weave.ends(); ++end) {
                int down = 0;
                for (int pick = 0; pick < weave.picks(); ++pick) down += !weave.warp_up(end, pick);
                QCOMPARE(down, 1);
            }
            for (int pick = 0; pick < weave.picks(); ++pick) {
                int down = 0;
                for (int end = 0; end < weave.ends(); ++end) down += !weave.warp_up(end, pick);
                QCOMPARE(down, 1);
            }
        }
    }
    void sateenIsSatinTurnedOver()
    {
        const Weave satin = weave_from_pattern("satin 8/3"), sateen = weave_from_pattern("sateen 8/3");
        for (int end = 0; end < 8; ++end)
            for (int pick = 0; pick < 8; ++pick) QCOMPARE(sateen.warp_up(end, pick), !satin.warp_up(end, pick));
    }
    void twillOfTwoAndOneHasTwoUpsOnEachEnd()
    {
        const Weave weave = weave_from_pattern("twill 2/1");
        QCOMPARE(weave.pattern(), std::string("twill 2/1 Z"));
        for (int end = 0; end < 3; ++end) QCOMPARE(weave.warp_up(end, 0) + weave.warp_up(end, 1) + weave.warp_up(end, 2), 2);
    }
    void indicesWrapRoundTheRepeatBothWays()
    {
        const Weave weave = weave_from_pattern("twill 3/1 S");
        for (int end = -9; end < 9; ++end)
            for (int pick = -9; pick < 9; ++pick) QCOMPARE(weave.warp_up(end, pick), weave.warp_up(end + 4, pick - 4));
    }
    void togglingMakesAFreeWeaveAndLeavesTheOldOne()
    {
        const Weave plain;
        const Weave other = plain.toggled(1, 1);
        QCOMPARE(plain.pattern(), std::string("plain"));
        QVERIFY(plain.warp_up(1, 1));
        QVERIFY(!other.warp_up(1, 1));
        QVERIFY(other.pattern().empty());
        QVERIFY(!(plain == other));
        QVERIFY(plain == Weave());
    }
    void everyCommonPatternIsAccepted()
    {
        for (const std::string& pattern : common_weave_patterns()) QCOMPARE(weave_from_pattern(pattern).pattern(), pattern);
    }
    void wrongPatternsAreRefusedWithTheForms()
    {
        for (const char* pattern : {"",
                                    "twil 2/1",
                                    "twill",
                                    "twill 2",
                                    "twill 2/x",
                                    "twill 0/1",
                                    "twill 2/1 Q",
                                    "twill 2/1 Z Z",
                                    "twill 1/1",
                                    "twill 99999999999/1",
                                    "twill 1999/1999",
                                    "basket",
                                    "basket 2/2/2",
                                    "rib 2 warp",
                                    "rib 2/2 round",
                                    "plain 2/2",
                                    "satin 4/1",
                                    "satin",
                                    "twill 2/-1",
                                    "twill 2//1",
                                    "twill 2/1/"})
            QVERIFY2(refused(pattern, ""), pattern);
    }
    void satinStepsMustBeCoprime()
    {
        QVERIFY(refused("satin 8/2", "3, 5"));
        QVERIFY(refused("satin 8/7", "3, 5"));
        QVERIFY(refused("satin 8/1", "3, 5"));
        QVERIFY(refused("satin 6/2", "no regular satin has 6 ends"));
        QCOMPARE(weave_from_pattern("satin 8").pattern(), std::string("satin 8/3"));
    }
    void aMatrixOfTheWrongSizeIsAnError() { QVERIFY_EXCEPTION_THROWN(Weave(2, 2, {1, 0, 1}), Error); }
    void plainWeaveChangesSidesEverywhere()
    {
        QCOMPARE(share_of_changes(Weave(), true), 1.0);
        QCOMPARE(share_of_changes(Weave(), false), 1.0);
        QCOMPARE(share_of_changes(weave_from_pattern("twill 2/2 Z"), true), 0.5);
        QCOMPARE(share_of_changes(weave_from_pattern("satin 5/2"), true), 0.4);
        QCOMPARE(share_of_changes(weave_from_pattern("rib 2/2 warp"), true), 0.5);
        QCOMPARE(share_of_changes(weave_from_pattern("rib 2/2 warp"), false), 1.0);
    }
};

QTEST_APPLESS_MAIN(TestWeave)
#include "tst_weave.moc"
