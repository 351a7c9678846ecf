// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the view has to do with the project: a recording that is none of it, and zones that are drawn on its garment.
#include "core/base/units.h"
#include "ui/garment/flat_view.h"
#include "ui/garment/garment_edits.h"
#include "ui/garment/garment_view.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include <cmath>

namespace hygroloom {

/// Over a recording that is none of the project's: the forms beside it are of the project.
QWidget* GarmentView::makeNotice()
{
    notice_ = new QWidget;
    notice_text_ = new QLabel;
    notice_text_->setWordWrap(true);
    notice_text_->setTextFormat(Qt::PlainText);
    notice_text_->setAccessibleName(tr("About the recording"));
    auto* open = new QPushButton(tr("Open Its Design"));
    open->setToolTip(tr("Edit the design from which this run was made, in place of the project."));
    connect(open, &QPushButton::clicked, this, &GarmentView::designRequested);
    auto* layout = new QHBoxLayout(notice_);
    layout->setContentsMargins(8, 2, 6, 2);
    layout->addWidget(notice_text_, 1);
    layout->addWidget(open);
    notice_->hide();
    return notice_;
}

QWidget* GarmentView::makeOffer()
{
    offer_ = new QLabel;
    offer_->setWordWrap(true);
    offer_->setTextFormat(Qt::RichText);
    offer_->setTextInteractionFlags(Qt::TextBrowserInteraction);
    offer_->setContentsMargins(8, 2, 6, 2);
    offer_->setAccessibleName(tr("Run that is kept"));
    connect(offer_, &QLabel::linkActivated, this, &GarmentView::offerTaken);
    offer_->hide();
    return offer_;
}

void GarmentView::setOffer(const QString& sentence, const QString& link)
{
    offer_->setText(sentence.isEmpty() ? QString() : sentence.toHtmlEscaped() + " <a href='run'>" + link.toHtmlEscaped() + "</a>");
    offer_->setVisible(!sentence.isEmpty());
}

bool GarmentView::isForeign() const
{
    if (!showsRun()) { return false; }
    const Design& now = *choice_.document().design();
    const WearLayout& layout = playback_.run()->layout();
    return !find_garment(now, layout.garment) || !find_wear(now, layout.experiment);
}

QString GarmentView::noticeText() const
{
    if (!isForeign()) { return {}; }
    const WearLayout& layout = playback_.run()->layout();
    return tr("A recording of “%1” in “%2”, which this project does not hold. It cannot be edited; the forms edit the project.")
        .arg(QString::fromStdString(layout.garment), QString::fromStdString(layout.experiment));
}

/// Fabrics can be dropped on what the project holds alone.
void GarmentView::refreshNotice()
{
    const QString text = noticeText();
    notice_text_->setText(text);
    notice_->setVisible(!text.isEmpty());
    const bool own = choice_.garment() && (!showsRun() || playback_.run()->layout().garment == choice_.garment()->name);
    for (GarmentPane* pane : panes()) { pane->setEditable(own); }
}

/// Of the run those with which it was computed.
void GarmentView::refreshZones()
{
    std::vector<ZoneOnPanel> zones;
    if (showsRun()) {
        newest_->flat().setOutlining(false); // a run has begun
        const WornRun& run = *playback_.run();
        const Garment* worn = find_garment(run.record->design, run.layout().garment);
        if (worn && run.drawing) { zones = zonesOn(*worn, *run.drawing); }
    } else if (choice_.garment() && choice_.drawing()) {
        zones = zonesOn(*choice_.garment(), *choice_.drawing());
    }
    newest_->flat().setZones(std::move(zones));
}

/// On the chosen garment in its fabrics: a run does not change.
void GarmentView::setOutlining(bool outlining)
{
    if (outlining && choice_.drawing()) {
        if (showsRun()) { setColors(Colors::fabrics); }
        if (!newest_->flat().isVisible()) {
            sides_box_->setCurrentIndex(0);
            for (GarmentPane* pane : panes()) { pane->setSides(GarmentPane::Sides::both); }
        }
    }
    newest_->flat().setOutlining(outlining && choice_.drawing());
}

void GarmentView::addZone(int panel, const std::vector<FlatPlace>& outline)
{
    if (!choice_.garment() || !choice_.drawing() || showsRun()) { return; }
    constexpr double fine = 1e-3; // mm; files need no more
    std::vector<std::array<double, 2>> places;
    places.reserve(outline.size());
    for (const FlatPlace& place : outline) {
        places.push_back({std::round(mm_from_metre(place[0]) / fine) * fine, std::round(mm_from_metre(place[1]) / fine) * fine});
    }
    addOwnZone(choice_.document(), choice_.garmentIndex(), choice_.drawing()->panels[static_cast<std::size_t>(panel)].name, places);
}

} // namespace hygroloom
