// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The ranking of candidates, and the files of a comparison.
#include "core/analysis/comparison.h"
#include "core/base/error.h"
#include "core/run/plan_run.h"
#include "tests/support/drop_design.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

using namespace hygroloom;

namespace {

/// A run whose numbers could all be determined.
Candidate full_candidate(ExperimentType type)
{
    auto record = std::make_shared<RunRecord>();
    RunRecord& run = *record;
    run.design = drop_design();
    run.design.experiments[0] = standard_experiment(type);
    run.fabric = run.design.fabrics[0].name;
    run.experiment = run.design.experiments[0].name;
    run.plan = plan_run(run.design, run.design.fabrics[0], run.design.experiments[0], Fidelity::draft);
    auto metrics = std::make_shared<Metrics>();
    Metrics& m = *metrics;
    m.ledger.water_delivered = 1e-6;
    m.absorbency_time = m.horizontal_rate = 1.0;
    m.management.emplace().top.wetting_time = 1.0;
    m.wicking = WickingResult{1.0, 1.0};
    m.drying = DryingResult{1.0, 300.0, 1.0};
    m.conditioning.emplace().half_time = 1.0;
    return candidate_of(record, metrics);
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
        if (radius) candidate.numbers[c.ranked_by.key] = *radius;
        c.candidates.push_back(candidate);
    }
    return c;
}

std::string order_of(const Comparison& comparison)
{
    std::string order;
    for (const Candidate& c : comparison.candidates) order += c.fabric;
    return order;
}

} // namespace

class TestComparison : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void candidatesNoteTheExpectedError()
    {
        const std::vector<std::string> notes = full_candidate(ExperimentType::droplet).notes;
        QVERIFY(!notes.empty() && notes.back().starts_with("The largest numerical error is "));
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
        for (const OutcomeInfo& criterion : criteria) QVERIFY2(candidate.numbers.contains(criterion.key), criterion.key.c_str());
    }
    void theBestComesFirst()
    {
        Comparison c = of_drops({{"a", 3.0}, {"b", {}}, {"c", 9.0}, {"d", 3.0}, {"e", -1.0}});
        c.candidates[1].failure = "too large";
        c.candidates.push_back(c.candidates[4]);
        c.candidates.back().fabric = "f";
        c.candidates.back().numbers.clear();
        rank(c);
        QCOMPARE(order_of(c), std::string("cadefb")); // equal ones as they stood, then without the number, then failed
        c.ranked_by.better = Better::less;
        rank(c);
        QCOMPARE(order_of(c), std::string("eadcfb"));
    }
    void anotherNumberMayRank()
    {
        const std::vector<OutcomeInfo> criteria = compared_by(ExperimentType::droplet);
        QCOMPARE(criterion_named(criteria, "").key, criteria[0].key);
        QVERIFY(criterion_named(criteria, "absorbency_time_s").better == Better::less);
        try {
            criterion_named(criteria, "ommc");
            QFAIL("a drop has no OMMC");
        } catch (const Error& error) {
            QVERIFY2(std::string(error.what()).find("absorbency_time_s") != std::string::npos, error.what());
        }
    }
    void theTableHasTitlesAndUnitsForPeople()
    {
        Comparison c = of_drops({{"cotton", 3.25}, {"polyester", {}}});
        c.candidates[1].failure = "too large";
        QCOMPARE(comparison_table(c), std::string("drop: ranked by wetted radius, top (largest first)\n"
                                                  "    fabric     wetted radius, top  wetted radius, bottom  absorbency time  run time\n"
                                                  "                               mm                     mm                s         s\n"
                                                  " 1  cotton                   3.25                      -                -         0\n"
                                                  " 2  polyester  too large\n"));
        for (int type = 0; type < experiment_types; ++type)
            for (const OutcomeInfo& criterion : compared_by(static_cast<ExperimentType>(type)))
                QVERIFY2(!criterion.title.empty() && criterion.title.find('_') == std::string::npos, criterion.key.c_str());
    }
    void theFilesHoldTheNumbersOfTheTable()
    {
        Comparison c = of_drops({{"a \"fine\", washed", 3.25}, {"b", {}}});
        c.candidates[0] = full_candidate(ExperimentType::droplet);
        c.candidates[0].fabric = "a \"fine\", washed";
        c.candidates[0].numbers = {{c.ranked_by.key, 3.25}};
        c.candidates[0].notes = {"Water reached the edge."};
        c.candidates[1].failure = "too large";
        rank(c);
        const std::string csv = comparison_csv(c);
        QVERIFY2(csv.find("# ranked_by=maximum_wetted_radius_top_mm, largest first\n") != std::string::npos, csv.c_str());
        QVERIFY2(csv.find("\n1,\"a \"\"fine\"\", washed\",3.25,,,0,\"Water reached the edge.\"\n") != std::string::npos, csv.c_str());
        QVERIFY2(csv.find("\n2,\"b\",,,,0,\"too large\"\n") != std::string::npos, csv.c_str());
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
