// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/garment/garment_run.h"

#include "core/base/error.h"
#include "gpu/backends.h"
#include "ui/basics/quantity.h"

#include <QDateTime>

#include <chrono>

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
    const auto start = std::chrono::steady_clock::now();
    const WearExperiment* wear = find_wear(*request.design, request.experiment);
    const GarmentParts parts = garment_parts(*request.design, *wear, request.base, [this] { return control_.cancel.load(); });
    const GarmentScene scene = garment_scene(parts, resolution_of(request.options));
    if (control_.cancel) { throw Cancelled(); }
    if (!scene.memory_is_short.empty()) {
        post([this] { Q_EMIT memoryIsShort(); });
    }
    const std::unique_ptr<Backend> backend = make_backend(request.backend);
    backend->set_threads(request.threads);
    auto record = std::make_shared<WearRecord>();
    record->design = *request.design;
    record->layout = wear_layout(parts, scene);
    record->fidelity = name_of(request.options.fidelity);
    record->backend = backend->name();
    record->device = backend->device();
    record->date = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
    const auto run = newWornRun(record);
    std::optional<WearWriter> writer;
    if (!request.recording.empty()) {
        writer.emplace(request.recording, *record);
        run->file = QString::fromStdString(request.recording.string());
    }
    run->live = true;
    post([this, run] { Q_EMIT started(run); });
    WearMetrics metrics(record->layout);
    WearCallbacks callbacks;
    callbacks.frame = [&](const std::shared_ptr<const WearFrame>& frame) {
        metrics.add(*frame);
        if (writer) { writer->append(*frame); }
        post([this, record, frame, most = mostWater(record->layout, *frame), now = std::make_shared<const WearMetrics>(metrics)] {
            Q_EMIT frameArrived(frame, now, most);
        });
    };
    callbacks.progress = [this](const RunProgress& progress) { post([this, progress] { Q_EMIT progressed(progress); }); };
    run_wear(scene, *parts.wear, *backend, control_, callbacks);
    const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (writer) { writer->finish(wall); }
    post([run, wall] { run->wall = wall; });
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
