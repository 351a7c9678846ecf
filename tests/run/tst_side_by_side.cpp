// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Runs side by side share their work out and end together; work in a process of its own gives back what it did.
#include "core/base/error.h"
#include "core/run/apart.h"
#include "core/run/memory_gate.h"
#include "core/run/side_by_side.h"
#include "core/solver/backend.h"

#include <QTest>

#include <algorithm>
#include <csignal>
#include <set>
#include <thread>

using namespace hygroloom;

namespace {

std::vector<std::unique_ptr<Backend>> backends(int count)
{
    std::vector<std::unique_ptr<Backend>> all;
    for (int i = 0; i < count; ++i) all.push_back(make_cpu_backend());
    return all;
}

/// What it throws, as a word and the sentence.
QString thrown_by(const ApartWork& work)
{
    const std::atomic<bool> cancel{false};
    try {
        run_apart("this", work, cancel, [](double) {});
    } catch (const Cancelled&) {
        return "cancelled";
    } catch (const DeviceError& error) {
        return QString("device: ") + error.what();
    } catch (const Error& error) {
        return QString("error: ") + error.what();
    }
    return "nothing";
}

} // namespace

class TestSideBySide : public QObject {
    Q_OBJECT

private Q_SLOTS:
    // First those that fork: this process has no threads yet.
    void workApartGivesItsTextAndItsMemory()
    {
        const std::atomic<bool> cancel{false};
        std::vector<double> shares;
        int here = 0;
        const ApartResult result = run_apart(
            "this",
            [&here](const std::function<void(double)>& progress) {
                here = 1;
                std::vector<char> large(std::size_t{200} << 20, 1);
                progress(0.25);
                progress(1);
                return std::string("found ") + (large[100] == 1 ? "it" : "nothing");
            },
            cancel, [&shares](double share) { shares.push_back(share); });
        QCOMPARE(result.text, std::string("found it"));
        QCOMPARE(shares, (std::vector<double>{0.25, 1}));
        QVERIFY(result.peak_bytes > 200e6);
        QCOMPARE(here, 0); // in the other process
    }
    void whatItThrowsArrives()
    {
        QCOMPARE(thrown_by([](const auto&) -> std::string { throw Cancelled(); }), "cancelled");
        QCOMPARE(thrown_by([](const auto&) -> std::string { throw DeviceError("It is gone."); }), "device: It is gone.");
        QCOMPARE(thrown_by([](const auto&) -> std::string { throw FileError("No room."); }), "error: No room.");
        QCOMPARE(thrown_by([](const auto&) -> std::string { throw FileError("No \no {}\n."); }), QString("error: No \uFFFDo {}\uFFFD."));
        QCOMPARE(thrown_by([](const auto&) -> std::string { throw std::bad_alloc(); }), "error: The memory does not suffice for this.");
        QCOMPARE(thrown_by([](const auto&) -> std::string {
                     std::raise(SIGKILL);
                     return "";
                 }),
                 "error: The run of this was ended by signal 9; the memory may not suffice.");
    }
    void cancellingEndsIt()
    {
        std::atomic<bool> cancel{false};
        const auto endless = [](const std::function<void(double)>& progress) -> std::string {
            std::signal(SIGTERM, SIG_DFL); // QtTest prints a stack
            progress(0.5);
            while (true) std::this_thread::sleep_for(std::chrono::milliseconds(10));
        };
        QVERIFY_EXCEPTION_THROWN(run_apart("this", endless, cancel, [&cancel](double) { cancel = true; }), Cancelled);
        QVERIFY_EXCEPTION_THROWN(run_apart("this", endless, cancel, [](double) {}), Cancelled);
    }

    void eachRunGoesOnce()
    {
        RunControl control;
        std::mutex mutex;
        std::vector<std::size_t> done;
        std::set<const Backend*> used;
        run_side_by_side(backends(3), 20, control, [&](std::size_t i, Backend& backend) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            const std::lock_guard lock(mutex);
            done.push_back(i);
            used.insert(&backend);
            return false;
        });
        std::sort(done.begin(), done.end());
        QCOMPARE(done.size(), std::size_t(20));
        for (std::size_t i = 0; i < done.size(); ++i) QCOMPARE(done[i], i);
        QCOMPARE(used.size(), std::size_t(3));
    }
    void othersTakeTheRunsOfAFailedDevice()
    {
        RunControl control;
        const auto all = backends(2);
        std::atomic<int> on_first{0}, on_second{0};
        run_side_by_side(all, 10, control, [&](std::size_t, Backend& backend) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            ++(&backend == all[0].get() ? on_first : on_second);
            return &backend == all[0].get();
        });
        QCOMPARE(on_first + on_second, 10);
        QVERIFY(on_first <= 1);
    }
    void whatOneThrowsCancelsTheOthers()
    {
        RunControl control;
        std::atomic<int> runs{0};
        const auto run = [&](std::size_t i, Backend&) -> bool {
            ++runs;
            if (i == 1) throw FileError("There is no room.");
            while (!control.cancel) std::this_thread::sleep_for(std::chrono::milliseconds(1));
            throw Cancelled();
        };
        QVERIFY_EXCEPTION_THROWN(run_side_by_side(backends(2), 10, control, run), FileError);
        QVERIFY(control.cancel);
        QVERIFY(runs <= 3);
    }
    void cancelledRunsStartNoMore()
    {
        RunControl control;
        int runs = 0;
        run_side_by_side(backends(1), 10, control, [&](std::size_t, Backend&) {
            control.cancel = ++runs == 4;
            return false;
        });
        QCOMPARE(runs, 4);
    }
    void runsWaitUntilTheirMemoryFits()
    {
        MemoryGate gate([] { return 100.0; });
        std::atomic<bool> cancel{false};
        std::atomic<double> taken{0}, most{0};
        std::atomic<int> inside{0}, together{0};
        const auto go = [&](double bytes) {
            const MemoryGate::Pass pass(gate, bytes, cancel);
            together = std::max(together.load(), ++inside);
            most = std::max(most.load(), taken += bytes);
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            --inside;
            taken -= bytes;
        };
        {
            std::vector<std::jthread> runs;
            for (int i = 0; i < 16; ++i) runs.emplace_back([&] { go(30); });
        }
        QVERIFY2(most <= 100 && together > 1, qPrintable(QString("%1 bytes, %2 together").arg(most.load()).arg(together.load())));
        go(1000); // alone it goes all the same
        const MemoryGate::Pass all(gate, 90, cancel);
        std::jthread later([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
            cancel = true;
        });
        QVERIFY_EXCEPTION_THROWN(go(20), Cancelled);
        QCOMPARE(inside.load(), 0);
    }
};

QTEST_APPLESS_MAIN(TestSideBySide)
#include "tst_side_by_side.moc"
