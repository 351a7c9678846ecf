// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/window/preferences_dialog.h"

#include "ui/basics/appearance.h"
#include "ui/basics/cache_folder.h"
#include "ui/basics/language.h"
#include "ui/basics/preferred_menu.h"
#include "ui/basics/quantity.h"
#include "ui/basics/wheel_guard.h"
#include "ui/results/device_choice.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDirIterator>
#include <QFormLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStackedWidget>
#include <QStandardItemModel>
#include <QVBoxLayout>

#include <algorithm>

namespace hygroloom {

namespace {

constexpr char language_setting[] = "look/language";
constexpr int devices_page = 6;

double bytesIn(const QString& folder)
{
    double bytes = 0;
    for (QDirIterator each(folder, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories); each.hasNext();) {
        each.next();
        bytes += static_cast<double>(each.fileInfo().size());
    }
    return bytes;
}

void change(int Preferences::*value, int to)
{
    Preferences chosen = preferences();
    chosen.*value = to;
    setPreferences(chosen);
}

} // namespace

PreferencesDialog::PreferencesDialog(QWidget* parent) : QDialog(parent), names_(new QListWidget), pages_(new QStackedWidget)
{
    setWindowTitle(tr("Preferences"));
    names_->setAccessibleName(tr("Pages of the preferences"));
    addUnits();
    addLanguage();
    addLook();
    addMouse();
    addAutosave();
    addRuns();
    addDevices();
    (new WheelGuard(this))->guard(pages_);
    names_->setFixedWidth(names_->sizeHintForColumn(0) + 24); // of the longest name, in any language
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::RestoreDefaults | QDialogButtonBox::Close);
    buttons->button(QDialogButtonBox::RestoreDefaults)->setText(tr("&Restore Defaults"));
    buttons->button(QDialogButtonBox::RestoreDefaults)->setToolTip(tr("Sets all pages to their defaults."));
    buttons->button(QDialogButtonBox::Close)->setText(tr("&Close"));
    for (QAbstractButton* button : buttons->buttons()) {
        button->setIcon({});
        qobject_cast<QPushButton*>(button)->setAutoDefault(false); // Enter commits a field
    }
    auto* middle = new QHBoxLayout;
    middle->setSpacing(16);
    middle->addWidget(names_);
    middle->addWidget(pages_, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 12, 12, 12);
    layout->setSpacing(12);
    layout->addLayout(middle, 1);
    layout->addWidget(buttons);
    resize(700, 440);
    connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this, &PreferencesDialog::restoreDefaults);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::accept);
    connect(names_, &QListWidget::currentRowChanged, this, &PreferencesDialog::showPage);
    connect(&PreferenceNews::instance(), &PreferenceNews::changed, this, &PreferencesDialog::refresh);
    refresh();
    names_->setCurrentRow(0);
}

void PreferencesDialog::showPage(int page)
{
    if (names_->currentRow() != page) {
        names_->setCurrentRow(page);
        return;
    }
    if (page == devices_page && !std::exchange(listed_, true)) { listDevices(*devices_); }
    pages_->setCurrentIndex(page);
}

void PreferencesDialog::restoreDefaults()
{
    QSettings().remove(language_setting);
    saveAppearance(Appearance::desktop);
    applyAppearance(Appearance::desktop);
    setPreferences({});
    refresh();
}

QFormLayout* PreferencesDialog::addPage(const QString& title, const QString& sentence)
{
    names_->addItem(title);
    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* heading = new QLabel(title);
    QFont bold = heading->font();
    bold.setBold(true);
    heading->setFont(bold);
    layout->addWidget(heading);
    if (!sentence.isEmpty()) {
        auto* words = new QLabel(sentence);
        words->setWordWrap(true);
        words->setForegroundRole(QPalette::PlaceholderText);
        layout->addWidget(words);
    }
    layout->addSpacing(6);
    auto* form = new QFormLayout;
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    layout->addLayout(form);
    layout->addStretch();
    auto* scroll = new QScrollArea;
    scroll->setWidget(page);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    pages_->addWidget(scroll);
    return form;
}

QComboBox* PreferencesDialog::addChoice(QFormLayout& form, const QString& label, int Preferences::*value, const QStringList& names)
{
    auto* box = new QComboBox;
    box->addItems(names);
    box->setAccessibleName(label);
    form.addRow(label, box);
    connect(box, &QComboBox::activated, this, [value](int index) { change(value, index); });
    refreshers_.push_back([box, value] { box->setCurrentIndex(preferences().*value); });
    return box;
}

void PreferencesDialog::addNumber(QFormLayout& form, const QString& label, int Preferences::*value, int least, int most,
                                  const QString& unit, const QString& of_zero, const QString& tip)
{
    auto* box = new QSpinBox;
    box->setRange(least, most);
    if (!unit.isEmpty()) { box->setSuffix(QChar(0x00a0) + unit); }
    box->setSpecialValueText(of_zero);
    box->setKeyboardTracking(false);
    box->setAccessibleName(label);
    box->setToolTip("<p>" + tip + "</p>");
    form.addRow(label, box);
    connect(box, &QSpinBox::valueChanged, this, [value](int number) { change(value, number); });
    refreshers_.push_back([box, value] {
        const QSignalBlocker quiet(box);
        box->setValue(preferences().*value);
    });
}

void PreferencesDialog::addTick(QFormLayout& form, const QString& label, int Preferences::*value)
{
    auto* box = new QCheckBox(label);
    form.addRow(box);
    connect(box, &QCheckBox::clicked, this, [value](bool on) { change(value, on ? 1 : 0); });
    refreshers_.push_back([box, value] { box->setChecked(preferences().*value != 0); });
}

QLabel* PreferencesDialog::addNote(QFormLayout& form, const QString& sentence)
{
    auto* note = new QLabel(sentence);
    note->setWordWrap(true);
    note->setTextFormat(Qt::PlainText);
    note->setForegroundRole(QPalette::PlaceholderText);
    note->setTextInteractionFlags(Qt::TextSelectableByMouse);
    note->setFocusPolicy(Qt::NoFocus);
    form.addRow(note);
    return note;
}

void PreferencesDialog::addUnits()
{
    QFormLayout* form = addPage(tr("Units"), tr("How numbers are shown. Fields take any unit that is typed with the number."));
    addChoice(*form, tr("Lengths"), &Preferences::length, {tr("millimetres (mm)"), tr("centimetres (cm)"), tr("inches (in)")});
    addChoice(*form, tr("Yarn count"), &Preferences::yarn,
              {tr("tex (g per km)"), tr("English cotton count (Ne)"), tr("metric count (Nm)"), tr("denier (g per 9 km)")});
    addChoice(*form, tr("Sett"), &Preferences::sett, {tr("per centimetre"), tr("per inch")});
    addChoice(*form, tr("Temperature"), &Preferences::degrees, {tr("degrees Celsius (°C)"), tr("degrees Fahrenheit (°F)")});
    addNote(*form,
            tr("Tables saved as files and the command line keep mm, tex and °C; so do the lesson and scale bars in pictures of reports."));
}

void PreferencesDialog::addLanguage()
{
    QFormLayout* form = addPage(tr("Language"));
    language_ = new QComboBox;
    language_->setAccessibleName(tr("Language"));
    language_->addItem(tr("As the system"), QString());
    for (const Language& language : languages()) { language_->addItem(language.name, language.code); }
    form->addRow(tr("Language"), language_);
    addNote(*form, tr("Acts at the next start."));
    connect(language_, &QComboBox::activated, this, [this] { QSettings().setValue(language_setting, language_->currentData()); });
    refreshers_.push_back([this] {
        language_->setCurrentIndex(std::max(0, language_->findData(QSettings().value(language_setting, QString()).toString())));
    });
}

void PreferencesDialog::addLook()
{
    QFormLayout* form = addPage(tr("Look"));
    look_ = new QComboBox;
    look_->setAccessibleName(tr("Appearance"));
    look_->addItems({tr("As the desktop"), tr("Light"), tr("Dark"), tr("High contrast")});
    form->addRow(tr("Appearance"), look_);
    connect(look_, &QComboBox::activated, this, [](int index) {
        saveAppearance(static_cast<Appearance>(index));
        applyAppearance(static_cast<Appearance>(index));
    });
    refreshers_.push_back([this] { look_->setCurrentIndex(static_cast<int>(savedAppearance())); });
    addChoice(*form, tr("Water colours"), &Preferences::water_colors, waterColorNames());
    addTick(*form, tr("Refine pictures of cloth while nothing moves"), &Preferences::refine_at_rest);
    addTick(*form, tr("Show the start page at the start"), &Preferences::start_page);
}

void PreferencesDialog::addMouse()
{
    QFormLayout* form = addPage(tr("Mouse"), tr("In pictures of cloth and of garments."));
    addChoice(*form, tr("Buttons"), &Preferences::navigation, navigationNames());
    addChoice(*form, tr("Wheel"), &Preferences::wheel_towards, {tr("forward comes nearer"), tr("backward comes nearer")});
    addTick(*form, tr("Zoom to the pointer, not to the middle"), &Preferences::zoom_to_pointer);
}

void PreferencesDialog::addAutosave()
{
    QFormLayout* form = addPage(
        tr("Autosave"), tr("A copy of unsaved work outlives a crash and is offered at the next start. Your own file changes only when you "
                           "save."));
    addNumber(*form, tr("Keep a copy every"), &Preferences::autosave_minutes, 0, most_autosave_minutes, tr("min"), tr("change, at once"),
              tr("1 to %1 minutes, or a second after each change.").arg(most_autosave_minutes));
    addNote(*form, tr("A crash loses at most what was changed since the last copy."));
}

void PreferencesDialog::addRuns()
{
    QFormLayout* form = addPage(tr("Runs"));
    addNumber(*form, tr("Room for the runs of a project"), &Preferences::runs_gigabytes, 1, most_runs_gigabytes, tr("GB"), {},
              tr("When a run ends and the runs take more, the window offers to delete the oldest that are not marked Keep."));
    addNumber(*form, tr("Threads of a run on the CPU"), &Preferences::threads, 0, most_threads, {}, tr("all"),
              tr("Running simulations keep theirs. Fewer threads leave room for other work."));
    cache_ = addNote(*form, {});
    cache_->setAccessibleName(tr("Cache"));
    auto* clear = new QPushButton(tr("C&lear the Cache"));
    clear->setToolTip(
        "<p>" + tr("Deletes pictures of the start page, what was found of rooms between yarns and how long runs took. All are made anew.") +
        "</p>");
    clear->setAutoDefault(false);
    clear->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    form->addRow(clear);
    connect(clear, &QPushButton::clicked, this, &PreferencesDialog::clearCache);
    refreshers_.push_back(
        [this] { cache_->setText(tr("Cache: %1 in %2").arg(bytesText(bytesIn(cacheFolder())), QDir::toNativeSeparators(cacheFolder()))); });
}

void PreferencesDialog::addDevices()
{
    devices_ = addPage(tr("Devices"), tr("Processors that runs may be computed on."));
    QComboBox* box = addChoice(*devices_, tr("For new runs"), &Preferences::backend,
                               {tr("Automatic: a GPU where one can be used"), tr("CPU"), tr("GPU")});
    box->setObjectName("backend");
}

void PreferencesDialog::listDevices(QFormLayout& form)
{
    bool usable = false;
    for (const DeviceLine& line : devicesOfThisMachine()) {
        usable = usable || (line.is_gpu && line.problem.isEmpty());
        addNote(form,
                line.problem.isEmpty() ? tr("%1: can be used").arg(line.name) : tr("%1: cannot be used. %2").arg(line.name, line.problem));
    }
    auto* box = findChild<QComboBox*>("backend");
    if (auto* model = qobject_cast<QStandardItemModel*>(box->model())) { model->item(2)->setEnabled(usable); }
}

void PreferencesDialog::clearCache()
{
    QDir folder(cacheFolder());
    if (folder.exists() && !folder.removeRecursively()) {
        cache_->setText(tr("%1 cannot be deleted. Check that the folder can be written to.").arg(QDir::toNativeSeparators(folder.path())));
        return;
    }
    refresh();
}

void PreferencesDialog::refresh()
{
    for (const auto& each : refreshers_) { each(); }
}

} // namespace hygroloom
