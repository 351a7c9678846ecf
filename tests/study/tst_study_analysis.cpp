// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Sensitivities, surfaces and suggestions, on functions whose answers are known.
#include "core/base/error.h"
#include "core/study/analysis.h"
#include "core/study/csv_rows.h"
#include "tests/support/drop_design.h"

#include <QTest>

using namespace hygroloom;
using Role = StudyColumnRole;

namespace {

const std::vector<std::string> paths{"fabrics[0].ends_per_cm", "fabrics[0].picks_per_cm", "fabrics[0].contact_angle_deg"};
constexpr double pi_ = 3.14159265358979323846;

/// A study over as many of the paths, each from low to high.
StudyFolder study_of(std::size_t factors, double low, double high, Sampling sampling, std::size_t points, Sensitivity sensitivity)
{
    StudyFolder folder;
    folder.design = drop_design();
    folder.study.metrics = {"absorbency_time_s"};
    folder.study.sampling = sampling;
    folder.study.points = points;
    folder.study.sensitivity = sensitivity;
    for (std::size_t k = 0; k < factors; ++k) {
        Factor factor;
        factor.path = paths[k];
        factor.distribution.low = low;
        factor.distribution.high = high;
        folder.study.factors.push_back(factor);
    }
    return folder;
}

/// The table that runs would give which follow a function of the factors.
StudyTable table_of(const StudyFolder& folder, const std::function<double(const std::vector<double>&)>& function)
{
    const StudyPoints points = study_points(folder.study, folder.design);
    StudyColumn point{"point", Role::point, true, {}, {}, {}}, replicate{"replicate", Role::replicate, true, {}, {}, {}};
    StudyColumn metric{"absorbency_time_s", Role::metric, true, {}, {}, {}}, status{"status", Role::status, false, {}, {row_done}, {}};
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::vector<double> x;
        for (std::size_t k = 0; k < folder.study.factors.size(); ++k) x.push_back(points.value(i, k).number);
        point.numbers.push_back(static_cast<double>(i));
        replicate.numbers.push_back(0);
        metric.numbers.push_back(function(x));
        status.word_of.push_back(0);
    }
    return {{point, replicate, status, metric}};
}

/// Ishigami and Homma 1990, a = 7, b = 0.1.
double ishigami(const std::vector<double>& x)
{
    return std::sin(x[0]) + 7 * std::pow(std::sin(x[1]), 2) + 0.1 * std::pow(x[2], 4) * std::sin(x[0]);
}

void compare_ishigami(const StudyFolder& folder)
{
    const double variance = 49.0 / 8 + 0.1 * std::pow(pi_, 4) / 5 + 0.01 * std::pow(pi_, 8) / 18 + 0.5;
    const double alone = 0.5 * std::pow(1 + 0.1 * std::pow(pi_, 4) / 5, 2), with = 0.01 * std::pow(pi_, 8) * (1.0 / 18 - 1.0 / 50);
    const double first[] = {alone / variance, 49.0 / 8 / variance, 0},
                 total[] = {(alone + with) / variance, 49.0 / 8 / variance, with / variance};
    const std::vector<MetricSensitivity> found = sensitivities(folder, table_of(folder, ishigami));
    QCOMPARE(found.size(), std::size_t{1});
    QVERIFY2(found[0].missing.empty(), found[0].missing.c_str());
    QCOMPARE(found[0].factors.size(), std::size_t{3});
    for (std::size_t k = 0; k < 3; ++k) {
        const SobolIndex& index = found[0].factors[k];
        qInfo("%s factor %zu: first %.4f (%.3f to %.3f), expected %.4f; total %.4f (%.3f to %.3f), expected %.4f", found[0].method.c_str(),
              k + 1, index.first, index.first_low, index.first_high, first[k], index.total, index.total_low, index.total_high, total[k]);
        QVERIFY(std::abs(index.first - first[k]) < 0.05);
        QVERIFY(std::abs(index.total - total[k]) < 0.05);
        QVERIFY(index.first_low <= index.first && index.first <= index.first_high);
    }
}

} // namespace

class TestStudyAnalysis : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        if (const std::string reason = why_no_analysis(); !reason.empty()) QSKIP(reason.c_str());
    }

    void ishigamisIndicesAreTheAnalyticOnes() { compare_ishigami(study_of(3, -pi_, pi_, Sampling::sobol, 10240, Sensitivity::saltelli)); }

    void aSurfaceGivesThemFromOtherPoints()
    {
        compare_ishigami(study_of(3, -pi_, pi_, Sampling::latin_hypercube, 300, Sensitivity::surrogate));
    }

    void failedPointsLeaveOutTheirBaseSample()
    {
        const StudyFolder folder = study_of(3, -pi_, pi_, Sampling::sobol, 2560, Sensitivity::saltelli);
        StudyTable table = table_of(folder, ishigami);
        table.columns[3].numbers[5] = std::numeric_limits<double>::quiet_NaN();
        table.columns[3].numbers[512 + 9] = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(sensitivities(folder, table)[0].points, std::size_t{5 * 510});
    }

    void whatDoesNotVaryHasNoIndices()
    {
        const StudyFolder folder = study_of(2, 0, 1, Sampling::sobol, 64, Sensitivity::saltelli);
        const MetricSensitivity found = sensitivities(folder, table_of(folder, [](const auto&) { return 3.0; }))[0];
        QVERIFY(found.factors.empty());
        QVERIFY(!found.missing.empty());
        QCOMPARE(sensitivity_json(folder, {found}), std::string("{\n  \"absorbency_time_s\": {}\n}\n"));
    }

    void aSurfaceCoversPointsThatItHasNotSeen()
    {
        const auto function = [](const std::vector<double>& x) { return std::sin(6 * x[0]) + x[1] * x[1]; };
        const StudyFolder folder = study_of(2, 0, 1, Sampling::latin_hypercube, 40, Sensitivity::none);
        const Surface surface = fit_surfaces(folder, table_of(folder, function))[0];
        QVERIFY2(surface.q2 > 0.9, qPrintable(QString::number(surface.q2)));
        std::vector<std::vector<FactorValue>> at;
        for (int i = 1; i < 10; ++i)
            for (int k = 1; k < 10; ++k) at.push_back({factor_value(0.1 * i), factor_value(0.1 * k)});
        int covered = 0;
        for (const auto& [p, x] : [&] {
                 std::vector<std::pair<Prediction, std::vector<FactorValue>>> both;
                 const std::vector<Prediction> found = predict(folder, surface, at);
                 for (std::size_t i = 0; i < at.size(); ++i) both.emplace_back(found[i], at[i]);
                 return both;
             }()) {
            const double truth = function({x[0].number, x[1].number});
            QVERIFY(std::abs(p.value - truth) < 0.15);
            covered += p.low <= truth && truth <= p.high;
        }
        QVERIFY2(covered >= 65, qPrintable(QString::number(covered))); // of 81, at 90 %
        QVERIFY_EXCEPTION_THROWN(predict(folder, surface, {{factor_value(1.5), factor_value(0.5)}}), Error);
        const std::vector<Surface> again{surface};
        QVERIFY(surfaces_json(folder, again).find("hygroloom-surface") != std::string::npos);
    }

    void theNextPointIsNearTheMinimumThatKeepsTheLimit()
    {
        StudyFolder folder = study_of(2, 0, 1, Sampling::latin_hypercube, 30, Sensitivity::none);
        const auto bowl = [](const std::vector<double>& x) { return std::pow(x[0] - 0.3, 2) + std::pow(x[1] - 0.7, 2); };
        StudyTable table = table_of(folder, bowl);
        const std::vector<Surface> surfaces = fit_surfaces(folder, table);
        const StudyGoal goal = parse_goal("minimise absorbency_time_s", folder.study.metrics);
        const std::vector<SuggestedPoint> found = suggest(folder, table, surfaces, goal, "cloth", folder.design.experiments[0].name, 3);
        QCOMPARE(found.size(), std::size_t{3});
        QVERIFY(std::abs(found[0].values[0].number - 0.3) < 0.15 && std::abs(found[0].values[1].number - 0.7) < 0.15);
        // At least 0.1: the circle about the minimum is left out.
        const StudyGoal limited = parse_goal("minimise absorbency_time_s subject to absorbency_time_s >= 0.1", folder.study.metrics);
        const SuggestedPoint there = suggest(folder, table, surfaces, limited, "cloth", folder.design.experiments[0].name, 1)[0];
        QVERIFY2(there.feasible > 0.5, qPrintable(QString::number(there.feasible)));
        QVERIFY(bowl({there.values[0].number, there.values[1].number}) > 0.09);
    }

    void aGoalThatIsNotUnderstoodIsRefused()
    {
        const std::vector<std::string> metrics{"absorbency_time_s", "wick_height_mm"};
        const StudyGoal goal = parse_goal("maximise wick_height_mm subject to absorbency_time_s<=2.5", metrics);
        QVERIFY(!goal.minimise);
        QCOMPARE(goal.limits.at(0).bound, 2.5);
        QVERIFY(goal.limits.at(0).at_most);
        for (const char* wrong :
             {"", "improve wick_height_mm", "minimise wick_heigt_mm", "minimise wick_height_mm when dry",
              "minimise wick_height_mm subject to absorbency_time_s about 3", "minimise wick_height_mm subject to absorbency_time_s <= x"})
            QVERIFY_EXCEPTION_THROWN(parse_goal(wrong, metrics), Error);
    }
};

QTEST_APPLESS_MAIN(TestStudyAnalysis)
#include "tst_study_analysis.moc"
