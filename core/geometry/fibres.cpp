// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A fibre's place in its yarn is (rank, angle): the angle turns with the twist, the rank, the share of fibre area that lies further in,
// runs to and fro between axis and surface at constant speed (ideal migration: Hearle, Grosberg and Backer 1969), so that with evenly
// spread phases every cross-section has the given packing.
#include "core/geometry/fibres.h"

#include "core/base/random.h"
#include "core/base/units.h"
#include "core/design/flyaway.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

constexpr double golden_angle = 2.399963229728653; // 2 pi (1 - 1/golden ratio): the most even spread of angles
constexpr double turns_per_migration = 4;          // from the axis to the surface and back
constexpr double untwisted_migration = 5e-3;       // m, where there is no twist
constexpr double densest_core = 0.9;               // hexagonal packing is 0.907
constexpr double loop_flank = 1.0;                 // half bases in which the fibre comes up to the skin
constexpr double hair_root = 0.7;                  // share of the way from the axis to the skin

enum Draw : std::uint64_t { draw_phase, draw_angle, draw_loop, draw_hair };

std::uint64_t draw_index(Draw what, int part, std::int64_t number)
{
    return (static_cast<std::uint64_t>(what) << 60) + (static_cast<std::uint64_t>(part) << 56) +
           static_cast<std::uint64_t>(number + (std::int64_t(1) << 50));
}

std::uint64_t stream_of(const Textile& textile, YarnKind kind, int yarn)
{
    const int absolute = (kind == YarnKind::warp ? textile.first_end : textile.first_pick) + yarn;
    return 2 * static_cast<std::uint64_t>(static_cast<std::uint32_t>(absolute)) + (kind == YarnKind::warp ? 0 : 1);
}

/// Radius of one of several circles in a ring inside the unit circle.
double ply_radius(int plies)
{
    if (plies < 2) return 1;
    const double s = std::sin(pi / plies);
    return s / (1 + s);
}

double equivalent_radius(const YarnType& type) { return std::sqrt(type.area / pi); }

/// How much denser a yarn's axis is than its mean; the surface is as much less dense.
double core_density(const YarnType& type) { return std::clamp(densest_core / type.packing_round_core() - 1, 0.0, 0.5); }

/// Squared share of a single yarn's radius that its core takes.
double core_hole(const YarnType& type)
{
    const double ply = ply_radius(type.plies);
    return std::min(0.9, type.packing * type.core / (type.plies * ply * ply));
}

/// Squared share of the radius that a rank has: rho2 (1 + core) - core rho4 = rank, for a packing that falls as 1 + core (1 - 2 rho2).
template <typename Number> Number squared_radius(Number core, Number rank)
{
    if (core <= 0) return rank;
    const Number sum = 1 + core;
    return (sum - std::sqrt(std::max(Number(0), sum * sum - 4 * core * rank))) / (2 * core);
}

/// Mean of the fibres' length over the yarn's; slope is the tangent of the helix angle at the surface.
double helix_lengthening(double slope, double core, double hole)
{
    constexpr int steps = 64;
    double sum = 0;
    for (int i = 0; i < steps; ++i) sum += std::sqrt(1 + slope * slope * (hole + (1 - hole) * squared_radius(core, (i + 0.5) / steps)));
    return sum / steps;
}

double length_factor(const Textile& textile, YarnKind kind, const YarnType& type)
{
    if (type.length_per_pitch.size() == 1) return type.length_per_pitch[0];
    double sum = 0;
    const YarnSystem& crossed = textile.system(other_kind(kind));
    for (std::uint8_t other : crossed.order) sum += type.length_per_pitch[other];
    return sum / static_cast<double>(crossed.order.size());
}

/// Yarn length from the fabric's crossing 0, crimp taken evenly.
struct Along {
    double span = 0; ///< m of yarn per crossing
    int origin = 0;
    double at(double crossings_from_edge) const { return (origin + crossings_from_edge) * span; }
};
Along along_axis(const Textile& textile, YarnKind kind, int yarn)
{
    const double factor = length_factor(textile, kind, textile.type(kind, yarn));
    return {textile.system(other_kind(kind)).pitch * factor, kind == YarnKind::warp ? textile.first_pick : textile.first_end};
}

/// Where hair number k of a yarn is rooted.
double hair_place(const FibreOptions& options, std::uint64_t stream, double density, std::int64_t k)
{
    return (static_cast<double>(k) + random_uniform(options.seed, stream, draw_index(draw_hair, 0, k))) / density;
}

/// Distance along direction (sine, cosine), scaled by the half axes, to a racetrack's skin, over that to the ellipse inside it.
float skin_over_ellipse(float half_width, float half_height, float sine, float cosine)
{
    const float flat = half_width - half_height;
    if (flat <= 1e-3f * half_height) return 1;
    const float x = std::abs(half_width * sine), y = std::abs(half_height * cosine);
    if (half_height * x <= flat * y) return half_height / y; // through the flat
    const float b = flat * x, a = x * x + y * y, c = flat * flat - half_height * half_height;
    return (b + std::sqrt(std::max(0.0f, b * b - a * c))) / a;
}

/// To and fro between 0 and 1, once per unit.
float triangle_wave(float t)
{
    t -= std::floor(t);
    return t < 0.5f ? 2 * t : 2 - 2 * t;
}

} // namespace

double packing_at(const YarnType& type, double squared) { return type.packing_round_core() * (1 + core_density(type) * (1 - 2 * squared)); }

double drawn_fibre_radius(const YarnType& type)
{
    const double radius = equivalent_radius(type), ply = ply_radius(type.plies);
    const double straight = std::sqrt((type.area * type.packing - type.core_area()) / (pi * type.fibres)); // were they straight
    const double round = type.plies > 1 ? 2 * pi * std::abs(type.ply_twist) * radius * (1 - ply) : 0;
    double fibre = straight;
    for (int i = 0; i < 12; ++i) { // thinner fibres reach further out and are longer
        const double reach = std::max(0.1 * radius * ply, radius * ply - fibre);
        const double lengthening = helix_lengthening(2 * pi * std::abs(type.twist) * reach, core_density(type), core_hole(type)) *
                                   std::sqrt(1 + round * round) * type.fibre_length;
        fibre = straight / std::sqrt(lengthening);
    }
    return fibre;
}

double drawn_core_radius(const YarnType& type)
{
    const double half = 0.5 * type.section.height * ply_radius(type.plies);
    return std::min(std::sqrt(type.core_area() / (pi * type.plies)), 0.9 * half);
}

int smooth_samples(const Textile& textile)
{
    double turns = 1; // per crossing
    for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
        for (const YarnType& type : textile.system(kind).types)
            turns = std::max(turns, textile.system(other_kind(kind)).pitch *
                                        std::max(std::abs(type.twist), type.plies > 1 ? std::abs(type.ply_twist) : 0.0));
    return static_cast<int>(std::ceil(8 * turns));
}

FlyawayLength flyaway_length(const Textile& textile, const YarnType& type)
{
    const double twist = type.plies > 1 ? 0.0 : std::abs(type.twist); // a plied yarn's fibres lie about along it
    FlyawayLength length;
    length.loops = 1e3 * textile.flyaway.loop_density_per_mm *
                   mean_loop_length(metre_from_mm(textile.flyaway.loop_height_mm), twist, equivalent_radius(type));
    length.hairs = 1e3 * textile.flyaway.hair_density_per_mm * metre_from_mm(textile.flyaway.hair_length_mm);
    return length;
}

YarnFibres::YarnFibres(const Textile& textile, const FibreOptions& options, YarnKind kind, int yarn, int first_crossing, int crossings)
    : textile_(textile), options_(options), type_(textile.type(kind, yarn)), fibres_(type_.fibres),
      cores_(running_strands(type_) - type_.fibres)
{
    const bool is_warp = kind == YarnKind::warp;
    rings_ = static_cast<std::size_t>(crossings) * static_cast<std::size_t>(options.samples_per_crossing) + 1;
    set_sizes();

    const Along axis = along_axis(textile, kind, yarn);
    const int limit = (is_warp ? textile.picks() : textile.ends()) - 1;
    const int samples = options.samples_per_crossing;
    ring_.resize(rings_ + 2);
    for (std::size_t i = 0; i < ring_.size(); ++i) {
        const int step = first_crossing * samples + static_cast<int>(i) - 1; // from half a pitch before crossing 0
        const int at = step >= 0 ? step / samples : -((-step + samples - 1) / samples);
        const double offset = static_cast<double>(step - at * samples) / samples - 0.5;
        const YarnPoint p = yarn_point(textile, kind, yarn, at, offset);
        const double flat = 1.0 / std::hypot(p.tangent.x, p.tangent.y);
        const Vec3d across{p.tangent.y * flat, -p.tangent.x * flat, 0}, up = cross(across, p.tangent);
        const double along = axis.at(at + 0.5 + offset);
        const double twist = 2 * pi * std::fmod(type_.twist * along, 1.0), ply = 2 * pi * std::fmod(type_.ply_twist * along, 1.0);
        Ring& ring = ring_[i];
        ring = {{static_cast<float>(p.centre.x), static_cast<float>(p.centre.y), static_cast<float>(p.centre.z)},
                {static_cast<float>(across.x), static_cast<float>(across.y)},
                {static_cast<float>(up.x), static_cast<float>(up.y), static_cast<float>(up.z)},
                static_cast<float>(p.half_width),
                static_cast<float>(p.half_height),
                static_cast<float>(std::cos(twist)),
                static_cast<float>(std::sin(twist)),
                static_cast<float>(std::cos(ply)),
                static_cast<float>(std::sin(ply)),
                static_cast<float>(along),
                0,
                static_cast<float>(step) / static_cast<float>(samples)};
        const int nearest = std::clamp(at, 0, limit);
        ring.segment = is_warp ? textile.segment(kind, yarn, nearest) : textile.segment(kind, nearest, yarn);
    }
    along0_ = axis.at(first_crossing);
    along1_ = axis.at(first_crossing + crossings);
    const std::uint64_t stream = stream_of(textile, kind, yarn);
    const double turn = 2 * pi * random_uniform(options.seed, stream, draw_index(draw_angle, 0, 0));
    const double start = random_uniform(options.seed, stream, draw_index(draw_phase, 0, 0));
    for (int i = 0; i < fibres_; ++i) {
        const int in_ply = i / type_.plies, each = (fibres_ + type_.plies - 1) / type_.plies;
        const double angle = turn + golden_angle * i + 0.3 * random_uniform(options.seed, stream, draw_index(draw_angle, 1, i));
        start_angle_cos_.push_back(static_cast<float>(std::cos(angle)));
        start_angle_sin_.push_back(static_cast<float>(std::sin(angle)));
        phase_.push_back(static_cast<float>(start + (in_ply + 0.5) / each));
    }
    loops_.resize(static_cast<std::size_t>(regular())); // a core has none
    if (options.flyaways) {
        find_loops(stream);
        find_hairs(stream);
    }
}

void YarnFibres::set_sizes()
{
    fibre_radius_ = drawn_fibre_radius(type_);
    core_radius_ = drawn_core_radius(type_);
    hole_ = static_cast<float>(core_hole(type_));
    hair_radius_ = metre_from_um(type_.fibre.fibre_radius_um);
    core_ = static_cast<float>(core_density(type_));
    inner_ = static_cast<float>(std::max(0.1, 1 - fibre_radius_ / (ply_radius(type_.plies) * equivalent_radius(type_))));
    migration_ = static_cast<float>(std::abs(type_.twist) > 1 ? turns_per_migration / std::abs(type_.twist) : untwisted_migration);
}

std::size_t YarnFibres::count_hairs(const Textile& textile, const FibreOptions& options, YarnKind kind, int yarn, int first_crossing,
                                    int crossings)
{
    const double density = 1e3 * textile.flyaway.hair_density_per_mm;
    if (!options.flyaways || density <= 0 || textile.flyaway.hair_length_mm <= 0) return 0;
    const std::uint64_t stream = stream_of(textile, kind, yarn);
    const Along axis = along_axis(textile, kind, yarn);
    // Hair k lies between k and k + 1 of the hairs' spacing, so below any place are the whole ones and perhaps one more.
    const auto below = [&](double place) {
        const auto whole = static_cast<std::int64_t>(std::floor(place * density));
        std::int64_t count = whole;
        for (std::int64_t k : {whole - 1, whole, whole + 1}) {
            const bool before = hair_place(options, stream, density, k) < place;
            count += (before ? 1 : 0) - (k < whole ? 1 : 0);
        }
        return count;
    };
    return static_cast<std::size_t>(below(axis.at(first_crossing + crossings)) - below(axis.at(first_crossing)));
}

double YarnFibres::loops_over(const Flyaway& flyaway, int fibres)
{
    const double reach_mm = (1 + loop_flank) * loop_width * flyaway.loop_height_mm;
    return 2 * reach_mm * flyaway.loop_density_per_mm / std::max(1, fibres);
}

void YarnFibres::find_loops(std::uint64_t stream)
{
    const double density = 1e3 * textile_.flyaway.loop_density_per_mm, height = metre_from_mm(textile_.flyaway.loop_height_mm);
    if (density <= 0 || height <= 0) return;
    const double reach = (1 + loop_flank) * loop_width * height;
    loop_reach_ = static_cast<float>(reach);
    const auto first = static_cast<std::int64_t>(std::floor((along0_ - reach) * density)) - 1;
    const auto last = static_cast<std::int64_t>(std::floor((along1_ + reach) * density)) + 1;
    for (std::int64_t k = first; k <= last; ++k) {
        const auto draw = [&](int part) { return random_uniform(options_.seed, stream, draw_index(draw_loop, part, k)); };
        const auto fibre = static_cast<std::size_t>(std::min(static_cast<int>(draw(0) * fibres_), fibres_ - 1));
        const double h = height * (lowest_loop + (1 - lowest_loop) * draw(1));
        loops_[fibre].push_back(
            {static_cast<float>((static_cast<double>(k) + draw(2)) / density), static_cast<float>(h), static_cast<float>(loop_width * h)});
    }
}

const YarnFibres::Loop* YarnFibres::first_loop(std::size_t fibre, float along) const
{
    const auto& loops = loops_[fibre];
    const auto first = std::lower_bound(loops.begin(), loops.end(), along - loop_reach_,
                                        [](const Loop& loop, float place) { return loop.middle < place; });
    return loops.data() + (first - loops.begin());
}

void YarnFibres::find_hairs(std::uint64_t stream)
{
    const double density = 1e3 * textile_.flyaway.hair_density_per_mm, mean = metre_from_mm(textile_.flyaway.hair_length_mm);
    if (density <= 0 || mean <= 0) return;
    const auto first = static_cast<std::int64_t>(std::floor(along0_ * density)) - 1;
    const auto last = static_cast<std::int64_t>(std::floor(along1_ * density)) + 1;
    const double spacing = (along1_ - along0_) / static_cast<double>(rings_ - 1);
    for (std::int64_t k = first; k <= last; ++k) {
        const auto draw = [&](int part) { return random_uniform(options_.seed, stream, draw_index(draw_hair, part, k)); };
        const double along = hair_place(options_, stream, density, k);
        if (along < along0_ || along >= along1_) continue;
        const double position = (along - along0_) / spacing;
        const auto index = std::min(static_cast<std::size_t>(position), rings_ - 1);
        const Ring& a = ring_[index + 1];
        const Ring& b = ring_[index + 2];
        const double part = position - static_cast<double>(index);
        const auto mix = [&](float x, float y) {
            return static_cast<double>(x) + part * (static_cast<double>(y) - static_cast<double>(x));
        };
        const Vec3d centre{mix(a.centre[0], b.centre[0]), mix(a.centre[1], b.centre[1]), mix(a.centre[2], b.centre[2])};
        const Vec3d across{static_cast<double>(a.across[0]), static_cast<double>(a.across[1]), 0};
        const Vec3d up{static_cast<double>(a.up[0]), static_cast<double>(a.up[1]), static_cast<double>(a.up[2])};
        const Vec3d along_yarn = cross(up, across);
        const double angle = 2 * pi * draw(1), lean = 2 * pi * draw(2), steepness = 0.35 + 1.2 * draw(3); // radian over the skin
        const Vec3d out = std::sin(angle) * across + std::cos(angle) * up, round = std::cos(angle) * across - std::sin(angle) * up;
        const Vec3d flat = std::cos(lean) * along_yarn + std::sin(lean) * round;
        Hair hair;
        hair.root = centre + hair_root * (mix(a.half_width, b.half_width) * std::sin(angle) * across +
                                          mix(a.half_height, b.half_height) * std::cos(angle) * up);
        hair.direction = std::sin(steepness) * out + std::cos(steepness) * flat;
        // Turning in its own plane, either over towards the yarn or away from it, or sideways.
        const Vec3d fold = std::cos(steepness) * out - std::sin(steepness) * flat, side = cross(hair.direction, fold);
        const double plane = 2 * pi * draw(4);
        hair.bend = std::cos(plane) * fold + std::sin(plane) * side;
        hair.length = mean * (shortest_hair + 2 * (1 - shortest_hair) * draw(5));
        hair.angle = 0.2 + 1.8 * draw(6);
        hair.ring = index + 1;
        hairs_.push_back(hair);
    }
}

void YarnFibres::place(int fibre, std::size_t index, float* out) const
{
    const Ring& ring = ring_[index];
    const auto i = static_cast<std::size_t>(fibre);
    float rho = 0, sine = 0, cosine = 1;
    if (!is_core(fibre)) {
        const float rank = triangle_wave(phase_[i] + ring.along / migration_), inside = std::max(0.005f, hole_);
        rho = inner_ * std::sqrt(inside + (1 - inside) * squared_radius(core_, rank)); // never quite through the axis
        sine = start_angle_sin_[i] * ring.twist_cos + start_angle_cos_[i] * ring.twist_sin;
        cosine = start_angle_cos_[i] * ring.twist_cos - start_angle_sin_[i] * ring.twist_sin;
    }
    float distance = rho;
    if (type_.plies > 1) {
        const auto ply = static_cast<float>((is_core(fibre) ? fibre - fibres_ : fibre) % type_.plies),
                   radius = static_cast<float>(ply_radius(type_.plies));
        const float at = 2 * static_cast<float>(pi) * ply / static_cast<float>(type_.plies);
        const float ply_sine = std::sin(at) * ring.ply_cos + std::cos(at) * ring.ply_sin;
        const float ply_cosine = std::cos(at) * ring.ply_cos - std::sin(at) * ring.ply_sin;
        const float x = (1 - radius) * ply_sine + radius * rho * sine, y = (1 - radius) * ply_cosine + radius * rho * cosine;
        distance = std::sqrt(x * x + y * y);
        const float inverse = distance > 1e-6f ? 1 / distance : 0;
        sine = x * inverse;
        cosine = y * inverse;
    }
    float lifted = 0, extra = 0;
    for (const Loop* at = first_loop(i, ring.along); at != loops_[i].data() + loops_[i].size(); ++at) {
        const Loop& loop = *at;
        if (loop.middle > ring.along + loop_reach_) break;
        const float x = std::abs(ring.along - loop.middle) / loop.half_width;
        if (x >= 1 + static_cast<float>(loop_flank)) continue;
        if (x < 1) {
            const float c = std::cos(0.5f * static_cast<float>(pi) * x);
            extra = std::max(extra, loop.height * c * c);
            lifted = 1;
        } else {
            const float t = (1 + static_cast<float>(loop_flank) - x) / static_cast<float>(loop_flank);
            lifted = std::max(lifted, t * t * (3 - 2 * t));
        }
    }
    distance += (1 - distance) * lifted;
    const float reach = distance * skin_over_ellipse(ring.half_width, ring.half_height, sine, cosine);
    const float x = (reach * ring.half_width + extra) * sine, y = (reach * ring.half_height + extra) * cosine;
    out[0] = ring.centre[0] + x * ring.across[0] + y * ring.up[0];
    out[1] = ring.centre[1] + x * ring.across[1] + y * ring.up[1];
    out[2] = ring.centre[2] + y * ring.up[2];
}

void YarnFibres::hair_curve(const Hair& hair, float* out) const
{
    const double radius = hair.length / hair.angle;
    for (std::size_t i = 0; i < hair_points; ++i) {
        const double turned = hair.angle * static_cast<double>(i) / (hair_points - 1);
        const Vec3d p = hair.root + radius * (std::sin(turned) * hair.direction + (1 - std::cos(turned)) * hair.bend);
        *out++ = static_cast<float>(p.x);
        *out++ = static_cast<float>(p.y);
        *out++ = static_cast<float>(p.z);
    }
}

void YarnFibres::curve(int strand, float* out) const
{
    if (is_hair(strand)) {
        hair_curve(hair(strand), out);
        return;
    }
    for (std::size_t ring = 0; ring < rings_; ++ring) place(strand, ring + 1, out + 3 * ring);
}

double YarnFibres::loop_length(int strand) const
{
    if (strand >= fibres_) return 0;
    double length = 0;
    float before[3], here[3];
    bool outside_before = false;
    for (std::size_t ring = 0; ring < rings_; ++ring) {
        place(strand, ring + 1, here);
        bool outside = false;
        const auto& loops = loops_[static_cast<std::size_t>(strand)];
        for (const Loop* at = first_loop(static_cast<std::size_t>(strand), ring_[ring + 1].along); at != loops.data() + loops.size();
             ++at) {
            const Loop& loop = *at;
            if (loop.middle > ring_[ring + 1].along + loop_reach_) break;
            outside = outside || std::abs(ring_[ring + 1].along - loop.middle) < loop.half_width;
        }
        if (ring > 0 && (outside || outside_before)) {
            const double piece = std::hypot(static_cast<double>(here[0] - before[0]), static_cast<double>(here[1] - before[1]),
                                            static_cast<double>(here[2] - before[2]));
            length += outside && outside_before ? piece : 0.5 * piece;
        }
        outside_before = outside;
        std::copy_n(here, 3, before);
    }
    return length;
}

} // namespace hygroloom
