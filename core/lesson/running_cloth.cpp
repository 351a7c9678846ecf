// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/lesson/running_cloth.h"

#include "core/analysis/metrics.h"
#include "core/base/error.h"
#include "core/base/moment.h"
#include "core/design/validate.h"
#include "core/physics/caps.h"
#include "core/run/plan_run.h"
#include "core/run/recording.h"
#include "core/scene/ledger_closes.h"
#include "core/scene/scene.h"
#include "core/solver/cap_shapes.h"
#include "core/solver/yarn_start.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hygroloom {
namespace {

constexpr double cubic_mm = 1e-9;    // m3, an ul
constexpr double drops_apart = 2e-3; // s; drops of an experiment that appear together must not overlap

double ul_of(double water, const Scene& scene) { return water / scene.climate.density / cubic_mm; }

std::size_t bytes_of(const Frame& frame)
{
    std::size_t values = frame.shells.size() + 3 * (frame.positions.size() + frame.velocities.size()) + frame.pressures.size();
    for (const FrameField& field : frame_fields) values += field.values ? field.in(frame).size() : 0;
    for (const auto& [name, other] : frame.others) values += other.size();
    return sizeof(Frame) + values * sizeof(float) + frame.caps.size() * sizeof(FrameCap) + frame.cells.size() * sizeof(CellSums);
}

/// Planned for drops of any size that the table offers.
Design planned_design(const Design& design, const Climate& air)
{
    Design whole = design;
    whole.experiments = {table_experiment(air)};
    whole.experiments[0].droplets = {Droplet{most_drop_ul, 0, {0, 0}, drop_height_mm, 0}};
    return whole;
}

/// A hand may start the dryer at any time.
ModelPlan plan_of_table(const Design& planned, const Textile& textile)
{
    return plan_run(planned, textile, planned.experiments[0], Fidelity::live, {{"sorption", true}, {"vapour", true}, {"heat", true}});
}

/// Why drops do not stand as caps, in a sentence; empty: they do.
std::string why_no_caps(const ModelPlan& plan, const std::string& fabric)
{
    for (const PlannedPart& part : plan.parts)
        if (part.name == "cap" && !part.on) return "On \"" + fabric + "\" drops do not stand as caps: " + part.reason;
    return {};
}

bool stands(const Ledger& ledger) { return ledger.water_free > 1e-9 * ledger.water_delivered; }

} // namespace

std::string why_no_drops(const Design& design, const Climate& air)
{
    const Design whole = planned_design(design, air);
    const Textile textile = textile_of_run(whole, whole.fabrics.at(0), whole.experiments[0]);
    return why_no_caps(plan_of_table(whole, textile), whole.fabrics[0].name);
}

RunningCloth::RunningCloth(const Design& design, const Climate& air)
    : backend_(make_cpu_backend()), run_(std::make_shared<RunRecord>()), done_(table_experiment(air))
{
    const Design whole = planned_design(design, air);
    const Experiment& experiment = whole.experiments[0];
    RunRecord& run = *run_;
    run.design = design;
    run.design.experiments = {done_};
    run.fabric = design.fabrics.at(0).name;
    run.experiment = done_.name;
    run.textile = textile_of_run(whole, whole.fabrics[0], experiment);
    run.plan = plan_of_table(whole, run.textile);
    if (const std::string reason = why_no_caps(run.plan, run.fabric); !reason.empty()) throw Error(reason);
    run.threads = 1;
    run.date = date_now();
    run.backend = backend_->name();
    backend_->set_threads(run.threads);
    run.device = backend_->device();
    Scene scene = build_scene(whole, run.textile, experiment, run.plan, run.seed);
    scene.supply.droplets.clear();
    session_ = std::make_unique<Session>(*backend_, std::move(scene), run.plan.bundling());
    session_->load();
    first_ = std::make_shared<const Frame>(session_->of_single_yarns(session_->take_frame().get()));
    bound_at_start_ = first_->ledger.water_bound;
    last_ = first_;
    keep(first_);
}

void RunningCloth::advance(double until, const std::atomic<bool>& stop)
{
    while (time_ < until && !stop) time_ = session_->advance(until);
    if (!stop) look();
}

void RunningCloth::look()
{
    auto frame = std::make_shared<Frame>(session_->of_single_yarns(session_->take_frame().get()));
    frame->time = time_;
    if (!ledger_closes(frame->ledger, session_->scene()))
        throw Error("The water ledger does not close; this is a fault of the program. Reset the table.");
    const Ledger& ledger = frame->ledger;
    if (stands(ledger) || ledger.water_delivered <= 0 || time_ < landed_)
        absorbed_ = -1;
    else if (absorbed_ < 0)
        absorbed_ = std::max(0.0, ledger.free_until - landed_);
    last_ = std::move(frame);
    keep(last_);
}

std::string RunningCloth::why_no_drop(double x, double y, double volume) const
{
    if (done_.droplets.size() >= static_cast<std::size_t>(most_droplets))
        return fmt::format("This cloth has had {} drops, the most that an experiment has. Reset the table to go on.", most_droplets);
    if (time_ >= done_.duration_s) return fmt::format("A lesson takes {:g} s at most. Reset the table to go on.", done_.duration_s);
    const Scene& scene = session_->scene();
    const double weight = scene.climate.density * gravity_acceleration / scene.climate.surface_tension;
    const CapShapes& shapes = CapShapes::table();
    const double own = shapes.base(volume, scene.caps.advancing, weight), ball = std::cbrt(3.0 * volume / (4.0 * pi));
    const double speed = std::sqrt(2.0 * gravity_acceleration * metre_from_mm(drop_height_mm));
    double joined = volume, sum_x = x * volume, sum_y = y * volume;
    const auto join = [&](double cap_x, double cap_y, double cap_volume, double cap_base) {
        if (std::hypot(cap_x - x, cap_y - y) > own + std::max(cap_base, own)) return;
        joined += cap_volume;
        sum_x += cap_x * cap_volume;
        sum_y += cap_y * cap_volume;
    };
    for (const FrameCap& cap : last_->caps) join(cap.x, cap.y, cap.volume, cap.base);
    for (std::size_t k = 0; k < asked_at_.size(); ++k) { // those that the last look does not have yet
        if (asked_at_[k] < last_->time) continue;
        const Droplet& drop = done_.droplets[k];
        const double its = drop.volume_ul * cubic_mm;
        join(metre_from_mm(drop.at_mm[0]), metre_from_mm(drop.at_mm[1]), its, shapes.base(its, scene.caps.advancing, weight));
    }
    const double base = std::max({own, shapes.base(joined, scene.caps.advancing, weight),
                                  impact_base(scene.climate.surface_tension, scene.climate.density, ball, speed)});
    const double half = 0.5 * metre_from_mm(lesson_cloth_mm);
    if (std::max({std::abs(x), std::abs(y), std::abs(sum_x / joined), std::abs(sum_y / joined)}) + base > half)
        return "A drop here would reach over the cloth's edge. Drop nearer its middle.";
    return {};
}

void RunningCloth::drop(double x, double y, double volume)
{
    notice_ = why_no_drop(x, y, volume);
    if (!notice_.empty()) {
        ++refused_;
        return;
    }
    const PutDrop put{x, y, volume, metre_from_mm(drop_height_mm), 0};
    session_->poke(put);
    const double at = done_.droplets.empty() ? time_ : std::max(time_, done_.droplets.back().time_s + drops_apart);
    done_.droplets.push_back({volume / cubic_mm, at, {mm_from_metre(x), mm_from_metre(y)}, drop_height_mm, 0});
    asked_at_.push_back(time_);
    landed_ = time_ + std::sqrt(2.0 * put.height / gravity_acceleration);
    absorbed_ = -1;
}

void RunningCloth::blow(const Climate& air)
{
    const Climate before = climate_at(done_, time_);
    session_->poke(air_of(air, time_, run_->textile, done_));
    change_air(done_.climates, time_, before, air);
}

void RunningCloth::squeeze()
{
    acts_.squeezed = time_;
    if (stands(last_->ledger) && time_ >= landed_) {
        acts_.wiped = time_;
        landed_ = std::numeric_limits<double>::infinity();
    }
    session_->poke(Squeeze{squeezed_share});
    look();
}

void RunningCloth::tilt(double degrees)
{
    tilt_ = radian_from_degree(degrees);
    acts_.tilted = time_;
    session_->poke(Tilt{gravity_acceleration * std::sin(tilt_), 0});
}

/// A drop stays on a slope while the surface tension along its rim holds its weight (Furmidge 1962).
int RunningCloth::sliding(const Frame& frame) const
{
    const Scene& scene = session_->scene();
    const double holds = scene.climate.surface_tension * (std::cos(scene.caps.receding) - std::cos(scene.caps.advancing)); // N/m
    return static_cast<int>(std::count_if(frame.caps.begin(), frame.caps.end(), [&](const FrameCap& cap) {
        const double pulls = scene.climate.density * gravity_acceleration * cap.volume * std::sin(std::abs(tilt_));
        return cap.base > 0 && pulls > holds * 2.0 * cap.base;
    }));
}

ClothScore RunningCloth::score_of(const Frame& frame) const
{
    const Textile& textile = run_->textile;
    int wet = 0;
    for (int end = 0; end < textile.ends(); ++end)
        for (int pick = 0; pick < textile.picks(); ++pick) {
            const YarnKind top = textile.warp_up(end, pick) ? YarnKind::warp : YarnKind::weft;
            wet += static_cast<double>(frame.saturation[static_cast<std::size_t>(textile.segment(top, end, pick))]) >= wet_saturation;
        }
    const Scene& scene = session_->scene();
    ClothScore score;
    score.drops = static_cast<int>(done_.droplets.size());
    score.wet_area_mm2 = wet * mm_from_metre(textile.warp.pitch) * mm_from_metre(textile.weft.pitch);
    score.radius_mm = std::max(0.0, mm_from_metre(wetted_circle(textile, frame, Face::top).radius));
    score.standing_ul = ul_of(frame.ledger.water_free, scene);
    score.in_fibres_ul = ul_of(frame.ledger.water_bound - bound_at_start_, scene);
    score.run_off_ul = ul_of(frame.ledger.water_dripped, scene);
    score.evaporated_ul = ul_of(frame.ledger.water_evaporated, scene);
    score.wiped = std::isinf(landed_);
    score.absorbed_s = absorbed_;
    return score;
}

std::shared_ptr<const ClothView> RunningCloth::view()
{
    auto view = std::make_shared<ClothView>();
    view->run = run_;
    view->first = first_;
    view->frame = last_;
    view->air = climate_at(session_->scene(), time_);
    view->bound_at_start = bound_at_start_;
    view->score = score_of(*last_);
    view->released = static_cast<int>(std::count_if(asked_at_.begin(), asked_at_.end(), [this](double at) { return at < last_->time; }));
    view->refused = refused_;
    view->sliding = sliding(*last_);
    view->notice = notice_;
    return view;
}

/// Where there are many, every second one goes.
void RunningCloth::keep(const std::shared_ptr<const Frame>& frame)
{
    if (!kept_.empty() && frame->time == kept_.back()->time) { // the cloth was squeezed since
        kept_.back() = frame;
        return;
    }
    if (!kept_.empty() && frame->time < kept_.back()->time + keep_every_) return;
    kept_.push_back(frame);
    if (kept_.size() < most_kept_frames(bytes_of(*frame))) return;
    for (std::size_t k = 0; 2 * k < kept_.size(); ++k) kept_[k] = kept_[2 * k];
    kept_.resize((kept_.size() + 1) / 2);
    keep_every_ *= 2;
}

RecordedCloth RunningCloth::recorded() const
{
    RecordedCloth cloth{*run_, kept_};
    if (last_->time > kept_.back()->time) cloth.frames.push_back(last_);
    cloth.run.acts = acts_;
    Experiment& experiment = cloth.run.design.experiments[0];
    experiment = done_;
    const auto fell = std::count_if(asked_at_.begin(), asked_at_.end(), [this](double at) { return at < time_; });
    experiment.droplets.resize(static_cast<std::size_t>(fell));
    experiment.duration_s = std::max(0.1, time_);
    if (fell > 0) experiment.duration_s = std::max(experiment.duration_s, experiment.droplets.back().time_s + drops_apart);
    return cloth;
}

std::size_t most_kept_frames(std::size_t bytes_each)
{
    constexpr std::size_t fewest = 20, most = 120, room = 100'000'000; // bytes
    return std::clamp(room / std::max<std::size_t>(1, bytes_each), fewest, most);
}

void change_air(std::vector<ClimateMoment>& later, double time, const Climate& before, const Climate& air)
{
    constexpr std::size_t most_moments = 1000;           // of an experiment; see validate_climates()
    constexpr double at_once = 1e-3;                     // s; in an experiment air changes evenly
    if (!later.empty() && later.back().time_s >= time) { // nobody has felt the last one yet
        later.back().climate = air;
        return;
    }
    if (later.size() + 2 > most_moments) {
        // Each change is two moments, from and to. Of the airs between two changes the shortest goes.
        std::size_t shortest = 1;
        for (std::size_t k = 1; k + 1 < later.size(); k += 2)
            if (later[k + 1].time_s - later[k].time_s < later[shortest + 1].time_s - later[shortest].time_s) shortest = k;
        const auto first = later.begin() + static_cast<std::ptrdiff_t>(shortest);
        later.erase(first, first + 2);
    }
    const double from = std::max(time, later.empty() ? at_once : later.back().time_s + at_once);
    later.push_back({from, before});
    later.push_back({from + at_once, air});
}

void write_recording(const RecordedCloth& cloth, const std::filesystem::path& path)
{
    const std::vector<Issue> issues = validate(cloth.run.design);
    if (const Issue* error = first_error(issues)) throw FileError(path.string() + ": This cloth cannot be recorded. " + error->text());
    RecordingWriter writer(path, cloth.run);
    for (const auto& frame : cloth.frames) writer.append(*frame);
    writer.finish(0);
}

} // namespace hygroloom
