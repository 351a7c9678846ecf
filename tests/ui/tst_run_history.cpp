// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The list of runs: their numbers when their recordings move.
#include "ui/results/run_history.h"

#include <QTest>

using namespace hygroloom;

class TestRunHistory : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aRunThatMovesHasTheNumberThatItGetsThere()
    {
        RunHistory history;
        for (const int number : {1, 2}) { history.keep(run(QString("/unsaved/run-%1.hygrorec").arg(number), number)); }
        history.move("/unsaved/run-1.hygrorec", "/filed/run-2.hygrorec", true);
        history.move("/unsaved/run-2.hygrorec", "/filed/run-3.hygrorec", true);
        QCOMPARE(history.find("/filed/run-2.hygrorec")->number, 2);
        QCOMPARE(history.find("/filed/run-3.hygrorec")->number, 3);
        history.keep(run("/filed/run-1.hygrorec", 1));
        QCOMPARE(history.runs().front().path, QString("/filed/run-1.hygrorec"));
    }

    void twoRunsNeverHaveOneNumber()
    {
        RunHistory history;
        history.keep(run("/unsaved/run-1.hygrorec", 1));
        KeptRun opened = run("/elsewhere/run-9.hygrorec", 0);
        opened.own = false;
        history.keep(opened);
        QCOMPARE(history.find(opened.path)->number, 2);
        history.move("/unsaved/run-1.hygrorec", "/filed/run-2.hygrorec", true);
        QCOMPARE(history.find("/filed/run-2.hygrorec")->number, 2);
        QCOMPARE(history.find(opened.path)->number, 1);
    }

    void aRunIsListedOnceWhenItWasFoundWhereItMovesTo()
    {
        RunHistory history;
        history.keep(run("/unsaved/run-1.hygrorec", 1));
        history.keep(run("/filed/run-1.hygrorec", 1));
        history.move("/unsaved/run-1.hygrorec", "/filed/run-1.hygrorec", true);
        QCOMPARE(history.runs().size(), std::size_t{1});
        QCOMPARE(history.runs().front().number, 1);
    }

    void aRunWithoutItsNumbersIsNotCompared()
    {
        const KeptRun bare = run("/run-1.hygrorec", 1);
        KeptRun whole = bare;
        whole.metrics = std::make_shared<const Metrics>();
        QVERIFY(whyNotCompared(whole, whole).isEmpty());
        QVERIFY(whyNotCompared(bare, whole).contains("being read"));
        whole.problem = "it is damaged.";
        QCOMPARE(whyNotCompared(whole, bare), whole.problem);
    }

private:
    static KeptRun run(const QString& path, int number)
    {
        KeptRun made;
        made.path = path;
        auto record = std::make_shared<RunRecord>();
        record->wall = 1;
        made.run = record;
        made.own = true;
        made.number = number;
        return made;
    }
};

QTEST_MAIN(TestRunHistory)
#include "tst_run_history.moc"
