// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Which particles are near each other: a step's start, cells, and lists of neighbours that last for several steps.
#pragma once

#include "core/solver/particles.h"
#include "core/solver/steps/ordered_bits.h"

namespace hygroloom::inline HL_PRECISION {

/// Of a spacing, in which displacements are counted.
constexpr int parts_of_spacing = 1 << 20;

/// What neighbours read, as a step finds it, and how far it is from where neighbours were listed. The dead count for nothing
/// from here on; returns how many they are.
struct BeginStep {
    Particles p;
    Real kept;           ///< of the pressure
    int* moved;          ///< greatest displacements towards x, y, z, -x, -y and -z, in parts of the spacing
    std::int64_t* total; ///< dead
    HL_FN std::int64_t operator()(int i) const
    {
        if (!p.alive[i]) {
            p.place[i] = p.standing[i] = p.predicted[i] = far_away();
            return 1;
        }
        const Vec3 &x = p.position[i], &v = p.velocity[i];
        p.place[i] = {x.x, x.y, x.z, kept * p.place[i].w};
        p.motion[i] = {v.x, v.y, v.z, p.size(i)};
        p.standing[i] = {x.x, x.y, x.z, p.size(i)};
        const Real way[3] = {x.x - p.listed_x[i], x.y - p.listed_y[i], x.z - p.listed_z[i]};
        int whole[6];
        for (int k = 0; k < 3; ++k) {
            const Real parts = way[k] * (Real(parts_of_spacing) / p.spacing), most = Real(1 << 30);
            whole[k] = static_cast<int>(parts > -most ? parts < most ? parts : most : -most);
            whole[3 + k] = -whole[k];
        }
        atomic_max_of_all(moved, whole);
        return 0;
    }
};

/// The greatest displacement since neighbours were listed, relative to that of the middle.
struct FindFarthestMoved {
    Particles p;
    const int* moved; ///< see BeginStep
    int* farthest;    ///< bits of its square, in spacings; positive, so they order like integers
    HL_FN void operator()(int i) const
    {
        if (!p.alive[i]) return;
        const Vec3 middle{middle_moved(0), middle_moved(1), middle_moved(2)};
        const Vec3 way = (Real(1) / p.spacing) * (p.position[i] - Vec3{p.listed_x[i], p.listed_y[i], p.listed_z[i]} - middle);
        atomic_max_of_all(farthest, ordered_bits(static_cast<float>(dot(way, way))));
    }
    HL_FN Real middle_moved(int axis) const
    {
        return static_cast<Real>((0.5 * moved[axis] - 0.5 * moved[axis + 3]) / parts_of_spacing) * p.spacing;
    }
};

struct FindCell {
    Particles p;
    const CellGrid* grid;
    HL_FN void operator()(int i) const
    {
        const CellGrid& g = *grid;
        const Vec3& x = p.position[i];
        g.key[i] = p.alive[i] ? (g.cell_z(x.z) * g.ny + g.cell_y(x.y)) * g.nx + g.cell_x(x.x) : g.cells();
    }
};

/// The cells between which particles are, as maxima: of minus x, y and z, and of x, y and z.
struct FindBox {
    Particles p;
    const CellGrid* grid;
    int* box;
    HL_FN void operator()(int i) const
    {
        if (!p.alive[i]) return;
        const CellGrid& g = *grid;
        const Vec3& x = p.position[i];
        const int cell[3] = {g.whole_at_x(x.x), g.whole_at_y(x.y), g.whole_at_z(x.z)};
        const int ends[6] = {-cell[0], -cell[1], -cell[2], cell[0], cell[1], cell[2]};
        atomic_max_of_all(box, ends);
    }
};

/// Brings particles into cell order. What lies behind the living is far away from then on.
struct Reorder {
    const int* order;
    const int* key;
    const int* dead_key;
    Particles p;
    Particles to;
    static constexpr bool wide = true;

    HL_FN void operator()(int i) const
    {
        const int from = order[i];
        SortedFields<Pointer>::each(
            [&](const auto&, const auto& array, const auto& sorted) {
                if (!is_place(&array) && array) copy(sorted[i], array[from]);
            },
            p, to);
        const bool lives = key[from] != *dead_key;
        to.alive[i] = lives;
        const Vec3 &x = p.position[from], &v = p.velocity[from];
        to.place[i] = lives ? Quad{x.x, x.y, x.z, p.place[from].w} : far_away();
        to.motion[i] = {v.x, v.y, v.z, to.size(i)};
        to.standing[i] = {to.place[i].x, to.place[i].y, to.place[i].z, to.size(i)};
        to.predicted[i] = far_away(); // a living one's is foreseen before anyone asks for it
        to.listed_x[i] = x.x;
        to.listed_y[i] = x.y;
        to.listed_z[i] = x.z;
    }

private:
    /// The one array that is not copied: each particle's place is found anew.
    HL_FN bool is_place(const void* array) const { return array == &p.place; }
    template <typename T> HL_FN static void copy(T& to, const T& from)
    {
        if constexpr (sizeof(T) > sizeof(Quad))
            copy_together(to, from);
        else
            to = from;
    }
};

/// Lists the neighbours of each particle; particles are in the order of cells.
struct FindNeighbours {
    Particles p;
    const CellGrid* grid;
    const Real* skin; ///< m, by which neighbours are listed beyond where they count
    static constexpr bool wide = true;

#if HL_LANE_IS_THREAD
    HL_FN void operator()(int i) const { list(i, p.near + begin_of_list(i, most_near), p.distant + begin_of_list(i, most_distant)); }
#else
    void operator()(int i) const { (*this)(i, i + 1); }
    /// Lists one close behind the other. Where they begin depends on which thread lists what; what they hold does not.
    void operator()(int first, int last) const
    {
        std::int64_t near = std::int64_t(first) * most_near, distant = std::int64_t(first) * most_distant;
        for (int i = first; i < last; ++i) {
            p.near_first[i] = static_cast<int>(near / lanes);
            p.distant_first[i] = static_cast<int>(distant / lanes);
            list(i, p.near + near, p.distant + distant);
            near += p.near_count[i];
            distant += p.distant_count[i];
        }
    }
#endif

private:
    HL_FN void list(int i, int* near_slots, int* distant_slots) const
    {
        const Vec3 x{p.listed_x[i], p.listed_y[i], p.listed_z[i]};
        const Real near_reach = p.support + *skin, reach = p.reach + *skin, reach2 = reach * reach, support2 = near_reach * near_reach;
        SlotList near{near_slots, most_near}, distant{distant_slots, most_distant}; // too short only where many are pressed together
        for_candidates({*grid, x, reach}, i, [&](const auto& wanted, const auto& j, const Pack& distance2) {
            const auto others = wanted & (distance2 < reach2);
            list_lanes(others & (distance2 < support2), others & (distance2 >= support2), j, near, distant);
        });
        fill_up(near, slot_of(p.room));
        fill_up(distant, slot_of(p.room));
        p.near_count[i] = near.count;
        p.distant_count[i] = distant.count;
    }
    /// Particles side by side, from a row of cells.
    struct Run {
        int first, end;
    };
    /// The cells that the reach of a place may touch.
    struct Cells {
        CellGrid g;
        Vec3 x;
        Real reach;
        int y0, y1, z0, z1;

        HL_FN Cells(const CellGrid& grid, const Vec3& place, Real far) : g(grid), x(place), reach(far)
        {
            y0 = g.inside(g.cell_y(x.y - reach), g.ny), y1 = g.inside(g.cell_y(x.y + reach), g.ny);
            z0 = g.inside(g.cell_z(x.z - reach), g.nz), z1 = g.inside(g.cell_z(x.z + reach), g.nz);
        }
        HL_FN Real gap_y(int y) const { return g.gap(x.y - g.origin.y, y + g.first_y, g.whole_y); }
        HL_FN Real gap_z(int z) const { return g.gap(x.z - g.origin.z, z + g.first_z, g.whole_z); }
        /// Cells along x lie side by side, and so do their particles. Of a row that far away the reach only touches the middle; none if it
        /// is farther.
        HL_FN Run run(int y, int z) const
        {
            const Real far_y = gap_y(y), far_z = gap_z(z), left = reach * reach - far_y * far_y - far_z * far_z;
            if (!(left > 0)) return {0, 0};
            const Real half = root(left);
            const int row = (z * g.ny + y) * g.nx;
            return {g.start[row + g.inside(g.cell_x(x.x - half), g.nx)], g.start[row + g.inside(g.cell_x(x.x + half), g.nx) + 1]};
        }
    };

#if HL_LANE_IS_THREAD
    /// Each lane looks at a row of cells; then all go through what they have found together, whole packs whatever each has.
    template <typename Visit> HL_FN void for_candidates(const Cells& cells, int i, const Visit& visit) const
    {
        const int wide = cells.y1 - cells.y0 + 1, rows = wide * (cells.z1 - cells.z0 + 1);
        const Real per_wide = inverse(Real(wide));
        for (int first = 0, end = largest_beside(rows); first < end; first += lanes) {
            const int row = first + own_lane(), plane = static_cast<int>((Real(row) + Real(0.5)) * per_wide);
            const Run own = row < rows ? cells.run(cells.y0 + row - plane * wide, cells.z0 + plane) : Run{0, 0};
            const int before_end = sum_up_to_lane(own.end - own.first), all = of_lane(before_end, lanes - 1);
            const int first_less_before = own.end - before_end;
            const auto candidate = [&](int k) { return k + of_lane(first_less_before, lane_reaching(before_end, k)); };
            int j = candidate(own_lane());
            Quad other = p.standing[own_lane() < all ? j : i];
            for (int k = own_lane(), left = largest_beside(all); left > 0; left -= lanes, k += lanes) {
                const int next_j = candidate(k + lanes);
                const Quad next = p.standing[k + lanes < all ? next_j : i]; // is on its way while this one is looked at
                const Vec3 d = cells.x - Vec3{other.x, other.y, other.z};
                visit(k < all && j != i, j, dot(d, d));
                j = next_j;
                other = next;
            }
        }
    }
    /// The first lane up to whose own sum there are more than k.
    HL_FN static int lane_reaching(int sum, int k)
    {
        int lane = 0;
        for (int half = lanes / 2; half > 0; half /= 2)
            if (of_lane(sum, lane + half - 1) <= k) lane += half;
        return lane;
    }
#else
    static constexpr int most_runs = 64; // cells are no smaller than half the reach
    template <typename Visit> HL_FN void for_candidates(const Cells& cells, int i, const Visit& visit) const
    {
        Run runs[most_runs + 1];
        const int run_count = find_runs(cells, runs);
        Run now = runs[0];
        for (int run = 0; run < run_count;) {
            const int j = now.first;
            const Vec3& x = cells.x;
            const Pack dx = x.x - load(p.listed_x + j), dy = x.y - load(p.listed_y + j), dz = x.z - load(p.listed_z + j);
            visit(lanes_below(now.end - j) & lanes_but(i - j), j, dx * dx + dy * dy + dz * dz);
            // Runs are short: without branches from one to the next.
            const Run next = runs[run + 1];
            const bool ends = j + lanes >= now.end;
            run += ends;
            now.first = ends ? next.first : j + lanes;
            now.end = ends ? next.end : now.end;
        }
    }
    /// Those with particles; behind them stands an empty one. Rows beside each other along y are the lanes of a pack.
    static int find_runs(const Cells& cells, Run* runs)
    {
        const int wide = cells.y1 - cells.y0 + 1;
        Pack far_y{};
        for (int lane = 0; lane < wide; ++lane) far_y[lane] = cells.gap_y(cells.y0 + lane);
        int count = 0;
        for (int z = cells.z0; z <= cells.z1; ++z) {
            const Real far_z = cells.gap_z(z);
            const Pack left = cells.reach * cells.reach - far_z * far_z - far_y * far_y, half = root(positive(left));
            const Slots first = cells_x(cells, cells.x.x - half), last = cells_x(cells, cells.x.x + half);
            for (int lane = 0; lane < wide; ++lane) {
                const int* row = cells.g.start + (z * cells.g.ny + cells.y0 + lane) * cells.g.nx;
                runs[count] = {row[first[lane]], row[last[lane] + 1]};
                count += int(left[lane] > 0) & int(runs[count].first < runs[count].end);
            }
        }
        runs[count] = {0, 0};
        return count;
    }
    /// The cells that places are in along x, as inside(cell_x()) has one of them.
    static Slots cells_x(const Cells& cells, const Pack& x)
    {
        const CellGrid& g = cells.g;
        const Pack place = positive((x - g.origin.x) * (narrower * g.per_size)), end = Pack{} + Real(g.whole_x - 1);
        const Slots cell = (__builtin_convertvector(place < end ? place : end, Slots) >> g.shift) - g.first_x;
        const Slots low = cell > 0 ? cell : Slots{}, high = Slots{} + (g.nx - 1);
        return low < high ? low : high;
    }
#endif
};

/// The slots of a particle's near neighbours.
HL_FN const int* near_of(const Particles& p, int i)
{
    return p.near + (HL_LANE_IS_THREAD ? begin_of_list(i, most_near) : std::int64_t(p.near_first[i]) * lanes);
}
HL_FN const int* distant_of(const Particles& p, int i)
{
    return p.distant + (HL_LANE_IS_THREAD ? begin_of_list(i, most_distant) : std::int64_t(p.distant_first[i]) * lanes);
}

/// What near pairs keep as long as a step lasts.
HL_FN Real* slope_of(const Particles& p, const int* slots) { return p.slope + (slots - p.near); }

/// Lists lie one close behind the other, and memory is fetched this number of slots beyond the own: for near neighbours those of the next
/// three particles, for distant ones of the next.
constexpr int slots_ahead = 128, slots_per_line = 64 / int(sizeof(int));

/// Calls visit(slots) with one pack after the other of the near neighbours of i; with_slopes if it asks for slope_of() them.
template <bool with_slopes = false, typename F> HL_FN void for_neighbours(const Particles& p, int i, const F& visit)
{
    const int* slots = near_of(p, i);
    const int count = p.near_count[i];
    HL_UNROLL_WHOLE
    for (int k = 0; k < usual_near; k += slots_per_line) {
        bring(slots + count + slots_ahead + k);
        if (with_slopes) bring(slope_of(p, slots) + count + slots_ahead + k);
    }
    HL_UNROLL(4)
    for (int k = 0; k < count; k += lanes) visit(slots + k * elements_beside);
}

/// The same with the distant neighbours of i.
template <typename F> HL_FN void for_distant_neighbours(const Particles& p, int i, const F& visit)
{
    const int* slots = distant_of(p, i);
    const int count = p.distant_count[i];
    HL_UNROLL_WHOLE
    for (int k = 0; k < usual_distant; k += slots_per_line) bring(slots + count + slots_ahead + k);
    HL_UNROLL(4)
    for (int k = 0; k < count; k += lanes) visit(slots + k * elements_beside);
}

} // namespace hygroloom::inline HL_PRECISION
