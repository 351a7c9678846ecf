// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The woven textile in SI units: two systems of yarns, one repeat of the weave, and how many crossings there are.
// Nothing is stored per crossing: sections and paths stand once for each type of yarn and everything else follows from indices.
// Warp runs along y, weft along x, z points out of the top face; the origin is the middle of the region.
#pragma once

#include "core/base/vec3.h"
#include "core/design/fitted_fabric.h"
#include "core/physics/finished_face.h"

#include <cmath>
#include <cstdint>

namespace hygroloom {

/// A yarn's shape over one pitch that begins on the upper side, sampled evenly from crossing to crossing.
struct YarnPath {
    std::vector<double> height;      ///< of the centreline
    std::vector<double> slope;       ///< dz/dx of the centreline
    std::vector<double> half_height; ///< of the section, across the yarn; smaller where neighbours squeeze it
    std::vector<double> half_width;
    double length = 0; ///< of the centreline
};

/// Yarns of one system that are alike but for their colour.
struct YarnType {
    Section section;        ///< m, at a crossing
    double area = 0;        ///< m2, of the section with its pores, mean along the yarn
    double packing = 0;     ///< fibre volume / yarn volume, in the fabric, mean along the yarn; a core counts as fibre
    double widest = 0;      ///< m, of the sections along it
    double core = 0;        ///< share of that fibre volume that is a solid core in the middle
    double pore_radius = 0; ///< m, effective, between the fibres
    double tortuosity = 1;
    double helix_tortuosity = 1; ///< as the fabric gives it, else of twist and plies on the free diameter, see helix_tortuosity()
    double contact_angle = 0;    ///< radian, advancing
    double receding_angle = 0;   ///< radian, at most the contact angle
    double mouths_apart = 0;     ///< m along the yarn, see entry_across_fibres()
    double perimeter_factor = 1; ///< of a fibre's section: perimeter over that of a circle of the same area
    Unevenness unevenness;       ///< of the linear density along the yarn
    Material fibre;              ///< the yarn's mean substance, see yarn_substance()
    int fibres = 30;             ///< drawn
    int plies = 1;
    double twist = 0;     ///< turns per m of yarn, more than 0 for Z
    double ply_twist = 0; ///< the same of the plies
    double core_area() const { return area * packing * core; }
    /// Of the fibres in the room that the core leaves them, where the pores are.
    double packing_round_core() const { return hygroloom::packing_round_core(packing, core); }
    /// As a finish meets it where it lies on the face, with the mean of its rises.
    FinishedYarn under_finish() const
    {
        double all = 0;
        for (double over : rise) all += over;
        return {section.width, section.height, rise.empty() ? 0.0 : all / static_cast<double>(rise.size())};
    }
    double fibre_length = 1;              ///< of untwisted fibres over the yarn's: they run in and out where the section is squeezed
    std::vector<double> rise;             ///< m, height of the centreline over the middle plane at a crossing, per type it crosses
    std::vector<double> length_per_pitch; ///< mean, per type it crosses: 1 + crimp
};

/// All ends, or all picks.
struct YarnSystem {
    int count = 0;    ///< yarns in the region
    double pitch = 0; ///< m, from yarn to yarn
    std::vector<YarnType> types;
    std::vector<std::uint8_t> order;  ///< type of each thread of one period, from the fabric's thread 0
    std::vector<std::uint16_t> yarns; ///< number of each as yarn_in() has it, for its colour
    std::vector<YarnPath> paths;      ///< per own type, crossed type before, crossed type after, and whether it changes sides; see path()
};

enum class YarnKind { warp, weft };

constexpr YarnKind other_kind(YarnKind kind) { return kind == YarnKind::warp ? YarnKind::weft : YarnKind::warp; }

/// A crossing is (end, pick). Each crossing has two segments, one of its end and one of its pick, each centred on it and
/// reaching half-way to the neighbouring crossings: the cells of the moisture model.
/// Segments are numbered along the yarns: first all ends (end x picks + pick), then all picks (ends x picks + pick x ends + end).
struct Textile {
    YarnSystem warp;
    YarnSystem weft;
    Weave weave;
    Flyaway flyaway;
    std::optional<double> face_angle; ///< radian, contact angle of what lies on the upper face; without it, each yarn's own
    std::optional<double> back_angle; ///< the same of the lower face
    int first_end = 0;                ///< of the region in the fabric, which goes on to both sides
    int first_pick = 0;
    double thickness = 0;                         ///< m, of the interlaced yarns, from face to face
    double ends_per_cell = 1, picks_per_cell = 1; ///< that each end and each pick stands for: see in_cells()
    std::vector<float> warp_on_top; ///< of cells, end x picks + pick: share of their crossings with the warp up; empty: each is one
    FabricQuantities quantities;

    int ends() const { return warp.count; }
    int picks() const { return weft.count; }
    int crossings() const { return ends() * picks(); }
    /// Of one yarn.
    int crossings_along(YarnKind kind) const { return kind == YarnKind::warp ? picks() : ends(); }
    int segments() const { return 2 * crossings(); }
    /// Ends, and picks, that each stands for, about.
    int yarns_per_cell() const { return static_cast<int>(std::lround(std::sqrt(ends_per_cell * picks_per_cell))); }
    int segment(YarnKind kind, int end, int pick) const
    {
        return kind == YarnKind::warp ? end * picks() + pick : crossings() + pick * ends() + end;
    }
    const YarnSystem& system(YarnKind kind) const { return kind == YarnKind::warp ? warp : weft; }
    /// Number of a yarn's type; yarns outside the region have one, too.
    int type_of(YarnKind kind, int yarn) const;
    const YarnType& type(YarnKind kind, int yarn) const { return system(kind).types[static_cast<std::size_t>(type_of(kind, yarn))]; }
    /// As yarn_in() numbers it.
    int yarn_number(YarnKind kind, int yarn) const;

    bool warp_up(int end, int pick) const { return weave.warp_up(first_end + end, first_pick + pick); }
    /// How much of a segment lies on the upper face, 0 or 1; of cells a share.
    double on_top(YarnKind kind, int end, int pick) const
    {
        const double up =
            warp_on_top.empty() ? double(warp_up(end, pick)) : double(warp_on_top[std::size_t(segment(YarnKind::warp, end, pick))]);
        return kind == YarnKind::warp ? up : 1.0 - up;
    }
    double x_of_end(int end) const { return (end - 0.5 * (ends() - 1)) * warp.pitch; }
    double y_of_pick(int pick) const { return (pick - 0.5 * (picks() - 1)) * weft.pitch; }
    /// Height of the yarn's centreline at its crossing.
    double height_at_crossing(YarnKind kind, int end, int pick) const;
    /// How far the yarn lies beside its place at a crossing, along +x (warp) or +y (weft): where no thread passes between neighbours
    /// they move together, by up to half the gap between them.
    double shift_at_crossing(YarnKind kind, int end, int pick) const;
    /// Whether the yarn and the next beside it, along +x (warp) or +y (weft), touch at a crossing; the last has none.
    bool touches_next(YarnKind kind, int end, int pick) const;
    /// Length of a segment's centreline.
    double segment_length(YarnKind kind, int end, int pick) const;
    /// Whether the yarn changes sides between this crossing and the next along it.
    bool changes_after(YarnKind kind, int end, int pick) const;
    /// The path from this crossing to the next along the yarn.
    const YarnPath& path_after(YarnKind kind, int end, int pick) const;
    /// Half the thickness of the interlaced yarns: no yarn reaches higher.
    double half_thickness() const { return 0.5 * thickness; }
};

/// Ends, or picks, of a fabric before a region.
inline constexpr int most_yarns_before = 100'000'000;

/// A rectangle of crossings.
struct TextileRegion {
    int first_end = 0;
    int first_pick = 0;
    int ends = 0;
    int picks = 0;
};

/// The whole crossings that fit a sample of the given size, each way at least one and at most largest_yarn_order.
TextileRegion region_of_sample(const Fabric& fabric, double width_mm, double height_mm);
/// The crossings of an experiment's sample: the even number that fits each way, or one. In their middle a repeat of the weave begins, and
/// of stripes lies the middle of a repeat, or just behind it. So it is the same place of the cloth whatever the sample's size.
TextileRegion region_of_run(const Fabric& fabric, const Experiment& experiment);

/// Precondition: validate() found no error in the fabric. Cost does not depend on the region's size.
Textile build_textile(const Design& design, const Fabric& fabric, const TextileRegion& region);
/// The same of a fabric that has been fitted.
Textile build_textile(const Fabric& fabric, const FittedFabric& fitted, const TextileRegion& region);

/// The same as an experiment takes it: with the paper's closure a fabric that gives no contact angle of its own has that of cotton,
/// whatever its fibres are.
/// The fabric is fitted unless it already is.
Textile textile_of_run(const Design& design, const Fabric& fabric, const Experiment& experiment, const TextileRegion& region,
                       const FittedFabric* fitted = nullptr);
/// Of the experiment's whole sample.
Textile textile_of_run(const Design& design, const Fabric& fabric, const Experiment& experiment, const FittedFabric* fitted = nullptr);

/// The same cloth drawn with fewer, wider yarns: as many ends and picks as given, each in place of those that it covers, and of the type of
/// the one in their middle. Each of its segments has the fibres and pores of all that it stands for, and lies on a face with as much of it
/// as those do; sample, thickness and the weave that is drawn stay. Precondition: 1 <= ends <= fine.ends(), 1 <= picks <= fine.picks().
Textile in_cells(const Textile& fine, int ends, int picks);

/// A yarn at one place: its centreline and half its section across and along the fabric.
struct YarnPoint {
    Vec3d centre;
    Vec3d tangent; ///< unit, along the yarn
    double half_height;
    double half_width;
};

/// The yarn at a distance from crossing number at (0 .. yarn's crossings - 1), offset -0.5 .. 0.5 of the pitch.
YarnPoint yarn_point(const Textile& textile, YarnKind kind, int yarn, int at, double offset);

} // namespace hygroloom
