// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a window that is gone had not saved: what is asked about, and which of it may be saved over its file.
#include "core/project/project_file.h"
#include "ui/document/recovery.h"
#include "ui/document/run_folder.h"

#include <QDir>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace hygroloom;

class TestRecovery : public QObject {
    Q_OBJECT
    const QString project_ = HYGROLOOM_SOURCE_DIR "/resources/examples/one-drop-on-cotton.hygro";

private Q_SLOTS:
    void aCrashBeforeTheFirstFrameLeavesNothingToAskAbout()
    {
        QTemporaryDir folder;
        for (const bool modified : {false, true}) {
            const QString crashed = folder.filePath("crashed.hygro");
            {
                Document document;
                Recovery recovery(document, folder.path());
                QSignalSpy kept(&recovery, &Recovery::kept);
                QVERIFY(document.openExample(project_));
                if (modified) {
                    document.edit("ends", {}, [](Design& d) { d.fabrics[0].ends_per_cm = 27; });
                }
                const QString run = reserveRun(recovery.runFolder());
                recovery.follow();
                QVERIFY(kept.wait(5000));
                const QString own = QDir(folder.path()).entryInfoList({"*.hygro"}, QDir::Files).first().absoluteFilePath();
                QVERIFY(QFile::copy(own, crashed) && QFile::copy(own + ".origin", crashed + ".origin"));
                releaseRun(run);
            }
            const QString begun = reserveRun(runFolderOf(crashed));
            QFile part(runFolderOf(crashed) + "/." + QFileInfo(begun).fileName() + ".part");
            QVERIFY(part.open(QIODevice::WriteOnly) && part.write("half a frame") > 0);
            part.close();
            Document document;
            Recovery recovery(document, folder.path());
            QCOMPARE(recovery.leftOver().size(), std::size_t{modified ? 1U : 0U});
            QVERIFY(!QFile::exists(runFolderOf(crashed)));
            QCOMPARE(QFile::exists(crashed), modified);
        }
    }

    void keptWorkThatIsOlderThanItsFileOpensAsUntitled()
    {
        QTemporaryDir folder;
        const QString crashed = folder.filePath("crashed.hygro");
        QVERIFY(QFile::copy(project_, crashed));
        QFile kept(crashed);
        QVERIFY(kept.open(QIODevice::ReadWrite) &&
                kept.setFileTime(QDateTime(QDate(2020, 1, 1), QTime(12, 0)), QFileDevice::FileModificationTime));
        kept.close();
        QFile origin(crashed + ".origin");
        QVERIFY(origin.open(QIODevice::WriteOnly));
        origin.write((project_ + "\ndrop.hygro\n").toUtf8());
        origin.close();
        Document document;
        Recovery recovery(document, folder.path());
        const std::vector<LeftOver> left = recovery.leftOver();
        QCOMPARE(left.size(), std::size_t{1});
        QVERIFY(left.front().outdated);
        QVERIFY(recovery.open(left.front()));
        QVERIFY(document.path().isEmpty() && document.modified());
    }

    /// The file's times say nothing when another program changed it before the last edit.
    void keptWorkOfAnotherVersionOfItsFileOpensAsUntitled()
    {
        for (const bool changed : {false, true}) {
            QTemporaryDir folder;
            const QString file = folder.filePath("project.hygro"), crashed = folder.filePath("kept/crashed.hygro");
            QVERIFY(QDir(folder.path()).mkdir("kept") && QDir(folder.path()).mkdir("own") && QFile::copy(project_, file));
            {
                Document document;
                Recovery recovery(document, folder.filePath("own"));
                QSignalSpy kept(&recovery, &Recovery::kept);
                QVERIFY(document.open(file));
                if (changed) {
                    Design other = read_project(file.toStdString());
                    other.fabrics[0].picks_per_cm = 22;
                    write_project(other, file.toStdString());
                }
                document.edit("ends", {}, [](Design& d) { d.fabrics[0].ends_per_cm = 27; });
                QVERIFY(kept.wait(10000));
                const QString own = QDir(folder.filePath("own")).entryInfoList({"*.hygro"}, QDir::Files).first().absoluteFilePath();
                QVERIFY(QFile::copy(own, crashed) && QFile::copy(own + ".origin", crashed + ".origin"));
            }
            Document document;
            const Recovery recovery(document, folder.filePath("kept"));
            const std::vector<LeftOver> left = recovery.leftOver();
            QCOMPARE(left.size(), std::size_t{1});
            QCOMPARE(left.front().outdated, changed);
        }
    }
};

QTEST_MAIN(TestRecovery)
#include "tst_recovery.moc"
