// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/scene/coarse_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace hygroloom {
namespace {

/// The bundles that a yarn lies in, and its part in each.
struct YarnParts {
    std::size_t first = 0, count = 0;
    std::array<double, 2> share{};
};
std::vector<YarnParts> parts_of(const Bundles& bundles)
{
    std::vector<YarnParts> all(static_cast<std::size_t>(bundles.yarns));
    for (int yarn = 0; yarn < bundles.yarns; ++yarn) {
        YarnParts& parts = all[static_cast<std::size_t>(yarn)];
        parts.first = static_cast<std::size_t>(bundles.first_of(yarn));
        for (int bundle = bundles.first_of(yarn); bundle <= bundles.last_of(yarn); ++bundle)
            parts.share[parts.count++] = bundles.share(yarn, bundle);
    }
    return all;
}

/// Of a fine segment: the coarse ones that it lies in.
struct SegmentParts {
    std::size_t count = 0;
    std::array<std::size_t, 4> coarse{};
    std::array<double, 4> share{};
};

/// A cloth's ends and picks as those of a coarser one.
struct Blocks {
    Bundles ends, picks;

    /// visit(fine segment, coarse segment, part of the fine one that is in the coarse one)
    template <typename Visit> void each_part(const Visit& visit) const
    {
        const int fine_crossings = ends.yarns * picks.yarns, coarse_crossings = ends.count * picks.count;
        for (int end = 0; end < ends.yarns; ++end)
            for (int pick = 0; pick < picks.yarns; ++pick)
                for (int across = ends.first_of(end); across <= ends.last_of(end); ++across)
                    for (int along = picks.first_of(pick); along <= picks.last_of(pick); ++along) {
                        const double share = ends.share(end, across) * picks.share(pick, along);
                        visit(static_cast<std::size_t>(end * picks.yarns + pick), static_cast<std::size_t>(across * picks.count + along),
                              share);
                        visit(static_cast<std::size_t>(fine_crossings + pick * ends.yarns + end),
                              static_cast<std::size_t>(coarse_crossings + along * ends.count + across), share);
                    }
    }
    /// visit(fine segment, its parts), in the order of segments.
    template <typename Visit> void each_segment(const Visit& visit) const
    {
        const std::vector<YarnParts> of_ends = parts_of(ends), of_picks = parts_of(picks);
        const auto all_ends = static_cast<std::size_t>(ends.count), all_picks = static_cast<std::size_t>(picks.count);
        std::size_t segment = 0;
        const auto look_at = [&](const YarnParts& end, const YarnParts& pick, bool is_warp) {
            SegmentParts parts;
            for (std::size_t across = 0; across < end.count; ++across)
                for (std::size_t along = 0; along < pick.count; ++along) {
                    const std::size_t c = end.first + across, d = pick.first + along;
                    parts.coarse[parts.count] = is_warp ? c * all_picks + d : all_ends * all_picks + d * all_ends + c;
                    parts.share[parts.count++] = end.share[across] * pick.share[along];
                }
            visit(segment++, parts);
        };
        for (const YarnParts& end : of_ends)
            for (const YarnParts& pick : of_picks) look_at(end, pick, true);
        for (const YarnParts& pick : of_picks)
            for (const YarnParts& end : of_ends) look_at(end, pick, false);
    }
    std::size_t coarse_segments() const { return static_cast<std::size_t>(2 * ends.count * picks.count); }
    /// How many yarns a coarse segment stands for side by side.
    double yarns_of(std::size_t coarse_segment) const { return coarse_segment < coarse_segments() / 2 ? ends.size() : picks.size(); }
};

template <typename T> std::vector<double> summed(const Blocks& blocks, const std::vector<T>& values)
{
    std::vector<double> sums(values.empty() ? 0 : blocks.coarse_segments());
    if (!values.empty())
        blocks.each_part([&](std::size_t i, std::size_t c, double share) { sums[c] += share * static_cast<double>(values[i]); });
    return sums;
}

/// Of a bundle, the mean of as many yarns as it stands for: of an outermost one that has more, or fewer, in proportion, so that it has
/// their pores and fibres.
std::vector<double> lengths(const Blocks& blocks, const std::vector<double>& fine)
{
    std::vector<double> coarse = summed(blocks, fine);
    for (std::size_t c = 0; c < coarse.size(); ++c) coarse[c] /= blocks.yarns_of(c);
    return coarse;
}

/// Conductances in series, from the middle of each bundle to that of the next: the segments of a cell side by side share their liquid.
std::vector<double> touching_bundles(const Blocks& blocks, const std::vector<double>& fine)
{
    if (fine.empty()) return {};
    const auto fine_crossings = static_cast<std::size_t>(blocks.ends.yarns * blocks.picks.yarns);
    std::vector<double> coarse;
    for (bool is_warp : {true, false}) {
        const Bundles &own = is_warp ? blocks.ends : blocks.picks, &crossed = is_warp ? blocks.picks : blocks.ends;
        const auto joint = [&](int yarn, int across) { // all of a cell's between a yarn and the next
            double sum = 0;
            for (int at = 0; at < crossed.yarns; ++at)
                if (crossed.first_of(at) <= across && across <= crossed.last_of(at))
                    sum += crossed.share(at, across) *
                           fine[(is_warp ? 0 : fine_crossings) + static_cast<std::size_t>(yarn * crossed.yarns + at)];
            return sum;
        };
        for (int bundle = 0; bundle < own.count; ++bundle)
            for (int across = 0; across < crossed.count; ++across) {
                const double from = own.middle(bundle) - 0.5; // in yarns' middles
                const double begin = std::max(0.0, from), end = std::min(from + own.size(), own.yarns - 1.0);
                double resistance = bundle + 1 < own.count ? 0 : std::numeric_limits<double>::infinity();
                for (int yarn = static_cast<int>(begin); yarn < end && std::isfinite(resistance); ++yarn)
                    resistance += std::max(0.0, std::min(end, yarn + 1.0) - std::max(begin, double(yarn))) / joint(yarn, across);
                coarse.push_back(1.0 / resistance);
            }
    }
    return coarse;
}

/// A block hangs in the liquid if half of it does; those that hang deepest do in any case.
std::vector<std::uint8_t> fed_blocks(const Blocks& blocks, const std::vector<std::uint8_t>& fine)
{
    const std::vector<double> hanging = summed(blocks, fine);
    if (hanging.empty()) return {};
    const double deepest = *std::max_element(hanging.begin(), hanging.end());
    const double enough = std::min(0.5 * blocks.ends.size() * blocks.picks.size(), deepest) * (1 - 1e-12);
    std::vector<std::uint8_t> fed;
    fed.reserve(hanging.size());
    for (double crossings : hanging) fed.push_back(crossings > 0 && crossings >= enough);
    return fed;
}

std::vector<std::uint8_t> types(const Blocks& blocks, const std::vector<std::uint8_t>& fine)
{
    std::vector<std::uint8_t> coarse;
    coarse.reserve(static_cast<std::size_t>(blocks.ends.count) + static_cast<std::size_t>(blocks.picks.count));
    for (int end = 0; end < blocks.ends.count; ++end) coarse.push_back(fine[static_cast<std::size_t>(blocks.ends.middle_of(end))]);
    for (int pick = 0; pick < blocks.picks.count; ++pick)
        coarse.push_back(fine[static_cast<std::size_t>(blocks.ends.yarns + blocks.picks.middle_of(pick))]);
    return coarse;
}

std::vector<float> warp_up_shares(const Blocks& blocks, const std::vector<std::uint8_t>& warp_up)
{
    std::vector<std::uint8_t> of_segments = warp_up; // of the warp's, which come in the order of crossings
    of_segments.resize(2 * warp_up.size());
    std::vector<double> shares = summed(blocks, of_segments);
    shares.resize(shares.size() / 2);
    auto share = shares.begin();
    for (int end = 0; end < blocks.ends.count; ++end)
        for (int pick = 0; pick < blocks.picks.count; ++pick) *share++ /= blocks.ends.held(end) * blocks.picks.held(pick);
    return {shares.begin(), shares.end()};
}

/// This number of yarns side by side, each segment of which meets this number of crossed ones.
void bundle(YarnParameters& yarn, double yarns, double crossed)
{
    yarn.pore_area *= yarns;
    yarn.fibre_area *= yarns;
    yarn.open_vapour *= yarns;
    yarn.face_area *= yarns * crossed;
    yarn.flow_along *= yarns;
    yarn.face_conductance *= yarns * crossed;
}

void bundle(BetweenParameters& between, double ends, double picks)
{
    for (double* of_all : {&between.volume, &between.to_warp, &between.to_weft, &between.yarns, &between.face, &between.through})
        *of_all *= ends * picks;
    between.along_warp *= ends / picks;
    between.along_weft *= picks / ends;
}

/// Of what each crossing has.
std::vector<double> summed_crossings(const Blocks& blocks, std::vector<double> values)
{
    if (values.empty()) return values;
    values.resize(2 * values.size()); // the warp's segments come in the order of crossings
    values = summed(blocks, values);
    values.resize(values.size() / 2);
    return values;
}

/// Where a field of all segments is read and written.
struct FieldCopy {
    const float* from;
    float* to;
    bool is_amount;
};
/// Of the fields that are not zero everywhere.
std::vector<FieldCopy> copies(const Frame& from, Frame& to)
{
    std::vector<FieldCopy> all;
    for (const FrameField& field : frame_fields) {
        const std::vector<float>& values = field.in(from);
        if (std::any_of(values.begin(), values.end(), [](float value) { return value != 0; }))
            all.push_back({values.data(), field.in(to).data(), field.is_amount});
    }
    return all;
}

/// As a run's frames show it.
double regain_shown(double regain)
{
    const auto shows_regain = [](const FrameField& field) { return field.values == &Frame::regain; };
    const FrameField* field = std::find_if(std::begin(frame_fields), std::end(frame_fields), shows_regain);
    return static_cast<double>(rounded(*field, static_cast<float>(regain)));
}

/// kg of liquid and bound water that a face's segments have more than at the start.
void add_up_faces(Frame& frame, const Scene& scene)
{
    frame.water_top = frame.water_bottom = 0;
    std::size_t segment = 0;
    for (std::size_t line = 0; line < scene.cloth.type.size(); ++line) {
        const YarnParameters& yarn = scene.cloth.yarns[scene.cloth.type[line]];
        const bool is_warp = line < static_cast<std::size_t>(scene.cloth.ends);
        const double start = regain_shown(yarn.initial_regain);
        const auto picks = static_cast<std::size_t>(scene.cloth.picks),
                   crossed = is_warp ? picks : static_cast<std::size_t>(scene.cloth.ends);
        for (std::size_t i = 0; i < crossed; ++i, ++segment) {
            const std::size_t crossing = is_warp ? segment : i * picks + line - static_cast<std::size_t>(scene.cloth.ends);
            const double fibres = scene.cloth.fibre_length(segment, yarn) * yarn.fibre_area * yarn.fibre_density;
            const double gained =
                static_cast<double>(frame.liquid[segment]) + fibres * (static_cast<double>(frame.regain[segment]) - start);
            ((scene.cloth.warp_up[crossing] != 0) == is_warp ? frame.water_top : frame.water_bottom) += gained;
        }
    }
}

} // namespace

Scene coarsened(const Scene& fine, const Bundling& bundling)
{
    const Blocks blocks{bundles_of(fine.cloth.ends, bundling), bundles_of(fine.cloth.picks, bundling)};
    const double ends = blocks.ends.size(), picks = blocks.picks.size();
    Scene coarse = fine;
    coarse.cloth.ends = blocks.ends.count;
    coarse.cloth.picks = blocks.picks.count;
    coarse.cloth.length = lengths(blocks, fine.cloth.length);
    coarse.cloth.pores = summed(blocks, fine.cloth.pores);
    coarse.cloth.shift.clear();
    coarse.cloth.room_along.clear(); // cells hold many places
    coarse.cloth.touching = touching_bundles(blocks, fine.cloth.touching);
    coarse.cloth.warp_up_share = warp_up_shares(blocks, fine.cloth.warp_up);
    coarse.cloth.warp_up.clear();
    for (float share : coarse.cloth.warp_up_share) coarse.cloth.warp_up.push_back(share >= 0.5f);
    coarse.cloth.threads_per_cell = bundling.yarns;
    coarse.cloth.shown_ends = std::min(fine.cloth.shown_ends, blocks.ends.count);
    coarse.cloth.shown_picks = std::min(fine.cloth.shown_picks, blocks.picks.count);
    coarse.cloth.type = types(blocks, fine.cloth.type);
    coarse.cloth.start.liquid = summed(blocks, fine.cloth.start.liquid);
    coarse.supply.fed = fed_blocks(blocks, fine.supply.fed);
    coarse.cloth.cell_area *= ends * picks;
    coarse.cloth.warp_pitch *= ends;
    coarse.cloth.weft_pitch *= picks;
    for (std::size_t type = 0; type < coarse.cloth.yarns.size(); ++type) {
        const bool is_warp = type < static_cast<std::size_t>(coarse.cloth.warp_types);
        bundle(coarse.cloth.yarns[type], is_warp ? ends : picks, is_warp ? picks : ends);
    }
    for (CrossingParameters& crossing : coarse.cloth.crossing) // of all the yarns' crossings
        for (double* conductance : {&crossing.liquid_conductance, &crossing.heat_conductance, &crossing.vapour_conductance})
            *conductance *= ends * picks;
    for (CrossingParameters& crossing : coarse.cloth.crossing) bundle(crossing.between, ends, picks);
    coarse.cloth.start.between = summed_crossings(blocks, fine.cloth.start.between);
    return coarse;
}

namespace {

/// m, in the order of segments.
std::vector<double> segment_lengths(const Textile& textile)
{
    std::vector<double> lengths(static_cast<std::size_t>(textile.segments()));
    for (int end = 0; end < textile.ends(); ++end)
        for (int pick = 0; pick < textile.picks(); ++pick)
            for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
                lengths[static_cast<std::size_t>(textile.segment(kind, end, pick))] = textile.segment_length(kind, end, pick);
    return lengths;
}

/// The frame with its fields, and its shells, on fine segments of these lengths (m).
Frame on_yarns(Frame frame, const Blocks& blocks, const std::vector<double>& length, const std::vector<double>& coarse_length)
{
    const Frame cells = frame;
    for (const FrameField& field : frame_fields)
        if (std::vector<float>& values = field.in(frame); !values.empty()) values.assign(length.size(), 0.0F);
    const std::size_t shells = cells.shells.size() / coarse_length.size();
    frame.shells.assign(shells * length.size(), 0.0F);
    const std::vector<FieldCopy> fields = copies(cells, frame);
    const float* shells_of = cells.shells.data();
    float* shells_to = frame.shells.data();
    const auto add = [](float& to, double factor, float value) { to += static_cast<float>(factor * static_cast<double>(value)); };
    blocks.each_segment([&](std::size_t i, const SegmentParts& parts) {
        for (std::size_t k = 0; k < parts.count; ++k) {
            const std::size_t c = parts.coarse[k];
            const double share = parts.share[k];
            const double part = share * length[i] / (blocks.yarns_of(c) * coarse_length[c]); // of the cell's pores
            for (const FieldCopy& field : fields) add(field.to[i], field.is_amount ? part : share, field.from[c]);
            for (std::size_t s = 0; s < shells; ++s) add(shells_to[i * shells + s], share, shells_of[c * shells + s]);
        }
    });
    return frame;
}

} // namespace

Frame refined(Frame frame, const Scene& coarse, const Scene& fine, const Bundling& bundling)
{
    const Blocks blocks{bundles_of(fine.cloth.ends, bundling), bundles_of(fine.cloth.picks, bundling)};
    frame = on_yarns(std::move(frame), blocks, fine.cloth.length, coarse.cloth.length);
    add_up_faces(frame, fine);
    return frame;
}

YarnsOfBundles::YarnsOfBundles(const Textile& textile, const Bundling& bundling)
    : ends_(bundles_of(textile.ends(), bundling)), picks_(bundles_of(textile.picks(), bundling)), lengths_(segment_lengths(textile)),
      bundled_(lengths({ends_, picks_}, lengths_))
{
}

Frame YarnsOfBundles::refined(Frame frame) const { return on_yarns(std::move(frame), {ends_, picks_}, lengths_, bundled_); }

} // namespace hygroloom
