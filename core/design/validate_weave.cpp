// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Whether a weave holds together, how far its floats reach, and how close its sett is to the closest that can be woven.
#include "core/design/issue_list.h"
#include "core/design/jam.h"
#include "core/design/weave_analysis.h"

namespace hygroloom {

namespace {

void warn_of_unbound(const char* name, const std::vector<int>& unbound, const std::string& where, IssueList& list)
{
    if (unbound.empty()) return;
    list.add(Severity::warning, "unbound_thread", where,
             unbound.size() == 1 ? fmt::format("{} {} never interlaces.", name, unbound.front() + 1)
                                 : fmt::format("{} {} and {} more never interlace.", name, unbound.front() + 1, unbound.size() - 1));
}

void warn_of_floats(const char* name, const Floats& face, const Floats& back, double crossed_per_cm, const std::string& where,
                    IssueList& list)
{
    const int longest = std::max(face.longest, back.longest);
    const double mm = 10 * longest / crossed_per_cm;
    if (!std::isfinite(mm) || mm <= longest_float_mm) return;
    list.add(Severity::warning, "long_float", where,
             fmt::format("The longest {} float passes {} {} threads, {:.3g} mm on the {}; floats over {} mm snag.", name,
                         face.longest >= back.longest ? "over" : "under", longest, mm, face.longest >= back.longest ? "face" : "back",
                         longest_float_mm));
}

void warn_of_jam(const char* name, bool striped, const JamOfSystem& jam, const std::string& where, IssueList& list)
{
    if (jam.ashenhurst_percent <= 100) return;
    list.add(Severity::warning, "jammed", where,
             fmt::format("{:.4g} {} per cm are {:.0f} % of Ashenhurst's limit of {:.3g} for this weave and {}, and {:.0f} % of "
                         "Peirce's of {:.3g}; woven so close the yarns must flatten.",
                         jam.sett_per_cm, name, jam.ashenhurst_percent, jam.ashenhurst_per_cm,
                         striped ? "the mean diameter of own and extra yarns" : "these yarns", jam.peirce_percent, jam.peirce_per_cm));
}

} // namespace

void validate_weave(const Fabric& fabric, const std::string& where, IssueList& list)
{
    const Weave& weave = fabric.weave;
    const std::string at = where + ".weave";
    if (weave.ends() > largest_repeat || weave.picks() > largest_repeat) {
        list.error(
            "range", at,
            fmt::format("A repeat may have up to {} ends and picks; given are {} and {}.", largest_repeat, weave.ends(), weave.picks()));
        return;
    }
    const WeaveAnalysis analysis = analyse(weave);
    warn_of_unbound("End", analysis.unbound_ends, at, list);
    warn_of_unbound("Pick", analysis.unbound_picks, at, list);
    if (analysis.cloths > 1)
        list.add(Severity::warning, "separate_cloths", at,
                 fmt::format("The weave falls into {} cloths that lie on one another without being joined; the upper one has {} of the "
                             "repeat's {} ends and {} of its {} picks.",
                             analysis.cloths, analysis.top_ends, weave.ends(), analysis.top_picks, weave.picks()));
    warn_of_floats("warp", analysis.warp_face, analysis.warp_back, fabric.picks_per_cm, at, list);
    warn_of_floats("weft", analysis.weft_face, analysis.weft_back, fabric.ends_per_cm, at, list);
}

void validate_sett(const Fabric& fabric, const FittedYarns& yarns, const std::string& where, IssueList& list)
{
    const JamGauge jam = jam_gauge(fabric, yarns);
    const bool striped = yarns.warp.size() > 1 || yarns.weft.size() > 1;
    warn_of_jam("ends", striped, jam.warp, where + ".ends_per_cm", list);
    warn_of_jam("picks", striped, jam.weft, where + ".picks_per_cm", list);
}

} // namespace hygroloom
