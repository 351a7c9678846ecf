// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/garment/garment_run.h"

#include "core/base/error.h"
#include "core/wear/garment_run.h"
#include "gpu/backends.h"
#include "ui/basics/quantity.h"

namespace hygroloom {

GarmentRun::GarmentRun(QObject* parent) : QObject(parent) {}

GarmentRun::~GarmentRun()
{
    cancel();
    if (thread_.joinable()) { thread_.join(); }
}

void GarmentRun::post(std::function<void()> work) { mail_.post(std::move(work)); }

void GarmentRun::setPaused(bool paused)
{
    if (!computing() || control_.pause == paused) { return; }
    control_.pause = paused;
    was_paused_ = true;
    Q_EMIT pausedChanged(paused);
}

void GarmentRun::cancel()
{
    control_.cancel = true;
    control_.pause = false;
}

void GarmentRun::begin(const std::function<void()>& work)
{
    if (thread_.joinable()) { thread_.join(); }
    control_.cancel = false;
    control_.pause = false;
    was_paused_ = false;
    running_ = true;
    thread_ = std::jthread([this, work] {
        Outcome outcome = Outcome::finished;
        QString sentence;
        try {
            work();
        } catch (const Cancelled&) {
            outcome = Outcome::cancelled;
        } catch (const NotEnoughMemory& error) {
            outcome = Outcome::memory_short;
            sentence = tr("This run takes about %1 of memory; %2 are free. Choose a lower fidelity.")
                           .arg(bytesText(error.needed), bytesText(error.available));
        } catch (const std::bad_alloc&) {
            outcome = Outcome::failed;
            sentence = tr("Not enough memory for this run. Choose a lower fidelity.");
        } catch (const std::exception& error) {
            outcome = Outcome::failed;
            sentence = QString::fromUtf8(error.what());
        }
        post([this, outcome, sentence] {
            running_ = false;
            Q_EMIT ended(outcome, sentence);
        });
    });
}

void GarmentRun::start(const Request& request)
{
    computing_ = true;
    begin([this, request] { compute(request); });
}

void GarmentRun::open(const std::filesystem::path& recording)
{
    computing_ = false;
    begin([this, recording] { read(recording); });
}

void GarmentRun::compute(const Request& request)
{
    const WearExperiment* wear = find_wear(*request.design, request.experiment);
    const GarmentParts parts = garment_parts(*request.design, *wear, request.base, [this] { return control_.cancel.load(); });
    const std::unique_ptr<Backend> backend = make_backend(request.backend);
    std::shared_ptr<const WearRecord> record;
    std::shared_ptr<WornRun> run;
    GarmentRunCallbacks callbacks;
    callbacks.memory_is_short = [this](const std::string&) { post([this] { Q_EMIT memoryIsShort(); }); };
    callbacks.device_failed = [this](const std::string& sentence) {
        post([this, said = QString::fromStdString(sentence)] { Q_EMIT deviceFailed(said); });
    };
    callbacks.started = [&](const std::shared_ptr<const WearRecord>& begun) {
        record = begun;
        run = newWornRun(record);
        if (!request.recording.empty()) { run->file = QString::fromStdString(request.recording.string()); }
        run->live = true;
        post([this, run] { Q_EMIT started(run); });
    };
    callbacks.frame = [&](const std::shared_ptr<const WearFrame>& frame, const WearMetrics& metrics) {
        post([this, record, frame, most = mostWater(record->layout, *frame), now = std::make_shared<const WearMetrics>(metrics)] {
            Q_EMIT frameArrived(frame, now, most);
        });
    };
    callbacks.progress = [this](const RunProgress& progress) { post([this, progress] { Q_EMIT progressed(progress); }); };
    GarmentRunOptions how;
    how.how = request.options;
    how.threads = request.threads;
    how.may_go_on_on_cpu = true;
    how.recording = request.recording;
    const FinishedGarment finished = run_garment(parts, how, *backend, control_, callbacks);
    if (!was_paused_) { learn_time(finished); }
    post([run, wall = finished.wall] { run->wall = wall; });
}

void GarmentRun::read(const std::filesystem::path& recording)
{
    const WearRecording file(recording);
    const auto record = std::make_shared<const WearRecord>(file.record());
    const auto run = newWornRun(record);
    run->file = QString::fromStdString(recording.string());
    run->wall = file.wall();
    post([this, run] { Q_EMIT started(run); });
    WearMetrics metrics(record->layout);
    for (int k = 0; k < file.frames(); ++k) {
        if (control_.cancel) { throw Cancelled(); }
        const auto frame = std::make_shared<const WearFrame>(file.frame(k));
        metrics.add(*frame);
        post([this, record, frame, most = mostWater(record->layout, *frame), now = std::make_shared<const WearMetrics>(metrics)] {
            Q_EMIT frameArrived(frame, now, most);
        });
    }
}

bool isGarmentRecording(const QString& path) { return WearRecording::is_one(path.toStdString()); }

} // namespace hygroloom
