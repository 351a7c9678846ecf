// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/base/words.h"
#include "core/design/issue_list.h"

namespace hygroloom {
namespace {

void validate_activity(const WearExperiment& wear, const std::string& where, IssueList& list)
{
    if (wear.activity.empty() || wear.activity.front().time_s != 0)
        list.error("activity_begins_late", where + ".activity", "A wearer's activity begins at 0 s; give its factor from there on.");
    if (wear.activity.size() > most_activities)
        list.error("range", where + ".activity",
                   fmt::format("A wearer's activity may change {} times at most; given are {}.", most_activities, wear.activity.size()));
    double before = -1;
    for (std::size_t i = 0; i < wear.activity.size() && i < most_activities; ++i) {
        const Activity& moment = wear.activity[i];
        const std::string at = fmt::format("{}.activity[{}]", where, i);
        list.range(at + ".factor", "factor of the activity", moment.factor, 0, largest_activity);
        if (!list.range(at + ".time_s", "time of the activity", moment.time_s, 0, 1e6, "s")) continue;
        if (moment.time_s <= before)
            list.error("activity_order", at + ".time_s",
                       fmt::format("Activities stand in order of time; given is {} s after {} s.", moment.time_s, before));
        if (i > 0 && moment.time_s >= wear.duration_s)
            list.error(
                "activity_after_end", at + ".time_s",
                fmt::format("The activity changes at {} s, not before the experiment's end at {} s.", moment.time_s, wear.duration_s));
        before = moment.time_s;
    }
}

} // namespace

void validate_wear(const Design& design, const WearExperiment& wear, const std::string& where, IssueList& list)
{
    if (find_garment(design, wear.garment) == nullptr)
        list.error("unknown_garment", where + ".garment", fmt::format("There is no garment named \"{}\" in the project.", wear.garment));
    if (find_liquid(design, wear.liquid) == nullptr)
        list.error("unknown_liquid", where + ".liquid",
                   fmt::format("There is no liquid named \"{}\" in the project or the library.", wear.liquid));
    list.range(where + ".climate.temperature_c", "temperature", wear.climate.temperature_c, -10, 60, "C");
    list.range(where + ".climate.relative_humidity", "relative humidity", wear.climate.relative_humidity, 0, 1);
    list.range(where + ".climate.air_speed_m_s", "air speed", wear.climate.air_speed_m_s, 0, 20, "m/s");
    list.range(where + ".duration_s", "duration", wear.duration_s, 1, 86400, "s");
    list.range(where + ".initial_water_g_m2", "water at the start", wear.initial_water_g_m2, 0, 5000, "g/m2");
    if (wear.activity_file.empty())
        validate_activity(wear, where, list);
    else if (!wear.activity_file.ends_with(".csv"))
        list.error("unknown_activity", where + ".activity",
                   fmt::format("Rates over time are a .csv beside the project; given is \"{}\".", wear.activity_file));
}

} // namespace hygroloom
