// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How often verdicts are right: a fabric against itself with other seeds, and against one that is worse or better on purpose.
// HYGROLOOM_VERDICTS asks for another number of repeats, HYGROLOOM_VERDICTS_FROM for other seeds. What was found stands in
// resources/help/limits.md.
#include "core/analysis/comparison.h"
#include "core/analysis/measured_run.h"
#include "core/design/unknowns.h"
#include "core/verify/set_ups.h"

#include <QTest>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <array>
#include <map>

using namespace hygroloom;

namespace tst_verdicts {
namespace {

constexpr int replicates = 8;

int repeats()
{
    const int asked = qEnvironmentVariableIntValue("HYGROLOOM_VERDICTS");
    return asked > 0 ? asked : 1;
}

/// Cotton cloth of 35 ends and picks a cm, with a finish, and two that are worse or better on purpose.
Design three_cloths()
{
    Design design = drop_on_cotton(3, 2, 35);
    design.fabrics[0].contact_angle_deg = 35;
    design.fabrics[0].name = "cloth";
    design.fabrics.push_back(design.fabrics[0]);
    design.fabrics[1].name = "55 degrees";
    design.fabrics[1].contact_angle_deg = 55;
    design.fabrics.push_back(design.fabrics[0]);
    design.fabrics[2].name = "open";
    design.fabrics[2].ends_per_cm *= 0.8;
    design.fabrics[2].picks_per_cm *= 0.8;
    Experiment drop = design.experiments[0];
    drop.name = "drop";
    drop.closure = Closure::pores;
    drop.sample_mm = {10, 10};
    Experiment strip = standard_experiment(ExperimentType::vertical_wicking);
    strip.name = "strip";
    strip.sample_mm = {1, 60}; // few yarns, which are alike
    strip.duration_s = 10;
    design.experiments = {drop, strip};
    return design;
}

/// otherwise: another seed for what scatters, with the same unknown inputs.
Candidate run_all(const Design& design, const std::string& fabric, const std::string& experiment, std::uint64_t seed,
                  std::uint64_t otherwise = 0)
{
    Candidate all;
    for (int number = 0; number < replicates; ++number) {
        const Drawn one = drawn(design, fabric, experiment, {seed, number, replicates});
        RunOptions how;
        how.fidelity = Fidelity::draft;
        how.seed = one.seed + otherwise;
        how.threads = 1;
        if (repeats() == 1) how.knobs = {{"particles_per_droplet", 300}}; // what is counted is of a draft as it is
        RunControl control;
        const auto backend = make_cpu_backend();
        FinishedRun run = run_and_measure(one.design, fabric, experiment, how, *backend, control);
        run.run.textile = {};
        Candidate candidate =
            candidate_of(std::make_shared<const RunRecord>(std::move(run.run)), std::make_shared<const Metrics>(std::move(run.metrics)));
        candidate.unknowns = one.names;
        candidate.replicates[0]->places = one.places;
        add_replicate(all, candidate, number);
    }
    return all;
}

/// Of one repeat: by experiment and metric, each worse or better cloth, and the same one with another seed.
struct Found {
    std::map<std::string, Compared> same, angle, open;
};

Found repeat(const Design& design, const std::string& experiment, int number)
{
    const int from = qEnvironmentVariableIntValue("HYGROLOOM_VERDICTS_FROM");
    const auto seed = static_cast<std::uint64_t>(1000 * (2 * (from + number) + 1));
    Candidate cloth, again, angle, open;
    tbb::parallel_invoke([&] { cloth = run_all(design, "cloth", experiment, seed); },
                         [&] { again = run_all(design, "cloth", experiment, seed, 500); },
                         [&] {
                             if (repeats() > 1) angle = run_all(design, "55 degrees", experiment, seed); // counted, not judged
                         },
                         [&] { open = run_all(design, "open", experiment, seed); });
    Found found;
    for (const OutcomeInfo& criterion : compared_by(find_experiment(design, experiment)->type)) {
        const auto keep = [&](std::map<std::string, Compared>& into, const Candidate& other) {
            if (const auto one = compared(other, cloth, criterion, replicates)) into[criterion.key] = *one;
        };
        keep(found.same, again);
        if (!angle.replicates.empty()) keep(found.angle, angle);
        keep(found.open, open);
    }
    return found;
}

} // namespace

class TestVerdicts : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void differencesAreFoundWhereTheyAre_data()
    {
        QTest::addColumn<QString>("experiment");
        QTest::newRow("drop") << "drop";
        QTest::newRow("strip") << "strip";
    }
    void differencesAreFoundWhereTheyAre()
    {
        QFETCH(QString, experiment);
        const Design design = three_cloths();
        std::vector<Found> all(static_cast<std::size_t>(repeats()));
        tbb::parallel_for(std::size_t{0}, all.size(),
                          [&](std::size_t i) { all[i] = repeat(design, experiment.toStdString(), static_cast<int>(i)); });
        std::map<std::string, std::array<std::array<int, 5>, 3>> count;
        for (const Found& found : all)
            for (std::size_t which = 0; which < 3; ++which)
                for (const auto& [key, one] : *std::array{&found.same, &found.angle, &found.open}[which])
                    ++count[key][which][static_cast<std::size_t>(one.verdict)];
        const char* names[] = {"itself", "55 degrees", "open"};
        for (const auto& [key, table] : count)
            for (const std::size_t which : repeats() > 1 ? std::vector<std::size_t>{0, 1, 2} : std::vector<std::size_t>{0, 2})
                qInfo("%s, %s: better %d, probably %d, none %d, probably worse %d, worse %d", key.c_str(), names[which], table[which][0],
                      table[which][1], table[which][2], table[which][3], table[which][4]);
        // An open cloth conducts better and sucks less: by its rate alone it is hardly told.
        const char* telling = experiment == "drop" ? "absorbency_time_s" : "wick_height_mm";
        QCOMPARE(count[telling][2][2], 0); // the open cloth is told from the other
        for (const auto& [key, table] : count) QVERIFY2(20 * (repeats() - table[0][2]) <= repeats(), key.c_str());
    }
};

} // namespace tst_verdicts

QTEST_APPLESS_MAIN(tst_verdicts::TestVerdicts)
#include "tst_verdicts.moc"
