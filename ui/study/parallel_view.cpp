// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/study/parallel_view.h"

#include "ui/compare/chart_style.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>

namespace hygroloom {

ParallelView::ParallelView(QWidget* parent) : QWidget(parent), color_(new QComboBox), chart_(new ParallelChart)
{
    color_->setAccessibleName(tr("Column that colours the lines"));
    auto* all = new QPushButton(tr("Show &All Rows"));
    all->setToolTip(tr("Take away the ranges on the axes."));
    all->setEnabled(false);
    auto* head = new QHBoxLayout;
    head->setContentsMargins(8, 6, 8, 0);
    head->addWidget(new QLabel(tr("Colour:")));
    head->addWidget(color_);
    head->addStretch();
    head->addWidget(all);
    QLabel* note = makeNote(tr("What the parallel coordinates show"));
    note->setText(
        tr("Each line is a row. Drag along an axis to keep the rows in that range, here and in the table; a click takes the range "
           "away."));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(head);
    layout->addWidget(chart_, 1);
    layout->addWidget(note);
    connect(color_, &QComboBox::currentIndexChanged, this, [this] { chart_->setColor(chosenAxis(*color_, data_.get())); });
    connect(all, &QPushButton::clicked, chart_, &ParallelChart::clearBrushes);
    connect(chart_, &ParallelChart::brushed, all, [this, all] { all->setEnabled(!chart_->brushes().empty()); });
}

void ParallelView::setStudy(const std::shared_ptr<const StudyData>& study)
{
    data_ = study;
    std::size_t factors = 0;
    for (std::size_t i = 0; study && i < study->axes.size(); ++i) { factors += study->axes[i].is_factor && !study->axes[i].empty; }
    fillAxes(*color_, study.get(), true, true, factors);
    chart_->setStudy(study);
    chart_->setColor(chosenAxis(*color_, study.get()));
}

} // namespace hygroloom
