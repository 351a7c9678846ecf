// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Estimates of time learn from the runs of this machine. No clock is asked: the runs are made up.
#include "core/run/learned_times.h"
#include "core/run/plan_run.h"
#include "tests/support/drop_design.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <thread>

using namespace hygroloom;

namespace {

ModelPlan plan_of(double volume_ul, Fidelity fidelity = Fidelity::draft, ExperimentType type = ExperimentType::droplet)
{
    Design design = drop_design();
    if (type != ExperimentType::droplet)
        design.experiments[0] = standard_experiment(type);
    else
        design.experiments[0].droplets[0].volume_ul = volume_ul;
    return plan_run(design, design.fabrics[0], design.experiments[0], fidelity);
}

/// A run that takes that many times its own estimate. Precondition: the plan has not been corrected.
RunRecord run_of(const ModelPlan& plan, double times)
{
    RunRecord run;
    run.plan = plan;
    run.backend = "cpu";
    run.wall = times * plan.expected_seconds;
    return run;
}

} // namespace

class TestLearnedTimes : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;
    QString file_;

private Q_SLOTS:
    void init()
    {
        file_ = folder_.filePath(QString(QTest::currentTestFunction()) + "/times.json");
        keep_learned_times({});
    }
    void cleanup() { keep_learned_times({}); }
    void nothingIsKeptWithoutAFile()
    {
        const ModelPlan plan = plan_of(15);
        learn_time(run_of(plan, 3));
        QCOMPARE(plan_of(15).expected_seconds, plan.expected_seconds);
    }
    void theSameSceneIsExpectedAsItWent()
    {
        const ModelPlan before = plan_of(15);
        keep_learned_times(file_.toStdString());
        learn_time(run_of(before, 3));
        const ModelPlan after = plan_of(15);
        QVERIFY(std::abs(after.expected_seconds / before.expected_seconds - 3) < 1e-9);
        QVERIFY(after.expectation_source.find("One run of this kind on this machine took 3.0 times its") != std::string::npos);
        keep_learned_times({}); // as the next session
        keep_learned_times(file_.toStdString());
        QCOMPARE(plan_of(15).expected_seconds, after.expected_seconds);
    }
    /// The next run may record nothing.
    void whatARecordingTookIsNotLearned()
    {
        const ModelPlan before = plan_of(15);
        keep_learned_times(file_.toStdString());
        RunRecord run = run_of(before, 3);
        run.recorded_in = before.expected_seconds;
        learn_time(run);
        QVERIFY(std::abs(plan_of(15).expected_seconds / before.expected_seconds - 2) < 1e-9);
    }
    void theMostAlikeCountMost()
    {
        const ModelPlan small = plan_of(5), large = plan_of(20), drying = plan_of(0, Fidelity::draft, ExperimentType::drying);
        keep_learned_times(file_.toStdString());
        learn_time(run_of(small, 4));
        learn_time(run_of(large, 1));
        const double as_small = plan_of(6).expected_seconds, as_large = plan_of(18).expected_seconds;
        const double other = plan_of(0, Fidelity::draft, ExperimentType::drying).expected_seconds;
        keep_learned_times({});
        QVERIFY(as_small > 2 * plan_of(6).expected_seconds && as_small < 4 * plan_of(6).expected_seconds);
        QVERIFY(as_large < 2 * plan_of(18).expected_seconds && as_large > plan_of(18).expected_seconds);
        QCOMPARE(other, drying.expected_seconds); // another kind
    }
    void runsAtOtherFidelitiesAreCountedAsSuch()
    {
        const ModelPlan draft = plan_of(15), standard = plan_of(15, Fidelity::standard);
        keep_learned_times(file_.toStdString());
        const auto said = [](Fidelity fidelity, const char* words) {
            return plan_of(15, fidelity).expectation_source.find(words) != std::string::npos;
        };
        learn_time(run_of(standard, 3));
        QVERIFY(said(Fidelity::draft, " One run of this kind at another fidelity on this machine took"));
        learn_time(run_of(draft, 3));
        learn_time(run_of(draft, 3));
        QVERIFY(said(Fidelity::draft, " 2 runs of this kind and 1 at another fidelity on this machine took"));
        QVERIFY(said(Fidelity::standard, " One run of this kind and 2 at other fidelities on this machine took"));
    }
    void runsThatDidNotHaveTheMachineAreNotTaken()
    {
        const ModelPlan before = plan_of(15);
        keep_learned_times(file_.toStdString());
        RunRecord one_thread = run_of(before, 3), stopped = run_of(before, 3), beside = run_of(before, 3);
        beside.alone = false;
        learn_time(beside);
        one_thread.threads = 1;
        stopped.wall = 0;
        learn_time(one_thread);
        learn_time(stopped);
        QVERIFY(!QFile::exists(file_));
    }
    void garmentsLearnFromGarments()
    {
        const ModelPlan drop = plan_of(15);
        const auto expected = [](double seconds, Fidelity fidelity, const char* backend) {
            GarmentTime time{fidelity, seconds, {}};
            expect_as_learned(time, backend);
            return time;
        };
        QCOMPARE(expected(10, Fidelity::draft, "cpu").seconds, 10.0);
        keep_learned_times(file_.toStdString());
        QVERIFY(expected(10, Fidelity::draft, "cpu").learned.empty());
        learn_time({Fidelity::draft, 10, {}}, 30, "cpu", "a device");
        learn_time({Fidelity::draft, 0, {}}, 30, "cpu", "a device"); // nothing was estimated
        const GarmentTime alike = expected(10, Fidelity::draft, "cpu");
        QVERIFY(std::abs(alike.seconds - 30) < 1e-9);
        QVERIFY(alike.learned.starts_with("One run of this kind on this machine took 3.0 times its estimate"));
        learn_time({Fidelity::draft, 1000, {}}, 1000, "cpu", "a device");
        const double large = expected(900, Fidelity::draft, "cpu").seconds;
        QVERIFY(large > 900 && large < 1000); // the larger is nearer
        QVERIFY(expected(10, Fidelity::standard, "cpu").learned.starts_with("2 runs of this kind at other fidelities"));
        QCOMPARE(expected(10, Fidelity::draft, "cuda").seconds, 10.0);
        QCOMPARE(plan_of(15).expected_seconds, drop.expected_seconds); // a sample's
        keep_learned_times({});                                        // as the next session
        keep_learned_times(file_.toStdString());
        learn_time(run_of(drop, 2));
        QVERIFY(std::abs(expected(10, Fidelity::draft, "cpu").seconds / alike.seconds - 1) < 0.1);
    }
    void theOldestGoFirst()
    {
        const ModelPlan before = plan_of(15);
        keep_learned_times(file_.toStdString());
        learn_time(run_of(before, 50));
        for (int i = 0; i < 60; ++i) learn_time(run_of(before, 2));
        QVERIFY(std::abs(plan_of(15).expected_seconds / before.expected_seconds - 2) < 1e-9);
        QVERIFY(QFile(file_).size() < 400'000);
    }
    void twoThatLearnAtOnceBothAre()
    {
        const ModelPlan before = plan_of(15);
        keep_learned_times(file_.toStdString());
        std::vector<std::jthread> learners;
        for (int i = 0; i < 8; ++i) learners.emplace_back([&] { learn_time(run_of(before, 2)); });
        learners.clear();
        QVERIFY(plan_of(15).expectation_source.find("8 runs of this kind") != std::string::npos);
    }
    void aDamagedFileCountsAsEmpty_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("text") << QByteArray("times");
        QTest::newRow("other") << QByteArray(R"({"format": "hygroloom-times", "version": 4, "runs": [1]})");
        QTest::newRow("entries") << QByteArray(R"({"format": "hygroloom-times", "version": 3, "runs": [1, {}, {"machine": 3}]})");
        QTest::newRow("runs") << QByteArray(R"({"format": "hygroloom-times", "version": 3, "runs": 7})");
    }
    void aDamagedFileCountsAsEmpty()
    {
        QFETCH(QByteArray, content);
        const ModelPlan before = plan_of(15);
        QFile file(folder_.filePath("damaged.json"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(content) == content.size());
        file.close();
        keep_learned_times(folder_.filePath("damaged.json").toStdString());
        QCOMPARE(plan_of(15).expected_seconds, before.expected_seconds);
        learn_time(run_of(before, 3));
        QVERIFY(std::abs(plan_of(15).expected_seconds / before.expected_seconds - 3) < 1e-9);
    }
    void aFileOfTheFirstVersionIsLeftOut()
    {
        const ModelPlan before = plan_of(15);
        const std::string path = folder_.filePath("older.json").toStdString();
        keep_learned_times(path);
        learn_time(run_of(before, 3));
        QFile file(QString::fromStdString(path));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QByteArray content = file.readAll();
        file.close();
        QVERIFY(content.contains("\"version\":3"));
        keep_learned_times(path);
        QVERIFY(plan_of(15).expected_seconds != before.expected_seconds); // it is read
        content.replace("\"version\":3", "\"version\":1");
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(content) == content.size());
        file.close();
        keep_learned_times(path);
        QCOMPARE(plan_of(15).expected_seconds, before.expected_seconds);
    }
    void numbersThatGiveNoEstimateAreLeftOut()
    {
        const ModelPlan before = plan_of(15);
        keep_learned_times(file_.toStdString());
        learn_time(run_of(before, 3));
        keep_learned_times({});
        QFile file(file_);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QByteArray content = file.readAll();
        file.close();
        const qsizetype at = content.indexOf("\"segments\":");
        QVERIFY(at > 0);
        content.insert(at + 11, "-1");
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(content) == content.size());
        file.close();
        keep_learned_times(file_.toStdString());
        QVERIFY(std::isfinite(plan_of(15).expected_seconds) && plan_of(15).expected_seconds > 0);
    }
    void aFolderThatCannotBeMadeChangesNothing()
    {
        const ModelPlan before = plan_of(15);
        keep_learned_times("/dev/null/hygroloom/times.json");
        learn_time(run_of(before, 3));
        QCOMPARE(plan_of(15).expected_seconds, before.expected_seconds);
    }
};

QTEST_APPLESS_MAIN(TestLearnedTimes)
#include "tst_learned_times.moc"
