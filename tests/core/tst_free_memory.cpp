// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The memory that is free, from files as the kernel writes them, and what is asked of it.
#include "core/base/free_memory.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>

using namespace hygroloom;

namespace {

/// A machine of files.
class Machine {
public:
    Machine() { QVERIFY(folder_.isValid()); }
    void put(const QString& file, const QByteArray& text) const
    {
        const QString path = folder_.filePath(file);
        QVERIFY(QDir().mkpath(QFileInfo(path).absolutePath()));
        QFile out(path);
        QVERIFY(out.open(QIODevice::WriteOnly));
        QCOMPARE(out.write(text), text.size());
    }
    FreeMemory free() const { return free_memory(folder_.path().toStdString()); }

private:
    QTemporaryDir folder_;
};

const QByteArray meminfo = "MemTotal:       24683520 kB\nMemFree:        18762000 kB\nMemAvailable:   20000000 kB\nBuffers: 1 kB\n";
constexpr double machine_free = 20000000.0 * 1024;

} // namespace

class TestFreeMemory : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatSaysNothingBoundsNothing()
    {
        const Machine machine;
        QVERIFY(std::isinf(machine.free().bytes));
        QCOMPARE(ask_for_memory("This run", 1e18, {}, machine.free()), std::string());
        QCOMPARE(jobs_that_fit(8, 1e12, machine.free()), 8);
    }
    void theMachineSaysWhatIsAvailable()
    {
        const Machine machine;
        machine.put("proc/meminfo", meminfo);
        QCOMPARE(machine.free().bytes, machine_free);
        QCOMPARE(machine.free().bound, std::string("on this machine"));
    }
    void aControlGroupAndAllAboveItBound()
    {
        const Machine machine;
        machine.put("proc/meminfo", meminfo);
        machine.put("proc/self/cgroup", "0::/system.slice/job\n");
        machine.put("sys/fs/cgroup/system.slice/job/memory.max", "max\n");
        machine.put("sys/fs/cgroup/system.slice/job/memory.current", "5000\n");
        machine.put("sys/fs/cgroup/system.slice/memory.max", "300000000\n");
        machine.put("sys/fs/cgroup/system.slice/memory.current", "100000000\n");
        QCOMPARE(machine.free().bytes, 200e6);
        QCOMPARE(machine.free().bound, std::string("under the limit of its control group"));
        machine.put("sys/fs/cgroup/system.slice/job/memory.max", "50000000\n");
        QCOMPARE(machine.free().bytes, 50e6 - 5000);
    }
    /// Else nothing would ever fit after a file was read that is as large as the limit.
    void pagesOfFilesCountAsFree()
    {
        const Machine machine;
        machine.put("proc/self/cgroup", "0::/job\n");
        machine.put("sys/fs/cgroup/job/memory.max", "300000000\n");
        machine.put("sys/fs/cgroup/job/memory.current", "299000000\n");
        machine.put("sys/fs/cgroup/job/memory.stat", "anon 9000000\nfile 290000000\nactive_file 90000000\ninactive_file 200000000\n");
        QCOMPARE(machine.free().bytes, 291e6);
    }
    void theFirstVersionOfControlGroupsBoundsToo()
    {
        const Machine machine;
        machine.put("proc/self/cgroup", "9:name=systemd:/\n4:cpu,memory:/docker/abc\n0::/\n");
        machine.put("sys/fs/cgroup/memory/docker/abc/memory.limit_in_bytes", "9223372036854771712\n");
        machine.put("sys/fs/cgroup/memory/docker/abc/memory.usage_in_bytes", "1000\n");
        machine.put("sys/fs/cgroup/memory/docker/memory.limit_in_bytes", "500000000\n");
        machine.put("sys/fs/cgroup/memory/docker/memory.usage_in_bytes", "200000000\n");
        machine.put("sys/fs/cgroup/memory/docker/memory.stat", "total_inactive_file 50000000\ntotal_active_file 10000000\n");
        QCOMPARE(machine.free().bytes, 360e6);
    }
    /// In a container the folder of the group is the top, whatever its path says.
    void aGroupIsFoundInAContainer()
    {
        const Machine machine;
        machine.put("proc/self/cgroup", "4:memory:/docker/abc\n0::/../other\n");
        machine.put("sys/fs/cgroup/memory/memory.limit_in_bytes", "400000000\n");
        machine.put("sys/fs/cgroup/memory/memory.usage_in_bytes", "100000000\n");
        QCOMPARE(machine.free().bytes, 300e6);
        machine.put("sys/fs/cgroup/memory.max", "80000000\n");
        machine.put("sys/fs/cgroup/memory.current", "90000000\n");
        QCOMPARE(machine.free().bytes, 0.0); // over its limit already
    }
    void limitsOfTheProcessBound()
    {
        const Machine machine;
        machine.put("proc/meminfo", meminfo);
        machine.put("proc/self/status", "Name:\tx\nVmSize:\t  200000 kB\nVmData:\t   50000 kB\n");
        machine.put("proc/self/limits", "Limit                     Soft Limit           Hard Limit           Units     \n"
                                        "Max data size             unlimited            unlimited            bytes     \n"
                                        "Max address space         1024000000           unlimited            bytes     \n");
        QCOMPARE(machine.free().bytes, 1024e6 - 204.8e6);
        machine.put("proc/self/limits", "Max data size             100000000            unlimited            bytes     \n"
                                        "Max address space         1024000000           unlimited            bytes     \n");
        QCOMPARE(machine.free().bytes, 100e6 - 51.2e6);
    }
    void badFilesBoundNothing()
    {
        const Machine machine;
        machine.put("proc/meminfo", "MemAvailable: much\n");
        machine.put("proc/self/cgroup", "\n:\n::\n0::\n4:memory:\nnonsense\n");
        machine.put("sys/fs/cgroup/memory.max", "\n");
        machine.put("proc/self/limits", "Max address space\n");
        QVERIFY(std::isinf(machine.free().bytes));
    }
    void thisMachineHasSome()
    {
        const FreeMemory free = free_memory();
        QVERIFY(free.bytes > 1e6);
        QVERIFY(!free.bound.empty());
    }
    void muchIsWarnedOfAndMoreRefused()
    {
        const FreeMemory free{1e9, "on this machine"};
        QCOMPARE(ask_for_memory("This run", 0.69e9, {}, free), std::string());
        QCOMPARE(ask_for_memory("This run", 0.8e9, {}, free),
                 std::string("This run takes about 800 MB of memory; 1.0 GB are free on this machine. Other programs may slow down."));
        try {
            ask_for_memory("This run", 25.6e9, {false, "Begin with --force."}, free);
            QFAIL("It was not refused.");
        } catch (const NotEnoughMemory& error) {
            QCOMPARE(error.what(), "This run takes about 26 GB of memory; 1.0 GB are free on this machine. Begin with --force.");
            QCOMPARE(error.needed, 25.6e9);
            QCOMPARE(error.available, 1e9);
        }
        QCOMPARE(ask_for_memory("This run", 25.6e9, {true, ""}, free), std::string());
    }
    void jobsSideBySideFollowFromIt()
    {
        const FreeMemory free{1e9, "on this machine"};
        QCOMPARE(jobs_that_fit(8, 100e6, free), 7); // 70 %
        QCOMPARE(jobs_that_fit(3, 100e6, free), 3);
        QCOMPARE(jobs_that_fit(8, 5e9, free), 1);
        QCOMPARE(jobs_that_fit(0, 1, free), 1);
    }
};

QTEST_GUILESS_MAIN(TestFreeMemory)
#include "tst_free_memory.moc"
