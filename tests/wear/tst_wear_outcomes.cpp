// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A garment's numbers: one row each, the same for files, tables and reports.
#include "core/wear/wear_outcomes.h"
#include "tests/support/crafted_wear.h"
#include "tests/wear/flat_garment.h"

#include <QTest>

#include <nlohmann/json.hpp>

#include <cmath>
#include <set>

using namespace hygroloom;

namespace {

using Json = nlohmann::json;

/// Of the two panels of 12 and 6 cells after the first and the second frame.
struct TwoPanels {
    WearRecord record = small_wear();
    WearMetrics metrics{record.layout};
    explicit TwoPanels(int frames = 3)
    {
        for (int k = 0; k < frames; ++k) metrics.add(small_wear_frame(record.layout, k));
    }
};

Outcome found(const std::vector<Outcome>& outcomes, const std::string& key)
{
    for (const Outcome& outcome : outcomes)
        if (outcome.key == key) return outcome;
    return {};
}

Interval between(double low, double high)
{
    Interval interval;
    interval.centre = 0.5 * (low + high);
    interval.low = low;
    interval.high = high;
    return interval;
}

bool is_near(const Outcome& outcome, double value) { return outcome.value && std::abs(*outcome.value - value) <= 1e-12 * std::abs(value); }

} // namespace

class TestWearOutcomes : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// The cells of "front" hold (0+1+2+3+4) x 2 + 0 + 1 = 21 tenths of a milligram inside and half as much outside, a second; those of
    /// "sleeve" 2 + 3 + 4 + 0 + 1 + 2 = 12.
    void each_part_has_its_numbers()
    {
        const TwoPanels worn;
        const std::vector<Outcome> all = outcomes_of(worn.metrics);
        QVERIFY(is_near(found(all, "water_g"), 2 * 33 * 1.5e-4));
        QVERIFY(is_near(found(all, "panels/front/water_g"), 2 * 21 * 1.5e-4));
        QVERIFY(is_near(found(all, "panels/sleeve/water_g"), 2 * 12 * 1.5e-4));
        QVERIFY(is_near(found(all, "panels/front/water_g_m2"), 2 * 21 * 1.5e-4 / (12 * 64e-6)));
        QVERIFY(is_near(found(all, "panels/front/share_of_capacity"), 2 * 21 * 1.5e-7 / (0.2 * 12 * 64e-6)));
        QVERIFY(is_near(found(all, "panels/front/share_inside"), 2 / 3.0));
        QVERIFY(is_near(found(all, "panels/front/water_inside_g"), 2 * 21 * 1e-4));
        QVERIFY(is_near(found(all, "panels/sleeve/on_skin_g"), 2 * 12 * 0.2e-4));
        QCOMPARE(*found(all, "panels/sleeve/wet_area_m2").value, 0.0); // 1.2 mg of 12.8 are not a tenth
        QCOMPARE(full_title(found(all, "panels/front/wet_area_m2")), std::string("wet area, panel front"));
        QCOMPARE(full_title(found(all, "zones/head/wet_area_m2")), std::string("wet area, zone head"));
        QVERIFY(!found(all, "panels/front/sweat_g").value && found(all, "sweat_g").value); // of the whole alone
    }

    void a_missing_number_says_why()
    {
        const TwoPanels worn, dry(1);
        const Outcome full = found(outcomes_of(worn.metrics), "time_to_full_s");
        QVERIFY(!full.value && full.missing.find("90 %") != std::string::npos);
        QCOMPARE(found(outcomes_of(dry.metrics), "share_inside").missing, std::string("there is no water"));
    }

    /// What is rounding beside the water that was given is none.
    void rounding_is_no_water()
    {
        const TwoPanels begun(1);
        WearMetrics metrics(begun.record.layout);
        WearFrame frame = small_wear_frame(begun.record.layout, 1);
        frame.ledger.water_delivered = 0.1;
        frame.ledger.water_dripped = 4e-17;
        metrics.add(frame);
        QCOMPARE(*found(outcomes_of(metrics), "dripped_g").value, 0.0);
    }

    /// No "-0.00", and as many digits in another unit as in its own.
    void tables_of_parts_round_alike()
    {
        const WearNumber &water = wear_number("water_g"), &area = wear_number("area_m2");
        QCOMPARE(text_in_table(water, -1e-9), std::string("0.00"));
        QCOMPARE(text_in_table(water, -1.234), std::string("-1.23"));
        const ReaderUnits inches = [](const std::string& unit) { return unit == "m²" ? ReaderUnit{"in²", 1550.0031} : ReaderUnit{unit}; };
        QCOMPARE(text_in_table(area, 0.2), std::string("0.200"));
        QCOMPARE(text_in_table(area, 0.2, inches), std::string("310"));
    }

    void files_and_tables_have_each_number()
    {
        const TwoPanels worn;
        const Json json = Json::parse(wear_json(worn.metrics, {{"water_g", between(1, 3)}}));
        std::set<std::string> keys;
        for (const WearNumber& number : wear_numbers()) {
            const std::string& key = number.info.key;
            QVERIFY2(keys.insert(key).second, key.c_str());
            QVERIFY2(json["metrics"].contains(key), key.c_str());
            QVERIFY2(json["panels"]["front"].contains(key) != number.of_whole_only, key.c_str());
            QVERIFY2(json["series"].contains(key) == number.over_time, key.c_str());
            if (number.decimals && !key.starts_with("time_to"))
                QVERIFY2(table_of_parts(worn.metrics).find(number.info.title) != std::string::npos, key.c_str());
        }
        QCOMPARE(json["series"]["zones"]["head"]["water_g"].size(), std::size_t(3));
        QCOMPARE(json["intervals"]["water_g"]["high"].get<double>(), 3.0);
        QCOMPARE(json["metrics"].size(), keys.size());
        for (const OutcomeInfo& criterion : compared_by_wear()) QVERIFY(criterion.better != Better::neither);
    }
    /// Cells of a millimetre and a half do not fit pieces of 20.3 by 13.7 mm.
    void anAreaIsThePatternPieces()
    {
        Worn worn;
        add_rectangle(worn.parts.pattern, "piece", {0, 0}, 20.3e-3, 13.7e-3);
        const GarmentScene garment = worn.scene(1.5e-3);
        const WearLayout layout = wear_layout(worn.parts, garment);
        double in_cells = 0;
        for (const GarmentCell& cell : layout.cells) in_cells += cell.area;
        constexpr double drawn = 20.3e-3 * 13.7e-3; // m2
        QVERIFY(std::abs(in_cells / drawn - 1) > 1e-3);
        WearMetrics metrics(layout);
        QVERIFY(std::abs(metrics.all().area / drawn - 1) < 1e-9);
        WearFrame wet;
        for (const GarmentCell& cell : layout.cells) {
            wet.inside.push_back(cell.capacity);
            for (auto values : {&wet.outside, &wet.evaporated, &wet.on_skin}) values->push_back(0);
            wet.temperature.push_back(300);
        }
        metrics.add(wet);
        QVERIFY(std::abs(metrics.all().largest_wet_area() / drawn - 1) < 1e-9);
    }
};

QTEST_GUILESS_MAIN(TestWearOutcomes)
#include "tst_wear_outcomes.moc"
