// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Studies of garments that are worn: the same rows and tables as of samples.
#include "core/project/library.h"
#include "core/study/study_run.h"
#include "core/wear/wear_outcomes.h"
#include "core/wear/worn_candidate.h"
#include "tests/support/drop_design.h"
#include "tests/support/places.h"
#include "tests/support/worn_tee.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace hygroloom;

namespace {

/// A tee of textile F, worn for two seconds, beside a sample's experiment.
Design tee_and_drop()
{
    Design design = drop_design();
    add_shipped(design, "Textile F");
    add_worn_tee(design, "Textile F", 2);
    return design;
}

Study worn_study()
{
    Study study;
    study.experiments = {"wear"};
    study.fidelity = Fidelity::live;
    study.sampling = Sampling::grid;
    study.metrics = {"sweat_g", "area_m2", "panels/front/water_g"};
    Factor chest;
    chest.path = "garments.tee.source.chest_mm";
    chest.values = {factor_value(900), factor_value(1100)};
    study.factors.push_back(chest);
    return study;
}

StudyTable table_of(const Design& design, const Study& study, const std::filesystem::path& folder, StudyOutcome* outcome = nullptr)
{
    RunQueue queue;
    StudyOutcome ended = run_study(design, study, folder, {}, queue, cpu_places(), false, {});
    if (outcome) *outcome = std::move(ended);
    return collect_rows(read_study_folder(folder), folder);
}

const StudyColumn& column(const StudyTable& table, const std::string& name)
{
    for (const StudyColumn& each : table.columns)
        if (each.name == name) return each;
    throw Error("no column " + name);
}

std::string first_issue(const Study& study, const Design& design)
{
    const std::vector<Issue> issues = validate(study, design);
    return issues.empty() ? std::string() : issues.front().where.text() + ": " + issues.front().text();
}

} // namespace

class TestStudyGarments : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void a_garments_size_is_a_factor()
    {
        const QTemporaryDir place;
        const std::filesystem::path folder = place.filePath("sizes").toStdString();
        QCOMPARE(first_issue(worn_study(), tee_and_drop()), std::string());
        StudyOutcome outcome;
        const StudyTable table = table_of(tee_and_drop(), worn_study(), folder, &outcome);
        QVERIFY2(outcome.failures.empty(), outcome.failures.empty() ? "" : outcome.failures.front().second.c_str());
        const std::vector<double>&area = column(table, "area_m2").numbers, &sweat = column(table, "sweat_g").numbers;
        QVERIFY(area.size() == 2 && area[0] < area[1] && sweat[0] < sweat[1]);
        QVERIFY(column(table, "panels/front/water_g").numbers[0] > 0);
    }

    /// Each listed fabric takes the place of the panels' own; replicates draw the inputs of what it is cut from.
    void fabrics_take_the_place_of_the_garments_own()
    {
        const QTemporaryDir place;
        Design design = tee_and_drop();
        design.wears.front().duration_s = 20;
        Study study = worn_study();
        study.factors.clear();
        study.metrics = {"share_of_capacity"};
        study.fabrics = {"cloth", "Textile F"};
        QCOMPARE(first_issue(study, design), std::string());
        const std::vector<double> listed =
            column(table_of(design, study, place.filePath("listed").toStdString()), "share_of_capacity").numbers;
        study.fabrics.clear();
        study.replicates = 2;
        const std::vector<double> own = column(table_of(design, study, place.filePath("own").toStdString()), "share_of_capacity").numbers;
        QVERIFY(listed.size() == 2 && own.size() == 2);
        QCOMPARE(own[0], listed[1]);
        QVERIFY(listed[0] != listed[1] && own[0] != own[1]);
    }

    void what_a_study_of_garments_cannot_be_is_told()
    {
        const Design design = tee_and_drop();
        Study study = worn_study();
        study.experiments = {"wear", design.experiments.front().name};
        QVERIFY(first_issue(study, design).find("not both") != std::string::npos);
        study = worn_study();
        study.metrics = {"absorbency_time_s"};
        QVERIFY(first_issue(study, design).find("They have: area_m2, ") != std::string::npos);
        for (const char* wrong : {"panels/sweat_g", "panels//water_g", "sleeves/front/water_g", "panels/front/nothing"}) {
            study.metrics = {wrong};
            QVERIFY2(first_issue(study, design).find("They have: area_m2, ") != std::string::npos, wrong);
        }
        study.metrics = {"panels/front/water_g", "zones/chest/water_g"};
        QCOMPARE(first_issue(study, design), std::string());
        study = worn_study();
        study.fidelity.reset();
        study.error = 0.05;
        QVERIFY(first_issue(study, design).find("name a fidelity") != std::string::npos);
        const auto refused = [&](const char* path) {
            const auto message = out_of_reach(worn_study(), design, path);
            return message ? english(*message) : std::string();
        };
        QVERIFY(refused("fabrics.cloth.ends_per_cm").find("does not run the fabric") != std::string::npos);
        QCOMPARE(refused("fabrics.Textile F.ends_per_cm"), std::string());
        QCOMPARE(refused("experiments.wear.duration_s"), std::string());
        QVERIFY(!refused("experiments[0].duration_s").empty());

        Study chosen = worn_study();
        chosen.factors.resize(1);
        chosen.factors[0].path = "garments.tee.panels.*.fabric";
        QVERIFY(!out_of_reach(chosen, design, "fabrics.cloth.ends_per_cm"));
        QVERIFY(!out_of_reach(chosen, design, chosen.factors[0].path));
        chosen.fabrics = {"cloth"};
        QVERIFY(english(out_of_reach(chosen, design, chosen.factors[0].path).value()).find("own list of fabrics") != std::string::npos);
    }

    void a_part_that_is_not_there_is_an_error_of_its_row()
    {
        const QTemporaryDir place;
        Study study = worn_study();
        study.factors.clear();
        study.metrics = {"panels/collar/water_g"};
        StudyOutcome outcome;
        Design design = tee_and_drop();
        design.wears.front().duration_s = 86400; // it is told before the run, which would outlast the test
        table_of(design, study, place.filePath("collar").toStdString(), &outcome);
        QVERIFY(outcome.failures.size() == 1 && outcome.failures.front().second.find("panels/collar/water_g") != std::string::npos);
    }

    void a_study_finds_the_garments_files_from_its_folder()
    {
        Design design = tee_and_drop();
        design.garments.front().source = "tee.json";
        design.wears.front().activity_file = "/rates.csv";
        const Design moved = with_absolute_files(design, "/somewhere/projects");
        QCOMPARE(moved.garments.front().source, std::string("/somewhere/projects/tee.json"));
        QCOMPARE(moved.wears.front().activity_file, std::string("/rates.csv"));
        QCOMPARE(with_absolute_files(tee_and_drop(), "/somewhere") == tee_and_drop(), true);
    }
};

QTEST_GUILESS_MAIN(TestStudyGarments)
#include "tst_study_garments.moc"
