// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The wet map that follows edits: it is of the design as it is, short enough for a moment, and costs nothing when nobody looks.
#include "core/run/runner.h"
#include "gpu/backends.h"
#include "tests/support/drop_design.h"
#include "ui/document/document.h"
#include "ui/results/live_panel.h"
#include "ui/results/water_map_view.h"

#include <QCheckBox>
#include <QDir>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

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

double angleOf(const Answer& answer) { return answer.run->design.fabrics[0].contact_angle_deg.value_or(-1); }

} // namespace

class TestLive : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QSettings().remove("live/refine"); }

    void itsLengthFollowsTheTimeThatItTook()
    {
        QCOMPARE(lengthThatFits(1, 10, 0.15), 1.0);
        QCOMPARE(lengthThatFits(1, 10, 0.05), 2.0);
        QCOMPARE(lengthThatFits(5, 10, 0.01), 10.0);
        QCOMPARE(lengthThatFits(10, 10, 0.01), 10.0);
        QCOMPARE(lengthThatFits(2, 10, 0.3), 1.0);
        QCOMPARE(lengthThatFits(1, 10, 0.3), 0.5);
        QCOMPARE(lengthThatFits(7, 7, 0.3), 5.0);
        QCOMPARE(lengthThatFits(0.1, 10, 9), 0.1);
        QCOMPARE(lengthThatFits(1000, 86400, 0.01), 2000.0);
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
        LivePanel panel(document);
        panel.setVisible(true);
        QTemporaryDir folder;
        for (const double volume : {2.0, 0.3, 5.0, 4.0}) { // the range follows each, whatever was before
            document.edit("drop", "drop", [&](Design& design) { design.experiments[0].droplets[0].volume_ul = volume; });
            QTRY_VERIFY_WITH_TIMEOUT(panel.answer() && panel.answer()->simulated >= panel.answer()->duration, patience);
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
            playback.open(QString::fromStdString(options.recording.string()));
            QTRY_VERIFY_WITH_TIMEOUT(playback.whole(), patience);
            QTRY_COMPARE_WITH_TIMEOUT(maps.range(), panel.range(), patience);
            QVERIFY(panel.range() > 0);
        }
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
        QVERIFY(panel.answer()->simulated > 30);
        QVERIFY(panel.answer()->top.stain->radius > 0);
    }

    void whoPausesAndAsksForItGetsAFinerAnswer()
    {
        Design design = two_cloths();
        design.experiments[0].duration_s = 0.15;
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
