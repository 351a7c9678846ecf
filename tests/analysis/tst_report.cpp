// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A made-up recording as a page and as files for ParaView, read back.
#include "core/analysis/line_chart.h"
#include "core/analysis/report.h"
#include "core/analysis/vtk_files.h"
#include "core/base/error.h"
#include "tests/support/drop_design.h"
#include "tests/support/vtp.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include <cstring>
#include <limits>

using namespace hygroloom;

namespace {

RunRecord run_of_cloth(double width_mm, double height_mm)
{
    RunRecord run;
    run.design = drop_design();
    run.fabric = run.design.fabrics[0].name;
    run.experiment = run.design.experiments[0].name;
    run.design.experiments[0].sample_mm = {width_mm, height_mm};
    run.plan.region = region_of_sample(run.design.fabrics[0], width_mm, height_mm);
    run.textile = build_textile(run.design, run.design.fabrics[0], run.plan.region);
    run.backend = "cpu";
    return run;
}

/// Segment i is i degrees over 20 and holds i ng of liquid.
Frame frame_at_time(const Textile& textile, double time, std::size_t particles)
{
    Frame frame;
    frame.time = frame.ledger.time = time;
    for (int i = 0; i < textile.segments(); ++i) {
        const auto number = static_cast<float>(i);
        frame.saturation.push_back(0.01f * number);
        frame.liquid.push_back(1e-12f * number);
        frame.regain.push_back(0.07f);
        frame.vapour.push_back(0.01f);
        frame.temperature.push_back(293.15f + number);
        frame.between.push_back(0);
    }
    for (std::size_t i = 0; i < particles; ++i) {
        frame.positions.push_back({0.001f * static_cast<float>(i), 0, 0.002f});
        frame.velocities.push_back({0, 0, -1});
    }
    frame.ledger.water_delivered = 1e-6;
    frame.ledger.water_free = 1e-9 * static_cast<double>(particles);
    return frame;
}

} // namespace

class TestReport : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void yarnsAreLinesWithWhatTheyHold()
    {
        const RunRecord run = record(1.5, 0.9);
        const Textile& t = run.textile;
        QCOMPARE(write_vtk(Recording(file().toStdString()), folder(), 2, [](double) { return true; }), 3); // 0, 2 and the last
        for (const char* name : {"yarns_000000.vtp", "yarns_000001.vtp", "yarns_000002.vtp"}) {
            const Vtp vtp(dir_.filePath(name));
            QVERIFY(vtp.well_formed);
            QCOMPARE(vtp.count.at("NumberOfLines"), t.segments());
            const auto points = vtp.values<float>("Points");
            QCOMPARE(points.size(), 3 * static_cast<std::size_t>(vtp.count.at("NumberOfPoints")));
            const auto places = vtp.values<std::int32_t>("connectivity"), ends = vtp.values<std::int32_t>("offsets");
            const auto segment = vtp.values<std::int32_t>("segment"), end = vtp.values<std::int32_t>("end"),
                       pick = vtp.values<std::int32_t>("pick");
            const auto warp = vtp.values<std::uint8_t>("warp"), top = vtp.values<std::uint8_t>("top");
            const auto temperature = vtp.values<float>("temperature_c"), content = vtp.values<float>("water_content_kg_kg");
            for (std::size_t i = 0; i < segment.size(); ++i) {
                QCOMPARE(segment[i], static_cast<int>(i));
                const YarnKind kind = warp[i] ? YarnKind::warp : YarnKind::weft;
                QCOMPARE(t.segment(kind, end[i], pick[i]), segment[i]);
                QCOMPARE(top[i] == warp[i], t.warp_up(end[i], pick[i]));
                QVERIFY(std::abs(temperature[i] - (20.0f + static_cast<float>(i))) < 1e-3f);
                const YarnType& type = t.type(kind, warp[i] ? end[i] : pick[i]);
                const double dry = type.area * type.packing * type.fibre.density_kg_m3 * t.segment_length(kind, end[i], pick[i]);
                QVERIFY(std::abs(static_cast<double>(content[i]) - (0.07 + 1e-12 * static_cast<double>(i) / dry)) < 1e-6);
                // The middle of three points is the crossing.
                QCOMPARE(ends[i], 3 * static_cast<int>(i + 1));
                const auto middle = static_cast<std::size_t>(places[3 * i + 1]);
                const double x = t.x_of_end(end[i]) + (warp[i] ? t.shift_at_crossing(kind, end[i], pick[i]) : 0);
                const double y = t.y_of_pick(pick[i]) + (warp[i] ? 0 : t.shift_at_crossing(kind, end[i], pick[i]));
                const double place[3] = {x, y, t.height_at_crossing(kind, end[i], pick[i])};
                for (std::size_t axis = 0; axis < 3; ++axis)
                    QVERIFY(std::abs(static_cast<double>(points[3 * middle + axis]) - 1e3 * place[axis]) < 1e-5);
            }
        }
    }
    void timesAreNamedAndLiquidIsThere()
    {
        record(0.6, 0.6);
        write_vtk(Recording(file().toStdString()), folder(), 1, [](double) { return true; });
        for (const char* name : {"yarns", "liquid"}) {
            QFile series(dir_.filePath(name + QStringLiteral(".vtp.series")));
            QVERIFY(series.open(QIODevice::ReadOnly));
            const QJsonArray files = QJsonDocument::fromJson(series.readAll()).object()["files"].toArray();
            QCOMPARE(files.size(), 4);
            for (int i = 0; i < 4; ++i) {
                QCOMPARE(files[i].toObject()["time"].toDouble(), 0.1 * i);
                QVERIFY(QFile::exists(dir_.filePath(files[i].toObject()["name"].toString())));
            }
            QFile collection(dir_.filePath(name + QStringLiteral(".pvd")));
            QVERIFY(collection.open(QIODevice::ReadOnly));
            QCOMPARE(collection.readAll().count("<DataSet timestep="), 4);
        }
        for (int i = 0; i < 4; ++i) {
            const Vtp liquid(dir_.filePath(QStringLiteral("liquid_00000%1.vtp").arg(i)));
            QVERIFY(liquid.well_formed);
            QCOMPARE(liquid.count.at("NumberOfVerts"), 3 - i);
            QCOMPARE(liquid.values<float>("velocity_m_s").size(), static_cast<std::size_t>(3 * (3 - i)));
        }
    }
    void anotherRecordingTakesTheFolderOver()
    {
        record(0.6, 0.6);
        write_vtk(Recording(file().toStdString()), folder(), 1, [](double) { return true; });
        QVERIFY(QFile::exists(dir_.filePath("liquid.pvd")));
        const RunRecord run = run_of_cloth(0.6, 0.6);
        {
            RecordingWriter writer(file().toStdString(), run);
            writer.append(frame_at_time(run.textile, 0, 0));
            writer.finish(1);
        }
        QCOMPARE(write_vtk(Recording(file().toStdString()), folder(), 1, [](double) { return true; }), 1);
        QVERIFY(QFile::exists(dir_.filePath("yarns.pvd")) && !QFile::exists(dir_.filePath("liquid.pvd")));
    }
    void cancellingLeavesNoIndex()
    {
        record(0.6, 0.6);
        QTemporaryDir other;
        QVERIFY_THROWS_EXCEPTION(
            Cancelled, write_vtk(Recording(file().toStdString()), other.path().toStdString(), 1, [](double share) { return share < 0.4; }));
        QVERIFY(QFile::exists(other.filePath("yarns_000000.vtp")) && !QFile::exists(other.filePath("yarns.pvd")));
    }
    void reportNamesResultsInputAndOrigin()
    {
        RunRecord run = run_of_cloth(1.2, 1.2);
        MetricsCollector collector;
        collector.start(run);
        for (int i = 0; i < 4; ++i) collector.add(frame_at_time(run.textile, 0.1 * i, 3));
        Metrics metrics = collector.metrics();
        metrics.series.regain_mean[1] = std::numeric_limits<double>::quiet_NaN(); // a gap
        metrics.notes = {"1 < 2 & \"so\""};
        run.plan.knobs = knobs_of(run.plan.fidelity);
        run.plan.knobs.particles_per_droplet = 123;
        run.plan.parts = {{"heat", false, true, "It was switched off by the user.", {}, false}};
        Image image{2, 1, {255, 0, 0, 0, 0, 255}};
        const QString html = QString::fromStdString(html_of(report_of(run, metrics, {{"Top face", image}}, true)));
        for (const char* part :
             {"wetted radius, top", "absorbency time", "1 &lt; 2 &amp; &quot;so&quot;", "data:image/png;base64,iVBORw0KGgo",
              "water imbalance", "cover factor", "mass per area", "radius", "<th>droplets</th><td>volume ", " µl, time ", "surface tension",
              "fidelity", "<svg", ">123<", "It was switched off by the user.", "smallest circle around all wet crossings"})
            QVERIFY2(html.contains(part), part);
        QVERIFY(!html.contains("was stopped"));
        // No key of a file stands among the words.
        QVERIFY(html.indexOf("<h2>Computation</h2>") > html.indexOf("<h2>Inputs</h2>"));
        QString words = html;
        words.remove(QRegularExpression("<style>.*</style>|base64,[^\"]*", QRegularExpression::DotMatchesEverythingOption));
        const auto key = QRegularExpression("[a-z]+_[a-z_]+").match(words);
        QVERIFY2(!key.hasMatch(), qPrintable(key.captured()));
        QVERIFY(html_of(report_of(run, metrics, {}, false)).find("was stopped at 0.3 s") != std::string::npos);
        const auto from = html.indexOf("base64,") + 7;
        const QByteArray png =
            QByteArray::fromBase64(html.mid(from, html.indexOf('"', from) - from).toLatin1(), QByteArray::AbortOnBase64DecodingErrors);
        QCOMPARE(std::string(png.constData(), static_cast<std::size_t>(png.size())), png_bytes(image));
    }
    void aPageIsTheSameAfterItsJsonAndCanBeReadAsText()
    {
        PageCell verdict{"4.8", PageCell::Kind::number, {"better"}, "measured 5"};
        verdict.columns = 2;
        const ReportPage page{"Stain < 5 mm",
                              joined({section("Results", table({row_of_headings({"fabric", "radius, mm"}),
                                                                row("Köper", "4.81", "mm", "grade 4 of 5"),
                                                                row("Leinwand", "12.34", "mm", "its edge was wet from 3 s on"),
                                                                {{"Satin", PageCell::Kind::heading}, verdict}})),
                                      section("Notes", list({"One.", "Two."})),
                                      {PageText{"It is so.", "Mind:"}},
                                      {PageDrawing{"<svg/>", "a curve"}},
                                      {PagePicture{std::string("\x89PNG\0\xff", 6), "a map"}},
                                      {PagePicture{std::string("\x89PNG\0\xff", 6), "a cloth", 40}},
                                      section("Empty", {})})};
        const ReportPage again = page_from_json(json_of(page));
        QCOMPARE(json_of(again), json_of(page));
        QCOMPARE(html_of(again), html_of(page));
        QVERIFY(html_of(page).find("<td class=\"number\" colspan=\"2\">4.8<br><b>better</b><br>measured 5</td>") != std::string::npos);
        // The page's own rule narrows no true scale.
        QVERIFY(html_of(page).find(" style=\"width:40.00mm;max-width:none\">") != std::string::npos);
        QCOMPARE(text_of(page), std::string("Stain < 5 mm\n============\n"
                                            "\nResults\n-------\n"
                                            "fabric    radius, mm\n"
                                            "Köper      4.81  mm  grade 4 of 5\n"
                                            "Leinwand  12.34  mm  its edge was wet from 3 s on\n"
                                            "Satin     4.8, better, measured 5\n"
                                            "\nNotes\n-----\n- One.\n- Two.\n"
                                            "Mind: It is so.\n[a curve]\n[a map]\n[a cloth]\n"));
        QVERIFY(written_as(page, "a.HTML") == html_of(page) && written_as(page, "a.txt") == text_of(page) &&
                written_as(page, "a.pdf").empty());
        for (const char* wrong : {"", "{}", "[1]", R"({"title": "a", "blocks": [{"picture": "*", "caption": ""}]})",
                                  R"({"title": "a", "blocks": [{"table": [[{"text": "a", "kind": "b"}]]}]})"})
            QVERIFY_EXCEPTION_THROWN(page_from_json(wrong), Error);
    }
    void chartLeavesGapsAndSurvivesFlatCurves()
    {
        const double none = std::numeric_limits<double>::quiet_NaN();
        for (const std::vector<double>& values :
             {std::vector<double>{1, none, 2}, {0, 0, 0}, {-5, -5, -5}, {none, none, none}, {1e300, -1e300, 0}}) {
            const std::string svg = svg_of({"t <", "time, s", "mm", {0, 1, 2}, {{"a", values}}});
            QXmlStreamReader xml(QByteArray::fromStdString(svg));
            while (!xml.atEnd()) xml.readNext();
            QVERIFY2(!xml.hasError(), svg.c_str());
            for (const char* wrong : {"nan", "inf"}) QVERIFY2(svg.find(wrong) == std::string::npos, svg.c_str());
        }
    }

private:
    QString file() const { return dir_.filePath("run.hygrorec"); }
    std::filesystem::path folder() const { return dir_.path().toStdString(); }
    /// Four frames; one particle fewer in each.
    RunRecord record(double width_mm, double height_mm)
    {
        const RunRecord run = run_of_cloth(width_mm, height_mm);
        RecordingWriter writer(file().toStdString(), run);
        for (int i = 0; i < 4; ++i) writer.append(frame_at_time(run.textile, 0.1 * i, static_cast<std::size_t>(3 - i)));
        writer.finish(1);
        return run;
    }
    QTemporaryDir dir_;
};

QTEST_APPLESS_MAIN(TestReport)
#include "tst_report.moc"
