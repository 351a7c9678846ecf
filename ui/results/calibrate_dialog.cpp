// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/calibrate_dialog.h"

#include "core/base/error.h"
#include "core/project/atomic_file.h"
#include "ui/basics/preferences.h"
#include "ui/basics/quantity.h"
#include "ui/results/fit_chart.h"
#include "ui/results/plan_dialog.h"
#include "ui/results/report_file.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

namespace hygroloom {

namespace {

QString words(const std::string& text) { return QString::fromStdString(text); }

QString number(double value, const FreeInput& input, int digits = 3)
{
    return shownNumber(value, input.unit.empty() ? digits : std::max(0, digits - 2)) + words(input.unit);
}

QString inputTitle(const std::string& key)
{
    if (key == "contact_angle_deg") { return CalibrateDialog::tr("Contact angle"); }
    return key == "receding_angle_deg" ? CalibrateDialog::tr("Receding angle") : CalibrateDialog::tr("Packing factor");
}

} // namespace

CalibrateDialog::CalibrateDialog(Document& document, WindowQueue& queue, Fidelity fidelity, const std::string& backend, QWidget* parent)
    : QDialog(parent), document_(document), backend_(backend), experiments_(new QComboBox), fidelity_(new QComboBox), file_(new QLineEdit),
      browse_(new QPushButton(tr("&Browse…"))), chart_(new FitChart), table_(new QTableWidget), message_(new QLabel),
      progress_(new QProgressBar), start_(new QPushButton), apply_(new QPushButton(tr("&Apply"))),
      report_(new QPushButton(tr("&Save Report…"))), run_(queue)
{
    setWindowTitle(tr("Calibrate"));
    for (const Fidelity one : all_fidelities) { fidelity_->addItem(fidelityName(one), static_cast<int>(one)); }
    fidelity_->setCurrentIndex(fidelity_->findData(static_cast<int>(fidelity)));
    auto* form = new QFormLayout;
    buildForm(form);
    buildResult();
    arrange(form);
    connect(&run_, &CalibrationRun::progressed, this, [this](int done, double share) {
        progress_->setValue(static_cast<int>(1000 * share));
        progress_->setFormat(tr("%n runs done", nullptr, done));
    });
    connect(&run_, &CalibrationRun::ended, this, &CalibrateDialog::showEnd);
    refresh();
    resize(760, 700);
}

void CalibrateDialog::buildForm(QFormLayout* form)
{
    auto* fabric = new QLabel(document_.fabric() ? words(document_.fabric()->name) : QString());
    fabric->setTextFormat(Qt::PlainText);
    form->addRow(tr("Fabric"), fabric);
    for (const Experiment& experiment : document_.design()->experiments) { experiments_->addItem(words(experiment.name)); }
    experiments_->setCurrentIndex(document_.experimentIndex());
    experiments_->setAccessibleName(tr("Experiment"));
    form->addRow(tr("&Experiment"), experiments_);
    auto* row = new QHBoxLayout;
    file_->setPlaceholderText(tr("CSV: time_s and a series such as wick_height_mm, or a table of metrics"));
    file_->setAccessibleName(tr("Measured file"));
    row->addWidget(file_, 1);
    row->addWidget(browse_);
    auto* label = new QLabel(tr("&Measured"));
    label->setBuddy(file_);
    form->addRow(label, row);
    auto* free = new QVBoxLayout;
    for (std::size_t i = 0; i < inputs_.size(); ++i) {
        Input& input = inputs_[i];
        const std::string& key = free_input_keys()[i];
        input.box = new QCheckBox(inputTitle(key));
        try {
            if (!document_.hasError() && document_.fabric()) { input.input = free_input(*document_.design(), *document_.fabric(), key); }
        } catch (const Error& error) {
            input.box->setToolTip(words(error.what()));
        }
        input.box->setEnabled(input.input.has_value());
        if (input.input) {
            input.box->setText(tr("%1: now %2, from %3 to %4")
                                   .arg(inputTitle(key), number(input.input->given, *input.input), number(input.input->low, *input.input),
                                        number(input.input->high, *input.input)));
        } else {
            input.box->setText(tr("%1: known").arg(inputTitle(key)));
        }
        input.box->setChecked(i == 0 && input.input);
        connect(input.box, &QCheckBox::toggled, this, &CalibrateDialog::refresh);
        free->addWidget(input.box);
    }
    form->addRow(tr("Fit"), free);
    fidelity_->setAccessibleName(tr("Fidelity"));
    form->addRow(tr("F&idelity"), fidelity_);
    connect(browse_, &QPushButton::clicked, this, &CalibrateDialog::browse);
    connect(file_, &QLineEdit::editingFinished, this, &CalibrateDialog::readFile);
    connect(experiments_, &QComboBox::currentIndexChanged, this, &CalibrateDialog::readFile);
}

void CalibrateDialog::buildResult()
{
    table_->setColumnCount(3);
    table_->setHorizontalHeaderLabels({tr("before"), tr("fitted, 90 %"), tr("range")});
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionMode(QAbstractItemView::NoSelection);
    table_->setAccessibleName(tr("Fitted inputs"));
    table_->setSizeAdjustPolicy(QAbstractScrollArea::AdjustToContents);
    table_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Maximum);
    message_->setTextFormat(Qt::PlainText);
    message_->setWordWrap(true);
    message_->setMinimumHeight(2 * fontMetrics().lineSpacing());
    message_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    message_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    message_->setAccessibleName(tr("Result of the calibration"));
    progress_->setRange(0, 1000);
    progress_->setAccessibleName(tr("Progress of the runs"));
    QSizePolicy stays = progress_->sizePolicy();
    stays.setRetainSizeWhenHidden(true);
    progress_->setSizePolicy(stays);
    progress_->hide();
    table_->hide();
}

void CalibrateDialog::arrange(QFormLayout* form)
{
    auto* close = new QPushButton(tr("Close"));
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(report_);
    buttons->addStretch();
    for (QPushButton* button : {start_, apply_, close}) { buttons->addWidget(button); }
    for (QPushButton* button : {report_, apply_, close}) { button->setAutoDefault(false); }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(12);
    layout->addLayout(form);
    layout->addWidget(chart_, 1);
    layout->addWidget(table_);
    layout->addWidget(message_);
    layout->addWidget(progress_);
    layout->addLayout(buttons);
    connect(start_, &QPushButton::clicked, this, &CalibrateDialog::startOrCancel);
    connect(apply_, &QPushButton::clicked, this, &CalibrateDialog::apply);
    connect(report_, &QPushButton::clicked, this, &CalibrateDialog::saveReport);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
}

const Experiment* CalibrateDialog::experiment() const
{
    const int i = experiments_->currentIndex();
    return i >= 0 ? &document_.design()->experiments[static_cast<std::size_t>(i)] : nullptr;
}

void CalibrateDialog::browse()
{
    const QString path = QFileDialog::getOpenFileName(this, tr("Measured File"), {}, tr("Tables (*.csv);;All files (*)"));
    if (!path.isEmpty()) { setFile(path); }
}

void CalibrateDialog::setFile(const QString& path)
{
    file_->setText(path);
    readFile();
}

void CalibrateDialog::readFile()
{
    data_.reset();
    file_complaint_.clear();
    result_.reset();
    const std::string path = file_->text().toStdString();
    if (!path.empty() && experiment() && document_.fabric()) {
        try {
            data_ =
                read_measured_data(read_file(path, std::size_t{16} << 20U), path, *document_.design(), *document_.fabric(), *experiment());
        } catch (const Error& error) {
            file_complaint_ = words(error.what());
        }
    }
    Calibration measured;
    if (data_) { measured.data = *data_; }
    chart_->show(measured);
    refresh();
}

std::vector<FreeInput> CalibrateDialog::chosenInputs() const
{
    std::vector<FreeInput> chosen;
    for (const Input& input : inputs_) {
        if (input.box->isChecked() && input.input) { chosen.push_back(*input.input); }
    }
    return chosen;
}

QString CalibrateDialog::complaint() const
{
    if (!document_.fabric() || !experiment()) { return tr("The project needs a fabric and an experiment."); }
    if (document_.hasError()) { return tr("The project has errors; correct them first."); }
    if (!file_complaint_.isEmpty()) { return file_complaint_; }
    if (!data_) { return tr("Choose a file of what was measured."); }
    const std::vector<FreeInput> chosen = chosenInputs();
    if (chosen.empty()) { return tr("Tick what is to be fitted."); }
    return words(refusal_of(*data_, chosen));
}

void CalibrateDialog::refresh()
{
    const bool running = run_.running();
    for (const Input& input : inputs_) { input.box->setEnabled(!running && input.input); }
    const std::initializer_list<QWidget*> fields{experiments_, fidelity_, file_, browse_};
    for (QWidget* field : fields) { field->setEnabled(!running); }
    const QString why = complaint();
    start_->setText(running ? tr("&Cancel") : tr("&Run"));
    start_->setEnabled(running || why.isEmpty());
    progress_->setVisible(running);
    const bool fitted = !running && result_ && !result_->fitted.empty();
    report_->setEnabled(fitted);
    apply_->setEnabled(fitted && result_->identifiable());
    if (!running && !result_) { message_->setText(why); }
    showInputs();
}

void CalibrateDialog::showInputs()
{
    table_->setRowCount(0);
    table_->setVisible(result_ != nullptr);
    if (!result_) { return; }
    for (const FittedInput& input : result_->inputs) {
        const int row = table_->rowCount();
        table_->insertRow(row);
        table_->setVerticalHeaderItem(row, new QTableWidgetItem(inputTitle(input.key)));
        const QString half = shownNumber(input.half, input.unit.empty() ? 3 : 1);
        table_->setItem(row, 0, new QTableWidgetItem(number(input.given, input)));
        table_->setItem(row, 1,
                        new QTableWidgetItem(input.half > 0 ? QString("%1 ± %2").arg(number(input.value, input), half + words(input.unit))
                                                            : number(input.value, input)));
        table_->setItem(row, 2, new QTableWidgetItem(tr("%1 to %2").arg(number(input.low, input), number(input.high, input))));
    }
}

void CalibrateDialog::startOrCancel()
{
    if (run_.running()) {
        run_.cancel();
        return;
    }
    if (!complaint().isEmpty()) { return; }
    result_.reset();
    message_->clear();
    progress_->setValue(0);
    RunOptions how;
    how.fidelity = static_cast<Fidelity>(fidelity_->currentData().toInt());
    how.may_go_on_on_cpu = true;
    how.threads = preferences().threads;
    run_.start({document_.design(), document_.fabric()->name, experiment()->name, *data_, chosenInputs(), how, backend_});
    refresh();
}

void CalibrateDialog::showEnd(const std::shared_ptr<const Calibration>& result, const QString& sentence)
{
    result_ = result;
    refresh();
    if (!result) {
        message_->setText(sentence.isEmpty() ? tr("Cancelled.") : sentence);
        return;
    }
    chart_->show(*result);
    QString text = words(result->refusal);
    if (text.isEmpty()) {
        text = tr("Residual: %1 before, %2 after, %3.")
                   .arg(shownNumber(result->residual_rms_before, 3), shownNumber(result->residual_rms, 3),
                        result->data.is_curve() ? words(result->data.unit) : tr("in spreads"));
        for (const std::string& note : result->notes) { text += " " + words(note); }
    }
    message_->setText(text);
}

QString CalibrateDialog::message() const { return message_->text(); }

void CalibrateDialog::apply()
{
    if (!result_ || !result_->identifiable() || run_.running()) { return; }
    document_.edit(tr("calibration"), {}, [this](Design& design) { design = calibrated_design(design, *result_); });
    accept();
}

void CalibrateDialog::saveReport()
{
    const QString path = askForReportFile(this, {}, "calibration");
    if (path.isEmpty()) { return; }
    try {
        writeReport(calibration_report(*result_), path);
        message_->setText(tr("Saved %1.").arg(path));
    } catch (const Error& error) {
        message_->setText(words(error.what()));
    }
}

void CalibrateDialog::done(int result)
{
    if (run_.running()) {
        run_.cancel();
        return;
    }
    QDialog::done(result);
}

} // namespace hygroloom
