// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Studies that run: the same table whatever the order, the jobs, the slices and the interruptions.
#include "core/analysis/sweep.h"
#include "core/base/error.h"
#include "core/project/project_json.h"
#include "core/study/study_run.h"
#include "tests/support/drop_design.h"

#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>

#include <fstream>

using namespace hygroloom;

namespace {

Study study_of(std::size_t points, int replicates = 1)
{
    Study study;
    study.fidelity = Fidelity::live;
    study.sampling = Sampling::latin_hypercube;
    study.points = points;
    study.replicates = replicates;
    set_knob(study.knobs, "free_liquid", "cap");
    for (const auto& [path, low, high] :
         {std::tuple{"fabrics[0].contact_angle_deg", 20.0, 60.0}, std::tuple{"fabrics[0].warp.twist_per_m", 500.0, 900.0}}) {
        Factor factor;
        factor.path = path;
        factor.distribution.low = low;
        factor.distribution.high = high;
        study.factors.push_back(factor);
    }
    return study;
}

/// Its drop stands as a cap, which is quick.
Design quick_design(double duration)
{
    Design design = drop_design(35, duration);
    design.experiments[0].closure = Closure::pores;
    return design;
}

std::vector<std::unique_ptr<Backend>> cpus(int count)
{
    std::vector<std::unique_ptr<Backend>> backends;
    while (static_cast<int>(backends.size()) < count) backends.push_back(make_cpu_backend());
    return backends;
}

/// The table but for times.
std::string text_of(const std::filesystem::path& folder)
{
    StudyTable table = collect_rows(read_study_folder(folder), folder);
    for (StudyColumn& column : table.columns)
        if (column.role == StudyColumnRole::wall) std::fill(column.numbers.begin(), column.numbers.end(), 0);
    return format_results(table);
}

StudyOutcome run_in(const std::filesystem::path& folder, const Study& study, const StudyOptions& options, int jobs = 1,
                    const StudyCallbacks& callbacks = {})
{
    RunControl control;
    return run_study(quick_design(0.01), study, folder, options, cpus(jobs), control, callbacks);
}

} // namespace

class TestStudyRun : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void slicesJobsAndResumingGiveTheSameTable()
    {
        const QTemporaryDir place;
        const std::filesystem::path whole = place.filePath("whole").toStdString(), parts = place.filePath("parts").toStdString();
        const Study study = study_of(6, 2);
        const StudyOutcome all = run_in(whole, study, {}, 2);
        QCOMPARE(all.progress.ended, std::size_t{12});
        QCOMPARE(all.progress.failed, std::size_t{0});
        const std::string expected = text_of(whole);
        QCOMPARE(std::count(expected.begin(), expected.end(), '\n'), 13);

        StudyOptions third;
        third.resume = true;
        third.task = 3;
        third.tasks = 3;
        QCOMPARE(run_in(parts, study, third).progress.ended, std::size_t{4});
        QCOMPARE(merge_study(parts).ended, std::size_t{4});
        QVERIFY(!merge_study(parts).missing.empty());
        std::ofstream(parts / "parts" / "000003-of-000003.csv", std::ios::app) << "7,done,1.5"; // killed there
        StudyOptions rest;
        rest.resume = true;
        QCOMPARE(run_in(parts, study, rest).progress.kept, std::size_t{4});
        QVERIFY(merge_study(parts).missing.empty());
        QCOMPARE(text_of(parts), expected);
        std::ifstream csv(parts / "results.csv");
        QCOMPARE(parse_results(std::string(std::istreambuf_iterator<char>(csv), {}), "results.csv").rows(), std::size_t{12});
    }

    void aPointTakesLittleBesideItsRun()
    {
        const QTemporaryDir place;
        const Design design = quick_design(0.001);
        Study study = study_of(50);
        RunControl control;
        const StudyPoints points = study_points(study, design);
        const std::vector<std::unique_ptr<Backend>> backends = cpus(1);
        RunOptions how;
        how.fidelity = Fidelity::live;
        how.knobs = study.knobs;
        how.threads = 1;
        QElapsedTimer timer;
        double alone = INFINITY, swept = INFINITY;
        for (int i = 0; i < 3; ++i) { // the least of three, as others use this machine
            timer.start();
            for (std::size_t point = 0; point < points.size(); ++point) {
                const Design there = with_point(study, json_from_design(design), points, point).design;
                run_and_measure(there, "cloth", design.experiments[0].name, how, *backends[0], control);
            }
            alone = std::min(alone, static_cast<double>(timer.nsecsElapsed()));
            timer.start();
            run_study(design, study, place.filePath(QString::number(i)).toStdString(), {}, backends, control, {});
            swept = std::min(swept, static_cast<double>(timer.nsecsElapsed()));
        }
        const double each = (swept - alone) / 1e6 / static_cast<double>(points.size());
        qInfo("a run takes %.2f ms, in a study %.2f ms more", alone / 1e6 / static_cast<double>(points.size()), each);
        QVERIFY2(each < 5, qPrintable(QString::number(each)));
    }

    void replicatesShareTheirRandomNumbersBetweenPoints()
    {
        const QTemporaryDir place;
        const std::filesystem::path folder = place.filePath("out").toStdString();
        Study study = study_of(2, 2);
        study.factors.resize(1);
        study.factors[0].distribution.low = 35;
        study.factors[0].distribution.high = 35 + 1e-12; // the same point twice
        run_in(folder, study, {});
        const StudyTable table = collect_rows(read_study_folder(folder), folder);
        const StudyColumn& radius = *table.find("maximum_wetted_radius_top_mm");
        QCOMPARE(radius.numbers[0], radius.numbers[2]);
        QCOMPARE(radius.numbers[1], radius.numbers[3]);
        QVERIFY(radius.numbers[0] != radius.numbers[1] ||
                table.find("absorbency_time_s")->numbers[0] != table.find("absorbency_time_s")->numbers[1]);
    }

    void aFolderWithRowsIsLeftAlone()
    {
        const QTemporaryDir place;
        const std::filesystem::path folder = place.filePath("out").toStdString();
        run_in(folder, study_of(2), {});
        QVERIFY_EXCEPTION_THROWN(run_in(folder, study_of(2), {}), Error);
        StudyOptions resume;
        resume.resume = true;
        QVERIFY_EXCEPTION_THROWN(run_in(folder, study_of(3), resume), Error); // another study
        QCOMPARE(run_in(folder, study_of(2), resume).progress.kept, std::size_t{2});
    }

    void aPointThatCannotRunIsAFailedRow()
    {
        const QTemporaryDir place;
        const std::filesystem::path folder = place.filePath("out").toStdString();
        Study study = study_of(0);
        study.sampling = Sampling::grid;
        study.factors.resize(1);
        study.factors[0] = {"fabrics[0].ends_per_cm", {factor_value(20.0), factor_value(5000.0)}, {}, {}, {}, {}};
        const StudyOutcome outcome = run_in(folder, study, {});
        QCOMPARE(outcome.progress.failed, std::size_t{1});
        QVERIFY2(outcome.failures.at(0).second.find("fabrics[0].ends_per_cm: The number of ends per cm must be from") == 0,
                 outcome.failures[0].second.c_str());
        const StudyTable table = collect_rows(read_study_folder(folder), folder);
        QCOMPARE(table.find("status")->word(1), std::string(row_failed));
        QVERIFY(std::isnan(table.find("absorbency_time_s")->numbers[1]));
        StudyOptions again;
        again.resume = true;
        QCOMPARE(run_in(folder, study, again).progress.kept, std::size_t{2}); // it stays as it is
        again.retry_failed = true;
        QCOMPARE(run_in(folder, study, again).progress.kept, std::size_t{1});
    }

    void cancellingKeepsWhatHasEnded()
    {
        const QTemporaryDir place;
        const std::filesystem::path folder = place.filePath("out").toStdString();
        RunControl control;
        StudyCallbacks callbacks;
        callbacks.ended = [&](const StudyRowResult&) { control.cancel = true; };
        const StudyOutcome outcome = run_study(quick_design(0.01), study_of(5), folder, {}, cpus(1), control, callbacks);
        QVERIFY(outcome.cancelled);
        QCOMPARE(outcome.progress.ended, std::size_t{1});
        QCOMPARE(collect_rows(read_study_folder(folder), folder).rows(), std::size_t{1});
    }

    void onePartHasOneWriter()
    {
        const QTemporaryDir place;
        const std::filesystem::path file = place.filePath("1.csv").toStdString();
        const Journal first(file, "abc");
        QVERIFY_EXCEPTION_THROWN(Journal(file, "abc"), FileError);
    }

    void aPartOfAnotherStudyIsRefused()
    {
        const QTemporaryDir place;
        const std::filesystem::path folder = place.path().toStdString();
        std::filesystem::create_directories(folder / "parts");
        {
            const Journal part(folder / "parts" / "1.csv", "abc");
        }
        KeptRows kept(3, 1);
        kept.read_parts(folder, "abc");
        QVERIFY_EXCEPTION_THROWN(kept.read_parts(folder, "abd"), FileError);
    }
};

QTEST_APPLESS_MAIN(TestStudyRun)
#include "tst_study_run.moc"
