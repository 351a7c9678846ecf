// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// compare --why, as a script would run it.
#include "tests/app/command_line.h"

#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

class TestCommandLineWhy : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;

    static QString structures() { return example("paper/figure-13-structures.hygro"); }

    /// A small drop that stands as a cap: without particles all tests of this file take some 4 s.
    static QStringList scene(const QString& project, const QString& experiment = "one drop", const QString& seconds = "0.2",
                             const QString& volume_ul = "5", const QString& side_mm = "16")
    {
        const QString of = "experiments." + experiment + ".";
        return {"compare",
                project,
                "--experiment",
                experiment,
                "--fidelity",
                "live",
                "--backend",
                "cpu",
                "--json",
                "--quiet",
                "--set",
                of + "duration_s=" + seconds,
                of + "sample_mm=[" + side_mm + "," + side_mm + "]",
                of + R"(droplets=[{"volume_ul": )" + volume_ul + "}]"};
    }

    /// The project of structures with a copy of "base", named "copy", with other values at some keys.
    QString with_copy(const QString& name, const QJsonObject& other)
    {
        QFile in(structures());
        if (!in.open(QIODevice::ReadOnly)) return {};
        QJsonObject project = QJsonDocument::fromJson(in.readAll()).object();
        QJsonArray fabrics = project["fabrics"].toArray();
        for (const auto& each : project["fabrics"].toArray()) {
            QJsonObject copy = each.toObject();
            if (copy["name"] != "base") continue;
            copy["name"] = "copy";
            for (auto key = other.begin(); key != other.end(); ++key) copy[key.key()] = key.value();
            fabrics.append(copy);
        }
        project["fabrics"] = fabrics;
        QFile out(folder_.filePath(name));
        if (!out.open(QIODevice::WriteOnly)) return {};
        out.write(QJsonDocument(project).toJson());
        return out.fileName();
    }

    static double sum_of(const QJsonObject& why)
    {
        double sum = why["together"].toObject()["difference"].toDouble();
        for (const auto& part : why["contributions"].toArray()) sum += part.toObject()["difference"].toDouble();
        return sum;
    }

private Q_SLOTS:
    void contributionsAddUpToTheDifference_data()
    {
        QTest::addColumn<QStringList>("question");
        QTest::addColumn<QString>("method");
        QTest::addColumn<int>("fabrics");
        QTest::newRow("two parts, in all orders") << scene(structures(), "one drop", "0.2", "20", "30") +
                                                         QStringList{"--why", "25 threads per cm", "--baseline", "35 threads per cm"}
                                                  << "shapley" << 4;
        QTest::newRow("eight parts, one at a time")
            << scene(example("paper/figure-10-three-fibres.hygro"), "three drops", "0.5", "3", "30") +
                   QStringList{"--set",      "fabrics.Textile G.warp.packing_factor=0.35",
                               "--set",      "fabrics.Textile G.weft.packing_factor=0.35",
                               "--why",      "Textile F",
                               "--baseline", "Textile G"} // or no difference is shown
            << "one_at_a_time" << 18;
    }
    void contributionsAddUpToTheDifference()
    {
        QFETCH(QStringList, question);
        QFETCH(QString, method);
        QFETCH(int, fabrics);
        const Answer answer = run_cli(question + QStringList{"--report", folder_.filePath("why.html")}, 300);
        QVERIFY2(answer.code == 0, answer.err);
        const QJsonObject why = answer.json()["why"].toObject();
        QCOMPARE(why["metric"].toString(), QString("equal_area_radius_mm"));
        QCOMPARE(why["method"].toString(), method);
        QCOMPARE(why["fabrics"].toInt(), fabrics);
        QCOMPARE(answer.json()["candidates"].toArray().size(), 2); // the two it is about
        const double whole = why["whole"].toObject()["difference"].toDouble();
        QVERIFY2(std::abs(whole) > 0 && std::abs(sum_of(why) - whole) <= 1e-12 * std::abs(whole), answer.out.right(3000));
        for (const auto& verdict : answer.json()["verdicts"].toArray())
            if (verdict.toObject()["metric"] == why["metric"]) QCOMPARE(verdict.toObject()["difference"].toDouble(), whole);
        QFile page(folder_.filePath("why.html"));
        QVERIFY(page.open(QIODevice::ReadOnly));
        QVERIFY(page.readAll().contains("<h2>Why</h2>"));
    }

    void aContactAngleAloneMakesAllOfTheDifference()
    {
        const Answer answer =
            run_cli(scene(with_copy("angle.hygro", {{"contact_angle_deg", 80}})) + QStringList{"--why", "base", "--baseline", "copy"}, 300);
        QVERIFY2(answer.code == 0, answer.err);
        const QJsonObject why = answer.json()["why"].toObject();
        const QJsonArray parts = why["contributions"].toArray();
        QVERIFY2(parts.size() == 1, answer.out.right(3000));
        QCOMPARE(parts[0].toObject()["part"].toString(), QString("contact angle"));
        QCOMPARE(parts[0].toObject()["difference"], why["whole"].toObject()["difference"]);
        QCOMPARE(why["whole"].toObject()["verdict"].toString(), QString("better"));
        QCOMPARE(why["fabrics"].toInt(), 2); // no mixture is needed
    }

    void anExactCopyHasNoDifference()
    {
        const QString project = with_copy("copy.hygro", {});
        for (const char* replicates : {"1", "2"}) {
            const Answer answer = run_cli(
                scene(project, "one drop", "0.1") + QStringList{"--why", "base", "--baseline", "copy", "--replicates", replicates}, 300);
            QVERIFY2(answer.code == 0, answer.err);
            const QJsonObject why = answer.json()["why"].toObject();
            QCOMPARE(why["whole"].toObject()["verdict"].toString(), QString("no difference shown"));
            QVERIFY(why["contributions"].toArray().isEmpty() && why["together"].isNull());
        }
    }

    void aProjectWithoutExperimentsIsToldHowToGetOne()
    {
        QFile in(structures());
        QVERIFY(in.open(QIODevice::ReadOnly));
        QJsonObject project = QJsonDocument::fromJson(in.readAll()).object();
        project["experiments"] = QJsonArray();
        QFile out(folder_.filePath("bare.hygro"));
        QVERIFY(out.open(QIODevice::WriteOnly));
        out.write(QJsonDocument(project).toJson());
        out.close();
        const Answer answer = run_cli({"compare", folder_.filePath("bare.hygro")});
        QCOMPARE(answer.code, 2);
        const QString said = QString::fromUtf8(answer.err);
        QVERIFY2(said.contains("The project has no experiment. hygroloom-cli presets --experiment droplet -o PROJECT adds one; "),
                 answer.err);
        QCOMPARE(run_cli({"presets", "--experiment", "droplet", "-o", folder_.filePath("bare.hygro")}).code, 0); // what it says works
        QCOMPARE(run_cli({"plan", folder_.filePath("bare.hygro"), "--fabric", "base"}).code, 0);
    }

    void aWrongQuestionIsRefused()
    {
        const QString project = structures();
        const auto refused = [&](const QStringList& more) {
            const Answer answer = run_cli(scene(project) + more);
            return answer.code == 2 ? QString(answer.err) : QString();
        };
        QVERIFY(refused({"--why", "no such"}).contains("no fabric \"no such\""));
        QVERIFY(refused({"--why", "base", "--baseline", "base"}).contains("needs another fabric"));
        QVERIFY(refused({"--why", "base", "--baseline", "no such"}).contains("no fabric \"no such\""));
        QVERIFY(refused({"--by", "absorbency"}).contains("did you mean \"absorbency_time_s\"?"));
        QVERIFY(refused({"--why", "base", "--fabrics", "no flyaways,twice the flyaways"}).contains("not among the compared fabrics"));
    }
};

QTEST_GUILESS_MAIN(TestCommandLineWhy)
#include "tst_command_line_why.moc"
