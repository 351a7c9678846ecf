// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// card, as a script would run it.
#include "tests/app/command_line.h"

#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

class TestCommandLineCard : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;

    QString file(const char* name) const { return folder_.filePath(name); }
    /// The project of a poplin, made once.
    QString poplin() const
    {
        if (!QFile::exists(file("poplin.hygro"))) run_cli({"presets", "Poplin shirting", "-o", file("poplin.hygro")});
        return file("poplin.hygro");
    }
    static QByteArray content(const QString& path)
    {
        QFile in(path);
        return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
    }

private Q_SLOTS:
    void itHasWhatTheContractSays()
    {
        const Answer answer = run_cli({"card", poplin(), "--fabric", "Poplin shirting", "--json", "--width-cm", "100"});
        QVERIFY2(answer.code == 0, answer.err.constData());
        QVERIFY(answer.json()["missing"].isArray() && answer.json()["missing"].toArray().isEmpty());
        const QJsonObject card = answer.json(), construction = card["construction"].toObject(), laboratory = card["laboratory"].toObject();
        QCOMPARE(card["fabric"].toString(), "Poplin shirting");
        QVERIFY(qAbs(construction["g_per_m"].toDouble() - construction["areal_density_g_m2"].toDouble()) < 0.2); // of one metre's width
        QVERIFY(construction["yarn_cost_per_m"].isNull());
        for (const char* key : {"air_permeability_mm_s", "rct_m2k_w", "ret_m2pa_w", "absorption_drained_percent", "thickness_mm"}) {
            const QJsonObject number = laboratory[key].toObject();
            QVERIFY2(number["low"].toDouble() <= number["value"].toDouble() && number["value"].toDouble() <= number["high"].toDouble() &&
                         number["value"].toDouble() > 0,
                     key);
        }
    }
    void checkHasTheQuickNumbers()
    {
        const QJsonObject fabric = run_cli({"check", poplin(), "--json"}).json()["fabrics"].toArray()[0].toObject();
        const QJsonObject laboratory = fabric["laboratory"].toObject();
        QCOMPARE(laboratory["mass_g_m2"].toObject()["value"].toDouble(), fabric["derived"].toObject()["areal_density_g_m2"].toDouble());
        QVERIFY(!laboratory.contains("air_permeability_mm_s"));
    }
    void loomAndPricesAreOnIt()
    {
        const Answer answer =
            run_cli({"card", poplin(), "--json", "--set", "fabrics[0].loom.reed_width_cm=159", "--set", "fabrics[0].loom.ends_per_dent=2",
                     "--set", "fabrics[0].warp.price=6.5", "--set", "fabrics[0].weft.price=6.5"});
        QVERIFY2(answer.code == 0, answer.err.constData());
        const QJsonObject construction = answer.json()["construction"].toObject(), loom = construction["loom"].toObject();
        QVERIFY(qAbs(loom["dents_per_10_cm"].toDouble() - 247) < 0.3);
        QVERIFY(qAbs(construction["yarn_cost_per_m"].toDouble() - 6.5e-3 * construction["g_per_m"].toDouble()) < 1e-9);
    }
    void itIsWrittenAsPageAndTable()
    {
        QCOMPARE(run_cli({"card", poplin(), "-o", file("card.html"), "-q"}).code, 0);
        const QByteArray page = content(file("card.html"));
        for (const char* text : {"Air permeability at 100 Pa", "ISO 11092", "data:image/png", "10 mm", "turned over", "mm wide", "g/m"})
            QVERIFY2(page.contains(text), text);
        for (const char* text : {"verify", "Numerical"}) QVERIFY2(!page.contains(text), text); // of programs, not of cloths
        QCOMPARE(
            run_cli({"card", poplin(), "-o", file("order.html"), "-q", "--length-m", "500", "--set", "fabrics[0].warp.price=6.5"}).code, 0);
        const QByteArray order = content(file("order.html"));
        for (const char* text : {"kg for 500 m", "cost of 1 m", "no price", "currency", "Only a measurement of it tells more"})
            QVERIFY2(order.contains(text), text);
        const QStringList ordered{"card", poplin(), "-q", "--length-m", "500", "--set", "fabrics[0].warp.price=6.5"};
        const Answer printed = run_cli(ordered);
        QVERIFY(printed.out.count("kg for 500 m") == 3 && printed.out.count("no price") == 1 && printed.out.count("cost ") == 1);
        QVERIFY(printed.out.contains("was compared with 16 sold cloths"));
        QCOMPARE(run_cli(ordered + QStringList{"-o", file("order.csv")}).code, 0);
        const QByteArray priced = content(file("order.csv"));
        for (const char* text : {"\nyarn_cost_per_m,warp,", "\nyarn_cost_per_m,weft,,,,per m,,no price,", "\nyarn_kg,together,",
                                 "for 500 m", "was compared with 16 sold cloths"})
            QVERIFY2(priced.contains(text), text);
        QCOMPARE(run_cli({"card", poplin(), "-o", file("card.csv"), "-q"}).code, 0);
        const QByteArray table = content(file("card.csv"));
        QVERIFY(table.startsWith("key,title,value,low,high,unit,standard,conditions,run\n") && table.contains("\nret_m2pa_w,"));
        for (const char* key : {"ends_per_cm", "picks_per_cm", "width_cm", "warp_linear_density_tex", "weft_crimp_percent",
                                "yarn_share_percent", "yarn_take_up_percent", "mass_g_m2", "thickness_mm"})
            QVERIFY2(table.contains(QByteArray("\n") + key + ','), key);
    }
    void comparedFabricsHaveItsNumbersBeside()
    {
        const QString cloths = file("cloths.hygro");
        run_cli({"presets", "Poplin shirting", "Sheeting", "--experiment", "droplet", "-o", cloths});
        const Answer answer = run_cli({"compare", cloths, "--card", "--json", "--fidelity", "live", "--backend", "cpu", "-q", "-o",
                                       file("compared"), "--report", file("compared.html")});
        QVERIFY2(answer.code == 0, answer.err.constData());
        QVERIFY(content(file("compared.html")).contains("Air permeability at 100 Pa, mm/s"));
        double air[2] = {};
        for (const auto& each : answer.json()["candidates"].toArray()) {
            const QJsonObject candidate = each.toObject();
            air[candidate["fabric"].toString() == "Sheeting"] =
                candidate["laboratory"].toObject()["air_permeability_mm_s"].toObject()["value"].toDouble();
        }
        QVERIFY(air[0] > 0 && air[1] > 2 * air[0]);
        QVERIFY(content(file("compared/comparison.csv")).contains(",air_permeability_mm_s,air_permeability_mm_s_low,"));
    }
    void numbersOfTestsAreRunAndKept()
    {
        const QStringList asked{"card", poplin(), "--runs", "drying,regain", "--backend", "cpu", "--json", "-q", "--keep", file("kept")};
        const Answer first = run_cli(asked), second = run_cli(asked);
        QVERIFY2(first.code == 0 && second.code == 0, first.err.constData());
        const QJsonObject ran = first.json()["laboratory"].toObject(), kept = second.json()["laboratory"].toObject();
        QVERIFY(!ran.contains("ommc")); // it was not asked for
        for (const char* key : {"drying_time_min", "drying_index_pct_min", "regain_percent"}) {
            const QJsonObject number = ran[key].toObject(), again = kept[key].toObject();
            QCOMPARE(number["run"].toString(), "live, cpu");
            QCOMPARE(again["run"].toString(), "live, cpu, kept run");
            QVERIFY2(number["low"].toDouble() <= number["value"].toDouble() && number["value"].toDouble() > 0, key);
            QCOMPARE(again["value"].toDouble(), number["value"].toDouble());
        }
        const QJsonObject other = run_cli(asked + QStringList{"--set", "fabrics[0].picks_per_cm=20"}).json()["laboratory"].toObject();
        QCOMPARE(other["drying_time_min"].toObject()["run"].toString(), "live, cpu"); // of another cloth
    }
    void yarnsOfALibraryGoThroughTablesAndProjects()
    {
        QFile table(file("yarns.csv"));
        QVERIFY(table.open(QIODevice::WriteOnly) && table.write("name,count,material,supplier\nnew,Ne 36,cotton,Mill\n") > 0);
        table.close();
        QCOMPARE(run_cli({"yarns", file("own.hygrolib")}).code, 3); // it is not there yet
        QCOMPARE(run_cli({"yarns", file("own.hygrolib"), "--read", file("yarns.csv"), "-q", "--write", file("all.csv")}).code, 0);
        QVERIFY(content(file("all.csv")).contains("\nnew,Mill,cotton 100,"));
        const QJsonObject listed = run_cli({"yarns", file("own.hygrolib"), "--json"}).json();
        const QJsonObject yarn = listed["yarns"].toArray()[0].toObject();
        QCOMPARE(yarn["supplier"].toString(), "Mill");
        QCOMPARE(yarn["count"].toString(), "Ne 36");
        QCOMPARE(yarn["fibres"].toString(), "cotton 100");
        QVERIFY(yarn["price"].isNull());
        const QStringList use{"yarns", file("own.hygrolib"), "--project", poplin(), "--json", "--where-used"};
        QVERIFY(run_cli(use + QStringList{"new"}).json()["fabrics"].toArray().isEmpty()); // the poplin has another
        QCOMPARE(run_cli(use + QStringList{"no such"}).code, 2);
        for (const QString& over : {file("own.hygrolib"), file("yarns.csv"), poplin(), file("./yarns.csv"), file("table.txt")}) {
            const QByteArray before = content(over);
            const QStringList again{"yarns", file("own.hygrolib"), "--read", file("yarns.csv"), "--write", over};
            QCOMPARE(run_cli(again).code, 2);
            QCOMPARE(content(over), before);
        }
    }
    void yarnsOfAProjectAreBroughtUpToDate()
    {
        const auto kept = [this](const QByteArray& table) {
            QFile csv(file("kept.csv"));
            if (csv.open(QIODevice::WriteOnly)) csv.write(table);
            csv.close();
            return run_cli({"yarns", file("kept.hygrolib"), "--read", file("kept.csv"), "-q"}).code;
        };
        const QString cloth = file("kept.hygro");
        run_cli({"presets", "Poplin shirting", "-o", cloth});
        QCOMPARE(kept("name,material,linear_density_tex\nwarp,cotton,14.7625\n"), 0);
        const QStringList of{"yarns", file("kept.hygrolib"), "--project", cloth, "--json"};
        QVERIFY(run_cli(of + QStringList{"--where-used", "warp", "--by", "warp"}).json()["replaced"].toBool()); // it refers to it now
        QVERIFY(content(cloth).contains("\"twist_per_m\": 1046") && content(cloth).contains("\"packing_factor\": 0.6"));
        QVERIFY(!run_cli(of + QStringList{"--update"}).json()["updated"].toBool());
        QCOMPARE(kept("name,material,linear_density_tex\nwarp,cotton,14.5\n"), 0);
        const QJsonObject done = run_cli(of + QStringList{"--update"}).json();
        QVERIFY(done["updated"].toBool());
        const QJsonObject change = done["updates"].toArray()[0].toObject()["changes"].toArray()[0].toObject();
        QCOMPARE(change["field"].toString(), "linear_density_tex");
        QCOMPARE(change["before"].toString() + " " + change["after"].toString(), "14.7625 tex 14.5 tex");
        QVERIFY(content(cloth).contains("\"library_yarn\": \"warp\"") && content(cloth).contains("14.5"));
        QCOMPARE(run_cli({"yarns", file("kept.hygrolib"), "--update"}).code, 2); // no project is named
        const QByteArray linked = content(cloth);
        const auto write_cloth = [&cloth](const QByteArray& text) {
            QFile project(cloth);
            return project.open(QIODevice::WriteOnly) && project.write(text) == text.size();
        };
        QVERIFY(write_cloth(QByteArray(linked).replace("\"library_yarn\": \"warp\"", "\"library_yarn\": \"gone\"")));
        QCOMPARE(run_cli(of + QStringList{"--update"}).code, 3);
        const Answer missing = run_cli(of.first(of.size() - 1) + QStringList{"--update"}); // in words
        QVERIFY2(missing.code == 3 && missing.err.contains("The library has no yarn \"gone\"."), missing.err.constData());
        QVERIFY(write_cloth(QByteArray(linked).replace("\"packing_factor\": 0.6,", "\"packing_factor\": 6,")));
        QCOMPARE(kept("name,material,linear_density_tex\nwarp,cotton,14\n"), 0);
        const Answer invalid = run_cli(of + QStringList{"--update"});
        QVERIFY2(invalid.code == 3 && invalid.err.contains("the project is not valid as it is"), invalid.err.constData());
    }
    void aYarnThatDoesNotFitReplacesNone()
    {
        QFile table(file("two.csv"));
        QVERIFY(table.open(QIODevice::WriteOnly));
        table.write("name,material,linear_density_tex,packing_factor,twist_per_m\nwarp,cotton,14.7625,0.6,1046\n"
                    "fine,cotton,14,0.6,1046\nheavy,cotton,590,0.6,200\n");
        table.close();
        QCOMPARE(run_cli({"yarns", file("two.hygrolib"), "--read", file("two.csv")}).code, 0);
        const QStringList use{"yarns", file("two.hygrolib"), "--project", poplin(), "--where-used", "warp", "--json", "--by"};
        const QByteArray before = content(poplin());
        const Answer refused = run_cli(use + QStringList{"heavy"});
        QCOMPARE(refused.code, 3);
        QVERIFY2(refused.err.contains("Nothing was replaced"), refused.err.constData());
        QCOMPARE(content(poplin()), before);
        QVERIFY(run_cli(use + QStringList{"fine"}).json()["replaced"].toBool());
        QVERIFY(!run_cli(use + QStringList{"fine"}).json()["replaced"].toBool(true)); // none is left
    }
    void wrongRequestsAreRefused()
    {
        QCOMPARE(run_cli({"card", poplin(), "--runs", "no such"}).code, 2);
        QCOMPARE(run_cli({"card", poplin(), "--fidelity", "no such"}).code, 2);
        QCOMPARE(run_cli({"card", poplin(), "-o", file("card.doc")}).code, 2);
        QCOMPARE(run_cli({"card", poplin(), "--fabric", "no such"}).code, 2);
        QCOMPARE(run_cli({"card", poplin(), "--set", "fabrics[0].loom.reed_width_cm=0"}).code, 3);
    }
};

QTEST_GUILESS_MAIN(TestCommandLineCard)
#include "tst_command_line_card.moc"
