// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The wet map that follows edits: it is of the design as it is, short enough for a moment, and costs nothing when nobody looks.
#include "core/base/units.h"
#include "core/run/runner.h"
#include "gpu/backends.h"
#include "tests/support/drop_design.h"
#include "ui/document/document.h"
#include "ui/results/live_panel.h"
#include "ui/results/water_map_view.h"

#include <QCheckBox>
#include <QDir>
#include <QEventLoop>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <thread>

using namespace hygroloom;

namespace {

constexpr int patience = 20000; // ms

Design two_cloths()
{
    Design design = drop_design(35, 0.3);
    design.experiments[0].closure = Closure::pores;
    design.fabrics.push_back(design.fabrics[0]);
    design.fabrics[1].name = "other";
    return design;
}

void setAngle(Document& document, double angle, std::size_t fabric = 0)
{
    document.edit("angle", "angle", [&](Design& design) { design.fabrics[fabric].contact_angle_deg = angle; });
}

/// nullptr: refused
std::shared_ptr<const Answer> answerOf(const Design& design, const LiveCut& cut)
{
    LiveAnswer live(cut);
    std::shared_ptr<const Answer> answer;
    QEventLoop waits;
    QObject::connect(&live, &LiveAnswer::refused, &waits, &QEventLoop::quit);
    QObject::connect(&live, &LiveAnswer::answered, &waits, [&](const std::shared_ptr<const Answer>& given) {
        answer = given;
        waits.quit();
    });
    live.ask(std::make_shared<const Design>(design), 0, 0);
    waits.exec();
    return answer;
}

double angleOf(const Answer& answer) { return answer.run->design.fabrics[0].contact_angle_deg.value_or(-1); }

} // namespace

class TestLive : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QSettings().remove("live/refine"); }

    void itsCutFollowsTheClothAndTheTest()
    {
        Design design = two_cloths(); // 35 ends and picks per cm
        QCOMPARE(cutOf(design.fabrics[0], design.experiments[0]).length, 1.0);
        QCOMPARE(cutOf(design.fabrics[0], standard_experiment(ExperimentType::moisture_management)).length, 2.0);
        QCOMPARE(cutOf(design.fabrics[0], standard_experiment(ExperimentType::drying)).length, 60.0);
        Experiment& sweat = design.experiments[0] = standard_experiment(ExperimentType::sweat);
        QCOMPARE(cutOf(design.fabrics[0], sweat).length, 10.0);
        sweat.sample_mm = {20, 20};
        QCOMPARE(cutOf(design.fabrics[0], sweat).halvings, 0);
        sweat.sample_mm = {100, 100};
        QCOMPARE(cutOf(design.fabrics[0], sweat).halvings, 3);
        sweat.sample_mm = {500, 500};
        QCOMPARE(cutOf(design.fabrics[0], sweat).halvings, 5);
        sweat.sample_mm = {5, 500};
        QCOMPARE(cutOf(design.fabrics[0], sweat).halvings, 3); // 5 x 62.5 mm
    }

    /// The cut once followed the time that answers took, and with it the load of the machine.
    void theAnswerIsTheSameHoweverBusyTheMachineIs()
    {
        Design design = two_cloths();
        design.experiments[0].duration_s = 20;
        std::vector<std::shared_ptr<const Answer>> answers;
        std::atomic<bool> busy{true};
        std::vector<std::thread> load;
        for (int turn = 0; turn < 3; ++turn) {
            for (int k = 0; k < 3 * turn; ++k) {
                load.emplace_back([&busy] {
                    while (busy) {}
                });
            }
            LiveAnswer live; // of one panel, which once learned from answer to answer
            QObject::connect(&live, &LiveAnswer::answered, &live, [&](const auto& answer) { answers.push_back(answer); });
            for (int again = 0; again < 2; ++again) {
                const std::size_t before = answers.size();
                live.ask(std::make_shared<const Design>(design), 0, 0);
                QTRY_VERIFY_WITH_TIMEOUT(answers.size() > before, patience);
            }
        }
        busy = false;
        for (std::thread& each : load) { each.join(); }
        QCOMPARE(answers.size(), std::size_t(6));
        for (const auto& answer : answers) {
            QCOMPARE(answer->run->design.experiments[0].duration_s, 1.0);
            QCOMPARE(answer->run->design.experiments[0].sample_mm, answers[0]->run->design.experiments[0].sample_mm);
            QCOMPARE(answer->top.stain->radius, answers[0]->top.stain->radius);
            for (std::size_t k = 0; k < answer->numbers.size(); ++k) { QCOMPARE(answer->numbers[k].value, answers[0]->numbers[k].value); }
        }
    }

    void ofAPartOfTheTestThereIsNoIndexAndNoGrade()
    {
        Design design = two_cloths();
        Experiment& test = design.experiments[0] = standard_experiment(ExperimentType::moisture_management);
        test.name = "test";
        test.sample_mm = {20, 20};
        test.volume_ul = 5;
        test.feed_s = 1;
        test.duration_s = 6;
        Document document;
        document.take(design, "test");
        LivePanel panel(document);
        panel.setVisible(true);
        const auto names = [&panel] {
            QStringList all;
            for (const Result& number : panel.answer()->numbers) { all << number.name + " " + number.value + " " + number.bottom; }
            return all.join('\n');
        };
        QTRY_VERIFY_WITH_TIMEOUT(panel.answer(), patience);
        QVERIFY(!panel.answer()->whole);
        QCOMPARE(panel.answer()->run->design.experiments[0].duration_s, 3.0); // 2 s after the first drop
        for (const char* index : {"OMMC", "ne-way", "preading speed", "bsorption rate", "Class", "(1)", "(2)", "(3)", "(4)", "(5)"}) {
            QVERIFY2(!names().contains(index), qPrintable(names()));
        }
        QVERIFY2(names().contains("etted radius"), qPrintable(names())); // the stain after so long
        QVERIFY2(panel.status().contains("need the whole test"), qPrintable(panel.status()));
        QTRY_VERIFY_WITH_TIMEOUT(panel.answer() && panel.answer()->whole, patience);
        QVERIFY2(names().contains("OMMC"), qPrintable(names()));
        QVERIFY(!panel.status().contains("need the whole test"));
    }

    void anOldAnswerIsMarkedUntilTheNewOneIsThere()
    {
        Document document;
        document.take(two_cloths(), "drops");
        LivePanel panel(document);
        panel.setVisible(true);
        QTRY_VERIFY_WITH_TIMEOUT(panel.answer(), patience);
        QVERIFY(!panel.outdated());
        const QImage fresh = panel.grab().toImage();
        setAngle(document, 70);
        QVERIFY(panel.outdated());
        QVERIFY2(panel.status().startsWith("Computing."), qPrintable(panel.status()));
        QVERIFY(panel.grab().toImage() != fresh);
        QTRY_VERIFY_WITH_TIMEOUT(panel.answer(), patience);
        QVERIFY(!panel.outdated());
    }

    void aCutSampleHoldsWhatFallsOnItAndARepeat()
    {
        Design design = two_cloths();
        Experiment& drop = design.experiments[0];
        const auto sides = [&](int halvings) {
            return cutDesign(design, 0, 0, {.length = 1, .halvings = halvings}).experiments[0].sample_mm;
        };
        drop.sample_mm = {100, 60};
        drop.droplets[0].volume_ul = 4.0 / 3 * pi; // a radius of 1 mm
        drop.droplets[0].at_mm = {0, -5};
        QCOMPARE(sides(0), (std::array<double, 2>{100, 60}));
        QCOMPARE(sides(1), (std::array<double, 2>{50, 30}));
        QCOMPARE(sides(9), (std::array<double, 2>{16, 16}));
        design.fabrics[0].weave = Weave(100, 4, std::vector<std::uint8_t>(400, 1));
        QVERIFY(sides(9)[0] >= 10 * 100 / design.fabrics[0].ends_per_cm);
        drop = standard_experiment(ExperimentType::vertical_wicking);
        drop.sample_mm = {5, 120};
        QCOMPARE(sides(1), (std::array<double, 2>{5, 60}));
        QCOMPARE(sides(9), (std::array<double, 2>{5, drop.immersion_mm + 20}));
        drop = standard_experiment(ExperimentType::sweat);
        drop.sample_mm = {4, 40};
        design.fabrics[0].weave = Weave();
        QCOMPARE(sides(9), (std::array<double, 2>{4, 5}));
    }

    void aFeedInDropsIsSeen()
    {
        Design design = two_cloths();
        Experiment& feed = design.experiments[0] = standard_experiment(ExperimentType::moisture_management);
        feed.name = "feed";
        feed.drop_ul = 25;
        feed.volume_ul = 50;
        const auto answer = answerOf(design, {.length = 0.2, .halvings = 1});
        QVERIFY(answer && answer->run->design.experiments[0].duration_s > 10); // the pump has delivered the first drop
        QVERIFY(answer->top.stain->radius > 0);
    }

    void aDropPastTheEndIsRefusedAndSeenOnceItIsMended()
    {
        Design design = two_cloths();
        design.experiments[0].duration_s = 2;
        Document document;
        document.take(design, "drops");
        LivePanel panel(document);
        panel.setVisible(true);
        QTRY_VERIFY_WITH_TIMEOUT(panel.answer(), patience);
        const auto setTime = [&](double time) {
            document.edit("time", std::to_string(time), [time](Design& d) { d.experiments[0].droplets[0].time_s = time; });
        };
        setTime(9);
        QTRY_VERIFY2_WITH_TIMEOUT(panel.status().contains("9 s"), qPrintable(panel.status()), patience);
        QVERIFY(!panel.answer());
        setTime(1.5);
        QTRY_VERIFY_WITH_TIMEOUT(panel.answer(), patience);
        QVERIFY(panel.answer()->top.stain->radius > 0);
    }

    void ofALongExperimentTheWholeIsExpectedToTakeLonger()
    {
        Design design = two_cloths();
        design.experiments[0] = standard_experiment(ExperimentType::sweat);
        design.experiments[0].name = "sweat";
        design.experiments[0].sample_mm = {20, 20};
        design.experiments[0].duration_s = 20;
        const double small = answerOf(design, {.length = 1, .halvings = 2})->wall_of_all;
        design.experiments[0].sample_mm = {200, 200};
        const double large = answerOf(design, {.length = 1, .halvings = 5})->wall_of_all;
        QVERIFY2(small > 0 && large > 10 * small, qPrintable(QString("%1 %2").arg(small).arg(large)));
    }

    /// At the edge of a cut sample water would find an end that the cloth does not have.
    void waterAtTheEdgeAsksForMoreOfTheSample()
    {
        Design design = two_cloths();
        design.experiments[0].sample_mm = {20, 20};
        const auto answer = answerOf(design, {.length = 0.3, .halvings = 3});
        QVERIFY(answer);
        const double side = answer->run->design.experiments[0].sample_mm[0];
        const double least = cutDesign(design, 0, 0, {.length = 0.3, .halvings = 3}).experiments[0].sample_mm[0];
        QVERIFY2(side > least && !answer->edge_is_wet, qPrintable(QString("%1 > %2").arg(side).arg(least)));
        QVERIFY(answer->top.stain->radius > 0.5e-3 * least); // it would have been there
    }

    /// Where all of the cloth changes alike, a part of it tells what the whole does, in wind as well.
    void aPartOfTheSampleTellsOfTheWhole()
    {
        Design design = two_cloths();
        design.experiments[0] = standard_experiment(ExperimentType::sweat);
        design.experiments[0].name = "sweat";
        design.experiments[0].sample_mm = {20, 20};
        design.experiments[0].duration_s = 20;
        for (Yarn* yarn : yarns_of(design.fabrics[0])) { yarn->irregularity_cv = 0; } // more cloth has thicker places
        const auto part = answerOf(design, {.length = 20, .halvings = 2}), whole = answerOf(design, {.length = 20});
        QVERIFY(part && whole && !part->ofAllCloth() && whole->ofAllCloth());
        QVERIFY2(whole->most > 0 && std::abs(part->most / whole->most - 1) < 0.02,
                 qPrintable(QString("%1 %2").arg(part->most).arg(whole->most)));
    }

    void everyEditIsAnsweredByTheNewDesign()
    {
        Document document;
        document.take(two_cloths(), "drops");
        LivePanel panel(document);
        panel.setVisible(true);
        QTRY_VERIFY_WITH_TIMEOUT(panel.answer(), patience);
        const double before = panel.answer()->top.stain->radius;
        QVERIFY(before > 0);
        QVERIFY2(panel.status().startsWith("Live: ") && panel.status().contains("after 0.3 s"), qPrintable(panel.status()));
        setAngle(document, 80);
        QVERIFY(!panel.answer());
        QTRY_VERIFY_WITH_TIMEOUT(panel.answer(), patience);
        QCOMPARE(angleOf(*panel.answer()), 80.0);
        QVERIFY(panel.answer()->top.stain->radius < before);
        QVERIFY(panel.answer()->numbers.size() > 3);
        document.setFabricIndex(1);
        QTRY_VERIFY_WITH_TIMEOUT(panel.answer(), patience);
        QCOMPARE(panel.answer()->run->fabric, std::string("other"));
    }

    /// The same run in Simulate.
    void itsColoursReachAsFarAsThoseOfSimulate()
    {
        Document document;
        document.take(two_cloths(), "drops");
        ColorRanges ranges;
        LivePanel panel(document);
        panel.shareRanges(ranges);
        panel.setVisible(true);
        QTemporaryDir folder;
        double least = 0;
        for (const double volume : {2.0, 0.3, 5.0}) { // each by itself would end elsewhere
            document.edit("drop", "drop", [&](Design& design) { design.experiments[0].droplets[0].volume_ul = volume; });
            QTRY_VERIFY_WITH_TIMEOUT(panel.answer() && panel.answer()->whole, patience);
            RunOptions options;
            options.fidelity = Fidelity::live;
            options.threads = 1;
            options.recording = folder.filePath(QString("%1.hygrorec").arg(volume)).toStdString();
            RunControl control;
            const auto backend = make_backend("cpu");
            const Design& design = *document.design();
            run_experiment(design, design.fabrics[0].name, design.experiments[0].name, options, *backend, control, {});
            Playback playback;
            WaterMapView maps(playback);
            maps.shareRanges(ranges);
            playback.open(QString::fromStdString(options.recording.string()));
            QTRY_VERIFY_WITH_TIMEOUT(playback.whole(), patience);
            QTRY_VERIFY_WITH_TIMEOUT(maps.top().map().columns > 0, patience);
            QCOMPARE(maps.range(), panel.range());
            QVERIFY(panel.range() > 0 && panel.range() >= least); // a colour keeps its meaning
            least = panel.range();
        }
    }

    void itsColoursStayWhileThereIsAnError()
    {
        Document document;
        document.take(two_cloths(), "drops");
        LivePanel panel(document);
        panel.setVisible(true);
        QTRY_VERIFY_WITH_TIMEOUT(panel.answer() && panel.answer()->whole, patience);
        const double range = panel.range();
        QVERIFY(range > 0);
        setAngle(document, 200); // an error, which clears the map
        QTRY_VERIFY_WITH_TIMEOUT(!panel.answer() && panel.range() == 0, patience);
        setAngle(document, 40);
        QTRY_VERIFY_WITH_TIMEOUT(panel.answer(), patience);
        QCOMPARE(panel.range(), range); // that of a part, too
    }

    void ofManyEditsTheLastIsAnsweredAndStaleOnesEnd()
    {
        Document document;
        document.take(two_cloths(), "drops");
        LivePanel panel(document);
        QSignalSpy changed(&panel, &LivePanel::changed);
        panel.setVisible(true);
        for (int i = 0; i < 50; ++i) {
            setAngle(document, 20 + i);
            QTest::qWait(2);
        }
        QTRY_VERIFY_WITH_TIMEOUT(panel.answer(), patience);
        QCOMPARE(angleOf(*panel.answer()), 69.0);
        QVERIFY2(changed.size() < 25, qPrintable(QString::number(changed.size())));
    }

    void nothingIsComputedForAPanelThatIsNotSeen()
    {
        Document document;
        document.take(two_cloths(), "drops");
        LivePanel panel(document);
        QSignalSpy changed(&panel, &LivePanel::changed);
        setAngle(document, 50);
        QTest::qWait(500);
        QCOMPARE(changed.size(), 0);
        panel.setVisible(true);
        QTRY_VERIFY_WITH_TIMEOUT(panel.answer(), patience);
        panel.setVisible(false);
        changed.clear();
        setAngle(document, 60);
        QTest::qWait(500);
        QCOMPARE(changed.size(), 0);
    }

    void anErrorElsewhereDoesNotMatterOneHereIsTold()
    {
        Document document;
        document.take(two_cloths(), "drops");
        LivePanel panel(document);
        panel.setVisible(true);
        document.edit("sett", "sett", [](Design& design) {
            design.fabrics[1].ends_per_cm = -1;
            design.wears.emplace_back().name = "worn"; // a garment that the project lacks
        });
        QTRY_VERIFY_WITH_TIMEOUT(panel.answer(), patience);
        document.edit("sett", "other", [](Design& design) { design.fabrics[0].ends_per_cm = -1; });
        QVERIFY(!panel.answer());
        QVERIFY2(panel.status().startsWith("The fabric has an error"), qPrintable(panel.status()));
        QCOMPARE(panel.findChild<WaterMap*>()->map().columns, 0); // nothing is shown of another cloth
        document.edit("none", "none", [](Design& design) {
            design.fabrics[0].ends_per_cm = 30;
            design.experiments.clear();
        });
        QVERIFY2(panel.status().contains("Add an experiment"), qPrintable(panel.status()));
    }

    void aDropThatComesLateIsSeen()
    {
        Design design = two_cloths();
        design.experiments[0].duration_s = 60;
        design.experiments[0].droplets[0].time_s = 30;
        Document document;
        document.take(design, "drops");
        LivePanel panel(document);
        panel.setVisible(true);
        QTRY_VERIFY_WITH_TIMEOUT(panel.answer(), patience);
        QVERIFY(panel.answer()->run->design.experiments[0].duration_s > 30);
        QVERIFY(panel.answer()->top.stain->radius > 0);
    }

    void whoPausesAndAsksForItGetsAFinerAnswer()
    {
        Design design = two_cloths();
        design.experiments[0] = standard_experiment(ExperimentType::sweat); // of particles a finer answer would take half a minute
        design.experiments[0].name = "sweat";
        design.experiments[0].sample_mm = {8, 8};
        design.experiments[0].duration_s = 5;
        Document document;
        document.take(design, "drops");
        LivePanel panel(document);
        panel.setVisible(true);
        QTRY_VERIFY_WITH_TIMEOUT(panel.answer(), patience);
        QTest::qWait(1500);
        QCOMPARE(panel.answer()->run->plan.fidelity, Fidelity::live); // unless one asks
        panel.findChild<QCheckBox*>()->click();
        QTRY_VERIFY_WITH_TIMEOUT(panel.answer() && panel.answer()->run->plan.fidelity == Fidelity::draft, patience);
        QVERIFY(panel.status().startsWith("Draft"));
        QTRY_VERIFY_WITH_TIMEOUT(panel.answer() && panel.answer()->run->plan.fidelity == Fidelity::standard, 3 * patience);
        setAngle(document, 60);
        QTRY_VERIFY_WITH_TIMEOUT(panel.answer(), patience);
        QCOMPARE(panel.answer()->run->plan.fidelity, Fidelity::live);
    }

    void aBatteryThatIsUsedUpIsSeen()
    {
        QTemporaryDir folder;
        const auto supply = [&](const char* name, const char* status, const char* scope) {
            QDir(folder.path()).mkpath(name);
            for (const auto& [file, text] : {std::pair{"status", status}, std::pair{"scope", scope}}) {
                QFile at(folder.filePath(QString(name) + "/" + file));
                if (*text && at.open(QIODevice::WriteOnly)) { at.write(QByteArray(text) + "\n"); }
            }
        };
        QVERIFY(!runsOnBattery(folder.filePath("none")));
        supply("AC", "", "");
        supply("mouse", "Discharging", "Device");
        supply("BAT0", "Charging", "");
        QVERIFY(!runsOnBattery(folder.path()));
        supply("BAT1", "Discharging", "");
        QVERIFY(runsOnBattery(folder.path()));
    }
};

QTEST_MAIN(TestLive)
#include "tst_live.moc"
