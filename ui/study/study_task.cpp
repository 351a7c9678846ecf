// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/study/study_task.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "gpu/backends.h"
#include "ui/results/device_choice.h"
#include "ui/results/plan_dialog.h"
#include "ui/study/study_cost.h"

namespace hygroloom {

StudyTask::StudyTask(WindowQueue& queue, QObject* parent) : QObject(parent), queue_(queue) {}

StudyTask::~StudyTask()
{
    cancel_ = true;
    if (thread_.joinable()) { thread_.join(); }
}

void StudyTask::post(std::function<void()> work) { QMetaObject::invokeMethod(this, std::move(work), Qt::QueuedConnection); }

void StudyTask::start(const std::shared_ptr<const Design>& design, const Study& study, const QString& folder, bool retry_failed)
{
    cancel_ = false;
    folder_ = folder;
    failure_.clear();
    progress_ = {};
    outcome_ = {};
    running_ = true;
    paused_ = false;
    if (thread_.joinable()) { thread_.join(); } // it has posted its last
    thread_ = std::jthread([this, design, study, folder, retry_failed] {
        const auto result = std::make_shared<Result>(run(*design, study, folder, retry_failed));
        post([this, result] {
            outcome_ = result->outcome;
            failure_ = result->failure;
            running_ = false;
            Q_EMIT ended();
        });
    });
    Q_EMIT progressed();
}

StudyTask::Result StudyTask::run(const Design& design, const Study& study, const QString& folder, bool retry_failed)
{
    Result result;
    const std::filesystem::path path = folder.toStdString();
    try {
        StudyOptions how;
        how.resume = true; // a folder with rows of another study is refused all the same
        how.retry_failed = retry_failed;
        const StudyNeeds needs = study_needs(design, study, path, how);
        ask_for_memory("One run of this study", static_cast<double>(needs.bytes_each), how.memory);
        const StudyShares shares = sharesOf(study, std::max<std::size_t>(needs.rows, 1), static_cast<double>(needs.bytes_each));
        how.threads = shares.threads;
        how.name = tr("Study").toStdString() + ", " + path.filename().string();
        const auto scenes = static_cast<int>(std::max<std::size_t>(needs.rows, 1));
        const auto places =
            std::make_shared<RunPlaces>(make_backends(backend_for(backendOfMany(), study.knobs), shares.jobs, scenes, needs.bytes_each));
        StudyCallbacks callbacks;
        callbacks.progress = [this](const StudyProgress& progress) {
            post([this, progress] {
                progress_ = progress;
                Q_EMIT progressed();
            });
        };
        callbacks.paused = [this](bool paused) {
            post([this, paused] {
                paused_ = paused;
                Q_EMIT progressed();
            });
        };
        callbacks.note = [this](const std::string& sentence) {
            post([this, text = QString::fromStdString(sentence)] { Q_EMIT noted(text); });
        };
        result.outcome = run_study(design, study, path, how, queue_.runs(), places, cancel_, callbacks);
        if (!result.outcome.cancelled) { merge_study(path); }
    } catch (const Cancelled&) {
        result.outcome.cancelled = true;
    } catch (const std::bad_alloc&) {
        result.failure = tr("The memory does not suffice for this study. Choose a lower fidelity, or fewer points.");
    } catch (const std::exception& error) {
        result.failure = QString::fromStdString(error.what());
    }
    return result;
}

void StudyTask::cancel() { cancel_ = true; }

QString StudyTask::progressText() const
{
    if (progress_.rows == 0) { return tr("Preparing the runs."); }
    QString text = tr("%1 of %2 runs").arg(progress_.ended).arg(progress_.rows);
    if (progress_.failed > 0) { text += tr(", %1 failed").arg(progress_.failed); }
    if (paused_) { return tr("%1, paused").arg(text); }
    // How far the first runs are says little: their time passes unevenly.
    constexpr double early = 0.25;
    const bool told = progress_.ended > progress_.kept || progress_.share >= early;
    const std::optional<double> left = told ? time_left(progress_.share, progress_.wall) : std::nullopt;
    return left && progress_.ended < progress_.rows ? tr("%1, %2 left").arg(text, roughDuration(*left)) : text;
}

} // namespace hygroloom
