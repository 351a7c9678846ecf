// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Cloths that are simulated while one looks: drops come where they are dropped, water adds up, time goes on, and a recording can be kept.
#include "core/analysis/metrics.h"
#include "core/base/error.h"
#include "core/design/validate.h"
#include "core/lesson/lesson_table.h"
#include "core/lesson/water_shares.h"
#include "core/project/project_file.h"
#include "core/run/recording.h"

#include <QTemporaryDir>
#include <QTest>

#include <ctime>
#include <limits>

using namespace hygroloom;

namespace {

const std::string three = HYGROLOOM_SOURCE_DIR "/resources/lessons/fibre.json";

/// s of all threads.
double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

bool laid_out(LessonTable& table)
{
    for (int k = 0; k < table.cloths(); ++k)
        if (!table.view(k)) return false;
    return true;
}

void require_balanced(const Ledger& ledger)
{
    QVERIFY2(std::abs(ledger.water_imbalance()) <= 1e-9 * (ledger.water_delivered + ledger.water_initial),
             qPrintable(QString::number(ledger.water_imbalance())));
}

} // namespace

class TestLessonTable : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aClothTakesDropsAirAndTiltAndLosesNoWater()
    {
        const Lesson lesson = read_lesson(three);
        const std::atomic<bool> stop{false};
        RunningCloth cloth(lesson.cloths[0].design, lesson.air);
        cloth.advance(0.5, stop);
        QCOMPARE(cloth.view()->score.wet_area_mm2, 0.0);
        cloth.drop(5e-3, -3e-3, 5e-9);
        QCOMPARE(cloth.view()->notice, std::string());
        cloth.advance(0.52, stop);
        QCOMPARE(cloth.view()->frame->caps.size(), std::size_t{1});
        QVERIFY(std::abs(cloth.view()->frame->caps[0].x - 5e-3) < 1e-9 && std::abs(cloth.view()->frame->caps[0].y + 3e-3) < 1e-9);
        cloth.advance(1.5, stop);
        cloth.blow({45, 0.2, 2});
        cloth.tilt(20);
        cloth.advance(3, stop);
        cloth.drop(19.5e-3, 0, 5e-9); // over the edge
        const auto view = cloth.view();
        QVERIFY(!view->notice.empty());
        QCOMPARE(view->score.drops, 1);
        QVERIFY(view->score.wet_area_mm2 > 1 && view->score.evaporated_ul > 0 && view->score.in_fibres_ul != 0);
        QVERIFY(std::abs(view->air.temperature + view->air.air_warmth - kelvin_from_celsius(45)) < 1e-9);
        require_balanced(view->frame->ledger);
        QVERIFY(std::abs(view->frame->ledger.water_delivered / 5e-6 - 1) < 0.01); // 5 ul
        const WaterShares shares = water_shares(view->frame->ledger, view->bound_at_start, view->score.drops);
        QCOMPARE(shares.in_yarns + shares.in_fibres + shares.in_air + shares.standing + shares.run_off, 10);
    }
    void aSqueezeLeavesWhatFibresHoldAndASharePoresHold()
    {
        const Lesson lesson = read_lesson(three);
        const std::atomic<bool> stop{false};
        RunningCloth cloth(lesson.cloths[0].design, lesson.air);
        cloth.blow({45, 0.2, 1}); // what is pressed out is cooler
        cloth.drop(0, 0, 10e-9);
        cloth.advance(4, stop);
        cloth.drop(-10e-3, 0, 20e-9);
        cloth.advance(4.055, stop);
        const auto before = cloth.view();
        QVERIFY(before->score.standing_ul > 1);
        cloth.drop(0, 10e-3, 1e-9); // it falls
        cloth.squeeze();
        const auto after = cloth.view();
        QCOMPARE(after->frame->time, before->frame->time);
        QVERIFY(after->score.run_off_ul > before->score.standing_ul);
        QCOMPARE(after->frame->ledger.water_bound, before->frame->ledger.water_bound);
        QCOMPARE(after->frame->ledger.water_free, 0.0); // the last one is not released yet
        const auto most = [](const std::vector<float>& values) { return *std::max_element(values.begin(), values.end()); };
        QVERIFY(most(before->frame->saturation) > 0.9);
        QVERIFY(std::abs(most(after->frame->saturation) - squeezed_share) < 1e-6);
        cloth.squeeze(); // nothing is left to press out
        QCOMPARE(cloth.view()->score.run_off_ul, after->score.run_off_ul);
        require_balanced(after->frame->ledger);
        cloth.advance(5, stop);
        const auto later = cloth.view();
        QVERIFY(std::abs(later->frame->ledger.water_delivered / (31e-9 * later->air.density) - 1) < 1e-9);
        QCOMPARE(later->score.run_off_ul, after->score.run_off_ul);
        require_balanced(later->frame->ledger);
        const double energy = later->frame->ledger.energy_imbalance();
        QVERIFY2(std::abs(energy) < 1e-9 * std::abs(later->frame->ledger.energy_released), qPrintable(QString::number(energy)));
        const double pressed = after->frame->ledger.energy_lost - before->frame->ledger.energy_lost;
        QVERIFY2(std::abs(pressed) > 1e-4 * std::abs(later->frame->ledger.energy_released), qPrintable(QString::number(pressed)));
    }
    void aSqueezeEmptiesTheRoomsBetweenYarns()
    {
        Design design = read_project(HYGROLOOM_SOURCE_DIR "/resources/examples/textile-F.hygro"); // its rooms draw water in at 889 Pa
        design.experiments.clear();
        const std::atomic<bool> stop{false};
        RunningCloth cloth(design, read_lesson(three).air);
        cloth.drop(0, 0, 60e-9);
        cloth.advance(0.2, stop);
        const auto before = cloth.view();
        cloth.squeeze();
        const auto after = cloth.view();
        const auto most = [](const std::vector<float>& values) { return *std::max_element(values.begin(), values.end()); };
        QVERIFY2(most(before->frame->between) > 5e-9, // kg; a room holds 13e-9
                 qPrintable(QString::number(most(before->frame->between))));
        QVERIFY2(most(after->frame->between) < 0.5 * most(before->frame->between),
                 qPrintable(QString::number(most(after->frame->between))));
        require_balanced(after->frame->ledger);
    }
    void aDropThatWasWipedOffIsNotAbsorbed()
    {
        const Lesson lesson = read_lesson(three);
        const std::atomic<bool> stop{false};
        RunningCloth cloth(lesson.cloths[0].design, lesson.air);
        cloth.drop(0, 0, 20e-9);
        cloth.advance(0.06, stop);
        QVERIFY(cloth.view()->score.standing_ul > 1);
        cloth.squeeze();
        QCOMPARE(cloth.view()->score.standing_ul, 0.0);
        QVERIFY(cloth.view()->score.wiped);
        cloth.advance(1, stop);
        QVERIFY(cloth.view()->score.absorbed_s < 0 && cloth.view()->score.wiped);
        QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath("wiped.hygrorec").toStdString();
        write_recording(cloth.recorded(), path);
        const Recording read(path);
        QVERIFY(read.run().acts.wiped == 0.06 && read.run().acts.squeezed == 0.06 && !read.run().acts.tilted);
        MetricsCollector collector;
        collector.start(read.run());
        for (int k = 0; k < read.frames(); ++k) collector.add(read.frame(k));
        QVERIFY(!collector.metrics().absorbency_time);
        QVERIFY(collector.metrics().notes.front().find("squeezed") != std::string::npos);
        cloth.drop(0, 0, 2e-9);
        cloth.advance(4, stop);
        QVERIFY(cloth.view()->score.absorbed_s > 0 && !cloth.view()->score.wiped);
    }
    void aSqueezeIsInTheRecordingThoughTimeStandsStill()
    {
        const Lesson lesson = read_lesson(three);
        const std::atomic<bool> stop{false};
        RunningCloth cloth(lesson.cloths[0].design, lesson.air);
        cloth.drop(0, 0, 10e-9);
        cloth.advance(2, stop); // a look that is kept
        cloth.squeeze();
        const RecordedCloth recorded = cloth.recorded();
        QVERIFY(recorded.frames.back()->ledger.water_dripped > 0);
        QCOMPARE(std::count_if(recorded.frames.begin(), recorded.frames.end(), [](const auto& frame) { return frame->time == 2; }), 1);
    }
    void theStepThatAsksForASqueezeCanBeSeen()
    {
        const Lesson lesson = read_lesson(three);
        const auto asks = std::find_if(lesson.steps.begin(), lesson.steps.end(),
                                       [](const LessonStep& step) { return step.ask.find("Squeeze") != std::string::npos; });
        QVERIFY(asks != lesson.steps.end());
        const std::atomic<bool> stop{false};
        TableState state;
        for (const LessonCloth& each : lesson.cloths) {
            RunningCloth cloth(each.design, lesson.air);
            cloth.drop(0, 0, 5e-9);
            cloth.advance(8, stop);
            cloth.drop(0, 0, 5e-9);
            cloth.advance(11, stop);
            cloth.squeeze();
            state.cloths.push_back(cloth.view()->score);
        }
        QVERIFY(is_seen(*asks->seen, state));
    }
    void handsMayDoManyThingsAtOneTime()
    {
        const Lesson lesson = read_lesson(three);
        const std::atomic<bool> stop{false};
        RunningCloth cloth(lesson.cloths[2].design, lesson.air);
        const auto act = [&] {
            cloth.drop(0, 5e-3, 2e-9);
            cloth.blow({30, 0.5, 1});
            cloth.drop(0, -5e-3, 2e-9);
            cloth.tilt(10);
            cloth.blow({35, 0.4, 1});
        };
        act(); // before anything has moved
        cloth.advance(0.5, stop);
        act();
        cloth.advance(1, stop);
        const auto view = cloth.view();
        QCOMPARE(view->score.drops, 4);
        QCOMPARE(view->released, 4);
        QVERIFY(std::abs(view->frame->ledger.water_delivered / (8e-9 * view->air.density) - 1) < 1e-9);
        QVERIFY(std::abs(view->air.temperature + view->air.air_warmth - kelvin_from_celsius(35)) < 1e-9);
        require_balanced(view->frame->ledger);
        QVERIFY(!has_error(validate(cloth.recorded().run.design)));
    }
    void dropsThatHaveNoRoomAreRefused()
    {
        const Lesson lesson = read_lesson(three);
        const std::atomic<bool> stop{false};
        RunningCloth cloth(lesson.cloths[1].design, lesson.air);
        for (int k = 0; k < most_droplets + 3; ++k) {
            cloth.drop(1e-3 * (k % 20 - 10), 1e-3 * (k / 8 - 4), 0.5e-9);
            cloth.advance(0.02 * (k + 1), stop);
        }
        const auto view = cloth.view();
        QCOMPARE(view->score.drops, most_droplets);
        QCOMPARE(view->refused, 3);
        QVERIFY(view->notice.find("64") != std::string::npos);
        require_balanced(view->frame->ledger);
    }
    void whatWasDoneIsAnOrdinaryRecording()
    {
        const Lesson lesson = read_lesson(three);
        const std::atomic<bool> stop{false};
        RunningCloth cloth(lesson.cloths[1].design, lesson.air);
        cloth.advance(0.3, stop);
        cloth.drop(0, 0, 3e-9);
        cloth.advance(1, stop);
        cloth.blow({40, 0.3, 1});
        cloth.advance(1.5, stop);
        QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath("lesson.hygrorec").toStdString();
        write_recording(cloth.recorded(), path);
        const Recording read(path);
        QVERIFY(read.finished() && read.problems().empty());
        const Experiment& experiment = read.run().design.experiments.at(0);
        QCOMPARE(experiment.droplets.size(), std::size_t{1});
        QVERIFY(std::abs(experiment.droplets[0].time_s - 0.3) < 1e-9 && experiment.droplets[0].volume_ul == 3.0);
        QCOMPARE(climate_at(experiment, 1.2).temperature_c, 40.0);
        QVERIFY(!has_error(validate(read.run().design)));
        const Frame last = read.frame(read.frames() - 1);
        QCOMPARE(last.time, cloth.time());
        require_balanced(last.ledger);
    }
    void twoDropsAtOnePlaceAtOneTimeCanBeReadAgain()
    {
        const Lesson lesson = read_lesson(three);
        const std::atomic<bool> stop{false};
        RunningCloth cloth(lesson.cloths[1].design, lesson.air);
        cloth.advance(0.1, stop);
        cloth.drop(0, 0, 3e-9);
        cloth.drop(0, 0, 3e-9);
        cloth.drop(1e-3, 0, 3e-9);
        QCOMPARE(cloth.view()->released, 0);
        cloth.advance(0.101, stop); // less than lies between their times in the experiment
        QCOMPARE(cloth.view()->released, 3);
        QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath("lesson.hygrorec").toStdString();
        write_recording(cloth.recorded(), path);
        const Recording read(path);
        const Experiment& experiment = read.run().design.experiments.at(0);
        QCOMPARE(experiment.droplets.size(), std::size_t{3});
        QVERIFY(experiment.droplets[1].time_s > experiment.droplets[0].time_s + 1e-3);
        QVERIFY(!has_error(validate(read.run().design)));
    }
    void dropsOfOneMomentCountTogetherAtTheEdge()
    {
        const Lesson lesson = read_lesson(three);
        const auto refused = [&](int drops) {
            RunningCloth cloth(lesson.cloths[1].design, lesson.air);
            for (int k = 0; k < drops; ++k) cloth.drop(14e-3, 0, 20e-9);
            return cloth.view()->refused;
        };
        QCOMPARE(refused(1), 0);
        QVERIFY(refused(12) > 0); // 240 ul together stand over the edge
    }
    void whatCannotBeReadAgainIsNotWritten()
    {
        const Lesson lesson = read_lesson(three);
        RunningCloth cloth(lesson.cloths[1].design, lesson.air);
        RecordedCloth recorded = cloth.recorded();
        recorded.run.design.experiments[0].droplets = {{3, 0, {0, 0}, 10, 0}, {3, 0, {0, 0}, 10, 0}};
        QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath("lesson.hygrorec").toStdString();
        QVERIFY_EXCEPTION_THROWN(write_recording(recorded, path), FileError);
        QVERIFY(!std::filesystem::exists(path));
    }
    void keptFramesTakeAHundredMegabytes()
    {
        QCOMPARE(most_kept_frames(1000), std::size_t{120});
        QCOMPARE(most_kept_frames(2'000'000), std::size_t{50});
        QCOMPARE(most_kept_frames(50'000'000), std::size_t{20}); // fewer show nothing
    }
    void anyNumberOfChangesOfTheAirIsAnExperiment()
    {
        Experiment experiment = table_experiment({25, 0.65, 0.1});
        for (int k = 0; k < 800; ++k) {
            const double time = 0.5 * k + (k % 2 ? 0.1 : 0);
            const Climate air{20.0 + k % 30, 0.5, 1};
            change_air(experiment.climates, time, climate_at(experiment, time), {5, 0.1, 0}); // a moment later changed again
            change_air(experiment.climates, time, climate_at(experiment, time), air);
            QCOMPARE(experiment.climates.back().climate, air);
        }
        QVERIFY(experiment.climates.size() > 900 && experiment.climates.size() <= 1000);
        Design design = read_lesson(three).cloths[0].design;
        design.experiments = {experiment};
        QVERIFY(!has_error(validate(design)));
        QCOMPARE(climate_at(experiment, 500).temperature_c, 20.0 + 799 % 30);
    }
    void aRecordingThatWasAskedForComesAlsoWhenTheTableGoes()
    {
        const Lesson lesson = read_lesson(three);
        std::atomic<int> taken{0};
        {
            LessonTable table(lesson.cloths, lesson.air, 1);
            QTRY_VERIFY_WITH_TIMEOUT(laid_out(table), 60000);
            for (int k = 0; k < 9; ++k) table.record(k % 3, [&](const RecordedCloth& cloth) { taken += cloth.frames.empty() ? 0 : 1; });
        }
        QCOMPARE(taken.load(), 9);
    }
    void aRecordingOfAClothThatWentWrongComes()
    {
        const Lesson lesson = read_lesson(three);
        LessonTable table(lesson.cloths, lesson.air, 1);
        QTRY_VERIFY_WITH_TIMEOUT(laid_out(table), 60000);
        table.blow({std::numeric_limits<double>::quiet_NaN(), 0.5, 1});
        QTRY_VERIFY_WITH_TIMEOUT(!table.failure(0).empty(), 60000);
        QVERIFY(table.view(0)); // as it was last
        std::atomic<bool> taken{false};
        table.record(0, [&](const RecordedCloth& cloth) { taken = !cloth.frames.empty(); });
        QTRY_VERIFY_WITH_TIMEOUT(taken, 60000);
    }
    void thePaceFollowsTheSpeedAtOnce()
    {
        const Lesson lesson = read_lesson(three);
        LessonTable table(lesson.cloths, lesson.air, 1);
        for (const double speed : {1.0, LessonTable::slow_motion, 0.0, 1.0}) { // before the clock goes
            table.set_speed(speed);
            if (speed > 0) QVERIFY(std::abs(table.pace() / speed - 1) < 1e-9);
        }
    }
    /// Where the humidity stays as it is, air that is warmed has more vapour than a cool cloth.
    void theAirThatTheLessonAsksForDries()
    {
        const Lesson lesson = read_lesson(HYGROLOOM_SOURCE_DIR "/resources/lessons/climate.json");
        const std::atomic<bool> stop{false};
        std::vector<Climate> airs{lesson.air};
        for (const LessonStep& step : lesson.steps) {
            if (!step.seen || step.seen->metric < 0) continue;
            const std::string key = lesson_metrics()[static_cast<std::size_t>(step.seen->metric)].key;
            Climate air = airs.back();
            if (key == "air_speed_m_s") air.air_speed_m_s = step.seen->limit;
            if (key == "air_humidity") air.relative_humidity = step.seen->limit;
            if (key == "air_temperature_c") air.temperature_c = step.seen->limit;
            if (air != airs.back()) airs.push_back(air);
        }
        QCOMPARE(airs.size(), std::size_t{4}); // still, wind, dry, warm
        const auto run = [&](std::size_t changes) {
            RunningCloth cloth(lesson.cloths[0].design, lesson.air);
            cloth.drop(0, 0, 1e-9 * lesson.drop_ul);
            std::vector<double> evaporated;
            for (const double time : {1.0, 2.0, 6.0, 6.2, 8.0}) {
                cloth.advance(time, stop);
                evaporated.push_back(cloth.view()->score.evaporated_ul);
                const std::size_t change = evaporated.size(); // at 1 s the wind, at 2 s drier, at 6 s warmer
                if (change < airs.size() && change <= changes) cloth.blow(airs[change]);
            }
            return evaporated;
        };
        const std::vector<double> wind = run(1), dry = run(2), warm = run(3);
        qInfo("ul at 6, 6.2 and 8 s: wind %g %g %g, dry %g %g %g, warm %g %g %g", wind[2], wind[3], wind[4], dry[2], dry[3], dry[4],
              warm[2], warm[3], warm[4]);
        QVERIFY(dry[2] > wind[2] && dry[4] > wind[4]);
        QVERIFY(warm[3] > warm[2]); // it takes nothing from the air
        QVERIFY(warm[4] > dry[4]);
    }
    void threeClothsWithADropEachFollowTheClock()
    {
        const Lesson lesson = read_lesson(three);
        LessonTable table(lesson.cloths, lesson.air, 2);
        QTRY_VERIFY_WITH_TIMEOUT(laid_out(table), 60000);
        const double before = table.clock(), cpu = cpu_seconds();
        QElapsedTimer wall;
        wall.start();
        for (int k = 0; k < table.cloths(); ++k) table.drop(k, 0, 0, 5e-9);
        QTRY_VERIFY_WITH_TIMEOUT(table.clock() > before + 5, 120000);
        const double simulated = table.clock() - before;
        qInfo("%.2f s simulated in %.2f s, %.2f s of CPU for each", simulated, 1e-3 * static_cast<double>(wall.elapsed()),
              (cpu_seconds() - cpu) / simulated);
        table.set_speed(0);
        const double stands = table.clock();
        QTest::qWait(200);
        QCOMPARE(table.clock(), stands);
        for (int k = 0; k < table.cloths(); ++k) {
            QCOMPARE(table.failure(k), std::string());
            const auto view = table.view(k);
            QCOMPARE(view->score.drops, 1);
            QVERIFY(view->score.wet_area_mm2 > 1);
            require_balanced(view->frame->ledger);
        }
    }
};

QTEST_GUILESS_MAIN(TestLessonTable)
#include "tst_lesson_table.moc"
