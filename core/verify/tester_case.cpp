// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The moisture management tester on a made-up disc of wet cloth, whose indices follow by arithmetic.
#include "core/analysis/moisture_tester.h"
#include "core/base/units.h"
#include "core/verify/verify.h"

#include <limits>

namespace hygroloom {
namespace {

constexpr double duration = 120, feed = 20; // s, the standard's

Textile plain_cotton()
{
    Fabric fabric;
    fabric.warp.diameter_mm = fabric.weft.diameter_mm = 0.2;
    return build_textile({}, fabric, region_of_sample(fabric, 80, 80));
}

/// A disc in the middle holds a share of its content; the bottom face a part of what the top face holds.
Frame disc(const Textile& textile, double radius, double content, double bottom_share)
{
    Frame frame;
    frame.liquid.resize(static_cast<std::size_t>(textile.segments()));
    frame.regain.resize(frame.liquid.size());
    for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
        for (int end = 0; end < textile.ends(); ++end)
            for (int pick = 0; pick < textile.picks(); ++pick) {
                if (std::hypot(textile.x_of_end(end), textile.y_of_pick(pick)) > radius * (1 + 1e-9)) continue;
                const YarnType& type = textile.type(kind, kind == YarnKind::warp ? end : pick);
                const double fibres = type.area * type.packing * type.fibre.density_kg_m3 * textile.segment_length(kind, end, pick);
                const bool on_top = textile.warp_up(end, pick) == (kind == YarnKind::warp);
                frame.liquid[static_cast<std::size_t>(textile.segment(kind, end, pick))] =
                    static_cast<float>(0.01 * content * (on_top ? 1 : bottom_share) * fibres);
            }
    return frame;
}

/// What the rings of a disc show: those that it fills, and how much of the band of the next one.
struct ExpectedRings {
    int full = 0;       // rings but the middle
    double partial = 0; // share of the next ring's band
};

ExpectedRings rings_of(double radius_mm)
{
    const double step = mm_from_metre(ring_step), band = mm_from_metre(ring_band);
    ExpectedRings rings;
    rings.full = static_cast<int>(std::min(tester_rings - 1.0, std::floor(radius_mm / step + 1e-9)));
    const double next = step * (rings.full + 1), inner = next - band;
    if (rings.full + 1 < tester_rings && radius_mm > inner)
        rings.partial = (radius_mm * radius_mm - inner * inner) / (next * next - inner * inner);
    return rings;
}

std::vector<VerifyResult> tester(const VerifyValues& v, Backend&)
{
    const double radius = v.at("radius_mm").value, content = v.at("content_pct").value, rise = v.at("rise_s").value;
    const double bottom = v.at("bottom_share").value;
    const Textile cloth = plain_cotton();
    const TesterPins pins(cloth, true);
    const Frame dry = disc(cloth, metre_from_mm(radius), 0, 0), full = disc(cloth, metre_from_mm(radius), content, bottom);
    const TesterReading start = pins.read(dry, dry.regain), end = pins.read(full, dry.regain);
    const ManagementIndices m = tester_indices({0, rise, duration}, {start, end, end}, {feed, 0});

    const ExpectedRings rings = rings_of(radius);
    // Samples lie 0.1 s apart and are joined by straight lines; the last one below that share may bend the rise.
    const double bend = tester_interval * std::floor(rise / tester_interval + 1e-9), rate = content / rise;
    const double bent = bend >= share_of_largest * rise ? 0.0 : 1 - rise / (bend + tester_interval);
    const double first = tester_interval * std::max(1.0, std::ceil(wet_content / content * rise / tester_interval - 1e-5));
    const bool partly = rings.partial * content > wet_content;
    const int wet = rings.full + partly;
    // A ring that is partly wet lowers the mean over the rings by up to this share, and reads wet later.
    const double loose = partly ? (1 - rings.partial) / (rings.full + 2) + 0.02 : 1e-6;
    const double step = mm_from_metre(ring_step), transport = (bottom - 1) * content * (1 - 0.5 * rise / duration);
    const double fastest = step / tester_interval, whole = rings.full > 0 ? step / first + (rings.full - 1) * fastest : 0.0;
    // A ring that is partly wet reads so when its share of the content reaches the bound; how many crossings its band has decides the
    // sample.
    const double last = tester_interval * std::ceil(wet_content / (rings.partial * content) * rise / tester_interval - 1e-5);
    const double own = partly ? step / std::max(last - (rings.full > 0 ? first : 0.0), tester_interval) : 0.0;
    const double speed = wet > 0 ? (whole + own) / wet : 0.0;
    return {{"wetting_time_s", m.top.wetting_time.value_or(std::numeric_limits<double>::quiet_NaN()), 0, 1e-9},
            {"absorption_rate_pct_s", m.top.absorption_rate, rate, (loose + bent) * rate},
            {"maximum_wetted_radius_mm", m.top.maximum_wetted_radius, step * wet, 1e-9},
            {"spreading_speed_mm_s", m.top.spreading_speed, speed, partly ? std::max(own, fastest - own) / wet : 1e-6 * speed},
            {"one_way_transport_pct", m.one_way_transport, transport, loose * std::abs(transport) + 1e-3 * content}};
}

} // namespace

std::vector<VerifyCase> tester_cases()
{
    return {{"tester",
             "The moisture management tester on a disc of cloth that wets at once and fills evenly: its indices by arithmetic.",
             {{"radius_mm", 17, 1, 35, ""}, {"content_pct", 180, 10, 2000, ""}, {"rise_s", 4, 0.1, 20, ""}, {"bottom_share", 1, 0, 1, ""}},
             tester}};
}

} // namespace hygroloom
