// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A garment's run goes on on the CPU when its device fails, with the same result, and says so; without leave it ends.
#include "core/base/error.h"
#include "core/wear/garment_run.h"
#include "core/wear/wear_outcomes.h"
#include "tests/support/device.h"
#include "tests/wear/flat_garment.h"

#include <QTemporaryDir>
#include <QTest>

#include <thread>

using namespace hygroloom;

namespace tst_garment_run {
namespace {

/// Fails at the given call of advance(); 0: when it is to load.
class FailingDevice : public Device {
public:
    FailingDevice(int fails_at, std::chrono::milliseconds pause) : left_(fails_at), pause_(pause) {}
    void load(const Scene& scene) override
    {
        if (left_ == 0) throw DeviceError("The device failed.");
        Device::load(scene);
    }
    double advance(double until) override
    {
        if (--left_ == 0) throw DeviceError("The device failed.");
        std::this_thread::sleep_for(pause_);
        return Device::advance(until);
    }
    std::vector<std::byte> state() override
    {
        ++states;
        return Device::state();
    }
    int states = 0; ///< asked for

private:
    int left_;
    std::chrono::milliseconds pause_;
};

struct Ended {
    std::vector<WearFrame> frames;
    std::string said, json;
};

Ended run(Backend& backend, bool may_go_on, const std::filesystem::path& recording = {})
{
    Tee tee(120);
    tee.scene(40e-3, true, true); // fills in the parts
    Ended ended;
    WornCallbacks worn;
    worn.frame = [&](const std::shared_ptr<const WearFrame>& frame, const WearMetrics& metrics) {
        ended.frames.push_back(*frame);
        ended.json = wear_json(metrics);
    };
    RunCallbacks beside;
    beside.device_failed = [&](const std::string& sentence) { ended.said += sentence; };
    RunOptions options;
    options.fidelity = Fidelity::draft;
    options.cell_side = 40e-3;
    options.may_go_on_on_cpu = may_go_on;
    options.recording = recording;
    RunControl control;
    run_garment(tee.parts, options, backend, control, beside, worn);
    return ended;
}

bool same(const Ended& a, const Ended& b)
{
    if (a.frames.size() != b.frames.size() || a.json != b.json) return false;
    for (std::size_t k = 0; k < a.frames.size(); ++k)
        if (a.frames[k].time != b.frames[k].time || a.frames[k].inside != b.frames[k].inside ||
            a.frames[k].temperature != b.frames[k].temperature)
            return false;
    return true;
}

} // namespace

class TestGarmentRun : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void itGoesOnOnTheCpu_data()
    {
        QTest::addColumn<int>("failsAt");
        QTest::addColumn<int>("pause");
        QTest::addColumn<bool>("fromTheMiddle");
        QTest::newRow("at loading") << 0 << 0 << false;
        QTest::newRow("at once") << 1 << 0 << false;
        QTest::newRow("after frames, whose state was kept") << 60 << 100 << true;
    }
    void itGoesOnOnTheCpu()
    {
        QFETCH(int, failsAt);
        QFETCH(int, pause);
        QFETCH(bool, fromTheMiddle);
        const std::unique_ptr<Backend> cpu = make_cpu_backend();
        const Ended wanted = run(*cpu, true);
        QVERIFY(wanted.said.empty() && wanted.frames.size() > 50);
        QVERIFY(wanted.frames.back().ledger.water_delivered > 0);
        FailingDevice device(failsAt, std::chrono::milliseconds(pause));
        const QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath("tee.hygrorec").toStdString();
        const Ended ended = run(device, true, file);
        QVERIFY(same(ended, wanted));
        QVERIFY2(ended.said.starts_with("The device failed. The run goes on on the CPU, from "), ended.said.c_str());
        QCOMPARE(ended.said.ends_with("from 0 s."), !fromTheMiddle);
        QCOMPARE(device.states > 0, fromTheMiddle);
        const WearRecording recording(file);
        QVERIFY(recording.finished());
        QCOMPARE(static_cast<std::size_t>(recording.frames()), wanted.frames.size());
        QVERIFY2(recording.record().device.starts_with("a device; from "), recording.record().device.c_str());
    }
    void withoutLeaveItEnds()
    {
        FailingDevice device(3, std::chrono::milliseconds(0));
        QVERIFY_THROWS_EXCEPTION(DeviceError, run(device, false));
    }
};

} // namespace tst_garment_run

QTEST_APPLESS_MAIN(tst_garment_run::TestGarmentRun)
#include "tst_garment_run.moc"
