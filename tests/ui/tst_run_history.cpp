// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The list of runs: their numbers when their recordings move.
#include "tests/support/drop_design.h"
#include "ui/results/run_history.h"

#include <QSignalSpy>
#include <QTest>

#include <functional>

using namespace hygroloom;

class TestRunHistory : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aRunThatMovesHasTheNumberThatItGetsThere()
    {
        RunHistory history;
        for (const int number : {1, 2}) { history.keep(run(QString("/unsaved/run-%1.hygrorec").arg(number), number)); }
        history.move("/unsaved/run-1.hygrorec", "/filed/run-2.hygrorec", true);
        history.move("/unsaved/run-2.hygrorec", "/filed/run-3.hygrorec", true);
        QCOMPARE(history.find("/filed/run-2.hygrorec")->number, 2);
        QCOMPARE(history.find("/filed/run-3.hygrorec")->number, 3);
        history.keep(run("/filed/run-1.hygrorec", 1));
        QCOMPARE(history.runs().front().path, QString("/filed/run-1.hygrorec"));
    }

    void twoRunsNeverHaveOneNumber()
    {
        RunHistory history;
        history.keep(run("/unsaved/run-1.hygrorec", 1));
        KeptRun opened = run("/elsewhere/run-9.hygrorec", 0);
        opened.own = false;
        history.keep(opened);
        QCOMPARE(history.find(opened.path)->number, 2);
        history.move("/unsaved/run-1.hygrorec", "/filed/run-2.hygrorec", true);
        QCOMPARE(history.find("/filed/run-2.hygrorec")->number, 2);
        QCOMPARE(history.find(opened.path)->number, 1);
    }

    void aRunIsListedOnceWhenItWasFoundWhereItMovesTo()
    {
        RunHistory history;
        history.keep(run("/unsaved/run-1.hygrorec", 1));
        history.keep(run("/filed/run-1.hygrorec", 1));
        history.move("/unsaved/run-1.hygrorec", "/filed/run-1.hygrorec", true);
        QCOMPARE(history.runs().size(), std::size_t{1});
        QCOMPARE(history.runs().front().number, 1);
    }

    void aRunWithoutItsNumbersIsNotCompared()
    {
        const KeptRun bare = run("/run-1.hygrorec", 1);
        KeptRun whole = bare;
        whole.metrics = std::make_shared<const Metrics>();
        QVERIFY(whyNotCompared(whole, whole).isEmpty());
        QVERIFY(whyNotCompared(bare, whole).contains("being read"));
        whole.problem = "it is damaged.";
        QCOMPARE(whyNotCompared(whole, bare), whole.problem);
    }

    /// A garment's run depends on the fabrics that its panels name, not on others of the project.
    void aGarmentsRunStaysCurrentWhateverElseChanges()
    {
        Design then = drop_design();
        for (const char* name : {"lining", "other"}) {
            then.fabrics.push_back(then.fabrics[0]);
            then.fabrics.back().name = name;
        }
        Garment tee;
        tee.name = "tee";
        tee.panels["*"].fabric = then.fabrics[0].name;
        tee.panels["back"] = tee.panels["*"];
        tee.panels["back"].lining = "lining";
        then.garments = {tee};
        WearExperiment wear;
        wear.name = "wear";
        wear.garment = "tee";
        then.wears = {wear};
        const auto holds = [&](const std::function<void(Design&)>& change) {
            Design now = then;
            change(now);
            return garmentHoldsFor(then, "tee", "wear", now);
        };
        QVERIFY(holds([](Design&) {}));
        QVERIFY(holds([](Design& now) { now.fabrics.push_back(now.fabrics[0]), now.fabrics.back().name = "new"; }));
        QVERIFY(holds([](Design& now) { now.fabrics[2].contact_angle_deg = 12; }));
        QVERIFY(!holds([](Design& now) { now.fabrics[0].contact_angle_deg = 12; }));
        QVERIFY(!holds([](Design& now) { now.fabrics[1].contact_angle_deg = 12; }));
        QVERIFY(!holds([](Design& now) { now.fabrics.erase(now.fabrics.begin() + 1); }));
        QVERIFY(!holds([](Design& now) { now.garments[0].panels["back"].fabric = "other"; }));
        QVERIFY(!holds([](Design& now) { now.wears[0].duration_s += 1; }));
        QVERIFY(holds([](Design& now) { now.liquids.push_back({}), now.liquids.back().name = "unused"; }));
    }

    void aGarmentOfOneFabricIsComparedHoweverTheProjectCutsIt()
    {
        RunRecord run;
        run.design = drop_design();
        run.design.fabrics.push_back(run.design.fabrics[0]);
        run.design.fabrics[1].name = "other";
        Garment tee;
        tee.name = "tee";
        cut_all_from(tee, "other");
        run.design.garments = {tee};
        WearExperiment wear;
        wear.name = "wear";
        wear.garment = "tee";
        run.design.wears = {wear};
        run.fabric = "tee";
        run.experiment = "wear";
        Design now = run.design;
        cut_all_from(now.garments[0], now.fabrics[0].name);
        QVERIFY(!garmentHoldsFor(run.design, "tee", "wear", now));
        QVERIFY(holdsFor(run, now));
        RunRecord recut = run;
        recut.design = now;
        QVERIFY(conditionsOf(recut) == conditionsOf(run));
        now.fabrics[1].contact_angle_deg = 12;
        now.garments[0].wearer.skin_temperature_c += 1;
        QCOMPARE(differencesOf(run, now), (QStringList{"garment", "fabric"}));
        now.garments.clear();
        now.wears.clear();
        QCOMPARE(differencesOf(run, now), (QStringList{"experiment is gone", "garment is gone", "fabric"}));
        run.design.garments[0].panels["front"].fabric = run.design.fabrics[0].name; // of two: as it is cut, and no other
        KeptRun kept{"a", std::make_shared<const RunRecord>(run), nullptr};
        kept.worn = true;
        QVERIFY(kept.cloth().empty());
        QVERIFY(!holdsFor(run, recut.design));
    }

    void whatDiffersIsNamed()
    {
        RunRecord run;
        run.design = drop_design();
        run.design.fabrics.push_back(run.design.fabrics[0]);
        run.design.fabrics[1].name = "other";
        run.fabric = run.design.fabrics[0].name;
        run.experiment = run.design.experiments[0].name;
        QVERIFY(holdsFor(run, run.design));
        Design now = run.design;
        now.experiments[0].sample_mm = {33, 44};
        QCOMPARE(differencesOf(run, now), QStringList{"sample"});
        now.experiments[0].duration_s += 1;
        now.fabrics[0].ends_per_cm += 1;
        QCOMPARE(differencesOf(run, now), (QStringList{"experiment", "fabric"}));
        now = run.design;
        now.experiments.clear();
        QCOMPARE(differencesOf(run, now), QStringList{"experiment is gone"});
    }

    /// The list says in what an older run differs: also the second difference is a change.
    void aFurtherDifferenceIsAChange()
    {
        const auto design = std::make_shared<Design>(drop_design());
        RunHistory history;
        history.setDesign(design);
        KeptRun kept = run("/run-1.hygrorec", 1);
        auto record = std::make_shared<RunRecord>(*kept.run);
        record->design = *design;
        record->fabric = design->fabrics[0].name;
        record->experiment = design->experiments[0].name;
        kept.run = record;
        history.keep(kept);
        QSignalSpy changes(&history, &RunHistory::changed);
        const auto edited = [&](const auto& work) {
            auto now = std::make_shared<Design>(*history.design());
            work(*now);
            history.setDesign(now);
            return changes.count();
        };
        QCOMPARE(edited([](Design& d) { d.fabrics[0].ends_per_cm += 1; }), 1);
        QCOMPARE(edited([](Design& d) { d.fabrics[0].ends_per_cm += 1; }), 1); // it says the same
        QCOMPARE(edited([](Design& d) { d.experiments[0].duration_s += 1; }), 2);
        QVERIFY(!history.runs().front().current);
    }

    /// A fibre of one's own, made for another fabric, makes no run of this one an older one.
    void fibresOfOtherFabricsDoNotMatter()
    {
        RunRecord run;
        run.design = drop_design();
        run.fabric = run.design.fabrics[0].name;
        run.experiment = run.design.experiments[0].name;
        Design now = run.design;
        now.materials.push_back(*find_library_material("wool"));
        now.materials.back().name = "own wool";
        QVERIFY(holdsFor(run, now));
        now.materials.push_back(*find_library_material(now.fabrics[0].warp.material[0].name));
        now.materials.back().fibre_radius_um += 1;
        QCOMPARE(differencesOf(run, now), QStringList{"fibres"});
    }

    /// The same design may have other numbers in another version of the program.
    void aRunOfAnotherProgramIsAnOlderOne()
    {
        RunRecord run;
        run.design = drop_design();
        run.fabric = run.design.fabrics[0].name;
        run.experiment = run.design.experiments[0].name;
        QVERIFY(holdsFor(run, run.design));
        run.answers = "of other sources";
        QCOMPARE(differencesOf(run, run.design), QStringList{"program"});
    }

private:
    static KeptRun run(const QString& path, int number)
    {
        KeptRun made;
        made.path = path;
        auto record = std::make_shared<RunRecord>();
        record->wall = 1;
        made.run = record;
        made.own = true;
        made.number = number;
        return made;
    }
};

QTEST_MAIN(TestRunHistory)
#include "tst_run_history.moc"
