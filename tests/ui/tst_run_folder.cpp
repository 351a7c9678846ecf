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

    void aLinkThatAKilledWindowLeftIsInNobodysWay()
    {
        const QString run = recorded(folder_), other = runFolderOf(root_->filePath("other.hygro"));
        QVERIFY(QDir().mkpath(other));
        write(other + "/run-1.link", "left");
        QCOMPARE(read(linkRun(run, other, Bring::copy)), QByteArray("recorded"));
        QCOMPARE(QDir(other).entryList(QDir::Files | QDir::Hidden), QStringList("run-1.hygrorec"));
    }

    void anotherFileSystemGetsACopyThatCanBeStopped()
    {
        QTemporaryDir elsewhere("/dev/shm/runs-XXXXXX");
        const QString other = elsewhere.filePath("cloth.hygro-runs"), run = recorded(folder_, QByteArray(9 << 20, 'w'));
        struct stat a {
        }, b{};
        if (stat(qPrintable(run), &a) != 0 || stat(qPrintable(elsewhere.path()), &b) != 0 || a.st_dev == b.st_dev) {
            QSKIP("no second file system");
        }
        setMarked(run, true);
        QCOMPARE(linkRun(run, other, Bring::move), QString());
        QVERIFY(!QFileInfo::exists(other));
        const auto stopped = [](double share) { return share < 0.5; };
        QVERIFY_EXCEPTION_THROWN(bringRun(run, other, Bring::move, stopped), Error);
        QVERIFY(!QFileInfo::exists(other) && QFileInfo::exists(run));
        std::vector<double> shares;
        const QString to = bringRun(run, other, Bring::move, [&shares](double share) {
            shares.push_back(share);
            return true;
        });
        QCOMPARE(QFileInfo(to).size(), qint64{9 << 20});
        QVERIFY(isMarked(to) && !QFileInfo::exists(folder_));
        QVERIFY(shares.size() == 3 && shares.back() == 1);
    }

    void theFolderHasOneNameThroughLinks()
    {
        QVERIFY(QDir().mkpath(root_->filePath("real/deep")));
        QVERIFY(QFile::link(root_->filePath("real"), root_->filePath("link")));
        QCOMPARE(runFolderOf(root_->filePath("link/deep/cloth.hygro")), root_->filePath("real/deep/cloth.hygro-runs"));
        QCOMPARE(runFolderOf(root_->filePath("link/new/../cloth.hygro")), root_->filePath("real/cloth.hygro-runs"));
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

    void whatCannotBeDeletedKeepsItsMark()
    {
        const QString run = recorded(folder_);
        setMarked(run, true);
        QVERIFY(QFile::remove(run) && QDir().mkpath(run + "/in the way"));
        QVERIFY_EXCEPTION_THROWN(deleteRun(run), Error);
        QVERIFY(isMarked(run));
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
