// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/issues_panel.h"

#include "ui/appearance.h"

#include <QLabel>
#include <QListWidget>
#include <QVBoxLayout>

namespace hygroloom {

IssuesPanel::IssuesPanel(Document& document, QWidget* parent)
    : QWidget(parent)
    , document_(document)
    , list_(new QListWidget)
    , empty_(new QLabel(tr("Nothing to complain about.")))
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
    connect(list_, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) { Q_EMIT issueActivated(item->data(Qt::UserRole).toString()); });
    connect(list_, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) { Q_EMIT issueActivated(item->data(Qt::UserRole).toString()); });
    connect(&document_, &Document::designChanged, this, &IssuesPanel::refresh);
    refresh();
}

void IssuesPanel::refresh()
{
    list_->clear();
    for (const Issue& issue : document_.issues()) {
        auto* item = new QListWidgetItem(severityIcon(issue.severity), QString::fromStdString(issue.text), list_);
        item->setData(Qt::UserRole, QString::fromStdString(issue.where));
        item->setToolTip(tr("%1 at %2").arg(severityName(issue.severity), QString::fromStdString(issue.where)));
    }
    list_->setVisible(list_->count() > 0);
    empty_->setVisible(list_->count() == 0);
}

} // namespace hygroloom
