// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Recordings of strangers: whatever stands in them, they are refused with a sentence that names file and field, or read.
#include "core/base/error.h"
#include "core/plan/plan_json.h"
#include "core/run/run_file.h"
#include "tests/support/crafted_recording.h"
#include "tests/support/process_memory.h"

#include <QElapsedTimer>
#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <zlib.h>

#include <limits>
#include <random>
#include <sys/stat.h>

using namespace hygroloom;

namespace {

/// The sentence of the refusal; empty: all was read.
std::string refusal_of(const std::string& path, int* frames = nullptr, std::vector<std::string>* problems = nullptr)
{
    try {
        Recording recording(path);
        recording.read_frames([](const Frame&) { return true; });
        if (frames) *frames = recording.frames();
        if (problems) *problems = recording.problems();
        return {};
    } catch (const FileError& error) {
        return error.what();
    }
}

std::vector<Bytef> packed_zeros(std::size_t count)
{
    std::vector<Bytef> zeros(1 << 20), packed(compressBound(count) / 100);
    z_stream stream{};
    deflateInit(&stream, 9);
    stream.next_out = packed.data();
    stream.avail_out = static_cast<uInt>(packed.size());
    for (std::size_t done = 0; done < count; done += zeros.size()) {
        stream.next_in = zeros.data();
        stream.avail_in = static_cast<uInt>(zeros.size());
        deflate(&stream, Z_NO_FLUSH);
    }
    deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
}

/// Puts a number into the middle of a field of the second frame.
void put_float(const std::string& path, const std::string& column, float value)
{
    const RunFileReader file(path);
    const StoredRow row = file.row(1, {column});
    std::vector<float> values = column.starts_with("particle") ? row.triples(column, 1) : row.floats(column, 1568);
    values[values.size() / 2] = value;
    NumberPacker packer;
    const Database database(path, Database::Access::write);
    database.statement("UPDATE frames SET " + sql_name(column) + "=?1 WHERE number=1")
        .bind_bytes(1, packer.packed(std::span<const float>(values)))
        .run();
    database.become_one_file();
}

constexpr double least_memory = 200e6; ///< bytes; what any recording may take beside three times its size

} // namespace

class TestCraftedRecordings : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;
    std::string valid_, crafted_;

    void restore() const
    {
        QFile::remove(QString::fromStdString(crafted_));
        QVERIFY(QFile::copy(QString::fromStdString(valid_), QString::fromStdString(crafted_)));
    }

private Q_SLOTS:
    void initTestCase()
    {
        valid_ = folder_.filePath("valid.hygrorec").toStdString();
        crafted_ = folder_.filePath("crafted.hygrorec").toStdString();
        write_small_recording(valid_);
        int frames = 0;
        QCOMPARE(refusal_of(valid_, &frames), std::string());
        QCOMPARE(frames, 3);
    }
    void eachIsRefusedByNameOrRead_data()
    {
        QTest::addColumn<int>("first");
        for (int first = 0; first < 600; first += 100) QTest::addRow("from %d", first) << first;
    }
    void eachIsRefusedByNameOrRead()
    {
        QFETCH(int, first);
        int refused = 0;
        for (int seed = first; seed < first + 100; ++seed) {
            std::mt19937 random(static_cast<unsigned>(seed));
            std::vector<std::uint8_t> bytes(6 + random() % 12);
            for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
            restore();
            const std::string did = craft(crafted_, {bytes.data(), bytes.size()});
            const std::string sentence = refusal_of(crafted_);
            refused += sentence.empty() ? 0 : 1;
            QVERIFY2(sentence.empty() || sentence.starts_with(crafted_ + ": "), (did + " -> " + sentence).c_str());
        }
        QVERIFY(refused > 10); // and what is only about one frame, or about nothing that is read, is not
        QVERIFY(refused < 95);
    }
    void whatIsNotAsExpectedIsNamed_data()
    {
        QTest::addColumn<QString>("sql");
        QTest::addColumn<QString>("sentence");
        const auto row = [](const char* name, const char* sql, const char* sentence) {
            QTest::newRow(name) << QString(sql) << QString(sentence);
        };
        row("a text as the wall time", "UPDATE meta SET value='1' WHERE name='wall_s'", "\"wall_s\" is not a number.");
        row("no threads", "DELETE FROM meta WHERE name='provenance/threads'",
            "\"provenance/threads\" is missing; the recording is damaged or no recording.");
        row("half a thread", "UPDATE meta SET value=0.5 WHERE name='provenance/threads'",
            "\"provenance/threads\" is 0.5; expected is a whole number from 0 to 1000000.");
        row("an endless wall time", "UPDATE meta SET value=9e999 WHERE name='wall_s'", "\"wall_s\" is not a finite number.");
        row("bytes as the design", "UPDATE meta SET value=x'00' WHERE name='design'", "\"design\" is not a text.");
        row("a number as the seed", "UPDATE meta SET value=1 WHERE name='provenance/seed'", "\"provenance/seed\" is not a text.");
        row("another format", "UPDATE meta SET value='hygroloom-study-results' WHERE name='format'",
            "this is not the recording of a sample.");
        row("a garment's format", "UPDATE meta SET value='hygroloom-wear-recording' WHERE name='format'",
            "this is the recording of a worn garment, not of a sample.");
        row("no table of frames", "DROP TABLE frames", "its table \"frames\" is missing; it is damaged or no recording.");
        row("a view of frames", "ALTER TABLE frames RENAME TO f; CREATE VIEW frames AS SELECT * FROM f",
            "it holds \"f\", which recordings do not; it is damaged or no recording.");
        row("a view alone", "DROP TABLE frames; CREATE VIEW frames AS SELECT 1 AS number",
            "its table \"frames\" has another form than recordings have.");
        row("a trigger", "CREATE TRIGGER t AFTER INSERT ON meta BEGIN DELETE FROM frames; END",
            "it holds \"t\", which recordings do not; it is damaged or no recording.");
        row("a trigger with a table's name", "DROP TABLE frames; CREATE TRIGGER frames AFTER INSERT ON meta BEGIN DELETE FROM meta; END",
            "its table \"frames\" has another form than recordings have.");
        row("a table with code", "CREATE VIRTUAL TABLE v USING fts5(x)",
            "it holds \"v\", which recordings do not; it is damaged or no recording.");
        row("a computed column", "ALTER TABLE frames ADD COLUMN more AS (zeroblob(100000000))",
            "its table \"frames\" has another form than recordings have.");
        row("a default", "ALTER TABLE meta ADD COLUMN more DEFAULT 1", "its table \"meta\" has another form than recordings have.");
        row("a newer form", "PRAGMA user_version=77", "this has version 77; this program reads up to 1. Use a newer program.");
        row("no form", "PRAGMA user_version=0", "this has version 0, which there is not; it is damaged.");
        row("another program", "PRAGMA application_id=7", "this is not a Hygroloom recording.");
        row("a table at another's place", "PRAGMA writable_schema=ON; UPDATE sqlite_schema SET rootpage=5-rootpage",
            "its table \"meta\" is damaged.");
        row("a table at no place", "PRAGMA writable_schema=ON; UPDATE sqlite_schema SET rootpage=4000000", "it is damaged.");
    }
    void whatIsNotAsExpectedIsNamed()
    {
        QFETCH(QString, sql);
        QFETCH(QString, sentence);
        restore();
        QVERIFY(craft_by_sql(crafted_, sql.toStdString()));
        QCOMPARE(QString::fromStdString(refusal_of(crafted_)), QString::fromStdString(crafted_) + ": " + sentence);
    }
    void ofBadFramesTheOthersAreRead_data()
    {
        QTest::addColumn<QString>("set");
        QTest::addColumn<QString>("why");
        const auto row = [](const char* name, const char* set, const char* why) { QTest::newRow(name) << QString(set) << QString(why); };
        row("a text as its time", "time_s='now'", "\"frames/000001/time_s\" is not a number.");
        row("no time", "time_s=NULL", "\"frames/000001/time_s\" is not a number.");
        row("a time before the last", "time_s=0, ledger_time_s=0", "its time, 0 s, does not come after 0 s.");
        row("a time before all", "time_s=-1, ledger_time_s=-1", "its time is -1 s, and -1 s in the ledger.");
        row("two times", "time_s=0.05", "its time is 0.05 s, and 0.1 s in the ledger.");
        row("an endless amount of water", "water_free_kg=9e999", "\"frames/000001/water_free_kg\" is not a finite number.");
        row("no temperature", "temperature=NULL", "\"frames/000001/temperature\" is missing; the recording is damaged or no recording.");
        row("a text of temperatures", "temperature='293'", "\"frames/000001/temperature\" is not a field of numbers.");
        row("no size of temperatures", "temperature=x'00'", "\"frames/000001/temperature\" has 0 values; expected are 1568.");
        row("fewer values", "saturation=x'0C00000000000000000000000000000000000000'",
            "\"frames/000001/saturation\" has 3 values; expected are 1568.");
        row("values that are not there", "saturation=x'8018000000000000'",
            "\"frames/000001/saturation\" cannot be unpacked; the file is damaged.");
        row("values that end early", "saturation=substr(saturation,1,20)",
            "\"frames/000001/saturation\" cannot be unpacked; the file is damaged.");
        row("half a place", "particle_position=x'080000000000000000000000000000000000'",
            "\"frames/000001/particle_position\" cannot be unpacked; the file is damaged.");
        row("two thirds of a place", "particle_position=x'08000000000000000000000000000000'",
            "\"frames/000001/particle_position\" has 2 values, which are no triples.");
        row("any number of places", "particle_position=x'0000000001000000'",
            "\"frames/000001/particle_position\" has 1073741824 values; a file of this size cannot hold them.");
        row("no velocities", "particle_velocity=NULL", "it has 1 particles, and velocities of 0.");
        row("changes", "follows=1", "it holds changes, and the recording does not say how.");
        row("another number", "number=7", "it is missing.");
    }
    void ofBadFramesTheOthersAreRead()
    {
        QFETCH(QString, set);
        QFETCH(QString, why);
        restore();
        const bool is_behind = set.startsWith("number");
        QVERIFY(craft_by_sql(
            crafted_, (is_behind ? "DELETE FROM frames WHERE number=1" : "UPDATE frames SET " + set + " WHERE number=1").toStdString()));
        int frames = 0;
        std::vector<std::string> problems;
        QCOMPARE(refusal_of(crafted_, &frames, &problems), std::string());
        QCOMPARE(frames, 2);
        QCOMPARE(problems.size(), std::size_t(1));
        QCOMPARE(QString::fromStdString(problems[0]), QString::fromStdString(crafted_) + ": Frame 1 is left out: " + why);
    }
    void numbersThatAreNoneTakeTheirFrame_data()
    {
        QTest::addColumn<QString>("column");
        QTest::addColumn<float>("value");
        QTest::newRow("a value") << "liquid" << std::numeric_limits<float>::quiet_NaN();
        QTest::newRow("a place") << "particle_position" << std::numeric_limits<float>::infinity();
    }
    void numbersThatAreNoneTakeTheirFrame()
    {
        QFETCH(QString, column);
        QFETCH(float, value);
        restore();
        put_float(crafted_, column.toStdString(), value);
        std::vector<std::string> problems;
        QCOMPARE(refusal_of(crafted_, nullptr, &problems), std::string());
        QCOMPARE(problems.size(), std::size_t(1));
        QCOMPARE(QString::fromStdString(problems[0]), QString::fromStdString(crafted_) + ": Frame 1 is left out: \"frames/000001/" +
                                                          column + "\" holds a number that is not finite.");
    }
    void flippedBitsInTextsAreRepaired()
    {
        restore();
        QVERIFY(craft_by_sql(crafted_, "UPDATE meta SET value=CAST(x'6120e465766963653b' AS TEXT) WHERE name='provenance/all_devices'"));
        QCOMPARE(Recording(crafted_).run().device, std::string("a \xEF\xBF\xBD"
                                                               "evice;"));
    }
    void unpackingTakesNoMoreThanTheValuesDo()
    {
        restore();
        const std::vector<Bytef> packed = packed_zeros(std::size_t(800'000'000)); // 0.8 MB
        for (const std::uint64_t told : {std::uint64_t(4 * 1568), std::uint64_t(800'000'000)}) {
            std::string field(reinterpret_cast<const char*>(&told), sizeof told);
            field.append(packed.begin(), packed.end());
            {
                const Database database(crafted_, Database::Access::write);
                database.statement("UPDATE frames SET saturation=?1 WHERE number=1").bind_bytes(1, field).run();
                database.become_one_file();
            }
            const double before = peak_memory();
            int frames = 0;
            QCOMPARE(refusal_of(crafted_, &frames), std::string());
            QCOMPARE(frames, 2);
            QVERIFY(peak_memory() - before < least_memory);
        }
    }
    void bytesAtRandomAreRefusedOrRead()
    {
        QFile valid(QString::fromStdString(valid_));
        QVERIFY(valid.open(QIODevice::ReadOnly));
        const QByteArray whole = valid.readAll();
        std::mt19937 random(5);
        int refused = 0;
        for (int trial = 0; trial < 1000; ++trial) {
            QByteArray bytes = trial % 10 == 0 ? whole.left(qsizetype(random()) % whole.size()) : whole;
            const qsizetype most = trial % 3 == 0 ? 4096 * 4 : bytes.size(); // where the tables' pages lie
            for (int k = 0; k < 1 + trial % 20; ++k)
                if (!bytes.isEmpty()) bytes[qsizetype(random()) % std::min(most, bytes.size())] = static_cast<char>(random());
            QFile file(QString::fromStdString(crafted_));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(bytes);
            file.close();
            const std::string sentence = refusal_of(crafted_);
            refused += sentence.empty() ? 0 : 1;
            QVERIFY2(sentence.empty() || sentence.starts_with(crafted_ + ": "), sentence.c_str());
        }
        qInfo("%d of 1000 are refused", refused);
        QVERIFY(refused > 100 && refused < 1000);
    }
    /// A file beside it that no run has left.
    void whatStandsBesideIsNotTrusted()
    {
        restore();
        QVERIFY(craft_by_sql(crafted_, "PRAGMA journal_mode=WAL"));
        std::mt19937 random(7);
        for (int trial = 0; trial < 100; ++trial) {
            QByteArray beside(32 + 4120 * 3, '\0');
            for (char& byte : beside) byte = static_cast<char>(random());
            if (trial % 2 == 0) beside.replace(0, 4, QByteArray("\x37\x7f\x06\x82", 4));
            QFile file(QString::fromStdString(crafted_ + "-wal"));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(beside);
            file.close();
            int frames = 0;
            QCOMPARE(refusal_of(crafted_, &frames), std::string());
            QCOMPARE(frames, 3);
        }
        QFile::remove(QString::fromStdString(crafted_ + "-wal"));
    }
    void numbersOfAPlanThatDoNotFitAreRefused()
    {
        const QString plan = QString::fromStdString(plan_json(small_run().plan));
        for (const char* key : {"ends", "first_pick", "segments", "crossings_per_cell", "fibre_shells"})
            for (const char* number : {"1e20", "-4294967296", "1.5"}) {
                QString changed = plan;
                changed.replace(QRegularExpression(QString("\"%1\": [0-9]+").arg(key)), QString("\"%1\": %2").arg(key, number));
                QVERIFY2(changed != plan, key);
                QVERIFY_EXCEPTION_THROWN(plan_from_json(changed.toStdString()), Error);
            }
    }
    /// A page that leads to itself, or to others over and over.
    void pagesThatLeadBackAreNotWalkedForEver()
    {
        QFile valid(QString::fromStdString(valid_));
        QVERIFY(valid.open(QIODevice::ReadOnly));
        const QByteArray bytes = valid.readAll();
        constexpr qsizetype page = 4096;
        for (qsizetype at = 0; at < bytes.size() / page; ++at)
            for (const qsizetype to : {at + 1, qsizetype(2), qsizetype(3)}) {
                QByteArray crafted = bytes;
                QByteArray inner("\x05\0\0\0\x0a\x00\x20\0\0\0\0\0", 12); // ten cells; the last child
                inner[11] = static_cast<char>(to);
                for (int cell = 0; cell < 10; ++cell) inner.append(QByteArray("\x01\0", 2));
                const qsizetype begin = at == 0 ? 100 : 0;
                crafted.replace(at * page + begin, inner.size(), inner);
                crafted.replace(at * page + 0x100, 5, QByteArray("\0\0\0", 3) + static_cast<char>(to) + '\x01');
                QFile file(QString::fromStdString(crafted_));
                QVERIFY(file.open(QIODevice::WriteOnly));
                file.write(crafted);
                file.close();
                QElapsedTimer time;
                time.start();
                refusal_of(crafted_);
                QVERIFY(time.elapsed() < 5000);
            }
    }
    void pipesAndFoldersAreRefusedAtOnce()
    {
        const std::string pipe = folder_.filePath("pipe.hygrorec").toStdString();
        QCOMPARE(::mkfifo(pipe.c_str(), 0600), 0);
        QCOMPARE(refusal_of(pipe), pipe + ": this is not a regular file.");
        const std::string folder = folder_.path().toStdString();
        QCOMPARE(refusal_of(folder), folder + ": this is a folder; give the name of a recording.");
    }
};

QTEST_GUILESS_MAIN(TestCraftedRecordings)
#include "tst_crafted_recordings.moc"
