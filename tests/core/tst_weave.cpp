// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/base/error.h"
#include "core/design/weave_analysis.h"
#include "tests/support/drawn.h"

#include <QTest>

using namespace hygroloom;

namespace {

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
        QTest::newRow("twill 3/2 Z steep 2") << "twill 3/2 Z steep 2"
                                             << "01101 01011 11010 10110 10101";
        QTest::newRow("broken twill 3/1 Z") << "broken twill 3/1 Z"
                                            << "0111 1101 1110 1011";
        QTest::newRow("satin 4") << "satin 4"
                                 << "1101 1110 1011 0111";
        QTest::newRow("satin 6") << "satin 6"
                                 << "111101 110111 111110 101111 111011 011111";
        QTest::newRow("sateen 4") << "sateen 4"
                                  << "0010 0001 0100 1000";
        QTest::newRow("pointed twill 2/2 Z 4") << "pointed twill 2/2 Z 4"
                                               << "001110 011011 110001 100100";
        QTest::newRow("herringbone 2/2 Z 4") << "herringbone 2/2 Z 4"
                                             << "00110011 01101001 11001100 10010110";
        QTest::newRow("diamond 2/2 4") << "diamond 2/2 4"
                                       << "110001 011011 001110 011011 110001 100100";
        QTest::newRow("waffle 6") << "waffle 6"
                                  << "010001 101010 110101 101010 010001 100000";
        QTest::newRow("mock leno 3") << "mock leno 3"
                                     << "010101 000111 010101 101010 111000 101010";
        QTest::newRow("huckaback 3") << "huckaback 3"
                                     << "101010 010111 101010 010101 111010 010101";
        QTest::newRow("birdseye") << "birdseye"
                                  << "010001 001010 100100 001010 010001 100100";
        QTest::newRow("sharkskin") << "sharkskin"
                                   << "0011 0110 1100 1001";
        QTest::newRow("ripstop 3") << "ripstop 3"
                                   << "011 011 100";
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
    void everyCataloguedWeaveIsBoundAndHangsTogether()
    {
        for (const std::string& pattern : common_weave_patterns()) {
            const WeaveAnalysis analysis = analyse(weave_from_pattern(pattern));
            QVERIFY2(analysis.unbound_ends.empty() && analysis.unbound_picks.empty(), pattern.c_str());
            QVERIFY2(analysis.cloths == 1, pattern.c_str());
        }
    }
    void steepTwillClimbsTwoPicksPerEndAndReclinedRunsTwoEndsPerPick()
    {
        const Weave steep = weave_from_pattern("twill 3/2 S steep 2"), reclined = weave_from_pattern("twill 3/2 Z reclined 2");
        for (int end = 0; end < 5; ++end)
            for (int pick = 0; pick < 5; ++pick) {
                QCOMPARE(steep.warp_up(end - 1, pick + 2), steep.warp_up(end, pick));
                QCOMPARE(reclined.warp_up(end + 2, pick + 1), reclined.warp_up(end, pick));
            }
    }
    void crepeHasNoFloatLongerThanThreeAndDependsOnItsSeed()
    {
        for (int seed : {0, 1, 2, 99})
            for (int size : {8, 16, 40, 200}) {
                const Weave weave = weave_from_pattern("crepe " + std::to_string(size) + " seed " + std::to_string(seed));
                const WeaveAnalysis analysis = analyse(weave);
                for (const Floats* floats : {&analysis.warp_face, &analysis.warp_back, &analysis.weft_face, &analysis.weft_back})
                    QVERIFY(floats->longest <= 3);
                QVERIFY(analysis.unbound_ends.empty() && analysis.unbound_picks.empty());
                QVERIFY(std::abs(analysis.warp_up_share - 0.5) < 0.15);
                QVERIFY(weave == weave_from_pattern(weave.pattern()));
            }
        QVERIFY(!weave_from_pattern("crepe 16 seed 1").same_matrix(weave_from_pattern("crepe 16 seed 2")));
        QCOMPARE(weave_from_pattern("crepe 16").pattern(), std::string("crepe 16 seed 1"));
        QCOMPARE(weave_from_pattern("crepe 2000").ends(), 2000);
    }
    void herringboneOfABalancedTwillCutsCleanly()
    {
        const Weave weave = weave_from_pattern("herringbone 3/3 Z 9");
        for (int pick = 0; pick < weave.picks(); ++pick) {
            QVERIFY(weave.warp_up(8, pick) != weave.warp_up(9, pick));
            QVERIFY(weave.warp_up(17, pick) != weave.warp_up(18, pick));
        }
    }
    void ripstopDoublesEveryNthThread()
    {
        for (int grid : {3, 4, 11, 12}) {
            const Weave weave = weave_from_pattern("ripstop " + std::to_string(grid));
            for (int thread = 0; thread < weave.ends(); ++thread) {
                const bool doubled = thread % grid == grid - 2;
                for (int other = 0; other < weave.picks(); ++other) {
                    QCOMPARE(weave.warp_up(thread, other) == weave.warp_up(thread + 1, other), doubled);
                    QCOMPARE(weave.warp_up(other, thread) == weave.warp_up(other, thread + 1), doubled);
                }
            }
        }
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
                                    "twill 2/1/",
                                    "twill 3/2 Z steep",
                                    "twill 3/2 Z steep 1",
                                    "twill 3/2 Z steep 5",
                                    "twill 3/2 Z sloping 2",
                                    "broken",
                                    "broken twill 2/1 Z",
                                    "pointed twill 2/2 Z 2",
                                    "herringbone 2/2 Z 8 8",
                                    "diamond 2/2 Z",
                                    "waffle 7",
                                    "waffle 4",
                                    "huckaback 4",
                                    "mock leno 2",
                                    "mock leno 2001",
                                    "crepe 9",
                                    "crepe 16 7",
                                    "crepe 16 seed -1",
                                    "birdseye 6",
                                    "ripstop 2",
                                    "ripstop 12 12"})
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
