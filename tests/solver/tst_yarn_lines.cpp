// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A line's work shared by many threads, which take turns here: it comes out as one thread alone does it, whoever is first.
#include "tests/solver/network.h"

#include <QTest>

#include <random>

using namespace hygroloom;

namespace {

/// Threads that go one after the other through each part of the work.
struct InTurns {
    int count;
    bool last_first;

    int size() const { return count; }
    template <typename F> void all(const F& f) const
    {
        for (int k = 0; k < count; ++k) f(last_first ? count - 1 - k : k);
    }
    template <typename F> bool any(const F& f) const
    {
        bool found = false;
        all([&](int t) { found = f(t) || found; });
        return found;
    }
    void add(std::int64_t* total, std::int64_t own) const { *total += own; }
};

/// Stages that solve single equations, and pairs.
struct OfSingles {};
struct OfPairs {
    static constexpr int columns = 1;
    bool rings = false;

    bool has_rings() const { return rings; }
};

/// Calls work(team) with a team for lines of so many places and a stage; of no threads: one that is alone.
template <typename Stage = OfSingles, typename Work>
void with_team(int threads, bool last_first, int longest, const Work& work, const Stage& stage = {})
{
    const LineNumbers numbers = line_numbers_of(stage);
    std::vector<double> places(Team<InTurns>::room(numbers, longest, std::max(1, threads)) +
                                   static_cast<std::size_t>(Alone::per_place<Stage> * longest),
                               std::nan(""));
    std::vector<double> links(static_cast<std::size_t>(Team<InTurns>::links_room(numbers, threads)), std::nan(""));
    if (threads == 0)
        work(Alone(places.data(), longest));
    else
        work(Team<InTurns>({threads, last_first}, numbers, places.data(), longest, links.data()));
}

const int team_sizes[] = {32, 64, 128, 256, 512};
const int line_lengths[] = {1, 2, 3, 31, 32, 33, 63, 97, 280, 511, 1000, 3500, 5000};

void add_teams_and_lines()
{
    QTest::addColumn<int>("threads");
    QTest::addColumn<int>("places");
    for (int threads : team_sizes)
        for (int places : line_lengths) QTest::addRow("%d threads, %d places", threads, places) << threads << places;
}

double difference(const std::vector<double>& a, const std::vector<double>& b)
{
    double largest = 0, most = 1e-300;
    for (std::size_t i = 0; i < a.size(); ++i) {
        largest = std::max(largest, std::abs(a[i] - b[i]));
        most = std::max(most, std::abs(a[i]));
        if (!(std::abs(a[i] - b[i]) <= 1e300)) return 1e300;
    }
    return largest / most;
}

std::vector<Equation> random_equations(int count, bool by_columns, unsigned seed)
{
    std::mt19937 random(seed);
    const auto number = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
    std::vector<Equation> equations(static_cast<std::size_t>(count));
    for (Equation& e : equations)
        e = {-std::pow(10, number(-8, 1)), std::pow(10, number(-2, 0)), -std::pow(10, number(-8, 1)), number(-1, 1)};
    equations.front().lower = equations.back().upper = 0;
    for (std::size_t i = 0; i < equations.size(); ++i) {
        const double before = by_columns && i > 0 ? equations[i - 1].upper : by_columns ? 0.0 : equations[i].lower;
        const double after = by_columns && i + 1 < equations.size() ? equations[i + 1].lower : by_columns ? 0.0 : equations[i].upper;
        equations[i].pivot -= before + after;
    }
    return equations;
}

std::vector<double> solution(const std::vector<Equation>& equations, int threads, bool last_first)
{
    constexpr int first = 7; // lines begin anywhere
    const auto count = static_cast<int>(equations.size());
    std::vector<double> x(equations.size());
    with_team(threads, last_first, count, [&](const auto& team) {
        team.solve(first, first + count, [&](int i) { return equations[static_cast<std::size_t>(i - first)]; });
        for (int i = 0; i < count; ++i) x[static_cast<std::size_t>(i)] = team.found(first, first + i);
    });
    return x;
}

/// Symmetric but for what each place keeps, as those of two classes that exchange at each place are.
std::vector<PairEquation> random_pairs(int count, unsigned seed, double least_kept = -3)
{
    std::mt19937 random(seed);
    const auto number = [&](double low, double high) { return std::pow(10, std::uniform_real_distribution<double>(low, high)(random)); };
    std::vector<PairEquation> equations(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < equations.size(); ++i) {
        PairEquation& e = equations[i];
        if (i > 0) e.lower = equations[i - 1].upper;
        if (i + 1 < equations.size()) e.upper = {-number(-8, 1), -number(-8, 1)};
        const double across = number(-3, 2);
        e.pivot = {number(least_kept, least_kept + 3) + across - e.lower.first - e.upper.first, -across, -across,
                   number(least_kept, least_kept + 3) + across - e.lower.second - e.upper.second};
        e.right = {number(-3, 0) - 0.5, number(-3, 0) - 0.5};
    }
    return equations;
}

/// First numbers, then second ones.
std::vector<double> solution(const std::vector<PairEquation>& equations, int threads, bool last_first)
{
    constexpr int first = 7;
    const auto count = static_cast<int>(equations.size());
    std::vector<double> x(2 * equations.size());
    with_team<OfPairs>(threads, last_first, count, [&](const auto& team) {
        team.solve_pairs(
            first, first + count,
            [&](int i, bool& open) {
                open = open || i == first + count - 1;
                return equations[static_cast<std::size_t>(i - first)];
            },
            [&](int i, const Pair& found) {
                x[static_cast<std::size_t>(i - first)] = found.first;
                x[static_cast<std::size_t>(count + i - first)] = found.second;
            });
    });
    return x;
}

/// The same, with the last place joined to the first.
std::vector<double> ring_solution(const std::vector<PairEquation>& equations, const Pair& joint, int threads, bool last_first)
{
    constexpr int first = 7;
    const auto count = static_cast<int>(equations.size());
    std::vector<double> x(2 * equations.size());
    const auto row = [&](int i, bool& open) {
        open = true;
        const PairEquation& own = equations[static_cast<std::size_t>(i - first)];
        const double leaves = (i == first ? 1.0 : 0.0) - (i + 1 == first + count ? 1.0 : 0.0);
        return RingEquation{own.lower, own.pivot, own.upper, {own.right, diagonal({leaves, leaves})}};
    };
    const auto use = [&](int i, const Pair& found) {
        x[static_cast<std::size_t>(i - first)] = found.first;
        x[static_cast<std::size_t>(count + i - first)] = found.second;
    };
    with_team(
        threads, last_first, count, [&](const auto& team) { team.solve_ring(first, first + count, row, joint, use); }, OfPairs{true});
    return x;
}

/// The largest part of an equation that a solution leaves open, over its terms. With a joint, the last place meets the first.
double left_open(const std::vector<PairEquation>& equations, const std::vector<double>& x, const Pair& joint = {})
{
    const std::size_t n = equations.size();
    double largest = 0;
    for (std::size_t i = 0; i < n; ++i) {
        PairEquation e = equations[i];
        for (const bool meets : {i == 0, i + 1 == n}) {
            if (!meets) continue;
            e.pivot.a += joint.first;
            e.pivot.d += joint.second;
            const std::size_t other = i == 0 ? n - 1 : 0;
            e.right = {e.right.first + joint.first * x[other], e.right.second + joint.second * x[n + other]};
        }
        const double before[] = {i > 0 ? x[i - 1] : 0.0, i > 0 ? x[n + i - 1] : 0.0};
        const double next[] = {i + 1 < n ? x[i + 1] : 0.0, i + 1 < n ? x[n + i + 1] : 0.0};
        const double own[] = {x[i], x[n + i]};
        const double open[] = {
            e.pivot.a * own[0] + e.pivot.b * own[1] + e.lower.first * before[0] + e.upper.first * next[0] - e.right.first,
            e.pivot.c * own[0] + e.pivot.d * own[1] + e.lower.second * before[1] + e.upper.second * next[1] - e.right.second};
        const double terms = (e.pivot.a + e.pivot.d) * (std::abs(own[0]) + std::abs(own[1])) + 1e-3;
        largest = std::max({largest, std::abs(open[0]) / terms, std::abs(open[1]) / terms});
    }
    return largest;
}

/// Places that keep 0..1, what they hold, and what went over each to the next.
struct Holds {
    std::vector<double> held, passed;

    explicit Holds(int places) : held(static_cast<std::size_t>(places)), passed(held.size(), 0.0) {}
    void carry(int threads, bool last_first)
    {
        const auto places = static_cast<int>(held.size());
        const auto at = [](int i) { return static_cast<std::size_t>(i); };
        with_team(threads, last_first, places, [&](const auto& team) {
            team.carry(
                0, places,
                [&](int i) {
                    const double kept = std::clamp(held[at(i)], 0.0, 1.0), over = held[at(i)] - kept;
                    held[at(i)] = kept;
                    return over;
                },
                [&](int from, int to, double amount) { passed[at(std::min(from, to))] += from < to ? amount : -amount; },
                [&](int i, double amount) { held[at(i)] += amount; });
        });
    }
};

/// A yarn between wet and dry, cold and warm, which hangs in a bath.
Network hanging_yarn(int places)
{
    YarnParameters yarn = cotton();
    yarn.fall = 1e-4;
    yarn.open_vapour = 1e-12;
    Network n(1, places, yarn, yarn);
    const ClimateParameters climate = room();
    std::mt19937 random(static_cast<unsigned>(places));
    std::uniform_real_distribution<double> share(0, 1);
    n.fed.assign(n.liquid.size(), 0);
    n.fed[0] = 1;
    for (std::size_t i = 0; i < static_cast<std::size_t>(places); ++i) {
        const double full = climate.density * n.pores[i];
        n.liquid[i] = i == 0 ? full : i % 50 < 20 ? full * share(random) : 0.0;
        n.warmth[i] = i % 30 < 10 ? share(random) : 0.0;
        n.vapour[i] = climate.vapour * pore_air(n.pores[i], n.liquid[i], climate.density) * (1 + 0.3 * share(random));
        n.uptake[i] = 100 * n.pores[i] * share(random);
    }
    return n;
}

void go_along(Network& n, int threads, bool last_first)
{
    ClimateParameters climate = room();
    climate.flow.slope = 0.02;
    const Segments s = n.views();
    with_team(threads, last_first, n.picks, [&](const auto& team) {
        for (double dt : {1e-3, 0.1, 10.0}) {
            WickAlongYarn{s, climate, dt, gravity_acceleration, 0}(team, 0);
            ConductAlongYarn{s, climate, dt}(team, 0);
            DiffuseVapourAlongYarn{s, climate, dt, 8e-8, true}(team, 0);
        }
    });
}

} // namespace

class TestYarnLines : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void eliminationInChunksFindsTheSameSolution_data() { add_teams_and_lines(); }
    void eliminationInChunksFindsTheSameSolution()
    {
        QFETCH(int, threads);
        QFETCH(int, places);
        for (bool by_columns : {false, true})
            for (unsigned seed = 0; seed < 5; ++seed) {
                const std::vector<Equation> equations = random_equations(places, by_columns, seed);
                const std::vector<double> alone = solution(equations, 0, false), shared = solution(equations, threads, false);
                QVERIFY2(difference(alone, shared) < 1e-12, qPrintable(QString::number(difference(alone, shared))));
                QVERIFY(shared == solution(equations, threads, true));
            }
    }
    void pairsAreSolvedByAnyNumberOfThreads_data() { add_teams_and_lines(); }
    void pairsAreSolvedByAnyNumberOfThreads()
    {
        QFETCH(int, threads);
        QFETCH(int, places);
        for (unsigned seed = 0; seed < 5; ++seed) {
            const std::vector<PairEquation> equations = random_pairs(places, seed);
            const std::vector<double> alone = solution(equations, 0, false), shared = solution(equations, threads, false);
            QVERIFY2(left_open(equations, alone) < 1e-12, qPrintable(QString::number(left_open(equations, alone))));
            QVERIFY2(difference(alone, shared) < 1e-11, qPrintable(QString::number(difference(alone, shared))));
            QVERIFY(shared == solution(equations, threads, true));
        }
    }
    void ringsAreSolvedByAnyNumberOfThreads_data() { add_teams_and_lines(); }
    void ringsAreSolvedByAnyNumberOfThreads()
    {
        QFETCH(int, threads);
        QFETCH(int, places);
        const std::vector<PairEquation> equations = random_pairs(places, 1);
        for (const Pair joint : {Pair{0.3, 2}, Pair{1e3, 0}, Pair{0, 0}}) {
            const std::vector<double> alone = ring_solution(equations, joint, 0, false),
                                      shared = ring_solution(equations, joint, threads, false);
            QVERIFY2(left_open(equations, alone, joint) < 1e-12, qPrintable(QString::number(left_open(equations, alone, joint))));
            QVERIFY2(difference(alone, shared) < 1e-11, qPrintable(QString::number(difference(alone, shared))));
            QVERIFY(shared == ring_solution(equations, joint, threads, true));
        }
        QVERIFY(difference(ring_solution(equations, {}, threads, false), solution(equations, threads, false)) < 1e-12);
        const std::vector<PairEquation> full = random_pairs(places, 2, -9); // as full pores, which hardly keep anything
        for (int size : {0, threads}) {
            const double left = left_open(full, ring_solution(full, {0.3, 2}, size, false), {0.3, 2});
            QVERIFY2(left < 1e-9, qPrintable(QString::number(left))); // 2e-10 here, an open line 6e-11; solve() repeats it
        }
    }
    /// As a GPU lays them out.
    void columnsHoldANumberForEachPlace_data() { add_teams_and_lines(); }
    void columnsHoldANumberForEachPlace()
    {
        QFETCH(int, threads);
        QFETCH(int, places);
        const auto work = [&](const auto& team) {
            const auto numbers = team.columns(OfPairs::columns, places);
            for (int i = 0; i < places; ++i) numbers(0, i) = i;
            for (int i = 0; i < places; ++i) QCOMPARE(numbers(0, i), static_cast<double>(i));
        };
        for (bool rings : {false, true}) with_team(threads, false, places, work, OfPairs{rings});
    }
    void pairsWithNothingOpenStayAsTheyAre()
    {
        const std::vector<PairEquation> equations = random_pairs(97, 1);
        for (int threads : {0, 32})
            with_team<OfPairs>(threads, false, 97, [&](const auto& team) {
                int used = 0;
                const auto row = [&](int i, bool&) { return equations[static_cast<std::size_t>(i)]; };
                QVERIFY(!team.solve_pairs(0, 97, row, [&](int, const Pair&) { ++used; }));
                QCOMPARE(used, 0);
            });
    }
    void whatPlacesCannotKeepIsPassedOnExactly_data() { add_teams_and_lines(); }
    void whatPlacesCannotKeepIsPassedOnExactly()
    {
        QFETCH(int, threads);
        QFETCH(int, places);
        constexpr double part = 1.0 / (1 << 20); // so that sums are exact
        for (double middle : {0.1, 0.5, 0.9}) {
            Holds before(places);
            std::mt19937 random(static_cast<unsigned>(places));
            double all = 0;
            for (double& held : before.held)
                all += held = std::round((middle + std::uniform_real_distribution<double>(-0.9, 0.9)(random)) / part) * part;
            if (all < 0 || all > places) continue; // there is no way to keep it
            Holds after = before, other = before;
            after.carry(threads, false);
            double left = 0;
            for (std::size_t i = 0; i < after.held.size(); ++i) {
                left += after.held[i];
                QVERIFY(after.held[i] >= 0 && after.held[i] <= 1);
                QCOMPARE(after.held[i], before.held[i] + (i > 0 ? after.passed[i - 1] : 0.0) - after.passed[i]);
            }
            QVERIFY(left == all);
            QCOMPARE(after.passed.back(), 0.0);
            other.carry(threads, true);
            QVERIFY(other.held == after.held && other.passed == after.passed);
        }
    }
    void aFullLinePassesOnAllTheWay() // what comes first has its place at the other end
    {
        for (int threads : {0, 32, 256}) {
            Holds full(1000);
            std::fill(full.held.begin(), full.held.end(), 1.0);
            full.held.front() = 1.5;
            full.held.back() = 0.25;
            full.carry(threads, false);
            for (std::size_t i = 0; i < 1000; ++i) QCOMPARE(full.held[i], i < 999 ? 1.0 : 0.75);
            for (std::size_t i = 0; i < 999; ++i) QCOMPARE(full.passed[i], 0.5);
        }
    }
    void yarnsFareTheSameWithATeam_data() { add_teams_and_lines(); }
    void yarnsFareTheSameWithATeam()
    {
        QFETCH(int, threads);
        QFETCH(int, places);
        Network alone = hanging_yarn(places), team = alone, other = alone;
        go_along(alone, 0, false);
        go_along(team, threads, false);
        go_along(other, threads, true);
        for (auto values : {&Network::liquid, &Network::warmth, &Network::vapour, &Network::flux, &Network::supplied, &Network::evaporated,
                            &Network::released, &Network::lost}) {
            QVERIFY2(difference(alone.*values, team.*values) < 1e-12, qPrintable(QString::number(difference(alone.*values, team.*values))));
            QVERIFY(other.*values == team.*values);
        }
    }
    void errorsAddUpToTheSame()
    {
        Network n = hanging_yarn(280);
        YarnTotals found[2];
        for (int k : {0, 1}) {
            const std::size_t all = n.liquid.size();
            std::vector<double> rates(3 * all, 0.0), before(3 * all, 0.0);
            double *rate = rates.data(), *was = before.data();
            with_team(128 * k, false, n.picks, [&](const auto& team) {
                EstimateWicking{n.views(), {rate, 0.1, 0.2, true}, was, &found[k].wicking_error}(team, 0);
                EstimateExchange{n.views(), {rate + all, 0.1, 0.2, true}, {rate + 2 * all, 0.1, 0.2, true}, was + all, was + 2 * all,
                                 &found[k]}(team, 0);
            });
        }
        QVERIFY(found[0].wicking_error > 0 && found[0].heat_error > 0);
        QCOMPARE(found[1].wicking_error, found[0].wicking_error);
        QCOMPARE(found[1].bound_error, found[0].bound_error);
        QCOMPARE(found[1].heat_error, found[0].heat_error);
    }
};

QTEST_APPLESS_MAIN(TestYarnLines)
#include "tst_yarn_lines.moc"
