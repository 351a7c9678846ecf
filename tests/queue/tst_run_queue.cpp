// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The queue: order, pause, stop, memory, devices that fail, and that one run concerns no other.
#include "core/base/error.h"
#include "core/queue/run_queue.h"
#include "tests/support/device.h"
#include "tests/support/places.h"
#include "tests/support/quick_job.h"

#include <QTest>

#include <algorithm>
#include <set>

using namespace hygroloom;
using State = BatchState::State;
using WaitsFor = BatchState::WaitsFor;

namespace {

/// Holds runs until it is opened.
class Gate {
public:
    void open() { open_ = true; }
    void pass() const
    {
        while (!open_) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }

private:
    std::atomic<bool> open_ = false;
};

/// What began, in order: "A0" is the first run of batch A.
class Begun {
public:
    void add(const std::string& what)
    {
        const std::lock_guard lock(mutex_);
        all_.push_back(what);
    }
    std::vector<std::string> all() const
    {
        const std::lock_guard lock(mutex_);
        return all_;
    }

private:
    mutable std::mutex mutex_;
    std::vector<std::string> all_;
};

/// Its runs are over as soon as they begin: they have no yarn.
RunBatch of_nothing(const std::string& name, std::size_t count, const std::shared_ptr<RunPlaces>& places, Begun& begun,
                    const Gate* gate = nullptr)
{
    RunBatch batch;
    batch.name = name;
    batch.count = count;
    batch.places = places;
    batch.job = [name, &begun, gate](std::size_t i) -> RunJob {
        begun.add(name + std::to_string(i));
        if (gate) gate->pass();
        throw Error("There is no yarn.");
    };
    return batch;
}

RunBatch of_drops(std::size_t count, const std::shared_ptr<RunPlaces>& places, bool slow = false)
{
    RunBatch batch;
    batch.name = "drops";
    batch.count = count;
    batch.places = places;
    batch.job = [slow](std::size_t) { return slow ? slow_job() : quick_job(); };
    return batch;
}

BatchState state_of(const RunQueue& queue, int id)
{
    for (const BatchState& each : queue.list())
        if (each.id == id) return each;
    return {};
}

class FailingDevice : public Device {
public:
    double advance(double) override { throw DeviceError("The device failed."); }
};

} // namespace

class TestRunQueue : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void batchesGoInTheirOrder()
    {
        RunQueue queue;
        const auto place = cpu_places();
        Begun begun;
        Gate gate;
        const int a = queue.add(of_nothing("A", 2, place, begun, &gate));
        const int b = queue.add(of_nothing("B", 2, place, begun));
        const int c = queue.add(of_nothing("C", 2, place, begun));
        QTRY_COMPARE(begun.all().size(), std::size_t(1));
        QCOMPARE(state_of(queue, a).state, State::running);
        QCOMPARE(state_of(queue, b).state, State::waiting);
        QCOMPARE(state_of(queue, b).waits_for, WaitsFor::others);
        gate.open();
        for (const int id : {a, b, c}) queue.wait(id);
        QCOMPARE(begun.all(), (std::vector<std::string>{"A0", "A1", "B0", "B1", "C0", "C1"}));
        QVERIFY(queue.list().empty());
    }
    void anOrderCanBeChanged()
    {
        RunQueue queue;
        const auto place = cpu_places();
        Begun begun;
        Gate gate;
        const int a = queue.add(of_nothing("A", 2, place, begun, &gate));
        const int b = queue.add(of_nothing("B", 1, place, begun));
        const int c = queue.add(of_nothing("C", 1, place, begun));
        QTRY_COMPARE(begun.all().size(), std::size_t(1));
        queue.move(c, -2);
        queue.move(b, -1);
        std::vector<std::string> names;
        for (const BatchState& each : queue.list()) names.push_back(each.name);
        QCOMPARE(names, (std::vector<std::string>{"C", "B", "A"}));
        gate.open();
        for (const int id : {a, b, c}) queue.wait(id);
        QCOMPARE(begun.all(), (std::vector<std::string>{"A0", "C0", "B0", "A1"}));
    }
    /// Two may be on, so the second of A goes beside the first; B may not be on beside another, and C waits behind it.
    void noneOvertakesButWhatIsWatched()
    {
        RunQueue queue;
        Begun begun;
        Gate gate;
        const int a = queue.add(of_nothing("A", 2, cpu_places(2), begun, &gate));
        const int b = queue.add(of_nothing("B", 1, cpu_places(), begun));
        const int c = queue.add(of_nothing("C", 1, cpu_places(8), begun));
        QTRY_COMPARE(begun.all().size(), std::size_t(2));
        QCOMPARE(state_of(queue, a).running, std::size_t(2));
        RunBatch watched = of_nothing("W", 1, cpu_places(), begun);
        watched.watched = true;
        queue.wait(queue.add(std::move(watched)));
        QCOMPARE(begun.all().size(), std::size_t(3));
        QCOMPARE(begun.all().back(), std::string("W0"));
        gate.open();
        for (const int id : {a, b, c}) queue.wait(id);
        QCOMPARE(begun.all().size(), std::size_t(5));
    }
    void whatIsPausedGivesWay()
    {
        RunQueue queue;
        Begun begun;
        const int long_one = queue.add(of_drops(1, cpu_places(), true));
        const int other = queue.add(of_nothing("B", 1, cpu_places(), begun));
        QTRY_VERIFY(state_of(queue, long_one).share > 0);
        QVERIFY(begun.all().empty());
        queue.set_paused(long_one, true);
        queue.wait(other);
        QCOMPARE(state_of(queue, long_one).state, State::paused);
        std::this_thread::sleep_for(std::chrono::milliseconds(300)); // a step may still be on
        const double share = state_of(queue, long_one).share;
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        QCOMPARE(state_of(queue, long_one).share, share);
        queue.set_paused(long_one, false);
        QTRY_VERIFY(state_of(queue, long_one).share > share);
        queue.cancel(long_one);
        queue.wait(long_one);
    }
    void whatIsLetGoOnWaitsForItsTurn()
    {
        RunQueue queue;
        std::vector<bool> told;
        RunBatch batch = of_drops(1, cpu_places(), true);
        batch.paused = [&](bool paused) { told.push_back(paused); };
        const int first = queue.add(std::move(batch));
        QTRY_COMPARE(state_of(queue, first).state, State::running);
        queue.set_paused(first, true);
        QCOMPARE(state_of(queue, first).running, std::size_t(0));
        const int second = queue.add(of_drops(1, cpu_places(), true));
        QTRY_COMPARE(state_of(queue, second).running, std::size_t(1));
        queue.set_paused(first, false);
        QCOMPARE(told, (std::vector<bool>{true, false}));
        QCOMPARE(state_of(queue, first).state, State::waiting);
        QCOMPARE(state_of(queue, first).waits_for, WaitsFor::others);
        const int third = queue.add(of_drops(1, cpu_places(), true)); // behind it
        queue.cancel(second);
        QTRY_COMPARE(state_of(queue, first).state, State::running);
        queue.wait(second);
        QCOMPARE(state_of(queue, third).running, std::size_t(0));
        queue.cancel(first);
        QTRY_COMPARE(state_of(queue, third).running, std::size_t(1));
        queue.cancel(third);
        for (const int id : {first, third}) queue.wait(id);
    }
    /// The second has the machine and waits for memory that the first has, which waits for the machine.
    void whatHasItsMemoryGoesOnBesideWhatWaitsForIt()
    {
        RunQueue queue;
        const double all = 1.5 * bytes_of(slow_job());
        const auto batch = [all] {
            RunBatch one = of_drops(1, cpu_places(), true);
            one.room = [all] { return all; };
            return one;
        };
        const int first = queue.add(batch());
        QTRY_VERIFY(state_of(queue, first).share > 0);
        queue.set_paused(first, true);
        const int second = queue.add(batch());
        QTRY_COMPARE(state_of(queue, second).waits_for, WaitsFor::memory);
        queue.set_paused(first, false);
        QTRY_COMPARE(state_of(queue, first).running, std::size_t(1));
        QCOMPARE(state_of(queue, second).running, std::size_t(0));
        queue.cancel(first);
        queue.wait(first);
        QTRY_COMPARE(state_of(queue, second).running, std::size_t(1));
        queue.cancel(second);
        queue.wait(second);
    }
    void noRunGoesBesideOneThatTakesAllOfItsMachine()
    {
        RunQueue queue;
        Begun begun;
        Gate gate;
        const int all = queue.add(of_nothing("A", 1, cpu_places(), begun, &gate));
        QTRY_COMPARE(begun.all().size(), std::size_t(1));
        const int shares = queue.add(of_nothing("B", 4, cpu_places(4), begun));
        const auto gpu = std::make_shared<RunPlaces>([] { return make_cpu_backend(); }, "cuda", 1);
        queue.wait(queue.add(of_nothing("G", 1, gpu, begun))); // which goes on another
        QCOMPARE(begun.all(), (std::vector<std::string>{"A0", "G0"}));
        gate.open();
        for (const int id : {all, shares}) queue.wait(id);
        QCOMPARE(begun.all().size(), std::size_t(6));
    }
    void whatIsPausedDoesNotBegin()
    {
        RunQueue queue;
        const auto place = cpu_places();
        Begun begun;
        Gate gate;
        const int a = queue.add(of_nothing("A", 1, place, begun, &gate));
        const int b = queue.add(of_nothing("B", 1, place, begun));
        const int c = queue.add(of_nothing("C", 1, place, begun));
        queue.set_paused(b, true);
        gate.open();
        queue.wait(a);
        queue.wait(c);
        QCOMPARE(state_of(queue, b).state, State::paused);
        queue.set_paused(b, false);
        queue.wait(b);
        QCOMPARE(begun.all(), (std::vector<std::string>{"A0", "C0", "B0"}));
    }
    void stoppingOneLeavesTheOthers()
    {
        RunQueue queue;
        const auto place = cpu_places();
        std::atomic<int> stopped{0}, over{0}, ended{0};
        RunBatch first = of_drops(5, place, true), second = of_drops(2, place);
        first.ended = [&](std::size_t, RunResult& result) { stopped += !result.ended() && result.failure().empty(); };
        first.over = [&] { ++over; };
        second.ended = [&](std::size_t, RunResult& result) { ended += result.ended(); };
        const int a = queue.add(std::move(first)), b = queue.add(std::move(second));
        QTRY_VERIFY(state_of(queue, a).share > 0);
        queue.cancel(a);
        queue.wait(a);
        queue.wait(b);
        QCOMPARE(stopped.load(), 1); // the others had not begun
        QCOMPARE(over.load(), 1);
        QCOMPARE(ended.load(), 2);
    }
    void aFailureConcernsItsRunAlone()
    {
        RunQueue queue;
        RunBatch batch = of_drops(3, cpu_places());
        batch.job = [](std::size_t i) {
            RunJob job = quick_job();
            if (i == 1) job.fabric = "silk";
            return job;
        };
        std::vector<std::string> failures;
        std::vector<std::string> devices;
        batch.ended = [&](std::size_t, RunResult& result) {
            failures.push_back(result.failure());
            devices.push_back(result.device);
            QVERIFY(result.wall > 0);
        };
        QVERIFY(queue.run(std::move(batch), false));
        QCOMPARE(failures, (std::vector<std::string>{"", "There is no fabric named \"silk\" in the project.", ""}));
        QVERIFY(!devices[0].empty() && devices[0] == devices[1]);
    }
    void eachRunGoesOnceOnAllPlaces()
    {
        RunQueue queue;
        std::vector<std::size_t> done;
        std::mutex mutex;
        std::atomic<int> inside{0}, together{0};
        Begun begun;
        RunBatch batch = of_nothing("A", 20, cpu_places(3), begun);
        batch.job = [&](std::size_t) -> RunJob {
            together = std::max(together.load(), ++inside);
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            --inside;
            throw Error("There is no yarn.");
        };
        batch.ended = [&](std::size_t i, RunResult&) { done.push_back(i); };
        QVERIFY(queue.run(std::move(batch), false));
        std::sort(done.begin(), done.end());
        QCOMPARE(done.size(), std::size_t(20));
        for (std::size_t i = 0; i < done.size(); ++i) QCOMPARE(done[i], i);
        QCOMPARE(together.load(), 3);
    }
    void othersTakeTheRunsOfAFailedDevice()
    {
        std::vector<std::unique_ptr<Backend>> backends;
        backends.push_back(std::make_unique<FailingDevice>());
        backends.push_back(make_cpu_backend());
        const auto places = std::make_shared<RunPlaces>(std::move(backends));
        RunQueue queue;
        int failed = 0, ended = 0;
        RunBatch batch = of_drops(6, places);
        batch.job = [](std::size_t) {
            RunJob job = quick_job();
            job.how.may_go_on_on_cpu = true;
            return job;
        };
        batch.ended = [&](std::size_t, RunResult& result) {
            ended += result.ended();
            failed += !result.device_failure().empty();
        };
        QVERIFY(queue.run(std::move(batch), false));
        QCOMPARE(ended, 6);
        QCOMPARE(failed, 1);
        QCOMPARE(places->at_once(), std::size_t(1));
    }
    void whatACallerThrowsStopsItsBatch()
    {
        RunQueue queue;
        int runs = 0;
        RunBatch batch = of_drops(5, cpu_places());
        batch.ended = [&](std::size_t, RunResult&) {
            if (++runs == 2) throw FileError("There is no room.");
        };
        QVERIFY_EXCEPTION_THROWN(queue.run(std::move(batch), false), FileError);
        QCOMPARE(runs, 2);
    }
    void noRunBeginsOnceItsCallerStops()
    {
        RunQueue queue;
        std::atomic<bool> cancel{false};
        int runs = 0;
        RunBatch batch = of_drops(10, cpu_places());
        batch.ended = [&](std::size_t, RunResult&) { cancel = ++runs == 4; };
        QVERIFY(!queue.run(std::move(batch), cancel));
        QCOMPARE(runs, 4);
        QVERIFY(queue.run(RunBatch{"none", 0, cpu_places(), {}}, false));
    }
    void runsWaitUntilTheirMemoryFits_data()
    {
        QTest::addColumn<double>("room"); // in runs
        QTest::addColumn<int>("together");
        QTest::newRow("less than one goes alone") << 0.5 << 1;
        QTest::newRow("one") << 1.5 << 1;
        QTest::newRow("two") << 2.5 << 2;
        QTest::newRow("all") << 9.0 << 4;
    }
    void runsWaitUntilTheirMemoryFits()
    {
        QFETCH(double, room);
        QFETCH(int, together);
        const double each = bytes_of(quick_job());
        QVERIFY(each > 0);
        RunQueue queue;
        std::atomic<int> inside{0}, most{0}, ended{0};
        RunBatch batch = of_drops(8, cpu_places(4));
        batch.room = [&] { return room * each; };
        batch.job = [&](std::size_t) {
            RunJob job = quick_job();
            job.beside.started = [&](const RunRecord&) {
                most = std::max(most.load(), ++inside);
                std::this_thread::sleep_for(std::chrono::milliseconds(100)); // so that all that may are on
                --inside;
            };
            return job;
        };
        batch.ended = [&](std::size_t, RunResult& result) { ended += result.ended(); };
        QVERIFY(queue.run(std::move(batch), false));
        QCOMPARE(ended.load(), 8);
        QCOMPARE(most.load(), together);
    }
    void aQueueThatGoesStopsItsRuns()
    {
        std::atomic<int> over{0};
        {
            RunQueue queue;
            RunBatch batch = of_drops(3, cpu_places(), true);
            batch.over = [&] { ++over; };
            const int id = queue.add(std::move(batch));
            QTRY_VERIFY(state_of(queue, id).share > 0);
        }
        QCOMPARE(over.load(), 0);
    }
};

QTEST_GUILESS_MAIN(TestRunQueue)
#include "tst_run_queue.moc"
