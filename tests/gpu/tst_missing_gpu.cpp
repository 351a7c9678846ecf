// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What `devices` says of machines that lack one thing each; they are drawn as folders.
#include "gpu/missing_gpu.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace hygroloom;

namespace {

/// A machine on which nothing is amiss.
const QMap<QString, QByteArray> whole{
    {"sys/bus/pci/devices/0000:01:00.0/vendor", "0x10de\n"},
    {"sys/bus/pci/devices/0000:01:00.0/class", "0x030200\n"},
    {"proc/driver/nvidia/version", "NVRM version: NVIDIA UNIX x86_64 Kernel Module  535.183.01  Sun May 12 19:39:15 UTC 2024\n"},
    {"usr/lib/x86_64-linux-gnu/libcuda.so.535.183.01", ""},
    {"usr/lib/x86_64-linux-gnu/libcuda.so.1", ""},
    {"dev/nvidiactl", ""},
    {"dev/nvidia0", ""},
    {"dev/nvidia-uvm", ""}};

std::string cause_on(const QMap<QString, QByteArray>& files, int driver = 12040, int runtime = 12040)
{
    const QTemporaryDir root;
    for (auto file = files.begin(); file != files.end(); ++file) {
        const QString path = root.filePath(file.key());
        QDir().mkpath(QFileInfo(path).path());
        QFile written(path);
        if (!written.open(QIODevice::WriteOnly) || written.write(file.value()) != file.value().size()) return "not written";
    }
    return missing_gpu_cause(gpu_surroundings(root.path().toStdString()), driver, runtime);
}

} // namespace

class TestMissingGpu : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { qunsetenv("CUDA_VISIBLE_DEVICES"); }
    void whatLacksIsNamed_data()
    {
        QTest::addColumn<QStringList>("without");
        QTest::addColumn<QStringList>("with");
        QTest::addColumn<QString>("said");
        const QString pci = "sys/bus/pci/devices/0000:01:00.0/vendor", module = "proc/driver/nvidia/version";
        const QString library = "usr/lib/x86_64-linux-gnu/libcuda.so.535.183.01";
        QTest::newRow("no card") << QStringList{pci, module} << QStringList{} << "no NVIDIA GPU";
        QTest::newRow("no driver") << QStringList{module} << QStringList{} << "driver is not loaded";
        QTest::newRow("no device files") << QStringList{"dev/nvidia0"} << QStringList{} << "nvidia-modprobe";
        QTest::newRow("a container without them") << QStringList{"dev/nvidiactl"} << QStringList{".dockerenv"} << "docker --gpus all";
        QTest::newRow("no nvidia_uvm") << QStringList{"dev/nvidia-uvm"} << QStringList{} << "nvidia_uvm is not loaded";
        QTest::newRow("a container without nvidia_uvm")
            << QStringList{"dev/nvidia-uvm"} << QStringList{"run/.containerenv"} << "outside the container";
        QTest::newRow("a driver that was updated") << QStringList{library} << QStringList{"usr/lib64/libcuda.so.550.54.14"}
                                                   << "535.183.01, its library libcuda is 550.54.14. Start the machine again";
    }
    void whatLacksIsNamed()
    {
        QFETCH(QStringList, without);
        QFETCH(QStringList, with);
        QFETCH(QString, said);
        QMap<QString, QByteArray> files = whole;
        for (const QString& file : without) files.remove(file);
        for (const QString& file : with) files.insert(file, "");
        const std::string cause = cause_on(files);
        QVERIFY2(QString::fromStdString(cause).contains(said), cause.c_str());
    }
    void aDriverTooOldIsNamedWithBothVersions()
    {
        QCOMPARE(cause_on(whole, 11080, 12040),
                 std::string("The driver supports CUDA 11.8, this program needs CUDA 12.4. Update the driver."));
        QVERIFY(cause_on(whole, 0).find("libcuda.so.1 is not found") != std::string::npos);
    }
    void hiddenGpusAreNamed()
    {
        for (const char* hidden : {"", "-1"}) {
            qputenv("CUDA_VISIBLE_DEVICES", hidden);
            QVERIFY(cause_on(whole).starts_with("CUDA_VISIBLE_DEVICES hides"));
        }
        qputenv("CUDA_VISIBLE_DEVICES", "0");
        QCOMPARE(cause_on(whole), std::string());
    }
    void aWholeMachineHasNoCause() { QCOMPARE(cause_on(whole), std::string()); }
};

QTEST_APPLESS_MAIN(TestMissingGpu)
#include "tst_missing_gpu.moc"
