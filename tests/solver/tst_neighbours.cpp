// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Particles of the free liquid and their neighbours, against brute force.
#include "core/base/random.h"
#include "core/solver/cpu_executor.h"
#include "core/solver/solver.h"

#include <QTest>

#include <algorithm>

using namespace hygroloom;

namespace {

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

} // namespace

class TestNeighbours : public QObject {
    Q_OBJECT
private Q_SLOTS:
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
};

QTEST_APPLESS_MAIN(TestNeighbours)
#include "tst_neighbours.moc"
