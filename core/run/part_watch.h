// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Parts of the physics that a plan leaves out on an estimate are watched while running: the estimate is made again at each frame from how
// far the cloth has really got wet. It costs a pass over the segments of each frame, on the device where frames show cells. Where
// nothing was left out, it costs nothing.
#pragma once

#include "core/plan/switched_part.h"
#include "core/scene/frame.h"
#include "core/scene/scene.h"

namespace hygroloom {

/// Estimates what a plan's watched parts would change. Of vapour that is what would have evaporated by now and, from what is wet now, until
/// the end. As long as fibres take up nothing, wet cloth that does not dry only grows, and vapour that comes over the limit would stay
/// over it; fibres that absorb may dry it again.
class PartWatch {
public:
    /// The scene is the one that runs: parts that are switched on in it are seen as on.
    PartWatch(const Scene& scene, const ModelPlan& plan);

    /// Which parts have come over the limit at this frame; each is reported once. Frames come in order of time, the first at 0 s, at which
    /// nothing has happened yet.
    std::vector<SwitchedPart> see(const Frame& frame);
    /// Whether a later frame may report a part.
    bool is_watching() const;

private:
    struct Watched {
        SwitchedPart part;
        bool reported = false;
    };
    /// Of the wet cloth: segments count by wet_share(), as fibres' surfaces do.
    struct WetCloth {
        double area = 0;   ///< m2 of its faces
        double thirst = 0; ///< kg that its fibres could take up in all
    };
    bool in_cells() const { return scene_.cloth.shown_ends > 0; }
    WetCloth wet_cloth(const Frame& frame) const;
    double dries_until_end(double from) const;
    double warming(const Frame& frame) const;
    double share_of(const std::string& part, const Frame& frame, const WetCloth& wet, bool sorption, bool vapour) const;

    const Scene& scene_;
    double duration_;              ///< s
    double water_at_stake_;        ///< kg
    std::vector<Watched> watched_; ///< in the plan's order, with vapour where it may follow sorption
    std::vector<double> thirst_;   ///< kg/kg, of each type of yarn: regain that it can still gain from liquid
    double time_ = 0;              ///< s, of the last frame
    double rate_ = 0;              ///< kg/s, at which what was wet then would dry
    double evaporated_ = 0;        ///< kg that would have evaporated since the start
};

} // namespace hygroloom
