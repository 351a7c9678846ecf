// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// One cloth of a lesson while it is simulated at live: drops fall on it, its air and its tilt change, and what it comes to is looked at.
#pragma once

#include "core/lesson/lesson.h"
#include "core/run/run_record.h"
#include "core/run/session.h"

#include <atomic>
#include <filesystem>

namespace hygroloom {

/// What a cloth has come to; a value.
struct ClothView {
    std::shared_ptr<const RunRecord> run;
    std::shared_ptr<const Frame> first, frame; ///< of single yarns
    ClimateParameters air;                     ///< as it is now
    double bound_at_start = 0;                 ///< kg
    ClothScore score;
    int released = 0;   ///< drops that the frame has
    int refused = 0;    ///< that were not dropped
    int sliding = 0;    ///< drops that would run down the tilted cloth
    std::string notice; ///< why the last drop was not dropped; empty: it was
};

/// A lesson's cloth as an ordinary run, with the drops and the air that it had.
struct RecordedCloth {
    RunRecord run;
    std::vector<std::shared_ptr<const Frame>> frames;
};
/// Throws FileError, also where what was done is no experiment that can be read again.
void write_recording(const RecordedCloth& cloth, const std::filesystem::path& path);

/// Notes that the air of an experiment changes at a time in s, from one that it has then. Many changes are joined to as many as an
/// experiment may have.
void change_air(std::vector<ClimateMoment>& later, double time, const Climate& before, const Climate& air);

/// How many frames of so many bytes are kept of a cloth for its recording.
std::size_t most_kept_frames(std::size_t bytes_each);

constexpr double drop_height_mm = 10;  ///< of a drop's lowest point over the cloth
constexpr double squeezed_share = 0.4; ///< of the pores' volume, left while a hand squeezes: an assumption

/// Why drops cannot stand on a cloth as caps, in a sentence; empty: they can. Precondition: why_not_on_table() finds nothing.
std::string why_no_drops(const Design& design, const Climate& air);

class RunningCloth {
public:
    /// Builds, plans and loads it. Precondition: why_not_on_table() finds nothing. Throws Error where why_no_drops() finds something.
    RunningCloth(const Design& design, const Climate& air);

    double time() const { return time_; }
    /// s of simulated time; ends early when asked to. Throws Error where water was lost.
    void advance(double until, const std::atomic<bool>& stop);
    /// Releases a drop now, m from the cloth's middle and m3, unless that drop would not stand on the cloth as a cap: see the view's
    /// notice.
    void drop(double x, double y, double volume);
    void blow(const Climate& air);
    /// See squeezed_share.
    void squeeze();
    /// Its lower edge, where pick 0 is, goes down.
    void tilt(double degrees);
    /// What it has come to.
    std::shared_ptr<const ClothView> view();
    RecordedCloth recorded() const;

private:
    void look();
    std::string why_no_drop(double x, double y, double volume) const;
    ClothScore score_of(const Frame& frame) const;
    int sliding(const Frame& frame) const;
    void keep(const std::shared_ptr<const Frame>& frame);

    std::unique_ptr<Backend> backend_;
    std::shared_ptr<RunRecord> run_;
    Experiment done_;              ///< with the drops and the air so far; no two drops at one time
    std::vector<double> asked_at_; ///< s, each drop: of the look at which it was released
    std::unique_ptr<Session> session_;
    double time_ = 0;           // s
    double tilt_ = 0;           // rad
    double landed_ = 0;         // s, the last drop; infinite: it was wiped off
    double absorbed_ = -1;      // s, after that; less than 0: not yet
    double bound_at_start_ = 0; // kg
    HandActs acts_;
    int refused_ = 0;
    std::string notice_; // why the last one was
    std::shared_ptr<const Frame> first_, last_;
    std::vector<std::shared_ptr<const Frame>> kept_; // for a recording
    double keep_every_ = 0.5;                        // s
};

} // namespace hygroloom
