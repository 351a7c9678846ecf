// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the room between the yarns of a woven layer is like as it is drawn, by place in the weave. Follows from lengths alone: liquids and
// angles have no part in it.
#pragma once

#include "core/physics/between_yarns.h"
#include "core/room/drawn_layer.h"

#include <optional>
#include <vector>

namespace hygroloom {

/// The room at crossings of one type of warp with one of weft, on the mean.
struct DrawnRoom {
    double warp_skin = 0, weft_skin = 0;   ///< m2 of the yarns at a crossing, beside the room
    double faces = 0;                      ///< m2 of its openings
    double along_warp = 0, along_weft = 0; ///< m2, permeabilities when full
    RoomStates states;                     ///< of what is drawn together: of all its types alike
};

struct RoomTables {
    std::vector<DrawnRoom> types;                ///< warp type x weft types + weft type; empty: the cloth is not drawn
    std::vector<float> warp_places, weft_places; ///< permeability of each crossing of a period, end x picks + pick, over that of its types
    int ends = 0, picks = 0;                     ///< of the period that the places are of
    double falls_along_warp = 0, falls_along_weft = 0; ///< power of its saturation that a room's permeability goes with
    double level_along_warp = 1, level_along_weft = 1; ///< what the permeabilities are over those by mobility, see room_permeability()
    double growth = 0;                                 ///< m, see growth_to_share()
};

constexpr int most_drawn_crossings = 64; ///< of a cell or period that is drawn as it is; else a part of it, or each pair of types alone

/// What of a cloth is drawn together; none: each pair of its types alone. Plain, ribs and baskets, of whose cells two make a period, are
/// drawn as a period.
std::optional<WovenCell> drawn_cell(const Textile& textile);
/// As the tables see it, from the cloth's first end and pick on.
DrawnLayer layer_of_cell(const Textile& textile, const WovenCell& cell, int voxels);

/// A cloth's repeat in voxels, and how much its yarns grow there to have the volume that they have before they are widened.
struct DrawnRepeat {
    DrawnLayer layer;
    double growth = 0; ///< m
};
/// The smallest cell of the weave; where types differ a whole period, or of a large weave a part of it with the first types alone.
DrawnRepeat drawn_repeat(const Textile& textile, int voxels, const Widening& wider = {});

/// Of the cloth, drawn as this cell of its weave, from its first end and pick on.
RoomTables tables_of_cell(const Textile& textile, const WovenCell& cell, int voxels);

constexpr int stokes_voxels = 28; ///< in the mean pitch, from which on Stokes flow sets the level of permeabilities

/// What is drawn for the tables: so many cells or periods one after the other, each of so many cubes, see cubes_of_crossing().
struct DrawnVolume {
    double cubes = 0;
    int periods = 0;
    double longest = 0; ///< side, in those of a cube
};
DrawnVolume drawn_volume(const Textile& textile);

/// Of the textile's weave and yarns, wherever its region lies. voxels: in the mean pitch, see drawn_layer().
RoomTables find_room_tables(const Textile& textile, int voxels);

} // namespace hygroloom
