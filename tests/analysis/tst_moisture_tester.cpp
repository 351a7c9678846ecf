// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The tester's pins on made-up frames, and its indices on made-up readings: each is known by hand.
#include "core/analysis/moisture_tester.h"
#include "core/base/units.h"

#include <QTest>

#include <cmath>
#include <functional>

using namespace hygroloom;

namespace tst_moisture_tester {
namespace {

bool near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

RingContents all(double content)
{
    RingContents rings;
    rings.fill(content);
    return rings;
}

/// Rises evenly between two times, then stays.
double ramp(double t, double from, double to, double slope) { return slope * (std::clamp(t, from, to) - from); }

struct Run {
    std::vector<double> time;
    std::vector<TesterReading> readings;
    ManagementIndices indices(double feed_end = 20, double drop_interval = 0) const
    {
        return tester_indices(time, readings, {feed_end, drop_interval});
    }
};

Run run_of(double step, double end, const std::function<TesterReading(double)>& reading)
{
    Run run;
    for (int i = 0; i * step <= end + 1e-9; ++i) {
        run.time.push_back(i * step);
        run.readings.push_back(reading(i * step));
    }
    return run;
}

Textile cloth(double per_cm = 20, std::optional<double> finish_depth = {}, double finish = 110)
{
    Fabric fabric;
    if (finish_depth) fabric.finish_face = finish;
    fabric.finish_depth = finish_depth;
    fabric.warp.diameter_mm = fabric.weft.diameter_mm = 0.2;
    fabric.ends_per_cm = fabric.picks_per_cm = per_cm;
    return build_textile({}, fabric, region_of_sample(fabric, 80, 80));
}

/// Water per dry fibre at each place and face.
Frame frame_of(const Textile& t, const std::function<double(double radius, bool on_top)>& water)
{
    Frame frame;
    frame.liquid.resize(static_cast<std::size_t>(t.segments()));
    frame.regain.assign(frame.liquid.size(), 0.07f);
    for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
        for (int end = 0; end < t.ends(); ++end)
            for (int pick = 0; pick < t.picks(); ++pick) {
                const YarnType& type = t.type(kind, kind == YarnKind::warp ? end : pick);
                const double fibres = type.area * type.packing * type.fibre.density_kg_m3 * t.segment_length(kind, end, pick);
                const bool on_top = t.warp_up(end, pick) == (kind == YarnKind::warp);
                frame.liquid[static_cast<std::size_t>(t.segment(kind, end, pick))] =
                    static_cast<float>(fibres * water(std::hypot(t.x_of_end(end), t.y_of_pick(pick)), on_top));
            }
    return frame;
}

} // namespace

class TestMoistureTester : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void pinsReadTheWaterOfTheirFacePerDryMass()
    {
        const Textile t = cloth();
        const TesterPins pins(t, true);
        Frame frame = frame_of(t, [](double, bool on_top) { return on_top ? 0.5 : 0.2; });
        const std::vector<float> before(frame.regain.size(), 0.07f);
        TesterReading reading = pins.read(frame, before);
        for (std::size_t ring = 0; ring < tester_rings; ++ring) {
            QVERIFY(near(reading.top[ring], 50, 1e-3));
            QVERIFY(near(reading.bottom[ring], 20, 1e-3));
        }
        frame.regain.assign(frame.regain.size(), 0.12f); // what the fibres took up counts, what they held does not
        reading = pins.read(frame, before);
        QVERIFY(near(reading.top[3], 55, 1e-3));
        QVERIFY(near(reading.bottom[0], 25, 1e-3));
    }
    void aFinishThatRepelsHidesWaterDownToItsDepth()
    {
        const std::vector<float> before(static_cast<std::size_t>(cloth().segments()), 0.07f);
        const auto top = [&](const Textile& t, bool finishes) {
            const TesterReading reading = TesterPins(t, finishes).read(frame_of(t, [](double, bool) { return 0.5; }), before);
            if (!near(reading.bottom[2], 50, 1e-3)) return -1.0;
            return reading.top[2];
        };
        QVERIFY(near(top(cloth(20, 0.2), true), 0, 1e-9));      // deeper than the pins reach
        QVERIFY(near(top(cloth(20, 0.2), false), 50, 1e-3));    // another closure, in which finishes of faces do not act
        QVERIFY(near(top(cloth(20, 0.2, 20), true), 50, 1e-3)); // it wets
        QVERIFY(near(top(cloth(20, 0.0), true), 50, 1e-3));
        // Near the top of a yarn its section grows as depth^1.5 and the part of a segment up there as depth^0.5, so that its share goes
        // with depth^2: of that, weighted by 1 - x, lies deeper than 2/3 of the tip: 1 - 3 (2/3)^2 + 2 (2/3)^3 = 7/27.
        QVERIFY(near(top(cloth(20, 0.1), true) / 50, 7.0 / 27, 0.05));
    }
    void eachRingReadsTheBandInsideIt_data()
    {
        QTest::addColumn<double>("per_cm");
        for (double per_cm : {4.0, 10.0, 20.0, 35.0}) QTest::addRow("%g per cm", per_cm) << per_cm;
    }
    void eachRingReadsTheBandInsideIt()
    {
        QFETCH(double, per_cm);
        const Textile t = cloth(per_cm);
        const TesterPins pins(t, true);
        const std::vector<float> before(static_cast<std::size_t>(t.segments()), 0.07f);
        for (int reached = 0; reached < tester_rings; ++reached) {
            // Up to the ring: that one is full, the next one dry.
            const double radius = 5e-3 * reached;
            const TesterReading reading = pins.read(frame_of(t,
                                                             [&](double r, bool) {
                                                                 return r <= std::max({radius, 1e-3, 15e-3 / per_cm}) + 1e-9 ? 1.0 : 0.0;
                                                             }),
                                                    before);
            for (int ring = 0; ring < tester_rings; ++ring)
                QVERIFY2(near(reading.top[static_cast<std::size_t>(ring)], ring <= reached ? 100 : 0, 1e-3),
                         qPrintable(QString("%1 of %2: %3").arg(ring).arg(reached).arg(reading.top[static_cast<std::size_t>(ring)])));
        }
        // Beyond the last ring nothing is read.
        const TesterReading outside = pins.read(frame_of(t, [](double r, bool) { return r > 30.001e-3 ? 1.0 : 0.0; }), before);
        for (double content : outside.bottom) QCOMPARE(content, 0.0);
    }
    void aFaceShowsTheMeanOfItsRingsByTheirContent()
    {
        QCOMPARE(face_content({200, 200, 200, 0, 0, 0, 0}), 200.0);
        QCOMPARE(face_content({200, 100, 0, 0, 0, 0, 0}), 50000.0 / 300);
        QVERIFY(
            near(face_content({100, 5, 0, 0, 0, 0, 0}), face_content({100, 0, 0, 0, 0, 0, 0}), 5)); // hardly less than before it got wet
        QCOMPARE(face_content({-3, 0, 0, 0, 0, 0, 0}), 0.0);                                        // drier than at the start
    }
    void theRateHardlyChangesWhereAContentLingers()
    {
        // A level within 1 s, which lasts for 15 s, then 100 %: what lingers just below half counts little less than what just passes it.
        const auto rate = [](double level) {
            return run_of(0.1, 60,
                          [level](double t) {
                              const double content = t <= 1    ? level * t
                                                     : t <= 16 ? level
                                                               : level + (100 - level) * std::min(1.0, (t - 16) / 2);
                              return TesterReading{all(content), {}};
                          })
                .indices()
                .top.absorption_rate;
        };
        QVERIFY(near(rate(50.1), 50.1, 0.1));
        QVERIFY(near(rate(49.9) / rate(50.1), 1, 0.15));
        QVERIFY(rate(30) < 0.5 * rate(50));
        QVERIFY(near(rate(99), 99, 1e-9));
    }
    void aFaceThatIsHalfFullAsItBeginsToWetHasARateToo()
    {
        // Below tan 15 degrees for 19 s, then 0.4 %/s for 1 s; and a content that rises faster and faster.
        const Run slow = run_of(0.1, 60, [](double t) { return TesterReading{all(ramp(t, 0, 19, 0.25) + ramp(t, 19, 20, 0.4)), {}}; });
        QVERIFY(near(slow.indices().top.absorption_rate, 0.4, 1e-9));
        const Run late = run_of(0.1, 60, [](double t) { return TesterReading{all(0.009 * std::min(t, 20.0) * std::min(t, 20.0)), {}}; });
        QVERIFY(late.indices().top.absorption_rate > 0.26 && late.indices().top.absorption_rate < 0.36);
    }
    void evenFillingHasItsSlopeAndTheSamplersSpeeds()
    {
        const Run run = run_of(0.1, 120, [](double t) { return TesterReading{all(ramp(t, 2, 20, 30)), all(ramp(t, 4, 12, 50))}; });
        const ManagementIndices m = run.indices();
        QVERIFY(near(*m.top.wetting_time, 2, 1e-9));
        QVERIFY(near(*m.bottom.wetting_time, 4, 1e-9));
        QVERIFY(near(m.top.absorption_rate, 30, 1e-9));    // up to 270 of 540 %
        QVERIFY(near(m.bottom.absorption_rate, 50, 1e-9)); // up to 200 of 400 %, whatever comes until the feed ends
        QCOMPARE(m.top.maximum_wetted_radius, 30.0);       // no ring lies farther out
        // 5 % after 0.17 and 0.1 s: at samples 0.2 and 0.1 s after wetting; the other five rings at once, in one sample.
        QVERIFY(near(m.top.spreading_speed, (5 / 0.2 + 5 * 5 / 0.1) / 6, 1e-6));
        QVERIFY(near(m.bottom.spreading_speed, 5 / 0.1, 1e-6));
        const double top = 540 * (0.5 * 18 + 100), bottom = 400 * (0.5 * 8 + 108);
        QVERIFY(near(m.one_way_transport, (bottom - top) / 120, 1e-6));
        QCOMPARE(m.ommc, overall_capability(m.bottom.absorption_rate, m.one_way_transport, m.bottom.spreading_speed));
    }
    void dropsCountOverTheirIntervals()
    {
        // Every 2 s a drop, absorbed within a sample: the first fills the middle and the rings at 5 and 10 mm, each later one a ring more.
        const auto fed = [](double largest) {
            return run_of(0.1, 60, [largest](double t) {
                TesterReading reading;
                for (int ring = 0; ring < 5; ++ring) {
                    const double drop = 2 * std::max(1, ring - 1);
                    reading.top[static_cast<std::size_t>(ring)] = ramp(t, drop, drop + 0.1, 10 * largest);
                }
                return reading;
            });
        };
        const ManagementIndices m = fed(80).indices(20, 2), twice = fed(160).indices(20, 2);
        QVERIFY(near(*m.top.wetting_time, 2, 1e-9));
        QCOMPARE(m.top.maximum_wetted_radius, 20.0);
        // The first drop gains 10 mm in its interval and a sample, two rings; then 5 mm in each interval.
        QVERIFY(near(m.top.spreading_speed, (2 * 10 / 2.1 + 5 / 2.0 + 5 / 2.0) / 4, 1e-6));
        QVERIFY(near(m.top.absorption_rate, 80 / 2.0, 1e-6)); // a step becomes a rise of one interval
        QVERIFY(near(twice.top.absorption_rate, 160 / 2.0, 1e-6));
        QVERIFY(fed(80).indices(20, 0).top.absorption_rate > 700); // as an even feed: the sampler's
    }
    void aRingThatWetsALittleLaterHardlyChangesTheSpeed()
    {
        // Drops every 2.5 s, each of which reaches a ring, the first after a delay of its own.
        const auto speed = [](double delay) {
            return run_of(0.1, 60,
                          [delay](double t) {
                              TesterReading reading;
                              for (int ring = 0; ring < 5; ++ring) {
                                  const double from = ring == 0 ? 2.5 : 2.5 * ring + (ring == 1 ? delay : 0);
                                  reading.top[static_cast<std::size_t>(ring)] = ramp(t, from, from + 0.1, 800);
                              }
                              return reading;
                          })
                .indices(20, 2.5)
                .top.spreading_speed;
        };
        QVERIFY(near(speed(0), (5 / 2.6 + 3 * 5 / 2.5) / 4, 1e-6));
        QVERIFY(near(speed(0.1), (5 / 2.7 + 3 * 5 / 2.5) / 4, 1e-6));
        QVERIFY(near(speed(2.0), (5 / 4.6 + 3 * 5 / 2.5) / 4, 1e-6));
    }
    void aFeedOfOneDropHasARate()
    {
        const Run run = run_of(0.1, 60, [](double t) { return TesterReading{all(ramp(t, 20, 20.1, 600)), {}}; });
        QVERIFY(near(run.indices(20, 20).top.absorption_rate, 60 / 20.0, 1e-6));
        const Run two = run_of(0.1, 60, [](double t) { return TesterReading{all(ramp(t, 10, 10.1, 300) + ramp(t, 20, 20.1, 300)), {}}; });
        QVERIFY(near(two.indices(20, 10).top.absorption_rate, 3, 1e-6));
    }
    void ringsThatWetOneAfterAnotherGiveTheSpeed()
    {
        // Ring k from dry to 100 % in the sample after 2 + 4 k s, up to 15 mm.
        const Run run = run_of(0.1, 60, [](double t) {
            TesterReading reading;
            for (int ring = 0; ring < 4; ++ring) reading.top[static_cast<std::size_t>(ring)] = ramp(t, 2 + 4 * ring, 2.1 + 4 * ring, 1000);
            return reading;
        });
        const ManagementIndices m = run.indices();
        QVERIFY(near(*m.top.wetting_time, 2, 1e-9));
        QCOMPARE(m.top.maximum_wetted_radius, 15.0);
        QVERIFY(near(m.top.spreading_speed, (5 / 4.1 + 5 / 4.0 + 5 / 4.0) / 3, 1e-6));
        QVERIFY(near(m.top.absorption_rate, 1000, 1e-6));
        QVERIFY(!m.bottom.wetting_time);
    }
    void aRingBelowFivePerCentIsDry()
    {
        for (const auto& [content, radius] : {std::pair(4.9, 0.0), std::pair(5.1, 5.0)}) {
            const Run run = run_of(0.1, 30, [content = content](double t) {
                TesterReading reading;
                reading.top[0] = ramp(t, 1, 3, 50);
                reading.top[1] = ramp(t, 1, 3, content / 2);
                return reading;
            });
            QCOMPARE(run.indices().top.maximum_wetted_radius, radius);
        }
    }
    void waterAfterTheFeedDoesNotCountForTheRate()
    {
        const auto rising = [](double from) {
            return run_of(0.1, 120, [from](double t) { return TesterReading{all(ramp(t, from, 120, 10)), {}}; });
        };
        QVERIFY(near(rising(0).indices(20).top.absorption_rate, 10, 1e-9));
        QVERIFY(near(*rising(30).indices(20).top.wetting_time, 30, 1e-9));
        QCOMPARE(rising(30).indices(20).top.absorption_rate, 0.0);
    }
    void framesThatLieFarApartAreJoinedByStraightLines()
    {
        const Run fine = run_of(0.1, 120, [](double t) { return TesterReading{all(ramp(t, 0, 4, 45)), all(ramp(t, 0, 4, 20))}; });
        const ManagementIndices a = fine.indices();
        const ManagementIndices b = tester_indices({0, 4, 120}, {{all(0), all(0)}, {all(180), all(80)}, {all(180), all(80)}}, {20, 0});
        QVERIFY(near(a.top.absorption_rate, b.top.absorption_rate, 1e-9));
        QVERIFY(near(b.bottom.absorption_rate, 20, 1e-9));
        QVERIFY(near(a.top.spreading_speed, b.top.spreading_speed, 1e-9));
        QVERIFY(near(a.one_way_transport, b.one_way_transport, 1e-9));
    }
    void aDryFaceHasNoWettingTime()
    {
        const Run run = run_of(1, 120, [](double t) { return TesterReading{all(ramp(t, 0, 120, 0.26)), {}}; }); // below tan 15 degrees
        const ManagementIndices m = run.indices();
        QVERIFY(!m.top.wetting_time && !m.bottom.wetting_time);
        QCOMPARE(m.top.maximum_wetted_radius, 0.0);
        const ManagementGrades grades = management_grades(m);
        QCOMPARE(grades.wetting_time_top, 1);
        QCOMPARE(QString(fabric_class(m)), QString("water-proof or water-repellent"));
        QCOMPARE(tester_indices({0}, {{}}, {20, 0}).ommc, 0.0);
    }
    void whatIsAssumedIsSaid()
    {
        const auto says = [](const std::vector<std::string>& all, const char* part) {
            return std::any_of(all.begin(), all.end(), [&](const std::string& one) { return one.find(part) != std::string::npos; });
        };
        const std::vector<std::string> drops = tester_assumptions(25, {20, 2.5}, 1.2), pool = tester_assumptions(0, {20, 0}, 0.6);
        for (const char* part : {"above 5 % of the dry mass", "seven rings", "every 5 mm",
                                 "every 0.1 s; frames lie up to 1.2 s apart during the feed", "until 50 % of the largest content",
                                 "drops of at most 25 ul", "one every 2.5 s", "averaged over the last 2.5 s", "liquid on the cloth"})
            QVERIFY2(says(drops, part), part);
        QVERIFY(says(pool, "flows evenly into a pool") && says(pool, "up to 0.6 s apart"));
    }
};

} // namespace tst_moisture_tester

QTEST_APPLESS_MAIN(tst_moisture_tester::TestMoistureTester)
#include "tst_moisture_tester.moc"
