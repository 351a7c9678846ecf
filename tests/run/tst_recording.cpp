// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Recordings: what is written is read back, a cut one reads to its last frame, and anything else is refused with a sentence.
#include "core/base/error.h"
#include "core/run/recording.h"
#include "core/run/run_file.h"
#include "core/scene/liquid_points.h"
#include "core/solver/backend.h"
#include "tests/support/crafted_recording.h"
#include "tests/support/drop_design.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <csignal>
#include <sys/wait.h>
#include <unistd.h>

using namespace hygroloom;

namespace {

RunRecord record_run(const std::string& path, double duration, std::vector<Frame>* frames = nullptr, int particles = 200)
{
    RunOptions options;
    options.fidelity = Fidelity::draft;
    options.knobs = {{"fibre_shells", 4}, {"particles_per_droplet", particles}};
    options.recording = path;
    RunControl control;
    RunCallbacks callbacks;
    callbacks.frame = [&](std::shared_ptr<const Frame> frame) {
        if (frames) frames->push_back(*frame);
    };
    const auto backend = make_cpu_backend();
    return run_experiment(drop_design(35, duration), "cloth", "drop", options, *backend, control, callbacks);
}

QByteArray bytes_of(const std::string& path)
{
    QFile file(QString::fromStdString(path));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class TestRecording : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;
    std::string at(const char* name) const { return folder_.filePath(name).toStdString(); }

private Q_SLOTS:
    void framesReadBackAsTheyWere()
    {
        std::vector<Frame> frames;
        const RunRecord run = record_run(at("whole.hygrorec"), 0.05, &frames);
        const Recording recording(at("whole.hygrorec"));
        QVERIFY(recording.finished());
        QCOMPARE(recording.frames(), int(frames.size()));
        QCOMPARE(recording.run().fabric, std::string("cloth"));
        QCOMPARE(recording.run().plan.segments, run.plan.segments);
        QVERIFY(recording.run().plan.knobs == run.plan.knobs);
        QCOMPARE(recording.run().plan.knobs.fibre_shells, 4.0);
        QCOMPARE(recording.run().wall, run.wall);
        for (int i : {0, int(frames.size()) / 2, int(frames.size()) - 1}) {
            const Frame frame = recording.frame(i);
            const Frame& was = frames[static_cast<std::size_t>(i)];
            QCOMPARE(frame.time, was.time);
            QCOMPARE(frame.saturation, was.saturation);
            QCOMPARE(frame.liquid, was.liquid);
            QCOMPARE(frame.temperature, was.temperature);
            QVERIFY(frame.positions == was.positions);
            QCOMPARE(frame.ledger.water_free, was.ledger.water_free);
        }
    }
    void aRunShowsRoundedValues()
    {
        for (const FrameField& field : frame_fields)
            for (float value : {0.0F, 1e-30F, 3.7e-12F, 0.0851F, 0.99999F, 293.1537F}) {
                const float shown = rounded(field, value);
                const float half_bit = field.bits > 0 ? value / static_cast<float>(1 << field.bits) : 0.0F;
                QVERIFY2(std::abs(shown - value) <= field.step / 2 + half_bit, field.name);
                QCOMPARE(rounded(field, shown), shown);
            }
        std::vector<Frame> frames;
        record_run(at("rounded.hygrorec"), 0.05, &frames);
        QVERIFY(frames.back().saturation != frames.front().saturation);
        for (const FrameField& field : frame_fields)
            for (float value : field.in(frames.back())) QCOMPARE(rounded(field, value), value);
    }
    void bundlesReadBackAsTheYarnsThatTheyStandFor()
    {
        Design design = drop_design(35, 0.02);
        design.experiments[0].closure = Closure::pores;
        RunOptions options;
        options.fidelity = Fidelity::live;
        options.recording = at("bundles.hygrorec");
        std::vector<Frame> frames;
        RunControl control;
        RunCallbacks callbacks;
        callbacks.frame = [&](std::shared_ptr<const Frame> frame) { frames.push_back(*frame); };
        const RunRecord run = run_experiment(design, "cloth", "drop", options, *make_cpu_backend(), control, callbacks);
        QVERIFY(run.plan.crossings_per_cell > 1);
        const Recording recording(at("bundles.hygrorec"));
        QCOMPARE(recording.frames(), int(frames.size()));
        QVERIFY(frames.back().ledger.water_liquid > 0.1 * frames.back().ledger.water_delivered);
        for (int i = 0; i < recording.frames(); ++i) {
            const Frame frame = recording.frame(i);
            const Frame& was = frames[static_cast<std::size_t>(i)];
            for (const FrameField& field : frame_fields) QVERIFY2(field.in(frame) == field.in(was), field.name);
            QVERIFY(frame.water_top == was.water_top && frame.water_bottom == was.water_bottom);
            QCOMPARE(frame.caps.size(), was.caps.size());
        }
        const FrameField one[] = {frame_fields[1]};
        QVERIFY(recording.frame(1, one).liquid == frames[1].liquid && recording.frame(1, one).saturation.empty());
    }
    void capsReadBackAndAreDrawn()
    {
        std::vector<Frame> frames;
        const RunRecord run = record_run(at("caps.hygrorec"), 0.02, &frames);
        Frame frame = frames.back();
        QVERIFY(liquid_points(frame) == frame.positions);
        frame.caps = {{1e-3, -2e-3, 1.5e-3, 3e-4, 1e-3, 4e-9}, {0, 0, 0, 3e-4, 4e-3, 8e-9}}; // one stands, one falls
        RecordingWriter writer(at("caps.hygrorec"), run);
        writer.append(frame);
        writer.finish(0);
        const Frame read = Recording(at("caps.hygrorec")).frame(0);
        QCOMPARE(read.caps.size(), std::size_t(2));
        for (double FrameCap::*value : {&FrameCap::x, &FrameCap::y, &FrameCap::base, &FrameCap::face, &FrameCap::height, &FrameCap::volume})
            for (std::size_t k : {0, 1}) QCOMPARE(read.caps[k].*value, double(float(frame.caps[k].*value)));
        const auto points = liquid_points(read);
        QVERIFY(points.size() > 1000 && points.size() < 4000);
        for (const auto& p : points) { // in one of the two, over the face
            const double standing = std::hypot(double(p[0]) - 1e-3, double(p[1]) + 2e-3), falling = std::hypot(double(p[0]), double(p[1]));
            QVERIFY(p[2] >= 3e-4f && (standing < 1.6e-3 || falling < 1.3e-3));
        }
        frame.caps = {{0, 0, 1e6, 0, 1e-30, 1e-30}, {0, 0, 0, 0, 1e30, 1e-30}, {0, 0, -1, 0, -1, -1}}; // of a stranger's file
        QVERIFY(liquid_points(frame).size() < 500000);
    }
    void linesWhoseSuctionsWereNotFoundAreNotedWhereThereAreAny()
    {
        std::vector<Frame> frames;
        const RunRecord run = record_run(at("unsolved.hygrorec"), 0.02, &frames);
        QCOMPARE(Recording(at("unsolved.hygrorec")).run().unsolved_lines, 0.0);
        for (double unsolved : {0.0, 3.0}) {
            RecordingWriter writer(at("noted.hygrorec"), run);
            frames[0].unsolved_lines = unsolved;
            writer.append(frames[0]);
            writer.finish(0);
            QCOMPARE(RunFileReader(at("noted.hygrorec")).has("provenance/unsolved_lines"), unsolved > 0);
            QCOMPARE(Recording(at("noted.hygrorec")).run().unsolved_lines, unsolved);
        }
    }
    void aRecordingMadeBeforeAFieldOfItsFramesStillOpens()
    {
        record_run(at("older.hygrorec"), 0.02);
        const Recording recording(at("older.hygrorec"));
        const FrameField newer[] = {{"liquid", &Frame::liquid, "kg", true},
                                    {"water_between_yarns", &Frame::saturation, "kg", true, nullptr, 0.25F}};
        const Frame frame = recording.frame(recording.frames() - 1, newer);
        QCOMPARE(frame.saturation, std::vector<float>(std::size_t(recording.run().textile.segments()), 0.25F));
        QCOMPARE(frame.liquid, recording.frame(recording.frames() - 1).liquid);
    }
    void aFieldWithoutAMemberOfItsOwnStandsAmongTheOthers()
    {
        record_run(at("others.hygrorec"), 0.02);
        const Recording recording(at("others.hygrorec"));
        const FrameField fields[] = {{"liquid", nullptr, "kg", true, "liquid"}, {"suction", nullptr, "Pa", false, "suction", 0.5F}};
        const int last = recording.frames() - 1;
        const Frame frame = recording.frame(last, fields);
        QVERIFY(frame.liquid.empty());
        QCOMPARE(frame.others.at("liquid"), recording.frame(last).liquid);
        QCOMPARE(frame.others.at("suction"), std::vector<float>(std::size_t(recording.run().textile.segments()), 0.5F));
    }
    void aRecordingThatLacksARequiredFieldIsRefusedByName()
    {
        record_run(at("lacking.hygrorec"), 0.02);
        QVERIFY(craft_by_sql(at("lacking.hygrorec"), "UPDATE frames SET temperature=NULL WHERE number=1"));
        const Recording recording(at("lacking.hygrorec"));
        QCOMPARE(recording.frame(0).temperature.size(), std::size_t(recording.run().textile.segments()));
        try {
            recording.frame(1);
            QFAIL("a frame without temperatures was read");
        } catch (const FileError& e) {
            QCOMPARE(QString(e.what()), QString::fromStdString(at("lacking.hygrorec")) +
                                            ": Frame 1 cannot be read: \"frames/000001/temperature\" is missing; " +
                                            "the recording is damaged or no recording.");
        }
    }
    void aKilledRunLeavesAReadableRecording()
    {
        const std::string path = at("killed.hygrorec");
        const pid_t child = fork();
        QVERIFY(child >= 0);
        if (child == 0) {
            record_run(path, 50'000, nullptr, 2000); // longer than it lives
            _exit(0);
        }
        QTest::qSleep(1500);
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
        const Recording recording(path);
        QVERIFY(!recording.finished());
        QVERIFY(recording.frames() >= 1);
        QCOMPARE(recording.frame(recording.frames() - 1).saturation.size(), std::size_t(recording.run().textile.segments()));
    }
    void otherFilesAreRefusedWithASentence_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("text") << QByteArray("not a recording");
        record_run(at("source.hygrorec"), 0.01);
        const QByteArray whole = bytes_of(at("source.hygrorec"));
        QTest::newRow("cut in the head") << whole.left(300);
        QTest::newRow("cut in the middle") << whole.left(whole.size() / 2);
        QByteArray scrambled = whole;
        for (int i = 600; i < 4000; ++i) scrambled[i] = char(i * 37);
        QTest::newRow("scrambled") << scrambled;
        QTest::newRow("of another program") << QByteArray(whole).replace(68, 4, "XXXX");
    }
    void otherFilesAreRefusedWithASentence()
    {
        QFETCH(QByteArray, content);
        QFile file(folder_.filePath("bad.hygrorec"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(content);
        file.close();
        QVERIFY_EXCEPTION_THROWN(Recording{at("bad.hygrorec")}, FileError);
    }
    void anOlderFormIsNamed()
    {
        const std::string path = at("old.hygrorec");
        QFile file(QString::fromStdString(path));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("\x89HDF\r\n\x1a\n" + QByteArray(2000, 'x'));
        file.close();
        try {
            const Recording recording(path);
            QFAIL("it was read");
        } catch (const FileError& e) {
            QCOMPARE(QString(e.what()),
                     QString::fromStdString(path) + ": this was written by an older version of the program; run it again.");
        }
        record_run(path, 0.01); // in its place
        QVERIFY(Recording(path).finished());
    }
    void aMissingFolderIsNamed()
    {
        try {
            record_run(at("nowhere/x.hygrorec"), 0.01);
            QFAIL("written into a folder that is not there");
        } catch (const FileError& e) {
            QVERIFY(QString(e.what()).contains("nowhere"));
        }
    }
};

QTEST_GUILESS_MAIN(TestRecording)
#include "tst_recording.moc"
