// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The folder of a project's runs: names that nobody else takes, copies, marks, and nothing deleted by the way.
#include "core/base/error.h"
#include "ui/document/run_folder.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <sys/stat.h>

using namespace hygroloom;

class TestRunFolder : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        root_ = std::make_unique<QTemporaryDir>();
        folder_ = runFolderOf(root_->filePath("cloth.hygro"));
    }

    void theFolderIsNamedAfterTheProject() { QCOMPARE(folder_, root_->filePath("cloth.hygro-runs")); }

    void aNameIsGivenOnce()
    {
        const QString first = reserveRun(folder_), second = reserveRun(folder_);
        QCOMPARE(QFileInfo(first).fileName(), QString("run-1.hygrorec"));
        QCOMPARE(QFileInfo(second).fileName(), QString("run-2.hygrorec"));
        write(QDir(folder_).filePath(".run-7.hygrorec.part"), "another window's, just beginning");
        QCOMPARE(runNumber(reserveRun(folder_)), 8);
        QVERIFY(recordingsIn(folder_).isEmpty()); // nothing is recorded yet
        QVERIFY(holdsRuns(folder_));
    }

    void aNameThatNoRunTookLeavesNothing()
    {
        const QString run = reserveRun(folder_);
        releaseRun(run);
        QVERIFY(!QFileInfo::exists(folder_));
        write(reserveRun(folder_), "recorded");
        releaseRun(QDir(folder_).filePath("run-1.hygrorec"));
        QCOMPARE(recordingsIn(folder_).size(), 1);
    }

    void recordingsComeByNumber()
    {
        QDir().mkpath(folder_);
        for (const char* name : {"run-10.hygrorec", "run-9.hygrorec", "other.hygrorec"}) {
            write(QDir(folder_).filePath(name), "recorded");
        }
        const QStringList found = recordingsIn(folder_);
        QCOMPARE(found.size(), 3);
        QCOMPARE(runNumber(found[1]), 9);
        QCOMPARE(runNumber(found[2]), 10);
    }

    void aCopySharesItsBytesAndReplacesNothing()
    {
        const QString run = recorded(folder_);
        setMarked(run, true);
        const QString other = runFolderOf(root_->filePath("other.hygro"));
        const QString there = recorded(other, "was there");
        const QString to = bringRun(run, other, Bring::copy);
        QCOMPARE(runNumber(to), 2);
        QVERIFY(isMarked(to) && !isMarked(there));
        QCOMPARE(read(there), QByteArray("was there"));
        QCOMPARE(read(run), QByteArray("recorded"));
        struct stat a {
        }, b{};
        QVERIFY(stat(qPrintable(run), &a) == 0 && stat(qPrintable(to), &b) == 0);
        QCOMPARE(a.st_ino, b.st_ino);
    }

    void movingTheLastRunTakesTheFolderAway()
    {
        const QString run = recorded(folder_);
        setMarked(run, true);
        const QString other = runFolderOf(root_->filePath("other.hygro"));
        const QString to = bringRun(run, other, Bring::move);
        QCOMPARE(read(to), QByteArray("recorded"));
        QVERIFY(isMarked(to));
        QVERIFY(!QFileInfo::exists(folder_));
    }

    void whatCannotBeBroughtStays()
    {
        const QString run = recorded(folder_);
        write(root_->filePath("other.hygro-runs"), "a file in the way");
        QVERIFY_EXCEPTION_THROWN(bringRun(run, root_->filePath("other.hygro-runs"), Bring::move), Error);
        QCOMPARE(read(run), QByteArray("recorded"));
    }

    void deletingLeavesTheOthersAndTheirMarks()
    {
        const QString first = recorded(folder_), second = recorded(folder_);
        setMarked(first, true);
        setMarked(second, true);
        deleteRun(first);
        QVERIFY(!QFileInfo::exists(first));
        QVERIFY(isMarked(second));
        setMarked(second, false);
        QVERIFY(!isMarked(second));
        deleteRun(second);
        QVERIFY(!QFileInfo::exists(folder_));
    }

private:
    static void write(const QString& path, const QByteArray& bytes)
    {
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(bytes);
    }
    static QByteArray read(const QString& path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    static QString recorded(const QString& folder, const QByteArray& bytes = "recorded")
    {
        const QString run = reserveRun(folder);
        write(run, bytes);
        return run;
    }

    std::unique_ptr<QTemporaryDir> root_;
    QString folder_;
};

QTEST_MAIN(TestRunFolder)
#include "tst_run_folder.moc"
