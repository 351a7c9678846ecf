// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The widgets of the page of studies, and what they are connected to.
#include "ui/basics/appearance.h"
#include "ui/basics/preferences.h"
#include "ui/basics/quantity.h"
#include "ui/compare/chart_style.h"
#include "ui/document/document.h"
#include "ui/study/effects_view.h"
#include "ui/study/indices_view.h"
#include "ui/study/pairs_view.h"
#include "ui/study/parallel_view.h"
#include "ui/study/study_page.h"
#include "ui/study/study_setup.h"
#include "ui/study/study_table.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QTabWidget>
#include <QTableView>

#include <utility>

namespace hygroloom {

namespace {

constexpr int pause_ms = 300, follow_ms = 2000;

/// Of the axes.
QStringList unitsShown()
{
    QStringList units;
    for (const char* unit : {"mm", "/cm", "tex", "°C"}) { units << userUnit(QString::fromUtf8(unit)).unit; }
    return units;
}

} // namespace

void StudyPage::build()
{
    auto* split = new QSplitter(Qt::Horizontal);
    split->setChildrenCollapsible(false);
    split->addWidget(buildLeft());
    split->addWidget(buildRight());
    split->setStretchFactor(0, 0);
    split->setStretchFactor(1, 1);
    split->setSizes({400, 880});
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(split);
    pause_.setSingleShot(true);
    pause_.setInterval(pause_ms);
    following_.setInterval(follow_ms);
}

QWidget* StudyPage::buildLeft()
{
    const auto button = [](const QString& text, const QString& tip) {
        auto* made = new QPushButton(text);
        made->setToolTip("<p>" + tip + "</p>");
        return made;
    };
    auto* fresh = button(tr("&New"), tr("Begin another study."));
    auto* open = button(tr("&Open…"), tr("Open a study file."));
    auto* save = button(tr("&Save"), tr("Save the study file."));
    auto* save_as = button(tr("Sa&ve As…"), tr("Save the study file under another name."));
    connect(fresh, &QPushButton::clicked, this, &StudyPage::newStudy);
    connect(open, &QPushButton::clicked, this, &StudyPage::chooseStudy);
    connect(save, &QPushButton::clicked, this, [this] { this->save(false); });
    connect(save_as, &QPushButton::clicked, this, [this] { this->save(true); });
    auto* files = new QHBoxLayout;
    files->setContentsMargins(8, 8, 8, 0);
    for (QPushButton* each : {fresh, open, save, save_as}) { files->addWidget(each); }
    name_->setContentsMargins(10, 0, 8, 0);
    name_->setAccessibleName(tr("Name of the study"));
    auto* scroll = new QScrollArea;
    scroll->setWidget(setup_);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* place = new QHBoxLayout;
    auto* choose = new QPushButton(tr("&Choose…"));
    choose->setToolTip(tr("Choose the folder for the results."));
    connect(choose, &QPushButton::clicked, this, &StudyPage::chooseFolder);
    folder_->setEditable(true);
    folder_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    folder_->setMinimumContentsLength(12);
    folder_->setAccessibleName(tr("Folder for the results"));
    place->addWidget(new QLabel(tr("Results in:")));
    place->addWidget(folder_, 1);
    place->addWidget(choose);
    auto* foot = new QVBoxLayout;
    foot->setContentsMargins(8, 4, 8, 8);
    foot->setSpacing(6);
    foot->addWidget(problems_);
    foot->addWidget(cost_);
    foot->addLayout(place);
    auto* buttons = new QHBoxLayout;
    run_->setToolTip("<p>" + tr("Run what the folder lacks of the study.") + "</p>");
    stop_->setToolTip("<p>" + tr("Stop. The runs that have ended are kept; Run goes on.") + "</p>");
    cluster_->setToolTip("<p>" + tr("Write the study for a cluster, and see what to type there.") + "</p>");
    for (QPushButton* each : {run_, stop_, cluster_}) { buttons->addWidget(each); }
    foot->addLayout(buttons);
    auto* left = new QWidget;
    left->setMinimumWidth(350);
    auto* layout = new QVBoxLayout(left);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addLayout(files);
    layout->addWidget(name_);
    layout->addWidget(scroll, 1);
    layout->addLayout(foot);
    return left;
}

QWidget* StudyPage::buildRight()
{
    auto* head = new QHBoxLayout;
    head->setContentsMargins(8, 8, 8, 0);
    auto* open = new QPushButton(tr("Open &Results…"));
    open->setToolTip(tr("Open the folder of a study that has run."));
    connect(open, &QPushButton::clicked, this, &StudyPage::chooseResults);
    heading_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    heading_->setAccessibleName(tr("Results shown"));
    head->addWidget(heading_, 1);
    head->addWidget(failures_);
    head->addWidget(retry_);
    head->addWidget(open);
    tabs_->setDocumentMode(true);
    tabs_->addTab(buildTable(), tr("Table"));
    tabs_->addTab(effects_, tr("Main Effects"));
    tabs_->addTab(pairs_, tr("Pairs"));
    tabs_->addTab(parallel_, tr("Parallel Coordinates"));
    tabs_->addTab(indices_, tr("Sensitivity"));
    auto* foot = new QHBoxLayout;
    foot->setContentsMargins(8, 0, 8, 0);
    row_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    row_->setTextFormat(Qt::PlainText);
    row_->setAccessibleName(tr("Chosen row"));
    candidate_->setToolTip("<p>" + tr("Add a fabric with the values of the chosen row to the project.") + "</p>");
    foot->addWidget(row_, 1);
    foot->addWidget(candidate_);
    auto* progress = new QHBoxLayout;
    progress->setContentsMargins(8, 0, 8, 8);
    bar_->setRange(0, 1000);
    bar_->setTextVisible(false);
    bar_->setAccessibleName(tr("Progress of the study"));
    bar_->setFixedWidth(220);
    bar_->setVisible(false);
    progress->addWidget(bar_);
    progress->addWidget(status_, 1);
    auto* right = new QWidget;
    auto* layout = new QVBoxLayout(right);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(head);
    layout->addWidget(tabs_, 1);
    layout->addLayout(foot);
    layout->addLayout(progress);
    return right;
}

QWidget* StudyPage::buildTable()
{
    view_->setModel(model_);
    view_->setAccessibleName(tr("Rows of the study"));
    view_->setSelectionBehavior(QAbstractItemView::SelectRows);
    view_->setSelectionMode(QAbstractItemView::SingleSelection);
    view_->setAlternatingRowColors(true);
    view_->setFrameShape(QFrame::NoFrame);
    view_->setWordWrap(false);
    view_->setTabKeyNavigation(false);
    view_->verticalHeader()->hide();
    view_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    view_->verticalHeader()->setDefaultSectionSize(view_->fontMetrics().height() + 8);
    view_->horizontalHeader()->setResizeContentsPrecision(50);
    view_->horizontalHeader()->setSortIndicator(-1, Qt::AscendingOrder);
    view_->setSortingEnabled(true);
    return view_;
}

void StudyPage::connectParts()
{
    connect(setup_, &StudySetup::changed, this, &StudyPage::refreshSetup);
    connect(&pause_, &QTimer::timeout, this, &StudyPage::foretell);
    connect(run_, &QPushButton::clicked, this, [this] { run(); });
    connect(retry_, &QPushButton::clicked, this, [this] { run(true); });
    connect(stop_, &QPushButton::clicked, &job_, &StudyTask::cancel);
    connect(stop_, &QPushButton::clicked, this, [this] { status_->setText(tr("Stopping.")); });
    connect(cluster_, &QPushButton::clicked, this, &StudyPage::showCluster);
    connect(failures_, &QPushButton::clicked, this, &StudyPage::showFailures);
    connect(&job_, &StudyTask::progressed, this, &StudyPage::refreshRun);
    connect(&job_, &StudyTask::noted, this, &StudyPage::messageShown);
    connect(&job_, &StudyTask::ended, this, &StudyPage::endRun);
    connect(&following_, &QTimer::timeout, this, &StudyPage::followRun);
    connect(&parallel_->chart(), &ParallelChart::brushed, this, &StudyPage::takeBrush);
    connect(&pairs_->chart(), &StudyChart::rowChosen, this, [this](std::size_t row) { choose(row); });
    connect(indices_, &IndicesView::computeRequested, this, &StudyPage::computeIndices);
    connect(candidate_, &QPushButton::clicked, this, &StudyPage::makeCandidate);
    connect(view_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& current) {
        if (current.isValid()) { choose(model_->rowAt(current.row())); }
    });
    connect(model_, &QAbstractItemModel::modelReset, this, [this] {
        const int shown = chosen_ && !model_->isEmpty() ? model_->shownAt(*chosen_) : -1;
        if (shown >= 0) { view_->selectRow(shown); } // sorted anew
    });
    connect(folder_, &QComboBox::editTextChanged, this, &StudyPage::refreshSetup);
    connect(&PreferenceNews::instance(), &PreferenceNews::changed, this, [this, before = unitsShown()]() mutable {
        const QStringList now = unitsShown();
        if (std::exchange(before, now) == now) { return; }
        setup_->refreshUnits();
        if (data_) { openResults(data_->path); }
    });
    connect(&document_, &Document::pathChanged, this, &StudyPage::proposeFolder);
    connect(&document_, &Document::replaced, this, [this] {
        path_.clear();
        Study fresh;
        fresh.points = 64;
        fresh.fidelity = Fidelity::draft;
        setup_->setStudy(fresh);
        saved_ = setup_->study();
        refreshSetup();
    });
}

} // namespace hygroloom
