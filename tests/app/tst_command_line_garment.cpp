// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Garments on the command line: what is said about their names, files and experiments.
#include "tests/app/command_line.h"

#include <QFile>
#include <QJsonArray>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>

class TestCommandLineGarment : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;

    QString at(const QString& name) const { return folder_.filePath(name); }
    static QJsonObject read(const QString& path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object() : QJsonObject();
    }
    void write(const QString& name, const QByteArray& bytes) const
    {
        QFile file(at(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
    }
    /// The tee's project with other keys of its garment and its experiment.
    void write_project(const QString& name, const QJsonObject& garment, const QJsonObject& wear = {}) const
    {
        QJsonObject project = read(at("tee.hygro"));
        QJsonObject changed = project["garments"].toArray()[0].toObject();
        for (auto key = garment.begin(); key != garment.end(); ++key) changed[key.key()] = key.value();
        project["garments"] = QJsonArray{changed};
        QJsonArray experiments = project["experiments"].toArray();
        QJsonObject last = experiments.last().toObject();
        for (auto key = wear.begin(); key != wear.end(); ++key) last[key.key()] = key.value();
        experiments[experiments.size() - 1] = last;
        project["experiments"] = experiments;
        write(name, QJsonDocument(project).toJson());
    }
    QJsonObject cut() const { return read(at("tee.hygro"))["garments"].toArray()[0].toObject()["panels"].toObject()["*"].toObject(); }

private Q_SLOTS:
    void initTestCase() { QCOMPARE(run_cli({"garment", "import", "built-in:tee", "-o", at("tee.hygro")}).code, 0); }

    /// An imported garment can be worn without a key written by hand.
    void an_imported_garment_is_worn()
    {
        const QJsonArray experiments = read(at("tee.hygro"))["experiments"].toArray();
        QCOMPARE(experiments.size(), 1);
        QCOMPARE(experiments[0].toObject()["type"].toString(), QString("wear"));
        QCOMPARE(experiments[0].toObject()["garment"].toString(), QString("tee"));
        const Answer plan = run_cli({"garment", "plan", at("tee.hygro"), "--cell-mm", "30", "--json"});
        QCOMPARE(plan.code, 0);
        QCOMPARE(plan.json()["experiment"].toString(), QString("wear"));
        const Answer second = run_cli({"garment", "import", "built-in:singlet", "-o", at("two.hygro")});
        QVERIFY2(second.out.contains("worn in the experiment \"wear\""), second.out);
        QCOMPARE(run_cli({"garment", "import", "built-in:tee", "-o", at("two.hygro")}).code, 0);
        QCOMPARE(read(at("two.hygro"))["experiments"].toArray()[1].toObject()["name"].toString(), QString("wear 2"));
    }

    void names_that_the_pattern_lacks_are_reported()
    {
        write_project("typos.hygro", {{"panels", QJsonObject{{"*", cut()}, {"frnt", cut()}}},
                                      {"seams", QJsonObject{{"front|bak", 0.5}, {"left sleeve|right sleeve", 0.5}, {"front|back", 1}}}});
        for (const QStringList& verb : {QStringList{"check"}, QStringList{"garment", "plan", "--cell-mm", "30"}}) {
            const Answer said = run_cli(verb + QStringList{at("typos.hygro")});
            QCOMPARE(said.code, 0);
            QVERIFY2(said.err.contains("panels.frnt: warning: The pattern has no panel \"frnt\"; did you mean \"front\"?"), said.err);
            QVERIFY2(said.err.contains("seams.front|bak: warning: The pattern has no panel \"bak\"; did you mean \"back\"?"), said.err);
            QVERIFY2(said.err.contains("\"left sleeve\" and \"right sleeve\" are not sewn together."), said.err);
            QVERIFY2(!said.err.contains("front|back:"), said.err);
        }
    }

    void check_reads_what_garments_name()
    {
        const Answer good = run_cli({"check", at("tee.hygro")});
        QVERIFY2(good.out.contains("Garment tee: ") && good.out.contains("4 panels") && good.out.contains("left sleeve 0."), good.out);
        const QJsonArray listed = run_cli({"check", at("tee.hygro"), "--json"}).json()["garments"].toArray();
        QCOMPARE(listed[0].toObject()["panels"].toArray().size(), 4);
        QVERIFY(listed[0].toObject()["area_m2"].toDouble() > 0.5);
        write("zone.csv", "time_s,zone,g_m2_h\n0,chst,100\n");
        write_project("gone.hygro", {{"source", "gone.json"}});
        write_project("no-rates.hygro", {}, {{"activity", "none.csv"}});
        write_project("zone.hygro", {}, {{"activity", "zone.csv"}});
        for (const auto& [project, words] : {std::pair{"gone.hygro", "garments[0].source: error: "},
                                             {"no-rates.hygro", "experiments[0].activity: error: "},
                                             {"zone.hygro", "did you mean \"chest\"?"}}) {
            const Answer said = run_cli({"check", at(project)});
            QCOMPARE(said.code, 3);
            QVERIFY2(said.err.contains(words), said.err);
        }
    }

    void a_garments_experiment_is_named_as_such()
    {
        QJsonObject project = read(at("tee.hygro"));
        const QJsonObject drop{{"name", "drop"},
                               {"type", "droplet"},
                               {"sample_mm", QJsonArray{20, 20}},
                               {"duration_s", 10},
                               {"droplets", QJsonArray{QJsonObject{{"volume_ul", 5}}}}};
        QJsonObject second = drop;
        second["name"] = "drop 2";
        project["experiments"] = QJsonArray{drop, second, project["experiments"].toArray()[0]};
        write("mixed.hygro", QJsonDocument(project).toJson());
        const QString mixed = at("mixed.hygro");
        QCOMPARE(run_cli({"garment", "plan", mixed, "--cell-mm", "30"}).code, 0);
        const auto says = [&](const QStringList& arguments, const char* words) {
            const Answer answer = run_cli(arguments);
            return answer.code == 2 && answer.err.contains(words);
        };
        QVERIFY(says({"garment", "plan", mixed, "--experiment", "waer"}, "type wear; did you mean \"wear\"? It has \"wear\"."));
        QVERIFY(says({"garment", "plan", mixed, "--experiment", "drop"}, "is one on a sample of fabric"));
        QVERIFY(says({"plan", mixed, "--experiment", "wear"}, "hygroloom-cli garment plan says what it takes"));
        QVERIFY(says({"compare", mixed, "--experiment", "wear"}, "A comparison needs two or more fabrics that the garment is cut from"));
        QVERIFY(says({"simulate", mixed}, "\"drop\", \"drop 2\" on a sample of fabric, or \"wear\" on a garment"));
        QVERIFY(says({"plan", at("tee.hygro")}, "The project's only experiments are on a garment"));
        const char* const all = "did you mean \"wear\"? It has \"drop\", \"drop 2\" on a sample of fabric and \"wear\" on a garment.";
        QVERIFY(says({"simulate", mixed, "--experiment", "waer"}, all));
        QVERIFY(says({"simulate", mixed, "--experiment", "waer", "--cell-mm", "30"}, all));
        QVERIFY(says({"simulate", mixed, "--experiment", "drop", "--cell-mm", "30"}, "\"drop\" is one on a sample of fabric."));
        QVERIFY(says({"simulate", at("tee.hygro"), "--experiment", "waer"}, "did you mean \"wear\"? It has \"wear\"."));
        QVERIFY(says({"simulate", at("tee.hygro"), "--fabric", "Denim"}, "A worn garment does not take --fabric"));
        QVERIFY(says({"simulate", at("tee.hygro"), "--seed", "7"}, "A worn garment does not take --seed"));
    }

    void panels_are_cut_from_a_fabric_of_the_library()
    {
        QCOMPARE(run_cli({"garment", "import", "built-in:tee", "--fabric", "Denim", "-o", at("tee-of-two.hygro")}).code, 0);
        QCOMPARE(run_cli({"garment", "import", "built-in:tee", "--fabric", "Textile F", "-o", at("tee-of-two.hygro")}).code, 0);
        const QJsonObject project = read(at("tee-of-two.hygro"));
        QCOMPARE(project["fabrics"].toArray().size(), 2);
        const auto fabric_of = [&](int garment) {
            return project["garments"].toArray()[garment].toObject()["panels"].toObject()["*"].toObject()["fabric"].toString();
        };
        QCOMPARE(fabric_of(0), QString("Denim"));
        QCOMPARE(fabric_of(1), QString("Textile F"));
        const Answer wrong = run_cli({"garment", "import", "built-in:tee", "--fabric", "Denin", "-o", at("tee-of-two.hygro")});
        QCOMPARE(wrong.code, 2);
        QVERIFY2(wrong.err.contains("did you mean \"Denim\"?"), wrong.err);
        QCOMPARE(run_cli({"garment", "import", "built-in:tee", "--fabric", "Denim"}).code, 2); // nothing is written
        QCOMPARE(run_cli({"garment", "plan", at("tee-of-two.hygro"), "--experiment", "wear", "--fabric", "Denim"}).code, 2);
        QCOMPARE(run_cli({"garment", "import", "built-in:tee", "--set", "experiments[0].duration_s=60"}).code, 2);
    }

    void a_plan_takes_changed_values()
    {
        const auto seconds = [&](const QString& set) {
            return run_cli({"garment", "plan", at("tee.hygro"), "--fidelity", "live", "--set", set, "--json"}).json()["seconds"].toDouble();
        };
        QVERIFY(seconds("experiments[0].duration_s=3600") > 1.5 * seconds("experiments[0].duration_s=60"));
        QCOMPARE(run_cli({"garment", "plan", at("tee.hygro"), "--set", "experiments[0].duraton_s=60"}).code, 2);
    }

    /// The same comparison as of samples: cut from each fabric, or as several projects have them.
    void garments_are_compared()
    {
        write_project("worn.hygro", {}, {{"duration_s", 60}});
        QCOMPARE(run_cli({"presets", "Denim", "-o", at("worn.hygro")}).code, 0);
        const QStringList coarse{"--experiment", "wear", "--fidelity", "live", "--cell-mm", "60", "--quiet"};
        const Answer two =
            run_cli(QStringList{"compare", at("worn.hygro"), "--replicates", "2", "-o", at("both"), "--report", at("both.html")} + coarse);
        QVERIFY2(two.code == 0 && two.out.contains("ranked by largest wet area (smallest first)"), two.out + two.err);
        QVERIFY2(two.out.contains("    against Poplin shirting"), two.out);
        const QJsonObject found = read(at("both/comparison.json"));
        QCOMPARE(found["candidates"].toArray().size(), 2);
        QCOMPARE(found["verdicts"].toArray()[0].toObject()["pairs"].toInt(), 2);
        QVERIFY(QFile::exists(at("both/Denim/front.png")) && QFile::exists(at("both/Poplin-shirting/cells.csv")));
        QFile page(at("both.html"));
        QVERIFY(page.open(QIODevice::ReadOnly));
        const QString html = page.readAll();
        for (const char* words :
             {"Which of 2 garments", "Denim: front, at 60 s", "contact angle on cotton", "<th>duration</th><td>60 s</td>"})
            QVERIFY2(html.contains(words), words);
        write_project("twin.hygro", {}, {{"duration_s", 60}});
        const QJsonArray projects =
            run_cli(QStringList{"compare", at("worn.hygro"), at("twin.hygro"), "--by", "most_water_g", "--json"} + coarse)
                .json()["candidates"]
                .toArray();
        QCOMPARE(projects.size(), 2);
        QStringList names{projects.at(0).toObject()["fabric"].toString(), projects.at(1).toObject()["fabric"].toString()};
        names.sort();
        QCOMPARE(names, (QStringList{"twin", "worn"}));
        write_project("damp.hygro", {}, {{"duration_s", 60}, {"initial_water_g_m2", 50}});
        const Answer other = run_cli(QStringList{"compare", at("worn.hygro"), at("damp.hygro")} + coarse);
        QVERIFY2(other.code == 2 && other.err.contains("they differ in initial_water_g_m2"), other.err);
        QCOMPARE(run_cli(QStringList{"compare", at("worn.hygro"), "--why", "Denim"} + coarse).code, 2);
        QCOMPARE(run_cli(QStringList{"compare", at("worn.hygro"), at("damp.hygro"), "--fabrics", "Denim"} + coarse).code, 2);
        QCOMPARE(run_cli(QStringList{"compare", at("tee.hygro")} + coarse).code, 2); // it has one fabric
    }

    void a_garment_has_replicates()
    {
        write_project("short.hygro", {}, {{"duration_s", 60}});
        const QStringList coarse{"simulate", at("short.hygro"), "--fidelity", "live", "--cell-mm", "60", "--json", "--quiet"};
        const QJsonObject one = run_cli(coarse + QStringList{"-o", at("one.hygrorec")}).json();
        const QJsonObject some = run_cli(coarse + QStringList{"--replicates", "3", "-o", at("some.hygrorec")}).json();
        QCOMPARE(some["metrics"].toObject(), one["metrics"].toObject());
        QCOMPARE(some["series"].toObject(), one["series"].toObject());
        QCOMPARE(some["intervals"].toObject()["most_water_g"].toObject()["runs"].toInt(), 3);
        QVERIFY(!one.contains("intervals"));
        const auto measured = [this](const char* file) { return run_cli({"measure", at(file), "--json", "--quiet"}).out; };
        QCOMPARE(measured("some.hygrorec"), measured("one.hygrorec"));
    }

    /// Estimates follow what garments took here.
    void a_plan_learns_from_runs()
    {
        write_project("timed.hygro", {}, {{"duration_s", 60}});
        const QStringList coarse{at("timed.hygro"), "--fidelity", "live", "--cell-mm", "50"};
        QCOMPARE(run_cli(QStringList{"simulate"} + coarse, 120, at("cache")).code, 0);
        const Answer plan = run_cli(QStringList{"garment", "plan"} + coarse, 120, at("cache"));
        QVERIFY2(plan.out.contains("on this machine took ") && plan.out.contains(" here about "), plan.out);
    }

    void a_study_runs_a_garment()
    {
        write_project("sized.hygro", {}, {{"duration_s", 5}});
        write("sizes.json", R"({ "format": "hygroloom-study", "version": 1, "fidelity": "live", "design": { "type": "grid" },
            "factors": [ { "path": "garments.tee.source.chest_mm", "values": [900, 1100] } ], "metrics": ["area_m2", "zones/chest/water_g"] })");
        const Answer swept = run_cli({"sweep", at("sized.hygro"), "--study", at("sizes.json"), "-o", at("sizes"), "--json", "--quiet"});
        QVERIFY2(swept.code == 0 && swept.json()["done"].toInt() == 2, swept.err);
        QFile table(at("sizes/results.csv"));
        QVERIFY(table.open(QIODevice::ReadOnly));
        const QList<QByteArray> lines = table.readAll().split('\n');
        QVERIFY2(lines[0].contains(",area_m2,zones/chest/water_g,"), lines[0]);
        QCOMPARE(run_cli({"sweep", "-o", at("sizes"), "--resume", "--quiet"}).code, 0); // from any folder
    }

    /// A washed garment at rest dries from the start, and not all that is asked for fits in.
    void a_washed_garment_dries()
    {
        const QJsonArray rests{QJsonObject{{"time_s", 0}, {"factor", 0}}};
        write_project("washed.hygro", {}, {{"activity", rests}, {"initial_water_g_m2", 2000}, {"duration_s", 14400}});
        const QStringList simulate{"simulate", at("washed.hygro"), "--fidelity", "live", "--cell-mm", "50"};
        const Answer run = run_cli(simulate + QStringList{"-o", at("washed.hygrorec")});
        QVERIFY2(run.out.contains("Of the 2000 g/m2 of water asked for at the start the yarns hold "), run.out);
        QVERIFY2(run.out.contains("water at the start"), run.out);
        const QJsonObject found = run_cli({"measure", at("washed.hygrorec"), "--json"}).json();
        const double dry = found["metrics"].toObject()["time_to_dry_s"].toDouble();
        const QJsonArray times = found["series"].toObject()["time_s"].toArray(), water = found["series"].toObject()["water_g"].toArray();
        qsizetype after = 0;
        while (after < times.size() && times[after].toDouble() < dry) ++after;
        QVERIFY(after > 0 && after < times.size() && dry > times[after - 1].toDouble());
        const double little = 0.05 * water[0].toDouble();
        QVERIFY2(water[after - 1].toDouble() > little && water[after].toDouble() <= little, qPrintable(QString::number(dry)));
        write_project("damp.hygro", {}, {{"initial_water_g_m2", 5}, {"duration_s", 600}}); // a little, then sweat: it only gets wetter
        const QJsonObject damp = run_cli({"simulate", at("damp.hygro"), "--fidelity", "live", "--cell-mm", "50", "--json"}).json();
        QVERIFY(damp["metrics"].toObject()["water_g"].toDouble() > 10);
        QVERIFY(damp["metrics"].toObject()["time_to_dry_s"].isNull());
    }

    void a_stopped_run_says_what_it_came_to()
    {
        write_project("long.hygro", {}, {{"duration_s", 86400}});
        QProcess process;
        process.start(HYGROLOOM_CLI, {"simulate", at("long.hygro"), "--fidelity", "live", "-o", at("long.hygrorec"), "--json", "-q"});
        QVERIFY(process.waitForStarted());
        QTRY_VERIFY_WITH_TIMEOUT(run_cli({"measure", at("long.hygrorec"), "--json"}).json()["time_s"].toDouble() > 0, 60000);
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(10000));
        QCOMPARE(process.exitCode(), 130);
        const QJsonObject said = QJsonDocument::fromJson(process.readAllStandardOutput()).object();
        QCOMPARE(said["exit_code"].toInt(), 130);
        QVERIFY(said["so_far"].toObject()["time_s"].toDouble() > 0);
        QVERIFY(said["so_far"].toObject()["panels"].toObject().contains("front"));
    }

    void an_estimate_counts_frames_time_and_water()
    {
        const auto seconds = [&](const QJsonObject& wear, const QString& fidelity) {
            write_project("planned.hygro", {}, wear);
            return run_cli({"garment", "plan", at("planned.hygro"), "--fidelity", fidelity, "--json"}).json()["seconds"].toDouble();
        };
        const QJsonObject minute{{"duration_s", 60}}, hour{{"duration_s", 3600}};
        const double soon = seconds(minute, "live"), late = seconds(hour, "live");
        QVERIFY2(soon > 0.5 && late > 1.5 * soon && late < 20 * soon, qPrintable(QString("%1 s, %2 s").arg(soon).arg(late)));
        QVERIFY(seconds({{"duration_s", 60}, {"initial_water_g_m2", 100}}, "live") > 1.3 * soon); // wet from the start
        const double cells = 16;                                                                  // of standard to one of live
        QVERIFY(seconds(hour, "standard") > 2 * cells * late);
        const QJsonArray rests{QJsonObject{{"time_s", 0}, {"factor", 0}}};
        QVERIFY(seconds({{"duration_s", 3600}, {"activity", rests}}, "live") < 0.8 * late);
    }

    void ranges_are_said_plainly()
    {
        for (const QStringList& wrong : {QStringList{"--most", "-5"}, {"--time", "-4"}, {"--times", "abc"}}) {
            const Answer answer = run_cli(QStringList{"garment", "map", "none.hygrorec", "-o", at("map")} + wrong);
            QCOMPARE(answer.code, 2);
            QVERIFY2(answer.err.size() < 200 && answer.err.contains("given is \"" + wrong[1].toUtf8() + "\""), answer.err);
        }
    }

    void a_map_beyond_the_run_is_refused()
    {
        write_project("short.hygro", {}, {{"duration_s", 2}});
        const Answer run =
            run_cli({"simulate", at("short.hygro"), "--fidelity", "draft", "--cell-mm", "40", "--profile", "-o", at("short.hygrorec")});
        QCOMPARE(run.code, 0);
        QVERIFY2(run.out.contains("exchange  ") && run.out.contains("outside the stages"), run.out);
        const Answer beyond = run_cli({"garment", "map", at("short.hygrorec"), "--time", "5", "-o", at("map")});
        QCOMPARE(beyond.code, 2);
        QVERIFY2(beyond.err.contains("--time 5: The run ends at 2 s; take a time from 0 to 2."), beyond.err);
        const Answer late = run_cli({"garment", "map", at("short.hygrorec"), "--report", at("late.html"), "--times", "1,5"});
        QCOMPARE(late.code, 2);
        QVERIFY2(late.err.contains("--times 5: The run ends at 2 s"), late.err);
        QCOMPARE(run_cli({"garment", "map", at("short.hygrorec"), "--time", "2", "-o", at("map")}).code, 0);
        const QStringList shares{"garment", "map", at("short.hygrorec"), "-o", at("map"), "--scale", "capacity"};
        const Answer percents = run_cli(shares + QStringList{"--most", "50"});
        QCOMPARE(percents.code, 2);
        QVERIFY2(percents.err.contains("--most 50: ") && percents.err.contains("50 % is 0.5."), percents.err);
        QCOMPARE(run_cli(shares + QStringList{"--steps", "1,2,3,4,5,6,7,80"}).code, 2);
        QCOMPARE(run_cli(shares + QStringList{"--most", "0.5"}).code, 0);
    }

    void a_map_names_the_cells_of_all_fabrics()
    {
        QCOMPARE(run_cli({"garment", "import", "built-in:tee", "--fabric", "Denim", "-o", at("two-cloths.hygro")}).code, 0);
        QCOMPARE(run_cli({"presets", "Textile F", "-o", at("two-cloths.hygro")}).code, 0);
        QJsonObject project = read(at("two-cloths.hygro")), tee = project["garments"].toArray()[0].toObject();
        tee["panels"] = QJsonObject{{"*", tee["panels"].toObject()["*"]}, {"front", QJsonObject{{"fabric", "Textile F"}}}};
        project["garments"] = QJsonArray{tee};
        write("two-cloths.hygro", QJsonDocument(project).toJson());
        QCOMPARE(run_cli({"simulate", at("two-cloths.hygro"), "--set", "experiments[0].duration_s=2", "--fidelity", "live", "--cell-mm",
                          "40", "-o", at("two-cloths.hygrorec")})
                     .code,
                 0);
        const QStringList map{"garment", "map", at("two-cloths.hygrorec"), "-o", at("map"), "--json"};
        const QJsonArray panels =
            run_cli({"garment", "plan", at("two-cloths.hygro"), "--cell-mm", "40", "--json"}).json()["panels"].toArray();
        const int of_front = panels[0].toObject()["crossings_per_cell"].toInt(),
                  of_back = panels[1].toObject()["crossings_per_cell"].toInt();
        QVERIFY(of_front > of_back);
        QCOMPARE(run_cli(map).json()["cells"].toString(), QString("by %1 x %1 or %2 x %2 crossings").arg(of_back).arg(of_front));
    }

    void a_file_that_is_no_pattern_is_named()
    {
        write("a.json", "{\"a\": 1}");
        const Answer refused = run_cli({"garment", "import", at("a.json")});
        QCOMPARE(refused.code, 3);
        QVERIFY2(refused.err.contains("a.json: This is no sewing pattern: it has no \"pattern\"; its keys are \"a\"."), refused.err);
    }
};

QTEST_GUILESS_MAIN(TestCommandLineGarment)
#include "tst_command_line_garment.moc"
