// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// tradeoff from end to end.
#include "command_line.h"

#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>

namespace tst_command_line_tradeoff {

using namespace hygroloom;

class TestCommandLineTradeoff : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;

    QStringList small_scene(const char* duration, const char* size = "[8,8]", const char* volume = "2") const
    {
        return {"tradeoff",
                example("one-drop-on-cotton.hygro"),
                "--backend",
                "cpu",
                "--repeats=2",
                "--set",
                QString("experiments[0].duration_s=") + duration,
                QString("experiments[0].sample_mm=") + size,
                QString("experiments[0].droplets[0].volume_ul=") + volume,
                "experiments[0].droplets[0].height_mm=0",
                "fidelity.particles_per_droplet=100",
                "experiments[0].closure=paper", // which needs no flow through rooms between yarns
                "-o",
                folder_.filePath("tradeoff.json")};
    }
    static QByteArray contents(const QString& path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

private Q_SLOTS:
    void aTradeoffComparesFidelitiesWithTheReference()
    {
        const Answer answer = run_cli(small_scene("0.001", "[4,4]", "0.3") << "--convergence", 300);
        QVERIFY2(answer.code == 0, answer.err);
        QVERIFY2(answer.out.contains("from reference x 2 to reference x 4: error "), answer.out);
        const QJsonObject json = QJsonDocument::fromJson(contents(folder_.filePath("tradeoff.json"))).object();
        QCOMPARE(json["format"].toString(), QString("hygroloom-tradeoff"));
        QVERIFY(json["provenance"].toObject()["complete"].toBool());
        const QJsonArray runs = json["runs"].toArray();
        QCOMPARE(runs.size(), 4 + 2);
        for (const QJsonValue& value : runs) {
            const QJsonObject run = value.toObject();
            const bool timed = run["refines"].toString().isEmpty();
            QCOMPARE(run["walls_s"].toArray().size(), timed ? 2 : 0);
            if (timed) QVERIFY(run["peak_bytes"].toDouble() > 1e6);
            QVERIFY(run["errors"].toObject().contains("largest"));
        }
        QCOMPARE(runs[3].toObject()["errors"].toObject()["largest"].toDouble(), 0.0);
        QVERIFY(runs[0].toObject()["errors"].toObject()["largest"].toDouble() > 0);
        const Answer table = run_cli({"tradeoff", "--csv", folder_.filePath("tradeoff.json")});
        QCOMPARE(table.code, 3); // it was measured with other knobs
        QVERIFY2(table.err.contains("--set fidelity."), table.err);
    }
    void anInterruptedTradeoffKeepsWhatWasMeasured()
    {
        QProcess process;
        process.start(HYGROLOOM_CLI, small_scene("0.3"));
        QVERIFY(process.waitForStarted());
        QByteArray said;
        const auto has_said = [&](const char* words) { return (said += process.readAllStandardError()).contains(words); };
        QTRY_VERIFY_WITH_TIMEOUT(has_said("live (1 of 4): "), 60000);
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(10000));
        QCOMPARE(process.exitCode(), 130);
        const QJsonObject json = QJsonDocument::fromJson(contents(folder_.filePath("tradeoff.json"))).object();
        QVERIFY(!json["provenance"].toObject()["complete"].toBool());
        QVERIFY(!json["runs"].toArray()[0].toObject()["walls_s"].toArray().isEmpty());
    }
    void aMeasuredSceneBecomesRowsOfATable()
    {
        const QString file = folder_.filePath("drying.json");
        const Answer run = run_cli({"tradeoff", HYGROLOOM_SOURCE_DIR "/resources/tradeoff/scenes.hygro", "--fabric", "Textile E",
                                    "--experiment", "drying on Textile E", "--fidelities", "live,draft", "--repeats", "1", "--backend",
                                    "cpu", "--set", "experiments[drying on Textile E].duration_s=1", "-o", file},
                                   300);
        QVERIFY2(run.code == 0, run.err);
        const Answer table = run_cli({"tradeoff", "--csv", file});
        QVERIFY2(table.code == 0, table.err);
        QCOMPARE(table.out.count('\n'), 1 + 1 + 2);
        QVERIFY2(table.out.contains("\ndrying on Textile E,cpu,scene,") && table.out.contains("\ndrying on Textile E,cpu,draft,"),
                 table.out);
    }
};

} // namespace tst_command_line_tradeoff

QTEST_GUILESS_MAIN(tst_command_line_tradeoff::TestCommandLineTradeoff)
#include "tst_command_line_tradeoff.moc"
