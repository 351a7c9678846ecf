// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What check and import say of cloths, whose repeats are drawn for it.
#include "command_line.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

class TestCommandLineCloth : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void checkReportsFloatsAndJam()
    {
        const QStringList call{"check", example("textile-F.hygro"), "--set", "fabrics[0].weave.pattern=satin 8/3"};
        const Answer text = run_cli(call);
        QVERIFY(text.out.contains("satin 8/3: smallest repeat 8 ends x 8 picks, warp up at 87.5 % of the crossings"));
        QVERIFY2(text.out.contains("7 (2 mm)"), text.out);                      // 7 picks at 35 per cm
        QVERIFY2(text.out.contains("% of Ashenhurst's limit 40/cm"), text.out); // 50 x 8/10
        const QJsonObject fabric = run_cli(call + QStringList{"--json"}).json()["fabrics"].toArray()[0].toObject();
        QCOMPARE(fabric["weave"].toObject()["floats"].toObject()["warp_face"].toObject()["longest"].toInt(), 7);
        QCOMPARE(fabric["weave"].toObject()["shafts"].toInt(), 8);
        QVERIFY(qAbs(fabric["jam"].toObject()["warp"].toObject()["ashenhurst_percent"].toDouble() - 87.5) < 1e-9);
        // sqrt 3 x 0.1414 mm of solid yarn x 35 per cm over a weave factor of sqrt(3/1.0625).
        QVERIFY2(qAbs(fabric["sett_share_of_limit"].toDouble() - 0.5102) < 1e-4, qPrintable(fabric["sett_share_of_limit"].toString()));
        QVERIFY2(text.out.contains("both setts together are 51 % of their limit"), text.out);
        const Answer uneven = run_cli({"check", example("textile-F.hygro"), "--set", "fabrics[0].picks_per_cm=25"});
        QVERIFY2(!uneven.out.contains("Ashenhurst") && uneven.out.contains("of Peirce's limit"), uneven.out);
    }
    void importReportsWhatItUnderstoodAndWritesAProject()
    {
        QTemporaryDir folder;
        const QString wif = HYGROLOOM_SOURCE_DIR "/tests/data/wif/basic_wpo__many_color_single_treadles.wpo.wif";
        const Answer shown = run_cli({"import", wif});
        QCOMPARE(shown.code, 0);
        QVERIFY(shown.out.contains("warning: [WARP] declares 1200 threads"));
        const QString project = folder.filePath("new.hygro");
        const Answer first = run_cli({"import", wif, "-o", project, "--json"});
        QCOMPARE(first.code, 0);
        QCOMPARE(first.json()["added"].toBool(true), false);
        QCOMPARE(first.json()["weave"].toObject()["ends"].toInt(), 4);
        QVERIFY(first.json()["report"].toArray().size() > 5);
        const Answer second = run_cli({"import", wif, "-o", project, "--json", "--no-suggestions"});
        QCOMPARE(second.json()["fabric"].toString(), QString("many color single treadles.wpo 2"));
        QCOMPARE(run_cli({"check", project, "--json"}).json()["fabrics"].toArray().size(), 2);
        QCOMPARE(run_cli({"import", HYGROLOOM_SOURCE_DIR "/tests/data/wif/bad_wif__missing_tieup.wif"}).code, 3);
        QCOMPARE(run_cli({"import", "/nowhere.wif"}).code, 3);
        QCOMPARE(run_cli({"import", wif, "-o", folder.filePath("x.json")}).code, 2);
    }
    void importTakesPlausibleNumbersUnlessForbidden()
    {
        QTemporaryDir folder;
        QFile wif(folder.filePath("d.wif"));
        QVERIFY(wif.open(QIODevice::WriteOnly));
        wif.write("[WIF]\nVersion=1.1\n[CONTENTS]\nWEAVING=1\nWARP=1\nWEFT=1\nTHREADING=1\nTIEUP=1\nTREADLING=1\n"
                  "[WEAVING]\nShafts=2\nTreadles=2\n[WARP]\nThreads=2\nUnits=Centimeters\nSpacing=0.04\n"
                  "[WEFT]\nThreads=2\nUnits=Centimeters\nSpacing=0.05\n[THREADING]\n1=1\n2=2\n[TIEUP]\n1=1\n2=2\n[TREADLING]\n1=1\n2=2\n");
        wif.close();
        const auto ends = [&](const QStringList& options) {
            const QString project = folder.filePath(QString("p%1.hygro").arg(QDir(folder.path()).count()));
            const Answer answer = run_cli(QStringList{"import", wif.fileName(), "-o", project, "--json"} + options);
            const QJsonObject suggested = answer.json()["suggestions"].toObject()["ends_per_cm"].toObject();
            const double pitch = run_cli({"check", project, "--json"})
                                     .json()["fabrics"]
                                     .toArray()[0]
                                     .toObject()["derived"]
                                     .toObject()["warp"]
                                     .toObject()["pitch_mm"]
                                     .toDouble();
            return std::make_pair(suggested["taken"].toBool(), qRound(10 / pitch));
        };
        QCOMPARE(ends({}), std::make_pair(true, 25));
        QCOMPARE(ends({"--use-suggestions"}), std::make_pair(true, 25));
        QCOMPARE(ends({"--no-suggestions"}), std::make_pair(false, 20));
        QCOMPARE(run_cli({"import", wif.fileName(), "--use-suggestions", "--no-suggestions"}).code, 2);
    }
    void checkDescribesTheYarnsOfStripes()
    {
        const QStringList call{
            "check", example("textile-F.hygro"),
            "--set", "fabrics[0].extra_yarns=[{\"material\":\"wool\",\"diameter_mm\":0.1},{\"material\":\"wool\",\"diameter_mm\":0.1}]",
            "--set", "fabrics[0].warp_order=[{\"yarn\":0,\"count\":4},{\"yarn\":1,\"count\":2}]"};
        const Answer text = run_cli(call);
        QCOMPARE(text.code, 0);
        QVERIFY2(text.out.contains("yarn B (extra yarn 1)") && text.out.contains("yarn C (extra yarn 2): used in neither order"),
                 text.out + text.err);
        const QJsonArray yarns =
            run_cli(call + QStringList{"--json"}).json()["fabrics"].toArray()[0].toObject()["derived"].toObject()["extra_yarns"].toArray();
        QCOMPARE(yarns.size(), 2);
        QCOMPARE(yarns[0].toObject()["diameter_mm"].toDouble(), 0.1);
        QVERIFY(yarns[0].toObject()["warp"].toObject()["pore_radius_um"].toDouble() > 0);
        QVERIFY(!yarns[0].toObject().contains("weft") && !yarns[1].toObject().contains("warp"));
    }
    void aDraftGoesOutAndComesBack()
    {
        QTemporaryDir folder;
        const QString wif = folder.filePath("f.wif"), project = folder.filePath("f.hygro");
        QCOMPARE(run_cli({"export", example("textile-F.hygro"), "-o", wif, "--quiet"}).code, 0);
        QCOMPARE(run_cli({"import", wif, "-o", project}).code, 0);
        const auto fabric = [](const QString& file) {
            return run_cli({"check", file, "--json"}).json()["fabrics"].toArray()[0].toObject();
        };
        for (const char* part : {"derived", "weave", "jam"}) QCOMPARE(fabric(project)[part], fabric(example("textile-F.hygro"))[part]);
    }
    void everydayClothIsNotWarnedOf()
    {
        QTemporaryDir folder;
        for (const char* name : {"Poplin shirting", "Denim", "Sports micro-twill", "Polyester taffeta", "Cotton sateen", "Wool serge"}) {
            const QString file = folder.filePath(QString(name) + ".hygro");
            QCOMPARE(run_cli({"presets", name, "-o", file}).code, 0);
            const QJsonArray issues = run_cli({"check", file, "--json"}).json()["issues"].toArray();
            for (const QJsonValue& issue : issues) {
                QVERIFY2(issue["severity"].toString() == "note", qPrintable(issue["text"].toString()));
            }
        }
    }
    void ofManyFabricsTheFirstOnesGeometryIsMeasured()
    {
        QFile given(example("textile-F.hygro"));
        QVERIFY(given.open(QIODevice::ReadOnly));
        QJsonObject project = QJsonDocument::fromJson(given.readAll()).object();
        QJsonObject fabric = project["fabrics"].toArray()[0].toObject();
        QJsonArray fabrics;
        for (int i = 0; i < 100; ++i) {
            fabric["name"] = QString("f%1").arg(i);
            fabrics.append(fabric);
        }
        project["fabrics"] = fabrics;
        QTemporaryDir folder;
        const QString file = folder.filePath("many.hygro");
        QFile many(file);
        QVERIFY(many.open(QIODevice::WriteOnly));
        many.write(QJsonDocument(project).toJson());
        many.close();
        const QJsonArray checked = run_cli({"check", file, "--json", "-q"}).json()["fabrics"].toArray();
        QCOMPARE(checked.size(), 100);
        const auto measured = std::count_if(checked.begin(), checked.end(), [](const QJsonValue& f) { return !f["geometry"].isNull(); });
        QVERIFY2(measured >= 5 && measured <= 40, qPrintable(QString::number(measured)));
        QVERIFY(checked[measured - 1]["geometry"].isObject() && checked[measured]["derived"].isObject());
        const QByteArray table = run_cli({"check", file, "-q"}).out;
        QCOMPARE(table.count("Geometry of 16 ends"), qsizetype{measured});
        QCOMPARE(table.count("Its geometry was not computed"), qsizetype{100 - measured});
    }
};

QTEST_APPLESS_MAIN(TestCommandLineCloth)
#include "tst_command_line_cloth.moc"
