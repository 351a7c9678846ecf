// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Stages that see a large cloth in cells, where its segments are: what comes to the host grows with the cells, not with the segments.
#pragma once

#include "core/scene/frame.h"
#include "core/scene/thirst.h"
#include "core/solver/steps/yarn_lines.h"

namespace hygroloom {

/// The ends, or the picks, of a cloth shared out to cells of one size. A cell may begin within a yarn, as Bundles do.
struct CellSpans {
    int yarns = 1, cells = 1;

    HL_FN int first_of(int cell) const { return static_cast<int>(static_cast<std::int64_t>(cell) * yarns / cells); }
    HL_FN int past(int cell) const { return static_cast<int>((static_cast<std::int64_t>(cell + 1) * yarns + cells - 1) / cells); }
    /// The cell in which a yarn begins, and the one in which it ends.
    HL_FN int cell_of(int yarn) const { return static_cast<int>(static_cast<std::int64_t>(yarn) * cells / yarns); }
    HL_FN int last_of(int yarn) const { return static_cast<int>((static_cast<std::int64_t>(yarn + 1) * cells - 1) / yarns); }
    /// Part of a yarn that is in a cell.
    HL_FN double share(int yarn, int cell) const
    {
        const std::int64_t y = static_cast<std::int64_t>(yarn) * cells, c = static_cast<std::int64_t>(cell) * yarns;
        const std::int64_t begin = y > c ? y : c, end = y + cells < c + yarns ? y + cells : c + yarns;
        return static_cast<double>(end - begin) / cells;
    }
};

/// What a shown segment, or a line of them, adds to the ledger and to the faces. SI, as in CellSums.
struct ShownSums {
    double top = 0, bottom = 0;
    double liquid = 0, bound = 0, vapour = 0, evaporated = 0, supplied = 0;
    double stored = 0, released = 0, lost = 0;
    WetSums wet;

    HL_FN void add(const ShownSums& more)
    {
        top += more.top;
        bottom += more.bottom;
        liquid += more.liquid;
        bound += more.bound;
        vapour += more.vapour;
        evaporated += more.evaporated;
        supplied += more.supplied;
        stored += more.stored;
        released += more.released;
        lost += more.lost;
        wet.add(more.wet);
    }
};

/// Fields of a frame, one behind the other, each of all shown segments.
enum ShownField { shown_saturation, shown_liquid, shown_regain, shown_vapour, shown_temperature, shown_between, shown_field_count };

/// One shown segment: the ends' (or picks') segments in a cell as one. Cells are numbered as crossings are, shown segments as segments.
struct SeeShown {
    Segments s;
    CellSpans ends, picks;
    double density, temperature; ///< of the liquid; K, of the climate
    bool vapour_is_modelled;
    bool sees_wet_sums;
    double humidity;                            ///< of the climate
    int first_column, columns, first_row, rows; ///< of the cells to see
    float* fields;
    ShownSums* sums;

    HL_FN void operator()(int index) const
    {
        const bool is_warp = index < columns * rows;
        const int place = is_warp ? index : index - columns * rows;
        const int column = first_column + (is_warp ? place / rows : place % columns);
        const int row = first_row + (is_warp ? place % rows : place / columns);
        const int cells = ends.cells * picks.cells;
        const int shown = is_warp ? column * picks.cells + row : cells + row * ends.cells + column;
        Held held;
        for (int end = ends.first_of(column); end < ends.past(column); ++end)
            for (int pick = picks.first_of(row); pick < picks.past(row); ++pick)
                add(end, pick, is_warp, ends.share(end, column) * picks.share(pick, row), held);
        sums[shown] = held.sums;
        write(shown, 2 * cells, held);
    }

private:
    struct Held {
        ShownSums sums;
        double pores = 0, fibres = 0, air = 0; ///< m3, kg, m3
        double in_pores = 0, between = 0;      ///< kg
        double warmth = 0, segments = 0;
        double thirst = -1; ///< kg/kg; less than 0: not found yet
    };

    HL_FN void add(int end, int pick, bool is_warp, double share, Held& held) const
    {
        const int crossing = end * s.picks + pick, i = is_warp ? crossing : s.weft_of(end, pick);
        const YarnParameters& yarn = s.yarn_of(i);
        const double fibres = s.fibre_length(i, yarn) * yarn.fibre_area * yarn.fibre_density;
        double between = 0;
        if (s.between != nullptr) {
            const double on_warp = s.crossing_at(end, pick).between.on_warp[s.warp_up[crossing] != 0];
            between = (is_warp ? on_warp : 1.0 - on_warp) * s.between[crossing];
        }
        const double up =
            s.warp_up_share != nullptr ? static_cast<double>(s.warp_up_share[crossing]) : static_cast<double>(s.warp_up[crossing]);
        const double on_top = is_warp ? up : 1.0 - up;
        const double gained = s.liquid[i] + between + s.bound[i] - yarn.initial_regain * fibres;
        held.sums.top += share * on_top * gained;
        held.sums.bottom += share * (1.0 - on_top) * gained;
        held.sums.liquid += share * (s.liquid[i] + between);
        held.sums.bound += share * s.bound[i];
        held.sums.vapour += share * s.vapour[i];
        held.sums.evaporated += share * s.evaporated[i];
        if (s.supplied != nullptr) held.sums.supplied += share * s.supplied[i];
        held.sums.stored += share * s.stored[i];
        held.sums.released += share * s.released[i];
        held.sums.lost += share * s.lost[i];
        held.pores += share * s.pores[i];
        held.fibres += share * fibres;
        held.air += share * pore_air(s.pores[i], s.liquid[i], density);
        held.in_pores += share * s.liquid[i];
        held.between += share * between;
        held.warmth += share * s.warmth[i];
        held.segments += share;
        if (sees_wet_sums) add_wet(i, yarn, fibres, share, s.liquid[i] + between, held);
    }
    HL_FN void add_wet(int i, const YarnParameters& yarn, double fibres, double share, double liquid, Held& held) const
    {
        if (held.thirst < 0) held.thirst = thirst_of(yarn, temperature); // a cell's yarns are of one type
        const double wet = wet_share(s.liquid[i] / (density * s.pores[i]));
        const WaterOnFibre water{s.bound[i] / fibres, liquid / fibres, wet, held.thirst};
        held.sums.wet.add({share * wet, share * wet * held.thirst * fibres, warming_of(water, yarn, humidity, 0.0),
                           warming_of(water, yarn, humidity, heat_of_evaporation(temperature))});
    }
    HL_FN void write(int shown, int count, const Held& held) const
    {
        const double kelvin = temperature + held.warmth / held.segments;
        const double most = saturation_concentration(kelvin); // shown at most where vapour is not modelled, as of single segments
        double vapour = held.sums.vapour / held.air;
        if (!vapour_is_modelled && vapour > most) vapour = most;
        const double values[shown_field_count] = {
            held.in_pores / (density * held.pores), held.sums.liquid, held.sums.bound / held.fibres, vapour, kelvin, held.between};
        for (int field = 0; field < shown_field_count; ++field)
            fields[static_cast<std::size_t>(field) * static_cast<std::size_t>(count) + static_cast<std::size_t>(shown)] =
                static_cast<float>(values[field]);
    }
};

/// Sums up a line of shown segments, in order.
struct SumShown {
    CellSpans ends, picks;
    const ShownSums* sums;
    ShownSums* lines;

    HL_FN void operator()(int line) const
    {
        const bool is_warp = line < ends.cells;
        const int count = is_warp ? picks.cells : ends.cells;
        const int first = is_warp ? line * count : ends.cells * picks.cells + (line - ends.cells) * count;
        ShownSums all;
        for (int k = 0; k < count; ++k) all.add(sums[first + k]);
        lines[line] = all;
    }
};

/// Which segments are wet on each face along a visited end: no other is.
struct SeeWet {
    Segments s;
    double density; ///< of the liquid
    WetEnd* wet;

    HL_FN void operator()(int index) const
    {
        const int end = s.unvisited.ends_before + index;
        WetEnd seen;
        double places[2] = {0, 0}, squares[2] = {0, 0};
        for (int pick = s.unvisited.picks_before; pick < s.picks - s.unvisited.picks_after; ++pick) {
            const int crossing = end * s.picks + pick;
            const bool warp = is_wet(crossing), weft = is_wet(s.weft_of(end, pick));
            if (!warp && !weft) continue;
            for (int face = 0; face < 2; ++face) {
                if (!((warp && lies_on(crossing, face)) || (weft && lies_on(crossing, 1 - face)))) continue;
                if (seen.first[face] < 0) seen.first[face] = static_cast<float>(pick);
                seen.last[face] = static_cast<float>(pick);
                seen.count[face] += 1;
                const double place = pick - static_cast<double>(seen.first[face]);
                places[face] += place;
                squares[face] += place * place;
            }
        }
        for (int face = 0; face < 2; ++face) {
            seen.places[face] = static_cast<float>(places[face]);
            seen.squares[face] = static_cast<float>(squares[face]);
        }
        wet[end] = seen;
    }

private:
    HL_FN bool is_wet(int i) const
    {
        return static_cast<double>(static_cast<float>(s.liquid[i] / (density * s.pores[i]))) >= wet_saturation;
    }
    /// Whether some of the warp lies on the top (0) or the bottom (1).
    HL_FN bool lies_on(int crossing, int face) const
    {
        const float up = s.warp_up_share != nullptr ? s.warp_up_share[crossing] : static_cast<float>(s.warp_up[crossing]);
        return face == 0 ? up > 0 : up < 1;
    }
};

} // namespace hygroloom
