// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How thick the yarns are, free and in the fabric, and how high they rise: linear density is kept, the fabric's thickness limits the
// height of the sections, the sett their width, and warp and weft share the crimp. Lengths in mm.
#pragma once

#include "core/design/design.h"
#include "core/design/evenness.h"
#include "core/design/interlacing.h"
#include "core/design/spreading.h"

#include <cstdint>

namespace hygroloom {

constexpr double widest_share_of_pitch = 0.98;  ///< neighbours leave this much of the pitch to one yarn at most
constexpr double loosest_packing = 0.01;        ///< fibre volume / yarn volume of a free yarn, at least
constexpr double densest_packing = 0.99;        ///< the same at most: fibres that fit each other, or hardly more than one
constexpr double loosest_in_cloth = 0.45;       ///< the same that a given thickness can loosen a yarn to; an assumption
constexpr double densest_squeezed = 0.85;       ///< the same that a looser yarn can be squeezed to
constexpr double pressed_height = 0.925;        ///< of its free height that a yarn has in cloth at 1 kPa: 0.9 where two cross, 0.95 beyond
constexpr double closest_round_fibres = 0.9069; ///< pi / (2 sqrt 3): round fibres of one size that touch all round
constexpr std::size_t most_yarn_types = 16;     ///< different yarns in one system, colour apart

/// A free yarn, all three values in agreement.
struct FreeYarn {
    double diameter = 0; ///< mm
    double linear_density_tex = 0;
    double packing_factor = 0;
};

/// The missing values from the given ones: tex = packing x density x pi d2 / 4. Precondition: a diameter or a linear density is given.
FreeYarn free_yarn(const Yarn& yarn, double fibre_density_kg_m3, double packing_if_open);
/// With the density and the packing of its fibres and class.
FreeYarn free_yarn(const Design& design, const Yarn& yarn);

/// Height over width of a yarn's section in cloth. One that is given by its diameter is round. Spun yarn by its twist times the root of its
/// tex, t: e = 0.35 + 0.51 (1 - exp(-t/1600)) / (1 - exp(-4600/1600)), whose ends, 0.35 untwisted and 0.86 at 4600, were measured
/// (Afrashteh, Merati and Jeddi 2013) and whose course between them is an assumption; rotor yarn 0.03 less; plied yarn 0.8, as its plies
/// keep it round; a monofilament is round. Filaments lie flatter: flat ones 0.3, textured ones 0.4; assumptions.
double usual_shape(const Design& design, const Yarn& yarn, const FreeYarn& free);

/// Packing of the fibres in the room that a solid core leaves them, which is so much of a yarn's solids.
constexpr double packing_round_core(double packing, double core) { return packing * (1 - core) / (1 - packing * core); }

/// Of the filaments that share a linear density, as round ones of the same section, um.
double filament_radius_um(double linear_density_tex, int filaments, double fibre_density_kg_m3);

/// The different yarns of one system and the order they come in.
struct YarnOrder {
    std::vector<int> yarns;          ///< of each type, as yarn_in() numbers them; yarns that differ in colour alone are one type
    std::vector<double> share;       ///< of the threads, per type
    std::vector<std::uint8_t> type;  ///< of each thread of one period
    std::vector<std::uint16_t> yarn; ///< of each thread of one period
};
/// Precondition: the order's numbers are in range.
YarnOrder yarn_order(const Fabric& fabric, bool warp);

struct FittedYarn {
    FreeYarn free;
    Material fibre;                ///< the yarn's mean substance, see yarn_substance()
    double core = 0;               ///< share of the solids, by volume, that is a core
    double receding_angle_deg = 0; ///< of the fibres, or of the fabric's finish over them
    Section section;               ///< mm, in the fabric
    double packing_factor = 0;     ///< in the fabric, mean along the yarn
    double area_share = 1;         ///< mean area along the yarn over the section's, which is that at crossings
    YarnClass yarn_class = YarnClass::ring;
    Unevenness unevenness;  ///< as given, or typical
    double shape = 1;       ///< height over width where nothing but the weave presses it: see usual_shape()
    bool soft = false;      ///< given by its count and of many fibres: the cloth presses it, and a given thickness loosens it
    double loosened = 1;    ///< its area over that of the free yarn, to fill a given thickness
    double in_floats = 1;   ///< how much wider it lies in floats: see widening_by_floats()
    bool flattened = false; ///< by the thickness, the crimp or the neighbours
    bool narrowed = false;  ///< by the neighbours

    /// How close it can be packed: as close as it can be squeezed, or as it is given where it is given closer.
    double most_packing() const
    {
        if (free.packing_factor <= densest_squeezed) return densest_squeezed;
        return flattened ? free.packing_factor : densest_packing;
    }
    /// Whether it would have to be packed closer, with so much more fibre in it; the fabric cannot be woven then.
    bool too_dense(double fibre_scale = 1) const
    {
        return fibre_scale * packing_factor > most_packing() * (1 + 1e-9); // flattening keeps it, but for rounding
    }
};

/// Heights of the two centrelines over (under) the middle plane where they cross; they sum to half the heights of both sections
/// unless the crimps are set to more.
struct CrossingHeights {
    double warp = 0;
    double weft = 0;
};

/// All types of both systems as they lie in the fabric.
struct FittedYarns {
    YarnOrder warp_order;
    YarnOrder weft_order;
    std::vector<FittedYarn> warp; ///< per type
    std::vector<FittedYarn> weft;
    std::vector<CrossingHeights> heights; ///< warp type x number of weft types + weft type
    std::vector<SpanPair> spans;          ///< the same, where the yarns change sides
    double available_height = 0;          ///< mm, thickness less the loops on both faces; 0 when no thickness is given
    double roundness = 0; ///< of yarns where they are crossed: 1 where a crimp is set, so that a path has it; less where that gives way
    bool jammed = false;  ///< free yarns of this sett cannot bend round each other in full arcs

    const CrossingHeights& at(std::size_t warp_type, std::size_t weft_type) const { return heights[warp_type * weft.size() + weft_type]; }
    const SpanPair& span_at(std::size_t warp_type, std::size_t weft_type) const { return spans[warp_type * weft.size() + weft_type]; }
    /// One yarn's path over another's. Precondition of Interlacing holds.
    Interlacing path(double pitch, const Section& own, const Section& other, double rise) const
    {
        return interlace(pitch, own, {other.width - roundness * (other.width - other.height), other.height}, rise);
    }
    /// From face to face.
    double thickness() const;
    /// Of fibres that stand out, both faces together, mm under 1 kPa.
    double surface() const;
};

/// Precondition: the yarns, the setts and the orders are in range.
/// Crimp: as set; else warp and weft share it as their spans to the power 1.5, up to where either jams: a compromise between measured
/// crimps of poplin, plain cloth of 94 x 120 threads an inch and satin. With both crimps set, yarns are flattened until they touch at those
/// rises; without a thickness set crimps give way where they would squeeze yarns closer than they can be packed. Without a thickness or a
/// set crimp, yarns that would jam are flattened until they do not or touch their neighbours.
FittedYarns fit_yarns(const Design& design, const Fabric& fabric);
/// The yarns of a fabric that differs by its contact angle alone, which they fit alike with.
FittedYarns with_angle_of(const Design& design, const Fabric& fabric, FittedYarns yarns);

} // namespace hygroloom
