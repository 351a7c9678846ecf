// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Work in a process of its own gives back what it did.
#include "core/base/error.h"
#include "core/run/apart.h"

#include <QTest>

#include <csignal>
#include <thread>

using namespace hygroloom;

namespace {

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

class TestApart : public QObject {
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
};

QTEST_APPLESS_MAIN(TestApart)
#include "tst_apart.moc"
