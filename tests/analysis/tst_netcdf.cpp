// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// NetCDF files, read as their format says: names, units and values are those of the recording.
#include "core/analysis/metrics.h"
#include "core/analysis/netcdf_file.h"
#include "core/analysis/recording_netcdf.h"
#include "core/base/error.h"
#include "tests/support/crafted_recording.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <QtEndian>

#include <map>
#include <sstream>

using namespace hygroloom;

namespace tst_netcdf {
namespace {

/// Of the classic format with 64-bit offsets, texts as the only attributes.
struct Reader {
    struct Variable {
        std::vector<int> dimensions;
        std::map<std::string, std::string> attributes;
        int type = 0;
        qsizetype bytes = 0, begin = 0;
    };
    QByteArray all;
    qsizetype at = 4, record = 0; ///< bytes of a record
    int records = 0;
    std::vector<std::pair<std::string, int>> dimensions;
    std::map<std::string, std::string> attributes;
    std::map<std::string, Variable> variables;

    explicit Reader(const QByteArray& bytes) : all(bytes)
    {
        records = whole();
        for (int k = list(0x0A); k > 0; --k) {
            const std::string name = text();
            dimensions.emplace_back(name, whole());
        }
        attributes = texts();
        for (int k = list(0x0B); k > 0; --k) {
            const std::string name = text();
            Variable& of = variables[name];
            for (int d = whole(); d > 0; --d) of.dimensions.push_back(whole());
            of.attributes = texts();
            of.type = whole();
            of.bytes = whole();
            of.begin = static_cast<qsizetype>(qFromBigEndian<qint64>(all.constData() + at));
            at += 8;
            if (!of.dimensions.empty() && of.dimensions[0] == 0) record += of.bytes;
        }
    }
    int whole()
    {
        at += 4;
        return qFromBigEndian<qint32>(all.constData() + at - 4);
    }
    int list(int tag)
    {
        const int found = whole(), count = whole();
        return found == tag || (found == 0 && count == 0) ? count : -1;
    }
    std::string text()
    {
        const int size = whole();
        const qsizetype begin = at;
        at += (size + 3) / 4 * 4;
        return all.mid(begin, size).toStdString();
    }
    std::map<std::string, std::string> texts()
    {
        std::map<std::string, std::string> found;
        for (int k = list(0x0C); k > 0; --k) {
            const std::string name = text();
            if (whole() != 2) return {};
            found[name] = text();
        }
        return found;
    }
    /// One record's, or all.
    std::vector<double> values(const std::string& name, int number = 0) const
    {
        const Variable& of = variables.at(name);
        const char* const begin = all.constData() + of.begin + number * record;
        std::vector<double> found;
        for (qsizetype place = 0; place < of.bytes; place += of.type == 6 ? 8 : 4)
            found.push_back(of.type == 6   ? qFromBigEndian<double>(begin + place)
                            : of.type == 5 ? static_cast<double>(qFromBigEndian<float>(begin + place))
                                           : qFromBigEndian<qint32>(begin + place));
        return found;
    }
};

} // namespace

class TestNetcdf : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;

    QByteArray written(const std::string& recording, const std::string& path) const
    {
        const Recording read(recording);
        MetricsCollector collector;
        collector.start(read.run());
        for (int k = 0; k < read.frames(); ++k) collector.add(read.frame(k));
        write_netcdf(read, collector.metrics(), 2, path, [](double) { return true; });
        QFile file(QString::fromStdString(path));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

private Q_SLOTS:
    /// By hand, from the format's grammar.
    void aSmallFileHasTheBytesOfItsFormat()
    {
        std::ostringstream to;
        NetcdfWriter file(to, "t", 2);
        const int x = file.dimension("x", 1);
        file.attribute("a", "bc");
        file.variable("v", NetcdfType::whole, true, {x}, "m");
        file.write_head();
        const std::int32_t values[] = {1, 258};
        for (const std::int32_t& value : values) file.put(std::span<const std::int32_t>(&value, 1));
        const QByteArray expected = QByteArray::fromHex("43444602 00000002"
                                                        "0000000a00000002 0000000174000000 00000000 0000000178000000 00000001"
                                                        "0000000c00000001 0000000161000000 00000002 0000000262630000"
                                                        "0000000b00000001 0000000176000000 00000002 00000000 00000001"
                                                        "0000000c00000001 00000005756e697473000000 00000002 000000016d000000"
                                                        "00000004 00000004 0000000000000090 00000001 00000102");
        QCOMPARE(QByteArray::fromStdString(to.str()).toHex(), expected.toHex());
    }
    void valuesAreThoseOfTheRecording()
    {
        const std::string recording = folder_.filePath("small.hygrorec").toStdString();
        write_small_recording(recording);
        const QByteArray bytes = written(recording, folder_.filePath("small.nc").toStdString());
        QVERIFY(bytes.startsWith(QByteArray("CDF\2", 4)));
        const Reader file(bytes);
        const Recording read(recording);
        const auto n = static_cast<std::size_t>(read.run().textile.segments());
        QCOMPARE(file.records, 3);
        QCOMPARE(file.attributes.at("fabric"), read.run().fabric);
        QCOMPARE(file.dimensions[1].second, int(n));
        QCOMPARE(bytes.size(), file.variables.at("time").begin + 3 * file.record);
        for (int k = 0; k < 3; ++k) {
            const Frame frame = read.frame(k);
            QCOMPARE(file.values("time", k), std::vector<double>{frame.time});
            for (const FrameField& field : frame_fields) {
                QCOMPARE(file.variables.at(field.name).attributes.at("units"), std::string(field.unit));
                QCOMPARE(file.values(field.name, k), std::vector<double>(field.in(frame).begin(), field.in(frame).end()));
            }
            for (const LedgerColumn& column : ledger_columns)
                if (column.value != &Ledger::time) QCOMPARE(file.values(column.name, k), std::vector<double>{frame.ledger.*column.value});
        }
        QCOMPARE(file.values("weft").size(), n);
        QCOMPARE(file.values("weft").front(), 0.0);
        QCOMPARE(file.values("weft").back(), 1.0);
        QCOMPARE(file.variables.at("water_map").attributes.at("units"), std::string("g/m2"));
        const std::vector<double> map = file.values("water_map", 2);
        QCOMPARE(map.size(), 3 * file.values("x").size() * file.values("y").size());
        QVERIFY(std::abs(file.values("x").front() + file.values("x").back()) < 2 * read.run().textile.warp.pitch * 1e3);
    }
    void aCancelledFileLeavesTheOneBefore()
    {
        const std::string recording = folder_.filePath("small.hygrorec").toStdString(), path = folder_.filePath("kept.nc").toStdString();
        write_small_recording(recording);
        const QByteArray before = written(recording, path);
        const Recording read(recording);
        QVERIFY_EXCEPTION_THROWN(write_netcdf(read, Metrics{}, 2, path, [](double) { return false; }), Cancelled);
        QFile file(QString::fromStdString(path));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll() == before);
    }
};

} // namespace tst_netcdf

QTEST_GUILESS_MAIN(tst_netcdf::TestNetcdf)
#include "tst_netcdf.moc"
