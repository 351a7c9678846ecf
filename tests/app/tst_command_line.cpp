// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Exit codes, JSON and messages of every verb that needs no run.
#include "command_line.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <map>

class TestCommandLine : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;

private Q_SLOTS:
    void helpAndVersionSucceed()
    {
        QCOMPARE(run_cli({"--help"}).code, 0);
        QVERIFY(run_cli({"--version"}).out.contains("Hygroloom 0."));
        for (const char* verb : {"check", "plan", "simulate", "measure", "export", "import", "garment", "presets", "devices", "calibrate",
                                 "compare", "tradeoff", "verify"}) {
            const Answer answer = run_cli({verb, "--help"});
            QCOMPARE(answer.code, 0);
            QVERIFY2(answer.out.contains("Example: hygroloom-cli"), verb);
        }
    }
    void referenceListsEveryVerbAndOption()
    {
        const QString text = run_cli({"reference"}).out;
        for (const char* part :
             {"## simulate\n", "## verify\n", "| `-o`, `--output` |", "| `PROJECT` |", "| required |", "| `fibre_shells` |"})
            QVERIFY2(text.contains(part), part);
        QVERIFY(!run_cli({"--help"}).out.contains("reference  "));
    }
    void wrongUsageIsTwo_data()
    {
        QTest::addColumn<QStringList>("arguments");
        const QString f = example("textile-F.hygro");
        QTest::newRow("nothing") << QStringList{};
        QTest::newRow("no such verb") << QStringList{"weave"};
        QTest::newRow("no project") << QStringList{"check"};
        QTest::newRow("no such option") << QStringList{"check", f, "--colour"};
        QTest::newRow("no such fabric") << QStringList{"check", f, "--fabric", "Textile Z"};
        QTest::newRow("no such experiment") << QStringList{"plan", f, "--experiment", "x"};
        QTest::newRow("no such machine") << QStringList{"plan", f, "--backend", "abacus"};
        QTest::newRow("double precision on a GPU") << QStringList{"plan", f, "--backend", "cuda", "--set", "fidelity.double_precision=1"};
        QTest::newRow("no such fidelity") << QStringList{"plan", f, "--fidelity", "best"};
        QTest::newRow("auto without a wish") << QStringList{"plan", f, "--fidelity", "auto"};
        QTest::newRow("auto with two wishes") << QStringList{"simulate", f, "--fidelity", "auto", "--error", "5%", "--time", "10s"};
        QTest::newRow("a wish without auto") << QStringList{"simulate", f, "--error", "5%"};
        QTest::newRow("no such error") << QStringList{"plan", f, "--fidelity", "auto", "--error", "120%"};
        QTest::newRow("no such time") << QStringList{"plan", f, "--fidelity", "auto", "--time", "10 days"};
        QTest::newRow("no such part") << QStringList{"plan", f, "--physics", "magic=on"};
        QTest::newRow("no such knob") << QStringList{"plan", f, "--set", "fidelity.fibre_shels=3"};
        QTest::newRow("bundles of half yarns") << QStringList{"simulate", f, "--set", "fidelity.crossings_per_cell=1.5"};
        QTest::newRow("knob out of range") << QStringList{"simulate", f, "--set", "fidelity.fibre_shells=99"};
        QTest::newRow("knob of nothing that runs") << QStringList{"check", f, "--set", "fidelity.fibre_shells=3"};
        QTest::newRow("comparison of one") << QStringList{"compare", f};
        QTest::newRow("comparison in no folder")
            << QStringList{"compare", example("three-candidates.hygro"), "--experiment", "one drop", "-o", "/dev/null/x"};
        QTest::newRow("neither a project nor measurements") << QStringList{"tradeoff"};
        QTest::newRow("no such rung") << QStringList{"tradeoff", f, "--fidelities", "draft,best"};
        QTest::newRow("no repeats of a trade-off") << QStringList{"tradeoff", f, "--repeats", "0"};
        QTest::newRow("no such backend") << QStringList{"simulate", f, "--backend", "abacus"};
        QTest::newRow("set without value") << QStringList{"check", f, "--set", "fabrics[0].ends_per_cm"};
        QTest::newRow("set of nothing") << QStringList{"check", f, "--set", "fabrics[0].end=1"};
        QTest::newRow("set to a word") << QStringList{"check", f, "--set", "fabrics[0].ends_per_cm=nan"};
        QTest::newRow("no such detail") << QStringList{"export", f, "--detail", "threads", "-o", "x.obj"};
        QTest::newRow("centrelines as triangles") << QStringList{"export", f, "--detail", "centreline", "-o", "x.stl"};
        QTest::newRow("skins as curves") << QStringList{"export", f, "-o", "x.bcc"};
        QTest::newRow("no repeats") << QStringList{"export", f, "--repeats", "0x2", "-o", "x.obj"};
        QTest::newRow("size and repeats") << QStringList{"export", f, "--repeats", "2x2", "--size-mm", "5x5", "-o", "x.obj"};
        QTest::newRow("time without water") << QStringList{"export", f, "--time", "1", "-o", "x.obj"};
        QTest::newRow("too large") << QStringList{"export", f, "--detail", "fibre", "--size-mm", "100x100", "-o", "x.glb"};
        QTest::newRow("time of a word") << QStringList{"export", f, "--water", "x.hygrorec", "--time", "1s", "-o", "x.obj"};
        QTest::newRow("no such format") << QStringList{"export", f, "-o", "x.dwg"};
        QTest::newRow("no size") << QStringList{"export", f, "--size-mm", "5", "-o", "x.obj"};
        QTest::newRow("map without file") << QStringList{"measure", "x.hygrorec", "--map", "top"};
    }
    void wrongUsageIsTwo()
    {
        QFETCH(QStringList, arguments);
        const Answer answer = run_cli(arguments);
        QCOMPARE(answer.code, 2);
        QVERIFY(!answer.err.isEmpty());
    }
    void invalidInputIsThree()
    {
        QCOMPARE(run_cli({"check", "/nowhere.hygro"}).code, 3);
        const Answer wrong = run_cli({"check", example("textile-F.hygro"), "--set", "fabrics[0].ends_per_cm=-1"});
        QCOMPARE(wrong.code, 3);
        QVERIFY2(wrong.err.contains(
                     "textile-F.hygro: fabrics[0].ends_per_cm: error: The number of ends per cm must be from 0.5 to 500; given is -1."),
                 wrong.err);
        QCOMPARE(run_cli({"simulate", example("textile-F.hygro"), "--set", "experiments[0].duration_s=0"}).code, 3);
        QCOMPARE(run_cli({"measure", example("textile-F.hygro")}).code, 3);
    }
    void aRecordingGivenForAProjectIsNamedAsOne()
    {
        const QString recording = folder_.filePath("drop.hygrorec");
        QFile file(recording);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("SQLite format 3 and the rest");
        file.close();
        for (const char* verb : {"simulate", "check", "plan"}) {
            const Answer answer = run_cli({verb, recording});
            QCOMPARE(answer.code, 3);
            QVERIFY2(answer.err.contains("This is a recording, not a project. The verb measure reads it"), answer.err);
        }
        QVERIFY(file.remove());
    }
    void warningsAreShownByCheckAndCountedByOthers()
    {
        const QStringList dense{example("textile-F.hygro"), "--set", "fabrics[0].ends_per_cm=45"};
        const Answer check = run_cli(QStringList{"check"} + dense), plan = run_cli(QStringList{"plan", "--json"} + dense);
        const qsizetype warnings = check.err.count(": warning: ");
        QVERIFY(warnings > 0);
        const QByteArray line =
            QString("%1 warning%2; see hygroloom-cli check %3.\n").arg(warnings).arg(warnings == 1 ? "" : "s", dense[0]).toUtf8();
        QCOMPARE(plan.err, line);
        QVERIFY(!plan.json().isEmpty());
        QCOMPARE(run_cli(QStringList{"plan", "--quiet"} + dense).err, QByteArray());
    }
    void presetsAreListedAndAddedToAProject()
    {
        QVERIFY(run_cli({"presets"}).out.contains("Poplin shirting"));
        QVERIFY(run_cli({"presets", "--finishes"}).out.contains("water repellent"));
        QTemporaryDir folder;
        const QString project = folder.filePath("cloth.hygro");
        QCOMPARE(run_cli({"presets", "Denim", "Textile F", "-o", project}).code, 0);
        const Answer again = run_cli({"presets", "Denim", "-o", project});
        QCOMPARE(again.code, 0);
        QVERIFY2(again.err.contains("the new one is \"Denim 2\"."), again.err);
        const Answer check = run_cli({"check", project, "--fabric", "Denim 2"});
        QCOMPARE(check.code, 0);
        QVERIFY(check.out.contains("laboratory"));
        const Answer wrong = run_cli({"presets", "Jeans", "-o", project});
        QCOMPARE(wrong.code, 2);
        QVERIFY(wrong.err.contains("Denim"));
    }
    void checkPrintsDerivedBesideMeasured()
    {
        const Answer answer = run_cli({"check", example("textile-F.hygro"), "--set", "fabrics[0].areal_density_g_m2=162"});
        QCOMPARE(answer.code, 0);
        QVERIFY(answer.out.contains("linear density") && answer.out.contains("24.35"));
        QVERIFY(answer.out.contains("162"));
        QVERIFY(answer.out.contains("flyaway fibres."));
    }
    void checkAnswersInJson()
    {
        const Answer answer = run_cli({"check", example("textile-F.hygro"), "--json", "--set", "fabrics[0].porosity=0.8"});
        QCOMPARE(answer.code, 0);
        const QJsonObject json = answer.json();
        QCOMPARE(json["valid"].toBool(), true);
        const QJsonObject fabric = json["fabrics"].toArray()[0].toObject();
        QVERIFY(qAbs(fabric["derived"].toObject()["warp"].toObject()["linear_density_tex"].toDouble() - 24.347) < 0.001);
        QCOMPARE(fabric["measured"].toObject()["porosity"].toDouble(), 0.8);
        const Answer wrong = run_cli({"check", example("textile-F.hygro"), "--json", "--set", "fabrics[0].ends_per_cm=99"});
        QCOMPARE(wrong.code, 3);
        QCOMPARE(wrong.json()["valid"].toBool(true), false);
        QCOMPARE(wrong.json()["issues"].toArray()[0].toObject()["code"].toString(), QString("ends_do_not_fit"));
        QCOMPARE(run_cli({"check", "/nowhere.hygro", "--json"}).json()["exit_code"].toInt(), 3);
    }
    void setTakesSeveralValuesAndLeavesTheProject()
    {
        const Answer answer = run_cli(
            {"check", "--set", "fabrics[0].ends_per_cm=20", "fabrics.Textile F.picks_per_cm=18", example("textile-F.hygro"), "--json"});
        QCOMPARE(answer.code, 0);
        const QJsonObject derived = answer.json()["fabrics"].toArray()[0].toObject()["derived"].toObject();
        QCOMPARE(derived["warp"].toObject()["pitch_mm"].toDouble(), 0.5);
        QVERIFY(qAbs(derived["weft"].toObject()["pitch_mm"].toDouble() - 10.0 / 18) < 1e-12);
    }
    void planSaysWhatAndWhy()
    {
        const Answer answer = run_cli({"plan", example("textile-F.hygro"), "--fidelity", "draft"});
        QCOMPARE(answer.code, 0);
        QVERIFY(answer.out.contains("wicking"));
        QVERIFY(run_cli({"plan", example("textile-F.hygro"), "--json", "--physics", "heat=off"}).json().contains("parts"));
        const auto source = [](const QString& backend) {
            const QJsonObject plan = run_cli({"plan", example("textile-F.hygro"), "--json", "--backend", backend}).json();
            return plan["expected"].toObject()["source"].toString();
        };
        QVERIFY(source("cuda").contains("H200")); // a GPU that need not be there
        QVERIFY(!source("cpu").contains("H200") && source("cpu").contains(" thread"));
    }
    void planNamesTheKeysThatChangeNothing()
    {
        const QStringList plan{"plan", example("textile-F.hygro"), "--set", "experiments[0].closure=paper"};
        const QString text = run_cli(plan).out;
        QVERIFY2(text.contains("only the closure pores reads it: ") && text.contains("yarn.twist_per_m"), qPrintable(text));
        const QJsonArray keys = run_cli(plan + QStringList{"--json"}).json()["idle_keys"].toArray();
        const auto is_twist = [](const QJsonValue& key) { return key.toObject()["key"].toString() == "yarn.twist_per_m"; };
        const auto twist = std::find_if(keys.begin(), keys.end(), is_twist);
        QVERIFY(twist != keys.end());
        QCOMPARE(twist->toObject()["because"].toString(), QString("sections of filament yarns and of given diameters do not follow it"));
    }
    void planListsTheKnobsAndTakesOne()
    {
        const QStringList plan{"plan", example("textile-F.hygro"), "--set", "fidelity.fibre_shells=12"};
        const Answer answer = run_cli(plan);
        QCOMPARE(answer.code, 0);
        QVERIFY2(answer.out.contains("network_step_limit_s    0.001 s"), answer.out);
        QVERIFY2(answer.out.contains("(set by the user; standard has 8)"), answer.out);
        const QJsonObject knobs = run_cli(plan + QStringList{"--json"}).json()["knobs"].toObject();
        QCOMPARE(knobs["fibre_shells"].toInt(), 12);
        QCOMPARE(knobs["particles_per_droplet"].toInt(), 8000);
        QCOMPARE(knobs["steps_between_absorption"].toInt(), 8);
        QCOMPARE(knobs["free_liquid"].toString(), QString("particles"));
        QCOMPARE(knobs.size(), 16);
        QVERIFY(run_cli({"plan", "--help"}).out.contains("fibre_shells"));
    }
    void planBeginsWithWhatItIsOfAndWhatToExpect()
    {
        const QStringList call{"plan", example("three-candidates.hygro"), "--fabric", "Hemp plain", "--experiment", "one drop"};
        const Answer people = run_cli(call), script = run_cli(call + QStringList{"--json"});
        QVERIFY2(people.out.startsWith("fabric       Hemp plain\nexperiment   one drop\nexpected     about "), people.out);
        QCOMPARE(script.json()["fabric"].toString(), QString("Hemp plain"));
        QCOMPARE(script.json()["experiment"].toString(), QString("one drop"));
        QVERIFY(script.json()["expected"].toObject()["time_s"].toDouble() > 0);
    }
    void planSaysWhereYarnsAreNotBundled()
    {
        const auto plan = [](const char* experiment) {
            return run_cli({"plan", example("laboratory.hygro"), "--experiment", experiment, "--set", "fidelity.crossings_per_cell=2",
                            "fidelity.crossings_per_even_cell=1"})
                .out;
        };
        const QByteArray drop = plan("one drop"), drying = plan("drying");
        QVERIFY2(drop.contains("although the fidelity would put 2 ends and picks into one: free liquid meets single yarns."), drop);
        QVERIFY2(drying.contains("are simulated as 52 and 52 bundles; what a frame shows of a yarn is its bundle's."), drying);
    }
    void aMisspeltVerbIsNamed()
    {
        const Answer near = run_cli({"mesure", "a.hygrorec"}), far = run_cli({"knit"});
        QVERIFY2(near.err.contains("There is no verb \"mesure\"; did you mean \"measure\"?"), near.err);
        QVERIFY2(far.err.contains("The verbs are: check, plan, simulate, measure,"), far.err);
    }
    void planLeavesOutWhatIsNotInTheScene()
    {
        const auto plan = [](const char* experiment, const char* fidelity) {
            return run_cli({"plan", example("laboratory.hygro"), "--experiment", experiment, "--fidelity", fidelity}).out;
        };
        const QByteArray drying = plan("drying", "draft"), drop = plan("one drop", "draft");
        QVERIFY2(!drying.contains("particles a drop") && drying.contains("no drop falls: particles_per_droplet, "), drying);
        QVERIFY2(drying.contains("takes at most all of the water delivered"), drying);
        QVERIFY2(drop.contains("2000 particles a drop"), drop);
        const QRegularExpression large("[1-9][0-9]{2,}(\\.[0-9]+)? %|e\\+");
        for (const QByteArray& text : {drying, drop, plan("conditioning", "draft"), plan("moisture management", "standard")})
            QVERIFY2(
                !QString::fromUtf8(text).remove("more than 100 %").remove(QRegularExpression("numerical error [0-9.]+ %")).contains(large),
                text);
        QVERIFY(plan("one drop", "reference").contains("numerical error not known (this is the reference)"));
        const QRegularExpression error(", numerical error ([0-9.]+) %");
        const QString shown = error.match(QString::fromUtf8(drying)).captured(1);
        const qsizetype digits = QString(shown).remove('.').remove(QRegularExpression("^0+")).size();
        QVERIFY2(digits == 1 || digits == 2, qPrintable(shown));
    }
    void aWrongFidelityIsRefusedWithTheValidOnes()
    {
        const QString project = example("three-candidates.hygro");
        for (const char* verb : {"plan", "simulate", "compare"}) {
            const Answer answer = run_cli({verb, project, "--fidelity", "best"});
            QCOMPARE(answer.code, 2);
            QVERIFY2(answer.err.contains("live, draft, standard, reference or auto; given is \"best\""), answer.err);
        }
        QVERIFY(run_cli({"compare", project, "--fidelity", "auto"}).err.contains("needs either"));
        const Answer ladder = run_cli({"tradeoff", example("textile-F.hygro"), "--fidelities", "draft,auto"}); // where auto is none
        QVERIFY2(ladder.err.contains("live, draft, standard or reference; \"auto\""), ladder.err);
    }
    void autoSaysWhatItTookAndWhy()
    {
        const auto plan = [](const char* option, const char* wish) {
            return run_cli({"plan", example("textile-F.hygro"), "--json", "--fidelity", "auto", option, wish}).json();
        };
        QCOMPARE(plan("--time", "9h")["fidelity"].toString(), QString("reference"));
        const QJsonObject hurried = plan("--time", "0.001s");
        QCOMPARE(hurried["fidelity"].toString(), QString("live"));
        QVERIFY(hurried["fidelity_reason"].toString().startsWith("No fidelity is expected to take at most 0.001 s"));
        QVERIFY(!plan("--error", "5%")["fidelity_reason"].toString().isEmpty());
    }
    void verifyAnswersWithGradesAsTheMetricsHaveThem()
    {
        // Yao et al.'s example: each index over its range, weighed, is 0.633; grades by the table of AATCC 195.
        const Answer answer = run_cli({"verify", "management_indices", "--json", "--backend", "cpu", "--set",
                                       "absorption_rate_bottom_pct_s=55", "one_way_transport_pct=250", "spreading_speed_bottom_mm_s=3.1",
                                       "wetting_time_top_s=120", "wetting_time_bottom_s=2.9"});
        QCOMPARE(answer.code, 0);
        std::map<QString, QJsonObject> results;
        for (const QJsonValue& result : answer.json()["results"].toArray()) results[result["name"].toString()] = result.toObject();
        QVERIFY(qAbs(results["ommc"]["computed"].toDouble() - 0.6333) < 1e-4);
        QVERIFY(results["grades"]["pass"].toBool());
        const QJsonObject grades = results["grades"]["computed"].toObject();
        QCOMPARE(results["grades"]["expected"].toObject(), grades);
        QCOMPARE(grades.size(), 10);
        for (const auto& [name, grade] :
             {std::pair("wetting_time_top", 1), std::pair("wetting_time_bottom", 5), std::pair("absorption_rate_bottom", 4),
              std::pair("one_way_transport", 4), std::pair("spreading_speed_bottom", 4), std::pair("ommc", 4)}) {
            QCOMPARE(grades[name].toInt(), grade);
            QCOMPARE(results[QString("grade_") + name]["computed"].toInt(), grade);
        }
    }
    void devicesListTheCpuFirst()
    {
        const Answer answer = run_cli({"devices", "--json"});
        QCOMPARE(answer.code, 0);
        const QJsonObject first = answer.json()["devices"].toArray()[0].toObject();
        QCOMPARE(first["backend"].toString(), QString("cpu"));
        QCOMPARE(first["usable"].toBool(), true);
    }
    void aDecimalCommaIsExplained()
    {
        const Answer answer = run_cli({"check", example("textile-F.hygro"), "--set", "fabrics[0].ends_per_cm=35,5"});
        QCOMPARE(answer.code, 2);
        QVERIFY2(answer.err.contains("Numbers are written with a decimal point: 35.5."), answer.err);
    }
    void exportWritesMeshesAndSaysHowLarge()
    {
        for (const char* ending : {"obj", "ply", "stl", "glb", "gltf", "fbx", "dae"}) {
            const QString file = folder_.filePath(QString("cloth.") + ending);
            const Answer answer = run_cli({"export", example("textile-A.hygro"), "--size-mm", "3x2", "-o", file});
            QCOMPARE(answer.code, 0);
            QVERIFY(QFile(file).size() > 1000);
            QVERIFY2(answer.err.contains("5 ends and 3 picks"), answer.err);
        }
        QCOMPARE(
            run_cli({"export", example("textile-A.hygro"), "--detail", "centreline", "-o", folder_.filePath("lines.obj"), "--quiet"}).err,
            QByteArray());
        const Answer nowhere = run_cli({"export", example("textile-A.hygro"), "-o", "/nowhere/cloth.obj"});
        QCOMPARE(nowhere.code, 1);
        QVERIFY(nowhere.err.contains("/nowhere/cloth.obj"));
        QCOMPARE(QDir(folder_.path()).entryList(QDir::Files | QDir::Hidden).size(), 7 + 3 + 1); // cloth.mtl, cloth.bin and lines.mtl, too
    }
    void exportForetellsWhatItWrites()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath("cloth.ply");
        const QStringList arguments{
            "export", example("textile-A.hygro"), "--detail", "fibre", "--repeats", "2x3", "--open-ends", "--json", "-o", file};
        const QJsonObject estimated = run_cli(arguments + QStringList{"--estimate"}).json();
        const Answer printed = run_cli({"export", example("textile-A.hygro"), "--estimate", "--quiet", "-o", file});
        QVERIFY2(printed.out.contains("triangles, about "), printed.out);
        QCOMPARE(printed.err, QByteArray());
        QVERIFY(QDir(folder.path()).isEmpty(QDir::Files | QDir::Hidden));
        const QJsonObject written = run_cli(arguments).json();
        for (const char* key : {"vertices", "faces", "bytes", "ends", "picks"})
            QVERIFY2(estimated[key].toDouble() > 0 && estimated[key] == written[key], key);
        QCOMPARE(written["bytes"].toInteger(), QFileInfo(file).size());
        QCOMPARE(written["files"].toArray().size(), 1);
        QVERIFY(written["seconds"].toDouble() > 0);
    }
};

QTEST_APPLESS_MAIN(TestCommandLine)
#include "tst_command_line.moc"
