// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Recordings while they are written: nothing is lost to a second run, a reader, a kill or a full disk.
#include "core/base/error.h"
#include "core/run/recording_target.h"
#include "core/run/wal_pages.h"
#include "tests/support/crafted_recording.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <QtEndian>

#include <sqlite3.h>

#include <csignal>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <map>
#include <random>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace hygroloom;

namespace tst_recording_writer {
namespace {

constexpr double mark_of_older = 77; ///< s, as the wall time

template <typename Act> QString complaint_of(Act act)
{
    try {
        act();
    } catch (const FileError& error) {
        return error.what();
    }
    return {};
}

QByteArray bytes_of(const std::string& path)
{
    QFile file(QString::fromStdString(path));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void set_bytes(const std::string& path, const QByteArray& bytes)
{
    QFile file(QString::fromStdString(path));
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(bytes), bytes.size());
}

/// Runs it in a process of its own; returns how that ended.
template <typename Act> pid_t begin_apart(Act act)
{
    const pid_t child = fork();
    if (child != 0) return child;
    act();
    _exit(0);
}

} // namespace

class TestRecordingWriter : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;
    RunRecord run_ = small_run();

    std::string at(const char* name) const { return folder_.filePath(name).toStdString(); }
    QStringList files() const { return QDir(folder_.path()).entryList(QDir::Files | QDir::Hidden); }
    void write_older(const std::string& path) const
    {
        RecordingWriter writer(path, run_);
        writer.append(small_frame(run_, 0));
        writer.finish(mark_of_older);
    }
    bool is_older(const std::string& path) const { return Recording(path).run().wall == mark_of_older; }
    /// All frames so far are whole.
    static int whole_frames(const std::string& path)
    {
        Recording recording(path);
        recording.read_frames([](const Frame&) { return true; });
        for (const std::string& problem : recording.problems()) qWarning("%s", problem.c_str());
        return recording.problems().empty() ? recording.frames() : -1;
    }

private Q_SLOTS:
    void anOlderRecordingStaysUntilAFrameAfterTheStartIsWhole()
    {
        const std::string path = at("older.hygrorec");
        write_older(path);
        {
            const RecordingWriter writer(path, run_);
            QVERIFY(is_older(path));
        }
        QVERIFY(is_older(path)); // a run that ends before its first frame leaves nothing
        {
            RecordingWriter writer(path, run_);
            writer.append(small_frame(run_, 0));
            writer.note_switched_on({"heat", 0, 0.5, 0.1});
            QVERIFY(is_older(path));
        }
        QVERIFY(is_older(path)); // one that ends at its start, too
        RecordingWriter writer(path, run_);
        writer.append(small_frame(run_, 0));
        QVERIFY(is_older(path));
        writer.append(small_frame(run_, 1));
        QVERIFY(!is_older(path));
        QVERIFY(Recording(path).is_being_written());
        QCOMPARE(whole_frames(path), 2);
        writer.finish(1);
        QVERIFY(Recording(path).finished());
        QVERIFY(!Recording(path).is_being_written());
        QCOMPARE(files().filter("older"), QStringList{"older.hygrorec"});
    }
    void aSecondRunIsRefusedAndTouchesNothing()
    {
        const std::string path = at("two.hygrorec");
        write_older(path);
        RecordingWriter first(path, run_);
        const auto second = [&] { return complaint_of([&] { RecordingWriter(path, run_); }); };
        const QString sentence =
            QString::fromStdString(path) + ": another run is writing this recording. Wait for its end or choose another name.";
        QCOMPARE(second(), sentence);
        QVERIFY(is_older(path));
        for (int k = 0; k < 3; ++k) {
            first.append(small_frame(run_, k));
            QCOMPARE(second(), sentence);
            if (k > 0) { QVERIFY(whole_frames(path) >= 2); }
        }
        first.finish(1);
        QCOMPARE(second(), QString());
        QVERIFY(Recording(path).finished());
    }
    void readersHoldNoRunUp()
    {
        const std::string path = at("readers.hygrorec");
        write_older(path);
        const Recording older(path);
        RecordingWriter writer(path, run_);
        for (int k = 0; k < 2; ++k) writer.append(small_frame(run_, k));
        const Recording reader(path), late(path);
        for (int k = 2; k < 20; ++k) writer.append(small_frame(run_, k));
        QCOMPARE(reader.frame(1).temperature.front(), 293.15F);
        QElapsedTimer time;
        time.start();
        writer.finish(1);
        QVERIFY2(time.elapsed() < 1000, qPrintable(QString::number(time.elapsed())));
        QCOMPARE(files().filter("readers"), QStringList{"readers.hygrorec"});
        QCOMPARE(reader.frames(), 2);
        QCOMPARE(reader.frame(0).temperature.front(), 293.15F);
        QCOMPARE(older.frame(0).temperature.front(), 293.15F);
        QCOMPARE(whole_frames(path), 20);
        write_older(path);
        QCOMPARE(complaint_of([&] { late.frame(0); }),
                 QString::fromStdString(path) + ": Frame 0 cannot be read: another run has replaced this recording.");
    }
    /// In another program, which began to read and was stopped.
    void aReaderThatWasHaltedHoldsNoRunUp()
    {
        const std::string path = at("halted.hygrorec");
        RecordingWriter writer(path, run_);
        for (int k = 0; k < 2; ++k) writer.append(small_frame(run_, k));
        std::this_thread::sleep_for(std::chrono::milliseconds(250));
        writer.append(small_frame(run_, 2));
        sqlite3* halted = nullptr;
        sqlite3_stmt* rows = nullptr;
        QCOMPARE(sqlite3_open_v2(path.c_str(), &halted, SQLITE_OPEN_READONLY, nullptr), SQLITE_OK);
        QCOMPARE(sqlite3_prepare_v2(halted, "SELECT number FROM frames", -1, &rows, nullptr), SQLITE_OK);
        QCOMPARE(sqlite3_step(rows), SQLITE_ROW);
        QElapsedTimer time;
        time.start();
        for (int k = 3; k < 6; ++k) {
            std::this_thread::sleep_for(std::chrono::milliseconds(210));
            writer.append(small_frame(run_, k));
        }
        QVERIFY2(time.elapsed() < 1500, qPrintable(QString::number(time.elapsed())));
        QCOMPARE(whole_frames(path), 6);
        writer.finish(1);
        QVERIFY2(time.elapsed() < 6000, qPrintable(QString::number(time.elapsed())));
        QCOMPARE(whole_frames(path), 6);
        QVERIFY(Recording(path).finished());
        sqlite3_finalize(rows);
        sqlite3_close(halted);
        QCOMPARE(whole_frames(path), 6);
    }
    void aRunningRecordingIsWholeWheneverItIsOpened()
    {
        const std::string path = at("running.hygrorec");
        const pid_t child = begin_apart([&] {
            RecordingWriter writer(path, run_);
            for (int k = 0; k < 200; ++k) {
                writer.append(small_frame(run_, k));
                std::this_thread::sleep_for(std::chrono::milliseconds(10)); // several commits
            }
            writer.finish(1);
        });
        int openings = 0, last = 0, sizes = 0;
        for (bool goes_on = true; goes_on; ++openings) {
            goes_on = waitpid(child, nullptr, WNOHANG) == 0;
            if (!QFile::exists(QString::fromStdString(path))) continue;
            const int now = whole_frames(path);
            QVERIFY(now >= std::max(1, last));
            sizes += now > last ? 1 : 0;
            last = now;
        }
        QCOMPARE(last, 200);
        QVERIFY2(sizes > 5, qPrintable(QString("%1 of %2 openings").arg(sizes).arg(openings)));
    }
    /// Else a run that pauses after a burst of frames, or computes long to the next, would keep them to itself.
    void aBurstOfFramesTakesEffectWithoutAnother()
    {
        const std::string path = at("burst.hygrorec");
        RecordingWriter writer(path, run_);
        for (int k = 0; k < 20; ++k) writer.append(small_frame(run_, k));
        std::this_thread::sleep_for(std::chrono::milliseconds(250));
        writer.commit_when_due();
        QCOMPARE(whole_frames(path), 20);
    }
    /// 3 ms each, when each was committed by itself.
    void aSmallFrameCostsLittle()
    {
        constexpr int frames = 1440;
        const std::string path = at("many.hygrorec");
        RecordingWriter writer(path, run_);
        QElapsedTimer time;
        time.start();
        const auto begin = std::clock();
        for (int k = 0; k < frames; ++k) writer.append(small_frame(run_, k));
        writer.finish(1);
        const double each = 1e3 * double(std::clock() - begin) / CLOCKS_PER_SEC / frames; // ms of processor time
        qInfo("%.3f ms of processor time a frame, %.3f ms in all", each, double(time.elapsed()) / frames);
        QVERIFY(each < 1);
        QCOMPARE(whole_frames(path), frames);
    }
    void aKillAtAnyMomentLeavesWholeFrames()
    {
        const std::string path = at("killed.hygrorec");
        std::mt19937 random(1);
        int readable = 0, frames = 0;
        for (int trial = 0; trial < 30; ++trial) {
            write_older(path);
            const pid_t child = begin_apart([&] {
                RecordingWriter writer(path, run_);
                for (int k = 0;; ++k) writer.append(small_frame(run_, k % 5 + 5 * k));
            });
            for (int k = 0; trial == 29 && k < 1000 && is_older(path); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(10));
            std::this_thread::sleep_for(std::chrono::microseconds(random() % (trial < 20 ? 60'000 : 400'000)));
            kill(child, SIGKILL);
            waitpid(child, nullptr, 0);
            const int whole = whole_frames(path);
            QVERIFY(whole >= 1);
            readable += is_older(path) || !Recording(path).finished() ? 1 : 0;
            frames = std::max(frames, whole);
            QVERIFY(!Recording(path).is_being_written());
            const std::string alone = at("alone.hygrorec");
            QFile::remove(QString::fromStdString(alone));
            QVERIFY(QFile::copy(QString::fromStdString(path), QString::fromStdString(alone)));
            const int in_copy = Recording(alone).frames();
            QVERIFY2(in_copy >= 1 && in_copy <= whole, qPrintable(QString("%1 of %2").arg(in_copy).arg(whole)));
        }
        QCOMPARE(readable, 30);
        QVERIFY(frames > 1);
        write_older(path); // takes over what the last kill may have left beside it
        QCOMPARE(files().filter("killed"), QStringList{"killed.hygrorec"});
    }
    /// The file alone, whose pages were being replaced by those in the file beside it, new ones first: up to any of them.
    void aCheckpointThatWasCutLosesFramesAtMost()
    {
        const std::string path = at("torn.hygrorec");
        QByteArray before, beside;
        {
            RecordingWriter writer(path, run_);
            for (int k = 0; k < 5; ++k) writer.append(small_frame(run_, k));
            std::this_thread::sleep_for(std::chrono::milliseconds(250));
            for (int k = 5; k < 80; ++k) writer.append(small_frame(run_, k));
            std::this_thread::sleep_for(std::chrono::milliseconds(250));
            writer.append(small_frame(run_, 80));
            before = bytes_of(path);
            beside = bytes_of(path + "-wal");
        }
        const qsizetype page = 4096, head = 32, page_head = 24;
        std::map<std::uint32_t, QByteArray> pages;
        for (qsizetype place = head; place + page_head + page <= beside.size(); place += page_head + page)
            pages[qFromBigEndian<std::uint32_t>(beside.constData() + place)] = beside.mid(place + page_head, page);
        QVERIFY2(pages.size() > 20, qPrintable(QString::number(pages.size())));
        set_bytes(at("before.hygrorec"), before);
        set_bytes(at("beside"), beside);
        const int file = ::open(at("before.hygrorec").c_str(), O_RDWR);
        QVERIFY(write_new_pages(at("beside"), file, std::uint32_t(before.size() / page)));
        ::close(file);
        before = bytes_of(at("before.hygrorec"));
        int least = 100, most = 0;
        for (const auto& [number, bytes] : pages) {
            before.replace(page * qsizetype(number - 1), page, bytes);
            set_bytes(at("alone.hygrorec"), before);
            Recording alone(at("alone.hygrorec"));
            alone.read_frames([](const Frame&) { return true; });
            least = std::min(least, alone.frames());
            most = std::max(most, alone.frames());
        }
        QVERIFY2(least >= 1, qPrintable(QString::number(least)));
        QCOMPARE(most, 81);
    }
    void whatAKillLeftIsBroughtIntoOneFile()
    {
        const std::string path = at("left.hygrorec");
        const pid_t child = begin_apart([&] {
            RecordingWriter writer(path, run_);
            for (int k = 0;; ++k) writer.append(small_frame(run_, k));
        });
        QTRY_VERIFY(QFile::exists(QString::fromStdString(path + "-wal")) && QFile(QString::fromStdString(path + "-wal")).size() > 0);
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        bring_in_left_over(path); // a run writes it
        QVERIFY(QFile::exists(QString::fromStdString(path + "-wal")));
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
        const int whole = whole_frames(path);
        bring_in_left_over(path);
        QCOMPARE(files().filter("left"), QStringList{"left.hygrorec"});
        QCOMPARE(whole_frames(path), whole);
        QVERIFY(!Recording(path).finished());
    }
    void aFullDiskKeepsWhatWasWholeBefore_data()
    {
        QTest::addColumn<int>("kilobytes");
        for (int kilobytes = 2; kilobytes < 600; kilobytes += 23) QTest::addRow("%d kB", kilobytes) << kilobytes;
    }
    /// A limit on the size of files stands for the disk.
    void aFullDiskKeepsWhatWasWholeBefore()
    {
        QFETCH(int, kilobytes);
        const std::string path = at("full.hygrorec"), said = at("full.txt");
        write_older(path);
        const pid_t child = begin_apart([&] {
            std::signal(SIGXFSZ, SIG_IGN);
            QFile sentence(QString::fromStdString(said));
            const bool open = sentence.open(QIODevice::WriteOnly);
            int frames = 0;
            const rlimit most{rlim_t(kilobytes) * 1024, RLIM_INFINITY};
            const QString complaint = complaint_of([&] {
                setrlimit(RLIMIT_FSIZE, &most);
                RecordingWriter writer(path, run_);
                for (; frames < 200; ++frames) writer.append(small_frame(run_, frames));
                writer.finish(1);
            });
            if (open) sentence.write(QByteArray::number(frames) + " " + complaint.toUtf8());
            sentence.close();
            std::exit(0);
        });
        int status = -1;
        waitpid(child, &status, 0);
        QCOMPARE(status, 0);
        const QString complaint = bytes_of(said);
        const int frames = complaint.section(' ', 0, 0).toInt();
        QVERIFY2(complaint.contains(": it cannot be written: File too large; "), qPrintable(complaint));
        if (frames < 2) {
            QVERIFY(complaint.endsWith("; nothing was recorded, and what had this name before stays."));
            QVERIFY(is_older(path));
        } else {
            const int whole = whole_frames(path); // those of the last moment were not committed yet
            QVERIFY2(whole >= 2 && whole <= frames, qPrintable(QString::number(whole)));
            QVERIFY2(complaint.endsWith(QString("; the recording ends at %1 s and can be read up to there.").arg(0.1 * (whole - 1))),
                     qPrintable(complaint));
            QVERIFY(!Recording(path).finished());
        }
        QVERIFY(!files().contains(".full.hygrorec.part"));
    }
    void whatIsNoRecordingIsNotReplaced()
    {
        const std::string path = at("text.hygrorec");
        set_bytes(path, "a text");
        QVERIFY(complaint_of([&] { RecordingWriter(path, run_); }).contains("it is no recording"));
        QCOMPARE(bytes_of(path), QByteArray("a text"));
        QVERIFY(complaint_of([&] { RecordingWriter(folder_.path().toStdString(), run_); }).contains("cannot be replaced"));
        QCOMPARE(files().filter("text"), QStringList{"text.hygrorec"});
    }
};

} // namespace tst_recording_writer

QTEST_GUILESS_MAIN(tst_recording_writer::TestRecordingWriter)
#include "tst_recording_writer.moc"
