// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The free liquid: neighbours against brute force, balances, and that nothing passes through yarn.
#include "core/base/random.h"
#include "core/run/plan_run.h"
#include "core/solver/cpu_executor.h"
#include "core/solver/host_cloth.h"
#include "core/solver/solver.h"
#include "core/verify/set_ups.h"
#include "tests/support/drop_design.h"

#include <QTest>

#include <algorithm>

using namespace hygroloom;

namespace {

/// Gives the cloth closed yarns of these half heights, the same types in warp and weft, one after the other; they touch half-way.
void set_heights(Scene& scene, const std::vector<double>& half_heights)
{
    const std::size_t n = half_heights.size();
    scene.cloth.warp_types = static_cast<int>(n);
    scene.cloth.yarns.resize(2 * n, scene.cloth.yarns[0]);
    scene.cloth.shapes.clear();
    scene.cloth.crossing.clear();
    scene.cloth.half_thickness = 0;
    for (int line = 0; line < scene.cloth.ends + scene.cloth.picks; ++line) {
        const auto yarn = static_cast<std::size_t>(line < scene.cloth.ends ? line : line - scene.cloth.ends);
        scene.cloth.type[static_cast<std::size_t>(line)] = static_cast<std::uint8_t>(yarn % n + (line < scene.cloth.ends ? 0 : n));
    }
    for (double own : half_heights) {
        ContactShape shape{own, 1.47e-4, {}};
        for (double before : half_heights)
            for (double after : half_heights)
                for (double side : {1.0, -1.0})
                    for (double rise : {0.5 * (own + before), side * 0.5 * (own + after)})
                        for (double value : {rise, 0.0, own, shape.half_width}) shape.profiles.push_back(static_cast<float>(value));
        scene.cloth.shapes.push_back(shape);
        for (double other : half_heights) {
            scene.cloth.crossing.push_back({0, 0, 0, 0.5 * (own + other), 0.5 * (own + other)});
            scene.cloth.half_thickness = std::max(scene.cloth.half_thickness, 0.5 * (own + other) + own);
        }
    }
    for (std::size_t i = 0; i < n; ++i) scene.cloth.shapes.push_back(scene.cloth.shapes[i]);
}

Scene drop_over_plate(double volume, double height, double speed, int particles, const std::vector<double>& half_heights = {5e-5})
{
    Scene scene = bare_scene(80, 80, 3e-4, 293.15);
    scene.cloth.shift.assign(static_cast<std::size_t>(scene.cloth.segments()), 0.0f);
    set_heights(scene, half_heights);
    const double radius = std::cbrt(3 * volume / (4 * pi));
    scene.supply.droplets.push_back({0, volume, {0, 0, scene.cloth.half_thickness + height + radius}, speed});
    scene.rules.particles_per_droplet = particles;
    return scene;
}

/// Water on a plate, a little off its lattice: a column in a box, or half a ball that lies free.
Scene water_in_vessel(bool box)
{
    constexpr double spacing = 2e-4, plate = 5e-3, half = 1e-3; // m
    Scene scene = bare_scene(1, 1, 2e-3, 293.15);
    scene.rules.network_step = scene.rules.calm_network_step = 1;
    for (int k = 0; k < (box ? 20 : 5); ++k)
        for (int j = -5; j < 5; ++j)
            for (int i = -5; i < 5; ++i) {
                const auto number = static_cast<std::uint64_t>(scene.liquid.places.size());
                const auto off = [&](std::uint64_t axis) { return 0.3 * (random_uniform(3, axis, number) - 0.5); };
                const Vec3d place = spacing * Vec3d{i + 0.5 + off(0), j + 0.5 + off(1), k + 0.5 + off(2)};
                if (box || length(place) < half) scene.liquid.places.push_back(place + Vec3d{0, 0, plate});
            }
    scene.liquid.velocities.assign(scene.liquid.places.size(), Vec3d{});
    scene.liquid.particle_volume = spacing * spacing * spacing;
    scene.liquid.vessel = SceneVessel{{-half, -half, plate}, {half, half, 1}, scene.climate.surface_tension};
    if (!box) scene.liquid.vessel->low.x = scene.liquid.vessel->low.y = -(scene.liquid.vessel->high.x = scene.liquid.vessel->high.y = 1);
    return scene;
}

/// How far any particle of a frame is from the nearest of another one, which may have them in another order, and how differently both
/// move; m, m/s.
std::pair<double, double> greatest_differences(const Frame& a, const Frame& b)
{
    const auto vector = [](const std::array<float, 3>& v) { return Vec3d{v[0], v[1], v[2]}; };
    double farthest = 0, fastest = 0;
    for (std::size_t i = 0; i < a.positions.size(); ++i) {
        const auto far_from = [&](std::size_t j) { return length(vector(a.positions[i]) - vector(b.positions[j])); };
        std::size_t nearest = 0;
        for (std::size_t j = 1; j < b.positions.size(); ++j)
            if (far_from(j) < far_from(nearest)) nearest = j;
        farthest = std::max(farthest, far_from(nearest));
        fastest = std::max(fastest, length(vector(a.velocities[i]) - vector(b.velocities[nearest])));
    }
    return {farthest, fastest};
}

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

/// Particles at random places in a cube of length 1, their neighbours listed. Each has a name that stays when they are sorted.
struct Listed {
    Particles p;
    CellGrid grid;
    CpuExecutor exec;
    std::vector<Vec3> x;
    std::vector<int> name;

    Listed(int count, int shift, Real skin)
    {
        p.room = count;
        p.mass = Real(2e-3);
        p.support = Real(0.15);
        p.reach = p.spacing = Real(0.2);
        grid.size = Real(0.2);
        grid.per_size = Real(5);
        grid.whole_y = grid.whole_z = 5;
        grid.whole_x = narrower * 5;
        grid.shift = shift;
        grid.nx = ((narrower * 5 - 1) >> shift) + 1;
        grid.ny = grid.nz = (4 >> shift) + 1;
        for (int i = 0; i < count; ++i) {
            const auto at = [&](std::uint64_t axis) { return Real(random_uniform(1, axis, std::uint64_t(i))); };
            x.push_back({at(0), at(1), at(2)});
            name.push_back(i);
        }
        alive_.assign(std::size_t(count), 1);
        list(skin);
    }
    Listed(const Listed& other) : p(other.p), grid(other.grid), x(other.x), name(other.name), alive_(other.alive_), lists_(other.lists_)
    {
        view();
    }

    void list(Real skin)
    {
        const auto n = x.size();
        view();
        CpuExecutor::Buffer<int> key, order, start;
        key.resize(n);
        order.resize(n);
        start.resize(static_cast<std::size_t>(grid.cells()) + 3);
        grid.key = key.data();
        grid.start = start.data();
        const int dead_key = grid.cells();
        exec.sort_into_cells(FindCell{p, &grid}, key.data(), order.data(), start.data(), {&p.room, p.room}, &dead_key);
        const auto sort = [&](auto& values) {
            const auto before = values;
            for (std::size_t i = 0; i < n; ++i) values[i] = before[std::size_t(order.read(i))];
        };
        sort(x);
        sort(name);
        sort(alive_);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            lists_.at[axis].assign(n + lanes, 0);
            for (std::size_t i = 0; i < n; ++i) lists_.at[axis][i] = axis == 0 ? x[i].x : axis == 1 ? x[i].y : x[i].z;
        }
        lists_.near.assign(n * most_near, 0);
        lists_.distant.assign(n * most_distant, 0);
        for (auto* numbers : {&lists_.near_first, &lists_.distant_first, &lists_.near_count, &lists_.distant_count}) numbers->assign(n, 0);
        view();
        exec.for_each("neighbours", start.read(std::size_t(grid.cells())), FindNeighbours{p, &grid, &skin});
    }
    /// With the particles where they are now.
    void find_surface()
    {
        const std::size_t room = x.size() + lanes;
        for (auto* quads : {&place_, &motion_, &standing_, &predicted_, &surface_}) quads->assign(room, far_away());
        std::vector<Vec3> still(x.size());
        std::vector<int> moved(6), no_walls(x.size(), no_wall);
        view();
        p.velocity = still.data();
        p.wall_segment = no_walls.data();
        std::vector<std::int64_t> full(x.size(), 1);
        p.content = full.data();
        p.per_quantum = 1;
        std::vector<ClothField> no_cloth(x.size());
        p.cloth = no_cloth.data();
        LiquidParameters liquid;
        liquid.density = 1;
        liquid.surface = {1, Real(1e-3)};
        std::int64_t dead = 0;
        exec.for_each("begin step", p.room, BeginStep{p, kept_pressure, moved.data(), &dead});
        exec.for_each("surface", p.room, FindSurface{p, liquid});
    }
    const Quad& surface_of(int named) const { return surface_[std::size_t(std::find(name.begin(), name.end(), named) - name.begin())]; }
    int living() const { return int(std::count(alive_.begin(), alive_.end(), 1)); }

private:
    struct Lists {
        std::vector<int> near, distant, near_first, distant_first, near_count, distant_count;
        std::vector<Real> at[3];
    };
    void view()
    {
        p.position = x.data();
        p.alive = alive_.data();
        p.near = lists_.near.data();
        p.distant = lists_.distant.data();
        p.near_first = lists_.near_first.data();
        p.distant_first = lists_.distant_first.data();
        p.near_count = lists_.near_count.data();
        p.distant_count = lists_.distant_count.data();
        p.listed_x = lists_.at[0].data();
        p.listed_y = lists_.at[1].data();
        p.listed_z = lists_.at[2].data();
        p.place = place_.data();
        p.motion = motion_.data();
        p.standing = standing_.data();
        p.predicted = predicted_.data();
        p.surface = surface_.data();
    }
    std::vector<std::uint8_t> alive_;
    Lists lists_;
    std::vector<Quad> place_, motion_, standing_, predicted_, surface_;
};

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

class TestLiquid : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void nearlyAbsorbedParticlesDoNotKeepADropAwakeButADripDoes()
    {
        Vec3 velocity[3] = {{Real(0.1), 0, 0}, {0, 0, Real(-0.3)}, {1, 0, 0}}; // full, nearly absorbed, dead
        std::int64_t content[3] = {1000, 20, 1000};
        std::uint8_t alive[3] = {1, 1, 0};
        ClothField cloth[3];
        Particles p;
        p.velocity = velocity;
        p.content = content;
        p.alive = alive;
        p.cloth = cloth;
        p.per_quantum = Real(1e-3);
        int largest = 0;
        const SumSpeeds speeds{p, nullptr, &largest};
        const auto square = [&](int i) { return static_cast<double>(speeds(i)) * SumSpeeds::quantum; };
        for (ClothField& c : cloth) c.surface_share = Real(0.1); // at the cloth
        QVERIFY(std::abs(square(0) - 0.01) < 1e-8);
        QVERIFY(std::abs(square(1) - 0.02 * 0.09) < 1e-8);
        QCOMPARE(square(2), 0.0);
        QCOMPARE(largest, 0);
        cloth[1].surface_share = 0; // a drip
        square(1);
        QVERIFY(std::abs(from_ordered_bits(largest) - 0.09f) < 1e-7f);
    }
    void neighboursAreThoseABruteSearchFinds_data()
    {
        QTest::addColumn<int>("shift");
        QTest::addColumn<double>("skin");
        QTest::newRow("cells of the reach") << 0 << 0.0;
        QTest::newRow("cells twice as wide") << 1 << 0.0;
        QTest::newRow("with a skin") << 0 << 0.03;
    }
    void neighboursAreThoseABruteSearchFinds()
    {
        QFETCH(int, shift);
        QFETCH(double, skin);
        Listed listed(500, shift, Real(skin));
        const Particles& p = listed.p;
        const Real within = p.support + Real(skin), reach = p.reach + Real(skin);
        for (int i = 0; i < p.room; ++i) {
            int expected_near = 0, expected = 0;
            for (int j = 0; j < p.room; ++j) {
                const Vec3 d = p.position[i] - p.position[j];
                expected_near += j != i && dot(d, d) < within * within;
                expected += j != i && dot(d, d) < reach * reach;
            }
            int near = 0, all = 0, filled = 0;
            const auto count = [&](const int* slots) {
                for (int l = 0; l < lanes; ++l) (slots[l] == slot_of(p.room) ? filled : all) += slots[l] != slot_of(i);
            };
            for_neighbours(p, i, count);
            near = all;
            for_distant_neighbours(p, i, count);
            QCOMPARE(near, expected_near);
            QCOMPARE(all, expected);
            QVERIFY(filled < 2 * lanes);
        }
    }
    void keptListsGiveTheSameSurfaceAsFreshOnes()
    {
        const Real skin = Real(0.03);
        Listed kept(500, 0, skin);
        for (int i = 0; i < kept.p.room; ++i) { // all fall by more than the skin, and each moves by less than half of it
            Vec3& x = kept.p.position[i];
            const auto off = [&](std::uint64_t axis) { return Real(0.5) * skin * Real(random_uniform(2, axis, std::uint64_t(i)) - 0.5); };
            x += Vec3{off(0), off(1), off(2) - Real(0.05)};
        }
        Listed fresh = kept;
        fresh.list(0);
        kept.find_surface();
        fresh.find_surface();
        for (int i = 0; i < kept.p.room; ++i) {
            const Quad &a = kept.surface_of(kept.name[std::size_t(i)]), &b = fresh.surface_of(kept.name[std::size_t(i)]);
            for (Real difference : {a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w}) QVERIFY(std::abs(difference) < 2e-4);
        }
    }
    void theDeadCountForNothing()
    {
        Listed with_dead(500, 0, 0);
        for (int i = 0; i < with_dead.p.room; i += 7) with_dead.p.alive[i] = 0;
        Listed without = with_dead;
        with_dead.find_surface();
        without.list(0);
        QCOMPARE(without.living(), 500 - 72);
        without.find_surface();
        for (int i = 0; i < with_dead.p.room; ++i)
            if (with_dead.p.alive[i]) {
                const Quad &a = with_dead.surface_of(with_dead.name[std::size_t(i)]),
                           &b = without.surface_of(with_dead.name[std::size_t(i)]);
                for (Real difference : {a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w}) QVERIFY(std::abs(difference) < 2e-4);
            }
    }
    void particlesAtOnePlaceDoNotPushEachOther()
    {
        Listed listed(500, 0, 0);
        for (std::size_t i : {1, 2}) listed.x[i] = listed.x[0];
        listed.list(0);
        listed.find_surface();
        for (int i = 0; i < listed.p.room; ++i) {
            const Quad& surface = listed.surface_of(i);
            for (Real value : {surface.x, surface.y, surface.z, surface.w}) QVERIFY(std::isfinite(value));
        }
    }
    void aFallingDropKeepsItsLists()
    {
        Solver<CpuExecutor> solver;
        solver.load(drop_over_plate(5e-9, 20e-3, 0, 800));
        for (double time = 0; time < 0.02;) time = solver.advance(0.02, 1e9);
        const long steps = solver.liquid_steps(), listings = solver.listings();
        for (double time = 0.02; time < 0.04;) time = solver.advance(0.04, 1e9);
        QVERIFY2(2 * (solver.listings() - listings) < solver.liquid_steps() - steps,
                 qPrintable(QString::number(solver.listings() - listings)));
    }
    void nothingDependsOnThreadsOrOnFramesTaken()
    {
        Scene scene = drop_over_plate(1e-9, 0.2e-3, 0.5, 300);
        for (YarnParameters& yarn : scene.cloth.yarns) { // so that yarns absorb some
            yarn.pore_area = 5e-8;
            yarn.intake_flux = 100;
            yarn.face_area = 1e-7;
        }
        std::vector<Frame> ends;
        for (int threads : {1, 2})
            for (bool takes_frames : {false, true}) {
                const auto backend = make_cpu_backend();
                backend->set_threads(threads);
                backend->load(scene);
                for (int k = 1; k <= 40; ++k) {
                    const double until = 2.5e-4 * k;
                    while (backend->advance(until) < until) {}
                    if (takes_frames) backend->frame();
                }
                ends.push_back(backend->frame());
            }
        QVERIFY(ends[0].positions.size() < 300);
        for (const Frame& end : ends) {
            QVERIFY(!end.positions.empty());
            QVERIFY(end.positions == ends[0].positions);
            QVERIFY(end.velocities == ends[0].velocities);
            QVERIFY(end.liquid == ends[0].liquid);
            QCOMPARE(end.ledger.water_free, ends[0].ledger.water_free);
        }
    }
    void whatAVesselHoldsGoesOnWhereItWasTaken_data()
    {
        QTest::addColumn<bool>("box");
        QTest::newRow("column") << true;
        QTest::newRow("drop on a plate") << false;
    }
    /// Without what its walls stand for, particles at them would be off by 3 um after 0.1 ms and by 0.1 mm after 10 ms; rounding, in
    /// another order of neighbours, moves them by 0.1 um.
    void whatAVesselHoldsGoesOnWhereItWasTaken()
    {
        QFETCH(bool, box);
        const Scene scene = water_in_vessel(box);
        Solver<CpuExecutor> whole, resumed;
        const auto advance = [](Solver<CpuExecutor>& solver, double until) {
            while (solver.advance(until, 10) < until) {}
        };
        whole.load(scene);
        advance(whole, 0.01);
        resumed.load(scene);
        resumed.go_on_from(whole.state());
        for (double until : {0.0101, 0.011, 0.02}) {
            advance(whole, until);
            advance(resumed, until);
            QCOMPARE(resumed.liquid_steps(), whole.liquid_steps());
            const auto [farthest, fastest] = greatest_differences(whole.frame(), resumed.frame());
            QVERIFY2(farthest < 1e-6, qPrintable(QString("%1 m at %2 s").arg(farthest).arg(until)));
            QVERIFY2(fastest < 1e-3, qPrintable(QString("%1 m/s at %2 s").arg(fastest).arg(until)));
        }
    }
    void aDropInTheAirFallsWithoutDrifting()
    {
        const auto backend = make_cpu_backend();
        Scene scene = drop_over_plate(5e-9, 20e-3, 0, 800);
        const std::vector<Frame> frames = frames_at(*backend, scene, {1e-3, 0.03});
        Vec3d middle, speed;
        for (std::size_t i = 0; i < frames[1].positions.size(); ++i) {
            const auto& x = frames[1].positions[i];
            const auto& v = frames[1].velocities[i];
            middle += (1.0 / 800) * Vec3d{x[0], x[1], x[2]};
            speed += (1.0 / 800) * Vec3d{v[0], v[1], v[2]};
        }
        const double fallen = scene.supply.droplets[0].centre.z - middle.z;
        QCOMPARE(int(frames[1].positions.size()), 800);
        QVERIFY2(std::abs(fallen - 0.5 * 9.80665 * 0.03 * 0.03) < 0.02 * fallen,
                 qPrintable(QString("%1 m, %2 m/s").arg(fallen).arg(speed.z)));
        QVERIFY(std::abs(speed.z + 9.80665 * 0.03) < 0.01 * 9.80665 * 0.03);
        QVERIFY(std::hypot(speed.x, speed.y) < 1e-3);
    }
    void aSliverOfAStepKicksNothing()
    {
        const auto backend = make_cpu_backend();
        const double whole = 5e-3;
        for (double sliver : {1e-18, 1e-12, 1e-10, 1e-8, 1e-6}) { // as a drop's time and a frame's may differ
            const double later = whole + sliver;
            const std::vector<Frame> frames = frames_at(*backend, drop_over_plate(5e-9, 20e-3, 0, 800), {whole, later, later + 1e-3});
            const auto fastest = [](const Frame& frame) {
                double most = 0;
                for (const auto& v : frame.velocities) most = std::max(most, std::hypot(double(v[0]), double(v[1])));
                return most;
            };
            for (const Frame& frame : frames) QVERIFY2(fastest(frame) < fastest(frames[0]) + 0.02, qPrintable(QString::number(sliver)));
        }
    }
    void aDropInTheAirStaysRoundAndComesToRest()
    {
        const auto backend = make_cpu_backend();
        const Frame frame = frames_at(*backend, drop_over_plate(5e-9, 20e-3, 0, 800), {0.04}).back();
        Vec3d middle, speed;
        for (std::size_t i = 0; i < 800; ++i) {
            middle += (1.0 / 800) * Vec3d{frame.positions[i][0], frame.positions[i][1], frame.positions[i][2]};
            speed += (1.0 / 800) * Vec3d{frame.velocities[i][0], frame.velocities[i][1], frame.velocities[i][2]};
        }
        double farthest = 0, agitation = 0;
        for (std::size_t i = 0; i < 800; ++i) {
            farthest = std::max(farthest, length(Vec3d{frame.positions[i][0], frame.positions[i][1], frame.positions[i][2]} - middle));
            const Vec3d v = Vec3d{frame.velocities[i][0], frame.velocities[i][1], frame.velocities[i][2]} - speed;
            agitation += dot(v, v) / 800;
        }
        QVERIFY(farthest < 1.15 * std::cbrt(3 * 5e-9 / (4 * pi)));
        QVERIFY2(std::sqrt(agitation) < 0.03, qPrintable(QString::number(std::sqrt(agitation))));
    }
    /// Neighbours slow each other down, they must not throw each other about.
    void aStickyDropComesToRestWithoutSpeedingUp()
    {
        const auto backend = make_cpu_backend();
        Scene scene = drop_over_plate(1e-10, 0, 1, 300);
        scene.climate.viscosity = 0.5;
        double fastest = 0;
        for (const Frame& frame : frames_at(*backend, scene, {1e-5, 3e-5, 1e-4, 3e-4, 1e-3})) {
            fastest = 0;
            for (const auto& v : frame.velocities) fastest = std::max(fastest, std::hypot(double(v[0]), double(v[1]), double(v[2])));
            QVERIFY2(fastest < 2 * scene.supply.droplets[0].speed, qPrintable(QString("%1 m/s at %2 s").arg(fastest).arg(frame.time)));
        }
        QVERIFY2(fastest < 0.2, qPrintable(QString::number(fastest)));
    }
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
    void noParticlePassesThroughClosedCloth_data()
    {
        QTest::addColumn<double>("speed");
        QTest::addColumn<std::vector<double>>("half_heights");
        for (double speed : {0.0, 1.0, 5.0, 10.0}) {
            QTest::addRow("%g m/s", speed) << speed << std::vector<double>{5e-5};
            QTest::addRow("%g m/s, thick and thin yarns", speed) << speed << std::vector<double>{5e-5, 2.5e-5, 4e-5};
        }
    }
    void noParticlePassesThroughClosedCloth()
    {
        QFETCH(double, speed);
        QFETCH(std::vector<double>, half_heights);
        const auto backend = make_cpu_backend();
        const Frame frame = frames_at(*backend, drop_over_plate(1e-9, 0.5e-3, speed, 300, half_heights), {0.01}).back();
        for (const auto& x : frame.positions) // those far from its edge, past which they may be thrown and cling to the other face
            if (std::abs(x[0]) < 7e-3f && std::abs(x[1]) < 7e-3f) QVERIFY2(x[2] > 0, qPrintable(QString::number(double(x[2]))));
        QCOMPARE(frame.ledger.water_delivered, frame.ledger.water_free + frame.ledger.water_dripped);
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
        const Design design = thick_and_thin();
        const Textile textile = build_textile(design, design.fabrics[0], {0, 0, 17, 19});
        const Scene scene = build_scene(design, textile, design.experiments[0],
                                        plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::draft), 1);
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
        const Design design = thick_and_thin();
        const Textile textile = build_textile(design, design.fabrics[0], {0, 0, 17, 19});
        const Scene scene = build_scene(design, textile, design.experiments[0],
                                        plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::draft), 1);
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

QTEST_APPLESS_MAIN(TestLiquid)
#include "tst_liquid.moc"
