// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Frames that a device gives late, while the next steps run: the run is the same, and what goes wrong with one ends it as ever.
#include "core/base/error.h"
#include "core/run/recording.h"
#include "core/run/runner.h"
#include "core/solver/backend.h"
#include "tests/support/device.h"
#include "tests/support/spot_design.h"

#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <thread>

using namespace hygroloom;

namespace tst_late_frames {
namespace {

/// Gives frames as a GPU does: some time after they were taken, to whoever asks.
class LateBackend : public Device {
public:
    void load(const Scene& scene) override
    {
        note_disorder();
        cpu_->load(scene);
    }
    void unload() override { note_disorder(); }
    double advance(double until) override
    {
        if (++advances == fails_at_advance) throw DeviceError("The device failed.");
        if (on_their_way_ > 0) ++advances_meanwhile;
        std::this_thread::sleep_for(step);
        return cpu_->advance(until);
    }
    std::future<Frame> take_frame() override
    {
        note_disorder();
        ++taken;
        ++on_their_way_;
        Frame frame = cpu_->frame();
        if (taken == leaks_at_frame) frame.ledger.water_free += 1e-6;
        return std::async(way, [this, frame = std::move(frame), fails = taken == fails_at_frame] {
            std::this_thread::sleep_for(delay);
            --on_their_way_;
            if (fails) throw DeviceError("The device failed.");
            return frame;
        });
    }
    std::vector<std::byte> state() override
    {
        note_disorder(); // a state is that of a frame that was seen
        ++states;
        return cpu_->state();
    }

    std::launch way = std::launch::deferred;
    std::chrono::milliseconds delay{5}, step{0};
    int fails_at_advance = 0, fails_at_frame = 0, leaks_at_frame = 0; ///< the how manieth
    int taken = 0, states = 0;
    std::atomic<int> advances{0};
    int advances_meanwhile = 0; ///< while a frame was on its way
    int disorder = 0;           ///< how often more was asked before the last frame was there

private:
    void note_disorder()
    {
        if (on_their_way_ > 0) ++disorder;
    }
    std::atomic<int> on_their_way_{0};
};

/// 101 frames.
Design brief() { return drop_design(35, 0.03); }

/// All parts are on, so nothing is watched. Few particles, as all that matters is when frames come.
RunOptions all_on(bool may_go_on_on_cpu = false)
{
    RunOptions options;
    options.fidelity = Fidelity::draft;
    options.forced = {{"sorption", true}, {"vapour", true}, {"heat", true}};
    options.knobs = {{"particles_per_droplet", 200}};
    options.may_go_on_on_cpu = may_go_on_on_cpu;
    return options;
}

struct Run {
    std::unique_ptr<RunControl> control = std::make_unique<RunControl>();
    RunRecord record;
    std::vector<Frame> frames;
    std::vector<std::string> reported; ///< what was called back, in order
    QString failure;
    int overlaps = 0; ///< calls while another had not come back
    std::function<void(const Frame&)> see;

    void go(const Design& design, const RunOptions& options, Backend& backend)
    {
        std::atomic<int> inside{0};
        RunCallbacks callbacks;
        callbacks.frame = [&](const std::shared_ptr<const Frame>& frame) {
            overlaps += inside++;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            frames.push_back(*frame);
            reported.emplace_back("frame");
            --inside;
            if (see) see(*frame);
        };
        callbacks.progress = [&](const RunProgress&) {
            overlaps += inside++;
            reported.emplace_back("progress");
            --inside;
        };
        callbacks.switched_on = [&](const SwitchedPart& part) { reported.push_back(part.name); };
        callbacks.device_failed = [&](const std::string& sentence) { failure += QString::fromStdString(sentence); };
        record = run_experiment(design, "cloth", "drop", options, backend, *control, callbacks);
    }
};

void verify_same(const std::vector<Frame>& frames, const std::vector<Frame>& expected)
{
    QCOMPARE(frames.size(), expected.size());
    for (std::size_t k = 0; k < frames.size(); ++k) {
        QCOMPARE(frames[k].time, expected[k].time);
        QCOMPARE(frames[k].saturation, expected[k].saturation);
        QCOMPARE(frames[k].regain, expected[k].regain);
        QCOMPARE(frames[k].temperature, expected[k].temperature);
        QVERIFY(frames[k].positions == expected[k].positions && frames[k].velocities == expected[k].velocities);
        QCOMPARE(frames[k].ledger.water_evaporated, expected[k].ledger.water_evaporated);
        QCOMPARE(frames[k].ledger.energy_imbalance(), expected[k].ledger.energy_imbalance());
    }
}

Run run_on_cpu(const Design& design, const RunOptions& options)
{
    Run run;
    run.go(design, options, *make_cpu_backend());
    return run;
}

} // namespace

class TestLateFrames : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { expected_ = run_on_cpu(brief(), all_on()).frames; }
    void theyChangeNothing_data()
    {
        QTest::addColumn<int>("way");
        QTest::addColumn<int>("delayMs");
        QTest::newRow("when asked for, at once") << int(std::launch::deferred) << 0;
        QTest::newRow("when asked for, after a while") << int(std::launch::deferred) << 12;
        QTest::newRow("by themselves, at once") << int(std::launch::async) << 0;
        QTest::newRow("by themselves, after a while") << int(std::launch::async) << 12;
    }
    void theyChangeNothing()
    {
        QFETCH(int, way);
        QFETCH(int, delayMs);
        LateBackend late;
        late.way = static_cast<std::launch>(way);
        late.delay = std::chrono::milliseconds(delayMs);
        late.step = std::chrono::milliseconds(3);
        RunOptions options = all_on();
        options.recording = folder_.filePath("late.hygrorec").toStdString();
        Run run;
        run.go(brief(), options, late);
        verify_same(run.frames, expected_);
        QCOMPARE(late.taken, int(expected_.size()));
        QCOMPARE(late.disorder, 0);
        QCOMPARE(run.overlaps, 0);
        if (delayMs > 0) QVERIFY(late.advances_meanwhile > late.taken / 2);
        const Recording recording(options.recording);
        QVERIFY(recording.finished());
        QCOMPARE(recording.frames(), int(expected_.size()));
        for (int k = 0; k < recording.frames(); ++k) QCOMPARE(recording.frame(k).saturation, expected_[std::size_t(k)].saturation);
    }
    void runGoesOnOnTheCpu_data()
    {
        QTest::addColumn<int>("frame");
        QTest::addColumn<int>("advance");
        QTest::addColumn<int>("stepMs");
        QTest::newRow("the first fails") << 1 << 0 << 0;
        QTest::newRow("one in the middle fails") << 20 << 0 << 0;
        QTest::newRow("the last fails") << 101 << 0 << 0;
        QTest::newRow("steps fail while one is on its way") << 0 << 20 << 0;
        QTest::newRow("steps fail, and so does the one on its way") << 20 << 20 << 0;
        QTest::newRow("one fails after something was kept") << 96 << 0 << 30;
    }
    void runGoesOnOnTheCpu()
    {
        QFETCH(int, frame);
        QFETCH(int, advance);
        QFETCH(int, stepMs);
        const auto set = [&](LateBackend& late) {
            late.fails_at_frame = frame;
            late.fails_at_advance = advance;
            late.step = std::chrono::milliseconds(stepMs);
        };
        {
            LateBackend late;
            set(late);
            Run run;
            QVERIFY_EXCEPTION_THROWN(run.go(brief(), all_on(), late), DeviceError);
            QCOMPARE(late.disorder, 0);
            QVERIFY(run.failure.isEmpty());
        }
        LateBackend late;
        set(late);
        RunOptions options = all_on(true);
        options.recording = folder_.filePath("failed.hygrorec").toStdString();
        Run run;
        run.go(brief(), options, late);
        QCOMPARE(late.disorder, 0);
        if (stepMs > 0) QVERIFY(late.states > 0);
        QCOMPARE(run.failure.count("goes on on the CPU"), 1);
        QVERIFY2(run.failure.contains("The device failed."), qPrintable(run.failure));
        QCOMPARE(run.frames.size(), expected_.size());
        for (std::size_t k = 0; k < run.frames.size(); ++k) {
            QCOMPARE(run.frames[k].time, expected_[k].time);
            QVERIFY(std::abs(run.frames[k].ledger.water_liquid - expected_[k].ledger.water_liquid) <
                    0.02 * expected_.back().ledger.water_delivered);
        }
        if (late.states == 0) verify_same(run.frames, expected_); // all over again
        const Recording recording(options.recording);
        QVERIFY(recording.finished());
        QCOMPARE(recording.frames(), int(expected_.size()));
    }
    void whatGoesWrongWithOneEndsTheRun_data()
    {
        QTest::addColumn<int>("leaks");
        QTest::addColumn<QString>("complaint");
        QTest::newRow("water is lost") << 4 << "The water ledger does not close";
        QTest::newRow("who sees it fails") << 0 << "There is no room for this frame.";
    }
    void whatGoesWrongWithOneEndsTheRun()
    {
        QFETCH(int, leaks);
        QFETCH(QString, complaint);
        LateBackend late;
        late.leaks_at_frame = leaks;
        RunOptions options = all_on(true);
        options.recording = folder_.filePath("ended.hygrorec").toStdString();
        Run run;
        if (leaks == 0)
            run.see = [&run](const Frame&) {
                if (run.frames.size() == 3) throw FileError("There is no room for this frame.");
            };
        QString said;
        try {
            run.go(brief(), options, late);
        } catch (const Error& error) {
            said = error.what();
        }
        QVERIFY2(said.startsWith(complaint), qPrintable(said));
        QVERIFY(run.failure.isEmpty());
        QCOMPARE(run.frames.size(), std::size_t(3));
        const Recording recording(options.recording);
        QVERIFY(!recording.finished());
        QCOMPARE(recording.frames(), 3);
    }
    void partsComeOnAtTheSameFrame()
    {
        const Design design = spot_design("polyester", 0.9955, 200);
        RunOptions options;
        options.fidelity = Fidelity::draft;
        options.forced = {{"heat", false}};
        const Run expected = run_on_cpu(design, options);
        LateBackend late;
        Run run;
        run.go(design, options, late);
        QCOMPARE(run.record.switched_on.size(), std::size_t(1));
        QCOMPARE(run.record.switched_on[0].name, std::string("vapour"));
        QCOMPARE(run.record.switched_on[0].time, expected.record.switched_on[0].time);
        verify_same(run.frames, expected.frames);
        // The frame at which the part comes on is seen before the run goes on; then nothing is watched any more.
        const auto frames_before = [](const Run& of) {
            return std::count(of.reported.begin(), std::find(of.reported.begin(), of.reported.end(), "vapour"), "frame");
        };
        QCOMPARE(frames_before(run), frames_before(expected));
        QVERIFY(late.advances_meanwhile > 0);
        QCOMPARE(late.disorder, 0);
    }
    void whoSeesOneMayCancel()
    {
        LateBackend late;
        RunOptions options = all_on();
        options.recording = folder_.filePath("cancelled.hygrorec").toStdString();
        Run run;
        run.see = [&run](const Frame&) {
            if (run.frames.size() == 5) run.control->cancel = true;
        };
        QVERIFY_EXCEPTION_THROWN(run.go(brief(), options, late), Cancelled);
        QCOMPARE(run.frames.size(), std::size_t(5));
        QCOMPARE(Recording(options.recording).frames(), 5);
    }
    void cancellingWaitsForTheOneOnItsWay()
    {
        LateBackend late;
        late.delay = std::chrono::milliseconds(100);
        late.step = std::chrono::milliseconds(20);
        Run run;
        std::atomic<bool> seen_one = false;
        run.see = [&seen_one](const Frame&) { seen_one = true; };
        std::jthread cancel([&run, &seen_one] {
            while (!seen_one) std::this_thread::sleep_for(std::chrono::milliseconds(5));
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
            run.control->cancel = true;
        });
        bool cancelled = false;
        try {
            run.go(drop_design(35, 1), all_on(), late);
        } catch (const Cancelled&) {
            cancelled = true;
        }
        cancel.join();
        QVERIFY(cancelled);
        const std::size_t seen = run.frames.size();
        QVERIFY(seen > 0);
        QTest::qSleep(200);
        QCOMPARE(run.frames.size(), seen);
        QCOMPARE(int(seen), late.taken);
    }
    void pausingHoldsTheStepsOnly()
    {
        LateBackend late;
        Run run;
        run.see = [&run](const Frame&) {
            if (run.frames.size() == 5) run.control->pause = true;
        };
        int advances = 0, later = 0;
        std::jthread go_on([&] {
            while (!run.control->pause) std::this_thread::sleep_for(std::chrono::milliseconds(5));
            std::this_thread::sleep_for(std::chrono::milliseconds(200));
            advances = late.advances;
            std::this_thread::sleep_for(std::chrono::milliseconds(200));
            later = late.advances;
            run.control->pause = false;
        });
        run.go(brief(), all_on(), late);
        go_on.join();
        QCOMPARE(later, advances);
        QCOMPARE(int(run.frames.size()), 101);
    }

private:
    QTemporaryDir folder_;
    std::vector<Frame> expected_; // of brief()
};

} // namespace tst_late_frames

QTEST_APPLESS_MAIN(tst_late_frames::TestLateFrames)
#include "tst_late_frames.moc"
