// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/compare/compare_maps.h"

#include "core/base/error.h"
#include "core/base/round_up.h"
#include "core/base/text.h"
#include "ui/basics/quantity.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hygroloom {

namespace {

constexpr int legend_width = 92;
constexpr int time_steps = 200;

/// How many of its replicates keep maps or curves; those of other versions keep none.
std::size_t tracesOf(const Candidate& candidate)
{
    const auto kept = [](const std::optional<ReplicateRun>& run) { return run && run->trace; };
    return static_cast<std::size_t>(std::count_if(candidate.replicates.begin(), candidate.replicates.end(), kept));
}

} // namespace

CompareMaps::CompareMaps(QWidget* parent)
    : QWidget(parent), side_by_side_(new QWidget), row_(new QHBoxLayout(side_by_side_)), legend_(new QWidget), empty_(new QLabel),
      shown_(new QComboBox), face_(new QComboBox), time_(new QSlider(Qt::Horizontal)), shown_time_(new QLabel), value_(new QLabel),
      problem_(new QLabel), grey_(new QLabel)
{
    row_->setContentsMargins(0, 4, 0, 0);
    row_->setSpacing(0);
    legend_->setFixedWidth(legend_width);
    row_->addWidget(legend_);
    shown_->addItems({tr("Maps"), tr("Difference to baseline")});
    shown_->setAccessibleName(tr("What the maps show"));
    grey_->setWordWrap(true);
    grey_->setTextFormat(Qt::PlainText);
    grey_->setContentsMargins(8, 0, 8, 0);
    grey_->setForegroundRole(QPalette::PlaceholderText);
    grey_->setVisible(false);
    face_->addItems({tr("Top face"), tr("Bottom face")});
    face_->setAccessibleName(tr("Face of the fabrics"));
    time_->setRange(0, time_steps);
    time_->setValue(time_steps);
    time_->setAccessibleName(tr("Time of all maps"));
    value_->setAccessibleName(tr("Value under the pointer"));
    value_->setContentsMargins(8, 0, 8, 0);
    empty_->setWordWrap(true);
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setForegroundRole(QPalette::PlaceholderText);
    problem_->setWordWrap(true);
    problem_->setTextFormat(Qt::PlainText);
    problem_->setContentsMargins(8, 0, 8, 0);
    problem_->setVisible(false);
    auto* foot = new QHBoxLayout;
    foot->setContentsMargins(8, 0, 8, 4);
    foot->addWidget(shown_);
    foot->addWidget(face_);
    foot->addWidget(time_, 1);
    foot->addWidget(shown_time_);
    shown_time_->setMinimumWidth(shown_time_->fontMetrics().horizontalAdvance("0000.00 s")); // the slider keeps its length
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(side_by_side_, 1);
    layout->addWidget(empty_, 1);
    layout->addWidget(problem_);
    layout->addWidget(grey_);
    layout->addWidget(value_);
    layout->addLayout(foot);
    for (QComboBox* box : {face_, shown_}) {
        connect(box, &QComboBox::currentIndexChanged, this, [this] {
            largest_difference_ = 0;
            readMaps();
        });
    }
    shareRanges(own_ranges_);
    connect(time_, &QSlider::valueChanged, this, [this] {
        readMaps();
        Q_EMIT timeChanged(static_cast<double>(time_->value()) / time_steps);
    });
}

void CompareMaps::shareRanges(ColorRanges& ranges)
{
    ranges_->disconnect(this);
    ranges_ = &ranges;
    connect(ranges_, &ColorRanges::changed, this, &CompareMaps::showRange);
    connect(ranges_, &ColorRanges::fitWanted, this, [this] {
        if (isVisible()) { readMaps(); }
    });
}

double CompareMaps::duration() const { return runs_.empty() ? 0 : durationOf(runs_.front()); }

double CompareMaps::shownTime() const { return duration() * time_->value() / time_steps; }

void CompareMaps::setTime(double share) { time_->setValue(static_cast<int>(std::lround(share * time_steps))); }

void CompareMaps::setWaterColors(WaterColors colors)
{
    colors_ = colors;
    showRange();
}

MapSide CompareMaps::side() const { return face_->currentIndex() == 0 ? MapSide::top : MapSide::bottom; }

bool CompareMaps::differs() const { return shown_->currentIndex() == static_cast<int>(Shown::differences); }

void CompareMaps::show(Shown shown) { shown_->setCurrentIndex(static_cast<int>(shown)); }

void CompareMaps::setRuns(const std::vector<KeptRun>& runs, const QStringList& titles, const QString& hint,
                          const std::optional<KeptRun>& baseline, const QString& baseline_title, const Comparison& comparison)
{
    side_by_side_->setVisible(!runs.empty());
    empty_->setVisible(runs.empty());
    empty_->setText(hint);
    for (QComboBox* box : {shown_, face_}) { box->setEnabled(!runs.empty()); }
    baseline_ = baseline;
    baseline_title_ = baseline_title;
    time_->setEnabled(!runs.empty());
    runs_ = runs;
    titles_ = titles;
    const auto named = [&comparison](const std::string& name) {
        const auto& all = comparison.candidates;
        const auto found = std::find_if(all.begin(), all.end(), [&name](const Candidate& each) { return each.fabric == name; });
        return found == all.end() ? Candidate() : *found;
    };
    std::vector<Candidate> candidates;
    for (const QString& title : titles) { candidates.push_back(named(title.toStdString())); }
    candidates.push_back(named(baseline_title.toStdString()));
    std::swap(candidates_, candidates);
    const QStringList identities = identitiesOf(runs);
    if (identities == identities_) {
        candidates_ = candidates; // with the maps that were read
        return;
    }
    identities_ = identities;
    qDeleteAll(maps_);
    maps_.clear();
    largest_difference_ = 0;
    value_->clear();
    for (const QString& title : titles) {
        auto* map = new WaterMap(title);
        map->setAccessibleName(tr("Water on %1").arg(title));
        connect(map, &WaterMap::pointed, value_, &QLabel::setText);
        row_->insertWidget(static_cast<int>(maps_.size()), map, 1);
        maps_.push_back(map);
    }
    for (WaterMap* map : maps_) { map->setRow(maps_); }
    readMaps();
}

void CompareMaps::readMaps()
{
    shown_time_->setText(runs_.empty() ? QString() : momentText(shownTime(), duration()));
    if (runs_.empty()) {
        ++requests_;
        reader_.drop();
        showProblem({});
        grey_->setVisible(false);
        update();
        return;
    }
    MapsRequest wanted{runs_, candidates_, side(), static_cast<double>(time_->value()) / time_steps, differs() && baseline_};
    wanted.candidates.resize(runs_.size());
    if (wanted.differences) {
        wanted.runs.push_back(*baseline_);
        wanted.candidates.push_back(candidates_.back());
    }
    reader_.run([this, wanted, request = ++requests_](const NewestJob::Turn& turn) {
        MapsRead read;
        QString problem;
        try {
            read = hygroloom::readMaps(wanted, [&turn] { return turn.outdated(); });
        } catch (const std::exception& error) {
            problem = QString::fromStdString(error.what());
        }
        turn.deliver([this, read = std::move(read), request, problem, differences = wanted.differences] {
            if (request != requests_) { return; }
            showProblem(problem);
            if (!problem.isEmpty()) { return; }
            std::copy_n(read.candidates.begin(), runs_.size(), candidates_.begin());
            if (differences) { candidates_.back() = read.candidates.back(); }
            shown_time_->setText(momentText(read.share * duration(), duration()));
            if (differences) {
                showDifferences(read);
            } else {
                showMaps(read);
            }
        });
    });
}

void CompareMaps::showMaps(const MapsRead& read)
{
    bool any = false;
    double most = 0;
    for (std::size_t i = 0; i < maps_.size(); ++i) {
        const FaceMap& map = read.maps[i];
        most = std::max(most, map.cells.maximum());
        maps_[i]->setMap(map.cells, map.stain, map.size);
        maps_[i]->setReplicates(read.ranges[i]);
        maps_[i]->setVisible(true);
        any = any || read.ranges[i];
    }
    grey_->setText(tr("Each cloth as given. Under the pointer also the range of its replicates, of larger cells."));
    grey_->setVisible(any);
    any_water_ = most > 0;
    ranges_->widenWater(most);
    showRange();
    Q_EMIT mapsChanged();
}

/// The baseline's own is nothing to look at.
void CompareMaps::showDifferences(const MapsRead& read)
{
    QStringList problems;
    MapError error;
    int pairs = 0, drawn = 0;
    QStringList unpaired, unknown;
    const FaceMap& baseline = read.maps.back();
    for (std::size_t i = 0; i < maps_.size(); ++i) {
        const bool own = runs_[i].path == baseline_->path;
        maps_[i]->setVisible(!own);
        if (own) { continue; }
        const FaceMap& map = read.maps[i];
        if (const QString why = whyNoDifference(map.cells, baseline.cells); !why.isEmpty()) {
            maps_[i]->clear();
            problems << tr("There is no difference map of %1: %2.").arg(titles_[static_cast<qsizetype>(i)], why);
            continue;
        }
        const MapError each = errorOfMaps(*runs_[i].run, *baseline_->run, side());
        const auto& paired = read.pairs[i];
        const MapDifference difference =
            paired ? MapDifference{paired->cells, paired->real} : differenceOf(map.cells, baseline.cells, each);
        if (paired) { pairs = pairs == 0 ? paired->pairs : std::min(pairs, paired->pairs); }
        if (!paired) { unpaired << titles_[static_cast<qsizetype>(i)]; }
        largest_difference_ = std::max(largest_difference_, largestOf(difference));
        maps_[i]->setDifference(difference, map.size);
        ++drawn;
        for (const auto& [run, name] :
             {std::pair(&runs_[i], titles_[static_cast<qsizetype>(i)]), std::pair(&*baseline_, baseline_title_)}) {
            if (!errorOfMaps(*run->run, *run->run, side()).share && !unknown.contains(name)) { unknown << name; }
        }
        if (error.of.isEmpty() || each.share.value_or(0) > error.share.value_or(0)) { error = each; }
    }
    if (runs_.size() == 1 && runs_.front().path == baseline_->path) { problems << tr("Tick a second fabric to see how it differs."); }
    if (pairs > 0 && !unpaired.isEmpty()) {
        problems
            << tr("One run each of %1 and the baseline, of whose replicates fewer than two pairs keep maps: grey is the numerical error "
                  "alone.")
                   .arg(unpaired.join(", "));
    }
    showProblem({});
    problem_->setText(problems.join(' '));
    problem_->setVisible(!problems.isEmpty());
    grey_->setText(drawn > 0 ? greyText(error, pairs, read.share, unknown) : QString()); // else the problems say why there is nothing
    grey_->setVisible(drawn > 0);
    showRange();
    Q_EMIT mapsChanged();
}

/// pairs: fewest of the maps; 0: the replicates do not count. unknown: whose numerical error is not known.
QString CompareMaps::greyText(const MapError& error, int pairs, double share, const QStringList& unknown) const
{
    const QString to = tr("Water less that of %1.").arg(baseline_title_);
    const QString percent = error.share ? shownNumber(100 * *error.share, decimals_for(100 * *error.share, 2)) : QString();
    if (pairs > 0) {
        const QString numerical = error.share ? tr("a numerical error of %1 %").arg(percent) : tr("no numerical error, which is not known");
        return tr("%1 Mean of at least %2 pairs of replicates after %3, the nearest time of which they keep maps. Grey: the interval of "
                  "the "
                  "mean difference, with %4, holds 0.")
            .arg(to)
            .arg(pairs)
            .arg(momentText(share * duration(), duration()), numerical);
    }
    if (!error.share) {
        return unknown.isEmpty()
                   ? tr("%1 The numerical error of these runs is not known: grey cells are exactly equal.").arg(to)
                   : tr("%1 The numerical error of %2 is not known: grey cells are exactly equal.").arg(to, unknown.join(", "));
    }
    const QString known =
        tr("%1 Grey: the difference is at most %2 % of the wetter one, the numerical error of %3.").arg(to, percent, error.of);
    return unknown.isEmpty() ? known : tr("%1 That of %2 is not known: grey cells are exactly equal there.").arg(known, unknown.join(", "));
}

/// Title, path, date and replicates of each.
QStringList CompareMaps::identitiesOf(const std::vector<KeptRun>& runs) const
{
    QStringList identities;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        identities << QString("%1\n%2\n%3\n%4")
                          .arg(titles_[static_cast<qsizetype>(i)], runs[i].path, QString::fromStdString(runs[i].run->date))
                          .arg(tracesOf(candidates_[i]));
    }
    if (baseline_) {
        identities
            << QString("%1\n%2\n%3").arg(baseline_->path, QString::fromStdString(baseline_->run->date)).arg(tracesOf(candidates_.back()));
    }
    return identities;
}

/// In the view rather than a dialog, as each step of the slider may repeat it.
void CompareMaps::showProblem(const QString& sentence)
{
    problem_->setText(sentence);
    problem_->setVisible(!sentence.isEmpty());
    if (sentence.isEmpty()) { return; }
    for (WaterMap* map : maps_) { map->clear(); }
}

void CompareMaps::showRange()
{
    const double end = differs() && baseline_ ? rounded_up(largest_difference_) : ranges_->mostWater();
    for (WaterMap* map : maps_) { map->setRange(end, colors_); }
    update();
}

void CompareMaps::paintEvent(QPaintEvent*)
{
    const bool differences = differs() && baseline_;
    if (maps_.empty() || !(differences ? largest_difference_ > 0 : any_water_)) { return; }
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(palette().color(QPalette::WindowText));
    const QRectF room(legend_->mapTo(this, QPoint(0, 0)), legend_->size());
    const QRectF area = room.adjusted(4, 0, -4, -std::max(0.0, room.height() - 240));
    if (differences) {
        drawDifferenceLegend(painter, area, tr("Difference"), 1000 * rounded_up(largest_difference_), tr("g/m²"));
    } else {
        drawLegend(painter, area, legendTitle(tr("Water"), *ranges_, ShownQuantity::water), 1000 * ranges_->mostWater(), tr("g/m²"),
                   colors_);
    }
}

} // namespace hygroloom
