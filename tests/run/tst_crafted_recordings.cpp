// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Recordings of strangers: whatever their objects are, they are refused with a sentence that names file and field, or read.
#include "core/base/error.h"
#include "core/plan/plan_json.h"
#include "core/run/hdf5_driver.h"
#include "core/run/hdf5_reader.h"
#include "core/run/recording.h"
#include "core/run/recording_source.h"
#include "tests/support/crafted_recording.h"
#include "tests/support/process_memory.h"

#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <hdf5.h>
#include <zlib.h>

#include <cstring>
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

struct OpenFile {
    explicit OpenFile(const std::string& path) : id(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT)) {}
    ~OpenFile() { H5Fclose(id); }
    hid_t id;
};

void put_array(hid_t file, const char* group_name, const char* name, hid_t type, hsize_t count)
{
    const hid_t group = H5Gopen2(file, group_name, H5P_DEFAULT);
    if (H5Aexists(group, name) > 0) H5Adelete(group, name);
    const hid_t space = H5Screate_simple(1, &count, nullptr), attribute = H5Acreate2(group, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    const std::vector<double> values(count, 1);
    H5Awrite(attribute, type, values.data());
    H5Aclose(attribute);
    H5Sclose(space);
    H5Gclose(group);
}

void put_set(hid_t file, const char* name, hid_t type, std::vector<hsize_t> sizes, hid_t properties = H5P_DEFAULT)
{
    H5Ldelete(file, name, H5P_DEFAULT);
    const hid_t space = H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr);
    const hid_t set = H5Dcreate2(file, name, type, space, H5P_DEFAULT, properties, H5P_DEFAULT);
    H5Dclose(set);
    H5Sclose(space);
}

void put_float(hid_t file, const char* name, float value)
{
    const hid_t set = H5Dopen2(file, name, H5P_DEFAULT), space = H5Dget_space(set);
    std::vector<float> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    H5Dread(set, H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    values[values.size() / 2] = value;
    H5Dwrite(set, H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Sclose(space);
    H5Dclose(set);
}

hid_t list_of_texts()
{
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, 500);
    return type;
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

using Craft = void (*)(hid_t file);

constexpr double least_memory = 200e6; ///< bytes; what any recording may take beside three times its size

} // namespace

Q_DECLARE_METATYPE(Craft)

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
        QTest::addColumn<Craft>("craft");
        QTest::addColumn<QString>("sentence");
        const auto row = [](const char* name, Craft craft, const char* sentence) { QTest::newRow(name) << craft << QString(sentence); };
        row(
            "a list as the version", [](hid_t f) { put_array(f, "/", "version", H5T_NATIVE_DOUBLE, 4000); },
            "\"version\" has 4000 values; expected is one value.");
        row(
            "a list as the wall time", [](hid_t f) { put_array(f, "/", "wall_s", H5T_NATIVE_DOUBLE, 4000); },
            "\"wall_s\" has 4000 values; expected is one value.");
        row(
            "a list as the threads", [](hid_t f) { put_array(f, "/provenance", "threads", H5T_NATIVE_DOUBLE, 4000); },
            "\"provenance/threads\" has 4000 values; expected is one value.");
        row(
            "a list of a part that came on",
            [](hid_t f) { put_array(f, "/provenance/switched_on/heat", "limit", H5T_NATIVE_DOUBLE, 4000); },
            "\"provenance/switched_on/heat/limit\" has 4000 values; expected is one value.");
        row(
            "a whole number as the version", [](hid_t f) { put_array(f, "/", "version", H5T_NATIVE_LLONG, 1); },
            "\"version\" is not a number.");
        row(
            "texts as the seed", [](hid_t f) { put_set(f, "/provenance/seed", list_of_texts(), {50}); },
            "\"provenance/seed\" has 50 values; expected is one value.");
        row(
            "texts as the design", [](hid_t f) { put_set(f, "/design", list_of_texts(), {50}); },
            "\"design\" has 50 values; expected is one value.");
        row(
            "texts as the format", [](hid_t f) { put_set(f, "/format", list_of_texts(), {50}); },
            "\"format\" has 50 values; expected is one value.");
        row(
            "texts of any length",
            [](hid_t f) {
                const hid_t type = H5Tcopy(H5T_C_S1);
                H5Tset_size(type, H5T_VARIABLE);
                put_set(f, "/provenance/all_devices", type, {1});
            },
            "\"provenance/all_devices\" cannot be read; it is damaged, or of a kind that recordings do not hold.");
        row(
            "a link elsewhere",
            [](hid_t f) {
                H5Ldelete(f, "/provenance", H5P_DEFAULT);
                H5Lcreate_external("/etc/passwd", "/", f, "/provenance", H5P_DEFAULT, H5P_DEFAULT);
            },
            "this is not a recording, or it is damaged or incomplete.");
        row(
            "a link within",
            [](hid_t f) {
                H5Ldelete(f, "/provenance", H5P_DEFAULT);
                H5Lcreate_soft("/textile", f, "/provenance", H5P_DEFAULT, H5P_DEFAULT);
            },
            "\"provenance\" is a link; recordings hold none, and none is followed.");
        row(
            "a text in another file",
            [](hid_t f) {
                const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
                H5Pset_external(properties, "/etc/passwd", 0, 500);
                put_set(f, "/provenance/all_devices", list_of_texts(), {1}, properties);
            },
            "\"provenance/all_devices\" cannot be read; it is damaged, or of a kind that recordings do not hold.");
        row(
            "a table from other files",
            [](hid_t f) {
                const hsize_t sizes[] = {3, 13};
                const hid_t properties = H5Pcreate(H5P_DATASET_CREATE), space = H5Screate_simple(2, sizes, nullptr);
                H5Pset_virtual(properties, space, "/etc/passwd", "/ledger", space);
                put_set(f, "/ledger", H5T_NATIVE_DOUBLE, {3, 13}, properties);
            },
            "\"ledger\" cannot be read; it is damaged, or of a kind that recordings do not hold.");
        row(
            "a ledger of other columns",
            [](hid_t f) {
                const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
                H5Pset_alloc_time(properties, H5D_ALLOC_TIME_EARLY);
                put_set(f, "/ledger", H5T_NATIVE_DOUBLE, {3, 12}, properties);
            },
            "\"ledger\" has 12 columns; 13 to 14 are possible.");
        row(
            "a ledger larger than its file",
            [](hid_t f) {
                put_set(f, "/ledger", H5T_NATIVE_DOUBLE, {20'000'000, 13});
            },
            "\"ledger\" should have 20000000 x 13 values, which the file does not hold.");
        row(
            "a version that is no number",
            [](hid_t f) {
                const hid_t attribute = H5Aopen(f, "version", H5P_DEFAULT);
                const double value = std::numeric_limits<double>::quiet_NaN();
                H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value);
                H5Aclose(attribute);
            },
            "\"version\" is not a finite number.");
    }
    void whatIsNotAsExpectedIsNamed()
    {
        QFETCH(Craft, craft);
        QFETCH(QString, sentence);
        restore();
        craft(OpenFile(crafted_).id);
        QCOMPARE(QString::fromStdString(refusal_of(crafted_)), QString::fromStdString(crafted_) + ": " + sentence);
    }
    void ofBadFramesTheOthersAreRead_data()
    {
        QTest::addColumn<Craft>("craft");
        QTest::addColumn<QString>("why");
        const auto row = [](const char* name, Craft craft, const char* why) { QTest::newRow(name) << craft << QString(why); };
        row(
            "a list as its time", [](hid_t f) { put_array(f, "/frames/000001", "time_s", H5T_NATIVE_DOUBLE, 4000); },
            "\"frames/000001/time_s\" has 4000 values; expected is one value.");
        row(
            "a time before the last", [](hid_t f) { put_array(f, "/frames/000001", "time_s", H5T_NATIVE_DOUBLE, 1); },
            "its time is 1 s, and 0.1 s in the ledger.");
        row(
            "no temperature", [](hid_t f) { H5Ldelete(f, "/frames/000001/temperature", H5P_DEFAULT); },
            "\"frames/000001/temperature\" is missing; the recording is damaged or no recording.");
        row(
            "a value that is no number", [](hid_t f) { put_float(f, "/frames/000001/liquid", std::numeric_limits<float>::quiet_NaN()); },
            "\"frames/000001/liquid\" holds a number that is not finite.");
        row(
            "an endless place", [](hid_t f) { put_float(f, "/frames/000001/particle_position", std::numeric_limits<float>::infinity()); },
            "\"frames/000001/particle_position\" holds a number that is not finite.");
        row(
            "no frame", [](hid_t f) { H5Ldelete(f, "/frames/000001", H5P_DEFAULT); },
            "\"frames/000001\" is missing; the recording is damaged or no recording.");
        row(
            "fewer values", [](hid_t f) { put_set(f, "/frames/000001/saturation", H5T_NATIVE_FLOAT, {3}); },
            "\"frames/000001/saturation\" has 3 values; expected is 1568 values.");
    }
    void ofBadFramesTheOthersAreRead()
    {
        QFETCH(Craft, craft);
        QFETCH(QString, why);
        restore();
        craft(OpenFile(crafted_).id);
        int frames = 0;
        std::vector<std::string> problems;
        QCOMPARE(refusal_of(crafted_, &frames, &problems), std::string());
        QCOMPARE(frames, 2);
        QCOMPARE(problems.size(), std::size_t(1));
        QCOMPARE(QString::fromStdString(problems[0]), QString::fromStdString(crafted_) + ": Frame 1 is left out: " + why);
    }
    void flippedBitsInTextsAreRepaired()
    {
        restore();
        {
            const OpenFile file(crafted_);
            const hid_t set = H5Dopen2(file.id, "/provenance/all_devices", H5P_DEFAULT), type = H5Dget_type(set);
            std::string text(H5Tget_size(type), '\0');
            H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data());
            text[2] = char(text[2] | 0x80);
            H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data());
            H5Tclose(type);
            H5Dclose(set);
        }
        QCOMPARE(Recording(crafted_).run().device, std::string("a \xEF\xBF\xBD"
                                                               "evice; from 0.1 s on another"));
    }
    void unpackingTakesNoMoreThanTheValuesDo()
    {
        restore();
        {
            const OpenFile file(crafted_);
            const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
            const hsize_t chunk = 1568, none = 0;
            H5Pset_chunk(properties, 1, &chunk);
            H5Pset_deflate(properties, 9);
            put_set(file.id, "/frames/000001/saturation", H5T_NATIVE_FLOAT, {1568}, properties);
            const std::vector<Bytef> packed = packed_zeros(std::size_t(800'000'000)); // 0.8 MB
            const hid_t set = H5Dopen2(file.id, "/frames/000001/saturation", H5P_DEFAULT);
            QVERIFY(H5Dwrite_chunk(set, H5P_DEFAULT, 0, &none, packed.size(), packed.data()) >= 0);
            H5Dclose(set);
        }
        const double before = peak_memory();
        int frames = 0;
        QCOMPARE(refusal_of(crafted_, &frames), std::string());
        QCOMPARE(frames, 2);
        QVERIFY(peak_memory() - before < least_memory);
    }
    /// The library takes what it copies from one place and what it has room for from another.
    void sizesThatDoNotAgreeAreRefused_data()
    {
        QTest::addColumn<QByteArray>("before");
        QTest::addColumn<int>("where");
        QTest::addColumn<int>("size");
        QTest::addColumn<int>("next"); // of the part after it; 0: as it is
        const QByteArray of_part("TREE\1", 5), of_fill("\x08\0\0\0\0\0\0\0\0\0\xf0\x3f", 12), of_layout("\x03\x02\x03", 3);
        QTest::newRow("none") << of_part << 24 << 24 << 0;
        QTest::newRow("a short part behind a long one") << of_part << 24 << 40 << 8; // together they have as many bytes as they should
        QTest::newRow("a long part") << of_part << 24 << 48 << 0;
        QTest::newRow("a short value for what is not there") << of_fill << 0 << 4 << 0;
        QTest::newRow("values of another size") << of_layout << 19 << 4 << 0;
    }
    void sizesThatDoNotAgreeAreRefused()
    {
        QFETCH(QByteArray, before);
        QFETCH(int, where);
        QFETCH(int, size);
        {
            const hid_t file = H5Fcreate(crafted_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
            const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
            const hsize_t chunk[2] = {1, 3}, rows[2] = {2, 3};
            const double value = 1, values[6] = {};
            H5Pset_chunk(properties, 2, chunk);
            H5Pset_fill_value(properties, H5T_IEEE_F64LE, &value);
            const hid_t space = H5Screate_simple(2, rows, nullptr);
            const hid_t set = H5Dcreate2(file, "table", H5T_IEEE_F64LE, space, H5P_DEFAULT, properties, H5P_DEFAULT);
            QVERIFY(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0);
            H5Dclose(set);
            H5Sclose(space);
            H5Pclose(properties);
            H5Fclose(file);
        }
        QFile file(QString::fromStdString(crafted_));
        QVERIFY(file.open(QIODevice::ReadWrite));
        QByteArray bytes = file.readAll();
        int changed = 0;
        QFETCH(int, next);
        constexpr int key_bytes = 8 + 3 * 8 + 8; // with the place of its part
        for (qsizetype at = bytes.indexOf(before); at >= 0; at = bytes.indexOf(before, at + 1), ++changed) {
            bytes[at + where] = static_cast<char>(size);
            if (next != 0) bytes[at + where + key_bytes] = static_cast<char>(next);
        }
        QVERIFY(changed > 0 && file.seek(0) && file.write(bytes) == bytes.size());
        file.close();
        bool refused = false;
        try {
            RecordingSource source(crafted_);
            const hdf5::Handle opened = hdf5::open_file(source, "It cannot be opened.");
            QCOMPARE(hdf5::Table(opened.get(), "table", 3, 3).read(0, 2), std::vector<double>(6));
        } catch (const FileError&) {
            refused = true;
        }
        QCOMPARE(refused, QTest::currentDataTag() != QByteArray("none"));
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
    void whatLeadsBackToItselfIsRefused()
    {
        QFile valid(QString::fromStdString(valid_));
        QVERIFY(valid.open(QIODevice::ReadOnly));
        const QByteArray bytes = valid.readAll();
        int tried = 0;
        const auto attempt = [&](qsizetype at, std::uint64_t number, qsizetype level_at = -1) {
            QByteArray crafted = bytes;
            std::memcpy(crafted.data() + at, &number, sizeof number);
            if (level_at >= 0) crafted[level_at] = 1;
            QFile file(QString::fromStdString(crafted_));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(crafted);
            file.close();
            refusal_of(crafted_);
            ++tried;
        };
        for (qsizetype at = bytes.indexOf("TREE"); at >= 0; at = bytes.indexOf("TREE", at + 1))
            for (const qsizetype child : {32, 24 + 24, 24 + 32}) attempt(at + child, std::uint64_t(at), at + 5);
        for (qsizetype at = bytes.indexOf("HEAP"); at >= 0; at = bytes.indexOf("HEAP", at + 1)) {
            std::uint64_t names = 0;
            std::memcpy(&names, bytes.constData() + at + 24, sizeof names);
            attempt(at + 16, 8);                     // free room from a place
            attempt(qsizetype(names) + 8, 8);        // on to that place
            attempt(at + 8, std::uint64_t(1) << 40); // of a terabyte
        }
        QVERIFY(tried > 40);
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
