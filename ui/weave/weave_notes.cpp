// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/weave/weave_notes.h"

#include "core/design/jam.h"
#include "core/design/weave_analysis.h"
#include "ui/basics/appearance.h"
#include "ui/basics/issue_text.h"
#include "ui/basics/quantity.h"

#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>

#include <algorithm>

namespace hygroloom {

namespace {

constexpr double limit_percent = 100 * most_sett_share, full_scale_percent = 125;

QString threads(const std::vector<int>& numbers)
{
    constexpr std::size_t most_named = 6;
    QStringList names;
    for (std::size_t i = 0; i < std::min(numbers.size(), most_named); ++i) { names << QString::number(numbers[i] + 1); }
    return names.join(", ") + (numbers.size() > most_named ? QStringLiteral(", …") : QString());
}

/// A thread that never interlaces floats over the whole cloth.
QString longestText(int floats, bool unbound) { return unbound ? WeaveNotes::tr("endless") : QString::number(floats); }

} // namespace

LimitGauge::LimitGauge(QWidget* parent) : QWidget(parent) { setFixedHeight(8); }

void LimitGauge::setPercent(double percent)
{
    percent_ = percent;
    update();
}

void LimitGauge::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QColor trough = palette().color(QPalette::Text);
    trough.setAlphaF(0.14F);
    const QRectF bar = QRectF(rect()).adjusted(0, 1, 0, -1);
    painter.setPen(Qt::NoPen);
    painter.setBrush(trough);
    painter.drawRoundedRect(bar, 3, 3);
    const double limit = bar.width() * limit_percent / full_scale_percent;
    if (percent_ >= 0) {
        QRectF filled = bar;
        filled.setWidth(bar.width() * std::clamp(percent_ / full_scale_percent, 0.0, 1.0));
        painter.setBrush(percent_ > limit_percent ? severityColor(Severity::warning, palette()) : palette().color(QPalette::Highlight));
        painter.drawRoundedRect(filled, 3, 3);
    }
    painter.fillRect(QRectF(limit - 0.75, 0, 1.5, height()), palette().color(QPalette::Text));
}

WeaveNotes::WeaveNotes(Document& document, QWidget* parent)
    : QScrollArea(parent), document_(document), facts_(new QLabel), warnings_(new QLabel)
{
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setAccessibleName(tr("Notes about the weave"));
    auto* all = new QWidget;
    auto* layout = new QVBoxLayout(all);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(3);
    facts_->setAccessibleName(tr("About the weave"));
    warnings_->setAccessibleName(tr("Warnings about the weave"));
    for (QLabel* label : {facts_, warnings_}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
        label->setFocusPolicy(Qt::NoFocus);
    }
    facts_->setForegroundRole(QPalette::PlaceholderText);
    layout->addWidget(warnings_);
    layout->addWidget(facts_);
    sett_ = new QLabel;
    sett_->setForegroundRole(QPalette::PlaceholderText);
    gauge_ = new LimitGauge;
    gauge_->setAccessibleName(tr("Setts against their limit"));
    layout->addWidget(sett_);
    layout->addWidget(gauge_);
    layout->addStretch();
    setWidget(all);
    all->setAutoFillBackground(false);
    viewport()->setAutoFillBackground(false);
    fixHeight();
    connect(&document_, &Document::designChanged, this, &WeaveNotes::refresh);
    refresh();
}

/// Room for the facts, the gauge and two lines of warnings.
void WeaveNotes::fixHeight()
{
    constexpr int lines_of_text = 3 + 1 + 2, gaps = 18;
    setFixedHeight(lines_of_text * fontMetrics().lineSpacing() + gauge_->height() + gaps);
}

void WeaveNotes::changeEvent(QEvent* event)
{
    QScrollArea::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) { fixHeight(); }
}

void WeaveNotes::refresh()
{
    const Fabric* fabric = document_.fabric();
    if (!fabric) {
        facts_->setText(tr("Add a fabric to draw its weave."));
        warnings_->clear();
        shown_.reset();
        refreshGauge();
        return;
    }
    if (!shown_ || !shown_->same_matrix(fabric->weave)) {
        const Weave& weave = shown_.emplace(fabric->weave);
        const WeaveAnalysis found = analyse(weave);
        const double crossings = static_cast<double>(weave.ends()) * weave.picks();
        QString facts = tr("Longest floats: warp %1, weft %2. Warp shows on %3 % of the face.")
                            .arg(longestText(std::max(found.warp_face.longest, found.warp_back.longest), !found.unbound_ends.empty()),
                                 longestText(std::max(found.weft_face.longest, found.weft_back.longest), !found.unbound_picks.empty()))
                            .arg(shownNumber(100 * found.warp_up_share, 0));
        facts +=
            " " + tr("%1 % of the crossings interlace.")
                      .arg(shownNumber(100 * static_cast<double>(found.warp_interlacings + found.weft_interlacings) / (2 * crossings), 0));
        if (found.repeat_ends != weave.ends() || found.repeat_picks != weave.picks()) {
            facts += " " + tr("It repeats every %1 × %2.").arg(found.repeat_ends).arg(found.repeat_picks);
        }
        facts_->setText(facts);
        facts_->setToolTip("<p>" + tr("A float passes over or under several yarns of the other system. 100 % interlacing is plain weave.") +
                           "</p>");
        QStringList wrong;
        if (!found.unbound_ends.empty()) { wrong << tr("Ends that never interlace: %1.").arg(threads(found.unbound_ends)); }
        if (!found.unbound_picks.empty()) { wrong << tr("Picks that never interlace: %1.").arg(threads(found.unbound_picks)); }
        warnings_->setProperty("analysis", wrong);
    }
    QStringList sentences = warnings_->property("analysis").toStringList();
    const Place own = Place("fabrics") / static_cast<std::size_t>(document_.fabricIndex()) / "weave";
    for (const Issue& issue : document_.issues()) {
        if (issue.where.is_in(own)) { sentences << issueText(issue); }
    }
    warnings_->setText(sentences.join('\n'));
    warnings_->setVisible(!sentences.isEmpty());
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, severityColor(Severity::warning, palette()));
    warnings_->setPalette(colors);
    refreshGauge();
}

void WeaveNotes::refreshGauge()
{
    const Fabric* fabric = document_.fabric();
    const bool known = fabric && document_.fitted();
    sett_->setVisible(known);
    gauge_->setVisible(known);
    if (!known) { return; }
    const double percent = 100 * sett_share_of_limit(*fabric, document_.fitted()->yarns);
    sett_->setText(tr("Setts: %1 % of their limit").arg(shownNumber(percent, 0)));
    QString help =
        tr("Both setts together, for these yarns and this weave: at 100 % solid round yarns would jam. Looms stop at about %1 %.")
            .arg(shownNumber(limit_percent, 0));
    if (is_square(fabric->ends_per_cm, fabric->picks_per_cm)) {
        const JamGauge jam = jam_gauge(*fabric, document_.fitted()->yarns);
        help += " " + tr("Ashenhurst's limit for square cloth, of which a firm one has about 75 %, is %1 ends and %2 picks.")
                          .arg(valueText(jam.warp.ashenhurst_per_cm, "/cm"), valueText(jam.weft.ashenhurst_per_cm, "/cm"));
    }
    sett_->setToolTip("<p>" + help + "</p>");
    gauge_->setToolTip("<p>" + help + "</p>");
    gauge_->setAccessibleDescription(sett_->text());
    gauge_->setPercent(percent);
}

QString WeaveNotes::text() const { return QStringList{facts_->text(), sett_->text(), warnings_->text()}.join('\n'); }

} // namespace hygroloom
