// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/panels/issues_panel.h"

#include "ui/basics/appearance.h"
#include "ui/basics/issue_text.h"
#include "ui/basics/preferences.h"
#include "ui/weave/cloth_picture.h"

#include <QLabel>
#include <QListWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace hygroloom {

namespace {

/// The part of a fabric or an experiment that a place is in, where it is a thing one would name.
QString partInWords(const Place& place)
{
    const std::string part = place.key(2);
    const int number = static_cast<int>(place.number(2).value_or(0));
    if (part == "warp") { return IssuesPanel::tr("warp"); }
    if (part == "weft") { return IssuesPanel::tr("weft"); }
    if (!place.number(2)) { return {}; }
    if (part == "extra_yarns") { return IssuesPanel::tr("yarn %1 (extra yarn %2)").arg(yarnLetter(number + 1)).arg(number + 1); }
    if (part == "droplets") { return IssuesPanel::tr("droplet %1").arg(number + 1); }
    if (part == "climate") { return number == 0 ? IssuesPanel::tr("initial climate") : IssuesPanel::tr("climate, row %1").arg(number); }
    return {};
}

template <typename Item> QString nameIn(const std::vector<Item>& items, std::size_t index)
{
    return index < items.size() ? QString::fromStdString(items[index].name) : QString();
}

bool repeatsTheWarp(const Document& document, const Issue& issue)
{
    if (issue.where.key(0) != "fabrics" || issue.where.key(2) != "weft") { return false; }
    const Place warp = issue.where.with(2, std::string("warp"));
    const std::size_t fabric = *issue.where.number(0);
    const auto& fabrics = document.design()->fabrics;
    return fabric < fabrics.size() && fabrics[fabric].warp == fabrics[fabric].weft &&
           std::any_of(document.issues().begin(), document.issues().end(),
                       [&](const Issue& other) { return other.where == warp && other.message == issue.message; });
}

} // namespace

std::vector<const Issue*> shownIssues(const Document& document)
{
    std::vector<const Issue*> shown;
    for (const Issue& issue : document.issues()) {
        if (!repeatsTheWarp(document, issue)) { shown.push_back(&issue); }
    }
    std::stable_sort(shown.begin(), shown.end(), [](const Issue* a, const Issue* b) { return a->severity > b->severity; });
    return shown;
}

QString issueInWords(const Design& design, const Issue& issue)
{
    const QString text = issueText(issue), part = partInWords(issue.where);
    const std::string list = issue.where.key(0);
    const std::size_t index = issue.where.number(0).value_or(0);
    QString name, number;
    if (list == "fabrics") {
        name = nameIn(design.fabrics, index);
        number = IssuesPanel::tr("Fabric %1");
    } else if (list == "experiments") {
        name = nameIn(design.experiments, index);
        number = IssuesPanel::tr("Experiment %1");
    } else if (list == "liquids") {
        name = nameIn(design.liquids, index);
        number = IssuesPanel::tr("Liquid %1");
    } else if (list == "materials") {
        name = nameIn(design.materials, index);
        number = IssuesPanel::tr("Material %1");
    } else {
        return text;
    }
    if (name.isEmpty()) { name = number.arg(index + 1); }
    return part.isEmpty() ? IssuesPanel::tr("%1: %2").arg(name, text) : IssuesPanel::tr("%1, %2: %3").arg(name, part, text);
}

IssuesPanel::IssuesPanel(Document& document, QWidget* parent)
    : QWidget(parent), document_(document), list_(new QListWidget), empty_(new QLabel(tr("No issues.")))
{
    list_->setAccessibleName(tr("Issues of the project"));
    list_->setWordWrap(true);
    list_->setFrameShape(QFrame::NoFrame);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setForegroundRole(QPalette::PlaceholderText);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(list_);
    layout->addWidget(empty_);
    const auto lead = [this](QListWidgetItem* item) {
        Q_EMIT issueActivated(shownIssues(document_)[static_cast<std::size_t>(list_->row(item))]->where);
    };
    connect(list_, &QListWidget::itemActivated, this, lead);
    connect(list_, &QListWidget::itemClicked, this, lead);
    connect(&document_, &Document::designChanged, this, &IssuesPanel::refresh);
    connect(&PreferenceNews::instance(), &PreferenceNews::changed, this, &IssuesPanel::refresh);
    refresh();
}

void IssuesPanel::refresh()
{
    // In their places: the chosen one stays chosen while it is mended, and a click may lead here.
    const std::vector<const Issue*> shown = shownIssues(document_);
    while (list_->count() > static_cast<int>(shown.size())) { delete list_->takeItem(list_->count() - 1); }
    for (std::size_t row = 0; row < shown.size(); ++row) {
        const Issue* issue = shown[row];
        QListWidgetItem* item = list_->item(static_cast<int>(row));
        item = item ? item : new QListWidgetItem(list_);
        item->setIcon(severityIcon(issue->severity));
        item->setText(issueInWords(*document_.design(), *issue));
        item->setToolTip(tr("%1 at %2").arg(severityName(issue->severity), QString::fromStdString(issue->where.text())));
    }
    list_->setVisible(list_->count() > 0);
    empty_->setVisible(list_->count() == 0);
}

} // namespace hygroloom
