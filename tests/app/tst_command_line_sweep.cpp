// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Studies from the command line: what they leave, what they refuse, and what an interrupt leaves.
#include "tests/app/command_line.h"

#include <QElapsedTimer>
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>

namespace {

const QString drop = example("textile-F.hygro");

/// A study of drops that are over soon.
QString study_in(const QTemporaryDir& folder, const QByteArray& factors, const QByteArray& design, const QByteArray& more = "")
{
    const QString name = folder.filePath("study.json");
    QFile file(name);
    if (!file.open(QIODevice::WriteOnly)) return {};
    file.write(R"({ "format": "hygroloom-study", "version": 1, "fidelity": "live", "factors": [)" + factors + R"(], "design": )" + design +
               more + "}");
    return name;
}

const QByteArray ends = R"({ "path": "fabrics[0].ends_per_cm", "values": [26, 30, 36] })";
const QByteArray grid = R"({ "type": "grid" })";
const QString soon = "experiments[0].duration_s=0.1";

QByteArray contents(const QString& name)
{
    QFile file(name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Rows without wall_s, which is the last number.
QList<QByteArray> rows_of(const QString& folder)
{
    QList<QByteArray> rows;
    for (const QByteArray& line : contents(folder + "/results.csv").split('\n')) rows << line.split(',').mid(0, 7).join(',');
    return rows;
}

} // namespace

class TestCommandLineSweep : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aStudyLeavesItsTable()
    {
        const QTemporaryDir folder;
        const QString out = folder.filePath("out");
        const Answer answer =
            run_cli({"sweep", drop, "--study", study_in(folder, ends, grid), "-o", out, "--set", soon, "--json", "--quiet"});
        QVERIFY2(answer.code == 0, answer.err);
        QCOMPARE(answer.json()["rows"].toInt(), 3);
        QCOMPARE(answer.json()["done"].toInt(), 3);
        const QList<QByteArray> lines = contents(out + "/results.csv").split('\n');
        QCOMPARE(
            lines[0],
            QByteArray("point,replicate,fabrics[0].ends_per_cm,status,equal_area_radius_mm,equal_area_radius_bottom_mm,absorbency_time_s,"
                       "maximum_wetted_radius_top_mm,maximum_wetted_radius_bottom_mm,wall_s,device,commit,reason"));
        QVERIFY(lines[1].startsWith("0,0,26,done,"));
        QVERIFY(lines[3].startsWith("2,0,36,done,"));
        QVERIFY(contents(out + "/study.sqlite").startsWith("SQLite format 3"));

        const Answer again = run_cli({"sweep", drop, "--study", folder.filePath("study.json"), "-o", out, "--set", soon});
        QCOMPARE(again.code, 2);
        QVERIFY(again.err.contains("The folder has 3 of the study's 3 rows. Go on with --resume"));
        QCOMPARE(run_cli({"sweep", "-o", out, "--resume", "--quiet"}).code, 0);
    }

    void whatFailsIsListed()
    {
        const QTemporaryDir folder;
        const QString out = folder.filePath("out");
        const QString study = study_in(folder, R"({ "path": "fabrics[0].ends_per_cm", "values": [26, 4000] })", grid);
        const Answer answer = run_cli({"sweep", drop, "--study", study, "-o", out, "--set", soon, "--json", "--quiet"});
        QCOMPARE(answer.code, 1);
        QCOMPARE(answer.json()["failed"].toInt(), 1);
        QCOMPARE(answer.json()["failures"].toArray()[0].toObject()["point"].toInt(), 1);
        QVERIFY(contents(out + "/results.csv").contains("1,0,4000,failed,,,,"));
        QVERIFY(contents(out + "/results.csv")
                    .contains("fabrics[0].ends_per_cm: The number of ends per cm must be from 0.5 to 500; given is 4000."));
    }

    void anInterruptKeepsWhatHasEnded()
    {
        const QTemporaryDir folder;
        const QByteArray design = R"({ "type": "latin_hypercube", "points": 8 })";
        const QString study = study_in(folder, R"({ "path": "fabrics[0].ends_per_cm", "low": 26, "high": 36 })", design);
        const QString out = folder.filePath("out"), whole = folder.filePath("whole");
        QProcess process;
        process.start(HYGROLOOM_CLI, {"sweep", drop, "--study", study, "-o", out, "--quiet", "--jobs", "2"});
        const QString part = out + "/parts/000001-of-000001.csv";
        QTRY_VERIFY_WITH_TIMEOUT(contents(part).count('\n') >= 3, 60000);
        QElapsedTimer timer;
        timer.start();
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(10000));
        QCOMPARE(process.exitCode(), 130);
        QVERIFY2(timer.elapsed() < 1000, qPrintable(QString::number(timer.elapsed()))); // 0.3 s on a quiet machine
        QVERIFY(process.readAllStandardError().contains("--resume goes on"));
        QCOMPARE(run_cli({"sweep", "-o", out, "--resume", "--quiet"}).code, 0);
        QCOMPARE(run_cli({"sweep", drop, "--study", study, "-o", whole, "--quiet"}).code, 0);
        QCOMPARE(rows_of(out).size(), 10); // header, 8, and after the last line end
        QCOMPARE(rows_of(out), rows_of(whole));
    }

    void whatIsWrongIsSaidBeforeAnythingRuns()
    {
        const QTemporaryDir folder;
        const QString out = folder.filePath("out");
        const QString study = study_in(folder, ends, grid, R"(, "metrics": ["ommc"])");
        Answer answer = run_cli({"sweep", drop, "--study", study, "-o", out});
        QCOMPARE(answer.code, 3);
        QVERIFY(answer.err.contains("study.json: metrics[0]: error: No experiment of the study has the metric \"ommc\""));
        answer = run_cli({"sweep", drop, "--study", study_in(folder, ends, R"({ "type": "sobel" })"), "-o", out, "--json"});
        QCOMPARE(answer.code, 3);
        QVERIFY(answer.json()["error"].toString().contains("did you mean \"sobol\"?"));
        QCOMPARE(run_cli({"sweep", drop, "-o", out}).code, 2);
        QCOMPARE(run_cli({"sweep", "-o", out, "--merge"}).code, 3);
        QCOMPARE(run_cli({"sweep", drop, "--study", study_in(folder, ends, grid), "-o", out, "--task", "4/3"}).code, 2);
        QVERIFY(!QFile::exists(out));
    }

    void withoutSlurmTheVerbSaysWhatToInstall()
    {
        const QTemporaryDir folder;
        QProcess process;
        auto environment = QProcessEnvironment::systemEnvironment();
        environment.insert("PATH", "/nowhere");
        process.setProcessEnvironment(environment);
        process.start(HYGROLOOM_CLI, {"sweep", drop, "--study", study_in(folder, ends, grid), "-o", folder.filePath("out"), "--slurm"});
        QVERIFY(process.waitForFinished());
        QCOMPARE(process.exitCode(), 1);
        QVERIFY(process.readAllStandardError().contains("install the package slurm-client"));
    }

    void sensitivitiesPredictionsAndSuggestionsFollow()
    {
        const QTemporaryDir folder;
        const QString out = folder.filePath("out");
        const QByteArray two =
            R"({ "path": "fabrics[0].ends_per_cm", "low": 26, "high": 36 }, { "path": "fabrics[0].contact_angle_deg", "low": 20, "high": 40 })";
        const QString study = study_in(folder, two, R"({ "type": "latin_hypercube", "points": 12 })");
        QCOMPARE(run_cli({"sweep", drop, "--study", study, "-o", out, "--set", soon, "--quiet"}).code, 0);
        Answer answer = run_cli({"sweep", "-o", out, "--analyse", "--json"});
        if (answer.err.contains("OpenTURNS, which is missing")) QSKIP("OpenTURNS is missing");
        QVERIFY2(answer.code == 0 && !answer.err.contains("runs have ended"), answer.err);
        const QString part = folder.filePath("part");
        QCOMPARE(run_cli({"sweep", drop, "--study", study, "-o", part, "--task", "1/2", "--set", soon, "--quiet"}).code, 0);
        run_cli({"sweep", "-o", part, "--merge"});
        const Answer early = run_cli({"sweep", "-o", part, "--analyse"});
        QVERIFY2(early.err.contains("6 of 12 runs have ended: shares will change"), early.err);
        const QJsonObject index = answer.json()["maximum_wetted_radius_top_mm"].toObject()["fabrics[0].ends_per_cm"].toObject();
        QVERIFY(index["first"].toDouble() > 0.3); // more ends hold more water
        QCOMPARE(index["method"].toString(), QString("kriging surrogate"));
        answer = run_cli({"sweep", "-o", out, "--predict", "fabrics[0].ends_per_cm=30", "--json"});
        const QJsonObject radius = answer.json()["predictions"].toObject()["maximum_wetted_radius_top_mm"].toObject();
        QVERIFY(radius["low"].toDouble() < radius["value"].toDouble() && radius["value"].toDouble() < radius["high"].toDouble());
        QCOMPARE(run_cli({"sweep", "-o", out, "--predict", "fabrics[0].ends_per_cm=50"}).code, 2);
        answer = run_cli({"sweep", "-o", out, "--suggest", "minimise maximum_wetted_radius_top_mm", "--count", "2", "--json"});
        QVERIFY2(answer.code == 0, answer.err);
        const QJsonArray found = answer.json()["suggestions"].toArray();
        QCOMPARE(found.size(), 2);
        QVERIFY(found[0].toObject()["value"].toDouble() < radius["value"].toDouble()); // smaller than in the middle of both ranges
    }

    void whatWouldBeLostOrIgnoredIsRefused()
    {
        const QTemporaryDir folder;
        const QString study = study_in(folder, ends, grid); // study.json in the very folder
        const QByteArray before = contents(study);
        const Answer here = run_cli({"sweep", drop, "--study", study, "-o", folder.path(), "--quiet"});
        QCOMPARE(here.code, 2);
        QVERIFY2(here.err.contains("study.json: The results would replace this file"), here.err);
        QCOMPARE(contents(study), before);
        const QString out = folder.filePath("out");
        QCOMPARE(run_cli({"sweep", drop, "--study", study, "-o", out, "--set", soon, "--quiet"}).code, 0);
        const Answer set = run_cli({"sweep", "-o", out, "--resume", "--set", soon, "--quiet"});
        QCOMPARE(set.code, 2);
        QVERIFY2(set.err.contains("--set: A folder's study stays as it is"), set.err);
        QCOMPARE(run_cli({"sweep", drop, "--study", study, "-o", "", "--quiet"}).code, 2);
        QCOMPARE(run_cli({"sweep", "-o", folder.filePath("none"), "--merge"}).code, 3);
    }
};

QTEST_GUILESS_MAIN(TestCommandLineSweep)
#include "tst_command_line_sweep.moc"
