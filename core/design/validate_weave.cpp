// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Whether a weave holds together, how far its floats reach, and how close its sett is to the closest that can be woven.
#include "core/design/issue_list.h"
#include "core/design/jam.h"
#include "core/design/weave_analysis.h"

namespace hygroloom {

namespace {

void warn_of_unbound(const Message& name, const std::vector<int>& unbound, const Place& where, IssueList& list)
{
    if (unbound.empty()) return;
    list.add(Severity::warning, "unbound_thread", where,
             unbound.size() == 1 ? say("{} {} never interlaces.", name, unbound.front() + 1)
                                 : say("{} {} and {} more never interlace.", name, unbound.front() + 1, unbound.size() - 1));
}

void warn_of_floats(const Message& name, const Floats& face, const Floats& back, double crossed_per_cm, const Place& where, IssueList& list)
{
    const int longest = std::max(face.longest, back.longest);
    const double mm = 10 * longest / crossed_per_cm;
    if (!std::isfinite(mm) || mm <= longest_float_mm) return;
    list.add(Severity::warning, "long_float", where,
             say("The longest {} float passes {} {} threads, {:.3g} on the {}; floats over {} snag.", name,
                 face.longest >= back.longest ? say("over") : say("under"), longest, Amount{mm, Stored::mm},
                 face.longest >= back.longest ? say("face") : say("back"), Amount{longest_float_mm, Stored::mm}));
}

} // namespace

void validate_weave(const Fabric& fabric, const Place& where, IssueList& list)
{
    const Weave& weave = fabric.weave;
    const Place at = where / "weave";
    if (weave.ends() > largest_repeat || weave.picks() > largest_repeat) {
        list.error("range", at,
                   say("A repeat may have up to {} ends and picks; given are {} and {}.", largest_repeat, weave.ends(), weave.picks()));
        return;
    }
    const WeaveAnalysis analysis = analyse(weave);
    warn_of_unbound(say("End"), analysis.unbound_ends, at, list);
    warn_of_unbound(say("Pick"), analysis.unbound_picks, at, list);
    if (analysis.cloths > 1)
        list.add(Severity::warning, "separate_cloths", at,
                 say("The weave falls into {} cloths that lie on one another without being joined; the upper one has {} of the "
                     "repeat's {} ends and {} of its {} picks.",
                     analysis.cloths, analysis.top_ends, weave.ends(), analysis.top_picks, weave.picks()));
    warn_of_floats(say("warp"), analysis.warp_face, analysis.warp_back, fabric.picks_per_cm, at, list);
    warn_of_floats(say("weft"), analysis.weft_face, analysis.weft_back, fabric.ends_per_cm, at, list);
}

void validate_sett(const Fabric& fabric, const FittedYarns& yarns, const Place& where, IssueList& list)
{
    const double share = sett_share_of_limit(fabric, yarns);
    const bool jams = racetracks_jam(fabric, yarns);
    if (share <= most_sett_share && !jams) return;
    const Message why = share > most_sett_share
                            ? say("are {:.0f} % of the limit of sett for these yarns and this weave; looms stop at about {:.0f} %",
                                  100 * share, 100 * most_sett_share)
                            : say("leave these yarns no room to bend round each other, flattened and squeezed as close as they can be");
    list.add(Severity::warning, "jammed", where / (fabric.ends_per_cm >= fabric.picks_per_cm ? "ends_per_cm" : "picks_per_cm"),
             say("{:.4g} ends and {:.4g} picks per {} {}. Lower a sett, or give finer yarns or longer floats.",
                 Bare{fabric.ends_per_cm, Stored::per_cm}, Bare{fabric.picks_per_cm, Stored::per_cm}, UnitAlone{Stored::per_cm, false},
                 why));
}

} // namespace hygroloom
