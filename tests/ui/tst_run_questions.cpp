// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a run asks: before it takes more memory than is free, and whether to keep what it recorded; and that it writes nothing into an
// installation. Needs a display: xvfb-run.
#include "project_runs_test.h"
#include "ui/garment/garment_edits.h"
#include "ui/results/device_choice.h"

#include <QRegularExpression>

#include <sys/resource.h>
#include <unistd.h>

using namespace hygroloom;

class TestRunQuestions : public ProjectRunsTest {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { useOwnSettings(); }
    void init() { openProject(); }
    void cleanup() { closeProject(); }

    void aStoppedRunIsKeptWhenThatIsAskedFor_data()
    {
        QTest::addColumn<QString>("answer");
        QTest::addColumn<bool>("kept");
        QTest::newRow("keep") << "Keep" << true;
        QTest::newRow("discard") << "Discard" << false;
    }
    void aStoppedRunIsKeptWhenThatIsAskedFor()
    {
        QFETCH(QString, answer);
        QFETCH(bool, kept);
        startLongRun();
        const QString recording = playback().path();
        QSignalSpy ended(&simulation(), &QueuedRun::ended);
        const auto asked = press(answer);
        for (QPushButton* each : simulationPanel().findChildren<QPushButton*>()) {
            if (each->text().remove('&') == "Stop") { each->click(); }
        }
        QTRY_VERIFY_WITH_TIMEOUT(ended.count() == 1 && !asked->isEmpty(), 20000);
        QVERIFY2(asked->contains("Keep what it recorded?"), qPrintable(*asked));
        QTRY_COMPARE_WITH_TIMEOUT(QFile::exists(recording), kept, 5000);
        QCOMPARE(bool(playback().run()), kept);
        QCOMPARE(runs().find(recording) != nullptr, kept);
        QCOMPARE(QDir(runFolderOf(project_)).exists(), kept);
    }

    void aRunCanBeStoppedWhileItIsSetUp()
    {
        shortenExperiment(3600, 10, 5);
        QTRY_VERIFY(simulationPanel().canRun());
        window_->run().start();
        QVERIFY(simulation().running()); // before any word of its thread
        int found = 0;
        for (const QPushButton* each : simulationPanel().findChildren<QPushButton*>()) {
            const QString text = each->text().remove('&');
            if (text != "Run" && text != "Pause" && text != "Stop") { continue; }
            ++found;
            QVERIFY2(each->isEnabled() == (text != "Run"), qPrintable(text));
        }
        QCOMPARE(found, 3);
        QSignalSpy ended(&simulation(), &QueuedRun::ended);
        simulation().cancel();
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, 20000);
    }

    void aSubjectWhoseGpuCannotBeOpenedMayRunOnTheCpu_data()
    {
        QTest::addColumn<bool>("worn");
        QTest::newRow("sample") << false;
        QTest::newRow("garment") << true;
    }
    void aSubjectWhoseGpuCannotBeOpenedMayRunOnTheCpu()
    {
        QFETCH(bool, worn);
        for (const DeviceLine& device : devicesOfThisMachine()) {
            if (device.is_gpu && device.problem.isEmpty()) { QSKIP("this machine has a GPU"); }
        }
        shortenExperiment(0.02, 4, 0.5);
        if (worn) {
            addBuiltInGarment(window_->document(), "singlet");
            editWear(window_->document(), "shorter", 0, {}, [](WearExperiment& wear) { wear.duration_s = 5; });
            window_->setWorkspace(Workspace::garment);
        }
        simulationPanel().setBackend("cuda");
        QTRY_VERIFY(simulationPanel().canRun());
        const auto asked = press("Run on the CPU");
        QSignalSpy ended(&simulation(), &QueuedRun::ended);
        window_->run().start();
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 2, 60000);
        QVERIFY2(asked->contains("Run on the CPU instead?"), qPrintable(*asked));
        QCOMPARE(simulationPanel().backend(), std::string("cpu"));
        QCOMPARE(ended[1][0].value<QueuedRun::Outcome>(), QueuedRun::Outcome::finished);
        QCOMPARE(runs().runs().size(), std::size_t{1});
        QCOMPARE(runs().runs()[0].worn, worn);
    }

    void anInstalledExampleIsOpenedWithoutItsFolder()
    {
        const QString folder = folder_.filePath(QString("i%1/share/hygroloom/examples").arg(tests_));
        QVERIFY(QDir().mkpath(folder));
        const QString file = folder + "/one-drop-on-cotton.hygro";
        QVERIFY(QFile::copy(example("one-drop-on-cotton"), file));
        QVERIFY(window_->openFile(file));
        QVERIFY(window_->document().path().isEmpty());
        run();
        QVERIFY(!playback().path().isEmpty() && QFile::exists(playback().path()));
        QCOMPARE(QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot), QStringList{"one-drop-on-cotton.hygro"});
    }

    void aRunThatNeedsMoreMemoryThanIsFreeIsAskedFor_data()
    {
        QTest::addColumn<QString>("answer");
        QTest::newRow("no") << "Cancel";
        QTest::newRow("all the same") << "Run All the Same";
    }
    void aRunThatNeedsMoreMemoryThanIsFreeIsAskedFor()
    {
        QFETCH(QString, answer);
        shortenExperiment(0.02, 400, 0.5); // more than 1 GB
        simulationPanel().setFidelity(Fidelity::live);
        QTRY_VERIFY(simulationPanel().canRun());
        rlimit before{};
        QCOMPARE(getrlimit(RLIMIT_AS, &before), 0);
        auto question = std::make_shared<QString>();
        meet<QMessageBox>([question, answer, before](QMessageBox* box) {
            setrlimit(RLIMIT_AS, &before);
            *question = box->text();
            for (QAbstractButton* button : box->buttons()) {
                if (button->text().remove('&') == answer) { button->click(); }
            }
        });
        QSignalSpy ended(&simulation(), &QueuedRun::ended);
        const rlimit little{takenAddresses() + 900'000'000, before.rlim_max};
        QCOMPARE(setrlimit(RLIMIT_AS, &little), 0);
        window_->run().start();
        const bool runs_all_the_same = answer != "Cancel";
        QTRY_VERIFY_WITH_TIMEOUT(!question->isEmpty() && ended.count() == (runs_all_the_same ? 2 : 1), 120000);
        setrlimit(RLIMIT_AS, &before);
        static const QRegularExpression numbers("This run takes about [0-9.]+.[MG]B of memory; [0-9.]+.MB are free\\.");
        QVERIFY2(numbers.match(*question).hasMatch(), qPrintable(*question));
        const auto outcome = ended.back().at(0).value<QueuedRun::Outcome>();
        QCOMPARE(outcome, runs_all_the_same ? QueuedRun::Outcome::finished : QueuedRun::Outcome::memory_short);
        QCOMPARE(QDir(runFolderOf(project_)).exists(), runs_all_the_same);
    }

private:
    /// Bytes of this process.
    static rlim_t takenAddresses()
    {
        QFile file("/proc/self/statm");
        return file.open(QIODevice::ReadOnly) ? file.readAll().split(' ').first().toULongLong() * rlim_t(sysconf(_SC_PAGESIZE)) : 0;
    }
    void startLongRun()
    {
        shortenExperiment(3600, 10, 5);
        simulationPanel().setFidelity(Fidelity::draft); // seconds long
        window_->run().start();
        QTRY_VERIFY_WITH_TIMEOUT(playback().live() && playback().frames() > 1, 30000);
        simulation().setPaused(true); // or it ends while the test goes on
        QVERIFY(simulation().running());
    }
};

QTEST_MAIN(TestRunQuestions)
#include "tst_run_questions.moc"
