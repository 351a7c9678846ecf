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

    /// A small drop at draft.
    static QStringList scene(const QString& project)
    {
        return {"compare",
                project,
                "--experiment",
                "one drop",
                "--fidelity",
                "draft",
                "--backend",
                "cpu",
                "--physics",
                "heat=off,vapour=off",
                "--json",
                "--quiet",
                "--set",
                "experiments.one drop.duration_s=0.3",
                "experiments.one drop.sample_mm=[8,8]",
                "experiments.one drop.droplets[0].volume_ul=2",
                "experiments.one drop.droplets[0].height_mm=0"};
    }

    /// The candidates' project with a copy of "Cotton plain", named "copy", with other values at some keys.
    QString with_copy(const QString& name, const QJsonObject& other)
    {
        QFile in(example("three-candidates.hygro"));
        if (!in.open(QIODevice::ReadOnly)) return {};
        QJsonObject project = QJsonDocument::fromJson(in.readAll()).object();
        QJsonArray fabrics = project["fabrics"].toArray();
        for (const auto& each : project["fabrics"].toArray()) {
            QJsonObject copy = each.toObject();
            if (copy["name"] != "Cotton plain") continue;
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
    void contributionsAddUpToTheDifference()
    {
        const QString project = example("three-candidates.hygro");
        const Answer answer = run_cli(scene(project) + QStringList{"--why", "Hemp plain", "--baseline", "Cotton plain", "--by",
                                                                   "absorbency_time_s", "--report", folder_.filePath("why.html")},
                                      300);
        QVERIFY2(answer.code == 0, answer.err);
        const QJsonObject why = answer.json()["why"].toObject();
        QCOMPARE(why["metric"].toString(), QString("absorbency_time_s"));
        QVERIFY2(why["contributions"].toArray().size() > 1, answer.out.right(3000));
        QCOMPARE(answer.json()["candidates"].toArray().size(), 2); // the two it is about
        const double whole = why["whole"].toObject()["difference"].toDouble();
        QVERIFY2(std::abs(whole) > 0 && std::abs(sum_of(why) - whole) <= 1e-12 * std::abs(whole), answer.out.right(3000));
        for (const auto& verdict : answer.json()["verdicts"].toArray())
            if (verdict.toObject()["metric"] == why["metric"]) QCOMPARE(verdict.toObject()["difference"].toDouble(), whole);
        QFile page(folder_.filePath("why.html"));
        QVERIFY(page.open(QIODevice::ReadOnly));
        const QByteArray html = page.readAll();
        QVERIFY(html.contains("<h2>Why</h2>") && html.contains("Hemp plain less Cotton plain"));
    }

    void aContactAngleAloneMakesAllOfTheDifference()
    {
        const Answer answer = run_cli(scene(with_copy("angle.hygro", {{"contact_angle_deg", 80}})) +
                                          QStringList{"--why", "Cotton plain", "--baseline", "copy", "--by", "absorbency_time_s"},
                                      300);
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
            const Answer answer =
                run_cli(scene(project) + QStringList{"--why", "Cotton plain", "--baseline", "copy", "--replicates", replicates}, 300);
            QVERIFY2(answer.code == 0, answer.err);
            const QJsonObject why = answer.json()["why"].toObject();
            QCOMPARE(why["whole"].toObject()["verdict"].toString(), QString("no difference"));
            QVERIFY(why["contributions"].toArray().isEmpty() && why["together"].isNull());
        }
    }

    void aWrongQuestionIsRefused()
    {
        const QString project = example("three-candidates.hygro");
        const auto refused = [&](const QStringList& more) {
            const Answer answer = run_cli(scene(project) + more);
            return answer.code == 2 ? QString(answer.err) : QString();
        };
        QVERIFY(refused({"--why", "no such"}).contains("no fabric \"no such\""));
        QVERIFY(refused({"--why", "Hemp plain", "--baseline", "Hemp plain"}).contains("needs another fabric"));
        QVERIFY(refused({"--why", "Hemp plain", "--baseline", "no such"}).contains("not among the compared fabrics"));
        QVERIFY(refused({"--why", "Hemp plain", "--fabrics", "Cotton plain,Cotton twill"}).contains("not among the compared fabrics"));
    }
};

QTEST_GUILESS_MAIN(TestCommandLineWhy)
#include "tst_command_line_why.moc"
