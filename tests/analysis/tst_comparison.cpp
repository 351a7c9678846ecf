// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The ranking of candidates, and the files of a comparison.
#include "core/analysis/comparison.h"
#include "core/analysis/comparison_report.h"
#include "core/analysis/measured_run.h"
#include "core/analysis/report_inputs.h"
#include "core/base/error.h"
#include "core/run/plan_run.h"
#include "tests/support/drop_design.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

using namespace hygroloom;

namespace {

/// A run whose numbers could all be determined.
FinishedRun full_run(ExperimentType type)
{
    FinishedRun finished;
    RunRecord& run = finished.run;
    run.design = drop_design();
    run.design.experiments[0] = standard_experiment(type);
    run.fabric = run.design.fabrics[0].name;
    run.experiment = run.design.experiments[0].name;
    run.plan = plan_run(run.design, run.design.fabrics[0], run.design.experiments[0], Fidelity::draft);
    Metrics& m = finished.metrics;
    m.ledger.water_delivered = 1e-6;
    m.absorbency_time = m.horizontal_rate = 1.0;
    m.management.emplace().top.wetting_time = 1.0;
    m.wicking = WickingResult{1.0, 1.0};
    m.drying = DryingResult{1.0, 300.0, 1.0, 0.01};
    m.conditioning.emplace().half_time = 1.0;
    return finished;
}

Candidate full_candidate(ExperimentType type)
{
    FinishedRun finished = full_run(type);
    return candidate_of(std::make_shared<const RunRecord>(std::move(finished.run)),
                        std::make_shared<const Metrics>(std::move(finished.metrics)));
}

Comparison of_drops(std::initializer_list<std::pair<const char*, std::optional<double>>> radii)
{
    Comparison c;
    c.experiment = "drop";
    c.criteria = compared_by(ExperimentType::droplet);
    c.ranked_by = c.criteria[0];
    for (const auto& [fabric, radius] : radii) {
        Candidate candidate;
        candidate.fabric = fabric;
        candidate.replicates.emplace_back(ReplicateRun{});
        if (radius) candidate.replicates[0]->numbers[c.ranked_by.key] = *radius;
        candidate.numerical[c.ranked_by.key] = 0.1;
        c.candidates.push_back(candidate);
    }
    return c;
}

/// Names in their order, each with its rank: "c1 a2= d2= b-".
std::string order_of(const Comparison& comparison)
{
    std::string order;
    for (const Candidate& c : comparison.candidates)
        order += (order.empty() ? "" : " ") + c.fabric + (c.rank > 0 ? std::to_string(c.rank) : "-") + (c.tied ? "=" : "");
    return order;
}

/// Replicates of one number, each with the place of one unknown input.
Candidate with_replicates(const std::string& fabric, const std::string& key, const std::vector<double>& values,
                          const std::vector<double>& places)
{
    Candidate all;
    for (std::size_t i = 0; i < values.size(); ++i) {
        Candidate run;
        run.fabric = fabric;
        run.unknowns = {"contact angle on cotton"};
        run.wall = 1;
        run.numerical[key] = 0.01;
        run.replicates = {ReplicateRun{{{key, values[i]}}, {places[i]}}};
        add_replicate(all, run, static_cast<int>(i));
    }
    return all;
}

QString refusal_of(const std::vector<OutcomeInfo>& criteria, const std::string& name)
{
    try {
        criterion_named(criteria, name);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

const std::vector<double> eight_places{0.5, 0.07, 0.9, 0.33, 0.76, 0.21, 0.61, 0.45};

} // namespace

class TestComparison : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aRunsNumbersHaveTheNumericalErrorOfItsKind()
    {
        const Candidate candidate = full_candidate(ExperimentType::droplet);
        const Interval& radius = candidate.intervals.at("absorbency_time_s");
        QVERIFY(radius.numerical_known && radius.numerical > 0 && radius.low < radius.centre && !radius.scatter);
        QCOMPARE(radius.numerical, candidate.run->plan.expected_errors.at("absorbency_time_s") * radius.centre);
    }
    void studentsFactorsAreThoseOfTheTables()
    {
        const std::pair<int, double> of_90[] = {{1, 6.314}, {2, 2.920}, {3, 2.353}, {7, 1.895}, {30, 1.697}};
        for (const auto& [v, factor] : of_90) QVERIFY(std::abs(student_factor(of_intervals, v) / factor - 1) < 0.005);
        const std::pair<int, double> of_98[] = {{1, 31.821}, {2, 6.965}, {3, 4.541}, {7, 2.998}, {30, 2.457}};
        for (const auto& [v, factor] : of_98) QVERIFY(std::abs(student_factor(of_verdicts, v) / factor - 1) < 0.005);
    }
    void scatterAndInputAreToldApart()
    {
        std::vector<double> values, places;
        std::vector<std::vector<double>> rows;
        for (int i = 0; i < 40; ++i) { // 3 per unit of place, and scatter of standard deviation 0.1
            rows.push_back({(i + 0.5) / 40});
            values.push_back(10 + 3 * rows.back()[0] + (i % 2 == 0 ? 0.1 : -0.1));
        }
        const Interval interval = interval_of(values, rows, 0.2);
        const double factor = student_factor(of_intervals, 39) * std::sqrt(1 + 1 / 40.0);
        QVERIFY(std::abs(*interval.input / (factor * 3 / std::sqrt(12.0)) - 1) < 0.05);
        QVERIFY(std::abs(*interval.scatter / (factor * 0.1) - 1) < 0.05);
        QVERIFY(std::abs(interval.high - interval.centre - std::hypot(0.2, *interval.input, *interval.scatter)) < 1e-9);
        const Interval few = interval_of({10, 11, 12}, {{0.1}, {0.5}, {0.9}}, 0.2);
        QVERIFY(few.spread && !few.scatter && !few.input);
    }
    void whatAllFabricsShareCancels()
    {
        const std::string key = compared_by(ExperimentType::droplet)[0].key;
        std::vector<double> a, b, c;
        for (std::size_t i = 0; i < eight_places.size(); ++i) {
            const double scatter = i % 2 == 0 ? 0.02 : -0.02;
            a.push_back(10 + 4 * eight_places[i]); // the input alone moves it by 4
            b.push_back(a.back() + 0.5 + scatter); // steadily more
            c.push_back(a.back() + scatter);       // the same but for scatter
        }
        const OutcomeInfo more = compared_by(ExperimentType::droplet)[0];
        const Candidate A = with_replicates("a", key, a, eight_places), B = with_replicates("b", key, b, eight_places),
                        C = with_replicates("c", key, c, eight_places);
        QVERIFY(compared(B, A, more, 8)->verdict == Verdict::better);
        QVERIFY(compared(A, B, more, 8)->verdict == Verdict::worse);
        QVERIFY(compared(C, A, more, 8)->verdict == Verdict::no_difference);
        QCOMPARE(compared(B, A, more, 8)->share_of_pairs, 1.0);
        OutcomeInfo less = more;
        less.better = Better::less;
        QVERIFY(compared(B, A, less, 8)->verdict == Verdict::worse);
        for (std::size_t i = 0; i < b.size(); ++i) b[i] = a[i] + 0.5 - 0.8 * eight_places[i]; // hangs on the input, and turns over
        QVERIFY(compared(with_replicates("b", key, b, eight_places), A, more, 8)->verdict == Verdict::no_difference);
        for (std::size_t i = 0; i < b.size(); ++i) b[i] = a[i] + 0.5 - 0.55 * eight_places[i]; // hangs on it, and hardly ever turns over
        QVERIFY(compared(with_replicates("b", key, b, eight_places), A, more, 8)->verdict == Verdict::probably_better);
    }
    void aMissingReplicateLeavesThePairsInOrder()
    {
        const std::string key = compared_by(ExperimentType::droplet)[0].key;
        Candidate a = with_replicates("a", key, {1, 2, 3, 4, 5, 6, 7, 8}, eight_places);
        Candidate failed;
        failed.fabric = "a";
        failed.failure = "no memory";
        const Candidate b = a;
        Candidate with_gap = with_replicates("a", key, {1, 2}, {0.5, 0.1});
        add_replicate(with_gap, failed, 2);
        for (int i = 3; i < 8; ++i)
            add_replicate(with_gap, with_replicates("a", key, {1.0 + i}, {eight_places[static_cast<std::size_t>(i)]}), i);
        const auto found = compared(with_gap, b, compared_by(ExperimentType::droplet)[0], 8);
        QCOMPARE(found->pairs, 7);
        QCOMPARE(found->difference, 0.0);
        QVERIFY(with_gap.notes.back().find("Replicate 3 is missing: no memory") != std::string::npos);
        for (int i = 3; i < 8; ++i) add_replicate(with_gap, failed, i);
        for (int i = 3; i < 8; ++i) with_gap.replicates[static_cast<std::size_t>(i)].reset();
        QVERIFY(!compared(with_gap, b, compared_by(ExperimentType::droplet)[0], 8)); // two of eight are too few
    }
    void everyTypeReportsWhatItIsComparedBy_data()
    {
        QTest::addColumn<int>("type");
        for (int type = 0; type < experiment_types; ++type) QTest::newRow(name_of(static_cast<ExperimentType>(type))) << type;
    }
    void everyTypeReportsWhatItIsComparedBy()
    {
        QFETCH(int, type);
        const Candidate candidate = full_candidate(static_cast<ExperimentType>(type));
        const std::vector<OutcomeInfo> criteria = compared_by(static_cast<ExperimentType>(type));
        QVERIFY(!criteria.empty());
        for (const OutcomeInfo& criterion : criteria) QVERIFY2(candidate.intervals.contains(criterion.key), criterion.key.c_str());
    }
    void theBestComesFirstAndTiesAreShown()
    {
        Comparison c = of_drops({{"a", 3.0}, {"b", {}}, {"c", 9.0}, {"d", 3.05}, {"e", -1.0}});
        c.candidates[1].failure = "too large";
        c.candidates.push_back(c.candidates[4]);
        c.candidates.back().fabric = "f";
        c.candidates.back().replicates[0]->numbers.clear();
        judge(c);
        QCOMPARE(order_of(c), std::string("c1 d2= a2= e4 f- b-")); // those within the error tie; without the number; failed
        c.ranked_by.better = Better::less;
        judge(c);
        QCOMPARE(order_of(c), std::string("e1 a2= d2= c4 f- b-"));
    }
    void afterThreeThatTieComesTheFourth()
    {
        // Only a is shown to be better than d; nothing else differs.
        Comparison c = of_drops({{"d", 3.10}, {"c", 3.17}, {"b", 3.18}, {"a", 3.25}, {"e", 1.0}});
        judge(c);
        QCOMPARE(order_of(c), std::string("a1= b1= c1= d4 e5"));
        c.candidates.pop_back();
        judge(c);
        const std::string table = comparison_table(c), csv = comparison_csv(c), page = html_of(comparison_report(c, {}));
        std::size_t in_table = 0, in_csv = 0, in_page = 0;
        const QJsonArray in_json = QJsonDocument::fromJson(QByteArray::fromStdString(comparison_json(c))).object()["candidates"].toArray();
        for (int i = 0; i < 4; ++i) { // all say it alike, in one order
            const std::string fabric = c.candidates[static_cast<std::size_t>(i)].fabric, rank = i < 3 ? "1" : "4", tie = i < 3 ? "=" : "";
            const auto follows = [](const std::string& text, const std::string& part, std::size_t& after) {
                after = text.find(part, after);
                return after != std::string::npos;
            };
            QVERIFY2(follows(table, " " + rank + (i < 3 ? "=" : " ") + " " + fabric + " ", in_table), table.c_str());
            QVERIFY2(follows(csv, "\n" + rank + ",\"" + fabric + "\"", in_csv), csv.c_str());
            QVERIFY2(follows(page, "<td>" + rank + tie + "</td><th>" + fabric + "</th>", in_page), page.c_str());
            QCOMPARE(in_json[i].toObject()["rank"].toInt(), std::stoi(rank));
            QCOMPARE(in_json[i].toObject()["tied"].toBool(), i < 3);
        }
    }
    void theReportSaysWhoseTimeItIs()
    {
        Comparison c = of_drops({{"a", 3.0}, {"b", 9.0}});
        for (Candidate& candidate : c.candidates) {
            auto run = std::make_shared<RunRecord>();
            run->design = drop_design();
            run->fabric = run->design.fabrics[0].name;
            run->experiment = run->design.experiments[0].name;
            candidate.run = run;
        }
        c.candidates[0].wall = c.candidates[1].wall = 1.5;
        c.candidates[0].timed = 1;
        const auto page = [&c] { return html_of(comparison_report(c, {})); };
        QVERIFY2(page().find("<td>1.5 s for 1 run</td>") != std::string::npos, page().c_str());
        QVERIFY2(page().find("<td>not known</td>") != std::string::npos, page().c_str());
        QVERIFY(comparison_csv(c).find("# wall_s=") == std::string::npos);
        const Candidate single = c.candidates[0];
        add_replicate(c.candidates[0], single, 1);
        QVERIFY2(page().find("<td>3 s for 2 runs together</td>") != std::string::npos, page().c_str());
        c.candidates[0].timed = 1; // as where only the recorded run keeps its time
        QVERIFY2(page().find("for the run of the cloth as given; no times of its 2 replicates are kept") != std::string::npos,
                 page().c_str());
        QVERIFY(comparison_csv(c).find("# wall_s=of the run of the cloth as given") != std::string::npos);
        auto run = std::make_shared<RunRecord>(*c.candidates[0].run);
        run->design.fabrics[0].ends_per_cm += 1;
        run->design.fabrics[0].warp.material = {{"polyester", 0.65}, {"cotton", 0.35}};
        run->textile.quantities.areal_density_g_m2 = 180;
        c.candidates[1].run = run;
        const std::string ends = QString::number(run->design.fabrics[0].ends_per_cm - 1, 'g', 10).toStdString();
        for (const std::string& words : {"<tr><th>ends</th><td>" + ends + " /cm</td>", std::string("<td>65 % polyester, 35 % cotton</td>"),
                                         std::string("mass per area, g/m²"), std::string("<td class=\"number\">180.0</td>")})
            QVERIFY2(page().find(words) != std::string::npos, words.c_str());
        for (const char* key : {"ends_per_cm", "--replicates"}) QVERIFY2(page().find(key) == std::string::npos, key);
    }
    /// Only two lengths of a size are a width and a height.
    void twoNumbersAreASizeOrNot()
    {
        using Row = std::pair<std::string, std::string>;
        const ProjectJson value{{"sample_mm", {15, 20}},           {"at_mm", {5, -3}},     {"time_s", {0, 60}}, {"threading", {1, 2}},
                                {"outline_mm", {{0, 0}, {10, 5}}}, {"strip_mm", {25, 200}}};
        const auto rows = inputs_in_words(value);
        for (const Row& row : {Row{"sample", "15 × 20 mm"}, Row{"place", "5, -3 mm"}, Row{"time", "0, 60 s"}, Row{"threading", "1, 2"},
                               Row{"outline", "0, 0 mm; 10, 5 mm"}, Row{"strip", "25 × 200 mm"}})
            QVERIFY2(std::find(rows.begin(), rows.end(), row) != rows.end(), row.first.c_str());
    }
    void thePanelsOfAGarmentHaveWords()
    {
        using Rows = std::vector<std::pair<std::string, std::string>>;
        ProjectJson garment;
        garment["panels"]["*"]["fabric"] = "Denim";
        QVERIFY((inputs_in_words(garment) == Rows{{"panels, all, fabric", "Denim"}}));
        garment["panels"]["back"]["fabric"] = "Poplin";
        QVERIFY((inputs_in_words(garment) == Rows{{"panels, all others, fabric", "Denim"}, {"panels, back, fabric", "Poplin"}}));
    }
    void cardsStandBesideEachOtherByTheirNumbers()
    {
        Comparison c = of_drops({{"a", 3.0}, {"b", 9.0}});
        judge(c);
        const LaboratoryNumber head{"hydrostatic_head_mm", "Hydrostatic head", "mm", "ISO 811", "", {14800, 9000, 21000}, ""},
            air{"air_permeability_mm_s", "Air permeability", "mm/s", "ISO 9237", "", {0.1234, 0.1234, 0.1234}, ""};
        c.cards["a"] = {{head}, {"Air permeability is missing. It was not found."}};
        c.cards["b"].found = {air, head};
        const std::string table = comparison_table(c), csv = comparison_csv(c), page = text_of(comparison_report(c, {}));
        for (const std::string& text : {table, page}) {
            QVERIFY2(text.find("14800") != std::string::npos && text.find("9000 to 21000") != std::string::npos, text.c_str());
            QVERIFY2(text.find("0.123") != std::string::npos && text.find("e+0") == std::string::npos, text.c_str());
            QVERIFY2(text.find("Air permeability is missing. It was not found.") != std::string::npos, text.c_str());
        }
        QVERIFY2(page.find("Technical cards") != std::string::npos, page.c_str());
        QVERIFY2(csv.find(",air_permeability_mm_s,air_permeability_mm_s_low,air_permeability_mm_s_high,hydrostatic_head_mm,") !=
                     std::string::npos,
                 csv.c_str());
        QVERIFY2(csv.find(",,,,14800,9000,21000,") != std::string::npos, csv.c_str()); // a's, behind the air that it lacks
        QVERIFY2(csv.find(",0.1234,0.1234,0.1234,14800,9000,21000,") != std::string::npos, csv.c_str());
        const QJsonArray candidates =
            QJsonDocument::fromJson(QByteArray::fromStdString(comparison_json(c))).object()["candidates"].toArray();
        for (const auto& each : candidates)
            QCOMPARE(each.toObject()["laboratory_missing"].toArray().size(), each.toObject()["fabric"].toString() == "a" ? 1 : 0);
    }
    void cardsAreCriteriaWithoutVerdicts()
    {
        Comparison c = of_drops({{"a", 3.0}, {"b", 9.0}});
        c.cards["a"].found = {{"ret_m2pa_w", "Ret", "m² Pa/W", "", "", {2, 1.5, 4}, ""}};
        c.cards["b"].found = {{"cost_per_m", "Cost", "", "", "", {2.99, 2.99, 2.99}, ""}, {"no such", "", "", "", "", {1, 1, 1}, ""}};
        judge(c);
        const Comparison with = with_card_numbers(c);
        QCOMPARE(with.criteria.size(), c.criteria.size() + 2); // what no card has is none
        const auto named = [&](const char* name) {
            return *std::find_if(with.candidates.begin(), with.candidates.end(),
                                 [&](const Candidate& each) { return each.fabric == name; });
        };
        QCOMPARE(named("a").intervals.at("ret_m2pa_w").high, 4.0);
        QCOMPARE(named("b").intervals.at("cost_per_m").low, 2.99); // exact
        QVERIFY(!named("b").intervals.contains("ret_m2pa_w"));
        QCOMPARE(with.verdicts.size(), c.verdicts.size());
        const auto cost =
            std::find_if(with.criteria.begin(), with.criteria.end(), [](const auto& each) { return each.key == "cost_per_m"; });
        QCOMPARE(cost->better, Better::less);
    }
    void convertedInputsHaveFewDigits()
    {
        const ReaderUnits inches = [](const std::string& unit) {
            return unit == "mm" ? ReaderUnit{"in", 1 / 25.4} : unit == "tex" ? ReaderUnit{"Ne", 590.5, 0, true} : ReaderUnit{unit};
        };
        const ProjectJson value{{"sample_mm", {80, 80}},    {"diameter_mm", 0.05},      {"linear_density_tex", 19.6833},
                                {"strip_mm", {25, 200000}}, {"density_kg_m3", 1543.25}, {"fibre_diffusivity_m2_s", 1.25e-13}};
        using Rows = std::vector<std::pair<std::string, std::string>>;
        const Rows expected{{"sample", "3.15 × 3.15 in"},  {"diameter", "0.001969 in"},  {"linear density", "30 Ne"},
                            {"strip", "0.9843 × 7874 in"}, {"density", "1543.25 kg/m³"}, {"fibre diffusivity", "1.25e-13 m²/s"}};
        const Rows rows = inputs_in_words(value, inches);
        for (std::size_t i = 0; i < expected.size(); ++i)
            QCOMPARE(QString::fromStdString(rows[i].second), QString::fromStdString(expected[i].second));
    }
    void theReportSaysWhatTheExperimentWas()
    {
        Comparison c = of_drops({{"a", 3.0}, {"b", 9.0}});
        Design design = drop_design();
        Experiment& e = design.experiments[0];
        e = standard_experiment(ExperimentType::droplet);
        e.name = "drop";
        e.droplets = {{.volume_ul = 12, .time_s = 0}, {.volume_ul = 12, .time_s = 3}, {.volume_ul = 5, .time_s = 4}};
        e.climate = {20, 0.5, 0.3};
        e.sample_mm = {30, 25};
        e.duration_s = 40;
        const auto give = [&](Candidate& candidate, Fidelity fidelity) {
            auto run = std::make_shared<RunRecord>();
            run->design = design;
            run->fabric = design.fabrics[0].name;
            run->experiment = e.name;
            run->plan.fidelity = fidelity;
            candidate.run = run;
        };
        for (Candidate& candidate : c.candidates) give(candidate, Fidelity::draft);
        const auto has = [](const std::string& page, const char* name, const char* text) {
            return page.find(std::string("<th>") + name + "</th><td>" + text + "</td>") != std::string::npos;
        };
        std::string page = html_of(comparison_report(c, {}));
        QVERIFY2(page.find("<h2>Experiment</h2>") < page.find("<h2>Results</h2>"), page.c_str());
        QVERIFY2(has(page, "type", "Droplets (AATCC 79)") && has(page, "drops", "2 × 12 µl, at 0, 3 s; 5 µl, at 4 s"), page.c_str());
        QVERIFY2(has(page, "climate", "20 °C, 50 % relative humidity, air at 0.3 m/s"), page.c_str());
        QVERIFY2(has(page, "sample", "30 mm × 25 mm") && has(page, "duration", "40 s") && has(page, "fidelity", "draft"), page.c_str());
        QVERIFY2(has(page, "liquid", "water: 72.74 mN/m, 1.002 mPa s at 20 °C"), page.c_str());
        page = html_of(comparison_report(c, {}, [](const std::string& unit) {
            return unit == "mm" ? ReaderUnit{"cm", 0.1} : unit == "°C" ? ReaderUnit{"°F", 1.8, 32} : ReaderUnit{unit};
        }));
        QVERIFY2(has(page, "sample", "3 cm × 2.5 cm") && page.find("<td>68 °F, 50 %") != std::string::npos, page.c_str());
        design.experiments[0].duration_s = 14400;
        for (Candidate& candidate : c.candidates) give(candidate, Fidelity::draft);
        page = html_of(comparison_report(c, {}));
        QVERIFY2(has(page, "duration", "14400 s"), page.c_str());
        page = html_of(comparison_report(c, {}, [](const std::string& unit) {
            return unit == "s" ? ReaderUnit{"min", 1 / 60.0} : ReaderUnit{unit};
        }));
        QVERIFY2(has(page, "duration", "240 min") && page.find("at 0, 0.05 min") != std::string::npos, page.c_str());
        give(c.candidates[1], Fidelity::standard);
        page = html_of(comparison_report(c, {}));
        QVERIFY2(page.find("<tr><th></th><th>a</th><th>b</th></tr>") != std::string::npos, page.c_str());
        QVERIFY2(has(page, "fidelity", "draft</td><td>standard"), page.c_str());
    }
    void withoutAKnownErrorNothingIsClaimed()
    {
        Comparison c = of_drops({{"a", 3.0}, {"b", 9.0}});
        c.candidates[1].numerical.clear();
        c.baseline = "a";
        judge(c);
        QVERIFY(c.verdicts.empty());
        QCOMPARE(order_of(c), std::string("b1= a1="));
    }
    void anotherNumberMayRank()
    {
        const std::vector<OutcomeInfo> criteria = compared_by(ExperimentType::droplet);
        QCOMPARE(criterion_named(criteria, "").key, criteria[0].key);
        QVERIFY(criterion_named(criteria, "absorbency_time_s").better == Better::less);
        QCOMPARE(criterion_named(criteria, "Wetted radius, bottom").key, std::string("maximum_wetted_radius_bottom_mm"));
        QVERIFY(refusal_of(criteria, "ommc").contains("number \"ommc\" to rank by. It has equal_area_radius_mm"));
        for (const char* near : {"absorbency", "Absorbency t", "absorbancy_time_s", "absorbency tme"})
            QVERIFY2(refusal_of(criteria, near).contains("did you mean \"absorbency"), qPrintable(refusal_of(criteria, near)));
    }
    void aDifferenceDoesNotLookLikeItsInterval()
    {
        const auto seen = [](double centre, double half) {
            Interval interval;
            interval.centre = centre;
            interval.low = centre - half;
            interval.high = centre + half;
            return with_interval(OutcomeInfo{}, interval);
        };
        QCOMPARE(seen(0.4, 0.1), std::string("0.40 ± 0.10"));
        QCOMPARE(seen(0.404, 0.398), std::string("0.404 ± 0.398"));
        QCOMPARE(seen(-0.404, 0.398), std::string("-0.404 ± 0.398"));
        QCOMPARE(seen(0.4, 0.4), std::string("0.40 ± 0.40")); // they are alike
    }
    void whatCannotBeNegativeHasNoNegativeInterval()
    {
        const Interval cut = interval_of({1, 3}, {}, 0.1, least_of("absorbency_time_s"));
        QCOMPARE(cut.low, 0.0);
        QVERIFY(cut.high > 12 && cut.centre == 2);
        QVERIFY2(with_interval(OutcomeInfo{}, cut) == "2 (0 to 13)", with_interval(OutcomeInfo{}, cut).c_str());
        QVERIFY(interval_of({1, 3}, {}, 0.1, least_of("one_way_transport_pct")).low < -8);
        QVERIFY(interval_of({1, 3}, {}, 0.1, least_of("surface_temperature_steady_c")).low < -8);
        const auto high = with_interval(OutcomeInfo{}, interval_of({10, 10.2}, {}, 0.1, 0));
        QVERIFY2(high.find(" ± ") != std::string::npos, high.c_str()); // nothing of it is cut
    }
    void fewReplicatesAreSaidToBeFew()
    {
        QVERIFY(few_replicates_text(1).empty() && few_replicates_text(4).empty() && few_replicates_text(8).empty());
        QVERIFY(few_replicates_text(2).find("reaches 7.7 standard deviations to either side (2.6 with 4, 2.0 with 8)") !=
                std::string::npos);
        Comparison c = of_drops({{"a", 3.0}, {"b", 9.0}});
        c.baseline = "a";
        for (const int replicates : {1, 2, 3, 4}) {
            c.replicates = replicates;
            QCOMPARE(comparison_table(c).find("are few") != std::string::npos, replicates == 2 || replicates == 3);
        }
    }
    void whatOnlyOneHasIsAVerdictOfItsOwn()
    {
        Comparison c = of_drops({{"cotton", 3.0}, {"hemp", 9.0}, {"twill", 4.0}});
        const std::string time = "absorbency_time_s", slope = c.criteria[1].key;
        c.candidates[0].replicates[0]->numbers[time] = 0.5;
        c.candidates[1].replicates[0]->numbers[slope] = 2;
        c.candidates[2].replicates.clear(); // has not run
        c.candidates[1].duration = 10;
        c.baseline = "cotton";
        judge(c);
        QCOMPARE(c.lone.size(), std::size_t(2));
        QVERIFY(!verdict_of(c, "hemp", time) && !lone_number_of(c, "twill", time) && !lone_number_of(c, "hemp", c.criteria[0].key));
        QCOMPARE(lone_number_of(c, "hemp", time)->words, std::string("does not absorb, baseline does"));
        QCOMPARE(lone_number_of(c, "hemp", time)->sentence, std::string("cotton absorbs all of the liquid, hemp does not within 10 s."));
        QCOMPARE(lone_number_of(c, "hemp", slope)->words, std::string("only this has it"));
        for (const std::string& text : {comparison_table(c), comparison_csv(c)})
            QVERIFY2(text.find("does not absorb, baseline does") != std::string::npos, text.c_str());
        QVERIFY(comparison_json(c).find("only baseline has it") != std::string::npos);
        c.replicates = 2; // the second runs are missing
        judge(c);
        QVERIFY(c.lone.empty());
        const auto two = [](Candidate& candidate, std::optional<double> first, std::optional<double> second) {
            candidate.replicates = {ReplicateRun{}, ReplicateRun{}};
            if (first) candidate.replicates[0]->numbers["absorbency_time_s"] = *first;
            if (second) candidate.replicates[1]->numbers["absorbency_time_s"] = *second;
        };
        two(c.candidates[0], 1.0, {});
        two(c.candidates[1], {}, {});
        judge(c);
        QVERIFY2(c.lone.front().sentence.find("in 1 of 2 replicates") != std::string::npos, c.lone.front().sentence.c_str());
    }
    void theTableHasTitlesAndUnitsForPeople()
    {
        Comparison c = of_drops({{"cotton", 3.25}, {"hemp", 4.5}, {"polyester", {}}});
        c.candidates[2].failure = "too large";
        c.baseline = "cotton";
        c.measured = {{"cotton", c.ranked_by.key, 3.5, 0.25}};
        judge(c);
        const std::string table = comparison_table(c);
        for (const char* part : {"drop: ranked by stain radius by area, top (largest first)\n    fabric     stain radius by area, top  "
                                 "stain radius by area, bottom",
                                 "\n 1  hemp                     4.50 ± 0.10", "\n 2  cotton                   3.25 ± 0.10",
                                 "\n    measured                  3.5 ± 0.25", "\n -  polyester  too large\n",
                                 "\n    against cotton  stain radius by area, top", "\n    hemp                               better"})
            QVERIFY2(table.find(part) != std::string::npos, (std::string(part) + "\n" + table).c_str());
        for (int type = 0; type < experiment_types; ++type)
            for (const OutcomeInfo& criterion : compared_by(static_cast<ExperimentType>(type)))
                QVERIFY2(!criterion.title.empty() && criterion.title.find('_') == std::string::npos, criterion.key.c_str());
    }
    void theFilesHoldTheNumbersOfTheTable()
    {
        Comparison c = of_drops({{"a \"fine\", washed", 3.25}, {"b", {}}});
        c.candidates[0] = full_candidate(ExperimentType::droplet);
        c.candidates[0].fabric = "a \"fine\", washed";
        c.candidates[0].replicates = {ReplicateRun{{{c.ranked_by.key, 3.25}}, {}}};
        c.candidates[0].numerical[c.ranked_by.key] = 0.25;
        c.candidates[0].notes = {"Water reached the edge."};
        c.candidates[1].failure = "too large";
        c.baseline = "b";
        judge(c);
        const std::string csv = comparison_csv(c);
        QVERIFY2(csv.find("# ranked_by=equal_area_radius_mm, largest first\n") != std::string::npos, csv.c_str());
        QVERIFY2(csv.find("\n1,\"a \"\"fine\"\", washed\",3.25,3,3.5,,,,,,,,,,,,,,,,,,0,\"Water reached the edge.\"\n") !=
                     std::string::npos,
                 csv.c_str());
        QVERIFY2(csv.find("\n,\"b\",,,,,,,,,,,,,,,,,,,,,0,\"too large\"\n") != std::string::npos, csv.c_str());
        const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(comparison_json(c))).object();
        QCOMPARE(json["format"].toString(), QString("hygroloom-comparison"));
        QCOMPARE(json["first"].toString(), QString("most"));
        QVERIFY(!json["complete"].toBool() && csv.find("# complete=no\n") != std::string::npos);
        const QJsonArray candidates = json["candidates"].toArray();
        QCOMPARE(candidates.size(), 2);
        QCOMPARE(candidates[0].toObject()["fabric"].toString(), QString("a \"fine\", washed"));
        QCOMPARE(candidates[0].toObject()["run"].toObject()["format"].toString(), QString("hygroloom-metrics"));
        QCOMPARE(candidates[1].toObject()["failure"].toString(), QString("too large"));
    }
};

QTEST_APPLESS_MAIN(TestComparison)
#include "tst_comparison.moc"
