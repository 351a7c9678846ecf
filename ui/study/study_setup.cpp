// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/study/study_setup.h"

#include "core/base/error.h"
#include "ui/document/document.h"
#include "ui/study/field_picker.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSpinBox>
#include <QTreeWidget>

#include <algorithm>

namespace hygroloom {

namespace {

constexpr int auto_fidelity = static_cast<int>(all_fidelities.size());

QListWidget* makeList(const QString& name, int height)
{
    auto* list = new QListWidget;
    list->setAccessibleName(name);
    list->setFixedHeight(height);
    list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list->setTextElideMode(Qt::ElideMiddle);
    return list;
}

} // namespace

StudySetup::StudySetup(Document& document, QWidget* parent)
    : QWidget(parent), document_(document), fabrics_(makeList(tr("Fabrics of the study"), 84)),
      experiments_(makeList(tr("Experiments of the study"), 84)), metrics_(makeList(tr("Metrics of the study"), 120)),
      factors_(new QTreeWidget), form_(new FactorForm), add_(new QPushButton(tr("&Add Factors…"))), remove_(new QPushButton(tr("Re&move"))),
      sampling_(new QComboBox), points_(new QSpinBox), replicates_(new QSpinBox), fidelity_(new QComboBox), error_(new QDoubleSpinBox),
      sensitivity_(new QComboBox), seed_(new QLineEdit)
{
    build();
    Study fresh;
    fresh.points = 64;
    fresh.fidelity = Fidelity::draft;
    setStudy(fresh);
    connectFields();
}

void StudySetup::build()
{
    auto* runs = new QHBoxLayout;
    for (const auto& [title, list] : {std::pair(tr("Fabrics"), fabrics_), std::pair(tr("Experiments"), experiments_)}) {
        auto* column = new QVBoxLayout;
        column->setSpacing(2);
        auto* label = new QLabel(title);
        label->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
        column->addWidget(label);
        column->addWidget(list);
        runs->addLayout(column);
    }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(8);
    layout->addLayout(runs);
    layout->addWidget(buildFactors());
    layout->addWidget(buildPoints());
    layout->addWidget(new QLabel(tr("Metrics")));
    layout->addWidget(metrics_);
    layout->addStretch();
}

QWidget* StudySetup::buildFactors()
{
    factors_->setAccessibleName(tr("Factors of the study"));
    factors_->setHeaderLabels({tr("Factor"), tr("Spread")});
    factors_->setRootIsDecorated(false);
    factors_->setUniformRowHeights(true);
    factors_->setFixedHeight(130);
    factors_->setTextElideMode(Qt::ElideMiddle);
    factors_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    factors_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    factors_->header()->setStretchLastSection(false);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(add_);
    buttons->addWidget(remove_);
    buttons->addStretch();
    auto* box = new QGroupBox(tr("Factors"));
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(8, 6, 8, 8);
    layout->setSpacing(4);
    layout->addWidget(factors_);
    layout->addLayout(buttons);
    layout->addWidget(form_);
    return box;
}

QWidget* StudySetup::buildPoints()
{
    sampling_->addItems({tr("Grid"), tr("Latin hypercube"), tr("Sobol sequence"), tr("One at a time")}); // as Sampling has them
    fidelity_->addItems({tr("Live"), tr("Draft"), tr("Standard"), tr("Reference"), tr("Fastest within an error")});
    sensitivity_->addItems({tr("Off"), tr("Points laid out for it"), tr("From a surface")}); // as Sensitivity has them
    points_->setRange(1, static_cast<int>(most_study_rows));
    replicates_->setRange(1, 1000);
    error_->setRange(0.1, 100);
    error_->setSuffix(tr(" %"));
    error_->setDecimals(1);
    error_->setValue(5);
    auto* box = new QGroupBox(tr("Points"));
    numbers_ = new QFormLayout(box);
    numbers_->setContentsMargins(8, 6, 8, 8);
    numbers_->setVerticalSpacing(4);
    const auto add = [this](const QString& label, QWidget* field, const QString& tip) {
        field->setAccessibleName(QString(label).remove(':'));
        if (!tip.isEmpty()) { field->setToolTip("<p>" + tip + "</p>"); }
        numbers_->addRow(label, field);
    };
    add(tr("Design:"), sampling_, tr("How the points are spread over the factors."));
    add(tr("Points:"), points_, tr("Of a grid, the most that there may be."));
    add(tr("Replicates:"), replicates_, tr("Runs of each point with cloths that their description leaves open."));
    add(tr("Fidelity:"), fidelity_, {});
    add(tr("Error at most:"), error_, {});
    add(tr("Sensitivity:"), sensitivity_,
        tr("Which factors matter. Points laid out for it need some hundred points a factor; a surface fitted to the points needs fewer."));
    add(tr("Seed:"), seed_, tr("The same seed gives the same points."));
    return box;
}

void StudySetup::connectFields()
{
    for (QListWidget* list : {fabrics_, experiments_, metrics_}) { connect(list, &QListWidget::itemChanged, this, &StudySetup::edited); }
    for (QComboBox* box : {sampling_, fidelity_, sensitivity_}) {
        connect(box, &QComboBox::currentIndexChanged, this, &StudySetup::edited);
    }
    for (QSpinBox* box : {points_, replicates_}) { connect(box, &QSpinBox::valueChanged, this, &StudySetup::edited); }
    connect(error_, &QDoubleSpinBox::valueChanged, this, &StudySetup::edited);
    connect(seed_, &QLineEdit::editingFinished, this, &StudySetup::edited);
    connect(add_, &QPushButton::clicked, this, &StudySetup::pickFields);
    connect(remove_, &QPushButton::clicked, this, &StudySetup::removeFactor);
    connect(form_, &FactorForm::edited, this, &StudySetup::takeFactor);
    connect(factors_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        const int row = factors_->indexOfTopLevelItem(item);
        form_->setVisible(row >= 0);
        remove_->setEnabled(row >= 0);
        if (row >= 0 && !filling_) { showFactor(static_cast<std::size_t>(row)); }
    });
    connect(&document_, &Document::designChanged, this, [this] {
        stale_ = true;
        if (!isVisible()) { return; }
        stale_ = false;
        refreshLists();
        edited();
    });
}

void StudySetup::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (!std::exchange(stale_, false)) { return; }
    refreshLists();
    edited();
}

void StudySetup::setStudy(const Study& study)
{
    const QScopedValueRollback filling(filling_, true);
    kept_ = study;
    drafts_.clear();
    for (const Factor& factor : study.factors) { drafts_.push_back({factor, {}}); }
    fabrics_->clear();
    experiments_->clear();
    metrics_->clear();
    known_metrics_.clear();
    sampling_->setCurrentIndex(static_cast<int>(study.sampling));
    points_->setValue(study.points > 0 ? static_cast<int>(study.points) : 64);
    replicates_->setValue(study.replicates);
    fidelity_->setCurrentIndex(study.fidelity ? static_cast<int>(*study.fidelity) : auto_fidelity);
    if (!study.fidelity) { error_->setValue(100 * study.error); }
    sensitivity_->setCurrentIndex(static_cast<int>(study.sensitivity));
    seed_->setText(QString::number(study.seed));
    refreshLists();
    refreshFactors();
    selectFactor(0);
    refreshProblems();
}

void StudySetup::tick(const QString& name, bool on)
{
    for (QListWidget* list : {fabrics_, experiments_}) {
        for (QListWidgetItem* item : list->findItems(name, Qt::MatchExactly)) { item->setCheckState(on ? Qt::Checked : Qt::Unchecked); }
    }
}

void StudySetup::tickMetric(const std::string& key, bool on)
{
    for (int i = 0; i < metrics_->count(); ++i) {
        QListWidgetItem* item = metrics_->item(i);
        if (item->data(Qt::UserRole).toString().toStdString() == key) { item->setCheckState(on ? Qt::Checked : Qt::Unchecked); }
    }
}

void StudySetup::pickFields()
{
    QStringList taken;
    for (const DraftFactor& draft : drafts_) { taken << QString::fromStdString(draft.factor.path); }
    FieldPicker picker(*document_.design(), read(), taken, this);
    if (picker.exec() == QDialog::Accepted) { addFactors(picker.chosen()); }
}

void StudySetup::addFactors(const std::vector<StudyField>& fields)
{
    for (const StudyField& field : fields) { drafts_.push_back({proposedFactor(field.path, field.value), {}}); }
    refreshFactors();
    selectFactor(static_cast<int>(drafts_.size()) - 1);
    edited();
}

void StudySetup::removeFactor()
{
    const int row = factors_->indexOfTopLevelItem(factors_->currentItem());
    if (row < 0) { return; }
    drafts_.erase(drafts_.begin() + row);
    refreshFactors();
    selectFactor(std::min(row, static_cast<int>(drafts_.size()) - 1));
    edited();
}

void StudySetup::showFactor(std::size_t row)
{
    const Factor& factor = drafts_[row].factor;
    form_->setFactor(factor, unitOfFactor(fieldAt(*document_.design(), factor.path).unit));
}

void StudySetup::selectFactor(int row)
{
    factors_->setCurrentItem(factors_->topLevelItem(row));
    const bool is = row >= 0 && row < static_cast<int>(drafts_.size());
    form_->setVisible(is);
    remove_->setEnabled(is);
    if (is) { showFactor(static_cast<std::size_t>(row)); }
}

void StudySetup::refreshUnits()
{
    {
        const QScopedValueRollback filling(filling_, true);
        known_metrics_.clear(); // or their list stays
        refreshMetrics();
    }
    refreshFactors();
    selectFactor(factors_->indexOfTopLevelItem(factors_->currentItem()));
    refreshProblems();
}

void StudySetup::takeFactor()
{
    const int row = factors_->indexOfTopLevelItem(factors_->currentItem());
    if (row < 0) { return; }
    drafts_[static_cast<std::size_t>(row)] = form_->factor();
    refreshFactors();
    edited();
}

void StudySetup::setPoints(Sampling sampling, int points)
{
    sampling_->setCurrentIndex(static_cast<int>(sampling));
    points_->setValue(points);
}

void StudySetup::setFidelity(Fidelity fidelity) { fidelity_->setCurrentIndex(static_cast<int>(fidelity)); }

void StudySetup::edited()
{
    if (filling_) { return; }
    {
        const QScopedValueRollback filling(filling_, true);
        refreshMetrics();
        refreshProblems();
    }
    Q_EMIT changed();
}

} // namespace hygroloom
