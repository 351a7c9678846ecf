// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Rates of sweat and temperatures of skin over time, from a file: what it may hold, and that it acts as it says.
#include "core/base/error.h"
#include "core/base/units.h"
#include "core/project/project_file.h"
#include "core/wear/wear_metrics.h"
#include "core/wear/wear_recording.h"
#include "tests/wear/flat_garment.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace hygroloom;

namespace tst_wear_course {
namespace {

constexpr double duration = 60;

struct Finished {
    WearLayout layout;
    std::vector<WearFrame> frames;
    double area = 0;
};

Finished run(Tee& tee)
{
    const GarmentScene garment = tee.scene(40e-3, true, true);
    Finished finished{wear_layout(tee.parts, garment), {}};
    for (const GarmentCell& cell : garment.cells) finished.area += cell.area;
    const std::unique_ptr<Backend> cpu = make_cpu_backend();
    RunControl control;
    run_wear(garment, tee.wear, *cpu, control,
             {[&](const std::shared_ptr<const WearFrame>& frame) { finished.frames.push_back(*frame); }, {}});
    return finished;
}

/// kg that came by a time.
double delivered(const Finished& run, double time)
{
    for (const WearFrame& frame : run.frames)
        if (std::abs(frame.time - time) < 1e-9) return frame.ledger.water_delivered;
    throw Error("there is no frame at this time");
}

bool same_cells(const Finished& a, const Finished& b)
{
    if (a.frames.size() != b.frames.size()) return false;
    for (std::size_t k = 0; k < a.frames.size(); ++k) {
        const WearFrame &x = a.frames[k], &y = b.frames[k];
        if (x.time != y.time || x.inside != y.inside || x.outside != y.outside || x.evaporated != y.evaporated ||
            x.temperature != y.temperature || x.on_skin != y.on_skin)
            return false;
    }
    return true;
}

} // namespace

class TestWearCourse : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;

    SweatCourse course(const std::string& text)
    {
        QFile file(folder_.filePath("rates.csv"));
        if (!file.open(QIODevice::WriteOnly)) throw Error("no file");
        file.write(text.c_str());
        file.close();
        return sweat_course("rates.csv", folder_.path().toStdString());
    }
    Finished run_with(const std::string& text)
    {
        Tee tee(duration);
        tee.wear.activity_file = "rates.csv";
        tee.parts.course = course(text);
        return run(tee);
    }
    /// The shipped table at some times, with what follows each row.
    static std::string as_table(const std::vector<double>& times, const char* header, const char* behind)
    {
        const SweatTable table = sweat_table("taylor-2013 exercise", {});
        std::string text = header;
        for (const double time : times)
            for (std::size_t zone = 0; zone < body_zones().size(); ++zone)
                text += QString("%1,%2,%3%4\n").arg(time).arg(body_zones()[zone].c_str()).arg(table.g_m2_h[zone]).arg(behind).toStdString();
        return text;
    }

private Q_SLOTS:
    void a_constant_file_is_the_table()
    {
        Tee plain(duration);
        const Finished by_table = run(plain);
        QVERIFY(by_table.frames.back().ledger.water_delivered > 0);
        QVERIFY(same_cells(by_table, run_with(as_table({0}, "time_s,zone,g_m2_h\n", ""))));
        QVERIFY(same_cells(by_table, run_with(as_table({0, 20, 3000}, "time_s,zone,g_m2_h\n", ""))));
        QVERIFY(same_cells(by_table, run_with(as_table({5, 20}, "time_s,zone,g_m2_h,skin_temperature_c\n", ",34"))));
        QVERIFY(!same_cells(by_table, run_with("time_s,zone,g_m2_h\n0,chest,843\n")));
    }

    void zones_that_are_not_named_keep_the_table()
    {
        Tee plain(duration);
        const SweatTable table = plain.parts.sweat;
        const double by_table = delivered(run(plain), duration);
        const std::size_t chest =
            static_cast<std::size_t>(std::find(body_zones().begin(), body_zones().end(), "chest") - body_zones().begin());
        const Finished dry_chest = run_with("time_s,zone,g_m2_h\n0,chest,0\n");
        double area = 0;
        for (const GarmentCell& cell : dry_chest.layout.cells)
            if (static_cast<std::size_t>(cell.zone) == chest) area += cell.area;
        const double less = 1e-3 * table.g_m2_h[chest] / 3600 * duration * area;
        QVERIFY(std::abs(by_table - delivered(dry_chest, duration) - less) < 1e-6 * by_table);
    }

    void steps_and_slopes_show_in_the_ledger()
    {
        const auto grams = [](const Finished& run, double g_m2) { return 1e-3 * g_m2 * run.area; };
        const Finished step = run_with("time_s,zone,g_m2_h\n0,default,0\n30,default,0\n30,default,1800\n");
        QCOMPARE(delivered(step, 30), 0.0);
        const double after = delivered(step, duration);
        QVERIFY(std::abs(after - grams(step, 15)) < 1e-6 * after); // 30 s at 1800 g/m2h
        const Finished slope = run_with("time_s,zone,g_m2_h\n0,default,0\n60,default,3600\n");
        for (const auto& [time, g_m2] :
             {std::pair{20.0, 20.0 * 20 / 120}, {40.0, 40.0 * 40 / 120}, {60.0, 30.0}}) // half of time times rate
            QVERIFY(std::abs(delivered(slope, time) - grams(slope, g_m2)) < 1e-6 * grams(slope, 30));
        const Finished peak = run_with("time_s,zone,g_m2_h\n0,default,0\n20,default,3600\n40,default,0\n");
        QVERIFY(std::abs(delivered(peak, duration) - grams(peak, 20)) < 1e-6 * grams(peak, 20));
        QCOMPARE(peak.layout.stops.value_or(-1), 40.0);
        QVERIFY(!slope.layout.stops);
        const Finished jump = run_with("time_s,zone,g_m2_h\n0,default,0\n30,default,840\n30,default,0\n"); // up, then off at once
        QCOMPARE(jump.layout.stops.value_or(-1), 30.0);
    }

    void warmer_skin_dries_more()
    {
        const auto at = [&](const char* rows) { return run_with(std::string("time_s,zone,g_m2_h,skin_temperature_c\n") + rows); };
        const Finished cool = at("0,default,900,28\n"), warm = at("0,default,900,38\n"),
                       rising = at("0,default,900,28\n60,default,900,38\n");
        const auto evaporated = [](const Finished& run) { return run.frames.back().ledger.water_evaporated; };
        const auto mean = [](const Finished& run) {
            double sum = 0;
            for (const float value : run.frames.back().temperature) sum += static_cast<double>(value);
            return sum / static_cast<double>(run.frames.back().temperature.size());
        };
        qInfo("evaporated %.3f, %.3f, %.3f g; cloth %.2f, %.2f, %.2f K", 1e3 * evaporated(cool), 1e3 * evaporated(rising),
              1e3 * evaporated(warm), mean(cool), mean(rising), mean(warm));
        QVERIFY(evaporated(cool) < evaporated(rising) && evaporated(rising) < evaporated(warm));
        QVERIFY(mean(cool) < mean(rising) && mean(rising) < mean(warm));
        QCOMPARE(delivered(cool, duration), delivered(warm, duration));
        QVERIFY(std::abs(rising.layout.skin_temperature_at(0, 30) - kelvin_from_celsius(33)) < 1e-9);

        // One zone alone: the others keep the wearer's temperature.
        const Finished chest = at("0,chest,842,20\n");
        const auto number = std::find(body_zones().begin(), body_zones().end(), "chest") - body_zones().begin();
        QCOMPARE(chest.layout.skin_temperature_at(static_cast<int>(number), 1), kelvin_from_celsius(20));
        QCOMPARE(chest.layout.skin_temperature_at(static_cast<int>(number) + 1, 1), kelvin_from_celsius(34));
    }

    void recordings_keep_the_skin()
    {
        Tee tee(duration);
        tee.parts.course = course("time_s,zone,g_m2_h,skin_temperature_c\n0,default,900,30\n60,default,900,36\n");
        const Finished finished = run(tee);
        const std::string path = folder_.filePath("skin.hygrorec").toStdString();
        {
            WearWriter writer(path, {tee.design, finished.layout, "draft", "cpu", "a CPU", "2026-01-01T00:00:00Z"});
            for (const WearFrame& frame : finished.frames) writer.append(frame);
            writer.finish(1);
        }
        const WearRecording recording{path};
        QVERIFY(std::abs(recording.record().layout.skin_temperature_at(3, 20) - kelvin_from_celsius(32)) < 1e-9);
        WearMetrics before(finished.layout), after(recording.record().layout);
        for (std::size_t k = 0; k < finished.frames.size(); ++k) {
            before.add(finished.frames[k]);
            after.add(recording.frame(static_cast<int>(k)));
        }
        QVERIFY(std::abs(before.heat_from_skin() - after.heat_from_skin()) < 1e-5 * std::abs(before.heat_from_skin()));
    }

    void bad_files_are_refused_by_line_and_field_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("sentence");
        const auto row = [](const char* name, const char* text, const char* sentence) {
            QTest::newRow(name) << QString(text) << QString(sentence);
        };
        row("no column", "time_s,zone\n0,chest\n", "g_m2_h");
        row("no row", "time_s,zone,g_m2_h\n", "There is no row. Give time_s, zone and g_m2_h of one zone at least.");
        row("a zone that is none", "time_s,zone,g_m2_h\n0,cheste,1\n", "line 2: There is no zone \"cheste\" of the body");
        row("a rate too high", "time_s,zone,g_m2_h\n0,chest,1\n1,chest,1e6\n", "line 3: g_m2_h must be from 0 to 100000; given is 1e+06.");
        row("a rate below 0", "time_s,zone,g_m2_h\n0,chest,-1\n", "line 2: g_m2_h must be from 0 to 100000; given is -1.");
        row("no number", "time_s,zone,g_m2_h\n0,chest,much\n", "line 2");
        row("a time before 0", "time_s,zone,g_m2_h\n-1,chest,1\n", "line 2: time_s must be from 0 to 1e+06; given is -1.");
        row("time goes back", "time_s,zone,g_m2_h\n5,chest,1\n4,chest,1\n",
            "line 3: Rows of a zone stand in order of time; time_s is 4 after 5.");
        row("three at once", "time_s,zone,g_m2_h\n5,chest,1\n5,chest,2\n5,chest,3\n",
            "line 4: The zone \"chest\" stands there a third time at 5 s");
        row("skin too warm", "time_s,zone,g_m2_h,skin_temperature_c\n0,chest,1,60\n",
            "line 2: skin_temperature_c must be from 10 to 45; given is 60.");
        row("skin in one row alone", "time_s,zone,g_m2_h,skin_temperature_c\n0,chest,1,30\n1,chest,1,\n",
            "line 3: skin_temperature_c is empty; give it in each row, from 10 to 45 C, or in none.");
    }
    void bad_files_are_refused_by_line_and_field()
    {
        QFETCH(QString, text);
        QFETCH(QString, sentence);
        try {
            course(text.toStdString());
            QFAIL("it was read");
        } catch (const FileError& error) {
            QVERIFY2(QString(error.what()).contains(sentence), error.what());
            QVERIFY2(QString(error.what()).contains("rates.csv"), error.what());
        }
    }

    void projects_name_the_file()
    {
        Tee tee(duration);
        Design design = tee.design;
        design.garments.push_back(tee.garment);
        tee.wear.activity_file = "sub/rates.csv";
        design.wears.push_back(tee.wear);
        QVERIFY(!has_error(validate(design)));
        const std::string text = format_project(design);
        QVERIFY(text.find("\"activity\": \"sub/rates.csv\"") != std::string::npos);
        QVERIFY(parse_project(text, "a test") == design);
        design.wears[0].activity_file = "rates.txt";
        const std::vector<Issue> issues = validate(design);
        QVERIFY(std::any_of(issues.begin(), issues.end(), [](const Issue& issue) {
            return issue.where.text().ends_with(".activity") && issue.text().find("rates.txt") != std::string::npos;
        }));
        std::string wrong = text;
        wrong.replace(wrong.find("\"sub/rates.csv\""), 15, "12");
        QVERIFY_EXCEPTION_THROWN(parse_project(wrong, "a test"), FileError);
    }

    void a_file_that_was_not_read_is_not_passed_over()
    {
        Tee tee(duration);
        tee.wear.activity_file = "rates.csv";
        QVERIFY_EXCEPTION_THROWN(tee.scene(40e-3), Error);
        Design design = tee.design;
        design.garments.push_back(tee.garment);
        QVERIFY_EXCEPTION_THROWN(garment_parts(design, tee.wear, folder_.path().toStdString() + "/none"), FileError);
    }
};

} // namespace tst_wear_course

QTEST_GUILESS_MAIN(tst_wear_course::TestWearCourse)
#include "tst_wear_course.moc"
