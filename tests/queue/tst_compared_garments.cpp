// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Garments side by side: the comparison of samples, with replicates whose first is the single run.
#include "core/queue/compared_runs.h"
#include "core/wear/wear_outcomes.h"
#include "core/wear/worn_candidate.h"
#include "tests/support/places.h"
#include "tests/support/worn_tee.h"
#include "tests/wear/flat_garment.h"

#include <QTest>

#include <cmath>

#include <nlohmann/json.hpp>

using namespace hygroloom;

namespace {

/// A tee cut from textile F, and the poplin beside it; a minute of wear.
Design two_cloths()
{
    Design design = library_design("Textile F");
    add_shipped(design, "Poplin shirting");
    add_worn_tee(design, "Textile F", 60).panels["back"] = {"Textile F", 0, false, 2, "Poplin shirting"};
    return design;
}

/// fabric: that it is cut from; empty: as it is.
RunJob worn(const Design& design, const std::string& fabric = {})
{
    RunJob job{std::make_shared<const Design>(design), "wear", fabric, "."};
    job.how.fidelity = Fidelity::live;
    job.how.cell_side = 60e-3;
    return job;
}

Comparison compare(const std::vector<NamedJob>& candidates, int replicates, std::vector<FinishedGarment>* firsts = nullptr)
{
    Comparison comparison;
    comparison.experiment = "wear";
    comparison.criteria = compared_by_wear();
    comparison.ranked_by = comparison.criteria.front();
    comparison.baseline = candidates.front().name;
    comparison.replicates = replicates;
    comparison.of_garments = true;
    ComparedWatch watch;
    watch.came = [&](std::size_t i, const RunResult& result) {
        if (firsts && i < candidates.size()) firsts->push_back(*result.garment);
    };
    RunQueue queue;
    run_comparison(comparison, candidates, queue, cpu_places(), false, watch);
    return comparison;
}

} // namespace

class TestComparedGarments : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void linings_stay_where_a_garment_is_cut_from_another_fabric()
    {
        const Design poplin = cut_from(two_cloths(), "wear", "Poplin shirting");
        const Garment& tee = poplin.garments.front();
        QCOMPARE(tee.panels.at("*").fabric, std::string("Poplin shirting"));
        QCOMPARE(tee.panels.at("back").fabric, std::string("Poplin shirting"));
        const Design textile = cut_from(two_cloths(), "wear", "Textile F");
        QCOMPARE(textile.garments.front().panels.at("back").lining, std::string("Poplin shirting"));
        QCOMPARE(fabrics_of(textile.garments.front()), (std::vector<std::string>{"Poplin shirting", "Textile F"}));
    }

    void the_first_replicate_is_the_single_run()
    {
        const Design design = two_cloths();
        const NamedJob as_given{"tee", worn(design)};
        RunControl control;
        const auto backend = make_cpu_backend();
        const RunResult alone = run_job(as_given.job, *backend, control);
        const FinishedGarment& single = *alone.garment;
        std::vector<FinishedGarment> firsts;
        const Comparison three = compare({as_given}, 3, &firsts);
        QVERIFY(three.complete && three.candidates.size() == 1);
        QCOMPARE(wear_json(*firsts[0].metrics), wear_json(*single.metrics));
        QVERIFY(firsts[0].last->inside == single.last->inside && firsts[0].last->temperature == single.last->temperature);
        const Candidate& tee = three.candidates.front();
        QVERIFY(!tee.unknowns.empty());
        const auto water = [&](std::size_t replicate) { return tee.replicates[replicate]->numbers.at("panels/front/most_water_g"); };
        QVERIFY(water(0) != water(1) && water(1) != water(2));
        const Interval& range = tee.intervals.at("panels/front/most_water_g");
        QVERIFY(range.low < water(1) && water(1) < range.high && range.runs == 3);
        const Interval& area = tee.intervals.at("area_m2"); // alike in all: the size of cells is left
        QVERIFY(std::abs((area.high - area.centre) / area.centre - 0.02) < 1e-6);
        QVERIFY(tee.intervals.at("most_water_g").numerical_known && !three.candidates[0].numerical.empty());
        const auto told = nlohmann::json::parse(comparison_json(three))["candidates"][0]["run"];
        QVERIFY(told["intervals"].contains("zones/chest/water_g") && told["panels"].contains("back, layer 2"));
    }

    /// One run of each shows no scatter, and the numerical error is not known.
    void verdicts_need_replicates()
    {
        const Design design = two_cloths();
        const std::vector<NamedJob> both{{"Textile F", worn(design, "Textile F")}, {"Poplin shirting", worn(design, "Poplin shirting")}};
        const Comparison one = compare(both, 1), some = compare(both, 2);
        QVERIFY(one.verdicts.empty());
        QCOMPARE(rank_text(one.candidates[0]), std::string("1="));
        QVERIFY(comparison_table(one).find("Sizes get no verdict") != std::string::npos);
        const Compared* const verdict = verdict_of(some, "Poplin shirting", "most_water_g");
        QVERIFY(verdict && verdict->pairs == 2);
        QVERIFY(comparison_csv(some).find("largest_wet_area_m2_verdict") != std::string::npos);
    }

    void what_cannot_be_read_concerns_its_garment_alone()
    {
        const Design design = two_cloths();
        Design broken = design;
        broken.garments.front().source = "nowhere.json";
        const Comparison comparison = compare({{"tee", worn(design)}, {"broken", worn(broken)}}, 1);
        QVERIFY(comparison.complete);
        for (const Candidate& candidate : comparison.candidates)
            QCOMPARE(candidate.failure.find("nowhere.json") != std::string::npos, candidate.fabric == "broken");
    }
};

QTEST_GUILESS_MAIN(TestComparedGarments)
#include "tst_compared_garments.moc"
