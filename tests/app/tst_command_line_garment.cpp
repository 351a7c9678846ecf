// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Garments on the command line: what is said about their names, files and experiments.
#include "tests/app/command_line.h"

#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

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
        QVERIFY(says({"compare", mixed, "--experiment", "wear"}, "hygroloom-cli simulate runs it"));
        QVERIFY(says({"simulate", mixed}, "\"drop\", \"drop 2\" on a sample of fabric, or \"wear\" on a garment"));
        QVERIFY(says({"plan", at("tee.hygro")}, "The project's only experiments are on a garment"));
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
        QCOMPARE(run_cli({"garment", "map", at("short.hygrorec"), "--time", "2", "-o", at("map")}).code, 0);
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
