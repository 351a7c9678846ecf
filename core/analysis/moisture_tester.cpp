// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/moisture_tester.h"

#include "core/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

constexpr double wetting_slope = 0.26794919243112270; // tan 15 degrees, % per s

/// Frames are floats: what reaches the bound but for their rounding is wet.
bool is_wet(double content) { return content > wet_content * (1 - 1e-6); }

/// A face's readings at the tester's own times.
struct Samples {
    std::vector<double> time;        // s
    std::vector<RingContents> rings; // %
    std::vector<double> content;     // %
};

Samples sampled(const std::vector<double>& time, const std::vector<TesterReading>& readings, RingContents TesterReading::*face)
{
    Samples samples;
    const auto count = static_cast<long>(std::floor((time.back() - time.front()) / tester_interval + 1e-9));
    std::size_t after = 1;
    for (long k = 0; k <= count; ++k) {
        const double at = time.front() + tester_interval * static_cast<double>(k);
        while (after + 1 < time.size() && time[after] < at) ++after;
        const double share = std::clamp((at - time[after - 1]) / (time[after] - time[after - 1]), 0.0, 1.0);
        const RingContents &a = readings[after - 1].*face, &b = readings[after].*face;
        RingContents here;
        for (std::size_t ring = 0; ring < here.size(); ++ring) here[ring] = a[ring] + share * (b[ring] - a[ring]);
        samples.time.push_back(at);
        samples.rings.push_back(here);
        samples.content.push_back(face_content(here));
    }
    return samples;
}

/// Slope of the straight rise that leaves the same area above it, from a sample until half of the further rise within the feed is first
/// reached, %/s; 0 when the feed ended before or nothing rises. Unlike the time of a level it changes little where a content lingers near
/// that level.
double initial_slope(const std::vector<double>& time, const std::vector<double>& content, std::size_t wetting, double feed_end)
{
    std::size_t end = wetting; // the first sample past the feed
    while (end < time.size() && time[end] <= feed_end + 1e-9) ++end;
    if (end < wetting + 2) return 0;
    const double start = content[wetting];
    const auto from = content.begin() + static_cast<std::ptrdiff_t>(wetting);
    const double rise = share_of_largest * (*std::max_element(from, content.begin() + static_cast<std::ptrdiff_t>(end)) - start);
    double above = 0, missing = rise, reached = start;
    for (std::size_t i = wetting + 1; i < end && missing > 0; ++i) {
        reached = std::max(reached, content[i]);
        const double next = rise - (reached - start);
        const double until = next > 0 ? 1.0 : missing / (missing - next); // share of the interval
        above += tester_interval * until * 0.5 * (missing + std::max(next, 0.0));
        missing = next;
    }
    return rise > 0 ? 0.5 * rise * rise / above : 0.0;
}

/// Mean of the last samples of an interval, s, that which began before the first counts as that: steps become rises of one interval.
std::vector<double> averaged(const std::vector<double>& content, double interval)
{
    const auto count = static_cast<std::size_t>(std::max(1.0, std::round(interval / tester_interval)));
    std::vector<double> means(content.size());
    double sum = static_cast<double>(count) * content.front();
    for (std::size_t i = 0; i < content.size(); ++i) {
        sum += content[i] - content[i < count ? 0 : i - count];
        means[i] = sum / static_cast<double>(count);
    }
    return means;
}

/// When each ring outside the middle reads wet, s, outwards to the first that stays dry.
std::vector<double> times_of_wet_rings(const Samples& face)
{
    std::vector<double> times;
    for (std::size_t ring = 1; ring < tester_rings; ++ring) {
        const auto at = std::find_if(face.rings.begin(), face.rings.end(), [&](const RingContents& r) { return is_wet(r[ring]); });
        if (at == face.rings.end()) break;
        const double time = face.time[static_cast<std::size_t>(at - face.rings.begin())];
        times.push_back(times.empty() ? time : std::max(time, times.back()));
    }
    return times;
}

/// Mean over the wet rings of the speed from ring to ring, mm/s. Rings that one drop reached have the way that it gained over the time
/// since an earlier drop reached a ring, or an interval before the first wetted the cloth.
double spreading_speed(const std::vector<double>& rings, double wetting_time, double drop_interval)
{
    const double least = std::max(tester_interval, drop_interval);
    const auto by_same_drop = [&](std::size_t i, std::size_t k) {
        const auto number = [&](double time) { return std::floor((time - 0.5 * tester_interval) / drop_interval); };
        return drop_interval > 0 && number(rings[i]) == number(rings[k]);
    };
    double speeds = 0;
    for (std::size_t i = 0, end = 0; i < rings.size(); i = end) {
        for (end = i + 1; end < rings.size() && by_same_drop(i, end);) ++end;
        const double since = i > 0 ? rings[i - 1] : wetting_time - drop_interval, gained = static_cast<double>(end - i);
        speeds += gained * mm_from_metre(ring_step) * gained / std::max(rings[end - 1] - since, least);
    }
    return rings.empty() ? 0 : speeds / static_cast<double>(rings.size());
}

FaceIndices face_indices(const Samples& face, const TesterFeed& feed)
{
    FaceIndices indices;
    std::size_t wetting = 0;
    while (wetting + 1 < face.time.size() && face.content[wetting + 1] - face.content[wetting] <= wetting_slope * tester_interval)
        ++wetting;
    if (wetting + 1 >= face.time.size()) return indices;
    indices.wetting_time = face.time[wetting];
    // The last drop comes when the pump stops.
    indices.absorption_rate = initial_slope(face.time, averaged(face.content, feed.drop_interval), wetting, feed.end + feed.drop_interval);
    const std::vector<double> rings = times_of_wet_rings(face);
    indices.maximum_wetted_radius = mm_from_metre(ring_step) * static_cast<double>(rings.size());
    indices.spreading_speed = spreading_speed(rings, *indices.wetting_time, feed.drop_interval);
    return indices;
}

double area(const Samples& face)
{
    double sum = 0;
    for (std::size_t i = 1; i < face.time.size(); ++i) sum += 0.5 * (face.content[i] + face.content[i - 1]) * tester_interval;
    return sum;
}

/// At the bottom, and on top.
using ByFace = std::array<double, 2>;

/// What pins read of a segment's yarn that lies deeper than some share of the thickness. Their tips are cones: what lies at a depth counts
/// by a tip's circumference there.
double read_deeper_than(const Textile& textile, const YarnType& type, double depth)
{
    constexpr int slices = 60; // of the sensor depth
    double read = 0;
    for (int i = 0; i < slices; ++i) {
        const double above = std::max(depth, sensor_depth * i / slices), below = std::max(depth, sensor_depth * (i + 1) / slices);
        const auto share = [&](double down) {
            return shares_in_finish(type.under_finish(), textile.thickness, down * textile.thickness).section;
        };
        if (below > above) read += (sensor_depth - 0.5 * (above + below)) * (share(below) - share(above));
    }
    return read;
}

/// What pins read of the liquid of a segment whose finish keeps its outer part dry, over what they read where it is wet all through: all
/// of its liquid lies in the rest.
ByFace read_of_liquid(const Textile& textile, const YarnType& type)
{
    ByFace read{1, 1};
    for (bool on_top : {false, true}) {
        const double dry = kept_dry(textile, type, on_top).section, all = read_deeper_than(textile, type, 0);
        if (dry > 0 && all > 0)
            read[on_top ? 1 : 0] = read_deeper_than(textile, type, textile.quantities.finish_depth) / (all * (1.0 - dry));
    }
    return read;
}

/// The same of each type of a system.
std::vector<ByFace> reads_of_types(const Textile& textile, YarnKind kind, bool finishes)
{
    std::vector<ByFace> reads;
    for (const YarnType& type : textile.system(kind).types) reads.push_back(finishes ? read_of_liquid(textile, type) : ByFace{1, 1});
    return reads;
}

} // namespace

TesterPins::TesterPins(const Textile& textile, bool finishes)
{
    const std::vector<ByFace> of_warp = reads_of_types(textile, YarnKind::warp, finishes),
                              of_weft = reads_of_types(textile, YarnKind::weft, finishes);
    // At least a crossing lies in the middle's band, and none is missed along the others.
    const double band = std::max(ring_band, 1.5 * std::max(textile.warp.pitch, textile.weft.pitch));
    for (int end = 0; end < textile.ends(); ++end)
        for (int pick = 0; pick < textile.picks(); ++pick) {
            const double radius = std::hypot(textile.x_of_end(end), textile.y_of_pick(pick));
            const double rings = std::ceil(radius / ring_step - 1e-9); // the ring outside it, but the middle's own band
            const int ring = radius <= band ? 0 : static_cast<int>(std::min(rings, 1.0 * tester_rings));
            if (ring >= tester_rings || radius < ring * ring_step - band) continue;
            for (YarnKind kind : {YarnKind::warp, YarnKind::weft}) {
                const YarnType& type = textile.type(kind, kind == YarnKind::warp ? end : pick);
                const double fibres = type.area * type.packing * type.fibre.density_kg_m3 * textile.segment_length(kind, end, pick);
                const bool on_top = textile.warp_up(end, pick) == (kind == YarnKind::warp);
                const auto own = static_cast<std::size_t>(textile.type_of(kind, kind == YarnKind::warp ? end : pick));
                const double liquid = (kind == YarnKind::warp ? of_warp : of_weft)[own][on_top ? 1 : 0];
                pins_.push_back({static_cast<std::size_t>(textile.segment(kind, end, pick)), ring, on_top, fibres, liquid});
                dry_[on_top ? 0 : 1][static_cast<std::size_t>(ring)] += fibres;
            }
        }
}

TesterReading TesterPins::read(const Frame& frame, const std::vector<float>& regain_at_start) const
{
    TesterReading water;
    for (const Pin& pin : pins_) {
        const std::size_t i = pin.segment;
        (pin.on_top ? water.top : water.bottom)[static_cast<std::size_t>(pin.ring)] +=
            pin.liquid * static_cast<double>(frame.liquid[i]) + pin.fibres * static_cast<double>(frame.regain[i] - regain_at_start[i]);
    }
    for (std::size_t ring = 0; ring < tester_rings; ++ring) {
        water.top[ring] = dry_[0][ring] > 0 ? 100 * water.top[ring] / dry_[0][ring] : 0;
        water.bottom[ring] = dry_[1][ring] > 0 ? 100 * water.bottom[ring] / dry_[1][ring] : 0;
    }
    return water;
}

double face_content(const RingContents& rings)
{
    double sum = 0, weighted = 0;
    for (double content : rings) {
        const double held = std::max(content, 0.0);
        sum += held;
        weighted += held * held;
    }
    return sum > 0 ? weighted / sum : 0;
}

ManagementIndices tester_indices(const std::vector<double>& time, const std::vector<TesterReading>& readings, const TesterFeed& feed)
{
    ManagementIndices indices;
    if (time.size() < 2) return indices;
    const Samples top = sampled(time, readings, &TesterReading::top), bottom = sampled(time, readings, &TesterReading::bottom);
    if (top.time.size() < 2) return indices;
    indices.top = face_indices(top, feed);
    indices.bottom = face_indices(bottom, feed);
    indices.one_way_transport = (area(bottom) - area(top)) / (top.time.back() - top.time.front());
    indices.ommc = overall_capability(indices.bottom.absorption_rate, indices.one_way_transport, indices.bottom.spreading_speed);
    return indices;
}

std::vector<std::string> tester_assumptions(double drop_ul, const TesterFeed& feed, double frame_interval)
{
    return {
        "Simulated, not measured: a tester reads conductances; here the water content is the mass of water over the dry mass.",
        fmt::format("Each face has seven rings of pins, in the middle and every {:g} mm; each reads the mean of the band of {:g} mm inside "
                    "it, of coarse cloths one and a half pitches.",
                    mm_from_metre(ring_step), mm_from_metre(ring_band)),
        fmt::format(
            "The pins' tips are cones that reach to a sensor depth of {:g} % of the thickness from their face. A finish that repels "
            "keeps that dry as far as it reaches; without one the depth changes nothing.",
            100 * sensor_depth),
        fmt::format("A ring reads wet above {:g} % of the dry mass of that half of the cloth, beyond what the cloth held at the start.",
                    wet_content),
        "The content of a face is that of the water in the yarns that lie on it, the mean over the rings, each weighted with its own "
        "content, so that a ring that is just becoming wet counts little; liquid on the cloth, and between the cloth and the lower sensor, "
        "is left out.",
        fmt::format("The tester samples every {:g} s; frames lie up to {:.3g} s apart during the feed and are joined by straight lines.",
                    tester_interval, frame_interval),
        fmt::format("The absorption rate is the mean slope from wetting until {:g} % of the largest content within the feed are first "
                    "reached, both over the content at wetting: that of a straight rise with the same area above it.",
                    100 * share_of_largest),
        drop_ul > 0
            ? fmt::format("The solution comes in drops of at most {:g} ul, each when the pump has delivered it, one every {:.3g} s. They "
                          "join a pool that the cloth absorbs; how they fall and strike is left out. Absorption rates are taken from "
                          "contents averaged over the last {:.3g} s, until so long after the pump stops, and rings that one drop reaches "
                          "count with the way it gained since an earlier drop reached a ring.",
                          drop_ul, feed.drop_interval, feed.drop_interval)
            : fmt::format("The solution flows evenly into a pool that the cloth absorbs; it covers at least the base of a half ball of "
                          "{:g} ul, a hanging drop.",
                          hanging_drop_ul)};
}

} // namespace hygroloom
