// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/scene/shown_quantity.h"

#include "core/base/error.h"
#include "core/physics/water.h"

#include <fmt/format.h>

#include <algorithm>

namespace hygroloom {
namespace {

constexpr const char* names[] = {"water", "temperature", "humidity"};
constexpr double least_kelvin = 0.5; // a narrower scale would show noise as a pattern

} // namespace

ShownQuantity shown_quantity_from_name(const std::string& name)
{
    for (int i = 0; i < 3; ++i)
        if (name == names[i]) return static_cast<ShownQuantity>(i);
    throw Error("The quantity of a map must be water, temperature or humidity; \"" + name + "\" was given.");
}

const char* name_of(ShownQuantity quantity) { return names[static_cast<int>(quantity)]; }

std::string part_behind(ShownQuantity quantity)
{
    return quantity == ShownQuantity::temperature ? "heat" : quantity == ShownQuantity::humidity ? "vapour" : "";
}

std::string why_not_shown(const ModelPlan& plan, ShownQuantity quantity)
{
    const std::string part = part_behind(quantity);
    if (part.empty() || plan.on(part)) return {};
    const auto found = std::find_if(plan.parts.begin(), plan.parts.end(), [&](const PlannedPart& p) { return p.name == part; });
    const std::string reason = found == plan.parts.end() ? "" : found->reason;
    return reason.empty() ? fmt::format("This run does not model {}.", part) : fmt::format("This run does not model {}: {}", part, reason);
}

std::vector<float> segment_values(const Frame& frame, ShownQuantity quantity)
{
    if (quantity == ShownQuantity::water) return frame.saturation;
    if (quantity == ShownQuantity::temperature) return frame.temperature;
    std::vector<float> shares(frame.vapour.size());
    std::transform(frame.vapour.begin(), frame.vapour.end(), frame.temperature.begin(), shares.begin(),
                   [](float vapour, float temperature) {
                       return static_cast<float>(static_cast<double>(vapour) / saturation_concentration(static_cast<double>(temperature)));
                   });
    return shares;
}

ValueRange range_of_values(const Frame& frame, ShownQuantity quantity)
{
    if (quantity != ShownQuantity::temperature || frame.temperature.empty()) return {};
    const auto [low, high] = std::minmax_element(frame.temperature.begin(), frame.temperature.end());
    const double wider = std::max(0.0, 0.5 * (least_kelvin - static_cast<double>(*high - *low)));
    return {static_cast<double>(*low) - wider, static_cast<double>(*high) + wider};
}

ValueRange united(const ValueRange& one, const ValueRange& other) { return {std::min(one.low, other.low), std::max(one.high, other.high)}; }

} // namespace hygroloom
