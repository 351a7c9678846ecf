// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The parts of a scene: each refuses what does not fit together, with a sentence.
#include "core/base/error.h"
#include "core/scene/unevenness.h"
#include "core/verify/set_ups.h"

#include <QTest>

#include <set>

using namespace hygroloom;

namespace {

/// What is said of a scene; empty: nothing.
std::string complaint(const Scene& scene)
{
    try {
        check(scene);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

} // namespace

class TestSceneParts : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aPlainSceneIsAccepted() { QCOMPARE(complaint(bare_scene(3, 4, 1e-3, 293.15)), std::string()); }
    void neighbouringSeedsGiveOtherYarns() // and not the same ones a yarn farther on
    {
        Design design = drop_on_cotton(2, 1, 35);
        for (Yarn* yarn : {&design.fabrics[0].warp, &design.fabrics[0].weft}) yarn->irregularity_cv = 0.2;
        const Textile textile = textile_of_run(design, design.fabrics[0], design.experiments[0]);
        const auto crossed = static_cast<std::size_t>(textile.weft.count);
        const std::vector<double> lengths(2 * static_cast<std::size_t>(textile.warp.count) * crossed, 1.0);
        std::set<double> middles; // of each warp yarn
        std::size_t yarns = 0;
        for (std::uint64_t seed = 1; seed <= 6; ++seed) {
            const std::vector<double> pores = uneven_pores(textile, lengths, seed);
            for (std::size_t yarn = 0; yarn < static_cast<std::size_t>(textile.warp.count); ++yarn, ++yarns)
                middles.insert(pores[yarn * crossed + crossed / 2]);
        }
        QVERIFY2(middles.size() > yarns * 9 / 10, qPrintable(QString::number(middles.size()))); // some lie at the limits
    }
    void partsThatDoNotFitAreRefused()
    {
        struct Fault {
            void (*make)(Scene&);
            const char* said;
        };
        const Fault faults[] = {
            {[](Scene& s) { s.cloth.length.pop_back(); }, "length for each segment"},
            {[](Scene& s) { s.cloth.length[2] = 0; }, "has no length"},
            {[](Scene& s) { s.cloth.type[0] = 7; }, "does not exist"},
            {[](Scene& s) { s.cloth.crossing.clear(); }, "crosses each type"},
            {[](Scene& s) { s.cloth.start.liquid = {1e-9}; }, "begin with liquid"},
            {[](Scene& s) { s.climate.density = 0; }, "density of the liquid"},
            {[](Scene& s) {
                 s.climate.course = {{0, 0, 0.5, 9, 0.01}, {10, 0, 0.6, 9, 0.01}, {5, 0, 0.7, 9, 0.01}};
             },
             "order of time"},
            {[](Scene& s) {
                 s.supply.pools = {{2, 1, 1e-9, true}};
             },
             "ends before it begins"},
            {[](Scene& s) {
                 s.supply.droplets = {{0, 1e-9, {}, 0}};
             },
             "no particles"},
            {[](Scene& s) { s.supply.fed = {1}; }, "hangs in liquid"},
            {[](Scene& s) { s.liquid.places = {{}}; }, "velocity for each place"},
            {[](Scene& s) { s.rules.network_step = 0; }, "no step"},
            {[](Scene& s) { s.rules.fibre_shells = 1000; }, "too many shells"},
        };
        for (const Fault& fault : faults) {
            Scene scene = bare_scene(3, 4, 1e-3, 293.15);
            fault.make(scene);
            QVERIFY2(complaint(scene).find(fault.said) != std::string::npos, fault.said);
        }
    }
};

QTEST_APPLESS_MAIN(TestSceneParts)
#include "tst_scene_parts.moc"
