// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Frames that are kept as changes read back as they were, whichever is asked for first, take little room, and can be damaged.
#include "core/base/error.h"
#include "core/run/frame_changes.h"
#include "core/run/recording.h"
#include "core/solver/backend.h"
#include "tests/support/crafted_recording.h"
#include "tests/support/drop_design.h"

#include <fmt/format.h>

#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <random>

using namespace hygroloom;

namespace tst_frame_changes {
namespace {

/// A drop on 40 x 40 mm in bundles of two, or sweat under 20 x 20 mm: 9800 segments.
RunRecord record(const std::string& path, double bundles, std::vector<Frame>* frames = nullptr)
{
    Design design = drop_design(35, 1);
    Experiment& experiment = design.experiments[0];
    experiment.closure = Closure::pores;
    experiment.sample_mm = {40, 40};
    if (bundles == 1) {
        experiment.type = ExperimentType::sweat;
        experiment.droplets.clear();
        experiment.rate_g_m2_h = 1000;
        experiment.duration_s = 10;
        experiment.sample_mm = {20, 20};
    }
    RunOptions options;
    options.fidelity = Fidelity::live;
    options.knobs = {{"crossings_per_cell", bundles}};
    options.recording = path;
    RunControl control;
    RunCallbacks callbacks;
    callbacks.frame = [&](std::shared_ptr<const Frame> frame) {
        if (frames) frames->push_back(*frame);
    };
    return run_experiment(design, "cloth", "drop", options, *make_cpu_backend(), control, callbacks);
}

bool are_alike(const Frame& a, const Frame& b)
{
    return std::all_of(std::begin(frame_fields), std::end(frame_fields),
                       [&](const FrameField& field) { return field.in(a) == field.in(b); });
}

/// Values that a run could show, of which one in a hundred moves.
void move(Frame& frame, std::mt19937& random)
{
    std::uniform_int_distribution<std::size_t> place(0, frame.saturation.size() - 1);
    std::uniform_real_distribution<float> share(0, 1);
    for (std::size_t k = 0; k < frame.saturation.size() / 100; ++k)
        for (const FrameField& field : frame_fields)
            field.in(frame)[place(random)] = share(random) * (field.step > 0.001F ? 300.0F : 1e-6F);
    frame.round_fields();
}

/// Writes one number of a frame's changes of saturation.
void put_change(const std::string& path, int frame, std::uint32_t number)
{
    const RunFileReader file(path);
    std::vector<std::uint32_t> changes = file.row(frame, {"saturation"}).counts("saturation", 9800);
    changes[7] = number;
    NumberPacker packer;
    const Database database(path, Database::Access::write);
    database.statement("UPDATE frames SET saturation=?1 WHERE number=?2")
        .bind_bytes(1, packer.packed(std::span<const std::uint32_t>(changes)))
        .bind(2, std::int64_t{frame})
        .run();
    database.become_one_file();
}

} // namespace

class TestFrameChanges : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;
    RunRecord run_;
    std::vector<Frame> start_; ///< of single yarns

    std::string at(const char* name) const { return folder_.filePath(name).toStdString(); }
    /// 30 frames, a second apart.
    std::vector<Frame> write(const std::string& path) const
    {
        std::vector<Frame> frames;
        std::mt19937 random(7);
        Frame frame = start_.front();
        RecordingWriter writer(path, run_);
        for (int k = 0; k < 30; ++k) {
            frame.time = frame.ledger.time = k;
            writer.append(frame);
            frames.push_back(frame);
            move(frame, random);
        }
        writer.finish(0);
        return frames;
    }
    QString complaint(const std::string& path, int frame) const
    {
        try {
            Recording(path).frame(frame);
        } catch (const FileError& error) {
            return QString(error.what()).remove(QString::fromStdString(path) + ": ");
        }
        return {};
    }

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(folder_.isValid());
        run_ = record(at("yarns.hygrorec"), 1, &start_);
    }
    void codesGiveTheirValuesAndNoOthers()
    {
        const ValueCodes steps{1.0F / 512, 0}, bits{0, 13};
        QCOMPARE(*steps.of(293.5F), 293 * 512 + 256);
        QCOMPARE(steps.value(293 * 512 + 256), 293.5F);
        QCOMPARE(bits.value(*bits.of(0.375F)), 0.375F);
        QCOMPARE(*bits.of(0.0F), 0);
        for (float value :
             {293.5001F, -1.0F, -0.0F, 1e30F, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()})
            QVERIFY2(!steps.of(value), std::to_string(value).c_str());
        for (float value : {1.0001F, -1.0F, -0.0F, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()})
            QVERIFY2(!bits.of(value), std::to_string(value).c_str());
        QCOMPARE(steps.most(), std::int64_t{1} << 24);
        QVERIFY(bits.most() == (0x7f800000 >> 11) - 1 && std::isfinite(bits.value(static_cast<std::int32_t>(bits.most()))));
        for (const FrameField& field : frame_fields) {
            const ValueCodes how = field.bits > 0 ? ValueCodes{0, field.bits} : ValueCodes{field.step, 0};
            for (float value : {0.0F, 3.7e-12F, 0.0851F, 0.99999F, 293.1537F}) {
                const float shown = rounded(field, value);
                QVERIFY2(how.of(shown) && how.value(*how.of(shown)) == shown, field.name);
            }
        }
    }
    void framesReadBackAsTheyWereInAnyOrder()
    {
        const std::vector<Frame> frames = write(at("any.hygrorec"));
        const Recording recording(at("any.hygrorec"));
        QCOMPARE(recording.frames(), 30);
        for (int i : {29, 0, 5, 6, 7, 3, 15, 16, 17, 23, 24, 28, 1})
            QVERIFY2(are_alike(recording.frame(i), frames[static_cast<std::size_t>(i)]), std::to_string(i).c_str());
        const FrameField one[] = {frame_fields[1]};
        QVERIFY(recording.frame(20, one).liquid == frames[20].liquid && recording.frame(20, one).saturation.empty());
        int number = 0;
        Recording(at("any.hygrorec")).read_frames([&](const Frame& frame) {
            return are_alike(frame, frames[static_cast<std::size_t>(number++)]);
        });
        QCOMPARE(number, 30);
    }
    void valuesThatNoRunShowsAreKeptWhole()
    {
        std::vector<Frame> frames(5, start_.back());
        frames[2].temperature[100] = 293.123456F;
        frames[3].saturation[5] = -1;
        RecordingWriter writer(at("odd.hygrorec"), run_);
        for (std::size_t k = 0; k < frames.size(); ++k) {
            frames[k].time = frames[k].ledger.time = static_cast<double>(k);
            writer.append(frames[k]);
        }
        writer.finish(0);
        const Recording recording(at("odd.hygrorec"));
        for (int i : {0, 1, 2, 3, 4})
            QVERIFY2(are_alike(recording.frame(i), frames[static_cast<std::size_t>(i)]), std::to_string(i).c_str());
    }
    /// Where all frames hold values, 5.8 bytes of bundles and 13.1 of yarns.
    void aFrameTakesFewBytesForEachCrossing_data()
    {
        QTest::addColumn<double>("bundles");
        QTest::addColumn<double>("most");
        QTest::newRow("bundles") << 2.0 << 3.5;
        QTest::newRow("yarns") << 1.0 << 7.0;
    }
    void aFrameTakesFewBytesForEachCrossing()
    {
        QFETCH(double, bundles);
        QFETCH(double, most);
        const std::string path = at("small.hygrorec");
        std::vector<Frame> frames;
        record(path, bundles, &frames);
        const Recording recording(path);
        QCOMPARE(recording.frames(), int(frames.size()));
        for (int i = 0; i < recording.frames(); ++i) QVERIFY(are_alike(recording.frame(i), frames[static_cast<std::size_t>(i)]));
        const double crossings = static_cast<double>(recording.run().textile.segments()) / 2 / (bundles * bundles),
                     bytes = static_cast<double>(QFileInfo(QString::fromStdString(path)).size()) / recording.frames() / crossings;
        QVERIFY2(bytes < most, std::to_string(bytes).c_str());
    }
    void theLedgerIsKeptAsItWas()
    {
        const std::vector<Frame> frames = write(at("ledger.hygrorec"));
        const Recording recording(at("ledger.hygrorec"));
        for (std::size_t i = 0; i < frames.size(); ++i)
            for (const LedgerColumn& column : ledger_columns)
                QCOMPARE(recording.ledgers()[i].*column.value, frames[i].ledger.*column.value);
    }
    void aDamagedFrameTakesThoseThatFollowFromIt()
    {
        const std::string path = at("damaged.hygrorec");
        const std::vector<Frame> frames = write(path);
        QVERIFY(craft_by_sql(path, "UPDATE frames SET follows=NULL, saturation=NULL WHERE number=3"));
        QCOMPARE(complaint(path, 5),
                 QString("Frame 5 cannot be read: \"frames/000003/saturation\" is missing; the recording is damaged or no recording."));
        QVERIFY(are_alike(Recording(path).frame(2), frames[2]) && are_alike(Recording(path).frame(16), frames[16]));
        Recording recording(path);
        int read = 0;
        recording.read_frames([&](const Frame&) { return ++read > 0; });
        QCOMPARE(read, 30 - 13); // 3 to 15
        QCOMPARE(int(recording.problems().size()), 13);
    }
    void aChangeThatLeadsToNoValueIsRefused()
    {
        const std::string path = at("endless.hygrorec");
        write(path);
        for (const std::uint32_t number : {3U, 0x7fffffffU, 0xffffffffU}) {
            put_change(path, 2, number);
            QCOMPARE(complaint(path, 2), QString("Frame 2 cannot be read: \"saturation\" changes to what is no value."));
        }
    }
    void whatIsReadInOnePieceIsKeptSo()
    {
        constexpr std::size_t most = 4 << 20;
        QVERIFY(keeps_changes(most, false) && !keeps_changes(most + 1, false) && !keeps_changes(most, true) && !keeps_changes(4095, false));
    }
    void framesThatLeadTooFarBackAreRefused()
    {
        const std::string path = at("far.hygrorec");
        std::vector<Frame> frames(1, start_.front());
        {
            RecordingWriter writer(path, run_);
            for (int k = 0; k < 80; ++k) {
                frames[0].time = frames[0].ledger.time = k;
                writer.append(frames[0]);
            }
            writer.finish(0);
        }
        for (const FrameField& field : frame_fields)
            QVERIFY(craft_by_sql(path, fmt::format("UPDATE frames SET follows=1, {0}=(SELECT {0} FROM frames WHERE number=1) "
                                                   "WHERE number>0 AND number%16=0",
                                                   field.name)));
        Recording recording(path);
        for (int k = 0; k <= 64; ++k) QVERIFY(are_alike(recording.frame(k), frames[0]));
        QVERIFY_THROWS_EXCEPTION(Error, recording.frame(65)); // though the one before was found
        QCOMPARE(complaint(path, 70),
                 QString("Frame 70 cannot be read: the frames from which its \"saturation\" follows lead too far back."));
    }
    void otherFormsOfChangesAreRefused_data()
    {
        QTest::addColumn<QString>("of");
        QTest::addColumn<double>("number");
        QTest::newRow("no step") << "changes/temperature" << 0.3;
        QTest::newRow("no bits") << "changes/liquid" << 24.0;
        QTest::newRow("no neighbour") << "changes/back" << 0.0;
        QTest::newRow("no answer") << "in_bundles" << 2.0;
    }
    void otherFormsOfChangesAreRefused()
    {
        QFETCH(QString, of);
        QFETCH(double, number);
        const std::string path = at("form.hygrorec");
        write(path);
        QVERIFY(craft_by_sql(path, fmt::format("UPDATE meta SET value={} WHERE name='{}'", number, of.toStdString())));
        QVERIFY_EXCEPTION_THROWN(Recording{path}, FileError);
    }
    void smallRecordingsHoldValuesAlone()
    {
        Design design = drop_design(35, 0.02);
        RunOptions options;
        options.fidelity = Fidelity::draft;
        options.recording = at("plain.hygrorec");
        RunControl control;
        run_experiment(design, "cloth", "drop", options, *make_cpu_backend(), control, {});
        const RunFileReader file(at("plain.hygrorec"));
        const StoredRow row = file.row(1, {follows_column, "saturation"});
        QVERIFY(!file.has("changes/back") && !row.has(follows_column) && row.has("saturation"));
    }
};

} // namespace tst_frame_changes

QTEST_GUILESS_MAIN(tst_frame_changes::TestFrameChanges)
#include "tst_frame_changes.moc"
