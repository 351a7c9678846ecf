// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// calibrate, as a script would run it: a strip that the program made itself, whose angle comes back.
#include "tests/app/command_line.h"

#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>

class TestCommandLineCalibrate : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;

    QString file(const char* name) const { return folder_.filePath(name); }
    void write(const char* name, const QByteArray& text) const
    {
        QFile out(file(name));
        QVERIFY(out.open(QIODevice::WriteOnly));
        out.write(text);
    }
    /// A cotton cloth on a small strip.
    QStringList scene(const char* verb) const
    {
        return {verb,           example("laboratory.hygro"),
                "--fabric",     "Textile F",
                "--experiment", "vertical wicking",
                "--fidelity",   "draft",
                "--backend",    "cpu",
                "--set",        "experiments[vertical wicking].duration_s=4",
                "--set",        "experiments[vertical wicking].strip_mm=[1,40]"};
    }

private Q_SLOTS:
    void theAngleOfAStripComesBack()
    {
        const Answer made = run_cli(scene("simulate") + QStringList{"--set", "fabrics[0].contact_angle_deg=44", "--json", "-q"}, 300);
        QCOMPARE(made.code, 0);
        const QJsonObject series = made.json()["series"].toObject();
        const QJsonArray time = series["time_s"].toArray(), height = series["wick_height_mm"].toArray();
        QByteArray csv = "time_s,wick_height_mm,spread\n";
        for (int i = time.size() / 8; i < time.size(); i += time.size() / 8)
            csv += QByteArray::number(time[i].toDouble()) + "," + QByteArray::number(height[i].toDouble()) + ",0.2\n";
        write("strip.csv", csv);
        const Answer answer = run_cli(scene("calibrate") + QStringList{"--measured", file("strip.csv"), "--free", "contact_angle_deg",
                                                                       "--json", "-o", file("fitted.hygro"), "--report", file("fit.html")},
                                      300);
        QVERIFY2(answer.code == 0, answer.err.constData());
        const QJsonObject angle = answer.json()["parameters"].toObject()["contact_angle_deg"].toObject();
        QVERIFY2(angle["low"].toDouble() < 44 && 44 < angle["high"].toDouble(), answer.out.constData());
        QVERIFY(answer.json()["identifiable"].toBool());
        QFile report(file("fit.html")), fitted(file("fitted.hygro"));
        QVERIFY(report.open(QIODevice::ReadOnly) && report.readAll().contains("<circle"));
        QVERIFY(fitted.open(QIODevice::ReadOnly) && fitted.readAll().contains("\"calibrated\""));
        QCOMPARE(run_cli({"check", file("fitted.hygro")}).code, 0);
    }
    void whatCannotBeToldIsOne()
    {
        write("one.csv", "time_s,wick_height_mm,spread\n4,15,0.5\n");
        QStringList both = scene("calibrate") + QStringList{"--measured",
                                                            file("one.csv"),
                                                            "--json",
                                                            "-o",
                                                            file("none.hygro"),
                                                            "--set",
                                                            "fabrics[0].uncertainty.packing_factor=0.05",
                                                            "--free",
                                                            "contact_angle_deg,packing_factor"};
        const Answer answer = run_cli(both, 300);
        QCOMPARE(answer.code, 1);
        QVERIFY2(answer.err.contains("1 measured number cannot tell 2 inputs"), answer.err.constData());
        QVERIFY(!answer.json()["identifiable"].toBool(true) && answer.json()["error"].toString().contains("cannot tell"));
        QVERIFY(!QFile::exists(file("none.hygro")));
        both.last() = "contact_angle_deg,contact_angle_deg";
        QCOMPARE(run_cli(both).code, 2);
        both.last() = "receding_angle_deg";
        QVERIFY(run_cli(both).err.contains("is known"));
    }
    void ctrlCLeavesNothing()
    {
        write("strip.csv", "time_s,wick_height_mm\n1,5\n2,8\n3,11\n4,13\n");
        QProcess process;
        process.start(HYGROLOOM_CLI, scene("calibrate") + QStringList{"--measured", file("strip.csv"), "--free", "contact_angle_deg", "-o",
                                                                      file("cut.hygro")});
        QVERIFY(process.waitForStarted());
        QTest::qWait(400);
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(5000));
        QCOMPARE(process.exitCode(), 130);
        QVERIFY(!QFile::exists(file("cut.hygro")));
    }
};

QTEST_GUILESS_MAIN(TestCommandLineCalibrate)
#include "tst_command_line_calibrate.moc"
