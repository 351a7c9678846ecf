// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/issue_list.h"

namespace hygroloom {
namespace {

void validate_activity(const WearExperiment& wear, const Place& where, IssueList& list)
{
    if (wear.activity.empty() || wear.activity.front().time_s != 0)
        list.error("activity_begins_late", where / "activity", say("A wearer's activity begins at 0 s; give its factor from there on."));
    if (wear.activity.size() > most_activities)
        list.error("range", where / "activity",
                   say("A wearer's activity may change {} times at most; given are {}.", most_activities, wear.activity.size()));
    double before = -1;
    for (std::size_t i = 0; i < wear.activity.size() && i < most_activities; ++i) {
        const Activity& moment = wear.activity[i];
        const Place at = where / "activity" / i;
        if (!list.fields(at, moment)) continue;
        if (moment.time_s <= before)
            list.error("activity_order", at / "time_s",
                       say("Activities stand in order of time; given is {} s after {} s.", moment.time_s, before));
        if (i > 0 && moment.time_s >= wear.duration_s)
            list.error("activity_after_end", at / "time_s",
                       say("The activity changes at {} s, not before the experiment's end at {} s.", moment.time_s, wear.duration_s));
        before = moment.time_s;
    }
}

} // namespace

void validate_wear(const Design& design, const WearExperiment& wear, const Place& where, IssueList& list)
{
    if (find_garment(design, wear.garment) == nullptr)
        list.error("unknown_garment", where / "garment", say("There is no garment named \"{}\" in the project.", wear.garment));
    if (find_liquid(design, wear.liquid) == nullptr)
        list.error("unknown_liquid", where / "liquid", say("There is no liquid named \"{}\" in the project or the library.", wear.liquid));
    validate_climate(wear.climate, where / "climate", list);
    list.fields(where, wear);
    if (wear.activity_file.empty())
        validate_activity(wear, where, list);
    else if (!wear.activity_file.ends_with(".csv"))
        list.error("unknown_activity", where / "activity",
                   say("Rates over time are a .csv beside the project; given is \"{}\".", wear.activity_file));
}

} // namespace hygroloom
