// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How a yarn bends from one face of the fabric to the other: Peirce's arcs and straights (1937) on racetrack sections (Kemp 1958).
// Any one unit of length throughout. Where the yarns are too close for round arcs, the arcs tighten and the yarn is squeezed between.
#pragma once

namespace hygroloom {

/// A yarn's section: a flat between two half circles. A circle when width equals height.
struct Section {
    double width = 0;  ///< in the plane of the fabric
    double height = 0; ///< across the fabric
    bool operator==(const Section&) const = default;
};

double section_area(const Section& section);

/// The racetrack of the same area as a circle, at a given height not above its diameter.
Section flattened_section(double diameter, double height);

/// Centreline of one yarn between two crossings where it changes sides, from +amplitude at x = 0 to -amplitude at x = pitch,
/// and flat where it stays on a side.
struct Interlacing {
    double pitch = 0;       ///< distance of the two crossings
    double amplitude = 0;   ///< height over the fabric's middle plane at a crossing
    double flat = 0;        ///< straight part over the crossed yarn's flat, to each side of the crossing
    double arc_radius = 0;  ///< of the centreline
    double weave_angle = 0; ///< greatest inclination, radian
    double length = 0;      ///< of the centreline over one pitch
    bool jammed = false;    ///< arcs are tighter than full arcs round the crossed yarn

    double height_at(double x) const; ///< 0 <= x <= pitch
    double slope_at(double x) const;  ///< dz/dx
};

/// own bends over other and rises by amplitude over the fabric's middle plane, from 0 to half the sum of both heights; other's yarns
/// lie pitch apart. Where full arcs do not fit, own first leaves the crossed yarn's flat earlier, then its arcs tighten.
Interlacing interlace(double pitch, const Section& own, const Section& other, double amplitude);
/// With level faces: the amplitude is half other's height.
inline Interlacing interlace(double pitch, const Section& own, const Section& other)
{
    return interlace(pitch, own, other, 0.5 * other.height);
}

/// Height that a crossed section leaves to own's section whose middle is this far along and over the crossed one's middle; from a tenth of
/// own's height to all of it.
double squeezed_height(const Section& own, const Section& crossed, double along, double over);

/// What the crossed yarns at both ends of a path that changes sides leave; other rises by other_rise to the other side.
double squeezed_height_at(const Interlacing& path, const Section& own, const Section& other, double other_rise, double x);

} // namespace hygroloom
