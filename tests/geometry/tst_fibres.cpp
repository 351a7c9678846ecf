// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/base/error.h"
#include "core/base/units.h"
#include "core/geometry/mesh_stream.h"
#include "core/project/project_file.h"

#include <QTest>

#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace hygroloom;

namespace {

Design textile_f() { return read_project(HYGROLOOM_SOURCE_DIR "/resources/examples/textile-F.hygro"); }

std::vector<Vec3d> curve_of(const YarnFibres& fibres, int strand)
{
    std::vector<float> flat(3 * fibres.points(strand));
    fibres.curve(strand, flat.data());
    std::vector<Vec3d> points;
    for (std::size_t i = 0; i < flat.size(); i += 3)
        points.push_back({static_cast<double>(flat[i]), static_cast<double>(flat[i + 1]), static_cast<double>(flat[i + 2])});
    return points;
}

double length_of(const std::vector<Vec3d>& line)
{
    double sum = 0;
    for (std::size_t i = 1; i < line.size(); ++i) sum += length(line[i] - line[i - 1]);
    return sum;
}

/// A straight yarn: weft that never interlaces has no crimp, a round section far from its neighbours.
Design straight_weft(double twist, int plies = 1)
{
    Design design = textile_f();
    Fabric& fabric = design.fabrics[0];
    fabric.flyaway = {};
    fabric.thickness_mm.reset();
    fabric.weave = Weave(2, 2, {1, 1, 0, 0}); // picks always below or always above
    fabric.ends_per_cm = fabric.picks_per_cm = 10;
    fabric.weft.twist_per_m = twist;
    fabric.weft.plies = plies;
    fabric.weft.fibres_per_yarn = 60;
    return design;
}

Textile part(const Design& design, const TextileRegion& region) { return build_textile(design, design.fabrics[0], region); }

const FibreOptions fine{16, 6, true, true, 7};

} // namespace

class TestFibres : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aFibreIsTheSameWhateverRegionIsMade()
    {
        const Design design = textile_f();
        const Textile whole = part(design, {0, 0, 30, 30}), piece = part(design, {10, 12, 8, 6});
        const Vec3d offset{whole.x_of_end(10) - piece.x_of_end(0), whole.y_of_pick(12) - piece.y_of_pick(0), 0};
        const YarnFibres a(whole, fine, YarnKind::warp, 13, 12, 6), b(piece, fine, YarnKind::warp, 3, 0, 6);
        QCOMPARE(a.strands(), b.strands());
        QVERIFY(a.strands() > a.regular());
        double worst = 0;
        for (int strand = 0; strand < a.strands(); ++strand) {
            const auto p = curve_of(a, strand), q = curve_of(b, strand);
            for (std::size_t i = 0; i < p.size(); ++i) worst = std::max(worst, length(p[i] - q[i] - offset));
        }
        QVERIFY2(worst < 2e-8, qPrintable(QString::number(worst))); // 0.02 um: single precision over a centimetre
    }
    void stretchesMeetInTheSamePoints()
    {
        const Design design = textile_f();
        const Textile textile = part(design, {0, 0, 12, 12});
        const YarnFibres whole(textile, fine, YarnKind::weft, 4, 0, 12), left(textile, fine, YarnKind::weft, 4, 0, 5),
            right(textile, fine, YarnKind::weft, 4, 5, 7);
        QCOMPARE(left.strands() - left.regular() + right.strands() - right.regular(), whole.strands() - whole.regular());
        for (int strand = 0; strand < whole.regular(); ++strand) {
            const auto a = curve_of(left, strand), b = curve_of(right, strand), all = curve_of(whole, strand);
            QVERIFY(length(a.back() - b.front()) == 0);
            QVERIFY(length(all[a.size() - 1] - a.back()) == 0);
        }
        // Normals at the seam, too: the last ring of the left tube and the first of the right one.
        const auto sides = static_cast<std::size_t>(fine.sides);
        YarnMesh l, r;
        for (auto [fibres, mesh] : {std::pair(&left, &l), std::pair(&right, &r)}) {
            mesh->positions.resize(3 * fibres->vertices(0));
            mesh->normals.resize(3 * fibres->vertices(0));
            mesh->uvs.resize(2 * fibres->vertices(0));
            mesh->segment_of_vertex.resize(fibres->vertices(0));
            mesh->indices.resize(3 * fibres->triangles(0));
            fibres->tube(0, *mesh, 0, 0);
        }
        for (std::size_t i = 0; i < 3 * sides; ++i) {
            QVERIFY(std::abs(l.normals[l.normals.size() - 3 * sides + i] - r.normals[i]) < 1e-6f);
            QVERIFY(std::abs(l.positions[l.positions.size() - 3 * sides + i] - r.positions[i]) < 1e-9f);
        }
    }
    void anotherSeedMakesOtherFibres()
    {
        const Design design = textile_f();
        const Textile textile = part(design, {0, 0, 6, 6});
        FibreOptions other = fine;
        other.seed = 8;
        QVERIFY(length(curve_of(YarnFibres(textile, fine, YarnKind::warp, 2, 0, 6), 0)[5] -
                       curve_of(YarnFibres(textile, other, YarnKind::warp, 2, 0, 6), 0)[5]) > 1e-6);
    }
    void fibresTogetherHaveTheYarnsFibreVolume_data()
    {
        QTest::addColumn<double>("twist");
        QTest::addColumn<int>("plies");
        QTest::newRow("untwisted") << 0.0 << 1;
        QTest::newRow("twisted") << 800.0 << 1;
        QTest::newRow("hard") << 2000.0 << 1;
        QTest::newRow("two plies") << 800.0 << 2;
        QTest::newRow("five plies") << 800.0 << 5;
        QTest::newRow("round a core") << 800.0 << 1;
        QTest::newRow("two plies, each round a core") << 800.0 << 2;
    }
    void fibresTogetherHaveTheYarnsFibreVolume()
    {
        QFETCH(double, twist);
        QFETCH(int, plies);
        Design design = straight_weft(twist, plies);
        const bool core = QString(QTest::currentDataTag()).contains("core");
        if (core) design.fabrics[0].weft.core = YarnCore{"elastane", 0.1};
        const Textile textile = part(design, {0, 0, 60, 4});
        const YarnType& type = textile.weft.types[0];
        const YarnFibres fibres(textile, fine, YarnKind::weft, 1, 0, 60);
        QCOMPARE(fibres.regular(), type.fibres + (core ? plies : 0));
        double volume = 0;
        for (int strand = 0; strand < fibres.regular(); ++strand)
            volume += length_of(curve_of(fibres, strand)) * pi * fibres.radius(strand) * fibres.radius(strand);
        const double expected = type.area * type.packing * 60 * textile.warp.pitch;
        QVERIFY2(std::abs(volume / expected - 1) < 0.02, qPrintable(QString::number(volume / expected)));
    }
    void theCoreLiesInTheMiddleAndTheFibresRoundIt()
    {
        Design design = straight_weft(800);
        design.fabrics[0].weft.core = YarnCore{"elastane", 0.1};
        const Textile textile = part(design, {0, 0, 60, 4});
        const YarnType& type = textile.weft.types[0];
        const YarnFibres fibres(textile, fine, YarnKind::weft, 1, 0, 60);
        const int core = fibres.regular() - 1;
        QVERIFY(fibres.is_core(core) && !fibres.is_core(core - 1) && !fibres.is_hair(core));
        QVERIFY(std::abs(pi * fibres.radius(core) * fibres.radius(core) - type.core_area()) < 1e-6 * type.core_area());
        const auto from_axis = [&](const Vec3d& p) {
            return std::hypot(p.y - textile.y_of_pick(1), p.z - textile.height_at_crossing(YarnKind::weft, 1, 1));
        };
        for (const Vec3d& p : curve_of(fibres, core)) QVERIFY(from_axis(p) < 1e-9);
        for (int strand = 0; strand < core; ++strand)
            for (const Vec3d& p : curve_of(fibres, strand)) QVERIFY(from_axis(p) > 0.85 * fibres.radius(core));
    }
    void packingFallsFromTheMiddleOutwards()
    {
        // Packing 0.5 leaves the core 1.5 times as dense as the mean: within half the radius lie 1.5/4 - 0.5/16 of the fibres.
        const Textile textile = part(straight_weft(800), {0, 0, 60, 4});
        const YarnFibres fibres(textile, fine, YarnKind::weft, 1, 0, 60);
        const double radius = 0.5 * textile.weft.types[0].section.width - fibres.radius(0); // what middles reach
        double inside = 0, all = 0;
        for (int strand = 0; strand < fibres.regular(); ++strand)
            for (const Vec3d& p : curve_of(fibres, strand)) {
                const double r = std::hypot(p.y - textile.y_of_pick(1), p.z - textile.height_at_crossing(YarnKind::weft, 1, 1));
                QVERIFY(r <= radius * 1.001);
                inside += r < 0.5 * radius;
                ++all;
            }
        QVERIFY2(std::abs(inside / all - (1.5 / 4 - 0.5 / 16)) < 0.02, qPrintable(QString::number(inside / all)));
    }
    void fibresTravelBetweenAxisAndSurface()
    {
        const Textile textile = part(straight_weft(800), {0, 0, 60, 4});
        const YarnFibres fibres(textile, fine, YarnKind::weft, 1, 0, 60);
        const double radius = 0.5 * textile.weft.types[0].section.width;
        for (int strand : {0, 7, 30}) {
            double least = 1, most = 0;
            for (const Vec3d& p : curve_of(fibres, strand)) {
                const double r = std::hypot(p.y - textile.y_of_pick(1), p.z - textile.height_at_crossing(YarnKind::weft, 1, 1));
                least = std::min(least, r / radius);
                most = std::max(most, r / radius);
            }
            QVERIFY(least < 0.2 && most > 0.8);
        }
    }
    void zTwistIsARightHandedScrew()
    {
        for (double twist : {500.0, 1500.0})
            for (TwistDirection direction : {TwistDirection::z, TwistDirection::s}) {
                Design design = straight_weft(twist);
                design.fabrics[0].weft.twist_direction = direction;
                const Textile textile = part(design, {0, 0, 40, 4});
                const YarnFibres fibres(textile, fine, YarnKind::weft, 1, 0, 40);
                const double y = textile.y_of_pick(1), z = textile.height_at_crossing(YarnKind::weft, 1, 1);
                double turned = 0, along = 0; // about +x, from y to z: right-handed
                const auto line = curve_of(fibres, 3);
                for (std::size_t i = 1; i < line.size(); ++i) {
                    const Vec3d a = line[i - 1], b = line[i];
                    turned += std::atan2((a.y - y) * (b.z - z) - (a.z - z) * (b.y - y), (a.y - y) * (b.y - y) + (a.z - z) * (b.z - z));
                    along += b.x - a.x;
                }
                const double expected = (direction == TwistDirection::z ? 1 : -1) * twist;
                QVERIFY2(std::abs(turned / (2 * pi) / along / expected - 1) < 0.01, qPrintable(QString::number(turned / (2 * pi) / along)));
            }
    }
    void pliesStayInTheirOwnCircles()
    {
        Design design = straight_weft(800, 2);
        const Textile textile = part(design, {0, 0, 40, 4});
        const YarnFibres fibres(textile, fine, YarnKind::weft, 1, 0, 40);
        const double radius = 0.5 * textile.weft.types[0].section.width;
        const auto first = curve_of(fibres, 0), second = curve_of(fibres, 1); // plies take turns
        const double y = textile.y_of_pick(1), z = textile.height_at_crossing(YarnKind::weft, 1, 1);
        for (std::size_t i = 0; i < first.size(); ++i) {
            const double phase = 2 * pi * -400 * ((first[i].x - textile.x_of_end(0)) + 0.5 * textile.warp.pitch);
            // Angle from up towards across, which is -y for a weft.
            const Vec3d middle{0, -0.5 * radius * std::sin(phase), 0.5 * radius * std::cos(phase)};
            QVERIFY(std::hypot(first[i].y - y - middle.y, first[i].z - z - middle.z) <= 0.5 * radius);
            QVERIFY(std::hypot(second[i].y - y + middle.y, second[i].z - z + middle.z) <= 0.5 * radius);
        }
    }
    void loopsAndHairsHaveTheLengthThatIsCounted()
    {
        for (const char* weave : {"plain", "satin 5/2"}) {
            Design design = textile_f();
            design.fabrics[0].weave = weave_from_pattern(weave);
            design.fabrics[0].ends_per_cm = design.fabrics[0].picks_per_cm = 20; // round yarns
            design.fabrics[0].flyaway = {3, 10, 0.1, 0.4};
            const Textile textile = part(design, {0, 0, 40, 200});
            double loops = 0, hairs = 0, yarn = 0;
            for (int end = 0; end < 40; ++end) {
                const YarnFibres fibres(textile, {24, 6, true, true, 1}, YarnKind::warp, end, 0, 200);
                for (int strand = 0; strand < fibres.strands(); ++strand)
                    (fibres.is_hair(strand) ? hairs : loops) +=
                        fibres.is_hair(strand) ? length_of(curve_of(fibres, strand)) : fibres.loop_length(strand);
                for (int pick = 0; pick < 200; ++pick) yarn += textile.segment_length(YarnKind::warp, end, pick);
            }
            const FlyawayLength expected = flyaway_length(textile, textile.warp.types[0]);
            QVERIFY2(std::abs(hairs / yarn / expected.hairs - 1) < 0.02, qPrintable(QString::number(hairs / yarn / expected.hairs)));
            QVERIFY2(std::abs(loops / yarn / expected.loops - 1) < 0.02, qPrintable(QString::number(loops / yarn / expected.loops)));
        }
    }
    void flyawaysRiseAsHighAsTheyAreSaidTo()
    {
        Design design = textile_f();
        design.fabrics[0].flyaway = {6, 0, 0.1, 0};
        const Textile textile = part(design, {0, 0, 20, 20});
        double highest = 0;
        const YarnMesh mesh = mesh_fibres(textile, {0, 0, 20, 20}, {});
        for (std::size_t i = 2; i < mesh.positions.size(); i += 3)
            highest = std::max(highest, std::abs(static_cast<double>(mesh.positions[i])));
        const double limit = textile.half_thickness() + 0.1e-3;
        QVERIFY2(highest > limit - 0.03e-3 && highest < limit + 2 * drawn_fibre_radius(textile.warp.types[0]),
                 qPrintable(QString::number(highest / limit)));
    }
    void tubesAreClosedAndFaceOutwards()
    {
        const Design design = textile_f();
        const Textile textile = part(design, {0, 0, 3, 3});
        const YarnMesh mesh = mesh_fibres(textile, {0, 0, 3, 3}, {});
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
        double volume = 0;
        const auto at = [&](std::uint32_t v) {
            return Vec3d{static_cast<double>(mesh.positions[3 * v]), static_cast<double>(mesh.positions[3 * v + 1]),
                         static_cast<double>(mesh.positions[3 * v + 2])};
        };
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            for (std::size_t c = 0; c < 3; ++c) ++edges[{mesh.indices[i + c], mesh.indices[i + (c + 1) % 3]}];
            volume += dot(at(mesh.indices[i]), cross(at(mesh.indices[i + 1]), at(mesh.indices[i + 2]))) / 6;
        }
        for (const auto& [edge, count] : edges) {
            QCOMPARE(count, 1);
            QVERIFY(edges.count({edge.second, edge.first}) == 1);
        }
        QVERIFY(volume > 0);
        for (float value : mesh.positions) QVERIFY(std::isfinite(value));
        for (float value : mesh.normals) QVERIFY(std::isfinite(value));
    }
    void streamIsAsLargeAsItSaysAndTheSameAsAWindow_data()
    {
        QTest::addColumn<bool>("cored");
        QTest::newRow("fibres alone") << false;
        QTest::newRow("two plies round cores") << true;
    }
    void streamIsAsLargeAsItSaysAndTheSameAsAWindow()
    {
        QFETCH(bool, cored);
        Design design = textile_f();
        if (cored) {
            design.fabrics[0].weft.plies = 2;
            design.fabrics[0].weft.core = YarnCore{"elastane", 0.1};
        }
        const Textile textile = part(design, {3, 5, 12, 14});
        for (const auto& [detail, capped] :
             {std::pair(MeshDetail::yarn, true), {MeshDetail::yarn, false}, {MeshDetail::fibre, true}, {MeshDetail::fibre, false}}) {
            const MeshRequest request{detail, 8, 6, true, capped, 1};
            const MeshSize size = stream_size(textile, request);
            std::size_t vertices = 0, triangles = 0;
            std::vector<float> positions;
            QVERIFY(stream_mesh(textile, request, [&](const YarnMesh& piece) {
                vertices += piece.segment_of_vertex.size();
                triangles += piece.indices.size() / 3;
                positions.insert(positions.end(), piece.positions.begin(), piece.positions.end());
                return piece.groups.size() == 1;
            }));
            QCOMPARE(vertices, size.vertices);
            QCOMPARE(triangles, size.triangles);
            if (detail == MeshDetail::fibre) QVERIFY(positions == mesh_fibres(textile, {0, 0, 12, 14}, request.fibres()).positions);
        }
    }
    void streamStopsWhenAsked()
    {
        const Design design = textile_f();
        const Textile textile = part(design, {0, 0, 50, 50});
        int pieces = 0;
        QVERIFY(!stream_mesh(textile, {MeshDetail::fibre, 8, 6, true, true, 1}, [&](const YarnMesh&) { return ++pieces < 3; }));
        QCOMPARE(pieces, 3);
    }
    void aStreamThatFailsLeavesNoMemory()
    {
        const Design design = textile_f();
        const Textile textile = part(design, {0, 0, 50, 50});
        const auto fail = [&] {
            int pieces = 0;
            const auto take = [&](const YarnMesh&) -> bool {
                if (++pieces == 3) throw Error("The disk is full.");
                return true;
            };
            QVERIFY_EXCEPTION_THROWN(stream_mesh(textile, {MeshDetail::fibre, 8, 6, true, true, 1}, take), Error);
            QCOMPARE(pieces, 3);
        };
        fail(); // what the library keeps
        const std::size_t before = mallinfo2().uordblks;
        for (int k = 0; k < 10; ++k) fail();
        const std::size_t more = mallinfo2().uordblks - std::min(mallinfo2().uordblks, before);
        // One yarn's fibres take 98 304 bytes for their hairs alone. With AddressSanitizer LeakSanitizer looks.
        QVERIFY2(more < 90'000, qPrintable(QString("%1 bytes").arg(more)));
    }
    void extremesStayFinite()
    {
        for (int fibres : {1, 2, 500})
            for (double twist : {0.0, 5000.0}) {
                Design design = textile_f();
                Fabric& fabric = design.fabrics[0];
                fabric.warp.fibres_per_yarn = fabric.weft.fibres_per_yarn = fibres;
                fabric.warp.plies = fibres > 6 ? 6 : 1;
                fabric.warp.twist_per_m = fabric.warp.ply_twist_per_m = twist;
                fabric.flyaway = {50, 50, 0.2, 2};
                const YarnMesh mesh = mesh_fibres(part(design, {0, 0, 2, 2}), {0, 0, 2, 2}, {1, 3, true, true, 1});
                for (float value : mesh.positions) QVERIFY(std::isfinite(value) && std::abs(value) < 0.02f);
                for (float value : mesh.normals) QVERIFY(std::isfinite(value));
            }
    }
};

QTEST_APPLESS_MAIN(TestFibres)
#include "tst_fibres.moc"
