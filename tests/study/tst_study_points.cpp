// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The points of each design: how many, where, and the same on any machine.
#include "core/base/error.h"
#include "core/project/project_json.h"
#include "core/study/points.h"
#include "core/study/quantiles.h"
#include "tests/support/drop_design.h"

#include <QTest>

#include <set>

using namespace hygroloom;

namespace tst_study_points {
namespace {

Factor range(const char* path, double low, double high)
{
    Factor factor;
    factor.path = path;
    factor.distribution.low = low;
    factor.distribution.high = high;
    return factor;
}

Factor list(const char* path, const std::vector<double>& values)
{
    Factor factor;
    factor.path = path;
    for (const double value : values) factor.values.push_back(factor_value(value));
    return factor;
}

Study study_of(Sampling sampling, std::size_t points)
{
    Study study;
    study.sampling = sampling;
    study.points = points;
    study.factors = {range("fabrics[0].ends_per_cm", 20, 30), range("fabrics[0].contact_angle_deg", 10, 70)};
    return study;
}

double number(const StudyPoints& points, std::size_t point, std::size_t factor) { return points.value(point, factor).number; }

} // namespace

class TestStudyPoints : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aHypercubeHasOnePointInEachStratum()
    {
        const StudyPoints points = study_points(study_of(Sampling::latin_hypercube, 50), drop_design());
        QCOMPARE(points.size(), std::size_t{50});
        for (std::size_t k = 0; k < 2; ++k) {
            std::set<int> strata;
            for (std::size_t i = 0; i < 50; ++i)
                strata.insert(static_cast<int>((number(points, i, k) - (k == 0 ? 20 : 10)) / (k == 0 ? 10 : 60) * 50));
            QCOMPARE(strata.size(), std::size_t{50});
        }
    }

    void sobolPointsFillEqualSharesAlike()
    {
        const StudyPoints points = study_points(study_of(Sampling::sobol, 64), drop_design());
        int shares[8][8] = {}; // a number of points that is a power of 2 has one in each
        for (std::size_t i = 0; i < 64; ++i)
            ++shares[static_cast<int>((number(points, i, 0) - 20) / 10 * 8)][static_cast<int>((number(points, i, 1) - 10) / 60 * 8)];
        for (const auto& row : shares)
            for (const int count : row) QCOMPARE(count, 1);
    }

    void anotherSeedGivesOtherPoints()
    {
        for (const Sampling sampling : {Sampling::latin_hypercube, Sampling::sobol}) {
            Study study = study_of(sampling, 8);
            const double one = number(study_points(study, drop_design()), 3, 0);
            study.seed = 2;
            QVERIFY(number(study_points(study, drop_design()), 3, 0) != one);
        }
    }

    void aGridHasAsManyLevelsAsItsPointsAllow()
    {
        Study study = study_of(Sampling::grid, 100);
        study.factors.push_back(list("fabrics[0].picks_per_cm", {20, 25, 30}));
        const StudyPoints points = study_points(study, drop_design()); // 5 x 5 x 3
        QCOMPARE(points.size(), std::size_t{75});
        QCOMPARE(number(points, 0, 0), 20.0);
        QCOMPARE(number(points, 1, 2), 25.0); // the last changes first
        QCOMPARE(number(points, 74, 0), 30.0);
        study.factors[0].levels = 2;
        QCOMPARE(study_points(study, drop_design()).size(), std::size_t{2 * 16 * 3});
        study.points = 5;
        QVERIFY_EXCEPTION_THROWN(study_points(study, drop_design()), Error);
    }

    void oneAtATimeChangesTheProjectsOwnValues()
    {
        Design design = drop_design();
        design.fabrics[0].ends_per_cm = 24;
        Study study = study_of(Sampling::one_at_a_time, 0);
        study.factors.push_back(list("fabrics[0].picks_per_cm", {20, 25, 30}));
        study.factors.back().base = factor_value(25.0);
        const StudyPoints points = study_points(study, design); // base, 2 ends, 2 angles, 2 picks but the base
        QCOMPARE(points.size(), std::size_t{7});
        QCOMPARE(number(points, 0, 0), 24.0);
        QCOMPARE(number(points, 1, 0), 20.0);
        QCOMPARE(number(points, 2, 0), 30.0);
        QCOMPARE(number(points, 3, 0), 24.0);
        QCOMPARE(number(points, 6, 2), 30.0);
    }

    void whatOthersChangeBesideMustBeInTheList()
    {
        Design design = drop_design();
        design.fabrics[0].ends_per_cm = 24;
        Study study = study_of(Sampling::one_at_a_time, 0);
        study.factors = {list("fabrics[0].ends_per_cm", {20, 22})};
        const auto first = [&] {
            const std::vector<Issue> issues = validate(study, design);
            return issues.empty() ? std::string() : issues[0].where.text() + ": " + issues[0].text();
        };
        QVERIFY2(first().find("factors[0].values: One at a time") == 0 && first().find(", 24,") != std::string::npos, first().c_str());
        study.factors[0].base = factor_value(23.0);
        QVERIFY2(first().find("factors[0].base: This must be one of \"values\"; given is 23.") == 0, first().c_str());
        study.factors[0].base = factor_value(22.0);
        QCOMPARE(first(), std::string());
        study.factors = {range("fabrics[0].ends_per_cm", 20, 30)};
        study.factors[0].base = factor_value(std::string("many"));
        QVERIFY2(first().find("factors[0].base: This must be a number; given is \"many\".") == 0, first().c_str());
    }

    void aDesignForIndicesHasBlocksThatShareColumns()
    {
        Study study = study_of(Sampling::sobol, 43);
        study.sensitivity = Sensitivity::saltelli;
        const StudyPoints points = study_points(study, drop_design());
        const std::size_t base = saltelli_base(study);
        QCOMPARE(base, std::size_t{10});
        QCOMPARE(points.size(), std::size_t{40});
        for (std::size_t i = 0; i < base; ++i) {
            QCOMPARE(number(points, 2 * base + i, 0), number(points, base + i, 0)); // of the other sample
            QCOMPARE(number(points, 2 * base + i, 1), number(points, i, 1));
            QCOMPARE(number(points, 3 * base + i, 0), number(points, i, 0));
            QCOMPARE(number(points, 3 * base + i, 1), number(points, base + i, 1));
        }
    }

    void quantilesArePublishedOnes()
    {
        const auto at = [](FactorDistribution::Type type, double mean, double sd, double probability) {
            return quantile(FactorDistribution{type, mean, sd, 0, {}, {}}, probability);
        };
        using Type = FactorDistribution::Type;
        QVERIFY(std::abs(at(Type::normal, 10, 2, 0.975) - (10 + 2 * 1.959963985)) < 1e-8);
        // Of the logarithm: variance ln(1 + 0.25), mean ln 4 less half of it.
        QVERIFY(std::abs(at(Type::lognormal, 4, 2, 0.5) - 4 / std::sqrt(1.25)) < 1e-9);
        FactorDistribution triangular{Type::triangular, 0, 0, 1, 0.0, 4.0};
        QVERIFY(std::abs(quantile(triangular, 0.25) - 1) < 1e-12); // a quarter of the area lies below the mode
        FactorDistribution logs{Type::log_uniform, 0, 0, 0, 1.0, 100.0};
        QVERIFY(std::abs(quantile(logs, 0.5) - 10) < 1e-9);
        FactorDistribution cut{Type::normal, 0, 1, 0, 0.0, {}};
        QVERIFY(std::abs(quantile(cut, 0.5) - 0.6744897502) < 1e-9); // the upper quartile of the whole
        QVERIFY(quantile(cut, 0) >= 0);
    }

    void stepsGiveWholeNumbers()
    {
        Factor factor = range("fabrics[0].warp.fibres_per_yarn", 20, 60);
        factor.step = 10;
        std::set<double> seen;
        for (int i = 0; i < 100; ++i) seen.insert(quantile(factor, i / 100.0).number);
        QCOMPARE(seen, (std::set<double>{20, 30, 40, 50, 60}));
    }

    void aPointSetsTheProjectAndTheKnobs()
    {
        Study study = study_of(Sampling::grid, 4);
        study.factors.push_back(list("fidelity.fibre_shells", {3}));
        const Design design = drop_design();
        const PointSetting setting = with_point(study, json_from_design(design), study_points(study, design), 3);
        QCOMPARE(setting.design.fabrics[0].ends_per_cm, 30.0);
        QCOMPARE(setting.design.fabrics[0].contact_angle_deg.value_or(0), 70.0);
        QCOMPARE(setting.knobs.at("fibre_shells"), 3.0);
    }
};

} // namespace tst_study_points

QTEST_APPLESS_MAIN(tst_study_points::TestStudyPoints)
#include "tst_study_points.moc"
