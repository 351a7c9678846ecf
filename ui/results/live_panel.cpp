// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/live_panel.h"

#include "core/analysis/outcomes.h"
#include "core/base/text.h"
#include "ui/basics/elided_label.h"
#include "ui/basics/preferences.h"
#include "ui/basics/quantity.h"
#include "ui/document/document.h"
#include "ui/results/plan_dialog.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QDir>
#include <QFile>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QSettings>

#include <algorithm>
#include <utility>

namespace hygroloom {

namespace {

constexpr int own_legend_width = 92;
constexpr int leading_numbers = 3;
constexpr int short_pause_ms = 400, pause_ms = 1000; // without an edit, after which the whole and a finer answer are begun
constexpr double longest_unasked = 20;               // s, that the whole may take
constexpr const char* refine_setting = "live/refine";

QString secondsText(double seconds) { return LivePanel::tr("%1 s").arg(shownNumber(seconds, decimals_for(seconds, 3))); }

/// "after 1 s of 600 s", and on how much of the sample.
QString extentText(const Answer& answer)
{
    const Experiment& computed = answer.run->design.experiments[0];
    const QString after = answer.ofAllTime()
                              ? LivePanel::tr("after %1").arg(secondsText(computed.duration_s))
                              : LivePanel::tr("after %1 of %2").arg(secondsText(computed.duration_s), secondsText(answer.asked.duration_s));
    if (answer.ofAllCloth()) { return after; }
    const auto side = [](double mm) { return valueText(mm, "mm"); };
    return is_strip(computed.type)
               ? LivePanel::tr("%1, on the lower %2 of the strip").arg(after, side(computed.sample_mm[1]))
               : LivePanel::tr("%1, on the middle %2 × %3").arg(after, side(computed.sample_mm[0]), side(computed.sample_mm[1]));
}

} // namespace

bool runsOnBattery(const QString& folder)
{
    for (const QString& supply : QDir(folder).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        QFile status(folder + "/" + supply + "/status"), scope(folder + "/" + supply + "/scope");
        const bool of_a_device = scope.open(QIODevice::ReadOnly) && scope.readAll().trimmed() == "Device"; // a mouse's, not the machine's
        if (!of_a_device && status.open(QIODevice::ReadOnly) && status.readAll().trimmed() == "Discharging") { return true; }
    }
    return false;
}

LivePanel::LivePanel(Document& document, QWidget* parent)
    : QWidget(parent), document_(document), map_(new WaterMap(tr("Top"))), legend_(new QWidget), status_(new QLabel),
      refine_(new QCheckBox(tr("Refine when I pause"))), numbers_(new QGridLayout)
{
    build();
    shareRanges(own_ranges_);
    pause_.setSingleShot(true);
    connect(&document_, &Document::designChanged, this, &LivePanel::ask);
    connect(&live_, &LiveAnswer::answered, this, &LivePanel::take);
    connect(&live_, &LiveAnswer::refused, this, &LivePanel::refuse);
    connect(&pause_, &QTimer::timeout, this, &LivePanel::askFiner);
    connect(&PreferenceNews::instance(), &PreferenceNews::changed, this, [this, length = preferences().length]() mutable {
        if (std::exchange(length, preferences().length) != length) { ask(); } // numbers come with their units
    });
    connect(refine_, &QCheckBox::toggled, this, [this](bool on) {
        QSettings().setValue(refine_setting, on);
        if (on) {
            askFiner();
        } else {
            ask();
        }
    });
}

void LivePanel::build()
{
    legend_->setFixedWidth(own_legend_width);
    status_->setWordWrap(true);
    status_->setAccessibleName(tr("What the map shows"));
    refine_->setChecked(QSettings().value(refine_setting, false).toBool());
    refine_->setToolTip("<p>" + tr("After a second without an edit the whole experiment runs at draft, then at standard.") + "</p>");
    numbers_->setContentsMargins(8, 0, 8, 0);
    numbers_->setVerticalSpacing(2);
    numbers_->setColumnStretch(0, 1);
    for (int row = 0; row < leading_numbers; ++row) {
        auto* name = new ElidedLabel;
        name->setElideMode(Qt::ElideRight);
        auto* value = new QLabel;
        value->setAlignment(Qt::AlignRight);
        numbers_->addWidget(name, row, 0);
        numbers_->addWidget(value, row, 1);
    }
    auto* picture = new QHBoxLayout;
    picture->setSpacing(0);
    picture->addWidget(map_, 1);
    picture->addWidget(legend_);
    auto* foot = new QVBoxLayout;
    foot->setContentsMargins(8, 0, 8, 4);
    foot->addWidget(status_);
    foot->addWidget(refine_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 4, 0, 0);
    layout->setSpacing(4);
    layout->addLayout(picture, 1);
    layout->addLayout(numbers_);
    layout->addLayout(foot);
}

QString LivePanel::status() const { return status_->text(); }

void LivePanel::say(const QString& sentence)
{
    status_->setText(sentence);
    keepStatusWhole();
}

/// A dock asks for no height that depends on the width: without room of its own the sentence would lose its last line.
void LivePanel::keepStatusWhole()
{
    const int room = width() - 16;                                                           // within the margins
    if (room > 0) { status_->setMinimumHeight(std::max(0, status_->heightForWidth(room))); } // less than 0 while there is no text
}

void LivePanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    keepStatusWhole();
}

void LivePanel::setWaterColors(WaterColors colors)
{
    colors_ = colors;
    showRange();
}

void LivePanel::shareRanges(ColorRanges& ranges)
{
    ranges_->disconnect(this);
    ranges_ = &ranges;
    connect(ranges_, &ColorRanges::changed, this, &LivePanel::showRange);
    connect(ranges_, &ColorRanges::fitWanted, this, [this] {
        if (isVisible() && shown_) { ranges_->widenWater(shown_->most); }
    });
}

void LivePanel::showRange()
{
    map_->setRange(ranges_->mostWater(), colors_);
    update();
}

void LivePanel::setOutdated(bool outdated)
{
    map_->setOutdated(outdated);
    for (int row = 0; row < leading_numbers; ++row) {
        for (int column = 0; column < 2; ++column) { numbers_->itemAtPosition(row, column)->widget()->setEnabled(!outdated); }
    }
}

void LivePanel::ask()
{
    pause_.stop();
    live_.stop();
    shown_.reset();
    if (!isVisible()) { return; }
    const Experiment* experiment = document_.experiment();
    if (!document_.fabric() || !experiment) {
        refuse(document_.fabric() ? tr("Add an experiment to see its water here.") : tr("Add a fabric to see its water here."));
    } else if (document_.fabricHasError()) {
        refuse(tr("The fabric has an error. Mend it to see its water here."));
    } else if (runsOnBattery()) {
        refuse(tr("Off while this machine runs on its battery."));
    } else {
        const bool any = map_->map().columns > 0;
        setOutdated(any);
        say(any ? tr("Computing. Hatched: the cloth before.") : tr("The answer follows."));
        live_.ask(document_.design(), document_.fabricIndex(), document_.experimentIndex());
    }
}

void LivePanel::askFiner()
{
    const bool live = shown_ && shown_->run->plan.fidelity == Fidelity::live;
    const bool draft = shown_ && shown_->run->plan.fidelity == Fidelity::draft;
    if (!isVisible() || live_.working() || !(live || draft)) { return; }
    const bool cut = live && !shown_->whole;
    if (cut && shown_->wall_of_all > longest_unasked) { return; } // the whole of what is so slow is for Simulate
    if (!cut && !refine_->isChecked()) { return; }
    const Fidelity next = cut ? Fidelity::live : live ? Fidelity::draft : Fidelity::standard;
    live_.ask(document_.design(), document_.fabricIndex(), document_.experimentIndex(), next, true);
    say(status_->text() + " " +
        (cut    ? tr("The whole follows.")
         : live ? tr("Draft is being computed.")
                : tr("Standard is being computed.")));
}

void LivePanel::take(const std::shared_ptr<const Answer>& answer)
{
    shown_ = answer;
    setOutdated(false);
    scaled_ = answer->most > 0; // of dry cloth there is no scale
    ranges_->widenWater(answer->most);
    showRange();
    map_->setMap(answer->top.cells, answer->top.stain, answer->top.size);
    showNumbers(answer->numbers);
    const QString name = QString::fromStdString(answer->run->experiment);
    const std::vector<OutcomeInfo> all = reported_by(answer->run->design.experiments[0].type);
    const bool indices = std::any_of(all.begin(), all.end(), [](const OutcomeInfo& info) { return info.of_whole_test; });
    say(tr("%1: %2, %3; %4.")
            .arg(fidelityName(answer->run->plan.fidelity), name, extentText(*answer),
                 answer->whole ? expectedError(answer->run->plan) : tr("20 frames, numerical error not known")));
    if (indices && !answer->whole) { say(status_->text() + " " + tr("Indices and grades need the whole test.")); }
    if (!answer->whole) {
        pause_.start(short_pause_ms); // numbers of the whole can be told apart from those after another edit
    } else if (refine_->isChecked() && answer->run->plan.fidelity != Fidelity::standard) {
        pause_.start(pause_ms);
    }
    update();
    Q_EMIT changed();
}

void LivePanel::showNumbers(const std::vector<Result>& numbers)
{
    for (int row = 0; row < leading_numbers; ++row) {
        const auto at = static_cast<std::size_t>(row);
        const bool is = at < numbers.size();
        const QString value = !is ? QString()
                              : numbers[at].bottom.isEmpty() || numbers[at].bottom == numbers[at].value
                                  ? numbers[at].value
                                  : tr("%1 / %2").arg(numbers[at].value, numbers[at].bottom);
        static_cast<ElidedLabel*>(numbers_->itemAtPosition(row, 0)->widget())->setFullText(is ? numbers[at].name : QString());
        static_cast<QLabel*>(numbers_->itemAtPosition(row, 1)->widget())->setText(value);
    }
    layout()->activate(); // with room for the values at once: names give way
}

/// Nothing is shown of a cloth that is not computed.
void LivePanel::refuse(const QString& sentence)
{
    pause_.stop();
    shown_.reset();
    map_->clear();
    setOutdated(false);
    showNumbers({});
    scaled_ = false;
    update();
    say(sentence);
    Q_EMIT changed();
}

void LivePanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    ask();
}

void LivePanel::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    pause_.stop();
    live_.stop();
}

void LivePanel::paintEvent(QPaintEvent*)
{
    if (!scaled_) { return; }
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    drawLegend(painter, QRectF(legend_->geometry()).adjusted(4, 0, -4, -4), legendTitle(tr("Water"), *ranges_, ShownQuantity::water),
               1000 * range(), tr("g/m²"), colors_);
}

} // namespace hygroloom
