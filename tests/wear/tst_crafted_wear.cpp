// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Recordings of garments from strangers: whatever their objects are, they are refused with a sentence that names file and field, or summed
// up and drawn.
#include "core/base/error.h"
#include "core/run/recording.h"
#include "core/run/run_file.h"
#include "core/wear/wear_map.h"
#include "tests/support/crafted_wear.h"
#include "tests/support/process_memory.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

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
    {"cells/panel", 2, "a cell is of no panel or no zone, or holds nothing; it is damaged."},
    {"cells/zone", 13, "a cell is of no panel or no zone, or holds nothing; it is damaged."},
    {"cells/area", 0, "a cell is of no panel or no zone, or holds nothing; it is damaged."},
    {"cells/capacity", 1e-30F, "a cell is of no panel or no zone, or holds nothing; it is damaged."},
    {"shape/places", 3e38F, "its shape reaches farther than 1000 m; it is damaged."},
    {"shape/flat", -2000, "its shape reaches farther than 1000 m; it is damaged."},
    {"shape/corners", 8, "a triangle of its shape names what does not exist; it is damaged."},
};

/// Instead of the first of a field's numbers.
void put_value(const std::string& path, const char* name, float value)
{
    const Database database(path, Database::Access::write);
    Statement found = database.statement("SELECT value FROM meta WHERE name=?1");
    QVERIFY(found.bind_text(1, name).step());
    std::vector<float> values = unpacked<float>(found.bytes(0));
    found = database.statement("UPDATE meta SET value=?1 WHERE name=?2");
    values[0] = value;
    NumberPacker packer;
    found.bind_bytes(1, packer.packed(std::span<const float>(values))).bind_text(2, name).run();
    database.become_one_file();
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
            QVERIFY2(std::string(RunFileReader(crafted_).text("layout")).find(change.from) != std::string::npos, change.what);
            QVERIFY(craft_by_sql(crafted_, std::string("UPDATE meta SET value=replace(value,'") + change.from + "','" + change.to +
                                               "') WHERE name='layout'"));
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
        QVERIFY(craft_by_sql(crafted_, "UPDATE meta SET value=4e6 WHERE name='shape/vertices'"));
        const QString sentence = QString::fromStdString(refusal());
        QVERIFY2(sentence.contains("its shape of 4000000 vertices") && sentence.contains("too large for the file"), qPrintable(sentence));
    }
    void framesWithoutCellsAreNamed()
    {
        restore();
        QVERIFY(craft_by_sql(crafted_, "INSERT INTO frames(number,time_s) VALUES(3,10)"));
        QCOMPARE(WearRecording(crafted_).frames(), 3); // one without a ledger is left out
        restore();
        QVERIFY(craft_by_sql(crafted_, "UPDATE frames SET inside=NULL WHERE number=2"));
        QCOMPARE(refusal(), crafted_ + ": frame 2: \"frames/000002/inside\" is missing; the recording is damaged or no recording.");
    }
    /// Of a recording with a text of 100 MB, in a process that may take 50 MB more.
    void tooLittleMemoryIsSaid()
    {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
        QSKIP("a sanitizer ends the process instead");
#endif
        restore();
        QVERIFY(craft_by_sql(crafted_, "UPDATE meta SET value=replace(hex(zeroblob(50000000)),'0','a') WHERE name='format'"));
        rlimit whole{};
        QCOMPARE(getrlimit(RLIMIT_AS, &whole), 0);
        const rlimit little{taken_addresses() + 50'000'000, whole.rlim_max};
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
