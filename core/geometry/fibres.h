// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The fibres of a yarn, made where they are looked at: twisted, migrating, plied, with loops and hairs (after Zhao et al. 2016).
// Everything random depends on the seed, the yarn's number in the fabric and the place along it alone, so a fibre is the same
// whatever stretch of it is made.
#pragma once

#include "core/geometry/mesh.h"

namespace hygroloom {

struct FibreOptions {
    int samples_per_crossing = 8; ///< >= 1
    int sides = 6;                ///< of a fibre, >= 3
    bool flyaways = true;
    bool capped = true; ///< ends of the tubes
    std::uint64_t seed = 1;
};

/// Radius that a drawn fibre has so that all of a yarn's fibres together have the yarn's fibre volume less its core's, twist included. m.
double drawn_fibre_radius(const YarnType& type);
/// Radius of the core in each single yarn, m; 0 without one. Where a yarn is flatter than its core is thick, less.
double drawn_core_radius(const YarnType& type);

/// Strands of a yarn that run through: its fibres, and a core in each single yarn of one that has cores.
inline int running_strands(const YarnType& type) { return type.fibres + (type.core > 0 ? type.plies : 0); }

/// Local packing at a squared share of the radius: 1 + core (1 - 2 rho2) times the mean, core at most 0.5 and so that no axis is denser
/// than 0.9. Its mean over the section is the yarn's packing. Round a core, of the ring that the core leaves: 0 is the core's skin.
double packing_at(const YarnType& type, double squared_radius);

/// Mean length of loops and of hairs per metre of yarn: analytic, what the drawn ones add up to. A loop counts from where it leaves the
/// yarn's skin to where it comes back; its height is from half the given one to the given one. A hair's length is from half to one and a
/// half times the given one.
struct FlyawayLength {
    double loops = 0;
    double hairs = 0;
};
FlyawayLength flyaway_length(const Textile& textile, const YarnType& type);

/// Samples per crossing with which the fibres are drawn smoothly: eight a turn of the hardest twist, eight at least.
int smooth_samples(const Textile& textile);

/// The fibres of one stretch of a yarn, from half a pitch before its first crossing to half a pitch past its last.
/// Neighbouring stretches meet in the same points and normals. Strands 0 .. regular() - 1 run through, the cores
/// last; the hairs rooted in the stretch follow.
class YarnFibres {
public:
    /// Crossings are numbered as in the textile and may lie outside its region.
    YarnFibres(const Textile& textile, const FibreOptions& options, YarnKind kind, int yarn, int first_crossing, int crossings);

    int regular() const { return fibres_ + cores_; }
    int strands() const { return regular() + static_cast<int>(hairs_.size()); }
    bool is_hair(int strand) const { return strand >= regular(); }
    bool is_core(int strand) const { return strand >= fibres_ && !is_hair(strand); }
    /// Points along a strand.
    std::size_t points(int strand) const { return is_hair(strand) ? hair_points : rings_; }
    double radius(int strand) const { return is_hair(strand) ? hair_radius_ : is_core(strand) ? core_radius_ : fibre_radius_; }
    std::size_t vertices(int strand) const { return points(strand) * static_cast<std::size_t>(options_.sides); }
    std::size_t triangles(int strand) const
    {
        const auto sides = static_cast<std::size_t>(options_.sides);
        return 2 * (points(strand) - 1) * sides + (options_.capped ? 2 * (sides - 2) : 0);
    }
    /// Writes x y z of each point, m.
    void curve(int strand, float* out) const;
    /// The textile's segment that a point lies in, of a hair the one it is rooted in.
    int segment(int strand, std::size_t point) const { return ring_[is_hair(strand) ? hair(strand).ring : point + 1].segment; }
    /// Length of the strand's parts outside the yarn that count as loops; 0 for hairs.
    double loop_length(int strand) const;
    /// Writes a tube at these places of a mesh that has room for it; u runs along the yarn in crossings, v
    /// round the fibre and back, so that no seam is needed.
    void tube(int strand, YarnMesh& mesh, std::size_t first_vertex, std::size_t first_index) const;

    static constexpr std::size_t hair_points = 9;
    /// Hairs rooted in a stretch, without making it.
    /// How many loops reach over a place of one of so many fibres.
    static double loops_over(const Flyaway& flyaway, int fibres);
    static std::size_t count_hairs(const Textile& textile, const FibreOptions& options, YarnKind kind, int yarn, int first_crossing,
                                   int crossings);

private:
    struct Ring {
        float centre[3], across[2], up[3]; ///< the frame; across lies in the fabric's plane
        float half_width, half_height;
        float twist_cos, twist_sin, ply_cos, ply_sin;
        float along; ///< m from the fabric's crossing 0, in yarn length
        int segment;
        float u; ///< crossings from the region's edge
    };
    struct Loop {
        float middle, height, half_width;
    };
    struct Hair {
        Vec3d root, direction, bend; ///< unit vectors that span its plane
        double length, angle;        ///< total turn, radian
        std::size_t ring;
    };

    void set_sizes();
    const Hair& hair(int strand) const { return hairs_[static_cast<std::size_t>(strand - regular())]; }
    void find_loops(std::uint64_t stream); ///< in order along the yarn
    /// The first of a fibre's loops that can reach a place.
    const Loop* first_loop(std::size_t fibre, float along) const;
    void find_hairs(std::uint64_t stream);
    void place(int fibre, std::size_t ring, float* out) const;
    void hair_curve(const Hair& hair, float* out) const;
    /// A strand's points and one more at each end, for the tangents.
    void middle_line(int strand, std::vector<float>& line) const;

    const Textile& textile_;
    FibreOptions options_;
    const YarnType& type_;
    int fibres_ = 0, cores_ = 0;
    std::size_t rings_ = 0;
    double fibre_radius_ = 0, core_radius_ = 0, hair_radius_ = 0;
    float core_ = 0;       ///< how much denser the axis is than the mean
    float hole_ = 0;       ///< squared share of the radius that the core takes
    float inner_ = 1;      ///< share of the section's half axes that fibres' middles reach
    float migration_ = 0;  ///< m of yarn from surface to surface
    float loop_reach_ = 0; ///< m, from a loop's middle to where its fibre is back in the yarn
    double along0_ = 0, along1_ = 0;
    std::vector<Ring> ring_; ///< one more at each end
    std::vector<float> start_angle_cos_, start_angle_sin_, phase_;
    std::vector<std::vector<Loop>> loops_; ///< per fibre
    std::vector<Hair> hairs_;
};

} // namespace hygroloom
