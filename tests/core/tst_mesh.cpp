// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/base/units.h"
#include "core/geometry/mesh.h"

#include <QTest>

#include <cmath>
#include <map>
#include <set>

using namespace hygroloom;

namespace {

Textile cloth(const char* pattern, int ends, int picks, double thickness_mm = 0)
{
    Fabric fabric;
    fabric.name = "cloth";
    fabric.warp.diameter_mm = 0.2;
    fabric.weft.diameter_mm = 0.25;
    fabric.ends_per_cm = 20;
    fabric.picks_per_cm = 16;
    fabric.weave = weave_from_pattern(pattern);
    if (thickness_mm > 0) fabric.thickness_mm = thickness_mm;
    return build_textile({}, fabric, {0, 0, ends, picks});
}

Vec3d position(const YarnMesh& mesh, std::uint32_t v)
{
    return {mesh.positions[3 * v], mesh.positions[3 * v + 1], mesh.positions[3 * v + 2]};
}

double volume(const YarnMesh& mesh, const MeshGroup& group)
{
    double six = 0;
    for (std::size_t i = group.first_index; i < group.first_index + group.indices; i += 3)
        six += dot(position(mesh, mesh.indices[i]), cross(position(mesh, mesh.indices[i + 1]), position(mesh, mesh.indices[i + 2])));
    return six / 6;
}

} // namespace

class TestMesh : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void sizesAreAsEstimated()
    {
        const Textile textile = cloth("twill 2/1 Z", 7, 5);
        const YarnMesh mesh = mesh_yarns(textile, 6, 8);
        const MeshSize size = mesh_size(textile, 6, 8);
        QCOMPARE(mesh.segment_of_vertex.size(), size.vertices);
        QCOMPARE(mesh.indices.size(), 3 * size.triangles);
        QCOMPARE(mesh.positions.size(), 3 * size.vertices);
        QCOMPARE(mesh.normals.size(), 3 * size.vertices);
        QCOMPARE(mesh.uvs.size(), 2 * size.vertices);
        QCOMPARE(mesh.groups.size(), std::size_t(12));
        QCOMPARE(mesh.groups.front().name, std::string("warp_000"));
        QCOMPARE(mesh.groups.back().name, std::string("weft_004"));
    }
    void openYarnsAreTheSameWithoutTheirCaps()
    {
        const Textile textile = cloth("twill 2/1 Z", 3, 4);
        for (YarnKind kind : {YarnKind::warp, YarnKind::weft}) {
            YarnMesh closed, open;
            append_yarn(textile, kind, 1, 6, 8, closed);
            append_yarn(textile, kind, 1, 6, 8, open, false);
            QCOMPARE(closed.segment_of_vertex.size() - open.segment_of_vertex.size(), std::size_t(2 * 9));
            QCOMPARE(closed.indices.size() - open.indices.size(), std::size_t(3 * 2 * 8));
            QVERIFY(std::equal(open.positions.begin(), open.positions.end(), closed.positions.begin()));
            QVERIFY(std::equal(open.indices.begin(), open.indices.end(), closed.indices.begin()));
        }
    }
    void groupsFollowEachOtherWithoutGaps()
    {
        const YarnMesh mesh = mesh_yarns(cloth("plain", 3, 4), 4, 8);
        std::size_t vertex = 0, index = 0;
        for (const MeshGroup& group : mesh.groups) {
            QCOMPARE(group.first_vertex, vertex);
            QCOMPARE(group.first_index, index);
            for (std::size_t i = index; i < index + group.indices; ++i)
                QVERIFY(mesh.indices[i] >= vertex && mesh.indices[i] < vertex + group.vertices);
            vertex += group.vertices;
            index += group.indices;
        }
        QCOMPARE(vertex, mesh.segment_of_vertex.size());
        QCOMPARE(index, mesh.indices.size());
    }
    void everyYarnIsClosed()
    {
        const YarnMesh mesh = mesh_yarns(cloth("satin 5/2", 5, 5, 0.3), 5, 12);
        for (const MeshGroup& group : mesh.groups) {
            // Weld by position: every edge must be used once in each direction.
            std::map<std::array<float, 3>, int> welded;
            std::set<std::pair<int, int>> edges;
            const auto id = [&](std::uint32_t v) {
                return welded
                    .emplace(std::array<float, 3>{mesh.positions[3 * v], mesh.positions[3 * v + 1], mesh.positions[3 * v + 2]},
                             static_cast<int>(welded.size()))
                    .first->second;
            };
            for (std::size_t i = group.first_index; i < group.first_index + group.indices; i += 3)
                for (std::size_t c = 0; c < 3; ++c)
                    QVERIFY(edges.emplace(id(mesh.indices[i + c]), id(mesh.indices[i + (c + 1) % 3])).second);
            for (const auto& [from, to] : edges) QVERIFY(edges.count({to, from}) == 1);
        }
    }
    void volumeIsSectionTimesLength()
    {
        const Textile textile = cloth("plain", 4, 4);
        const YarnMesh mesh = mesh_yarns(textile, 32, 64);
        for (const MeshGroup& group : mesh.groups) {
            const YarnSystem& system = textile.system(group.kind);
            const double expected = system.types[0].area * system.paths[1].length * 4;
            const double found = volume(mesh, group);
            QVERIFY2(std::abs(found / expected - 1) < 0.03, qPrintable(QString::number(found / expected))); // positive: facing outwards
        }
    }
    void normalsAreUnitAndPointOutwards()
    {
        const YarnMesh mesh = mesh_yarns(cloth("twill 2/2 S", 4, 4), 6, 8);
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const Vec3d a = position(mesh, mesh.indices[i]), b = position(mesh, mesh.indices[i + 1]),
                        c = position(mesh, mesh.indices[i + 2]);
            const Vec3d face = cross(b - a, c - a);
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t v = mesh.indices[i + k];
                const Vec3d normal{mesh.normals[3 * v], mesh.normals[3 * v + 1], mesh.normals[3 * v + 2]};
                QVERIFY(std::abs(length(normal) - 1) < 1e-5);
                QVERIFY(dot(normal, face) > 0);
            }
        }
    }
    void yarnsFillTheRegionAndTheThickness()
    {
        const Textile textile = cloth("plain", 6, 8);
        const YarnMesh mesh = mesh_yarns(textile, 8, 16);
        float low[3] = {1, 1, 1}, high[3] = {-1, -1, -1};
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            low[i % 3] = std::min(low[i % 3], mesh.positions[i]);
            high[i % 3] = std::max(high[i % 3], mesh.positions[i]);
        }
        QVERIFY(std::abs(high[0] - 3 * textile.warp.pitch) < 0.2e-4 + 0.05e-3); // ends of the weft, tilted by half its height at most
        QVERIFY(std::abs(high[1] - 4 * textile.weft.pitch) < 0.2e-4 + 0.05e-3);
        QVERIFY(std::abs(high[2] - textile.half_thickness()) < 1e-7);
        QVERIFY(std::abs(low[2] + textile.half_thickness()) < 1e-7);
    }
    void verticesKnowTheirSegments()
    {
        const Textile textile = cloth("plain", 3, 4);
        const YarnMesh mesh = mesh_yarns(textile, 5, 8);
        for (const MeshGroup& group : mesh.groups)
            for (std::size_t v = group.first_vertex; v < group.first_vertex + group.vertices; ++v) {
                const int crossings = group.kind == YarnKind::warp ? 4 : 3;
                const int at = std::min(static_cast<int>(mesh.uvs[2 * v]), crossings - 1);
                QCOMPARE(mesh.segment_of_vertex[v], group.kind == YarnKind::warp ? textile.segment(YarnKind::warp, group.yarn, at)
                                                                                 : textile.segment(YarnKind::weft, at, group.yarn));
            }
    }
    void linesRunThroughTheMiddle()
    {
        const Textile textile = cloth("plain", 2, 3);
        const std::vector<MiddleLine> lines = yarn_lines(textile, 4);
        QCOMPARE(lines.size(), std::size_t(5));
        QCOMPARE(lines[0].positions.size(), std::size_t(3 * 13));
        double along = 0;
        for (std::size_t i = 3; i < lines[0].positions.size(); i += 3)
            along +=
                std::hypot(lines[0].positions[i + 1] - lines[0].positions[i - 2], lines[0].positions[i + 2] - lines[0].positions[i - 1]);
        QVERIFY(std::abs(along / (3 * textile.warp.paths[1].length) - 1) < 0.02);
    }
    void racetracksHaveTheirWidthAndHeight()
    {
        QVERIFY(std::abs(section_point(2, 1, 0.5 * pi).across - 2) < 1e-12);
        QVERIFY(std::abs(section_point(2, 1, 1.5 * pi).across + 2) < 1e-12);
        QCOMPARE(section_point(2, 1, 0).up, 1.0);
        QVERIFY(std::abs(section_point(2, 1, 0).across) < 1e-12);
        QVERIFY(std::abs(section_point(1, 1, pi / 3).across - std::sin(pi / 3)) < 1e-12);
    }
};

QTEST_APPLESS_MAIN(TestMesh)
#include "tst_mesh.moc"
