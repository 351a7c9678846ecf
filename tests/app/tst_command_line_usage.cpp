// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Calls that are written wrongly, the help on verbs, and projects to begin with.
#include "command_line.h"

#include "core/design/validate.h"
#include "core/project/project_file.h"

#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

namespace tst_command_line_usage {

using namespace hygroloom;

class TestCommandLineUsage : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void wrongCallsAreToldWhatToWrite()
    {
        const QString project = example("one-drop-on-cotton.hygro");
        const struct {
            QStringList call;
            const char* says;
        } cases[] = {
            {{}, "needs a verb: check, plan, simulate"},
            {{"simulate"}, "hygroloom-cli simulate needs PROJECT: Project file (.hygro)."},
            {{"verify", "--fidelty", "draft"}, "hygroloom-cli verify has no option \"--fidelty\""},
            {{"simulate", project, "--fidelty", "draft"}, "has no option \"--fidelty\"; did you mean \"--fidelity\"?"},
            {{"simulate", project, "--fidelty=draft"}, "did you mean \"--fidelity\"?"},
            {{"simulate", project, "-z"}, "has no option \"-z\""},
            {{"simulate", project, "further"}, "takes no further word \"further\""},
            {{"simulate", project, "-o", ""}, "-o: This is an empty text."},
            {{"simulate", project, "--output="}, "--output: This is an empty text."},
            {{"simulate", ""}, "One of the words is an empty text."},
            {{"measure", "", "--json"}, "One of the words is an empty text."},
            {{"export", project, "-o", ""}, "-o: This is an empty text."},
            {{"compare", project, "--fabrics", ""}, "--fabrics: This is an empty text."},
            {{"help", "simulte"}, "There is no verb \"simulte\"; did you mean \"simulate\"?"},
        };
        for (const auto& one : cases) {
            const Answer answer = run_cli(one.call);
            QCOMPARE(answer.code, 2);
            QVERIFY2(answer.err.contains(one.says), answer.err + one.says);
        }
        QVERIFY(!run_cli({"nothing"}).err.contains("reference")); // which the help does not list
        QCOMPARE(run_cli({"help", "simulate"}).out, run_cli({"simulate", "--help"}).out);
        QCOMPARE(run_cli({"help"}).out, run_cli({"--help"}).out);
        QCOMPARE(run_cli({"help", "garment", "import"}).out, run_cli({"garment", "--help"}).out);
        QVERIFY(run_cli({"--version"}).out.contains(", commit "));
    }

    void presetsAddExperimentsOfEachType()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("cloth.hygro");
        QCOMPARE(run_cli({"presets", "Denim", "Textile F", "--experiment", "droplet", "-o", path}).code, 0);
        const Design first = read_project(path.toStdString());
        QCOMPARE(first.fabrics.size(), std::size_t(2));
        QCOMPARE(first.experiments.size(), std::size_t(1));
        QCOMPARE(first.experiments[0].name, std::string("one drop"));
        QStringList all{"presets", "-o", path, "--json"};
        for (int type = 0; type < experiment_types; ++type) all << "--experiment" << name_of(ExperimentType(type));
        const Answer added = run_cli(all);
        QCOMPARE(added.code, 0);
        QCOMPARE(added.json()["experiments"].toArray().size(), qsizetype(experiment_types));
        const Design whole = read_project(path.toStdString());
        QCOMPARE(whole.experiments[1].name, std::string("one drop 2"));
        for (int type = 0; type < experiment_types; ++type) {
            Experiment expected = standard_experiment(ExperimentType(type));
            expected.name = whole.experiments[std::size_t(type) + 1].name;
            QVERIFY(whole.experiments[std::size_t(type) + 1] == expected);
        }
        QVERIFY(!has_error(validate(whole)));
        QVERIFY(run_cli({"presets", "--experiment", "dropplet", "-o", path}).err.contains("did you mean \"droplet\"?"));
        QVERIFY(run_cli({"presets", "--experiment", "wear", "-o", path}).err.contains("garment import"));
        QCOMPARE(run_cli({"presets", "--experiment", "droplet"}).code, 2);
        QVERIFY(read_project(path.toStdString()) == whole);
    }
};

} // namespace tst_command_line_usage

QTEST_GUILESS_MAIN(tst_command_line_usage::TestCommandLineUsage)
#include "tst_command_line_usage.moc"
