// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/export/card_numbers.h"

#include "core/base/error.h"
#include "core/design/looks.h"
#include "core/queue/card_runs.h"
#include "gpu/backends.h"
#include "ui/results/device_choice.h"

#include <algorithm>
#include <numeric>

namespace hygroloom {
namespace {

const Fabric& fabricOf(const Design& design, int fabric) { return design.fabrics[static_cast<std::size_t>(fabric)]; }

/// Whether the numbers of a card of both are the same.
bool sameCloth(const Design& a, const Fabric& fabric_a, const Design& b, const Fabric& fabric_b)
{
    return a.materials == b.materials && a.liquids == b.liquids && without_look(fabric_a) == without_look(fabric_b);
}

std::vector<CardNumbers::Row> known(const std::vector<LaboratoryNumber>& numbers)
{
    std::vector<CardNumbers::Row> rows;
    for (const LaboratoryNumber& number : numbers) { rows.push_back({number, true}); }
    return rows;
}

} // namespace

CardNumbers::CardNumbers(Document& document, WindowQueue& queue, QObject* parent) : QObject(parent), document_(document), queue_(queue)
{
    connect(&document_, &Document::designChanged, this, &CardNumbers::take);
}

CardNumbers::~CardNumbers() { cancel(); }

void CardNumbers::post(std::function<void()> work) { QMetaObject::invokeMethod(this, std::move(work), Qt::QueuedConnection); }

void CardNumbers::follow(bool on)
{
    follows_ = on;
    if (on) { take(); }
}

/// Whether a fabric of the design is the cloth that the card is of.
bool CardNumbers::isIn(const Design& design) const
{
    return std::any_of(design.fabrics.begin(), design.fabrics.end(),
                       [&](const Fabric& fabric) { return sameCloth(*design_, fabricOf(*design_, fabric_), design, fabric); });
}

void CardNumbers::stopTests()
{
    if (running_ && !cancel_) {
        Q_EMIT failed(tr("The tests of the technical card of %1 were stopped: the fabric is another now.")
                          .arg(QString::fromStdString(fabricOf(*design_, fabric_).name)));
    }
    cancel();
}

/// The numbers stay; prices and colours are those of the design.
void CardNumbers::relabel(const std::shared_ptr<const Design>& design, int fabric)
{
    const bool changed_labels = fabricOf(*design_, fabric_) != fabricOf(*design, fabric);
    const auto fitted = document_.fitted();
    design_ = design;
    fabric_ = fabric;
    if (!changed_labels || !fitted) { return; }
    Card labelled = card_without_numbers(*design, fabricOf(*design, fabric), *fitted);
    labelled.numbers = card_->numbers;
    labelled.seconds = card_->seconds;
    card_ = std::make_shared<const Card>(std::move(labelled));
    Q_EMIT changed();
}

void CardNumbers::take()
{
    const auto design = document_.design();
    if (!follows_) {
        if (running_ && !cancel_ && !isIn(*design)) { stopTests(); }
        return;
    }
    const int fabric = document_.fabric() ? document_.fabricIndex() : -1;
    if (design_ && fabric >= 0 && fabric_ >= 0 && sameCloth(*design_, fabricOf(*design_, fabric_), *design, fabricOf(*design, fabric))) {
        if (card_) { return relabel(design, fabric); }
        if (computing() && fabricOf(*design_, fabric_) == fabricOf(*design, fabric)) { return; }
    }
    stopTests();
    job_.drop();
    if (card_) { before_ = rows(); }
    card_.reset();
    tested_.clear();
    ++cloth_;
    design_ = design;
    fabric_ = fabric;
    if (const auto fitted = document_.fitted(); fabric >= 0 && fitted) {
        job_.run([this, design, fabric = *document_.fabric(), fitted](const NewestJob::Turn& turn) {
            auto card = std::make_shared<const Card>(card_of(*design, fabric, *fitted));
            turn.deliver([this, card] {
                card_ = card;
                Q_EMIT changed();
            });
        });
    }
    Q_EMIT changed();
}

std::vector<CardNumbers::Row> CardNumbers::rows() const
{
    if (!card_) {
        std::vector<Row> rows;
        if (document_.fitted()) { rows = known(quick_numbers(*document_.fitted())); }
        for (const Row& old : before_) {
            const auto same = [&old](const Row& row) { return row.number.key == old.number.key; };
            if (std::none_of(rows.begin(), rows.end(), same)) { rows.push_back({old.number, false}); }
        }
        return rows;
    }
    std::vector<Row> rows = known(card_->numbers.found);
    for (const std::string& key : card_test_keys()) {
        if (tested_.contains(key)) { continue; }
        try {
            const Fabric& fabric = fabricOf(*design_, fabric_);
            for (const LaboratoryNumber& number : unknown_numbers(card_test(key, fabric, card_->numbers.found))) {
                rows.push_back({number, false});
            }
        } catch (const Error&) { // a run will say why not
        }
    }
    return rows;
}

bool CardNumbers::canRun() const { return card_ && !running_ && tested_.size() < card_test_keys().size(); }

void CardNumbers::run()
{
    if (thread_.joinable()) { thread_.join(); }
    Task tests{cloth_, design_, fabric_, card_, {}};
    for (const std::string& key : card_test_keys()) {
        if (!tested_.contains(key)) { tests.tests.push_back(key); }
    }
    cancel_ = false;
    running_ = true;
    paused_ = false;
    thread_ = std::jthread([this, tests] {
        QString sentence;
        try {
            runTests(tests);
        } catch (const Cancelled&) {
            // nothing to say
        } catch (const std::bad_alloc&) {
            sentence = tr("Not enough memory for the tests of the card.");
        } catch (const std::exception& error) {
            sentence = QString::fromStdString(error.what());
        }
        post([this, sentence] {
            running_ = false;
            if (!sentence.isEmpty()) { Q_EMIT failed(sentence); }
            Q_EMIT changed();
        });
    });
    Q_EMIT changed();
}

void CardNumbers::runTests(const Task& task)
{
    const Fabric& fabric = fabricOf(*task.design, task.fabric);
    CardRuns what{task.tests, {}};
    what.how.fidelity = Fidelity::live;
    what.how.may_go_on_on_cpu = true;
    const CardJobs jobs = card_jobs(*task.design, fabric, task.card->numbers, what);
    const auto count = std::max(1, static_cast<int>(jobs.jobs.size()));
    const auto places = std::make_shared<RunPlaces>(make_backends(backendOfMany(), 0, count, static_cast<std::size_t>(jobs.bytes)));
    std::mutex mutex; // several run side by side
    std::vector<double> shares(jobs.jobs.size());
    std::set<std::string> tested(task.tests.begin(), task.tests.end()); // those that cannot be done, and those that came to an end
    for (const NamedJob& job : jobs.jobs) { tested.erase(job.name); }
    ComparedWatch watch;
    watch.begins = [&](std::size_t i, RunJob& job) {
        job.beside.progress = [&, i](const RunProgress& now) {
            const std::lock_guard lock(mutex);
            shares[i] = now.duration > 0 ? now.simulated / now.duration : 0;
            const double all = std::accumulate(shares.begin(), shares.end(), 0.0) / static_cast<double>(shares.size());
            post([this, all] { Q_EMIT progressed(all); });
        };
    };
    watch.paused = [this](bool paused) {
        post([this, paused] {
            paused_ = paused;
            Q_EMIT changed();
        });
    };
    if (expected_backend(backendOfMany()) != "cpu") {
        watch.room = [] { return memory_for_scenes("auto"); };
    }
    watch.came = [&](std::size_t i, const RunResult&) { tested.insert(jobs.jobs[i].name); };
    const LaboratoryNumbers last = run_card_jobs(jobs, 1, queue_.runs(), places, cancel_, watch,
                                                 [&](const LaboratoryNumbers& numbers) { give(task, numbers, tested); });
    if (!cancel_) { give(task, last, {task.tests.begin(), task.tests.end()}); } // those that failed are done, too
}

void CardNumbers::give(const Task& task, const LaboratoryNumbers& numbers, const std::set<std::string>& tested)
{
    post([this, cloth = task.cloth, numbers, tested] {
        if (cloth != cloth_ || !card_) { return; } // another cloth by now
        Card more = *card_;
        more.numbers = numbers;
        card_ = std::make_shared<const Card>(std::move(more));
        tested_.insert(tested.begin(), tested.end());
        Q_EMIT changed();
    });
}

} // namespace hygroloom
