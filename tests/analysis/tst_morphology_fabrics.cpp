// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The closure against the drawn pores of fabrics of several weaves: a table, and that no miss exceeds what is listed.
#include "core/base/units.h"
#include "core/physics/water.h"
#include "core/verify/drawn_pores.h"
#include "core/verify/pore_set_ups.h"
#include "core/verify/set_ups.h"
#include "core/verify/verify.h"

#include <QTest>

#include <array>
#include <cmath>
#include <cstdio>
#include <random>

using namespace hygroloom;

namespace {

using Changes = std::map<std::string, std::string>;

VerifyReport report_of(const std::string& fabric, Changes changes = {})
{
    changes["fabric"] = fabric;
    return run_verify_case("retention_by_morphology", changes, *make_cpu_backend());
}

/// Computed once, for all tests that ask.
const VerifyReport& usual_report_of(const std::string& fabric)
{
    static std::map<std::string, VerifyReport> all;
    const auto known = all.find(fabric);
    return known != all.end() ? known->second : all.emplace(fabric, report_of(fabric)).first->second;
}

const VerifyReport& coarse_report()
{
    static const VerifyReport report = report_of("Textile F", {{"fibre_voxel_um", "1"}, {"voxel_um", "10"}});
    return report;
}

bool whole_cases() { return qEnvironmentVariableIsSet("HYGROLOOM_WHOLE_CASES"); }

const VerifyResult& result(const VerifyReport& report, const std::string& name)
{
    for (const VerifyResult& r : report.results)
        if (r.name == name) return r;
    qFatal("There is no such result.");
}

/// Random parallel rods that do not overlap, 144 to a repeat and 16 voxels thick: shaken from a net until nothing of it is left.
PoreImage random_rods(double packing)
{
    constexpr int rods = 144, columns = 12;
    constexpr double radius = 16;
    const double side = std::sqrt(rods * pi * radius * radius / packing);
    std::vector<std::array<double, 2>> at;
    for (int i = 0; i < rods; ++i) at.push_back({(i % columns + 0.5 * (i / columns % 2)) * side / columns, i / columns * side / columns});
    const auto apart = [&](const std::array<double, 2>& a, const std::array<double, 2>& b) {
        const double x = a[0] - b[0], y = a[1] - b[1];
        return std::hypot(x - side * std::round(x / side), y - side * std::round(y / side));
    };
    std::mt19937 random(7);
    std::uniform_real_distribution<double> step(-0.4 * radius, 0.4 * radius);
    for (int sweep = 0; sweep < 1000; ++sweep)
        for (std::size_t i = 0; i < at.size(); ++i) {
            std::array<double, 2> moved{at[i][0] + step(random), at[i][1] + step(random)};
            for (double& c : moved) c -= side * std::floor(c / side);
            bool free = true;
            for (std::size_t j = 0; free && j < at.size(); ++j) free = j == i || apart(moved, at[j]) > 2 * radius;
            if (free) at[i] = moved;
        }
    const int n = static_cast<int>(std::lround(side));
    PoreImage image{{n, n, 1, true, true}, {}};
    image.voxels.assign(image.grid.size(), Voxel::pore);
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x)
            for (const auto& rod : at)
                if (apart({x + 0.5, y + 0.5}, rod) < radius) image.voxels[image.grid.at(x, y, 0)] = Voxel::solid;
    return image;
}

} // namespace

class TestMorphologyFabrics : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void missesStayWithinTheirBounds_data()
    {
        QTest::addColumn<QString>("fabric");
        QTest::newRow("Oxford") << "Oxford"; // tst_verify runs it of textile F
        if (!whole_cases()) return;
        for (const char* fabric : {"Textile F", "Wool serge", "Poplin shirting", "Drill", "Sports micro-twill", "Cotton sateen"})
            QTest::newRow(fabric) << fabric;
    }
    void missesStayWithinTheirBounds()
    {
        QFETCH(QString, fabric);
        const VerifyReport& report = usual_report_of(fabric.toStdString());
        QCOMPARE(report.results.size(), std::size_t(10));
        std::printf("%-20s", qPrintable(fabric));
        for (const VerifyResult& r : report.results)
            std::printf(" %s %.4g/%.4g=%.2f", r.name.c_str(), r.computed, r.expected, r.computed / r.expected);
        std::printf("\n");
        for (const VerifyResult& r : report.results) QVERIFY2(std::isfinite(r.expected), r.name.c_str());
        QVERIFY(report.as_expected());
    }
    void onItsOwnRandomRodsTheClosureFillsEarlierThanDiscs_data()
    {
        QTest::addColumn<double>("packing");
        for (double packing : {0.35, 0.5, 0.65}) QTest::addRow("packing %g", packing) << packing;
    }
    void onItsOwnRandomRodsTheClosureFillsEarlierThanDiscs()
    {
        // What the method itself adds to a miss: menisci that stand across a pore pull more than its largest disc.
        QFETCH(double, packing);
        const MorphologyCurves curves = morphology_curves(random_rods(packing), 40);
        const PoreClosure closure = pores_of_bundle(packing, 16, 1, 0, 0);
        const double half = imbibition_suction(closure, 0.5) * radius_at(curves.filling, 0.5),
                     entry = closure.entry_suction * fitted_to(curves.filling).entry_radius;
        std::printf("random rods, packing %g: entry %.2f, half %.2f of discs'\n", packing, entry, half);
        QVERIFY(half > 1.0 && half < 1.3);
        QVERIFY(entry > 1.2 && entry < 1.8);
    }
    void aRunGivesTheSameNumbersAgain()
    {
        const VerifyReport &once = coarse_report(), again = report_of("Textile F", {{"fibre_voxel_um", "1"}, {"voxel_um", "10"}});
        for (std::size_t i = 0; i < once.results.size(); ++i) QCOMPARE(once.results[i].expected, again.results[i].expected);
    }
    void halfTheVoxelChangesLittle()
    {
        const VerifyReport coarse = whole_cases() ? usual_report_of("Textile F") : coarse_report(),
                           fine = report_of("Textile F", {{"fibre_voxel_um", whole_cases() ? "0.25" : "0.5"}, {"voxel_um", "5"}});
        for (const char* name : {"warp_entry_pa", "warp_half_pa", "warp_hysteresis", "weft_entry_pa", "weft_half_pa", "weft_hysteresis",
                                 "between_share", "between_half_pa"}) {
            const double ratio = result(fine, name).expected / result(coarse, name).expected;
            QVERIFY2(std::abs(ratio - 1) < 0.12, qPrintable(QString("%1: %2").arg(name).arg(ratio)));
        }
    }
    void suctionsAreThoseOfCylindersInYarnsAndOfBallsBetweenThem()
    {
        const Fabric& fabric = library_fabric("Textile F");
        const Design design = design_of(fabric, standard_experiment(ExperimentType::horizontal_wicking));
        const Textile textile = build_textile(design, design.fabrics[0], {0, 0, fabric.weave.ends(), fabric.weave.picks()});
        const VerifyReport& report = coarse_report();
        const double tension = water_surface_tension(pore_temperature);
        const YarnType &warp = textile.warp.types[0], &weft = textile.weft.types[0];

        const std::vector<DrawnSection> sections = drawn_sections(textile, YarnKind::warp, 0, 4);
        const MorphologyCurves yarn =
            morphology_curves(image_of_sections(sections, metre_from_um(1), 2 * sections[0].fibres[0].radius), 24);
        const double half = tension * std::cos(warp.contact_angle) / (metre_from_um(1) * radius_at(yarn.filling, 0.5));
        QVERIFY(std::abs(result(report, "warp_half_pa").expected / half - 1) < 1e-9);
        const double fuller = radius_at(yarn.filling, 0.5) / radius_at(yarn.emptying, 0.5);
        const double dries = std::cos(warp.receding_angle) / std::cos(warp.contact_angle);
        QVERIFY(std::abs(result(report, "warp_hysteresis").expected / (fuller * dries) - 1) < 1e-9);

        const MorphologyCurves room = morphology_curves(image_of_room(textile, metre_from_um(10)), 24);
        const double wets =
            1 - 0.5 * (warp.packing * (1 - std::cos(warp.contact_angle)) + weft.packing * (1 - std::cos(weft.contact_angle)));
        const double between = 2 * tension * wets / (metre_from_um(10) * radius_at(room.filling, 0.5));
        QVERIFY(std::abs(result(report, "between_half_pa").expected / between - 1) < 1e-9);
    }
};

QTEST_APPLESS_MAIN(TestMorphologyFabrics)
#include "tst_morphology_fabrics.moc"
