// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/base/error.h"
#include "core/base/random.h"
#include "core/design/drawdown.h"
#include "core/project/project_file.h"

#include <QTest>

using namespace hygroloom;

namespace {

using Lists = std::vector<std::vector<int>>;

/// A matrix with chosen shares of ups, some threads alike.
Weave random_weave(std::uint64_t seed)
{
    const int ends = 1 + static_cast<int>(random_bits(seed, 0, 0) % 40), picks = 1 + static_cast<int>(random_bits(seed, 0, 1) % 40);
    const std::uint64_t kinds = 1 + random_bits(seed, 0, 2) % 6;
    std::vector<std::uint8_t> up;
    for (int pick = 0; pick < picks; ++pick)
        for (int end = 0; end < ends; ++end)
            up.push_back(random_bits(seed, random_bits(seed, 1, static_cast<std::uint64_t>(end)) % kinds,
                                     random_bits(seed, 2, static_cast<std::uint64_t>(pick)) % kinds) &
                         1);
    return {ends, picks, std::move(up)};
}

Draft four_shaft_twill()
{
    Draft draft;
    draft.shafts = draft.treadles = 4;
    draft.threading = {{0}, {1}, {2}, {3}};
    draft.tie_up = {{0, 3}, {0, 1}, {1, 2}, {2, 3}};
    draft.treadling = {{0}, {1}, {2}, {3}};
    return draft;
}

Design with_weave(const Weave& weave)
{
    Design design;
    Fabric& fabric = design.fabrics.emplace_back();
    fabric.name = "cloth";
    fabric.warp.diameter_mm = fabric.weft.diameter_mm = 0.2;
    fabric.weave = weave;
    return design;
}

std::string refusal(const std::string& draft)
{
    try {
        parse_project(R"({"format": "hygroloom-project", "version": 1, "fabrics": [{"name": "a", "ends_per_cm": 20, "picks_per_cm": 20,
            "warp": {"material": "cotton", "diameter_mm": 0.2}, "weft": {"material": "cotton", "diameter_mm": 0.2}, "weave": {"draft": )" +
                          draft + "}}]}",
                      "p");
    } catch (const FileError& error) {
        return error.what();
    }
    return "accepted";
}

} // namespace

class TestDraft : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aTwillHasAStraightDraw() { QVERIFY(smallest_draft(weave_from_pattern("twill 2/2 Z")) == four_shaft_twill()); }
    void theDrawdownOfATwillsDraftIsTheTwill() { QVERIFY(drawdown(four_shaft_twill()).same_matrix(weave_from_pattern("twill 2/2 Z"))); }
    void aPointedTwillNeedsFourShaftsDrawnToThePointAndBack()
    {
        const Draft draft = smallest_draft(weave_from_pattern("pointed twill 2/2 Z 4"));
        QCOMPARE(draft.shafts, 4);
        QCOMPARE(draft.treadles, 4);
        QVERIFY((draft.threading == Lists{{0}, {1}, {2}, {3}, {2}, {1}}));
    }
    void shaftsAndTreadlesAreAsManyAsThereAreDifferentThreads()
    {
        const Draft huck = smallest_draft(weave_from_pattern("huckaback 5")); // the classic cloth of four shafts
        QCOMPARE(huck.shafts, 4);
        QCOMPARE(smallest_draft(weave_from_pattern("waffle 8")).shafts, 5);
        QCOMPARE(smallest_draft(weave_from_pattern("satin 8/3")).shafts, 8);
        QCOMPARE(smallest_draft(weave_from_pattern("ripstop 12")).shafts, 2);
    }
    void theDrawdownOfTheSmallestDraftIsTheWeave()
    {
        for (const std::string& pattern : common_weave_patterns()) {
            const Weave weave = weave_from_pattern(pattern);
            QVERIFY2(drawdown(smallest_draft(weave)).same_matrix(weave), pattern.c_str());
        }
        for (std::uint64_t seed = 0; seed < 300; ++seed) {
            const Weave weave = random_weave(seed);
            const Draft draft = smallest_draft(weave);
            QCOMPARE(fault_in(draft), std::string());
            QVERIFY(drawdown(draft).same_matrix(weave));
            QVERIFY(drawdown(with_liftplan(draft)).same_matrix(weave));
            QVERIFY(with_tie_up(with_liftplan(draft)) == draft);
        }
    }
    void treadlesPressedTogetherAddUp()
    {
        Draft draft = four_shaft_twill();
        draft.treadling = {{0, 2}, {}, {1}};
        const Weave weave = drawdown(draft);
        for (int end = 0; end < 4; ++end) {
            QCOMPARE(weave.warp_up(end, 0), true);
            QCOMPARE(weave.warp_up(end, 1), false);
            QCOMPARE(weave.warp_up(end, 2), end < 2);
        }
        QVERIFY((with_liftplan(draft).liftplan == Lists{{0, 1, 2, 3}, {}, {0, 1}}));
        QCOMPARE(with_tie_up(draft).treadles, 3);
    }
    void aSinkingShedIsTheComplementExceptForEndsThatAreNotThreaded()
    {
        Draft draft = four_shaft_twill();
        draft.rising_shed = false;
        draft.threading.push_back({});
        const Weave weave = drawdown(draft), rising = weave_from_pattern("twill 2/2 Z");
        for (int pick = 0; pick < 4; ++pick) {
            for (int end = 0; end < 4; ++end) QCOMPARE(weave.warp_up(end, pick), !rising.warp_up(end, pick));
            QCOMPARE(weave.warp_up(4, pick), false);
        }
        QVERIFY(drawdown(with_liftplan(draft)).same_matrix(weave));
        QVERIFY(drawdown(with_tie_up(draft)).same_matrix(weave));
    }
    void anEndOnTwoShaftsIsUpWithEither()
    {
        Draft draft = four_shaft_twill();
        draft.threading = {{0, 2}};
        const Weave weave = drawdown(draft);
        for (int pick = 0; pick < 4; ++pick) QCOMPARE(weave.warp_up(0, pick), true); // one of shafts 1 and 3 is always up
    }
    void aWeaveKeepsItsDraftUntilTheMatrixIsEdited()
    {
        const Weave weave = weave_from_draft(four_shaft_twill());
        QVERIFY(weave.draft() && *weave.draft() == four_shaft_twill());
        QVERIFY(!weave.toggled(0, 0).draft());
        QVERIFY(!(weave == drawdown(four_shaft_twill())));
        QVERIFY(weave == weave_from_draft(four_shaft_twill()));
    }
    void aDraftComesBackFromTheProjectFile()
    {
        Draft twice = four_shaft_twill();
        twice.threading = {{0}, {1, 3}, {}, {2}};
        twice.treadling = {{0, 1}, {}, {3}};
        twice.rising_shed = false;
        twice.private_lines = {"[PRIVATE LOOM]", "Speed=3, \"fast\""};
        for (const Draft& draft : {four_shaft_twill(), with_liftplan(four_shaft_twill()), twice}) {
            const Design design = with_weave(weave_from_draft(draft));
            const Design again = parse_project(format_project(design), "again");
            QVERIFY(again == design);
            QVERIFY(*again.fabrics[0].weave.draft() == draft);
        }
    }
    void aWrongDraftIsRefusedAtItsPlace_data()
    {
        QTest::addColumn<QString>("draft");
        QTest::addColumn<QString>("sentence");
        const auto row = [](const char* draft, const char* sentence) { QTest::newRow(sentence) << draft << sentence; };
        row(R"({"shafts": 2, "treadles": 2, "threading": [1, 3], "tie_up": [[1], [2]], "treadling": [1, 2]})",
            "p: fabrics[0].weave.draft.threading[1]: A shaft must be from 1 to 2; given is 3.");
        row(R"({"shafts": 2, "treadles": 2, "threading": [1, 2], "tie_up": [[1], [2]], "treadling": [1, [2, 3]]})",
            "p: fabrics[0].weave.draft.treadling[1]: A treadle must be from 1 to 2; given is 3.");
        row(R"({"shafts": 2, "threading": [1, 2], "liftplan": [[1], [4]]})",
            "p: fabrics[0].weave.draft.liftplan[1]: A shaft must be from 1 to 2; given is 4.");
        row(R"({"shafts": 0, "threading": [1, 2], "liftplan": [[1], [2]]})",
            "p: fabrics[0].weave.draft.shafts: The number of shafts must be from 1 to 2000; given is 0.");
        row(R"({"shafts": 2, "treadles": 2001, "threading": [1, 2], "tie_up": [], "treadling": [1]})",
            "p: fabrics[0].weave.draft.treadles: The number of treadles must be from 1 to 2000; given is 2001.");
        row(R"({"shafts": 2, "treadles": 2, "threading": [1, 2], "tie_up": [[1]], "treadling": [1]})",
            "p: fabrics[0].weave.draft.tie_up: Each of the 2 treadles needs its list of shafts; given are 1.");
        row(R"({"shafts": 2, "treadles": 2, "threading": [1, 1.5], "tie_up": [[1], [2]], "treadling": [1]})",
            "p: fabrics[0].weave.draft.threading[1]: This must be a whole number of 1 or more; given is 1.5.");
        row(R"({"shafts": 2, "threading": [], "liftplan": [[1]]})",
            "p: fabrics[0].weave.draft.threading: The number of ends must be from 1 to 2000; given is 0.");
        row(R"({"shafts": 2, "threading": [1], "liftplan": []})",
            "p: fabrics[0].weave.draft.liftplan: The liftplan needs a list of shafts for each pick; it is empty.");
        row(R"({"shafts": 2, "threading": [1], "liftplan": [[1]], "treadles": 2})",
            "p: fabrics[0].weave.draft: There is no key \"treadles\" here");
        row(R"({"shafts": 2, "threading": [1], "liftplan": [[1]], "rising_shed": 1})",
            "p: fabrics[0].weave.draft.rising_shed: This must be true or false; given is 1.");
    }
    void aWrongDraftIsRefusedAtItsPlace()
    {
        QFETCH(QString, draft);
        QFETCH(QString, sentence);
        const QString given = QString::fromStdString(refusal(draft.toStdString()));
        if (sentence.contains("no key"))
            QVERIFY2(given.contains("treadles"), qPrintable(given));
        else
            QCOMPARE(given, sentence);
    }
    void setReplacesADraftByAPattern()
    {
        const Design design = with_value(with_weave(weave_from_draft(four_shaft_twill())), "fabrics[0].weave.pattern", "plain");
        QVERIFY(design.fabrics[0].weave == Weave());
    }
    void aLargeDraftIsDrawnDownQuickly()
    {
        const Weave crepe = weave_from_pattern("crepe 2000 seed 3");
        QBENCHMARK_ONCE { QVERIFY(drawdown(smallest_draft(crepe)).same_matrix(crepe)); }
    }
};

QTEST_APPLESS_MAIN(TestDraft)
#include "tst_draft.moc"
