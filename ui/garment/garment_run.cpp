// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/garment/garment_run.h"

#include "core/base/error.h"

namespace hygroloom {

GarmentRun::GarmentRun(WindowQueue& queue, QObject* parent) : QueuedRun(queue, tr("Choose a lower fidelity."), parent) {}

GarmentRun::~GarmentRun()
{
    stop_reading_ = true;
    stopAndWait();
}

void GarmentRun::start(const std::shared_ptr<const Design>& design, const std::string& experiment, const std::filesystem::path& base,
                       const RunOptions& options, const std::string& backend)
{
    const auto run = std::make_shared<std::shared_ptr<WornRun>>(); // once it has begun
    RunJob job{design, experiment, {}, base, options};
    job.beside.device_failed = [this](const std::string& sentence) {
        post([this, said = QString::fromStdString(sentence)] { Q_EMIT deviceFailed(said); });
    };
    job.worn.started = [this, run, file = options.recording](const std::shared_ptr<const WearRecord>& record) {
        *run = newWornRun(record);
        (*run)->file = QString::fromStdString(file.string());
        (*run)->live = true;
        post([this, begun = *run] { Q_EMIT started(begun); });
    };
    job.worn.frame = [this, run](const std::shared_ptr<const WearFrame>& frame, const WearMetrics& metrics) {
        show((*run)->record, frame, metrics);
    };
    begin(std::move(job), backend, [this, run](RunResult& result) { post([run, wall = result.garment->wall] { (*run)->wall = wall; }); });
}

void GarmentRun::show(const std::shared_ptr<const WearRecord>& record, const std::shared_ptr<const WearFrame>& frame,
                      const WearMetrics& metrics)
{
    post([this, record, frame, most = mostWater(record->layout, *frame), now = std::make_shared<const WearMetrics>(metrics)] {
        Q_EMIT frameArrived(frame, now, most);
    });
}

void GarmentRun::open(const std::filesystem::path& recording)
{
    if (reader_.joinable()) { reader_.join(); }
    stop_reading_ = false;
    reading_ = true;
    reader_ = std::jthread([this, recording] {
        RunResult result;
        try {
            read(recording);
        } catch (...) {
            result.error = std::current_exception();
        }
        const bool stopped = stop_reading_;
        post([this, stopped, sentence = failureText(result, {})] {
            reading_ = false;
            Q_EMIT ended(stopped ? Outcome::cancelled : sentence.isEmpty() ? Outcome::finished : Outcome::failed, sentence);
        });
    });
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
    for (int k = 0; k < file.frames() && !stop_reading_; ++k) {
        const auto frame = std::make_shared<const WearFrame>(file.frame(k));
        metrics.add(*frame);
        show(record, frame, metrics);
    }
}

void GarmentRun::cancel()
{
    stop_reading_ = true;
    QueuedRun::cancel();
}

bool isGarmentRecording(const QString& path) { return WearRecording::is_one(path.toStdString()); }

} // namespace hygroloom
