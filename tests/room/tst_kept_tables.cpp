// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Rooms that were found stay on the disk for the next program. What is read back from a file is what was found, to the bit.
#include "core/plan/expectation.h"
#include "core/room/kept_tables.h"
#include "core/run/plan_run.h"
#include "tests/room/square_cotton.h"
#include "tests/support/drop_design.h"

#include <QDirIterator>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace hygroloom;

namespace {

constexpr int voxels = 8;

QStringList files_in(const QString& folder)
{
    QStringList found;
    for (QDirIterator each(folder, QDir::Files); each.hasNext();) found << each.next();
    return found;
}

std::vector<double> numbers_of(const RoomTables& tables)
{
    std::vector<double> all{tables.falls_along_warp, tables.falls_along_weft, tables.level_along_warp, tables.level_along_weft,
                            tables.growth,           double(tables.ends),     double(tables.picks)};
    for (const DrawnRoom& room : tables.types) {
        all.insert(all.end(), {room.warp_skin, room.weft_skin, room.faces, room.along_warp, room.along_weft});
        const RoomStates& states = room.states;
        for (const RestingState& state : {states.almost, states.sunk, states.knee, states.low, states.fills, states.breaks})
            all.insert(all.end(), {state.curvature, state.warp, state.weft});
    }
    all.insert(all.end(), tables.warp_places.begin(), tables.warp_places.end());
    all.insert(all.end(), tables.weft_places.begin(), tables.weft_places.end());
    return all;
}

} // namespace

class TestKeptTables : public QObject {
    Q_OBJECT
    QTemporaryDir home_;
    QString folder_;
    void next_program() { keep_tables_in(folder_.toStdString()); } // the memory of the last is gone

private Q_SLOTS:
    void init() { folder_ = home_.filePath(QString(QTest::currentTestFunction())); }
    void cleanup() { keep_tables_in({}); }

    void nothingIsWrittenUnlessAsked()
    {
        keep_tables_in({});
        const Textile textile = square_cotton("twill 2/1 Z");
        room_tables(textile, voxels);
        QVERIFY(!room_tables_are_kept(textile, voxels));
        QVERIFY(!QFile::exists(folder_));
    }
    void theNextProgramReadsWhatWasFound()
    {
        const Textile textile = square_cotton("twill 2/1 Z");
        next_program();
        QVERIFY(!room_tables_are_kept(textile, voxels));
        const std::vector<double> found = numbers_of(*room_tables(textile, voxels));
        QVERIFY(room_tables_are_kept(textile, voxels));
        QCOMPARE(files_in(folder_).size(), 1);
        next_program();
        QCOMPARE(numbers_of(*room_tables(textile, voxels)), found);
    }
    /// The file is what is read: that of another cloth in its place comes back.
    void theFileIsWhatIsRead()
    {
        const Textile textile = square_cotton("twill 2/1 Z");
        next_program();
        const std::vector<double> found = numbers_of(*room_tables(textile, voxels));
        const QString file = files_in(folder_).value(0);
        const std::vector<double> other = numbers_of(*room_tables(square_cotton("twill 1/2 S", {.threads_per_cm = 20}), voxels));
        for (const QString& each : files_in(folder_))
            if (each != file) QVERIFY(QFile::remove(file) && QFile::copy(each, file));
        next_program();
        QVERIFY(other != found);
        QCOMPARE(numbers_of(*room_tables(textile, voxels)), other);
    }
    void tablesThatNoClothHasAreNotTaken_data()
    {
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::newRow("as it is, with places that are not a number")
            << QByteArray("\"warp_places\":[") << QByteArray("\"warp_places\":[null,");
        QTest::newRow("less than no picks") << QByteArray("\"picks\":") << QByteArray("\"picks\":-");
        QTest::newRow("other ends") << QByteArray("\"ends\":") << QByteArray("\"ends\":1");
        QTest::newRow("another type") << QByteArray("{\"types\":[") << QByteArray("{\"types\":[[],");
        QTest::newRow("huge") << QByteArray("\"numbers\":[") << QByteArray("\"numbers\":[1e300,");
        QTest::newRow("falls too steeply") << QByteArray("\"numbers\":[") << QByteArray("\"numbers\":[5,");
    }
    /// Though the file's digest is right.
    void tablesThatNoClothHasAreNotTaken()
    {
        QFETCH(const QByteArray, from);
        QFETCH(const QByteArray, to);
        const Textile textile = square_cotton("plain");
        folder_ += QTest::currentDataTag();
        next_program();
        const std::vector<double> found = numbers_of(*room_tables(textile, voxels));
        QFile file(files_in(folder_).value(0));
        QVERIFY(file.open(QFile::ReadOnly));
        QByteArray text = file.readAll().mid(16);
        file.close();
        QVERIFY(text.contains(from));
        text.replace(from, to);
        std::uint64_t digest = 0xcbf29ce484222325U;
        for (const char byte : text) digest = (digest ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
        QVERIFY(file.open(QFile::WriteOnly));
        file.write(QByteArray::number(qulonglong(digest), 16).rightJustified(16, '0') + text);
        file.close();
        next_program();
        QCOMPARE(numbers_of(*room_tables(textile, voxels)), found);
    }
    void anotherClothOrFinenessIsAnotherFile()
    {
        next_program();
        room_tables(square_cotton("twill 2/1 Z"), voxels);
        QVERIFY(!room_tables_are_kept(square_cotton("twill 1/2 Z"), voxels));
        QVERIFY(!room_tables_are_kept(square_cotton("twill 2/1 Z"), voxels + 1));
        room_tables(square_cotton("twill 1/2 Z"), voxels);
        room_tables(square_cotton("twill 2/1 Z"), voxels + 1);
        QCOMPARE(files_in(folder_).size(), 3);
    }
    void aDamagedFileIsFoundAgain_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("nothing") << QByteArray();
        QTest::newRow("no JSON") << QByteArray("room");
        QTest::newRow("no tables") << QByteArray("{}");
        QTest::newRow("no digest") << QByteArray(
            R"({"types":[],"numbers":[1,1,1,1,0],"ends":0,"picks":0,"warp_places":[],"weft_places":[]})");
        QTest::newRow("a digest of other bytes") << QByteArray(R"(0123456789abcdef{"types":[],"numbers":[1,1,1,1,0]})");
    }
    void aDamagedFileIsFoundAgain()
    {
        QFETCH(const QByteArray, bytes);
        const Textile textile = square_cotton("plain");
        next_program();
        const std::vector<double> found = numbers_of(*room_tables(textile, voxels));
        QFile file(files_in(folder_).value(0));
        QVERIFY(file.open(QFile::WriteOnly));
        file.write(bytes);
        file.close();
        next_program();
        QCOMPARE(numbers_of(*room_tables(textile, voxels)), found);
        next_program();
        QCOMPARE(numbers_of(*room_tables(textile, voxels)), found);
        QFile again(files_in(folder_).value(0));
        QVERIFY(again.size() > bytes.size());
    }
    void aFolderThatCannotBeWrittenChangesNothing()
    {
        const Textile textile = square_cotton("plain");
        keep_tables_in("/dev/null/rooms");
        const std::vector<double> found = numbers_of(*room_tables(textile, voxels));
        keep_tables_in({});
        QCOMPARE(numbers_of(*room_tables(textile, voxels)), found);
    }
    void estimatesKnowThatARoomNeedNotBeFoundAgain()
    {
        Design design = drop_design();
        design.experiments[0].closure = Closure::pores;
        const auto plan = [&] { return plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::standard); };
        next_program();
        const ModelPlan before = plan();
        QVERIFY(before.counts.drawn_periods > 0);
        room_tables(build_textile(design, design.fabrics[0], {0, 0, 20, 20}), static_cast<int>(before.knobs.room_voxels));
        const ModelPlan after = plan();
        QCOMPARE(after.counts.drawn_periods, 0.0);
        QVERIFY(set_up_seconds(after, "cpu") < set_up_seconds(before, "cpu"));
        QCOMPARE(after.expected_bytes, before.expected_bytes);
    }
};

QTEST_APPLESS_MAIN(TestKeptTables)
#include "tst_kept_tables.moc"
