// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The yarns' skins against brute force, and that a particle stops at them.
#include "core/base/random.h"
#include "core/run/plan_run.h"
#include "core/solver/host_cloth.h"
#include "core/solver/solver.h"
#include "tests/solver/plate.h"
#include "tests/support/drop_design.h"

#include <QTest>

#include <algorithm>

using namespace hygroloom;

namespace {

/// Ends and picks thick, thin and thick again in a 2/2 twill, which has level paths and changes of side between all of them.
Design thick_and_thin()
{
    Design design = drop_design();
    Fabric& fabric = design.fabrics[0];
    fabric.weave = weave_from_pattern("twill 2/2 Z");
    fabric.extra_yarns.push_back(fabric.warp);
    fabric.extra_yarns[0].diameter_mm = 0.12;
    fabric.warp_order = {{0, 3}, {1, 2}};
    fabric.weft_order = {{0, 2}, {1, 1}};
    return design;
}

/// One particle without neighbours between the yarns.
struct LoneParticle {
    Vec3 x, v;
    Real distance = 0;
    int segment = no_wall;
    std::uint8_t alive = 1;
    std::int64_t content = 5, dripped = 0;
    Room room{1, 1, -1};

    /// A step of it from start to x.
    void meet(const TextileShape& shape, const Vec3& start, Real reach, Real touching)
    {
        Vec3 normal;
        Quad place{start.x, start.y, start.z, 0};
        ClothField open;
        Particles p;
        p.cloth = &open;
        p.position = &x;
        p.velocity = &v;
        p.place = &place;
        p.wall_distance = &distance;
        p.wall_normal = &normal;
        p.wall_segment = &segment;
        p.alive = &alive;
        p.content = &content;
        StepNumbers step;
        step.friction = Real(0.2);
        step.drag = 1;
        MeetYarns{p, shape, {}, reach, touching, Real(2.5e-5), &step, room, &dripped}(0);
    }
};

/// Cloths with skins of all kinds: types of yarn, floats, yarns that lie beside their places, yarns that are wider than their pitch.
void add_cloths()
{
    QTest::addColumn<double>("most_shift");
    QTest::addColumn<double>("squeezed");
    QTest::newRow("thick and thin yarns") << 0.0 << 1.0;
    QTest::newRow("yarns beside their places") << 4e-5 << 1.0;
    QTest::newRow("yarns that reach over their neighbours' places") << 4e-5 << 0.7;
}
Scene cloth_scene(double most_shift, double squeezed)
{
    const Design design = thick_and_thin();
    const Textile textile = build_textile(design, design.fabrics[0], {0, 0, 17, 19});
    Scene scene =
        build_scene(design, textile, design.experiments[0], plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::draft), 1);
    for (std::size_t k = 0; k < scene.cloth.shift.size(); ++k)
        scene.cloth.shift[k] += static_cast<float>(most_shift * (2 * random_uniform(11, 0, k) - 1));
    scene.cloth.warp_pitch *= squeezed;
    scene.cloth.weft_pitch *= squeezed;
    return scene;
}

/// The skins of all yarns over a place and beside it, whether they may be the nearest or not; none off the cloth's box.
std::vector<NearestSkin> all_skins(const TextileShape& t, const Vec3& x, Real reach)
{
    const Real u = x.x * t.per_warp_pitch + Real(0.5) * Real(t.ends - 1), v = x.y * t.per_weft_pitch + Real(0.5) * Real(t.picks - 1);
    const int end = static_cast<int>(std::floor(u + Real(0.5))), pick = static_cast<int>(std::floor(v + Real(0.5)));
    std::vector<NearestSkin> skins;
    if (end < 0 || end >= t.ends || pick < 0 || pick >= t.picks || std::abs(x.z) > t.half_thickness + reach) return skins;
    const AlongYarn<Real> along_warp(t, v - Real(pick)), along_weft(t, u - Real(end));
    const auto add = [&](const YarnSkin<Real>& skin) { skins.push_back({skin.distance, skin.normal(), skin.segment}); };
    for (int beside : {0, -1, 1}) {
        if (end + beside >= 0 && end + beside < t.ends)
            add({t, true, t.segment(true, end + beside, pick), along_warp, (u - Real(end + beside)) * t.warp_pitch, x.z});
        if (pick + beside >= 0 && pick + beside < t.picks)
            add({t, false, t.segment(false, end, pick + beside), along_weft, (v - Real(pick + beside)) * t.weft_pitch, x.z});
    }
    return skins;
}

} // namespace

class TestYarnSkins : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatFliesPastTheSampleHasDrippedOff()
    {
        const Scene scene = drop_over_plate(1e-9, 1e-3, 0, 10);
        const HostCloth host(scene);
        for (const Vec3& x : {Vec3{Real(0.02), 0, 0}, Vec3{0, Real(-0.02), Real(0.1)}, Vec3{0, 0, Real(-0.006)}, Vec3{0, 0, Real(0.1)}}) {
            LoneParticle one{x, {}};
            one.room = {Real(0.017), Real(0.017), Real(-0.005)};
            one.meet(host.shape(), x, Real(1e-4), Real(1e-5));
            const bool gone = x.z < Real(0.05) || x.y != 0;
            QCOMPARE(int(one.alive), gone ? 0 : 1);
            QCOMPARE(one.dripped, gone ? one.content : 0);
        }
    }
    void theNearestSkinIsThatOfABruteSearch_data() { add_cloths(); }
    void theNearestSkinIsThatOfABruteSearch()
    {
        QFETCH(double, most_shift);
        QFETCH(double, squeezed);
        const Scene scene = cloth_scene(most_shift, squeezed);
        const HostCloth cloth(scene);
        const TextileShape& t = cloth.shape();
        int beside = 0, none = 0;
        for (std::uint64_t k = 0; k < 4000; ++k) {
            // Places in the cloth, at its edges and off it; some packs have only few near it.
            Real x[lanes], y[lanes], z[lanes];
            const Real reach = Real(random_uniform(9, 3, k) * 3e-4);
            for (std::uint64_t lane = 0; lane < lanes; ++lane) {
                const auto within = [&](std::uint64_t axis, double half) {
                    return Real((2 * random_uniform(9, axis, lanes * k + lane) - 1) * half);
                };
                x[lane] = within(0, 0.55 * scene.cloth.ends * scene.cloth.warp_pitch);
                y[lane] = within(1, 0.55 * scene.cloth.picks * scene.cloth.weft_pitch);
                z[lane] = within(2, (k % 4 == 0 ? 8 : 1.2) * scene.cloth.half_thickness);
            }
            const Nearest<Pack> pack = nearest_skins(t, Packs{load(x), load(y), load(z)}, reach);
            for (int lane = 0; lane < lanes; ++lane) {
                const Vec3 place{x[lane], y[lane], z[lane]};
                const std::vector<NearestSkin> skins = all_skins(t, place, reach);
                Real least = reach;
                for (const NearestSkin& skin : skins) least = std::min(least, skin.distance);
                for (const NearestSkin& found : {nearest_skin(t, place, reach), skin_of(pack, lane)}) {
                    QVERIFY(std::abs(found.distance - least) <= Real(1e-10));
                    if (least == reach) QCOMPARE(found.segment, -1);
                    const auto same = std::find_if(skins.begin(), skins.end(), [&](const auto& s) { return s.segment == found.segment; });
                    QCOMPARE(same == skins.end(), found.segment < 0);
                    if (same == skins.end()) continue;
                    QVERIFY(std::abs(same->distance - least) <= Real(1e-10)); // others may be as near
                    QVERIFY(length(found.normal - same->normal) < Real(1e-3));
                }
                none += least == reach;
                beside += least < reach && skins[0].distance > least && skins[1].distance > least;
            }
        }
        QVERIFY2(beside > 200 && none > 2000, qPrintable(QString("%1 yarns beside, %2 without a skin").arg(beside).arg(none)));
    }
    void particlesSideBySideMeetTheYarnsAsEachAlone_data() { add_cloths(); }
    void particlesSideBySideMeetTheYarnsAsEachAlone()
    {
        QFETCH(double, most_shift);
        QFETCH(double, squeezed);
        const Scene scene = cloth_scene(most_shift, squeezed);
        const HostCloth cloth(scene);
        const Real reach = Real(3e-4), touching = Real(1e-5);
        constexpr std::size_t n = 3001;
        struct Many {
            std::vector<Vec3> x = std::vector<Vec3>(n), v = x, normal = x;
            std::vector<Quad> place = std::vector<Quad>(n);
            std::vector<Real> distance = std::vector<Real>(n);
            std::vector<int> segment = std::vector<int>(n, no_wall);
            std::vector<std::uint8_t> alive = std::vector<std::uint8_t>(n, 1);
            std::vector<std::int64_t> content = std::vector<std::int64_t>(n, 7);
            std::vector<ClothField> cloth = std::vector<ClothField>(n);
            std::int64_t dripped = 0;
            Particles views()
            {
                Particles p;
                p.position = x.data(), p.velocity = v.data(), p.wall_normal = normal.data();
                p.place = place.data(), p.wall_distance = distance.data(), p.wall_segment = segment.data();
                p.alive = alive.data(), p.content = content.data(), p.cloth = cloth.data();
                return p;
            }
        } side_by_side;
        for (std::size_t i = 0; i < n; ++i) {
            const auto within = [&](std::uint64_t axis, double half) { return Real((2 * random_uniform(10, axis, i) - 1) * half); };
            const Vec3 start{within(0, 0.5 * scene.cloth.ends * scene.cloth.warp_pitch),
                             within(1, 0.5 * scene.cloth.picks * scene.cloth.weft_pitch), within(2, 1.2 * scene.cloth.half_thickness)};
            const double far = i % 5 == 0 ? 6e-4 : 2e-5;
            side_by_side.place[i] = {start.x, start.y, start.z, 0};
            side_by_side.x[i] = i % 101 == 0 ? Vec3{0, 0, -2} : start + Vec3{within(3, far), within(4, far), within(5, far)};
            side_by_side.v[i] = {within(3, 1), within(4, 1), within(5, 1)};
            side_by_side.distance[i] = i % 3 == 0 ? Real(0) : nearest_skin(cloth.shape(), start, reach).distance;
            side_by_side.alive[i] = i % 67 != 0;
        }
        Many alone = side_by_side;
        StepNumbers step;
        step.friction = Real(0.2);
        const Room room{1, 1, -1};
        const auto meet = [&](Many& many) {
            return MeetYarns{many.views(), cloth.shape(), {}, reach, touching, Real(2.5e-5), &step, room, &many.dripped};
        };
        meet(side_by_side)(0, 1);
        meet(side_by_side)(1, static_cast<int>(n));
        for (std::size_t i = 0; i < n; ++i) meet(alone)(static_cast<int>(i));
        QVERIFY(alone.dripped > 0);
        QCOMPARE(side_by_side.dripped, alone.dripped);
        QCOMPARE(side_by_side.alive, alone.alive);
        int others = 0; // rounding decides where there is little between two ways
        for (std::size_t i = 0; i < n; ++i)
            others += length(side_by_side.x[i] - alone.x[i]) > Real(1e-9) || length(side_by_side.v[i] - alone.v[i]) > Real(1e-3) ||
                      std::abs(side_by_side.distance[i] - alone.distance[i]) > Real(1e-9) || side_by_side.segment[i] != alone.segment[i];
        QVERIFY2(others <= 3, qPrintable(QString("%1 of %2").arg(others).arg(n)));
    }
    void aMoveStopsAtTheFirstSkinOnItsWay()
    {
        const Scene scene = cloth_scene(0, 1);
        const HostCloth cloth(scene);
        const Real reach = Real(3e-4), touching = Real(5e-6);
        int moves = 0, stopped = 0;
        for (std::uint64_t k = 0; k < 3000; ++k) {
            const auto within = [&](std::uint64_t axis, double half) { return Real((2 * random_uniform(7, axis, k) - 1) * half); };
            const Real height = Real(1.3 * scene.cloth.half_thickness);
            const Vec3 start{within(0, 2e-3), within(1, 2e-3), within(2, 1) * height};
            const Vec3 way{within(3, 6e-4), within(4, 6e-4), within(5, 6e-4)}; // of up to several yarns
            const NearestSkin at_start = nearest_skin(cloth.shape(), start, reach);
            if (at_start.distance < touching) continue;
            LoneParticle one{start + way, Real(1e3) * way, at_start.distance, at_start.segment};
            one.meet(cloth.shape(), start, reach, touching);
            const Vec3& x = one.x;
            ++moves;
            QVERIFY(nearest_skin(cloth.shape(), x, reach).distance > Real(0.49) * touching);
            // Where the free way ends, by small pieces; behind it the particle may not be.
            constexpr int pieces = 600;
            int free = 0;
            while (free < pieces &&
                   nearest_skin(cloth.shape(), start + (Real(free + 1) / pieces) * way, reach).distance > Real(0.5) * touching)
                ++free;
            if (free == pieces) continue;
            ++stopped;
            const Real behind = dot(x - start, way) / length(way) - Real(free) / pieces * length(way);
            QVERIFY2(behind < Real(4e-5), qPrintable(QString("%1 um behind a skin").arg(1e6 * double(behind))));
        }
        QVERIFY(moves > 1000 && stopped > 300);
    }
    void wedgesAreLeftAlongTheirSkins()
    {
        const Scene scene = cloth_scene(0, 1);
        const HostCloth cloth(scene);
        const Real reach = Real(3e-4), touching = Real(2e-5);
        int places = 0, wedges = 0, left = 0, kept = 0;
        for (std::uint64_t k = 0; k < 20000; ++k) {
            const auto within = [&](std::uint64_t axis, double half) { return Real((2 * random_uniform(8, axis, k) - 1) * half); };
            const Vec3 start{within(0, 2e-3), within(1, 2e-3), within(2, scene.cloth.half_thickness)};
            const NearestSkin at_start = nearest_skin(cloth.shape(), start, reach);
            if (at_start.distance >= touching || at_start.distance < 0) continue;
            const Vec3 pushed = start + (touching - at_start.distance) * at_start.normal;
            const bool wedge = nearest_skin(cloth.shape(), pushed, reach).distance < Real(0.9) * touching;
            LoneParticle one{start, {within(3, 1), within(4, 1), within(5, 1)}, at_start.distance, at_start.segment};
            const Real before = length(one.v);
            one.meet(cloth.shape(), start, reach, touching);
            ++places;
            wedges += wedge;
            QVERIFY(length(one.v) <= Real(1.0001) * before);
            QVERIFY(length(one.x - start) < Real(8) * touching);
            const NearestSkin now = nearest_skin(cloth.shape(), one.x, reach);
            if (now.distance < Real(0.89) * touching) continue;
            left += wedge;
            // Yarns bend: a skin's normal turns a little over the way.
            const auto approaches = [&](const Vec3& normal) { return dot(one.v, normal) < Real(-0.05) * before; };
            kept += approaches(at_start.normal);
        }
        const QString counts =
            QString("%1 places, %2 wedges, %3 left, %4 still towards the first skin").arg(places).arg(wedges).arg(left).arg(kept);
        QVERIFY2(places > 1000 && wedges > 100 && left > 0.75 * wedges && kept < 0.005 * places, qPrintable(counts));
        qInfo("%s", qPrintable(counts));
    }
    void beadsThatAreCutOnDemandActAsThoseInMemory_data() { add_cloths(); }
    void beadsThatAreCutOnDemandActAsThoseInMemory()
    {
        QFETCH(double, most_shift);
        QFETCH(double, squeezed);
        const Scene scene = cloth_scene(most_shift, squeezed);
        const ClothShape shape(scene);
        const HostCloth cloth(scene);
        HostBeads kept = make_beads(scene, shape, 1e-4, 2e-4, 3e-4);
        QVERIFY(
            std::all_of(kept.first.begin(), kept.first.end(), [](int first) { return first >= 0; })); // the drop is as wide as the cloth
        std::vector<int> none(kept.first.size(), -1);
        kept.view.bead = kept.beads.data();
        kept.view.types = kept.types.data();
        Beads cut = kept.view;
        kept.view.first = kept.first.data();
        cut.first = none.data();
        for (const Quad& bead : kept.beads) QVERIFY(std::abs(bead.z) <= kept.view.top);
        Real most_share = 0;
        for (std::uint64_t k = 0; k < 300; ++k) {
            const auto place = [&](std::uint64_t axis, double half) {
                return static_cast<Real>(half * (2 * random_uniform(3, axis, k) - 1));
            };
            const Vec3 x{place(0, 8.5 * scene.cloth.warp_pitch), place(1, 9.5 * scene.cloth.weft_pitch),
                         place(2, 2 * scene.cloth.half_thickness)};
            const ClothField of_kept = FeelCloth{{}, cloth.shape(), kept.view}.expansion(x).field;
            const ClothField of_cut = FeelCloth{{}, cloth.shape(), cut}.expansion(x).field;
            QVERIFY2(std::abs(of_kept.share - of_cut.share) <= Real(1e-5) * (of_kept.share + Real(0.1)),
                     qPrintable(QString("%1 in memory, %2 cut").arg(of_kept.share).arg(of_cut.share)));
            QVERIFY(length(of_kept.slope - of_cut.slope) <= Real(1e-4) * (length(of_kept.slope) + 1));
            QVERIFY(length(of_kept.adhesion - of_cut.adhesion) <= Real(1e-4) * (length(of_kept.adhesion) + 1));
            most_share = std::max(most_share, of_kept.share);
        }
        QVERIFY(most_share > Real(0.5));
    }
    void largeClothsHaveBeadsAsSmallOnes()
    {
        const auto beads = [](int side) {
            const Design design = drop_design();
            const Textile textile = build_textile(design, design.fabrics[0], {0, 0, side, side});
            const Scene scene = build_scene(design, textile, design.experiments[0],
                                            plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::draft), 1);
            return make_beads(scene, ClothShape(scene), 5e-5, 1e-4, 1.5e-4);
        };
        const HostBeads small = beads(100), large = beads(600); // 720 000 segments
        QVERIFY(small.view.grid.per_segment() > 12);
        QCOMPARE(large.view.grid.per_segment(), small.view.grid.per_segment());
        QVERIFY(large.beads.size() < 2 * small.beads.size()); // near the drop alone
        const std::size_t missing = static_cast<std::size_t>(std::count(large.first.begin(), large.first.end(), -1));
        QVERIFY(missing > large.first.size() / 2 && missing < large.first.size());
    }
    void skinIsFoundOnTheSideOneIsOn()
    {
        const Scene scene = drop_over_plate(1e-9, 1e-3, 0, 10);
        const HostCloth host(scene);
        const TextileShape& shape = host.shape();
        const NearestSkin above = nearest_skin(shape, {Real(1.5e-4), Real(1.5e-4), Real(1.8e-4)}, Real(2e-4));
        QVERIFY(above.segment >= 0);
        QVERIFY(above.normal.z > Real(0.9));
        QVERIFY(std::abs(above.distance - Real(0.8e-4)) < Real(1e-6));
        QCOMPARE(nearest_skin(shape, {0, 0, Real(1e-2)}, Real(2e-4)).segment, -1);
        QCOMPARE(nearest_skin(shape, {Real(1), 0, 0}, Real(2e-4)).segment, -1);
    }
    void skinOfThickAndThinYarnsLiesWhereTheTextileHasThem()
    {
        const Design design = thick_and_thin();
        const Textile textile = build_textile(design, design.fabrics[0], {0, 0, 17, 19});
        QCOMPARE(int(textile.warp.types.size()), 2);
        const Scene scene = build_scene(design, textile, design.experiments[0],
                                        plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::draft), 1);
        const HostCloth host(scene);
        for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
            for (int yarn = 0; yarn < textile.system(kind).count; ++yarn)
                for (int at = 1; at + 1 < textile.system(other_kind(kind)).count; ++at)
                    for (double offset : {-0.49, -0.31, -0.12, 0.0, 0.2, 0.37, 0.48}) {
                        const YarnPoint point = yarn_point(textile, kind, yarn, at, offset);
                        const Vec3 middle{Real(point.centre.x), Real(point.centre.y), Real(point.centre.z)};
                        const NearestSkin skin = nearest_skin(host.shape(), middle, Real(1e-4));
                        QCOMPARE(skin.segment, kind == YarnKind::warp ? textile.segment(kind, yarn, at) : textile.segment(kind, at, yarn));
                        QVERIFY2(std::abs(double(skin.distance) + point.half_height) < 1e-3 * point.half_height,
                                 qPrintable(QString("%1 instead of %2").arg(double(skin.distance)).arg(-point.half_height)));
                    }
    }
};

QTEST_APPLESS_MAIN(TestYarnSkins)
#include "tst_yarn_skins.moc"
