// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Turns a fabric's derived sections into SI profiles; all positions follow from indices.
#include "core/geometry/textile.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

constexpr int profile_samples = 65;
constexpr double default_tortuosity = 1.2; // Li and Zhu 2003, of liquid in a yarn's pores

/// Distance from a point to a racetrack's skin, negative inside.
double distance_to_section(const Section& section, double across, double up)
{
    const double flat = 0.5 * (section.width - section.height);
    return std::hypot(std::max(std::abs(across) - flat, 0.0), up) - 0.5 * section.height;
}

Section metres(const Section& mm) { return {metre_from_mm(mm.width), metre_from_mm(mm.height)}; }

/// The section keeps its flat; its height at each sample is what the two crossed yarns leave it.
YarnProfile make_profile(const Interlacing& path, const Section& own, const Section& other)
{
    YarnProfile profile;
    for (int i = 0; i < profile_samples; ++i) {
        const double x = path.pitch * i / (profile_samples - 1);
        const double z = path.height_at(x);
        const double clearance = std::min(distance_to_section(other, x, z + 0.5 * own.height),
                                          distance_to_section(other, x - path.pitch, z - 0.5 * own.height));
        const double height = 2.0 * std::clamp(clearance, 0.1 * own.height, 0.5 * own.height);
        profile.height.push_back(z);
        profile.slope.push_back(path.slope_at(x));
        profile.half_height.push_back(0.5 * height);
        profile.half_width.push_back(0.5 * (own.width - own.height + height));
    }
    return profile;
}

YarnSystem make_system(const Design& design, const Fabric& fabric, const Yarn& yarn, const YarnQuantities& quantities,
                       const YarnQuantities& other, int count)
{
    YarnSystem system;
    system.count = count;
    system.pitch = metre_from_mm(quantities.pitch_mm);
    system.section = metres(quantities.section_mm);
    system.path = interlace(metre_from_mm(other.pitch_mm), system.section, metres(other.section_mm));
    system.profile = make_profile(system.path, system.section, metres(other.section_mm));
    system.area = section_area(system.section);
    system.packing = quantities.packing_factor_in_fabric;
    system.pore_radius = metre_from_um(fabric.measured.capillary_radius_um.value_or(quantities.pore_radius_um));
    system.tortuosity = fabric.measured.tortuosity.value_or(default_tortuosity);
    system.contact_angle = radian_from_degree(quantities.contact_angle_deg);
    system.fibre = blended_material(design, yarn.material);
    return system;
}

double interpolated(const std::vector<double>& samples, double position)
{
    const double at = std::clamp(position, 0.0, 1.0) * static_cast<double>(samples.size() - 1);
    const auto low = std::min(static_cast<std::size_t>(at), samples.size() - 2);
    return samples[low] + (samples[low + 1] - samples[low]) * (at - static_cast<double>(low));
}

int positive_modulo(int value, int modulus) { return ((value % modulus) + modulus) % modulus; }

} // namespace

double Textile::half_thickness() const { return 0.5 * (warp.section.height + weft.section.height); }

double Textile::height_at_crossing(YarnKind kind, int end, int pick) const
{
    const bool on_top = warp_up(end, pick) == (kind == YarnKind::warp);
    return on_top ? system(kind).path.amplitude : -system(kind).path.amplitude;
}

bool Textile::changes_after(YarnKind kind, int end, int pick) const
{
    const bool along_warp = kind == YarnKind::warp;
    return warp_up(end, pick) != warp_up(end + (along_warp ? 0 : 1), pick + (along_warp ? 1 : 0));
}

double Textile::segment_length(YarnKind kind, int end, int pick) const
{
    const Interlacing& path = system(kind).path;
    const bool along_warp = kind == YarnKind::warp;
    const bool before = changes_after(kind, end - (along_warp ? 0 : 1), pick - (along_warp ? 1 : 0));
    const bool after = changes_after(kind, end, pick);
    return 0.5 * ((before ? path.length : path.pitch) + (after ? path.length : path.pitch));
}

TextileRegion region_of_sample(const Fabric& fabric, double width_mm, double height_mm)
{
    // Rounded to a millionth of a pitch first, so that 2 cm at 35 ends/cm are 70 ends and not 69.
    const auto whole = [](double crossings) { return std::max(1, static_cast<int>(std::floor(crossings + 1e-6))); };
    return {0, 0, whole(0.1 * width_mm * fabric.ends_per_cm), whole(0.1 * height_mm * fabric.picks_per_cm)};
}

Textile build_textile(const Design& design, const Fabric& fabric, const TextileRegion& region)
{
    Textile textile;
    textile.quantities = derive_quantities(design, fabric);
    const FabricQuantities& quantities = textile.quantities;
    textile.warp = make_system(design, fabric, fabric.warp, quantities.warp, quantities.weft, region.ends);
    textile.weft = make_system(design, fabric, fabric.weft, quantities.weft, quantities.warp, region.picks);
    textile.weave = fabric.weave;
    textile.first_end = positive_modulo(region.first_end, fabric.weave.ends());
    textile.first_pick = positive_modulo(region.first_pick, fabric.weave.picks());
    return textile;
}

YarnPoint yarn_point(const Textile& textile, YarnKind kind, int yarn, int at, double offset)
{
    const bool is_warp = kind == YarnKind::warp;
    const YarnSystem& system = textile.system(kind);
    const int end = is_warp ? yarn : at;
    const int pick = is_warp ? at : yarn;
    const int step = offset < 0 ? -1 : 1;
    const double side = textile.height_at_crossing(kind, end, pick) > 0 ? 1.0 : -1.0;
    const bool changes = step > 0 ? textile.changes_after(kind, end, pick)
                                  : textile.changes_after(kind, end - (is_warp ? 0 : 1), pick - (is_warp ? 1 : 0));
    const double position = changes ? std::abs(offset) : 0.0;
    const double slope = changes ? side * step * interpolated(system.profile.slope, position) : 0.0;
    const double height = side * (changes ? interpolated(system.profile.height, position) : system.path.amplitude);
    const double norm = 1.0 / std::sqrt(1.0 + slope * slope);
    const double along = offset * system.path.pitch;

    YarnPoint point;
    point.half_height = interpolated(system.profile.half_height, position);
    point.half_width = interpolated(system.profile.half_width, position);
    if (is_warp) {
        point.centre = {textile.x_of_end(end), textile.y_of_pick(pick) + along, height};
        point.tangent = {0, norm, slope * norm};
    } else {
        point.centre = {textile.x_of_end(end) + along, textile.y_of_pick(pick), height};
        point.tangent = {norm, 0, slope * norm};
    }
    return point;
}

} // namespace hygroloom
