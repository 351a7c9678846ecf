// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The yarns of a running scene, cut into segments: which there are, which of them a step visits, and the table of their arrays.
#pragma once

#include "core/scene/scene.h"
#include "core/solver/fields.h"

#include <algorithm>

namespace hygroloom {

constexpr int no_particle = 0x7fffffff; ///< noted by a segment that no particle touches

/// Threads at the sample's sides that a step leaves out, because nothing happens there yet.
struct Unvisited {
    int ends_before = 0, ends_after = 0;
    int picks_before = 0, picks_after = 0;

    HL_FN bool any() const { return ends_before + ends_after + picks_before + picks_after > 0; }
};

/// What both leave out.
inline Unvisited left_out_by_both(const Unvisited& a, const Unvisited& b)
{
    const auto less = [](int one, int other) { return one < other ? one : other; };
    return {less(a.ends_before, b.ends_before), less(a.ends_after, b.ends_after), less(a.picks_before, b.picks_before),
            less(a.picks_after, b.picks_after)};
}

/// One yarn's segments that a step visits: first to last - 1.
struct YarnLine {
    const YarnParameters& yarn;
    int first;
    int last;
    bool is_warp;
    bool starts, stops; ///< whether the yarn's own start and end are among them
};

struct Crossing {
    int end, pick;
};

/// The panels of a garment as stages see them: see ClothPanels.
struct Panels {
    int warp_pieces = 0, weft_pieces = 0; ///< of yarns
    int present = 0;                      ///< crossings
    int warp_chains = 0, weft_chains = 0, longest_chain = 0;
    bool has_rings = false; ///< chains whose last place joins the first
    int count = 0;          ///< 0: one whole rectangle
    const int* first = nullptr;
    const int* last = nullptr;
    const int* crossings = nullptr;
    const std::uint8_t* of_pick = nullptr;
    const double* cell_area = nullptr;
    const std::uint8_t* skin_on_top = nullptr;
    const std::uint8_t* air = nullptr;
    const FaceAir* airs = nullptr;
    const float* rise = nullptr;
    const int* shown = nullptr;
    const int* shown_ends = nullptr;
    const int* order = nullptr;
    const int* chain_ends = nullptr;
    const double* joint_yarns = nullptr;
    const double* joint_rooms = nullptr;
};

/// The cloth's yarns: lines of segments, all ends, then all picks. A yarn is of one type along its whole length.
/// Stages go through the visited lines, crossings and segments by an index of their own.
struct Yarns {
    int ends = 0;
    int picks = 0;
    int warp_types = 1;
    int weft_types = 1;
    const std::uint8_t* type = nullptr;           ///< of each line
    const YarnParameters* parameters = nullptr;   ///< per type: the warp's, then the weft's
    const CrossingParameters* crossing = nullptr; ///< warp type x weft_types + weft type
    Unvisited unvisited;
    Panels panels;

    HL_FN bool whole() const { return panels.count == 0; }
    HL_FN int crossings() const { return ends * picks; }
    HL_FN int visited_ends() const { return ends - unvisited.ends_before - unvisited.ends_after; }
    HL_FN int visited_picks() const { return picks - unvisited.picks_before - unvisited.picks_after; }
    HL_FN int visited_warps() const { return whole() ? visited_ends() : panels.warp_pieces; } ///< lines of the warp
    HL_FN int visited_wefts() const { return whole() ? visited_picks() : panels.weft_pieces; }
    HL_FN int visited_lines() const { return visited_warps() + visited_wefts(); }
    HL_FN int visited_crossings() const { return whole() ? visited_ends() * visited_picks() : panels.present; }
    HL_FN int visited_segments() const { return 2 * visited_crossings(); }
    HL_FN bool is_warp(int segment) const { return segment < crossings(); }
    HL_FN int line_of(int segment) const { return is_warp(segment) ? segment / picks : ends + (segment - crossings()) / ends; }
    HL_FN int type_of_end(int end, int pick) const { return type[whole() ? end : panels.of_pick[pick] * ends + end]; }
    HL_FN int type_of_pick(int pick) const { return type[(whole() ? 1 : panels.count) * ends + pick]; }
    HL_FN int type_of(int segment) const
    {
        if (whole()) return type[line_of(segment)];
        return is_warp(segment) ? type_of_end(segment / picks, segment % picks) : type_of_pick((segment - crossings()) / ends);
    }
    HL_FN const YarnParameters& yarn_of(int segment) const { return parameters[type_of(segment)]; }
    HL_FN const CrossingParameters& crossing_at(int end, int pick) const
    {
        return crossing[type_of_end(end, pick) * weft_types + type_of_pick(pick) - warp_types];
    }
    HL_FN YarnLine visited_line(int index) const
    {
        if (!whole()) {
            const int first = panels.first[index];
            return {yarn_of(first), first, panels.last[index], index < panels.warp_pieces, true, true};
        }
        const Unvisited& out = unvisited;
        if (index < visited_ends()) {
            const int end = out.ends_before + index, first = end * picks;
            return {parameters[type[end]], first + out.picks_before, first + picks - out.picks_after, true,
                    out.picks_before == 0, out.picks_after == 0};
        }
        const int pick = out.picks_before + index - visited_ends(), first = crossings() + pick * ends;
        return {parameters[type[ends + pick]], first + out.ends_before, first + ends - out.ends_after, false,
                out.ends_before == 0,          out.ends_after == 0};
    }
    /// Crossings are visited in strips of some ends, so that those side by side in the order lie side by side along picks, too.
    HL_FN Crossing visited_place(int index) const
    {
        if (!whole()) return {panels.crossings[index] / picks, panels.crossings[index] % picks};
        constexpr int strip = 8;
        const int height = visited_picks(), first = index / (strip * height) * strip;
        const int width = visited_ends() - first < strip ? visited_ends() - first : strip, place = index - first * height;
        return {unvisited.ends_before + first + place % width, unvisited.picks_before + place / width};
    }
    HL_FN int visited_crossing(int index) const
    {
        if (!whole()) return panels.crossings[index];
        if (!unvisited.any()) return index;
        return (unvisited.ends_before + index / visited_picks()) * picks + unvisited.picks_before + index % visited_picks();
    }
    HL_FN int visited_segment(int index) const
    {
        if (!whole()) {
            if (index < panels.present) return panels.crossings[index];
            const int at = panels.crossings[index - panels.present];
            return crossings() + at % picks * ends + at / picks;
        }
        if (!unvisited.any()) return index;
        if (index < visited_crossings()) return visited_crossing(index);
        const int weft = index - visited_crossings();
        return crossings() + (unvisited.picks_before + weft / visited_ends()) * ends + unvisited.ends_before + weft % visited_ends();
    }
};

/// Those of a scene, on the host.
inline Panels panels_of(const ClothPanels& p)
{
    Panels there;
    there.warp_pieces = p.warp_pieces;
    there.weft_pieces = static_cast<int>(p.first.size()) - p.warp_pieces;
    there.present = static_cast<int>(p.crossings.size());
    there.warp_chains = p.warp_chains;
    there.weft_chains = static_cast<int>(p.chain_ends.size()) - p.warp_chains;
    int first = 0;
    for (int end : p.chain_ends) {
        there.longest_chain = std::max(there.longest_chain, end - first);
        there.has_rings = there.has_rings || (end > first && p.joint_yarns[static_cast<std::size_t>(end) - 1] >= 0);
        first = end;
    }
    there.count = p.count;
    there.first = p.first.data();
    there.last = p.last.data();
    there.crossings = p.crossings.data();
    there.of_pick = p.panel.data();
    there.cell_area = p.cell_area.data();
    there.skin_on_top = p.skin_on_top.data();
    there.air = p.air.data();
    there.airs = p.airs.data();
    there.rise = p.rise.data();
    there.shown = p.shown.data();
    there.shown_ends = p.shown_ends.data();
    there.order = p.order.data();
    there.chain_ends = p.chain_ends.data();
    there.joint_yarns = p.joint_yarns.data();
    there.joint_rooms = p.joint_rooms.data();
    return there;
}
inline Yarns yarns_of(const Scene& scene)
{
    return {scene.cloth.ends,
            scene.cloth.picks,
            scene.cloth.warp_types,
            scene.cloth.weft_types(),
            scene.cloth.type.data(),
            scene.cloth.yarns.data(),
            scene.cloth.crossing.data(),
            {},
            panels_of(scene.cloth.panels)};
}

/// The arrays of panels on a machine.
template <template <typename> typename Buffer> struct PanelArrays {
    Buffer<int> first, last, crossings, shown, shown_ends, order, chain_ends;
    Buffer<std::uint8_t> of_pick, skin_on_top, air;
    Buffer<double> cell_area, joint_yarns, joint_rooms;
    Buffer<FaceAir> airs;
    Buffer<float> rise;

    void upload(const ClothPanels& panels)
    {
        first.upload(panels.first);
        last.upload(panels.last);
        crossings.upload(panels.crossings);
        of_pick.upload(panels.panel);
        skin_on_top.upload(panels.skin_on_top);
        air.upload(panels.air);
        cell_area.upload(panels.cell_area);
        airs.upload(panels.airs);
        rise.upload(panels.rise);
        shown.upload(panels.shown);
        shown_ends.upload(panels.shown_ends);
        order.upload(panels.order);
        chain_ends.upload(panels.chain_ends);
        joint_yarns.upload(panels.joint_yarns);
        joint_rooms.upload(panels.joint_rooms);
    }
    Panels view(Panels there) const
    {
        if (there.count == 0) return {};
        there.first = first.data();
        there.last = last.data();
        there.crossings = crossings.data();
        there.of_pick = of_pick.data();
        there.cell_area = cell_area.data();
        there.skin_on_top = skin_on_top.data();
        there.air = air.data();
        there.airs = airs.data();
        there.rise = rise.data();
        there.shown = shown.data();
        there.shown_ends = shown_ends.data();
        there.order = order.data();
        there.chain_ends = chain_ends.data();
        there.joint_yarns = joint_yarns.data();
        there.joint_rooms = joint_rooms.data();
        return there;
    }
};

/// How many elements an array of the segments has.
enum class SegmentCount {
    segments,
    shells,            ///< those of each segment's fibres, from the middle outwards
    crossings,         ///< end x picks + pick
    bundle_crossings,  ///< the same where the cloth goes in bundles of yarns, else none
    fed_segments,      ///< all, where any hangs in liquid, else none
    watched_segments,  ///< all, where errors of steps are watched, else none
    takers,            ///< all that free liquid passes into: segments, and behind them each crossing's room where liquid flows by suction
    offered_takers,    ///< the same, where a pool, caps or particles feed cloth in which liquid flows by suction, else none
    promised_takers,   ///< the same, where particles feed it, else none
    cap_crossings,     ///< all crossings, where drops or pools come, else none
    uneven_segments,   ///< all, where yarns are uneven along their length, else none
    touching_segments, ///< all, where liquid flows by suction and neighbours touch, else none
    woven_segments,    ///< all, where liquid flows by suction and rooms are as they are drawn, else none
    sucking_segments,  ///< all, where liquid flows by suction, else none
    sucking_crossings, ///< the same of the crossings
    layered_segments,  ///< all, where layers lie on each other, else none
    skin_crossings     ///< all crossings, where skin sweats under them, else none
};

/// The segments' arrays. Liquid and vapour are masses, so that what leaves one segment enters another exactly.
template <template <typename> typename Array> struct SegmentFields {
    Array<const double> length{};
    Array<const std::uint8_t> warp_up{}; ///< whether the end is up
    Array<const float> warp_up_share{};  ///< of the crossings that each stands for
    Array<const std::uint8_t> fed{};     ///< whether it hangs in liquid and stays full
    Array<const double> touching{};      ///< see Cloth
    Array<const float> room_along{};     ///< see Cloth
    Array<double> pores{};               ///< volume; changes as fibres swell
    Array<const double> dry_pores{};     ///< volume before any swelling, of uneven yarns
    Array<double> supplied{};            ///< liquid since the start by hanging in it
    Array<double> liquid{};
    Array<double> vapour{};
    Array<double> warmth{}; ///< over the climate's temperature
    Array<double> regain{};
    Array<double> bound{};   ///< water in the fibres: see bound_water(); who changes regain keeps it up to date
    Array<double> suction{}; ///< Pa, at which the pores last settled
    Array<double> settled{}; ///< the saturation they had then
    Array<double> room{};    ///< m3, between the yarns at each crossing
    Array<double> between{}; ///< liquid there; it is as warm as the warp's segment
    Array<double> between_suction{}, between_settled{};
    Array<const double> sweat{};                ///< m/s, see SkinSupply
    Array<std::int64_t> on_skin{};              ///< quanta that the skin under a crossing holds
    Array<std::int64_t> offered{};              ///< quanta of a pool, cap or drop that each taker may still draw in this step
    Array<std::int64_t> promised{}, paid{};     ///< by particles: quanta offered in this step, and what they have paid of those drawn
    Array<int> cap_over{};                      ///< place among those that stand of the cap, drop or pool over a crossing; -1: none
    Array<std::int64_t> absorbed{};             ///< quanta taken from particles and pools since the last network step
    Array<int> contact{};                       ///< note of the particle that touches, or none: see note_of()
    Array<double> uptake{};                     ///< how much more water fibres took in the last exchange per kg/m3 more of pore vapour
    Array<double> evaporated{};                 ///< to the air since the start
    Array<double> released{};                   ///< by phase change since the start
    Array<double> lost{};                       ///< to the air since the start
    Array<double> came{};                       ///< heat from other layers that the exchange has still to take in
    Array<double> stored{};                     ///< heat over the climate's temperature, found when stock is taken: see TakeStock
    Array<double> work0{}, work1{}, work2{};    ///< scratch of what goes along lines
    Array<double> flux{};                       ///< that crossed to the next segment along the yarn in this step
    Array<double> liquid_before{};              ///< at the start of this step
    Array<double> liquid_rate{};                ///< of change by wicking, in the step before
    Array<double> bound_before{}, bound_rate{}; ///< at the last exchange, and the rate of change in it
    Array<double> heat_before{}, heat_rate{};   ///< the same of the heat

    /// The table: visit(field, the field's array of each state).
    template <typename Visit, typename... States> static constexpr void each(const Visit& visit, States&... of)
    {
        using Row = Field<SegmentCount>;
        using Count = SegmentCount;
        constexpr bool saved = true, shown = true;
        visit(Row{"length", "m", Count::segments}, of.length...);
        visit(Row{"warp_up", "1", Count::crossings}, of.warp_up...);
        visit(Row{"warp_up_share", "1", Count::bundle_crossings}, of.warp_up_share...);
        visit(Row{"fed", "1", Count::fed_segments}, of.fed...);
        visit(Row{"touching", "m3/(Pa s)", Count::touching_segments}, of.touching...);
        visit(Row{"room_along", "1", Count::woven_segments}, of.room_along...);
        visit(Row{"pores", "m3", Count::segments, saved, shown}, of.pores...);
        visit(Row{"dry_pores", "m3", Count::uneven_segments}, of.dry_pores...);
        visit(Row{"supplied", "kg", Count::fed_segments, saved, shown}, of.supplied...);
        visit(Row{"liquid", "kg", Count::segments, saved, shown}, of.liquid...);
        visit(Row{"vapour", "kg", Count::segments, saved, shown}, of.vapour...);
        visit(Row{"warmth", "K", Count::segments, saved, shown}, of.warmth...);
        visit(Row{"regain", "kg/kg", Count::shells, saved, shown}, of.regain...);
        visit(Row{"bound", "kg", Count::segments, saved, shown}, of.bound...);
        visit(Row{"suction", "Pa", Count::sucking_segments, saved}, of.suction...);
        visit(Row{"settled", "1", Count::sucking_segments, saved}, of.settled...);
        visit(Row{"room", "m3", Count::sucking_crossings, saved, shown}, of.room...);
        visit(Row{"between", "kg", Count::sucking_crossings, saved, shown}, of.between...);
        visit(Row{"between_suction", "Pa", Count::sucking_crossings, saved}, of.between_suction...);
        visit(Row{"between_settled", "1", Count::sucking_crossings, saved}, of.between_settled...);
        visit(Row{"sweat", "m/s", Count::skin_crossings}, of.sweat...);
        visit(Row{"on_skin", "2^-64 kg", Count::skin_crossings, saved}, of.on_skin...);
        visit(Row{"offered", "2^-64 kg", Count::offered_takers}, of.offered...);
        visit(Row{"promised", "2^-64 kg", Count::promised_takers}, of.promised...);
        visit(Row{"paid", "2^-64 kg", Count::promised_takers}, of.paid...);
        visit(Row{"cap_over", "1", Count::cap_crossings}, of.cap_over...);
        visit(Row{"absorbed", "2^-64 kg", Count::takers, saved}, of.absorbed...);
        visit(Row{"contact", "1", Count::takers}, of.contact...);
        visit(Row{"uptake", "m3", Count::segments, saved}, of.uptake...);
        visit(Row{"evaporated", "kg", Count::segments, saved, shown}, of.evaporated...);
        visit(Row{"released", "J", Count::segments, saved, shown}, of.released...);
        visit(Row{"lost", "J", Count::segments, saved, shown}, of.lost...);
        visit(Row{"came", "J", Count::layered_segments}, of.came...);
        visit(Row{"stored", "J", Count::segments, !saved, shown}, of.stored...);
        visit(Row{"work0", "1", Count::segments}, of.work0...);
        visit(Row{"work1", "1", Count::segments}, of.work1...);
        visit(Row{"work2", "1", Count::segments}, of.work2...);
        visit(Row{"flux", "kg", Count::segments}, of.flux...);
        visit(Row{"liquid_before", "kg", Count::segments, saved}, of.liquid_before...);
        visit(Row{"liquid_rate", "kg/s", Count::watched_segments, saved}, of.liquid_rate...);
        visit(Row{"bound_before", "kg", Count::watched_segments, saved}, of.bound_before...);
        visit(Row{"bound_rate", "kg/s", Count::watched_segments, saved}, of.bound_rate...);
        visit(Row{"heat_before", "J", Count::watched_segments, saved}, of.heat_before...);
        visit(Row{"heat_rate", "W", Count::watched_segments, saved}, of.heat_rate...);
    }
};

/// The segments as stages see them; arrays that the scene does not have are null.
struct Segments : Yarns, SegmentFields<Pointer> {
    int shells = 0;                                                       ///< of each segment's fibres
    double swelling = 0;                                                  ///< m3 of fibre per kg of water bound
    bool narrows = false;                                                 ///< whether fibres swell
    HL_FN bool varies() const { return narrows || dry_pores != nullptr; } ///< whether pores differ from their type's

    /// m of a yarn of mean thickness that has as much fibre: a thick place has more fibres and more pores, as closely packed.
    HL_FN double fibre_length(int i, const YarnParameters& yarn) const
    {
        return dry_pores != nullptr ? dry_pores[i] * plain_inverse(yarn.pore_area) : length[i];
    }
    bool room_with_warp = true; ///< whose temperature the liquid between yarns has

    HL_FN int warp_of(int end, int pick) const { return end * picks + pick; }
    HL_FN int weft_of(int end, int pick) const { return crossings() + pick * ends + end; }
    HL_FN int crossing_of(int segment) const
    {
        if (segment < crossings()) return segment;
        const int weft = segment - crossings();
        return (weft % ends) * picks + weft / ends;
    }
    /// Of a place in a cloth of panels.
    HL_FN int panel_at(int place) const { return panels.of_pick[place % picks]; }
    HL_FN const FaceAir& air_over(int segment) const { return panels.airs[panels.air[crossing_of(segment)]]; }
    HL_FN double cell_area(int segment) const { return panels.cell_area[panel_at(crossing_of(segment))]; }
    /// The face that a yarn lies on at a crossing: 1 on top, 0 at the bottom.
    HL_FN int face_of(int place, bool is_warp) const { return (warp_up[place] != 0) == is_warp ? 1 : 0; }
    /// kg that has a segment's temperature: its liquid and bound water, and of the warp's the liquid beside it, or of the weft's.
    HL_FN double warm_water(int i) const
    {
        const double water = liquid[i] + bound[i];
        return between != nullptr && is_warp(i) == room_with_warp ? water + between[crossing_of(i)] : water;
    }
};

/// How far something happens: its largest end, its largest pick, and both counted from the sample's other side.
struct Reach {
    int* farthest;

    HL_FN void include(const Yarns& yarns, int crossing) const
    {
        const int end = crossing / yarns.picks, pick = crossing % yarns.picks;
        atomic_max(farthest, end);
        atomic_max(farthest + 1, pick);
        atomic_max(farthest + 2, yarns.ends - 1 - end);
        atomic_max(farthest + 3, yarns.picks - 1 - pick);
    }
};

} // namespace hygroloom
