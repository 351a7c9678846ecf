// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/panels/issues_panel.h"

#include "ui/basics/appearance.h"
#include "ui/basics/issue_text.h"
#include "ui/basics/preferences.h"
#include "ui/weave/cloth_picture.h"

#include <QLabel>
#include <QListWidget>
#include <QRegularExpression>
#include <QVBoxLayout>

#include <algorithm>
#include <cstdlib>

namespace hygroloom {

namespace {

/// The part of a fabric or an experiment a path goes into, where it is a thing one would name.
QString partInWords(const QString& path)
{
    static const QRegularExpression extra("^\\.extra_yarns\\[(\\d+)\\]"), droplet("^\\.droplets\\[(\\d+)\\]"),
        climate("^\\.climate\\[(\\d+)\\]");
    if (path.startsWith(".warp.") || path == ".warp") { return IssuesPanel::tr("warp"); }
    if (path.startsWith(".weft.") || path == ".weft") { return IssuesPanel::tr("weft"); }
    if (const auto match = extra.match(path); match.hasMatch()) {
        const int yarn = match.captured(1).toInt() + 1;
        return IssuesPanel::tr("yarn %1 (extra yarn %2)").arg(yarnLetter(yarn)).arg(yarn);
    }
    if (const auto match = droplet.match(path); match.hasMatch()) {
        return IssuesPanel::tr("droplet %1").arg(match.captured(1).toInt() + 1);
    }
    if (const auto match = climate.match(path); match.hasMatch()) {
        const int moment = match.captured(1).toInt();
        return moment == 0 ? IssuesPanel::tr("initial climate") : IssuesPanel::tr("climate, row %1").arg(moment);
    }
    return {};
}

template <typename Item> QString nameIn(const std::vector<Item>& items, std::size_t index)
{
    return index < items.size() ? QString::fromStdString(items[index].name) : QString();
}

bool repeatsTheWarp(const Document& document, const Issue& issue)
{
    const std::size_t weft = issue.where.find("].weft");
    if (weft == std::string::npos) { return false; }
    const std::string warp = std::string(issue.where).replace(weft, 6, "].warp");
    const auto fabric = static_cast<std::size_t>(std::atoi(issue.where.c_str() + sizeof("fabrics[") - 1));
    const auto& fabrics = document.design()->fabrics;
    return fabric < fabrics.size() && fabrics[fabric].warp == fabrics[fabric].weft &&
           std::any_of(document.issues().begin(), document.issues().end(),
                       [&](const Issue& other) { return other.where == warp && other.text == issue.text; });
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
    static const QRegularExpression owner("^(fabrics|experiments|materials|liquids)\\[(\\d+)\\]");
    const QString where = QString::fromStdString(issue.where), text = issueText(issue);
    const auto match = owner.match(where);
    if (!match.hasMatch()) { return text; }
    const auto index = static_cast<std::size_t>(match.captured(2).toInt());
    const QString list = match.captured(1), part = partInWords(where.mid(match.capturedEnd()));
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
    } else {
        name = nameIn(design.materials, index);
        number = IssuesPanel::tr("Material %1");
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
    connect(list_, &QListWidget::itemActivated, this,
            [this](QListWidgetItem* item) { Q_EMIT issueActivated(item->data(Qt::UserRole).toString()); });
    connect(list_, &QListWidget::itemClicked, this,
            [this](QListWidgetItem* item) { Q_EMIT issueActivated(item->data(Qt::UserRole).toString()); });
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
        item->setData(Qt::UserRole, QString::fromStdString(issue->where));
        item->setToolTip(tr("%1 at %2").arg(severityName(issue->severity), QString::fromStdString(issue->where)));
    }
    list_->setVisible(list_->count() > 0);
    empty_->setVisible(list_->count() == 0);
}

} // namespace hygroloom
