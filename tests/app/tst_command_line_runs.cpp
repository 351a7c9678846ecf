// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// simulate and measure from end to end, and Ctrl-C.
#include "command_line.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>

class TestCommandLineRuns : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;

    QStringList short_run(const QString& recording) const
    {
        return {"simulate",
                example("one-drop-on-cotton.hygro"),
                "--fidelity",
                "draft",
                "--backend",
                "cpu",
                "--set",
                "experiments[0].duration_s=0.05",
                "experiments[0].sample_mm=[8,8]",
                "experiments[0].droplets[0].volume_ul=2",
                "experiments[0].droplets[0].height_mm=0",
                "fidelity.particles_per_droplet=200",
                "-o",
                recording};
    }

    static QStringList small_drop()
    {
        return {"experiments.one drop.duration_s=0.05", "experiments.one drop.sample_mm=[8,8]", "fidelity.particles_per_droplet=200",
                "experiments.one drop.droplets[0].volume_ul=2", "experiments.one drop.droplets[0].height_mm=0"};
    }
    static QByteArray contents(const QString& path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

private Q_SLOTS:
    void simulateThenMeasureGiveTheSameNumbers()
    {
        const QString recording = folder_.filePath("drop.hygrorec");
        const Answer run = run_cli(short_run(recording) << "--json", 300);
        QCOMPARE(run.code, 0);
        QVERIFY(QFile::exists(recording));
        const QJsonObject json = run.json();
        QCOMPARE(json["format"].toString(), QString("hygroloom-metrics"));
        QVERIFY(qAbs(json["ledger"].toObject()["water_imbalance_kg"].toDouble()) < 1e-15);
        QVERIFY(qAbs(json["ledger"].toObject()["water_in_kg"].toDouble() - 2e-6) < 0.02e-6);
        const Answer measured = run_cli({"measure", recording, "--json"});
        QCOMPARE(measured.code, 0);
        QCOMPARE(measured.json()["metrics"], json["metrics"]);
        QVERIFY(run_cli({"measure", recording}).out.contains("wetted radius, top"));
    }
    void aPartThatComesOnIsReportedByRunAndRecording()
    {
        const QString recording = folder_.filePath("watched.hygrorec");
        // Nearly saturated air, in which a small stain has minutes to spread farther than the plan expects.
        const QStringList run{"simulate",
                              example("laboratory.hygro"),
                              "--experiment",
                              "horizontal wicking",
                              "--fidelity",
                              "draft",
                              "--backend",
                              "cpu",
                              "--physics",
                              "heat=off",
                              "-o",
                              recording,
                              "--set",
                              "fabrics[0].warp.material=polyester",
                              "fabrics[0].weft.material=polyester",
                              "fabrics[0].contact_angle_deg=20",
                              "experiments[3].closure=paper",
                              "experiments[3].volume_ul=1",
                              "experiments[3].sample_mm=[16,16]",
                              "experiments[3].duration_s=200",
                              "experiments[3].climate.relative_humidity=0.9945",
                              "experiments[3].climate.air_speed_m_s=0"};
        const Answer answer = run_cli(run);
        QVERIFY2(answer.code == 0, answer.err);
        QVERIFY2(answer.out.contains("Vapour was left out until "), answer.out);
        const QJsonObject read = run_cli({"measure", recording, "--json"}).json();
        const QJsonArray parts = read["provenance"].toObject()["switched_on"].toArray();
        QCOMPARE(parts.size(), 1);
        QCOMPARE(parts[0].toObject()["name"].toString(), QString("vapour"));
        QCOMPARE(parts[0].toObject()["limit"].toDouble(), 0.01);
        QVERIFY(parts[0].toObject()["share"].toDouble() > 0.01 && parts[0].toObject()["time_s"].toDouble() > 0);
        const QString note = read["metrics"].toObject()["notes"].toArray()[0].toString();
        QVERIFY2(answer.out.contains(note.toUtf8()), qPrintable(note));
    }
    void bundlesOfYarnsAreRecorded()
    {
        const QString recording = folder_.filePath("bundles.hygrorec");
        const Answer run =
            run_cli({"simulate", example("laboratory.hygro"), "--experiment", "drying", "--fidelity", "draft", "--backend", "cpu", "-o",
                     recording, "--json", "--set", "fidelity.crossings_per_cell=3", "fidelity.crossings_per_even_cell=1",
                     "experiments[4].sample_mm=[8,8]", "experiments[4].duration_s=60"});
        QVERIFY2(run.code == 0, run.err);
        const QJsonObject read = run_cli({"measure", recording, "--json"}).json(), plan = read["provenance"].toObject()["plan"].toObject();
        QCOMPARE(read["metrics"], run.json()["metrics"]);
        QCOMPARE(plan["knobs"].toObject()["crossings_per_cell"].toInt(), 3);
        QCOMPARE(plan["resolution"].toObject()["crossings_per_cell"].toInt(), 3);
        // 8 mm at 35 per cm: 28 ends and picks.
        for (const QByteArray& text : {run.err, run_cli({"measure", recording}).out})
            QVERIFY2(text.contains("Yarns side by side went in bundles: 28 ends and 28 picks as 10 and 10."), text);
    }
    void aKnobWithoutEffectIsReported()
    {
        const QString recording = folder_.filePath("idle.hygrorec");
        const QStringList call{"simulate",
                               example("laboratory.hygro"),
                               "--experiment",
                               "drying",
                               "--fidelity",
                               "draft",
                               "--backend",
                               "cpu",
                               "--set",
                               "fidelity.density_tolerance=0.05",
                               "experiments[4].sample_mm=[8,8]",
                               "experiments[4].duration_s=60"};
        const QByteArray sentence = "density_tolerance was set and had no effect: no drop falls.";
        const Answer people = run_cli(call), script = run_cli(call + QStringList{"--json"}),
                     quiet = run_cli(call + QStringList{"--json", "--quiet"});
        QVERIFY2(people.out.contains(sentence), people.out);
        QVERIFY2(script.err.contains(sentence) && !script.json().isEmpty(), script.err);
        QVERIFY2(quiet.code == 0 && quiet.err.isEmpty(), quiet.err);
    }
    void moreThreadsThanCoresAreNoNewsAndNotClaimed()
    {
        const int cores = QThread::idealThreadCount();
        const Answer run =
            run_cli({"simulate", example("one-drop-on-cotton.hygro"), "--set", "experiments[0].duration_s=0.01", "--fidelity", "live",
                     "--backend", "cpu", "--json", "--quiet", "--threads", QString::number(cores + 6)});
        QVERIFY2(run.code == 0 && run.err.isEmpty(), run.err);
        const QByteArray device = run.json()["provenance"].toObject()["device"].toString().toUtf8();
        QVERIFY2(device.endsWith(QString(", %1 thread%2").arg(cores).arg(cores == 1 ? "" : "s").toUtf8()), device);
    }
    void aProfileShowsWhereTheTimeWent()
    {
        const Answer run = run_cli(short_run(folder_.filePath("timed.hygrorec")) << "--profile", 300);
        QCOMPARE(run.code, 0);
        for (const char* line : {"stage ", "sort ", "outside the stages"}) QVERIFY2(run.out.contains(line), run.out);
        const Answer json = run_cli(short_run(folder_.filePath("timed.hygrorec")) << "--profile"
                                                                                  << "--json",
                                    300);
        QVERIFY(json.err.contains("outside the stages") && json.json().contains("metrics"));
    }
    void severalFabricsRunAsEachAlone()
    {
        const QString folder = folder_.filePath("several"), project = example("three-candidates.hygro");
        const QStringList scene = QStringList{"--experiment", "one drop",  "--backend",           "cpu",    "--fidelity",
                                              "draft",        "--physics", "heat=off,vapour=off", "--json", "--set"} +
                                  small_drop();
        const QStringList names{"Hemp plain", "Cotton plain"};
        const Answer both = run_cli(
            QStringList{"simulate", project} + scene + QStringList{"--fabrics", names.join(","), "--at-once", "2", "-o", folder}, 300);
        QVERIFY2(both.code == 0, both.err);
        const QJsonArray list = QJsonDocument::fromJson(both.out).array();
        QCOMPARE(list.size(), 2);
        for (qsizetype i = 0; i < 2; ++i) {
            const Answer alone = run_cli(QStringList{"simulate", project} + scene + QStringList{"--fabric", names[i]}, 300);
            QCOMPARE(list[i].toObject()["metrics"], alone.json()["metrics"]);
            QCOMPARE(list[i].toObject()["ledger"], alone.json()["ledger"]);
            const QString recording = folder + "/" + QString(names[i]).replace(' ', '-') + ".hygrorec";
            QCOMPARE(run_cli({"measure", recording, "--json"}).json()["metrics"], alone.json()["metrics"]);
        }
        QVERIFY(run_cli({"simulate", project, "--fabric", names[0], "--fabrics", names[1]}).err.contains("either --fabric or --fabrics"));
        QVERIFY(run_cli({"simulate", project, "--fabrics", names[1], "--profile"}).err.contains("works with one fabric"));
        QCOMPARE(run_cli({"simulate", project, "--fabric", names[0], "--at-once", "2"}).code, 2);
    }
    void candidatesAreRankedOnOneExperiment()
    {
        const QString folder = folder_.filePath("compared");
        const QStringList compare{
            "compare", example("three-candidates.hygro"), "--backend", "cpu", "--fidelity", "draft", "--physics", "heat=off,vapour=off"};
        const QStringList scene = QStringList{"--experiment", "one drop", "--set"} + small_drop();
        const Answer answer = run_cli(compare + scene + QStringList{"-o", folder, "--json"}, 300);
        QVERIFY2(answer.code == 0, answer.err);
        const QJsonArray candidates = answer.json()["candidates"].toArray();
        QVERIFY(candidates.size() == 3 && answer.json()["complete"].toBool());
        const auto radius_of = [&](qsizetype i) {
            return candidates[i].toObject()["run"].toObject()["metrics"].toObject()["equal_area_radius_mm"].toDouble();
        };
        QVERIFY(radius_of(0) >= radius_of(1) && radius_of(1) >= radius_of(2) && radius_of(0) > radius_of(2) && radius_of(2) > 0);
        QCOMPARE(contents(folder + "/comparison.csv").count('\n'), 6 + candidates.size());
        QCOMPARE(QDir(folder).entryList({"*.png"}).size(), 2 * candidates.size());
        const auto without_walls = [](const QByteArray& json) {
            return QString::fromUtf8(json).remove(QRegularExpression("\"wall_s\": [^,\n]*"));
        };
        const Answer together = run_cli(compare + scene + QStringList{"--at-once", "3", "--json"}, 300);
        QCOMPARE(without_walls(together.out), without_walls(answer.out));
        QVERIFY(run_cli(compare + scene + QStringList{"--by", "ommc"}).err.contains("no number \"ommc\""));
        const Answer least =
            run_cli(compare + scene + QStringList{"--by", "absorbency_time_s", "--fabrics", "Hemp plain, Cotton plain"}, 300);
        QVERIFY2(least.code == 0 && least.out.contains("ranked by absorbency time (smallest first)"), least.err);
        QVERIFY2(least.out.contains("stain radius by area, bottom  absorbency time  wetted radius, top  wetted radius, bottom  run time\n"),
                 least.out);
        QVERIFY(!least.out.contains("_mm") && !least.out.contains("_s"));
        QVERIFY(least.out.contains("Hemp plain") && !least.out.contains("Cotton twill"));
        const Answer hurried = run_cli(QStringList{"compare", example("three-candidates.hygro"), "--backend", "cpu", "--physics",
                                                   "heat=off,vapour=off", "--fidelity", "auto", "--time", "0.001s"} +
                                           scene,
                                       300);
        QVERIFY2(hurried.out.contains("fidelity live: No fidelity is expected to take at most 0.001 s"), hurried.out);
        QVERIFY2(hurried.out.contains("of 3 runs"), hurried.out);
        const QString first = candidates[0].toObject()["fabric"].toString();
        QVERIFY(run_cli(compare + scene + QStringList{"--fabrics", first}).err.contains("two or more fabrics"));
        QVERIFY(run_cli(compare + scene + QStringList{"--fabrics", first + "," + first}).err.contains("named twice"));
        QVERIFY(run_cli(compare + scene + QStringList{"--fabrics", first + ",no such"}).err.contains("no fabric \"no such\""));
        QVERIFY(run_cli(compare + scene + QStringList{"--fabrics", first + ",,"}).err.contains("One of the names is empty"));
    }
    void mapsAreWrittenAsPictureAndTable()
    {
        const QString recording = folder_.filePath("map.hygrorec");
        QCOMPARE(run_cli(short_run(recording), 300).code, 0);
        for (const char* side : {"top", "bottom", "total"})
            for (const char* ending : {".csv", ".png"}) {
                const QString file = folder_.filePath(QString(side) + ending);
                QCOMPARE(run_cli({"measure", recording, "--map", side, "--cells", "2", "-o", file}).code, 0);
                QVERIFY(QFile(file).size() > 100);
            }
        const QStringList map{"measure", recording, "--map", "top", "-o", folder_.filePath("late.csv"), "--time"};
        const Answer late = run_cli(map + QStringList{"99", "--quiet"});
        QCOMPARE(late.code, 0);
        QVERIFY2(late.err.contains("warning: The recording ends at "), late.err);
        QVERIFY(!run_cli(map + QStringList{"0"}).err.contains("warning"));
        QCOMPARE(
            run_cli({"measure", recording, "--report", folder_.filePath("page.html"), "--vtk", folder_.filePath("vtk"), "--every", "1000"})
                .code,
            0);
        QVERIFY(QFile::exists(folder_.filePath("page.html")) && QFile::exists(folder_.filePath("vtk/yarns.pvd")));
        QVERIFY(QFile::exists(folder_.filePath("vtk/yarns_000001.vtp")) && !QFile::exists(folder_.filePath("vtk/yarns_000002.vtp")));
        for (const QStringList& useless : {QStringList{"--every", "2"}, QStringList{"--time", "0"}, QStringList{"--report", ""}})
            QCOMPARE(run_cli(QStringList{"measure", recording} + useless).code, 2);
        QVERIFY(run_cli({"measure", recording, "--report", folder_.filePath("page.doc")}).err.contains(".html"));
        QCOMPARE(run_cli({"measure", recording, "--map", "left", "-o", folder_.filePath("x.png")}).code, 2);
        QCOMPARE(run_cli({"measure", recording, "--map", "top", "-o", folder_.filePath("x.tif")}).code, 2);
    }
    void mapsShowWarmthAndHumidityWhereTheRunModelsThem()
    {
        for (const char* state : {"on", "off"}) {
            const QString recording = folder_.filePath(QString("air-%1.hygrorec").arg(state)), file = folder_.filePath("air.csv");
            const QString physics = QString("heat=%1,vapour=%1").arg(state);
            QCOMPARE(run_cli(short_run(recording) + QStringList{"--physics", physics}, 300).code, 0);
            for (const char* quantity : {"temperature", "humidity"}) {
                const Answer answer = run_cli({"measure", recording, "--map", "top", "--quantity", quantity, "-o", file});
                QCOMPARE(answer.code, QString(state) == "on" ? 0 : 3);
                QCOMPARE(answer.err.contains("This run does not model "), QString(state) == "off");
            }
        }
        const QString recording = folder_.filePath("air-on.hygrorec");
        QCOMPARE(run_cli({"measure", recording, "--quantity", "humidity"}).code, 2);
        QCOMPARE(run_cli({"measure", recording, "--map", "top", "--quantity", "heat", "-o", folder_.filePath("x.png")}).code, 2);
    }
    void waterIsExportedOnThePieceThatWasSimulated()
    {
        const QString recording = folder_.filePath("wet.hygrorec"), file = folder_.filePath("wet.ply"),
                      project = example("one-drop-on-cotton.hygro");
        QCOMPARE(run_cli(short_run(recording), 300).code, 0);
        const Answer answer = run_cli({"export", project, "--water", recording, "--time", "0.02", "--json", "-o", file});
        QCOMPARE(answer.code, 0);
        QVERIFY2(answer.err.contains("Water at 0.0"), answer.err);
        QFile ply(file);
        QVERIFY(ply.open(QIODevice::ReadOnly) && ply.read(1000).contains("property float saturation"));
        QCOMPARE(run_cli({"export", project, "--water", recording, "--size-mm", "2x2", "-o", file}).code, 2);
        QCOMPARE(run_cli({"export", project, "--water", recording, "--set", "fabrics[0].ends_per_cm=11", "-o", file}).code, 3);
        QCOMPARE(run_cli({"export", project, "--water", project, "-o", file}).code, 3);
    }
    void interruptedRunsLeaveAReadableRecording_data()
    {
        QTest::addColumn<int>("signal");
        QTest::addColumn<QStringList>("how");
        QTest::newRow("Ctrl-C") << SIGINT << QStringList{};
        QTest::newRow("a polite kill") << SIGTERM << QStringList{};
        QTest::newRow("a closed terminal") << SIGHUP << QStringList{};
        QTest::newRow("a polite kill of a quiet run") << SIGTERM << QStringList{"--quiet"};
    }
    void interruptedRunsLeaveAReadableRecording()
    {
        QFETCH(int, signal);
        QFETCH(QStringList, how);
        const QString recording = folder_.filePath("cut.hygrorec");
        QProcess process;
        QFile::remove(recording);
        process.start(HYGROLOOM_CLI, QStringList{"simulate", example("one-drop-on-cotton.hygro"), "--fidelity", "draft", "--backend", "cpu",
                                                 "--set", "experiments[0].duration_s=3600", "-o", recording} +
                                         how);
        QVERIFY(process.waitForStarted());
        QTRY_VERIFY_WITH_TIMEOUT(QFile(recording).size() > 0, 30000);
        QTest::qWait(1000);
        ::kill(static_cast<pid_t>(process.processId()), signal);
        QVERIFY(process.waitForFinished(10000));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), 130);
        QVERIFY(process.readAllStandardError().contains("The recording so far: " + recording.toUtf8()));
        const Answer measured = run_cli({"measure", recording, "--json"});
        QCOMPARE(measured.code, 0);
        QVERIFY(measured.err.contains("was stopped"));
        QVERIFY(!measured.json()["series"].toObject()["time_s"].toArray().isEmpty());
    }
    void interruptedRunsSideBySideLeaveReadableRecordings()
    {
        const QString folder = folder_.filePath("cut-several"), first = folder + "/Hemp-plain.hygrorec";
        QProcess process;
        process.start(HYGROLOOM_CLI, {"simulate", example("three-candidates.hygro"), "--experiment", "one drop", "--fabrics",
                                      "Hemp plain,Cotton plain", "--fidelity", "standard", "--backend", "cpu", "--quiet", "--set",
                                      "experiments.one drop.duration_s=3600", "-o", folder});
        QVERIFY(process.waitForStarted());
        QTRY_VERIFY_WITH_TIMEOUT(QFile(first).size() > 0, 30000);
        QTest::qWait(1000);
        ::kill(static_cast<pid_t>(process.processId()), SIGTERM);
        QVERIFY(process.waitForFinished(10000));
        QCOMPARE(process.exitCode(), 130);
        const QByteArray err = process.readAllStandardError();
        QVERIFY2(err.contains("Cancelled after 0 of 2 fabrics. The recordings so far are in " + folder.toUtf8() + "."), err);
        QVERIFY(run_cli({"measure", first}).err.contains("was stopped"));
    }
    void anInterruptedComparisonKeepsWhatWasRun()
    {
        const QString folder = folder_.filePath("cut-comparison");
        const auto comparison = [&] { return QJsonDocument::fromJson(contents(folder + "/comparison.json")).object(); };
        QProcess process;
        process.start(HYGROLOOM_CLI, {"compare", example("three-candidates.hygro"), "--experiment", "one drop", "--backend", "cpu",
                                      "--fidelity", "draft", "--set", "experiments.one drop.duration_s=3", "-o", folder});
        QVERIFY(process.waitForStarted());
        QTRY_VERIFY_WITH_TIMEOUT(!comparison()["candidates"].toArray().isEmpty(), 120000);
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(10000));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), 130);
        const qsizetype ended = comparison()["candidates"].toArray().size();
        QVERIFY(ended < 3 && !comparison()["complete"].toBool());
        const QByteArray err = process.readAllStandardError();
        QVERIFY2(err.contains(QString("Cancelled after %1 of 3 runs.").arg(ended).toUtf8()), err);
        QVERIFY(process.readAllStandardOutput().contains(comparison()["candidates"].toArray()[0].toObject()["fabric"].toString().toUtf8()));
        QCOMPARE(QDir(folder).entryList({"*.png"}).size(), 2 * ended);
    }
    void aComparisonInterruptedAtOnceHasNothingToRank()
    {
        const QString folder = folder_.filePath("no-comparison");
        QProcess process;
        process.start(HYGROLOOM_CLI, {"compare", example("three-candidates.hygro"), "--experiment", "one drop", "--backend", "cpu",
                                      "--json", "--set", "experiments.one drop.duration_s=3600", "-o", folder});
        QVERIFY(process.waitForStarted());
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(folder + "/comparison.json"), 30000);
        QTest::qWait(500);
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(10000));
        QCOMPARE(process.exitCode(), 130);
        const QJsonObject json = QJsonDocument::fromJson(process.readAllStandardOutput()).object();
        QVERIFY(json.contains("complete") && !json["complete"].toBool() && json["candidates"].toArray().isEmpty());
        const QByteArray err = process.readAllStandardError();
        QVERIFY2(err.contains("Cancelled after 0 of 3 runs.") && !err.contains("are in "), err);
    }
    void interruptedExportLeavesNoFile()
    {
        QTemporaryDir folder;
        QProcess process;
        process.start(HYGROLOOM_CLI,
                      {"export", example("textile-F.hygro"), "--detail", "fibre", "--size-mm", "40x40", "-o", folder.filePath("f.obj")});
        QVERIFY(process.waitForStarted());
        QTRY_VERIFY_WITH_TIMEOUT(!QDir(folder.path()).isEmpty(QDir::Files | QDir::Hidden), 20000);
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(20000));
        QCOMPARE(process.exitCode(), 130);
        QVERIFY(process.readAllStandardError().contains("Cancelled"));
        QVERIFY(QDir(folder.path()).isEmpty(QDir::Files | QDir::Hidden));
    }
    void aMissingGpuIsFour()
    {
        const QByteArray devices = run_cli({"devices", "--json"}).out;
        if (devices.contains("\"cuda\"") && devices.count("\"usable\": true") > 1) QSKIP("There is a GPU.");
        const Answer once = run_cli({"simulate", example("textile-F.hygro"), "--backend", "cuda"});
        QCOMPARE(once.code, 4);
        QVERIFY(once.err.contains("--backend cpu"));
    }
};

QTEST_GUILESS_MAIN(TestCommandLineRuns)
#include "tst_command_line_runs.moc"
