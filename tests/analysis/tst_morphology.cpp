// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Distances and balls in voxels against brute force and against pores whose throats are known.
#include "core/base/error.h"
#include "core/base/units.h"
#include "core/project/library.h"
#include "core/verify/drawn_pores.h"
#include "core/verify/set_ups.h"
#include "core/verify/verify.h"

#include <QTest>

#include <algorithm>
#include <array>

#include <cmath>
#include <functional>
#include <random>

using namespace hygroloom;

namespace tst_morphology {
namespace {

bool near(double value, double expected, double share) { return std::abs(value - expected) <= share * std::abs(expected); }

/// As near as a grid can tell a radius.
bool within_a_voxel(double radius, double expected) { return std::abs(radius - expected) <= 1; }

/// A picture of what a function says of each voxel's middle.
PoreImage drawn(const VoxelGrid& grid, const std::function<Voxel(double, double, double)>& what)
{
    PoreImage image{grid, std::vector<Voxel>(grid.size())};
    for (int z = 0; z < grid.nz; ++z)
        for (int y = 0; y < grid.ny; ++y)
            for (int x = 0; x < grid.nx; ++x) image.voxels[grid.at(x, y, z)] = what(x + 0.5, y + 0.5, z + 0.5);
    return image;
}

/// Radius at which a curve falls steepest: that of pores which are all alike.
double steepest(const std::vector<MorphologyPoint>& curve)
{
    double most = 0, radius = 0;
    for (std::size_t i = 1; i < curve.size(); ++i) {
        const double fall = curve[i - 1].saturation - curve[i].saturation;
        if (fall > most) {
            most = fall;
            radius = std::sqrt(curve[i - 1].radius * curve[i].radius);
        }
    }
    return radius;
}

/// Parallel rods in air: rows of a square or hexagonal net. Pores lie between the rods' middles.
PoreImage rods(bool hexagonal, int a_side, double radius, double spacing)
{
    const double rise = hexagonal ? spacing * std::sqrt(0.75) : spacing, margin = 2.5 * spacing;
    const int nx = static_cast<int>(std::ceil((a_side - 0.5) * spacing + 2 * margin)),
              ny = static_cast<int>(std::ceil((a_side - 1) * rise + 2 * margin));
    return drawn({nx, ny, 1, false, true}, [=](double x, double y, double) {
        for (int row = 0; row < a_side; ++row)
            for (int i = 0; i < a_side; ++i)
                if (std::hypot(x - margin - (i + (hexagonal && row % 2 == 1 ? 0.5 : 0)) * spacing, y - margin - row * rise) < radius)
                    return Voxel::solid;
        const double left = margin + (hexagonal ? 0.5 * spacing : 0), right = margin + (a_side - 1) * spacing;
        const bool between = x > left && x < right && y > margin && y < margin + (a_side - 1) * rise;
        return between ? Voxel::pore : Voxel::outside;
    });
}

} // namespace

class TestMorphology : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void distancesAreThoseOfBruteForce_data()
    {
        QTest::addColumn<bool>("repeats");
        QTest::addColumn<bool>("sections");
        QTest::addColumn<int>("marks");
        for (bool repeats : {false, true})
            for (bool sections : {false, true})
                for (int marks : {0, 1, 3, 60})
                    QTest::addRow("%d marks, repeats %d, sections %d", marks, repeats, sections) << repeats << sections << marks;
    }
    void distancesAreThoseOfBruteForce()
    {
        QFETCH(bool, repeats);
        QFETCH(bool, sections);
        QFETCH(int, marks);
        const VoxelGrid g{13, 10, 7, repeats, sections};
        std::mt19937 random(5);
        std::vector<std::uint8_t> marked(g.size(), 0);
        for (int i = 0; i < marks; ++i) marked[random() % g.size()] = 1;
        const std::vector<int> squared = squared_distances(g, marked);
        const auto off = [&](int a, int b, int n) {
            const int d = std::abs(a - b);
            return repeats ? std::min(d, n - d) : d;
        };
        for (std::size_t i = 0; i < g.size(); ++i) {
            const auto at = [&](std::size_t k) {
                const int n = static_cast<int>(k);
                return std::array{n % g.nx, n / g.nx % g.ny, n / (g.nx * g.ny)};
            };
            int least = nothing_near;
            for (std::size_t j = 0; j < g.size(); ++j) {
                const auto a = at(i), b = at(j);
                if (!marked[j] || (sections && a[2] != b[2])) continue;
                const int x = off(a[0], b[0], g.nx), y = off(a[1], b[1], g.ny), z = a[2] - b[2];
                least = std::min(least, x * x + y * y + z * z);
            }
            QCOMPARE(squared[i], least);
        }
    }
    void waysInAreThoseOfAFlood()
    {
        const VoxelGrid g{17, 15, 9, false, false};
        std::mt19937 random(9);
        PoreImage image{g, std::vector<Voxel>(g.size(), Voxel::pore)};
        std::vector<std::uint8_t> solid(g.size(), 0);
        for (std::size_t i = 0; i < g.size(); ++i) {
            const std::size_t z = i / 255;
            if (z == 0) image.voxels[i] = Voxel::outside;
            if (z > 0 && random() % 25 == 0) image.voxels[i] = Voxel::solid;
            solid[i] = image.voxels[i] == Voxel::solid;
        }
        const std::vector<int> fits = squared_distances(g, solid), ways = squared_ways_in(image, fits);
        for (int level : {1, 2, 3, 4, 5, 6, 8, 9, 10, 13}) { // those who are reached through voxels that allow it
            std::vector<std::uint8_t> reached(g.size(), 0);
            std::vector<std::size_t> waiting;
            for (std::size_t i = 0; i < 255; ++i)
                if (image.voxels[i] == Voxel::outside && fits[i] >= level) {
                    reached[i] = 1;
                    waiting.push_back(i);
                }
            while (!waiting.empty()) {
                const std::size_t i = waiting.back();
                waiting.pop_back();
                const int x = static_cast<int>(i % 17), y = static_cast<int>(i / 17 % 15), z = static_cast<int>(i / 255);
                for (const auto& [dx, dy, dz] : {std::array{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}) {
                    if (x + dx < 0 || x + dx > 16 || y + dy < 0 || y + dy > 14 || z + dz < 0 || z + dz > 8) continue;
                    const std::size_t next = g.at(x + dx, y + dy, z + dz);
                    if (reached[next] || fits[next] < level) continue;
                    reached[next] = 1;
                    waiting.push_back(next);
                }
            }
            for (std::size_t i = 0; i < g.size(); ++i) QCOMPARE(ways[i] >= level, reached[i] == 1);
        }
    }
    void aRoundHoleFillsAndEmptiesAtItsRadius()
    {
        // Through a plate, open on both faces.
        constexpr double radius = 11.0;
        const PoreImage image = drawn({40, 40, 90, true, false}, [](double x, double y, double z) {
            if (z < 30 || z > 60) return Voxel::outside;
            return std::hypot(x - 20, y - 20) < radius ? Voxel::pore : Voxel::solid;
        });
        const MorphologyCurves curves = morphology_curves(image, 60);
        QVERIFY(near(curves.pores, 3.14159265 * radius * radius * 30, 0.02));
        QVERIFY2(within_a_voxel(steepest(curves.filling), radius), qPrintable(QString::number(steepest(curves.filling))));
        QVERIFY2(within_a_voxel(steepest(curves.emptying), radius), qPrintable(QString::number(steepest(curves.emptying))));
    }
    void aBottleFillsAtItsBellyAndEmptiesAtItsNeck()
    {
        constexpr double neck = 5, belly = 14; // radii; the only way in is the neck
        const PoreImage image = drawn({40, 40, 74, true, false}, [](double x, double y, double z) {
            if (z < 24) return Voxel::outside;
            const double off = std::hypot(x - 20.5, y - 20.5);
            return (z < 34 ? off < neck : std::hypot(off, z - 50.5) < belly || (z < 40 && off < neck)) ? Voxel::pore : Voxel::solid;
        });
        const MorphologyCurves curves = morphology_curves(image, 60);
        QVERIFY2(within_a_voxel(steepest(curves.filling), belly), qPrintable(QString::number(steepest(curves.filling))));
        QVERIFY2(within_a_voxel(steepest(curves.emptying), neck), qPrintable(QString::number(steepest(curves.emptying))));
    }
    void rodsFillAtTheInscribedDiscAndEmptyAtTheThroat_data()
    {
        QTest::addColumn<bool>("hexagonal");
        QTest::addColumn<double>("spacing"); // over the radius
        for (bool hexagonal : {false, true})
            for (double spacing : {2.5, 3.0}) QTest::addRow("%s, %g", hexagonal ? "hexagonal" : "square", spacing) << hexagonal << spacing;
    }
    void rodsFillAtTheInscribedDiscAndEmptyAtTheThroat()
    {
        QFETCH(bool, hexagonal);
        QFETCH(double, spacing);
        constexpr double radius = 24;
        const MorphologyCurves curves = morphology_curves(rods(hexagonal, 5, radius, spacing * radius), 90);
        const double inscribed = radius * (spacing / (hexagonal ? std::sqrt(3.0) : std::sqrt(2.0)) - 1),
                     throat = radius * (0.5 * spacing - 1);
        QVERIFY2(within_a_voxel(steepest(curves.filling), inscribed), qPrintable(QString::number(steepest(curves.filling) - inscribed)));
        QVERIFY2(within_a_voxel(steepest(curves.emptying), throat), qPrintable(QString::number(steepest(curves.emptying) - throat)));
    }
    void curvesFallAndAirThatComesInIsAirThatFits()
    {
        const MorphologyCurves curves = morphology_curves(rods(true, 5, 12, 32), 40);
        QCOMPARE(curves.filling.size(), curves.emptying.size());
        QVERIFY(curves.filling.size() > 5);
        for (std::size_t i = 0; i < curves.filling.size(); ++i) {
            QVERIFY(curves.emptying[i].saturation >= curves.filling[i].saturation);
            if (i > 0) QVERIFY(curves.filling[i].saturation <= curves.filling[i - 1].saturation);
            if (i > 0) QVERIFY(curves.emptying[i].saturation <= curves.emptying[i - 1].saturation);
        }
    }
    void liquidHangsTogetherOnlyIfItMeetsItselfARepeatOn()
    {
        // A groove as wide as a ball's room, along x or closed by a wall.
        for (bool closed : {false, true}) {
            const PoreImage image = drawn({40, 40, 40, true, false}, [=](double x, double y, double z) {
                if (z > 30) return Voxel::outside;
                const bool groove = z > 10 && std::abs(y - 20) < 8 && !(closed && x < 4);
                return groove ? Voxel::pore : Voxel::solid;
            });
            const MorphologyCurves curves = morphology_curves(image, 30);
            QVERIFY(curves.filling.front().saturation > 0.3);
            QCOMPARE(curves.filling.front().spans, !closed);
        }
    }
    void aPowerLawIsReadBack()
    {
        std::vector<MorphologyPoint> curve;
        for (double r = 30; r > 1; r /= 1.2) curve.push_back({r, std::min(1.0, std::pow(r / 20, 2.5)), false});
        const BrooksCorey fitted = fitted_to(curve);
        QVERIFY(near(fitted.entry_radius, 20, 1e-9));
        QVERIFY(near(fitted.shape, 2.5, 1e-9));
        QVERIFY(near(radius_at(curve, 0.5), 20 * std::pow(0.5, 0.4), 0.01));
        QVERIFY(std::isnan(radius_at(curve, 1e-6)));
        QVERIFY(std::isnan(fitted_to({{2, 0.7, false}, {1, 0.4, false}}).shape));
    }
    void theDrawnLayerHasTheYarnsVolume()
    {
        // Against sections summed along the drawn centrelines.
        const Fabric& fabric = library_fabric("Poplin shirting");
        const Design design = design_of(fabric, standard_experiment(ExperimentType::horizontal_wicking));
        const Textile textile = build_textile(design, design.fabrics[0], {0, 0, 2, 2});
        double yarns = 0;
        for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
            for (int yarn = 0; yarn < 2; ++yarn)
                for (int step = 0; step < 400; ++step) {
                    const auto at = [&](double s) {
                        return yarn_point(textile, kind, yarn, s < 200 ? 0 : 1, s / 200 - (s < 200 ? 0.5 : 1.5));
                    };
                    const YarnPoint a = at(step + 0.001), b = at(step + 0.999), middle = at(step + 0.5);
                    const double h = middle.half_height;
                    yarns += length(b.centre - a.centre) / 0.998 * (3.14159265 * h * h + 4 * h * (middle.half_width - h));
                }
        const double layer = 4 * textile.warp.pitch * textile.weft.pitch * textile.thickness, voxel = 4e-6;
        const PoreImage image = image_of_room(textile, voxel);
        double pores = 0;
        for (Voxel v : image.voxels) pores += v == Voxel::pore ? 1 : 0;
        pores *= 4 * textile.warp.pitch * textile.weft.pitch / (image.grid.nx * image.grid.ny) * voxel;
        QVERIFY2(near(layer - pores, yarns, 0.03), qPrintable(QString("%1 %2").arg((layer - pores) / layer).arg(yarns / layer)));
    }
    void theDrawnLayerIsAsEmptyAsItsVolumesSay()
    {
        for (const Preset& preset : shipped_presets()) {
            const Fabric& fabric = preset.fabric();
            const TextileRegion region{0, 0, std::max(2, fabric.weave.ends()), std::max(2, fabric.weave.picks())};
            const Textile t = build_textile({}, fabric, region);
            double yarns = 0;
            for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
                for (int end = 0; end < t.ends(); ++end)
                    for (int pick = 0; pick < t.picks(); ++pick)
                        yarns += t.type(kind, kind == YarnKind::warp ? end : pick).area * t.segment_length(kind, end, pick);
            const double by_volume = 1 - yarns / (t.ends() * t.warp.pitch * t.picks() * t.weft.pitch * t.thickness);
            const double voxel = std::min({t.thickness, t.warp.pitch, t.weft.pitch}) / 60;
            const PoreImage image = image_of_room(t, voxel);
            const double pores = static_cast<double>(std::count(image.voxels.begin(), image.voxels.end(), Voxel::pore));
            int layers = 0;
            for (int z = 0; z < image.grid.nz; ++z) layers += std::abs(z + 0.5 - 0.5 * image.grid.nz) * voxel < 0.5 * t.thickness;
            const double drawn = pores / (double(image.grid.nx) * image.grid.ny * layers);
            // Known misses: more fibre than racetracks packed to 0.85 hold in the given thickness.
            const double bound = fabric.name == "Textile A" ? 0.05 : fabric.name == "Textile D" ? 0.12 : 0.0125;
            QVERIFY2(std::abs(drawn - by_volume) < bound,
                     qPrintable(QString("%1: %2 %3").arg(fabric.name.c_str()).arg(drawn).arg(by_volume)));
        }
    }
    void sectionsHoldAsMuchFibreAsThePackingSays()
    {
        const Fabric& fabric = library_fabric("Textile F");
        const Design design = design_of(fabric, standard_experiment(ExperimentType::horizontal_wicking));
        const Textile textile = build_textile(design, design.fabrics[0], {0, 0, 2, 2});
        for (const DrawnSection& s : drawn_sections(textile, YarnKind::weft, 0, 3)) {
            double fibre = 0;
            for (const FibreCut& f : s.fibres) {
                fibre += 3.14159265 * f.radius * f.radius;
                QVERIFY(std::hypot(f.x, f.y) < s.half_width);
                QVERIFY(f.radius > 0.95 * metre_from_um(textile.weft.types[0].fibre.fibre_radius_um)); // oblique ones are larger
            }
            const double outline = 3.14159265 * s.half_height * s.half_height + 4 * s.half_height * (s.half_width - s.half_height);
            QVERIFY2(near(fibre / outline, textile.weft.types[0].packing * textile.weft.types[0].area / outline, 0.08),
                     qPrintable(QString::number(fibre / outline)));
        }
    }
    void tooFineAndTooCoarseVoxelsAreRefusedWithASentence_data()
    {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("value");
        QTest::newRow("room, fine") << "voxel_um"
                                    << "1";
        QTest::newRow("room, beyond numbers") << "voxel_um"
                                              << "1e-12";
        QTest::newRow("fibres, beyond numbers") << "fibre_voxel_um"
                                                << "1e-12";
        QTest::newRow("room, coarse") << "voxel_um"
                                      << "90";
        QTest::newRow("fibres, fine") << "fibre_voxel_um"
                                      << "0.05";
        QTest::newRow("fibres, coarse") << "fibre_voxel_um"
                                        << "4";
    }
    void tooFineAndTooCoarseVoxelsAreRefusedWithASentence()
    {
        QFETCH(QString, key);
        QFETCH(QString, value);
        const auto backend = make_cpu_backend();
        try {
            run_verify_case("retention_by_morphology", {{"fabric", "Textile F"}, {key.toStdString(), value.toStdString()}}, *backend);
            QFAIL("This was not refused.");
        } catch (const Error& error) {
            const QString sentence = error.what();
            QVERIFY2(sentence.startsWith(key + ": must be a number from ") && sentence.endsWith("; " + value + " was given."),
                     error.what());
        }
    }
};

} // namespace tst_morphology

QTEST_APPLESS_MAIN(tst_morphology::TestMorphology)
#include "tst_morphology.moc"
