// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Recordings of garments from strangers: whatever their objects are, they are refused with a sentence that names file and field, or summed
// up and drawn.
#include "core/base/error.h"
#include "core/run/hdf5_file.h"
#include "core/run/hdf5_reader.h"
#include "core/run/recording.h"
#include "core/run/recording_layout.h"
#include "core/wear/wear_map.h"
#include "tests/support/crafted_wear.h"
#include "tests/support/process_memory.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <hdf5.h>

#include <random>
#include <sys/resource.h>
#include <unistd.h>

using namespace hygroloom;

namespace {

/// Of a number in the layout, or of a value of a set.
struct Change {
    const char* what;
    const char* from; ///< in the layout
    const char* to;
    const char* sentence;
};
const Change in_layout[] = {
    {"a skin of 0 K", "\"skin_temperature\":307.15", "\"skin_temperature\":0", "skin_temperature is from 200 to 400 K; given is 0."},
    {"cells without a width", "\"across\":[0.008,0.0]", "\"across\":[0,0]", "a cell's sides, across and along, are from 1e-06 to 1 m long"},
    {"cells without an area", "\"across\":[0.008,0.0]", "\"across\":[0,0.008]",
     "a cell's sides, across and along, are from 1e-06 to 1 m long"},
    {"a panel larger than any", "\"ends\":4,\"picks\":3", "\"ends\":100000,\"picks\":100000",
     "panels[0]: a panel has at most 100000000 cells; given are 100000 x 100000."},
    {"an outline far off", "\"outline\":[[0.0,0.0]", "\"outline\":[[1e300,0.0]", "a place lies within 100 m; given is 1e+300, 0."},
    {"a grain that is no angle", "\"grain\":0.0", "\"grain\":1e300", "panels[0].grain: 1e+300 is no angle."},
    {"cells beyond their panel", "\"ends\":4,\"picks\":3", "\"ends\":1,\"picks\":3", "a cell lies outside its panel; it is damaged."},
};

struct SetChange {
    const char* set;
    float value;
    const char* sentence;
};
const SetChange in_sets[] = {
    {"/cells/panel", 2, "a cell is of no panel or no zone, or holds nothing; it is damaged."},
    {"/cells/zone", 13, "a cell is of no panel or no zone, or holds nothing; it is damaged."},
    {"/cells/area", 0, "a cell is of no panel or no zone, or holds nothing; it is damaged."},
    {"/cells/capacity", 1e-30F, "a cell is of no panel or no zone, or holds nothing; it is damaged."},
    {"/shape/places", 3e38F, "its shape reaches farther than 1000 m; it is damaged."},
    {"/shape/flat", -2000, "its shape reaches farther than 1000 m; it is damaged."},
    {"/shape/corners", 8, "a triangle of its shape names what does not exist; it is damaged."},
};

struct OpenFile {
    explicit OpenFile(const std::string& path) : id(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT)) {}
    ~OpenFile() { H5Fclose(id); }
    hid_t id;
};

void put_text(const std::string& path, const char* name, const std::string& from, const std::string& to)
{
    const OpenFile file(path);
    const hid_t set = H5Dopen2(file.id, name, H5P_DEFAULT), type = H5Dget_type(set);
    std::string text(H5Tget_size(type), '\0');
    H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data());
    H5Tclose(type);
    H5Dclose(set);
    const std::size_t at = text.find(from);
    QVERIFY2(at != std::string::npos, text.c_str());
    text.replace(at, from.size(), to);
    H5Ldelete(file.id, name, H5P_DEFAULT);
    const hid_t changed = H5Tcopy(H5T_C_S1), space = H5Screate(H5S_SCALAR);
    H5Tset_size(changed, text.size());
    const hid_t again = H5Dcreate2(file.id, name, changed, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Dwrite(again, changed, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data());
    H5Dclose(again);
    H5Sclose(space);
    H5Tclose(changed);
}

void put_value(const std::string& path, const char* name, float value)
{
    const OpenFile file(path);
    const hid_t set = H5Dopen2(file.id, name, H5P_DEFAULT), space = H5Dget_space(set);
    std::vector<float> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    H5Dread(set, H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    values[0] = value;
    H5Dwrite(set, H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Sclose(space);
    H5Dclose(set);
}

/// Takes no room on the disk.
void put_long_text(const std::string& path, const char* name, std::size_t size)
{
    const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    const hid_t type = H5Tcopy(H5T_C_S1), space = H5Screate(H5S_SCALAR), properties = H5Pcreate(H5P_DATASET_CREATE);
    H5Tset_size(type, size);
    H5Pset_alloc_time(properties, H5D_ALLOC_TIME_EARLY);
    H5Pset_fill_time(properties, H5D_FILL_TIME_NEVER);
    H5Dclose(H5Dcreate2(file, name, type, space, H5P_DEFAULT, properties, H5P_DEFAULT));
    H5Pclose(properties);
    H5Sclose(space);
    H5Tclose(type);
    H5Fclose(file);
}

/// The rows take no room on the disk.
void put_long_ledger(const std::string& path, hsize_t rows)
{
    const OpenFile file(path);
    const hsize_t sizes[2] = {rows, std::size(ledger_columns)};
    const hid_t space = H5Screate_simple(2, sizes, nullptr), properties = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_alloc_time(properties, H5D_ALLOC_TIME_EARLY);
    H5Pset_fill_time(properties, H5D_FILL_TIME_NEVER);
    H5Ldelete(file.id, "ledger", H5P_DEFAULT);
    H5Dclose(H5Dcreate2(file.id, "ledger", H5T_IEEE_F64LE, space, H5P_DEFAULT, properties, H5P_DEFAULT));
    H5Pclose(properties);
    H5Sclose(space);
}

/// Of the process, bytes.
rlim_t taken_addresses()
{
    QFile sizes("/proc/self/statm");
    return sizes.open(QIODevice::ReadOnly) ? sizes.readAll().split(' ')[0].toULongLong() * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE)) : 0;
}

} // namespace

class TestCraftedWear : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;
    std::string valid_, crafted_;

    void restore() const
    {
        QFile::remove(QString::fromStdString(crafted_));
        QVERIFY(QFile::copy(QString::fromStdString(valid_), QString::fromStdString(crafted_)));
    }
    /// The sentence of the refusal; empty: all was read.
    std::string refusal() const
    {
        try {
            use_wear_recording(crafted_, folder_.path().toStdString());
            return {};
        } catch (const FileError& error) {
            return error.what();
        }
    }

private Q_SLOTS:
    void initTestCase()
    {
        valid_ = folder_.filePath("valid.hygrorec").toStdString();
        crafted_ = folder_.filePath("crafted.hygrorec").toStdString();
        write_small_wear_recording(valid_);
        restore();
        QCOMPARE(refusal(), std::string());
        QVERIFY(QFile::exists(folder_.filePath("cells.vtp")));
    }
    void eachIsRefusedByNameOrUsed()
    {
        int refused = 0;
        for (unsigned seed = 0; seed < 300; ++seed) {
            std::mt19937 random(seed);
            std::vector<std::uint8_t> bytes(3 + random() % 5);
            for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
            restore();
            const std::string did = craft(crafted_, {bytes.data(), bytes.size()}, targets_of_a_garment());
            const std::string sentence = refusal();
            refused += sentence.empty() ? 0 : 1;
            QVERIFY2(sentence.empty() || sentence.starts_with(crafted_ + ": "), (did + " -> " + sentence).c_str());
        }
        qInfo("%d of 300 are refused", refused);
        QVERIFY(refused > 100 && refused < 295); // and what only changes a number is used
    }
    void numbersOfTheLayoutHaveBounds()
    {
        for (const Change& change : in_layout) {
            restore();
            put_text(crafted_, "/layout", change.from, change.to);
            const std::string sentence = refusal();
            QVERIFY2(sentence.starts_with(crafted_ + ": ") && sentence.find(change.sentence) != std::string::npos,
                     (std::string(change.what) + ": " + sentence).c_str());
        }
    }
    void numbersOfCellsAndShapeHaveBounds()
    {
        for (const SetChange& change : in_sets) {
            restore();
            put_value(crafted_, change.set, change.value);
            QCOMPARE(refusal(), crafted_ + ": " + change.sentence);
        }
    }
    void namesDoNotBreakTheTable()
    {
        WearRecord record = small_wear();
        record.layout.panels[0].name = "front, \"left\"";
        const std::string csv = wear_csv(record.layout, small_wear_frame(record.layout, 1));
        QVERIFY(csv.find("\n\"front, \"\"left\"\"\",0,0,") != std::string::npos);
        QVERIFY(csv.find("\nsleeve,0,0,") != std::string::npos);
    }
    /// Packed zeros take no room in the file, but would in memory.
    void aShapeIsNotLargerThanItsFileCanBe()
    {
        restore();
        {
            const OpenFile file(crafted_);
            hdf5::write_number(hdf5::open_group(file.id, "shape").get(), "vertices", 4e6);
        }
        const QString sentence = QString::fromStdString(refusal());
        QVERIFY2(sentence.contains("its shape of 4000000 vertices") && sentence.contains("too large for the file"), qPrintable(sentence));
    }
    /// Its rows would take 450 MB, which are a hole in the file.
    void rowsWithoutFramesAreNotRead()
    {
        restore();
        constexpr hsize_t rows = 4'000'000;
        put_long_ledger(crafted_, rows);
        const double before = peak_memory();
        QCOMPARE(refusal(), crafted_ + ": frame 3: \"frames/000003\" is missing; the recording is damaged or no recording.");
        QVERIFY(peak_memory() - before < 100e6);
    }
    /// Of a recording with a text of 400 MB that holds nothing, in a process that may take 200 MB more.
    void tooLittleMemoryIsSaid()
    {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
        QSKIP("a sanitizer ends the process instead");
#endif
        put_long_text(crafted_, "format", 400'000'000);
        rlimit whole{};
        QCOMPARE(getrlimit(RLIMIT_AS, &whole), 0);
        const rlimit little{taken_addresses() + 200'000'000, whole.rlim_max};
        QCOMPARE(setrlimit(RLIMIT_AS, &little), 0);
        std::string wear, sample;
        bool is_one = true;
        try {
            is_one = WearRecording::is_one(crafted_);
            wear = refusal();
            Recording recording(crafted_);
        } catch (const std::exception& error) {
            sample = error.what();
        }
        setrlimit(RLIMIT_AS, &whole);
        QVERIFY(!is_one);
        QCOMPARE(wear, crafted_ + ": the memory does not suffice to read it.");
        QCOMPARE(sample, wear);
    }
};

QTEST_GUILESS_MAIN(TestCraftedWear)
#include "tst_crafted_wear.moc"
