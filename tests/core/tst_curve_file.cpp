// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// BCC and USDA are read back by what their descriptions say.
#include "core/project/mesh_file.h"

#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <cstring>
#include <fstream>

using namespace hygroloom;
namespace fs = std::filesystem;

namespace {

Fabric fabric()
{
    Fabric fabric;
    fabric.name = "cloth";
    fabric.warp.diameter_mm = fabric.weft.diameter_mm = 0.2;
    fabric.weft.fibres_per_yarn = 12;
    fabric.weft.color = Color{255, 0, 0};
    fabric.flyaway = {0.5, 2, 0.1, 0.5};
    return fabric;
}

Textile cloth() { return build_textile({}, fabric(), {0, 0, 4, 3}); }

ExportOptions with(MeshDetail detail)
{
    ExportOptions options;
    options.mesh = {detail, 8, 6, true, true, 1};
    return options;
}

std::string text_of(const fs::path& path)
{
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

template <typename Value> Value at(const std::string& bytes, std::size_t place)
{
    Value value{};
    std::memcpy(&value, bytes.data() + place, sizeof value);
    return value;
}

/// Every curve in the order of the file, mm.
std::vector<std::vector<float>> curves_of(const Textile& textile, const FibreOptions& options)
{
    std::vector<std::vector<float>> curves;
    for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
        for (int yarn = 0; yarn < textile.system(kind).count; ++yarn) {
            const YarnFibres fibres(textile, options, kind, yarn, 0, kind == YarnKind::warp ? textile.picks() : textile.ends());
            for (int strand = 0; strand < fibres.strands(); ++strand) {
                curves.emplace_back(3 * fibres.points(strand));
                fibres.curve(strand, curves.back().data());
                for (float& value : curves.back()) value *= 1000;
            }
        }
    return curves;
}

std::vector<double> numbers(QString text)
{
    std::vector<double> values;
    for (const QString& part : text.remove('(').remove(')').split(',')) values.push_back(part.toDouble());
    return values;
}

} // namespace

class TestCurveFile : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;
    fs::path path(const std::string& name) const { return fs::path(folder_.path().toStdString()) / name; }

private Q_SLOTS:
    void bccHoldsEveryFibre()
    {
        const Textile textile = cloth();
        const ExportOptions options = with(MeshDetail::fibre);
        const ExportEstimate size = export_estimate(textile, fabric(), options, MeshFormat::bcc);
        const Exported exported = export_textile(textile, fabric(), options, path("cloth.bcc"));
        QCOMPARE(double(exported.bytes), size.bytes);
        const std::string bcc = text_of(path("cloth.bcc"));
        QCOMPARE(bcc.substr(0, 8), std::string("BCC\x44"
                                               "C0\x03\x02",
                                               8));
        const auto expected = curves_of(textile, options.mesh.fibres());
        QCOMPARE(at<std::uint64_t>(bcc, 8), std::uint64_t(expected.size()));
        QCOMPARE(std::size_t(size.curves), expected.size());
        QCOMPARE(at<std::uint64_t>(bcc, 16), std::uint64_t(size.vertices));
        const double thickest = 1e3 * std::max(drawn_fibre_radius(textile.warp.types[0]), drawn_fibre_radius(textile.weft.types[0]));
        const QString remark = QString::fromLatin1(&bcc[24], 40).remove(QChar('\0'));
        const auto match = QRegularExpression("^mm; fibre radius ([0-9.]+)-([0-9.]+)$").match(remark);
        QVERIFY2(match.hasMatch(), qPrintable(remark));
        QVERIFY(std::abs(match.captured(2).toDouble() - thickest) < 1e-5);
        std::size_t place = 64;
        for (const auto& curve : expected) {
            QCOMPARE(std::size_t(at<std::int32_t>(bcc, place)), curve.size() / 3);
            place += 4;
            QVERIFY(std::memcmp(&bcc[place], curve.data(), 4 * curve.size()) == 0);
            place += 4 * curve.size();
        }
        QCOMPARE(place, bcc.size());
    }
    void usdaSaysUnitAxisWidthsAndPoints()
    {
        const Textile textile = cloth();
        const ExportOptions options = with(MeshDetail::fibre);
        const ExportEstimate size = export_estimate(textile, fabric(), options, MeshFormat::usda);
        const Exported exported = export_textile(textile, fabric(), options, path("cloth.usda"));
        QVERIFY(std::abs(static_cast<double>(exported.bytes) / size.bytes - 1) < 0.25);
        const QString usda = QString::fromStdString(text_of(path("cloth.usda")));
        QVERIFY(usda.startsWith("#usda 1.0\n"));
        QVERIFY(usda.contains("metersPerUnit = 0.001") && usda.contains("upAxis = \"Z\""));
        QCOMPARE(usda.count("def BasisCurves \"warp_00"), 4);
        QCOMPARE(usda.count("def BasisCurves \"weft_00"), 3);
        QCOMPARE(usda.count('{'), usda.count('}'));
        const QRegularExpression pattern(
            "curveVertexCounts = \\[([^]]*)\\].*?widths = \\[([^]]*)\\].*?displayColor = \\[([^]]*)\\].*?points = \\[([^]]*)\\]",
            QRegularExpression::DotMatchesEverythingOption);
        const auto expected = curves_of(textile, options.mesh.fibres());
        std::size_t curve = 0;
        int yarn = 0;
        for (auto match = pattern.globalMatch(usda); match.hasNext(); ++yarn) {
            const auto one = match.next();
            const auto counts = numbers(one.captured(1)), widths = numbers(one.captured(2)), points = numbers(one.captured(4));
            QCOMPARE(counts.size(), widths.size());
            const YarnType& type = yarn < 4 ? textile.warp.types[0] : textile.weft.types[0];
            QVERIFY(std::abs(widths[0] - 2e3 * drawn_fibre_radius(type)) < 1e-6);
            QCOMPARE(numbers(one.captured(3))[1] < 0.01, yarn >= 4); // the red weft has no green
            std::size_t value = 0;
            for (double count : counts) {
                QCOMPARE(3 * static_cast<std::size_t>(count), expected[curve].size());
                for (float coordinate : expected[curve]) QVERIFY(std::abs(points[value++] - static_cast<double>(coordinate)) < 1.1e-5);
                ++curve;
            }
            QCOMPARE(value, points.size());
        }
        QCOMPARE(yarn, 7);
        QCOMPARE(curve, size.curves);
    }
    void centrelinesHaveTheYarnsWidth()
    {
        const Textile textile = cloth();
        export_textile(textile, fabric(), with(MeshDetail::centreline), path("lines.bcc"));
        const std::string bcc = text_of(path("lines.bcc"));
        QCOMPARE(at<std::uint64_t>(bcc, 8), std::uint64_t(7));
        const MiddleLine line = yarn_lines(textile, 8)[0];
        QCOMPARE(std::size_t(at<std::int32_t>(bcc, 64)), line.positions.size() / 3);
        QCOMPARE(at<float>(bcc, 68), 1000 * line.positions[0]);
        QVERIFY(bcc.substr(24, 40).find("yarn radius 0.") != std::string::npos);
        export_textile(textile, fabric(), with(MeshDetail::centreline), path("lines.usda"));
        const QString usda = QString::fromStdString(text_of(path("lines.usda")));
        const auto match = QRegularExpression("widths = \\[([^]]*)\\]").match(usda);
        QVERIFY(std::abs(match.captured(1).toDouble() - 2e3 * std::sqrt(textile.warp.types[0].area / M_PI)) < 1e-6);
    }
    void waterColoursUsdCurves()
    {
        const Textile textile = cloth();
        ExportOptions options = with(MeshDetail::fibre);
        options.saturation.assign(static_cast<std::size_t>(textile.segments()), 1.0f);
        export_textile(textile, fabric(), options, path("wet.usda"));
        const QString usda = QString::fromStdString(text_of(path("wet.usda")));
        const auto match = QRegularExpression("displayColor = \\[([^]]*)\\]").match(usda);
        const auto colors = numbers(match.captured(1));
        const auto points = numbers(QRegularExpression("points = \\[([^]]*)\\]").match(usda).captured(1));
        QCOMPARE(colors.size(), points.size());
        QVERIFY(std::abs(colors[2] - 0.1500) < 2e-4); // of 108 / 255
        QVERIFY(!export_estimate(textile, fabric(), options, MeshFormat::bcc).refusal.empty());
    }
};

QTEST_APPLESS_MAIN(TestCurveFile)
#include "tst_curve_file.moc"
