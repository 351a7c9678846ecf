// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Studies that run: the same table whatever the order, the jobs, the slices and the interruptions.
#include "core/base/error.h"
#include "core/study/slurm.h"
#include "core/study/study_run.h"
#include "tests/support/drop_design.h"
#include "tests/support/places.h"

#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <csignal>
#include <fstream>
#include <sys/resource.h>
#include <thread>

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
    RunQueue queue;
    return run_study(quick_design(0.01), study, folder, options, queue, cpu_places(jobs), false, callbacks);
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

    void numbersOfTheCardAreMetrics()
    {
        const QTemporaryDir place;
        const std::filesystem::path folder = place.filePath("out").toStdString();
        Study study = study_of(2);
        study.factors.resize(1);
        study.factors[0].path = "fabrics[0].warp.price";
        study.factors[0].distribution.low = 5;
        study.factors[0].distribution.high = 8;
        study.metrics = {"absorbency_time_s", "cost_per_m", "mass_g_m2"};
        Design design = quick_design(0.01);
        design.fabrics[0].warp.price = design.fabrics[0].weft.price = 6;
        RunQueue queue;
        run_study(design, study, folder, {}, queue, cpu_places(), false, {});
        const StudyTable table = collect_rows(read_study_folder(folder), folder);
        const StudyColumn &mass = *table.find("mass_g_m2"), &cost = *table.find("cost_per_m");
        QCOMPARE(mass.numbers.size(), std::size_t{2});
        QCOMPARE(mass.numbers[0], mass.numbers[1]);
        // Of 1.5 m width, at prices of 5 to 8 for the warp and 6 for the weft.
        for (const double each : cost.numbers)
            QVERIFY2(each > 1.5e-3 * mass.numbers[0] * 5 * 0.99 && each < 1.5e-3 * mass.numbers[0] * 8 * 1.01,
                     qPrintable(QString::number(each)));
        QVERIFY(cost.numbers[0] != cost.numbers[1]);
        study.metrics = {"no_such_number"};
        QVERIFY(!validate(study, design).empty());
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
        std::atomic<bool> cancel{false};
        StudyCallbacks callbacks;
        callbacks.ended = [&](const StudyRowResult&) { cancel = true; };
        RunQueue queue;
        const StudyOutcome outcome = run_study(quick_design(0.01), study_of(5), folder, {}, queue, cpu_places(), cancel, callbacks);
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

    /// A disk that is full: a limit on the size of files does the same.
    void aLineThatDoesNotFitIsTakenOffAgain()
    {
        const QTemporaryDir place;
        const std::filesystem::path folder = place.path().toStdString();
        std::filesystem::create_directories(folder / "parts");
        StudyRowResult result;
        result.metrics = {1.5};
        rlimit before{};
        getrlimit(RLIMIT_FSIZE, &before);
        {
            Journal part(folder / "parts" / "1.csv", "abc");
            part.add(result);
            const rlimit tight{std::filesystem::file_size(folder / "parts" / "1.csv") + 5, before.rlim_max};
            std::signal(SIGXFSZ, SIG_IGN);
            setrlimit(RLIMIT_FSIZE, &tight);
            result.row = 1;
            bool refused = false;
            try {
                part.add(result);
            } catch (const FileError&) {
                refused = true;
            }
            setrlimit(RLIMIT_FSIZE, &before);
            QVERIFY(refused);
            result.row = 2; // that of another thread, once there is room
            part.add(result);
        }
        KeptRows kept(3, 1);
        kept.read_parts(folder, "abc");
        using State = KeptRows::State;
        QVERIFY(kept.state(0) == State::done && kept.state(1) == State::missing && kept.state(2) == State::done);
    }

    void aLineThatIsNoRowIsRefused()
    {
        const QTemporaryDir place;
        const std::filesystem::path folder = place.path().toStdString(), file = folder / "parts" / "1.csv";
        std::filesystem::create_directories(folder / "parts");
        for (const char* line : {"0,done,1.5,0.2,cpu,abc,", "0,failed,,0.2,cpu,abc,why"}) {
            std::ofstream(file) << "hygroloom-study-part 2 abc\n" << line << "\n";
            KeptRows(3, 1).read_parts(folder, "abc");
        }
        for (const char* line :
             {"", "3,done,1.5,0.2,cpu,abc,", "-1,done,1.5,0.2,cpu,abc,", "0,don,1.5,0.2,cpu,abc,", "0,done,x,0.2,cpu,abc,",
              "0,done,1.5,,cpu,abc,", "0,done,1.5,0.2,cpu,abc", "0,done,1.5,0.2,cpu,abc,,", "0,done,1.2,done,1.5,0.2,cpu,abc,"}) {
            std::ofstream(file) << "hygroloom-study-part 2 abc\n" << line << "\n";
            KeptRows kept(3, 1);
            QVERIFY_EXCEPTION_THROWN(kept.read_parts(folder, "abc"), FileError);
        }
    }

    void filesThatAreNotOfAStudyAreKept()
    {
        for (const char* name : {"project.hygro", "study.json"}) {
            const QTemporaryDir place;
            const std::filesystem::path folder = place.path().toStdString();
            std::ofstream(folder / name) << "the user's";
            QVERIFY_EXCEPTION_THROWN(run_in(folder, study_of(2), {}), Error);
            std::ifstream file(folder / name);
            QCOMPARE(std::string(std::istreambuf_iterator<char>(file), {}), std::string("the user's"));
        }
    }

    void ofTwoStudiesThatBeginInOneFolderOneIsRefused()
    {
        for (int trial = 0; trial < 20; ++trial) {
            const QTemporaryDir place;
            const std::filesystem::path folder = place.filePath("out").toStdString();
            std::atomic<int> refused{0};
            {
                std::vector<std::jthread> both;
                for (const std::size_t points : {2, 3})
                    both.emplace_back([&, points] {
                        try {
                            run_in(folder, study_of(points), {});
                        } catch (const Error&) {
                            ++refused;
                        }
                    });
            }
            QCOMPARE(refused.load(), 1);
            QCOMPARE(merge_study(folder).missing, std::string());
        }
    }

    void aTableWhosePartsAreGoneIsKept()
    {
        const QTemporaryDir place;
        const std::filesystem::path folder = place.filePath("out").toStdString();
        run_in(folder, study_of(2), {});
        merge_study(folder);
        std::filesystem::remove_all(folder / "parts");
        QVERIFY_EXCEPTION_THROWN(merge_study(folder), Error);
        for (const std::size_t points : {2, 3}) QVERIFY_EXCEPTION_THROWN(run_in(folder, study_of(points), {}), Error);
        QCOMPARE(read_results(folder / "results.csv").rows(), std::size_t{2});
    }

    /// With a stand-in for sbatch, which tells its users things around its answer.
    void aJobArrayIsWrittenAndSubmitted()
    {
        const QTemporaryDir place;
        const std::filesystem::path programs = place.path().toStdString(), folder = programs / "50% wet; $(touch oops)";
        const auto write = [&](const std::string& lines) {
            std::ofstream(programs / "sbatch") << "#!/bin/sh\n" << lines << "\n";
            std::filesystem::permissions(programs / "sbatch", std::filesystem::perms::owner_all);
        };
        const auto script_in = [&](const std::filesystem::path& of) {
            std::ifstream file(of / "slurm" / "job.sh");
            return std::string(std::istreambuf_iterator<char>(file), {});
        };
        write("cp \"$2\" '" + (programs / "asked").string() + "'\necho 7 days to go >&2\necho '123;west'\necho Be nice >&2");
        const QByteArray before = qgetenv("PATH");
        qputenv("PATH", place.path().toUtf8() + ":" + before);
        SlurmOptions how;
        how.sbatch = "--time=2:00:00";
        const SlurmJob job = submit_study(quick_design(0.01), study_of(80), folder, {}, how);
        QCOMPARE(job.id, std::string("123"));
        QCOMPARE(job.submitted, 5); // 80 rows of 16 a task
        const std::string script = script_in(folder);
        QVERIFY(std::filesystem::exists(programs / "asked"));
        for (const char* line : {"#SBATCH --array=1-5\n", "50%% wet; $(touch oops)/slurm/task-%a.log\"\n", "#SBATCH --time=2:00:00\n",
                                 "50% wet; $(touch oops)' --task \"$SLURM_ARRAY_TASK_ID/5\" --quiet --backend auto --threads 1"})
            QVERIFY2(script.find(line) != std::string::npos, (line + script).c_str());
        QVERIFY(script.find("--force") == std::string::npos);
        how.force = how.gpus = true;
        how.tasks = 3;
        QCOMPARE(submit_study(quick_design(0.01), study_of(80), programs / "b", {}, how).submitted, 3);
        for (const char* words : {" --force", "--backend cuda", "#SBATCH --gres=gpu:1\n"})
            QVERIFY2(script_in(programs / "b").find(words) != std::string::npos, words);

        const auto refusal = [&](const std::string& lines) {
            write(lines);
            try {
                submit_study(quick_design(0.01), study_of(4), programs / "c", {}, {});
            } catch (const Error& error) {
                return std::string(error.what());
            }
            return std::string("accepted");
        };
        QCOMPARE(refusal("echo Invalid account >&2\nexit 1"), std::string("Slurm does not take the job: Invalid account"));
        QCOMPARE(refusal("echo Invalid job array specification >&2\nexit 1"),
                 std::string("Slurm does not take the job: Invalid job array specification. Give fewer tasks with --tasks."));
        qputenv("PATH", before);
    }

    void onlySlicesThatLackRowsAreSubmitted()
    {
        const QTemporaryDir place;
        const std::filesystem::path folder = place.filePath("out").toStdString();
        std::ofstream(place.filePath("sbatch").toStdString()) << "#!/bin/sh\necho 5\n";
        std::filesystem::permissions(place.filePath("sbatch").toStdString(), std::filesystem::perms::owner_all);
        StudyOptions options;
        options.resume = true;
        options.tasks = 4;
        for (const int task : {1, 3}) {
            options.task = task;
            run_in(folder, study_of(4), options);
        }
        const QByteArray before = qgetenv("PATH");
        qputenv("PATH", place.path().toUtf8() + ":" + before);
        SlurmOptions how;
        how.tasks = 4;
        QCOMPARE(submit_study(quick_design(0.01), study_of(4), folder, options, how).submitted, 2);
        std::ifstream file(folder / "slurm" / "job.sh");
        QVERIFY(std::string(std::istreambuf_iterator<char>(file), {}).find("#SBATCH --array=2,4\n") != std::string::npos);
        qputenv("PATH", before);
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
