// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/weave/weave_notes.h"

#include "core/design/jam.h"
#include "core/design/weave_analysis.h"
#include "ui/basics/appearance.h"
#include "ui/basics/quantity.h"

#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>

#include <algorithm>

namespace hygroloom {

namespace {

constexpr double full_scale_percent = 125;

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
    const double limit = bar.width() * 100 / full_scale_percent;
    if (percent_ >= 0) {
        QRectF filled = bar;
        filled.setWidth(bar.width() * std::clamp(percent_ / full_scale_percent, 0.0, 1.0));
        painter.setBrush(percent_ > 100 ? severityColor(Severity::warning, palette()) : palette().color(QPalette::Highlight));
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
    for (int system = 0; system < 2; ++system) {
        setts_[system] = new QLabel;
        setts_[system]->setForegroundRole(QPalette::PlaceholderText);
        gauges_[system] = new LimitGauge;
        gauges_[system]->setAccessibleName(system == 0 ? tr("Warp sett against its limit") : tr("Weft sett against its limit"));
        layout->addWidget(setts_[system]);
        layout->addWidget(gauges_[system]);
    }
    layout->addStretch();
    setWidget(all);
    all->setAutoFillBackground(false);
    viewport()->setAutoFillBackground(false);
    fixHeight();
    connect(&document_, &Document::designChanged, this, &WeaveNotes::refresh);
    refresh();
}

/// Room for the facts, the gauges and two lines of warnings.
void WeaveNotes::fixHeight()
{
    constexpr int lines_of_text = 3 + 2 + 2, gaps = 24;
    setFixedHeight(lines_of_text * fontMetrics().lineSpacing() + gauges_[0]->height() + gauges_[1]->height() + gaps);
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
        refreshGauges();
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
    const std::string own = "fabrics[" + std::to_string(document_.fabricIndex()) + "].weave";
    for (const Issue& issue : document_.issues()) {
        if (issue.where.starts_with(own)) { sentences << QString::fromStdString(issue.text); }
    }
    warnings_->setText(sentences.join('\n'));
    warnings_->setVisible(!sentences.isEmpty());
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, severityColor(Severity::warning, palette()));
    warnings_->setPalette(colors);
    refreshGauges();
}

void WeaveNotes::refreshGauges()
{
    const Fabric* fabric = document_.fabric();
    std::optional<JamGauge> jam;
    if (fabric && document_.fitted()) { jam = jam_gauge(*fabric, document_.fitted()->yarns); }
    for (int system = 0; system < 2; ++system) {
        setts_[system]->setVisible(jam.has_value());
        gauges_[system]->setVisible(jam.has_value());
        if (!jam) { continue; }
        const JamOfSystem& one = system == 0 ? jam->warp : jam->weft;
        const QString share = shownNumber(one.ashenhurst_percent, 0);
        setts_[system]->setText(system == 0 ? tr("Warp sett: %1 % of its limit").arg(share)
                                            : tr("Weft sett: %1 % of its limit").arg(share));
        const QString help =
            tr("Ashenhurst's limit is %1 per cm: yarns side by side, with room to change sides. A firm cloth has about 75 % of it. "
               "Peirce's limit is %2 per cm (%3 %): circular arcs that touch.")
                .arg(shownNumber(one.ashenhurst_per_cm, 1), shownNumber(one.peirce_per_cm, 1), shownNumber(one.peirce_percent, 0));
        setts_[system]->setToolTip("<p>" + help + "</p>");
        gauges_[system]->setToolTip("<p>" + help + "</p>");
        gauges_[system]->setAccessibleDescription(setts_[system]->text());
        gauges_[system]->setPercent(one.ashenhurst_percent);
    }
}

QString WeaveNotes::text() const { return QStringList{facts_->text(), setts_[0]->text(), setts_[1]->text(), warnings_->text()}.join('\n'); }

} // namespace hygroloom
