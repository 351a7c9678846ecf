// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/base/random.h"
#include "core/base/units.h"
#include "core/design/drawdown.h"
#include "core/design/jam.h"
#include "core/design/validate.h"
#include "core/design/weave_analysis.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace hygroloom;

namespace tst_weave_analysis {
namespace {

using Counts = std::vector<long>;

/// Rows as on point paper, last pick first.
Weave from_rows(const std::vector<std::string>& rows)
{
    std::vector<std::uint8_t> up;
    for (std::size_t row = rows.size(); row-- > 0;)
        for (char crossing : rows[row]) up.push_back(crossing == '1');
    return {static_cast<int>(rows[0].size()), static_cast<int>(rows.size()), std::move(up)};
}

Design with_weave(const Weave& weave, double sett = 20, double diameter = 0.2)
{
    Design design;
    Fabric& fabric = design.fabrics.emplace_back();
    fabric.name = "cloth";
    fabric.warp.diameter_mm = fabric.weft.diameter_mm = diameter;
    fabric.weave = weave;
    fabric.ends_per_cm = fabric.picks_per_cm = sett;
    return design;
}

std::string text_of(const std::vector<Issue>& issues, const std::string& code)
{
    for (const Issue& issue : issues)
        if (issue.code == code) return issue.where.text() + ": " + issue.text();
    return {};
}

/// Whether a weave hangs together, by walking from thread to thread that lies over it: all must be reached from all.
bool hangs_together(const Weave& weave)
{
    const int ends = weave.ends(), threads = ends + weave.picks();
    const auto over = [&](int a, int b) { // a over b
        if ((a < ends) == (b < ends)) return false;
        return a < ends ? weave.warp_up(a, b - ends) : !weave.warp_up(b, a - ends);
    };
    for (int start = 0; start < threads; ++start) {
        std::vector<char> reached(static_cast<std::size_t>(threads));
        std::vector<int> open{start};
        reached[static_cast<std::size_t>(start)] = 1;
        while (!open.empty()) {
            const int at = open.back();
            open.pop_back();
            for (int next = 0; next < threads; ++next)
                if (!reached[static_cast<std::size_t>(next)] && over(next, at)) {
                    reached[static_cast<std::size_t>(next)] = 1;
                    open.push_back(next);
                }
        }
        if (std::count(reached.begin(), reached.end(), 1) != threads) return false;
    }
    return true;
}

} // namespace

class TestWeaveAnalysis : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void twillOfTwoAndOneFloatsOverTwoAndUnderOne()
    {
        const WeaveAnalysis a = analyse(weave_from_pattern("twill 2/1 Z"));
        QVERIFY((a.warp_face.count == Counts{0, 0, 3}) && (a.warp_back.count == Counts{0, 3}));
        QVERIFY((a.weft_face.count == Counts{0, 3}) && (a.weft_back.count == Counts{0, 0, 3}));
        QCOMPARE(a.warp_up_share, 2.0 / 3);
        QCOMPARE(a.warp_interlacings, 6L);
        QCOMPARE(a.weft_interlacings, 6L);
    }
    void satinOfEightFloatsOverSeven()
    {
        const WeaveAnalysis a = analyse(weave_from_pattern("satin 8/3"));
        QCOMPARE(a.warp_face.longest, 7);
        QCOMPARE(a.warp_face.count[7], 8L);
        QCOMPARE(a.weft_back.longest, 7);
        QCOMPARE(a.weft_face.longest, 1);
        QCOMPARE(a.warp_up_share, 7.0 / 8);
    }
    void waffleFloatsFurtherInTheMiddleOfItsCells()
    {
        const WeaveAnalysis a = analyse(weave_from_pattern("waffle 8"));
        QCOMPARE(a.warp_face.longest, 5);
        QCOMPARE(a.weft_face.longest, 7);
    }
    void floatsGoOnAcrossTheEdgeOfTheRepeat()
    {
        const WeaveAnalysis a = analyse(from_rows({"1", "0", "1", "1"})); // one end, picks 1 1 0 1 from the first on
        QCOMPARE(a.warp_face.longest, 3);
        QVERIFY((a.warp_face.count == Counts{0, 0, 0, 1}));
        QCOMPARE(a.unbound_picks.size(), std::size_t(4));
    }
    void theSmallestRepeatIsFound()
    {
        const Weave thrice = from_rows({"010101", "101010", "010101", "101010"});
        const WeaveAnalysis a = analyse(thrice);
        QCOMPARE(a.repeat_ends, 2);
        QCOMPARE(a.repeat_picks, 2);
        QVERIFY(reduced(thrice).same_matrix(Weave()));
        for (const std::string& pattern : common_weave_patterns()) {
            const Weave weave = weave_from_pattern(pattern);
            QVERIFY2(reduced(weave) == weave, pattern.c_str());
        }
    }
    void aRepeatThatDoesNotFitIsNone()
    {
        const WeaveAnalysis a = analyse(from_rows({"10101", "01010"})); // the edge joins two ends that are alike
        QCOMPARE(a.repeat_ends, 5);
        const std::string text = "abcabcab";
        QCOMPARE(least_period(8, [&](int i, int k) { return text[std::size_t(i)] == text[std::size_t(k)]; }), 3);
        QCOMPARE(dividing_period(8, [&](int i, int k) { return text[std::size_t(i)] == text[std::size_t(k)]; }), 8);
    }
    void aReducedWeaveKeepsItsDraft()
    {
        Draft draft = smallest_draft(weave_from_pattern("twill 2/2 Z"));
        for (int i = 0; i < 4; ++i) draft.threading.push_back(draft.threading[static_cast<std::size_t>(i)]);
        for (int i = 0; i < 8; ++i) draft.treadling.push_back(draft.treadling[static_cast<std::size_t>(i)]);
        const Weave weave = reduced(weave_from_draft(draft));
        QVERIFY(weave.same_matrix(weave_from_pattern("twill 2/2 Z")));
        QVERIFY(weave.draft() && *weave.draft() == smallest_draft(weave));
    }
    void doubleClothIsFoundToBeTwo()
    {
        // Ends and picks 1 and 3 above, 2 and 4 below, both plain.
        const Weave weave = from_rows({"1011", "0010", "1110", "1000"});
        const WeaveAnalysis a = analyse(weave);
        QCOMPARE(a.cloths, 2);
        QCOMPARE(a.top_ends, 2);
        QCOMPARE(a.top_picks, 2);
        QVERIFY(a.unbound_ends.empty() && a.unbound_picks.empty());
        QVERIFY(QString::fromStdString(text_of(validate(with_weave(weave)), "separate_cloths"))
                    .contains("fabrics[0].weave: The weave falls into 2 cloths"));
        QCOMPARE(analyse(weave.toggled(1, 0)).cloths, 1); // one stitch joins them
    }
    void aLooseThreadIsNotACloth()
    {
        const WeaveAnalysis a = analyse(from_rows({"101", "011"})); // plain with an end on top
        QCOMPARE(a.cloths, 1);
        QVERIFY(a.unbound_ends == std::vector<int>{2});
    }
    void fallingApartAgreesWithAWalkFromThreadToThread()
    {
        int apart = 0;
        for (std::uint64_t seed = 0; seed < 400; ++seed) {
            const int ends = 2 + static_cast<int>(random_bits(seed, 0, 0) % 5), picks = 2 + static_cast<int>(random_bits(seed, 0, 1) % 5);
            std::vector<std::uint8_t> up;
            for (int i = 0; i < ends * picks; ++i) up.push_back(random_bits(seed, 1, static_cast<std::uint64_t>(i)) & 1);
            const Weave weave(ends, picks, std::move(up));
            const WeaveAnalysis a = analyse(weave);
            const bool whole = a.cloths == 1 && a.top_ends == ends && a.top_picks == picks;
            QCOMPARE(whole, hangs_together(weave));
            apart += !whole;
        }
        QVERIFY(apart > 50 && apart < 350);
    }
    void aLargeWeaveIsAnalysedQuickly()
    {
        const Weave crepe = weave_from_pattern("crepe 2000 seed 3");
        QBENCHMARK_ONCE { QCOMPARE(analyse(crepe).cloths, 1); }
    }
    void floatsLongerThanTenMillimetresAreWarnedOf()
    {
        // 7 picks at 5 per cm are 14 mm; at 8 per cm 8.75 mm.
        const std::string text = text_of(validate(with_weave(weave_from_pattern("satin 8/3"), 5, 1)), "long_float");
        QCOMPARE(QString::fromStdString(text), QString("fabrics[0].weave: The longest warp float passes over 7 threads, 14 mm on the face; "
                                                       "floats over 10 mm snag."));
        QCOMPARE(text_of(validate(with_weave(weave_from_pattern("satin 8/3"), 8, 0.8)), "long_float"), std::string());
    }

    void ashenhurstGivesHalfTheThreadsSideBySideForPlain()
    {
        // 0.2 mm: 50 per cm side by side; r/(r + i) is 2/4 for plain, 4/6 for 2/2 twill, 8/10 for a satin of 8.
        QCOMPARE(jam_gauge(Weave(), 35, 35, 0.2, 0.2).warp.ashenhurst_per_cm, 25.0);
        QVERIFY(std::abs(jam_gauge(Weave(), 35, 35, 0.2, 0.2).warp.ashenhurst_percent - 140) < 1e-9);
        QVERIFY(std::abs(jam_gauge(weave_from_pattern("twill 2/2 Z"), 20, 20, 0.2, 0.2).weft.ashenhurst_per_cm - 100.0 / 3) < 1e-9);
        QVERIFY(std::abs(jam_gauge(weave_from_pattern("satin 8/3"), 20, 20, 0.2, 0.2).warp.ashenhurst_per_cm - 40) < 1e-9);
        // Yarns of 0.2 and 0.3 mm: each end of plain weave needs 0.5 mm.
        QVERIFY(std::abs(jam_gauge(Weave(), 20, 20, 0.2, 0.3).warp.ashenhurst_per_cm - 20) < 1e-9);
    }
    void aWarpRibPacksItsEndsAsPlainAndItsPicksCloser()
    {
        const JamGauge jam = jam_gauge(weave_from_pattern("rib 2/2 warp"), 20, 20, 0.2, 0.2);
        QCOMPARE(jam.warp.ashenhurst_per_cm, 25.0);                       // every end to its neighbour changes
        QVERIFY(std::abs(jam.weft.ashenhurst_per_cm - 100.0 / 3) < 1e-9); // two picks in one shed
    }
    void peircesSquareClothJamsAtPitch0866OfTheSumOfDiameters()
    {
        // cos a = cos b = 1/2: pitch = 0.4 mm x sin 60 degrees.
        const double sett = 10 / (0.4 * std::sqrt(0.75));
        const JamGauge jam = jam_gauge(Weave(), sett, sett, 0.2, 0.2);
        QVERIFY(std::abs(jam.warp.peirce_percent - 100) < 1e-6);
        QVERIFY(std::abs(jam.weft.peirce_percent - 100) < 1e-6);
    }
    void anOpenWeftLetsTheEndsTouchAndACrammedOneKeepsThemTwoDiametersApart()
    {
        QCOMPARE(jam_gauge(Weave(), 20, 5, 0.2, 0.2).warp.peirce_per_cm, 50.0);
        QVERIFY(std::abs(jam_gauge(Weave(), 20, 1e6, 0.2, 0.2).warp.peirce_per_cm - 25) < 1e-3);
        // Picks 0.32 mm apart on 0.4 mm: sin b = 0.8, cos b = 0.6, cos a = 0.4, pitch = 0.4 x sqrt(0.84).
        QVERIFY(std::abs(jam_gauge(Weave(), 20, 31.25, 0.2, 0.2).warp.peirce_per_cm - 10 / (0.4 * std::sqrt(0.84))) < 1e-9);
    }
    void theWeaveFactorIsThePublishedOne()
    {
        const auto factor = [](const char* pattern) { return weave_factor(weave_from_pattern(pattern)); };
        QCOMPARE(factor("plain"), 1.0);
        QVERIFY(std::abs(factor("twill 2/2 Z") - 1.265) < 5e-4); // Milasius
        QVERIFY(std::abs(factor("twill 3/1 Z") - 1.31) < 2e-3);
        // Satin 5: of each yarn's 5 fields 3 are free, one between two that change, two beside one: 3 - 2 (9 + 2 x 10)/(8 x 5) = 1.55.
        QVERIFY(std::abs(factor("satin 5/2") - std::sqrt(3 / 1.55)) < 1e-12);
        QCOMPARE(factor("twill 2/2 S"), factor("twill 2/2 Z"));
        QVERIFY(factor("basket 2/2") > factor("twill 2/2 Z"));
        QCOMPARE(factor("rib 2/2 warp"), factor("rib 2/2 weft"));
    }
    void bothSettsTogetherAreJudged_data()
    {
        QTest::addColumn<QString>("pattern");
        QTest::addColumn<double>("warp_tex");
        QTest::addColumn<double>("weft_tex");
        QTest::addColumn<double>("ends");
        QTest::addColumn<double>("picks");
        QTest::addColumn<double>("density");
        QTest::addColumn<double>("share"); // by hand
        QTest::newRow("poplin") << "plain" << 14.7625 << 14.7625 << 52.4 << 28.3 << 1540.0 << .693;
        QTest::newRow("sheeting") << "plain" << 18.4531 << 18.4531 << 26.8 << 26.8 << 1540.0 << .573;
        QTest::newRow("denim") << "twill 3/1 Z" << 84.3571 << 84.3571 << 26.8 << 17.3 << 1540.0 << .72;
        QTest::newRow("drill") << "twill 3/1 Z" << 36.9062 << 49.2083 << 37.8 << 18.9 << 1540.0 << .593;
        QTest::newRow("sateen") << "satin 5/2" << 9.8417 << 9.8417 << 68.1 << 47.2 << 1540.0 << .607;
        QTest::newRow("nylon taffeta") << "plain" << 7.8 << 7.8 << 44.0 << 34.0 << 1140.0 << .609;
        QTest::newRow("shirting twill") << "twill 2/2 Z" << 19.6833 << 14.7625 << 44.0 << 28.0 << 1540.0 << .564;
        QTest::newRow("voile") << "plain" << 7.4 << 7.4 << 31.0 << 30.0 << 1540.0 << .412;
    }
    void bothSettsTogetherAreJudged()
    {
        QFETCH(QString, pattern);
        QFETCH(double, warp_tex);
        QFETCH(double, weft_tex);
        QFETCH(double, ends);
        QFETCH(double, picks);
        QFETCH(double, density);
        QFETCH(double, share);
        const Weave weave = weave_from_pattern(pattern.toStdString());
        const double found = sett_share({warp_tex, ends, density}, {weft_tex, picks, density}, weave_factor(weave));
        const double within = pattern.startsWith("satin") ? 0.007 : 0.002; // its factor is not a published one
        QVERIFY2(std::abs(found - share) <= within, qPrintable(QString::number(found)));
    }
    void aSquareClothOfSolidYarnsIsAtTheLimitWhereTheyJam()
    {
        // 0.2 mm solid: pitch 0.2 x sqrt 3. Half of it fibre: half the sett.
        const double tex = 1500 * pi / 4 * 0.04, sett = 10 / (0.2 * std::sqrt(3.0));
        QVERIFY(std::abs(sett_share({tex, sett, 1500}, {tex, sett, 1500}, 1) - 1) < 1e-12);
        QVERIFY(std::abs(sett_share({tex, sett / 2, 1500}, {tex, sett / 2, 1500}, 1) - 0.5) < 1e-12);
        QVERIFY(std::abs(sett_share({tex, sett, 1500}, {tex, sett, 1500}, 1.25) - 0.8) < 1e-12);
    }
    void onlyWhatAMillRefusesIsAWarning()
    {
        // Cotton, half of each yarn fibre, 0.2 mm: 24.36 tex; 0.9 of the limit are 0.9/(sqrt 3 x 0.01414 cm) = 36.7 per cm.
        QCOMPARE(text_of(validate(with_weave(Weave(), 35)), "jammed"), std::string()); // Ashenhurst's limit is 25
        const std::vector<Issue> issues = validate(with_weave(Weave(), 37.5));
        QVERIFY(!has_error(issues));
        const QString text = QString::fromStdString(text_of(issues, "jammed"));
        QVERIFY2(text.startsWith("fabrics[0].ends_per_cm: 37.5 ends and 37.5 picks per cm are 92 % of the limit of sett"),
                 qPrintable(text));
    }
    void yarnsThatStayTooThickToBendAreAWarning()
    {
        // Two round yarns of 0.5 mm, 1 mm from face to face when one lies on the other: at a pitch of 0.5 mm both leave the middle plane at
        // 30 degrees at most, which lifts them by 2 (1 - cos 30) = 0.27 of what they need.
        FittedYarns yarns;
        yarns.warp_order = yarns.weft_order = {{0}, {1.0}, {0}, {0}};
        yarns.warp.resize(1);
        yarns.weft.resize(1);
        yarns.warp[0].section = yarns.weft[0].section = {0.5, 0.5};
        yarns.warp[0].packing_factor = yarns.weft[0].packing_factor = densest_squeezed;
        Fabric fabric;
        fabric.ends_per_cm = fabric.picks_per_cm = 20;
        QVERIFY(racetracks_jam(fabric, yarns));
        fabric.ends_per_cm = fabric.picks_per_cm = 10 / (0.5 * std::sqrt(3.0)); // 60 degrees each
        QVERIFY(!racetracks_jam(fabric, yarns));
        // One system far apart lifts by as much as it likes.
        fabric.ends_per_cm = 20;
        fabric.picks_per_cm = 10;
        QVERIFY(!racetracks_jam(fabric, yarns));
        // Flat ones at the same pitch as the jammed round ones: 0.5 - (0.5 - 0.2) = 0.2 of 0.4.
        yarns.warp[0].section = yarns.weft[0].section = {0.5, 0.2};
        fabric.picks_per_cm = 20;
        QVERIFY(racetracks_jam(fabric, yarns));
        yarns.warp[0].section = yarns.weft[0].section = {0.4, 0.1}; // 0.2 of 0.2
        QVERIFY(!racetracks_jam(fabric, yarns));
        // Round and loose ones shrink to a quarter of their section: 0.5 of 0.5.
        yarns.warp[0].section = yarns.weft[0].section = {0.5, 0.5};
        yarns.warp[0].packing_factor = yarns.weft[0].packing_factor = densest_squeezed / 4;
        QVERIFY(!racetracks_jam(fabric, yarns));
        // Packed closer on average, as they are squeezed between crossings; where they cross they are as loose.
        for (auto* all : {&yarns.warp, &yarns.weft}) {
            all->front().area_share = 0.8;
            all->front().packing_factor /= 0.8;
        }
        QVERIFY(!racetracks_jam(fabric, yarns));
    }
};

} // namespace tst_weave_analysis

QTEST_APPLESS_MAIN(tst_weave_analysis::TestWeaveAnalysis)
#include "tst_weave_analysis.moc"
