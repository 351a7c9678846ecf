// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The page that a worn garment's recording becomes.
#include "core/wear/wear_report.h"

#include "core/base/error.h"
#include "core/base/round_up.h"
#include "tests/support/crafted_wear.h"

#include <QDir>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <set>

using namespace hygroloom;

class TestWearReport : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;

private Q_SLOTS:
    void initTestCase() { write_small_wear_recording(folder_.filePath("small.hygrorec").toStdString()); }

    void maps_are_at_the_times_asked_for()
    {
        const WearRecording recording(folder_.filePath("small.hygrorec").toStdString());
        std::vector<double> times;
        for (int k = 0; k < recording.frames(); ++k) times.push_back(recording.time_of(k));
        QCOMPARE(frames_for_report(times, {}), (std::vector{1, 2})); // 0.5, 1, 1.5 and 2 s of frames at 0, 1 and 2 s
        QCOMPARE(frames_for_report(times, {1.9, 0.1, 2.2}), (std::vector{0, 2}));
    }

    /// A dry picture and a wet one share the scale: the wet one's cells reach its end, the dry ones do not.
    void maps_share_a_scale()
    {
        const WearRecording recording(folder_.filePath("small.hygrorec").toStdString());
        WearMapOptions how;
        const WearMap last = wear_map(recording.record().layout, recording.frame(2), how);
        const std::vector<ReportPicture> alone = pictures_of_panels(recording, {1}, how), both = pictures_of_panels(recording, {1, 2}, how);
        QCOMPARE(alone.size(), std::size_t(2));
        QCOMPARE(both.size(), std::size_t(4));
        QVERIFY(alone[0].image.rgb != both[0].image.rgb);
        how.most = last.most();
        QVERIFY(pictures_of_panels(recording, {1}, how)[0].image.rgb == both[0].image.rgb);
    }

    /// Only the scale bar and its length are others.
    void the_scale_bar_is_in_the_readers_unit()
    {
        const WearRecord record = small_wear();
        WearMapOptions how;
        const WearFrame frame = small_wear_frame(record.layout, 2);
        const Image metric = panel_picture(record.layout, wear_map(record.layout, frame, how), 0, 2);
        how.units = [](const std::string& unit) { return unit == "mm" ? ReaderUnit{"in", 1 / 25.4} : ReaderUnit{unit}; };
        const Image inches = panel_picture(record.layout, wear_map(record.layout, frame, how), 0, 2);
        const FlatBox box = record.layout.panels[0].box();
        const double scale = 1000 / std::max(box.width(), box.height()); // pixels per metre
        const auto bar_of = [&](const Image& image) {
            const int y = image.height - 56 + 20;
            int length = 0;
            while (image.rgb[static_cast<std::size_t>(3 * (y * image.width + 24 + length))] < 128) ++length;
            return length / scale;
        };
        const double in_mm = 1e3 * bar_of(metric), in_inches = bar_of(inches) / 25.4e-3;
        const auto is_round = [](double length) {
            const double first = length / std::pow(10.0, std::floor(std::log10(1.005 * length)));
            return std::abs(first - 1) < 0.02 || std::abs(first - 2) < 0.04 || std::abs(first - 5) < 0.1;
        };
        QVERIFY2(is_round(in_mm), qPrintable(QString::number(in_mm)));
        QVERIFY2(is_round(in_inches) && !is_round(25.4 * in_inches), qPrintable(QString::number(in_inches)));
    }

    /// Steps with ends of their own: a cell has the colour of the step in which its value lies, in pictures as in textures.
    void steps_may_end_anywhere()
    {
        const WearSteps even = even_steps(80);
        QCOMPARE(even[0], 10.0);
        QCOMPARE(even[7], 80.0);
        QCOMPARE(step_of(even, 0), std::size_t(0));
        QCOMPARE(step_of(even, 9.99), std::size_t(0));
        QCOMPARE(step_of(even, 10), std::size_t(1));
        QCOMPARE(step_of(even, 1e6), std::size_t(7));
        QVERIFY_THROWS_EXCEPTION(Error, require_ascending({1, 2, 3, 4, 5, 6, 6, 8}));
        QVERIFY_THROWS_EXCEPTION(Error, require_ascending({0, 2, 3, 4, 5, 6, 7, 8}));
        const WearRecord record = small_wear();
        const WearFrame frame = small_wear_frame(record.layout, 2);
        WearMapOptions how;
        const double most = wear_map(record.layout, frame, how).most();
        how.steps = WearSteps{1e-3 * most, 2e-3 * most, 3e-3 * most, 4e-3 * most, 5e-3 * most, 6e-3 * most, 7e-3 * most, 2 * most};
        const WearMap map = wear_map(record.layout, frame, how);
        QCOMPARE(map.most(), 2 * most);
        const Image texture = panel_texture(record.layout, map, 0);
        const FlatBox box = record.layout.panels[0].box();
        int seen = 0;
        for (std::size_t i = 0; i < record.layout.cells.size(); ++i) {
            const GarmentCell& cell = record.layout.cells[i];
            const auto x = static_cast<int>((cell.flat[0] - box.left) / box.width() * texture.width),
                       y = static_cast<int>((box.high - cell.flat[1]) / box.height() * texture.height);
            if (cell.panel != 0 || x < 0 || y < 0 || x >= texture.width || y >= texture.height) continue;
            const auto colour = step_colour(map.values[i] > 7e-3 * most ? 7 : step_of(*how.steps, map.values[i]));
            const auto at = static_cast<std::size_t>(3 * (y * texture.width + x));
            QVERIFY(std::equal(colour.begin(), colour.end(), texture.rgb.begin() + static_cast<std::ptrdiff_t>(at)));
            seen += map.values[i] > 7e-3 * most ? 1 : 0;
        }
        QVERIFY(seen > 0);
        how.steps = WearSteps{1, 1, 1, 1, 1, 1, 1, 1};
        QVERIFY_THROWS_EXCEPTION(Error, wear_map(record.layout, frame, how));
    }

    /// A panel that is named as another's texture keeps a file of its own.
    void no_file_is_written_twice()
    {
        WearRecord record = small_wear();
        record.layout.panels[0].name = "x";
        record.layout.panels[1].name = "x_texture";
        const WearFrame frame = small_wear_frame(record.layout, 2);
        const QString folder = folder_.filePath("twice");
        QVERIFY(QDir().mkpath(folder));
        const std::vector<std::string> files =
            write_wear_map(record.layout, frame, wear_map(record.layout, frame, {}), folder.toStdString());
        QCOMPARE(std::set<std::string>(files.begin(), files.end()).size(), files.size());
        QCOMPARE(std::size_t(QDir(folder).entryList(QDir::Files).size()), files.size());
    }

    void the_page_holds_it_all()
    {
        const WearRecording recording(folder_.filePath("small.hygrorec").toStdString());
        WearMetrics metrics(recording.record().layout);
        for (int k = 0; k < recording.frames(); ++k) metrics.add(recording.frame(k));
        const QString html = QString::fromStdString(
            html_of(wear_report(recording.record(), metrics, pictures_of_panels(recording, {1, 2}, {}), recording.finished())));
        QCOMPARE(html.count("<img "), 4);
        QVERIFY(html.count("<svg ") >= 4);
        for (const char* words : {"tee, run", "<th>front</th>", "<th>sleeve</th>", "front, at 1 s", "sleeve, at 2 s", "35 g/m²", "0.3 mm",
                                  "cells of 8 x 8 mm, 2 x 2 crossings", "Zones of the body", "not accounted for", "a device"})
            QVERIFY2(html.contains(words), words);
        const double water = 1e3 * metrics.all().course.back().water;
        QVERIFY(html.contains(QString("<th>water</th><td class=\"number\">%1</td>").arg(QString::number(water, 'g', 4))));
        for (const char* tag : {"table", "tr", "td", "th", "figure", "svg", "details", "ul", "li", "p"})
            QCOMPARE(html.count(QRegularExpression(QString("<%1[ >]").arg(tag))), html.count(QString("</%1>").arg(tag)));
        QVERIFY(!html.contains("The run was stopped"));
        QVERIFY(html_of(wear_report(recording.record(), metrics, {}, false)).find("The run was stopped at 2 s.") != std::string::npos);
    }

    void inputs_are_in_the_readers_units()
    {
        const WearRecord record = small_wear();
        WearMetrics metrics(record.layout);
        for (int k = 0; k < 2; ++k) metrics.add(small_wear_frame(record.layout, k));
        const ReaderUnits inches = [](const std::string& unit) {
            return unit == "/cm" ? ReaderUnit{"/in", 2.54} : unit == "mm" ? ReaderUnit{"in", 1 / 25.4} : ReaderUnit{unit};
        };
        const QString metric = QString::fromStdString(html_of(wear_report(record, metrics, {}, true)));
        const QString imperial = QString::fromStdString(html_of(wear_report(record, metrics, {}, true, inches)));
        QVERIFY(metric.contains(" /cm</td>") && !metric.contains(" /in</td>"));
        QVERIFY(!imperial.contains(" /cm</td>") && imperial.contains(" /in</td>"));
    }

    /// What is rounding beside the water that was given is none.
    void rounding_is_no_water()
    {
        const WearRecording recording(folder_.filePath("small.hygrorec").toStdString());
        WearMetrics metrics(recording.record().layout);
        for (int k = 0; k < recording.frames(); ++k) {
            WearFrame frame = recording.frame(k);
            frame.ledger.water_delivered = 0.1;
            frame.ledger.water_free = 4e-17;
            frame.ledger.water_dripped = 2e-10;
            metrics.add(frame);
        }
        const QString html = QString::fromStdString(html_of(wear_report(recording.record(), metrics, {}, true)));
        QVERIFY(html.contains("<th>on the skin</th><td class=\"number\">0</td>"));
        QVERIFY(html.contains("<th>dripped</th><td class=\"number\">2e-07</td>"));
        QVERIFY(html.contains("of all water"));
    }

    /// The scale of shares ends at a round step over what is there, as that of water does.
    void scales_follow_the_data()
    {
        const WearRecording recording(folder_.filePath("small.hygrorec").toStdString());
        WearMapOptions how;
        for (WearScale scale : {WearScale::same, WearScale::capacity}) {
            how.scale = scale;
            const WearMap map = wear_map(recording.record().layout, recording.frame(2), how);
            const double most = *std::max_element(map.values.begin(), map.values.end());
            QVERIFY(map.most() >= most && map.most() <= 1.25 * most);
            QCOMPARE(map.most(), rounded_up(most));
        }
        QCOMPARE(rounded_up(0), 1.0);
        QCOMPARE(rounded_up(3e-14), 1.0); // a dry garment is white
        QCOMPARE(rounded_up(0.27), 0.3);
        QCOMPARE(rounded_up(169), 200.0);
        QCOMPARE(rounded_up(87), 100.0);
        how.most = 0.5;
        QCOMPARE(wear_map(recording.record().layout, recording.frame(2), how).most(), 0.5);
    }

    void names_of_strangers_are_text()
    {
        WearRecord record = small_wear();
        record.layout.panels[0].name = "<script>";
        WearMetrics metrics(record.layout);
        for (int k = 0; k < 2; ++k) metrics.add(small_wear_frame(record.layout, k));
        const std::string html = html_of(wear_report(record, metrics, {}, true));
        QVERIFY(html.find("<script>") == std::string::npos);
        QVERIFY(html.find("&lt;script&gt;") != std::string::npos);
    }
};

QTEST_GUILESS_MAIN(TestWearReport)
#include "tst_wear_report.moc"
