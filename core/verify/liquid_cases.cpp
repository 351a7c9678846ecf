// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The free liquid: drops that swing, rest and fall, against closed forms.
#include "core/base/random.h"
#include "core/sim/droplet.h"
#include "core/verify/fits.h"
#include "core/verify/set_ups.h"
#include "core/verify/verify.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hygroloom {
namespace {

constexpr double temperature = 293.15; // K
constexpr double plate_height = 5e-3;  // m, over the piece of cloth that every scene has

double value(const VerifyValues& values, const std::string& name) { return values.at(name).value; }

/// Free liquid over a small piece of cloth that it never meets.
Scene scene_with(const std::vector<Vec3d>& places, double particle_volume)
{
    Scene scene = bare_scene(1, 1, 2e-3, temperature);
    scene.network_step = scene.calm_network_step = 1.0;
    scene.liquid.places = places;
    scene.liquid.velocities.assign(places.size(), Vec3d{});
    scene.liquid.particle_volume = particle_volume;
    scene.gravity = 0;
    return scene;
}

void put_on_plate(Scene& scene, double contact_angle)
{
    scene.vessel = SceneVessel{{-1, -1, plate_height}, {1, 1, 1}, scene.climate.surface_tension * (1.0 + std::cos(contact_angle))};
}

/// Places a little off their lattice, so that nothing rests on a perfect one.
void disturb(std::vector<Vec3d>& places, double spacing, std::uint64_t start = 1)
{
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto off = [&](std::uint64_t axis) { return 0.5 * spacing * (random_uniform(start, axis, i) - 0.5); };
        places[i] += Vec3d{off(0), off(1), off(2)};
    }
}

/// A ball high over everything.
Scene ball(int particles, double radius, std::uint64_t start = 1)
{
    const double particle_volume = 4.0 / 3.0 * pi * radius * radius * radius / particles, spacing = std::cbrt(particle_volume);
    std::vector<Vec3d> places = droplet_lattice(particles, spacing);
    disturb(places, spacing, start);
    for (Vec3d& p : places) p += Vec3d{0, 0, plate_height + 2 * radius};
    return scene_with(places, particle_volume);
}

/// The cap of a ball by its height and the radius of its base.
struct Cap {
    double base = 0, height = 0;
    double angle() const { return 2.0 * std::atan(height / base); }
};

Cap cap_of(double volume, double contact_angle)
{
    const double c = std::cos(contact_angle);
    const double base = std::sin(contact_angle) * std::cbrt(3.0 * volume / (pi * (2.0 - 3.0 * c + c * c * c)));
    return {base, base * std::tan(0.5 * contact_angle)};
}

/// A drop on a plate, in the shape it would have there at the angle it starts with.
Scene cap_on_plate(int particles, double volume, double start_angle, double contact_angle)
{
    const double particle_volume = volume / particles, spacing = std::cbrt(particle_volume);
    const Cap cap = cap_of(volume, start_angle);
    const Vec3d middle{0, 0, -cap.base / std::tan(start_angle)}; // of the ball that the cap is cut from
    const int across = static_cast<int>(std::ceil(std::max(cap.base, cap.base / std::sin(start_angle)) / spacing)) + 2;
    std::vector<Vec3d> places;
    for (int k = 0; k < static_cast<int>(cap.height / spacing) + 3; ++k)
        for (int j = -across; j < across; ++j)
            for (int i = -across; i < across; ++i) places.push_back(spacing * Vec3d{i + 0.5, j + 0.5, k + 0.5});
    std::stable_sort(places.begin(), places.end(), [&](const Vec3d& a, const Vec3d& b) { return length(a - middle) < length(b - middle); });
    places.resize(static_cast<std::size_t>(particles));
    disturb(places, spacing);
    for (Vec3d& p : places) p.z += plate_height;
    Scene scene = scene_with(places, particle_volume);
    put_on_plate(scene, contact_angle);
    return scene;
}

Vec3d place(const Frame& f, std::size_t i)
{
    return {static_cast<double>(f.positions[i][0]), static_cast<double>(f.positions[i][1]), static_cast<double>(f.positions[i][2])};
}

Vec3d velocity(const Frame& f, std::size_t i)
{
    return {static_cast<double>(f.velocities[i][0]), static_cast<double>(f.velocities[i][1]), static_cast<double>(f.velocities[i][2])};
}

Vec3d middle(const Frame& f)
{
    Vec3d sum;
    for (std::size_t i = 0; i < f.positions.size(); ++i) sum += place(f, i);
    return (1.0 / static_cast<double>(f.positions.size())) * sum;
}

Vec3d mean_velocity(const Frame& f)
{
    Vec3d sum;
    for (std::size_t i = 0; i < f.velocities.size(); ++i) sum += velocity(f, i);
    return (1.0 / static_cast<double>(f.velocities.size())) * sum;
}

/// Root of the mean square of the velocities over their mean.
double agitation(const Frame& f)
{
    const Vec3d mean = mean_velocity(f);
    double sum = 0;
    for (std::size_t i = 0; i < f.velocities.size(); ++i) sum += dot(velocity(f, i) - mean, velocity(f, i) - mean);
    return std::sqrt(sum / static_cast<double>(f.velocities.size()));
}

/// Times from first to last, evenly.
std::vector<double> moments(double first, double last, int count)
{
    std::vector<double> times;
    for (int k = 0; k < count; ++k) times.push_back(first + (last - first) * k / (count - 1));
    return times;
}

/// Least squares of values over x with up to three given functions, and what is left.
struct Fit {
    std::array<double, 3> factors{};
    double rest = 0; ///< sum of squares
};

Fit fit_three(const std::vector<double>& x, const std::vector<double>& y, const std::function<std::array<double, 3>(double)>& functions)
{
    double m[3][4] = {};
    double squares = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const std::array<double, 3> f = functions(x[i]);
        for (std::size_t a = 0; a < 3; ++a) {
            for (std::size_t b = 0; b < 3; ++b) m[a][b] += f[a] * f[b];
            m[a][3] += f[a] * y[i];
        }
        squares += y[i] * y[i];
    }
    double u[3][4];
    std::copy(&m[0][0], &m[0][0] + 12, &u[0][0]);
    for (int a = 0; a < 3; ++a)
        for (int b = a + 1; b < 3; ++b) {
            const double q = u[b][a] / u[a][a];
            for (int c = a; c < 4; ++c) u[b][c] -= q * u[a][c];
        }
    Fit fit;
    for (int a = 2; a >= 0; --a) {
        double sum = u[a][3];
        for (int b = a + 1; b < 3; ++b) sum -= u[a][b] * fit.factors[static_cast<std::size_t>(b)];
        fit.factors[static_cast<std::size_t>(a)] = sum / u[a][a];
    }
    fit.rest = squares;
    for (std::size_t a = 0; a < 3; ++a) fit.rest -= fit.factors[a] * m[a][3];
    return fit;
}

struct Swing {
    double frequency = 0; ///< Hz
    double damping = 0;   ///< s
};

/// The damped swing round a constant that comes nearest, between half and twice the expected frequency.
Swing fit_swing(const std::vector<double>& times, const std::vector<double>& values, double expected)
{
    Swing best;
    double least = std::numeric_limits<double>::infinity();
    for (double f = 0.5 * expected; f < 2.0 * expected; f *= 1.004)
        for (double damping = 0.2 / expected; damping < 40 / expected; damping *= 1.1) {
            const Fit fit = fit_three(times, values, [&](double t) {
                const double e = std::exp(-t / damping);
                return std::array<double, 3>{e * std::cos(2 * pi * f * t), e * std::sin(2 * pi * f * t), 1.0};
            });
            if (fit.rest < least) {
                least = fit.rest;
                best = {f, damping};
            }
        }
    return best;
}

/// How much longer than wide a drop is: 0 for a ball.
double elongation(const Frame& f)
{
    const Vec3d m = middle(f);
    double along = 0, all = 0;
    for (std::size_t i = 0; i < f.positions.size(); ++i) {
        const Vec3d d = place(f, i) - m;
        along += d.z * d.z - 0.5 * (d.x * d.x + d.y * d.y);
        all += dot(d, d);
    }
    return along / all;
}

/// A ball that has come to rest is set swinging between long and flat (Rayleigh 1879).
std::vector<VerifyResult> rayleigh(const VerifyValues& v, Backend& backend)
{
    const double radius = 1e-3 * value(v, "radius_mm");
    Scene scene = ball(static_cast<int>(value(v, "particles")), radius);
    const ClimateParameters& water = scene.climate;
    const double rate = std::sqrt(8.0 * water.surface_tension / (water.density * radius * radius * radius));
    const double period = 2.0 * pi / rate;
    const Frame resting = frames_at(backend, scene, {2.5 * period}).back();
    const Vec3d m = middle(resting), u = mean_velocity(resting);
    for (std::size_t i = 0; i < scene.liquid.places.size(); ++i) {
        const Vec3d d = place(resting, i) - m;
        scene.liquid.places[i] = place(resting, i);
        scene.liquid.velocities[i] = velocity(resting, i) - u + value(v, "amplitude") * rate * Vec3d{-0.5 * d.x, -0.5 * d.y, d.z};
    }
    const std::vector<double> times = moments(0.02 * period, 3.0 * period, 120);
    std::vector<double> values;
    for (const Frame& f : frames_at(backend, scene, times)) values.push_back(elongation(f));
    const Swing swing = fit_swing(times, values, 1.0 / period);
    const double viscous = radius * radius * water.density / (5.0 * water.viscosity);
    return {{"frequency_hz", swing.frequency, 1.0 / period, 0.08 / period},
            {"damping_time_ms", 1e3 * swing.damping, 1e3 * viscous, 0, Rule::at_most}};
}

/// Mean pressure in the inner half of a ball at rest.
double inner_pressure(Backend& backend, int particles, double radius, std::uint64_t start)
{
    Scene scene = ball(particles, radius, start);
    scene.shows_pressure = true;
    const double period = 2.0 * pi * std::sqrt(scene.climate.density * radius * radius * radius / (8.0 * scene.climate.surface_tension));
    double sum = 0;
    long count = 0;
    std::vector<Frame> frames = frames_at(backend, scene, moments(2.0 * period, 4.0 * period, 60));
    frames.erase(frames.begin()); // its mean goes back to the start
    for (const Frame& f : frames) {
        const Vec3d m = middle(f);
        for (std::size_t i = 0; i < f.positions.size(); ++i)
            if (length(place(f, i) - m) < 0.5 * radius) {
                sum += static_cast<double>(f.pressures[i]);
                ++count;
            }
    }
    return sum / static_cast<double>(count);
}

std::vector<VerifyResult> laplace(const VerifyValues& v, Backend& backend)
{
    const double radius = 1e-3 * value(v, "radius_mm");
    const int particles = static_cast<int>(value(v, "particles"));
    const double expected = 2.0 * bare_scene(1, 1, 1e-3, temperature).climate.surface_tension / radius;
    const int starts = static_cast<int>(value(v, "starts"));
    double small = 0, large = 0;
    for (int start = 1; start <= starts; ++start) {
        small += inner_pressure(backend, particles, radius, static_cast<std::uint64_t>(start)) / starts;
        large += inner_pressure(backend, particles, 2 * radius, static_cast<std::uint64_t>(start)) / starts;
    }
    const char* shells = "Particles come to rest in shells, whose stress differs with their number, most below 3 000.";
    const VerifyResult pressure{"pressure_pa", small, expected, 0.05 * expected},
        pressure_of_twice{"pressure_of_twice_the_radius_pa", large, 0.5 * expected, 0.025 * expected};
    std::vector<VerifyResult> results{pressure, pressure_of_twice, {"ratio", small / large, 2.0, 0.06}};
    if (particles < 3000)
        for (VerifyResult& result : results) result = known_miss(result, shells);
    return results;
}

/// The cap with the same middle over the plate and the same mean square distance from its axis.
Cap cap_like(const Frame& f)
{
    const Vec3d m = middle(f);
    double square = 0;
    for (std::size_t i = 0; i < f.positions.size(); ++i) {
        const Vec3d d = place(f, i) - m;
        square += d.x * d.x + d.y * d.y;
    }
    square /= static_cast<double>(f.positions.size());
    // Of a cap of height 1 cut from a ball of radius r: the middle's height and the mean square, both without the ball's size.
    const auto shape = [](double r) {
        const double volume = pi * (3.0 * r - 1.0) / 3.0;
        return std::pair{(4.0 * r - 1.0) / (4.0 * (3.0 * r - 1.0)), 0.5 * pi * (4.0 * r * r / 3.0 - r + 0.2) / volume};
    };
    const double up = m.z - plate_height, wanted = square / (up * up);
    double low = 0.5, high = 1e4; // the flatter the larger
    for (int k = 0; k < 200; ++k) {
        const double r = std::sqrt(low * high);
        const auto [height, mean_square] = shape(r);
        (mean_square / (height * height) < wanted ? low : high) = r;
    }
    const double r = std::sqrt(low * high), height = up / shape(r).first;
    return {height * std::sqrt(std::max(0.0, 2.0 * r - 1.0)), height};
}

Cap mean_cap(const std::vector<Frame>& frames)
{
    Cap mean;
    for (const Frame& f : frames) {
        const Cap cap = cap_like(f);
        mean.base += cap.base / static_cast<double>(frames.size());
        mean.height += cap.height / static_cast<double>(frames.size());
    }
    return mean;
}

std::vector<VerifyResult> sessile(const VerifyValues& v, Backend& backend)
{
    const double angle = radian_from_degree(value(v, "contact_angle_deg")), volume = cubic_metre_from_ul(value(v, "volume_ul"));
    const double start = angle + (0.5 * pi - angle) * value(v, "off_by"); // a drop that starts far off leaps from the plate
    const Scene scene = cap_on_plate(static_cast<int>(value(v, "particles")), volume, start, angle);
    const double time = value(v, "time_s");
    const Cap cap = mean_cap(frames_at(backend, scene, moments(0.8 * time, time, 20))), expected = cap_of(volume, angle);
    return {{"base_radius_mm", 1e3 * cap.base, 1e3 * expected.base, 0.05 * 1e3 * expected.base},
            {"height_mm", 1e3 * cap.height, 1e3 * expected.height, 0.05 * 1e3 * expected.height},
            {"contact_angle_deg", cap.angle() * 180.0 / pi, value(v, "contact_angle_deg"), 6.0}};
}

std::vector<VerifyResult> liquid_rest(const VerifyValues& v, Backend& backend)
{
    const double angle = radian_from_degree(value(v, "contact_angle_deg")), volume = cubic_metre_from_ul(value(v, "volume_ul"));
    const Scene scene = cap_on_plate(static_cast<int>(value(v, "particles")), volume, angle, angle);
    constexpr double settled = 0.1; // s
    const std::vector<Frame> frames =
        frames_at(backend, scene, {settled, settled + 0.5 * value(v, "time_s"), settled + value(v, "time_s")});
    const Vec3d first = middle(frames.front()), last = middle(frames.back());
    const double base = cap_like(frames.front()).base;
    const double growth = cap_like(frames.back()).base - base;
    const VerifyResult drift{"drift_mm", 1e3 * std::hypot(last.x - first.x, last.y - first.y), 0, 1e3 * 0.01 * base},
        base_growth{"base_growth_mm", 1e3 * growth, 0, 1e3 * 0.01 * base},
        speed{"speed_mm_s", 1e3 * agitation(frames.back()), 5.0, 0, Rule::at_most};
    constexpr double least_angle = 60; // degrees, see rattling_share()
    if (value(v, "contact_angle_deg") >= least_angle) return {drift, base_growth, speed};
    const char* rattles = "Below 60 degrees particles rattle at a wall, and the drop creeps.";
    return {drift, known_miss(base_growth, rattles), known_miss(speed, rattles)};
}

/// A column in a box: pressure by depth, and how much the liquid is pressed together.
std::vector<VerifyResult> column(const VerifyValues& v, Backend& backend)
{
    const double depth = 1e-3 * value(v, "depth_mm");
    const int across = static_cast<int>(value(v, "across"));
    const int up = static_cast<int>(value(v, "layers"));
    const double spacing = depth / up;
    std::vector<Vec3d> places;
    for (int k = 0; k < up; ++k)
        for (int j = 0; j < across; ++j)
            for (int i = 0; i < across; ++i)
                places.push_back(spacing * Vec3d{i + 0.5 - 0.5 * across, j + 0.5 - 0.5 * across, k + 0.5} + Vec3d{0, 0, plate_height});
    disturb(places, spacing);
    Scene scene = scene_with(places, spacing * spacing * spacing);
    const double half = 0.5 * across * spacing;
    scene.vessel = SceneVessel{{-half, -half, plate_height}, {half, half, 1}, scene.climate.surface_tension};
    scene.gravity = gravity_acceleration;
    scene.shows_pressure = true;
    std::vector<Frame> frames = frames_at(backend, scene, moments(0.1, 0.2, 20));
    frames.erase(frames.begin()); // its mean goes back to the start
    std::vector<double> heights, pressures;
    double lowering = 0;
    for (const Frame& f : frames) {
        lowering += 2.0 * (middle(f).z - plate_height) / static_cast<double>(frames.size());
        for (std::size_t i = 0; i < f.positions.size(); ++i) {
            const Vec3d p = place(f, i);
            const double height = p.z - plate_height;
            if (height < 3 * spacing || height > depth - 4 * spacing) continue;
            heights.push_back(height);
            pressures.push_back(static_cast<double>(f.pressures[i]));
        }
    }
    const Fit line = fit_three(heights, pressures, [&](double z) { return std::array<double, 3>{1.0, z / depth, 1e-9 * z * z}; });
    const double expected = scene.climate.density * gravity_acceleration * depth;
    return {{"bottom_pressure_pa", line.factors[0], expected, 0.03 * expected},
            {"gradient_pa", -line.factors[1], expected, 0.05 * expected},
            {"shortening_percent", 100.0 * (1.0 - lowering / depth), 0, 1.0}};
}

std::vector<VerifyResult> falling_drop(const VerifyValues& v, Backend& backend)
{
    const double radius = 1e-3 * value(v, "radius_mm"), time = value(v, "time_s");
    Scene scene = ball(static_cast<int>(value(v, "particles")), radius);
    scene.gravity = gravity_acceleration;
    for (Vec3d& p : scene.liquid.places) p.z += gravity_acceleration * time * time;
    const std::vector<Frame> frames = frames_at(backend, scene, {1e-4, time});
    const auto energy = [](const Frame& f) {
        const Vec3d u = mean_velocity(f);
        return 0.5 * dot(u, u) + gravity_acceleration * middle(f).z;
    };
    const double gained = 0.5 * gravity_acceleration * gravity_acceleration * time * time;
    const Vec3d u = mean_velocity(frames.back());
    return {{"speed_m_s", -u.z, gravity_acceleration * time, 1e-4 * gravity_acceleration * time},
            {"sideways_speed_m_s", std::hypot(u.x, u.y), 0, 1e-5},
            {"energy_change_percent", 100.0 * (energy(frames.back()) - energy(frames.front())) / gained, 0, 1.0}};
}

/// Greatest width of a drop that strikes a plate it hardly wets, over its diameter: 0.9 We^(1/4) (Clanet, Beguin, Richard and Quere
/// 2004, J. Fluid Mech. 517, their figure 4; scatter about 10 %).
std::vector<VerifyResult> impact(const VerifyValues& v, Backend& backend)
{
    const double radius = 1e-3 * value(v, "radius_mm"), weber = value(v, "weber");
    Scene scene = ball(static_cast<int>(value(v, "particles")), radius);
    put_on_plate(scene, radian_from_degree(value(v, "contact_angle_deg")));
    const ClimateParameters& water = scene.climate;
    const double speed = std::sqrt(weber * water.surface_tension / (2.0 * radius * water.density));
    scene.liquid.velocities.assign(scene.liquid.places.size(), Vec3d{0, 0, -speed});
    const double capillary = std::sqrt(water.density * radius * radius * radius / water.surface_tension);
    const double spacing = std::cbrt(scene.liquid.particle_volume);
    double widest = 0;
    bool finite = true;
    for (const Frame& f : frames_at(backend, scene, moments(0.2 * capillary, radius / speed + 2.5 * capillary, 60))) {
        std::vector<double> across;
        const Vec3d m = middle(f);
        for (std::size_t i = 0; i < f.positions.size(); ++i) across.push_back(std::hypot(place(f, i).x - m.x, place(f, i).y - m.y));
        std::sort(across.begin(), across.end());
        const double rim = across[across.size() - 1 - across.size() / 100]; // without a stray particle
        finite = finite && std::isfinite(rim);
        widest = std::max(widest, 2.0 * rim + spacing);
    }
    const double expected = 0.9 * std::pow(weber, 0.25);
    return {{"spread", finite ? widest / (2.0 * radius) : std::numeric_limits<double>::quiet_NaN(), expected, 0.15 * expected}};
}

} // namespace

std::vector<VerifyCase> liquid_cases()
{
    const VerifyParameter particles{"particles", 1000, 200, 1e6, ""};
    const VerifyParameter radius{"radius_mm", 1, 0.1, 10, ""};
    const VerifyParameter volume{"volume_ul", 5, 0.01, 100, ""};
    return {
        {"rayleigh",
         "A drop swings between long and flat: frequency, and damping that is not less than water's.",
         {particles, radius, {"amplitude", 0.05, 0.005, 0.3, ""}},
         rayleigh},
        {"laplace",
         "Pressure in a drop at rest and in one of twice its radius.",
         {{"particles", 8000, 200, 1e6, ""}, radius, {"starts", 1, 1, 100, ""}},
         laplace},
        {"sessile",
         "A drop on a smooth plate without gravity settles to the cap of a ball.",
         {particles, volume, {"contact_angle_deg", 90, 20, 160, ""}, {"off_by", 0.3, 0, 1, ""}, {"time_s", 0.1, 0.01, 10, ""}},
         sessile},
        {"liquid_rest",
         "A drop on a smooth plate neither creeps nor heats up.",
         {particles, volume, {"contact_angle_deg", 90, 20, 160, ""}, {"time_s", 0.2, 0.01, 10, ""}},
         liquid_rest},
        {"falling_drop",
         "A drop in free fall keeps its energy and its momentum.",
         {particles, radius, {"time_s", 0.02, 1e-3, 1, ""}},
         falling_drop},
        {"column",
         "A column of water in a box: pressure by depth.",
         {{"depth_mm", 20, 1, 100, ""}, {"layers", 30, 10, 1000, ""}, {"across", 16, 6, 100, ""}},
         column},
        {"impact",
         "A drop strikes a plate that it hardly wets: how far it spreads.",
         {particles, radius, {"weber", 15, 1, 200, ""}, {"contact_angle_deg", 150, 20, 170, ""}},
         impact},
    };
}

} // namespace hygroloom
