// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Blocks of HDF5 files that share what only one of them can have, or claim what the file does not hold: refused before the library walks
// them or makes room.
#include "core/base/error.h"
#include "core/run/hdf5_driver.h"
#include "core/run/hdf5_reader.h"
#include "core/run/recording_source.h"
#include "tests/support/process_memory.h"

#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <hdf5.h>

#include <cstring>
#include <functional>

using namespace hygroloom;

namespace {

constexpr hsize_t columns = 3, chunk_rows = 100;
constexpr std::uint64_t chunk_bytes = chunk_rows * columns * sizeof(double);

/// The bytes of a file, to be changed.
struct FileBytes {
    QByteArray all;

    void put(qsizetype at, std::uint64_t number, std::size_t size = 8) { std::memcpy(all.data() + at, &number, size); }
    /// Returns where they begin. The library finds the file's end.
    std::uint64_t append(const QByteArray& bytes)
    {
        constexpr qsizetype end_in_superblock = 40;
        const auto at = static_cast<std::uint64_t>(all.size());
        all += bytes;
        put(end_in_superblock, static_cast<std::uint64_t>(all.size()));
        return at;
    }
    /// A tree of chunks with these children.
    std::uint64_t append_tree(int level, const std::vector<std::uint64_t>& children)
    {
        constexpr qsizetype head = 24, key = 8 + 8 * (columns - 1 + 1), most = 64;
        const auto tree = static_cast<qsizetype>(append(QByteArray(head + most * (key + 8) + key, '\0')));
        all.replace(tree, 5, QByteArray("TREE\1", 5));
        put(tree + 5, static_cast<std::uint64_t>(level), 1);
        put(tree + 6, children.size(), 2);
        for (int sibling = 0; sibling < 2; ++sibling) put(tree + 8 + 8 * sibling, UINT64_MAX);
        for (std::size_t i = 0; i <= children.size(); ++i) {
            const qsizetype at = tree + head + static_cast<qsizetype>(i) * (key + 8);
            put(at, chunk_bytes, 4);
            put(at + 8, i * chunk_rows);
            if (i < children.size()) put(at + key, children[i]);
        }
        return static_cast<std::uint64_t>(tree);
    }
    /// Of the sets that have none yet, the next one gets it.
    void set_tree(std::uint64_t tree)
    {
        const qsizetype layout = all.indexOf(QByteArray("\x03\x02\x03\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF", 11));
        QVERIFY(layout > 0);
        put(layout + 3, tree);
    }
};

void create_groups(const std::string& path, const std::vector<const char*>& names)
{
    const hdf5::Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose, "");
    for (const char* name : names) hdf5::create_group(hdf5::create_group(file.get(), name).get(), "in it");
}

/// Tables without values.
void create_tables(const std::string& path, const std::vector<const char*>& names, hsize_t rows)
{
    const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
    const hsize_t chunk[2] = {chunk_rows, columns}, sizes[2] = {rows, columns};
    H5Pset_chunk(properties, 2, chunk);
    const hid_t space = H5Screate_simple(2, sizes, nullptr);
    for (const char* name : names) H5Dclose(H5Dcreate2(file, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, properties, H5P_DEFAULT));
    H5Sclose(space);
    H5Pclose(properties);
    H5Fclose(file);
}

void create_text(const std::string& path, const std::string& text)
{
    const hdf5::Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose, "");
    hdf5::write_text(file.get(), "text", text);
}

using Entries = std::vector<std::pair<std::uint64_t, std::string>>;

/// Whole, whatever its entries are.
std::string log_of(const Entries& entries)
{
    std::string log;
    const auto put = [&](std::uint64_t number) { log.append(reinterpret_cast<const char*>(&number), sizeof number); };
    for (const auto& [at, bytes] : entries) {
        put(at);
        put(bytes.size());
        log += bytes;
    }
    std::uint64_t sum = 0xCBF29CE484222325; // FNV-1a
    for (const char byte : log) sum = (sum ^ static_cast<unsigned char>(byte)) * 0x100000001B3;
    const std::uint64_t length = log.size() + 32;
    put(sum);
    put(length);
    return log + "hygroloom redo..";
}

/// The sentence of the refusal; empty: what the file is read for is read.
std::string refusal_when(const std::string& path, const std::function<void(hid_t)>& read)
{
    try {
        RecordingSource source(path);
        read(hdf5::open_file(source, "It cannot be opened.").get());
        return {};
    } catch (const FileError& error) {
        return error.what();
    }
}

constexpr const char* damaged = "\"table\" should have 6400 x 3 values, which the file does not hold.";

} // namespace

Q_DECLARE_METATYPE(Entries)

class TestCraftedBlocks : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;
    std::string path_;

    void change(const std::function<void(FileBytes&)>& craft) const
    {
        QFile file(QString::fromStdString(path_));
        QVERIFY(file.open(QIODevice::ReadWrite));
        FileBytes bytes{file.readAll()};
        craft(bytes);
        QVERIFY(file.seek(0) && file.write(bytes.all) == bytes.all.size());
    }
    std::string table_refusal(const char* name = "table") const
    {
        return refusal_when(path_, [&](hid_t file) { hdf5::Table(file, name, columns, columns).read(0, 1); });
    }

private Q_SLOTS:
    void initTestCase()
    {
        hdf5::silence();
        path_ = folder_.filePath("crafted.hygrorec").toStdString();
    }
    void treesOfTheLibraryAreRead()
    {
        constexpr hsize_t rows = 20'000; // of 200 chunks, in two levels
        create_tables(path_, {"table"}, rows);
        const hid_t file = H5Fopen(path_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), set = H5Dopen2(file, "table", H5P_DEFAULT);
        std::vector<double> values(rows * columns);
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(i);
        QVERIFY(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0);
        H5Dclose(set);
        H5Fclose(file);
        const auto read = [&](hid_t id) {
            const hdf5::Table table(id, "table", columns, columns);
            for (int twice = 0; twice < 2; ++twice) QCOMPARE(table.read(0, rows), values);
        };
        QCOMPARE(refusal_when(path_, read), std::string());
    }
    void chunksOfATreeThatIsWholeAreRead()
    {
        create_tables(path_, {"table"}, 64 * chunk_rows);
        change([](FileBytes& bytes) {
            std::vector<std::uint64_t> chunks;
            for (int i = 0; i < 64; ++i) chunks.push_back(bytes.append(QByteArray(chunk_bytes, '\0')));
            bytes.set_tree(bytes.append_tree(0, chunks));
        });
        QCOMPARE(table_refusal(), std::string());
    }
    void aTreeHasOneParent()
    {
        create_tables(path_, {"table"}, 64 * 64 * 64 * chunk_rows);
        change([](FileBytes& bytes) {
            std::vector<std::uint64_t> chunks;
            for (int i = 0; i < 64; ++i) chunks.push_back(bytes.append(QByteArray(chunk_bytes, '\0')));
            std::uint64_t tree = bytes.append_tree(0, chunks);
            for (int level = 1; level < 3; ++level) tree = bytes.append_tree(level, std::vector(64, tree));
            bytes.set_tree(tree);
        });
        QCOMPARE(table_refusal(), std::string("\"table\" should have 26214400 x 3 values, which the file does not hold."));
    }
    void aChunkIsNamedOnce()
    {
        create_tables(path_, {"table"}, 64 * chunk_rows);
        change([](FileBytes& bytes) {
            const std::uint64_t chunk = bytes.append(QByteArray(64 * chunk_bytes, '\0'));
            bytes.set_tree(bytes.append_tree(0, std::vector(64, chunk)));
        });
        QCOMPARE(table_refusal(), std::string(damaged));
    }
    void chunksTogetherFitTheFile()
    {
        create_tables(path_, {"table"}, 64 * chunk_rows);
        change([](FileBytes& bytes) {
            const std::uint64_t chunk = bytes.append(QByteArray(2 * chunk_bytes, '\0'));
            std::vector<std::uint64_t> chunks;
            for (std::uint64_t i = 0; i < 64; ++i) chunks.push_back(chunk + 8 * i);
            bytes.set_tree(bytes.append_tree(0, chunks));
        });
        QCOMPARE(table_refusal(), std::string(damaged));
    }
    void twoSetsHaveTwoTrees()
    {
        create_tables(path_, {"other", "table"}, chunk_rows);
        change([](FileBytes& bytes) {
            const std::uint64_t tree = bytes.append_tree(0, {bytes.append(QByteArray(chunk_bytes, '\0'))});
            for (int set = 0; set < 2; ++set) bytes.set_tree(tree);
        });
        const std::string sentence = refusal_when(path_, [](hid_t file) {
            for (const char* name : {"other", "table"}) hdf5::Table(file, name, columns, columns);
        });
        QCOMPARE(sentence, std::string("\"table\" cannot be read; it is damaged, or of a kind that recordings do not hold."));
    }
    void aHeapIsOfOneGroup_data()
    {
        QTest::addColumn<bool>("shared");
        QTest::newRow("two heaps") << false;
        QTest::newRow("the names of one for two") << true;
    }
    void aHeapIsOfOneGroup()
    {
        QFETCH(bool, shared);
        create_groups(path_, {"one", "two"});
        if (shared)
            change([](FileBytes& bytes) {
                std::vector<qsizetype> heaps; // of the root, of one, of what is in it, of two, of what is in it
                for (qsizetype at = bytes.all.indexOf("HEAP"); at >= 0; at = bytes.all.indexOf("HEAP", at + 1)) heaps.push_back(at);
                QCOMPARE(heaps.size(), std::size_t(5));
                bytes.all.replace(heaps[3] + 24, 8, bytes.all.mid(heaps[1] + 24, 8));
            });
        int found = 0;
        refusal_when(path_, [&](hid_t file) {
            for (const char* name : {"one", "two"}) found += hdf5::exists(hdf5::open_group(file, name).get(), "in it") ? 1 : 0;
        });
        QCOMPARE(found, shared ? 1 : 2);
    }
    /// One of 40 MB was read anew for each name that was looked for.
    void aHeapFitsWhatTheLibraryKeeps()
    {
        create_groups(path_, {"one"});
        const auto lengthen = [&](std::uint64_t size) {
            change([&](FileBytes& bytes) {
                const qsizetype heap = bytes.all.indexOf("HEAP");
                const std::uint64_t names = bytes.append(bytes.all.mid(heap + 32, 88) + QByteArray(qsizetype(size) - 88, '\0'));
                bytes.put(heap + 8, size);
                bytes.put(heap + 16, 1); // no free room
                bytes.put(heap + 24, names);
            });
        };
        const auto open = [](hid_t file) { hdf5::open_group(file, "one"); };
        lengthen(15 << 20);
        QCOMPARE(refusal_when(path_, open), std::string());
        lengthen(17 << 20);
        QCOMPARE(refusal_when(path_, open), std::string("\"one\" is missing; the recording is damaged or no recording."));
    }
    void partsOfAHeaderLieApart_data()
    {
        QTest::addColumn<quint64>("second");
        QTest::newRow("one behind the other") << quint64(32);
        QTest::newRow("one over the other") << quint64(8);
    }
    void partsOfAHeaderLieApart()
    {
        QFETCH(quint64, second);
        create_groups(path_, {"one"});
        change([&](FileBytes& bytes) {
            constexpr qsizetype head = 16, message = 24, link = 8 + 8; // in a node of the group's tree
            const qsizetype node = bytes.all.indexOf("SNOD");
            std::uint64_t old = 0;
            std::memcpy(&old, bytes.all.constData() + node + link, sizeof old);
            const QByteArray heap_and_tree = bytes.all.mid(qsizetype(old) + head, message);
            const std::uint64_t parts = bytes.append(QByteArray(64, '\0')); // messages of nothing, of 8 bytes each
            const auto at = qsizetype(
                bytes.append(QByteArray("\1\0\x0B\0\1\0\0\0\x48\0\0\0\0\0\0\0", head) + heap_and_tree + QByteArray(2 * message, '\0')));
            for (int i = 0; i < 2; ++i) {
                const qsizetype on = at + head + (1 + i) * message;
                bytes.put(on, 0x10, 2);
                bytes.put(on + 2, 16, 2);
                bytes.put(on + 8, parts + (i == 0 ? 0 : second));
                bytes.put(on + 16, 32);
            }
            bytes.put(node + link, std::uint64_t(at));
        });
        const std::string sentence = refusal_when(path_, [](hid_t file) { hdf5::open_group(file, "one"); });
        QCOMPARE(sentence.empty(), second == 32);
    }
    void textsLieInTheFile_data()
    {
        QTest::addColumn<quint64>("claimed");
        QTest::newRow("no more than it has") << quint64(500);
        QTest::newRow("300 MB") << quint64(300'000'000);
    }
    void textsLieInTheFile()
    {
        QFETCH(quint64, claimed);
        create_text(path_, std::string(500, 'x'));
        change([&](FileBytes& bytes) {
            const qsizetype type = bytes.all.indexOf(QByteArray("\x13\x10\0\0\xF4\1\0\0", 8)),
                            layout = bytes.all.indexOf(QByteArray("\3\1", 2), type);
            QVERIFY(type > 0 && layout > 0);
            bytes.put(type + 4, claimed, 4);
            bytes.put(layout + 10, claimed);
        });
        std::string text;
        const double before = peak_memory();
        const std::string sentence = refusal_when(path_, [&](hid_t file) { text = hdf5::read_text(file, "text"); });
        QVERIFY(peak_memory() - before < 50e6);
        const std::string damaged_text = "\"text\" cannot be read; it is damaged, or of a kind that recordings do not hold.";
        QCOMPARE(sentence, claimed == 500 ? std::string() : damaged_text);
        QCOMPARE(text, claimed == 500 ? std::string(500, 'x') : std::string());
    }
    void logsWhoseChangesAreInOrderAreUsed_data()
    {
        QTest::addColumn<Entries>("entries");
        QTest::addColumn<bool>("used");
        QTest::newRow("in order") << Entries{{10, "bb"}, {20, "cc"}} << true;
        QTest::newRow("up to each other and the end") << Entries{{10, "bb"}, {12, "cc"}, {998, "dd"}} << true;
        QTest::newRow("out of order") << Entries{{20, "cc"}, {10, "bb"}} << false;
        QTest::newRow("one over the other") << Entries{{10, "bb"}, {11, "cc"}} << false;
        QTest::newRow("of nothing") << Entries{{10, "bb"}, {12, ""}} << false;
        QTest::newRow("over the file's end") << Entries{{10, "bb"}, {999, "cc"}} << false;
        QTest::newRow("far behind the file's end") << Entries{{10, "bb"}, {std::uint64_t(1) << 40, "cc"}} << false;
    }
    void logsWhoseChangesAreInOrderAreUsed()
    {
        QFETCH(Entries, entries);
        QFETCH(bool, used);
        QFile file(QString::fromStdString(path_));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QByteArray(1000, 'a') + QByteArray::fromStdString(log_of(entries)));
        file.close();
        RecordingSource source(path_);
        std::string bytes(2, '\0');
        QVERIFY(source.read(10, bytes.data(), bytes.size(), hdf5::BlockKind::data));
        QCOMPARE(bytes, std::string(used ? "bb" : "aa"));
    }
    /// Each change was put over those before: 20 000 copies of 2 MB.
    void aLogIsReadOnce()
    {
        Entries entries{{std::uint64_t(1) << 40, std::string(2'000'000, 'x')}};
        entries.resize(20'000, {(std::uint64_t(1) << 40) + 1, ""});
        QFile file(QString::fromStdString(path_));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QByteArray::fromStdString(log_of(entries)));
        file.close();
        QElapsedTimer timer;
        timer.start();
        RecordingSource source(path_);
        QVERIFY(timer.elapsed() < 500);
    }
};

QTEST_GUILESS_MAIN(TestCraftedBlocks)
#include "tst_crafted_blocks.moc"
