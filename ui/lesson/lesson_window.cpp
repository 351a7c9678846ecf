// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/lesson/lesson_window.h"

#include "core/base/error.h"
#include "ui/basics/ask.h"
#include "ui/basics/language.h"
#include "ui/basics/quantity.h"
#include "ui/basics/wheel_guard.h"
#include "ui/document/document.h"
#include "ui/lesson/cloth_choice.h"
#include "ui/lesson/lesson_controls.h"
#include "ui/lesson/lesson_scene.h"
#include "ui/lesson/lesson_steps.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QFile>
#include <QFileDialog>
#include <QFontInfo>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QScreen>
#include <QScrollArea>
#include <QToolButton>

#include <algorithm>

namespace hygroloom {

namespace {

constexpr int side_width = 300; // pixels
constexpr int look_ms = 100;
constexpr int own_cloths = 5, from_file = 6; // places in the list of lessons
constexpr const char* shipped[] = {"contact-angle", "weave", "fibre", "climate", "garment"};

/// Undyed cloth is so pale that water hardly shows on it.
Design dyed(Design design, std::size_t place)
{
    constexpr Color dyes[] = {{86, 124, 141}, {160, 98, 82}, {112, 128, 84}, {132, 104, 140}};
    const Color dye = dyes[place % std::size(dyes)];
    const auto dye_yarn = [&](Yarn& yarn) {
        if (!yarn.color) { yarn.color = dye; }
    };
    if (design.fabrics.empty()) { return design; } // the table says so
    Fabric& fabric = design.fabrics.front();
    dye_yarn(fabric.warp);
    dye_yarn(fabric.weft);
    for (Yarn& yarn : fabric.extra_yarns) { dye_yarn(yarn); }
    return design;
}

} // namespace

LessonWindow::LessonWindow(const Document& document, QWidget* parent)
    : QWidget(parent, Qt::Window), document_(document), scene_(new LessonScene), steps_(new LessonSteps), controls_(new LessonControls),
      lessons_(new QComboBox), clock_(new QLabel), pace_(new QLabel), note_(new QLabel),
      pause_(addButton(tr("Pause"), QKeySequence(Qt::Key_Space), true)), slow_(addButton(tr("Slow motion"), QKeySequence(Qt::Key_S), true)),
      reset_(addButton(tr("Reset"), QKeySequence(Qt::Key_R), false)), explain_(addButton(tr("Explain"), QKeySequence(Qt::Key_E), true)),
      squeeze_(addButton(tr("Squeeze"), QKeySequence(Qt::Key_Q), false)),
      screen_(addButton(tr("Full screen"), QKeySequence(Qt::Key_F11), true)),
      save_(addButton(tr("Save"), QKeySequence(Qt::CTRL | Qt::Key_S), false)),
      help_(addButton(tr("Help"), QKeySequence(Qt::Key_F1), false)), leave_(addButton(tr("Leave"), {}, false)), save_menu_(new QMenu(this))
{
    setWindowTitle(tr("Lesson – Hygroloom"));
    setObjectName("lesson window");
    resize(QSize(1280, 800).boundedTo(screen()->availableSize())); // where it does not fill the screen
    build();
    connectParts();
    chooseLesson(0);
    scene_->setFocus();
}

LessonWindow::~LessonWindow()
{
    scene_->setTable(nullptr, {});
    film_.disconnect(this);
}

QToolButton* LessonWindow::addButton(const QString& text, const QKeySequence& key, bool checkable)
{
    auto* button = new QToolButton;
    button->setText(text);
    button->setCheckable(checkable);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setFocusPolicy(Qt::NoFocus); // keys belong to the table
    if (!key.isEmpty()) {
        button->setShortcut(key);
        button->setToolTip(tr("%1 (%2)").arg(text, key.toString(QKeySequence::NativeText)));
    }
    return button;
}

void LessonWindow::build()
{
    for (const QString& name : {tr("Contact angle"), tr("Weave"), tr("Fibre"), tr("Climate"), tr("Garment"), tr("Cloths of my own…"),
                                tr("Lesson from a file…")}) {
        lessons_->addItem(name);
    }
    lessons_->setAccessibleName(tr("Lesson"));
    auto* scroll = new QScrollArea;
    scroll->setWidget(buildSide());
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFixedWidth(side_width);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(scene_, 1);
    layout->addWidget(scroll);
}

QWidget* LessonWindow::buildSide()
{
    clock_->setAlignment(Qt::AlignCenter);
    clock_->setAccessibleName(tr("Clock"));
    for (QLabel* label : {pace_, note_}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
    }
    pace_->setAlignment(Qt::AlignCenter);
    squeeze_->setToolTip(
        "<p>" +
        tr("All cloths are squeezed for a moment, so that their pores keep %1 % of their room. Liquid that has no place, and "
           "drops that stand, run off. Key: %2")
            .arg(qRound(100 * squeezed_share))
            .arg(squeeze_->shortcut().toString(QKeySequence::NativeText)) +
        "</p>");
    save_->setMenu(save_menu_);
    save_->setPopupMode(QToolButton::InstantPopup);
    auto* buttons = new QGridLayout;
    QToolButton* const all[] = {pause_, slow_, reset_, squeeze_, explain_, screen_, save_, help_, leave_};
    constexpr int count = static_cast<int>(std::size(all));
    for (int k = 0; k < count; ++k) { buttons->addWidget(all[k], k / 2, k % 2, 1, k + 1 < count || count % 2 == 0 ? 1 : 2); }
    auto* side = new QWidget;
    auto* layout = new QVBoxLayout(side);
    layout->addWidget(lessons_);
    layout->addWidget(steps_);
    layout->addStretch(1);
    layout->addWidget(clock_);
    layout->addWidget(pace_);
    layout->addLayout(buttons);
    layout->addWidget(controls_);
    layout->addWidget(note_);
    auto* wheel = new WheelGuard(this);
    wheel->guard(side);
    wheel->guardSliders(side);
    return side;
}

void LessonWindow::connectParts()
{
    connect(lessons_, &QComboBox::activated, this, &LessonWindow::chooseLesson);
    connect(pause_, &QToolButton::toggled, this, &LessonWindow::setSpeed);
    connect(slow_, &QToolButton::toggled, this, &LessonWindow::setSpeed);
    connect(reset_, &QToolButton::clicked, this, [this] {
        if (mayClear(tr("Reset"), tr("&Reset"))) { reset(); }
    });
    connect(squeeze_, &QToolButton::clicked, this, [this] {
        if (table_) { table_->squeeze(); }
    });
    connect(explain_, &QToolButton::toggled, scene_, &LessonScene::setExplains);
    connect(screen_, &QToolButton::toggled, this, [this](bool full) { setWindowState(windowState().setFlag(Qt::WindowFullScreen, full)); });
    connect(help_, &QToolButton::clicked, this, &LessonWindow::helpWanted);
    connect(leave_, &QToolButton::clicked, this, &QWidget::close);
    connect(save_menu_, &QMenu::aboutToShow, this, &LessonWindow::fillSaveMenu);
    connect(controls_, &LessonControls::dropChanged, scene_, &LessonScene::setDrop);
    connect(controls_, &LessonControls::airChanged, this, [this] {
        if (table_) { table_->blow(controls_->air()); }
    });
    connect(controls_, &LessonControls::tiltChanged, this, [this] {
        if (table_) { table_->tilt(controls_->tilt()); }
    });
    connect(&looks_, &QTimer::timeout, this, &LessonWindow::look);
    connect(&pictures_, &QTimer::timeout, this, [this] { film_.add(scene_->picture(clock_->text())); });
    connect(&film_, &Film::finished, this, &LessonWindow::filmEnded);
    connect(&film_, &Film::failed, this, [this](const QString& sentence) {
        closing_ = false; // the sentence is to be read
        filmEnded(sentence);
    });
    connect(steps_, &LessonSteps::stepChanged, note_, &QLabel::clear);
    looks_.start(look_ms);
    pictures_.setTimerType(Qt::PreciseTimer);
    pictures_.setInterval(1000 / Film::pictures_per_second);
}

/// Whether what lies on the table may go; the user is asked where something would be lost.
bool LessonWindow::mayClear(const QString& title, const QString& button)
{
    int drops = 0;
    for (int k = 0; table_ && k < table_->cloths(); ++k) {
        if (const auto view = table_->view(k)) { drops += view->score.drops; }
    }
    if (drops == 0 && !film_.runs()) { return true; }
    const QString consequence =
        drops == 0 ? tr("A film is being taken; it goes on with the new cloths.")
        : film_.runs()
            ? tr("What the drops have come to is lost, unless a recording is saved before. The film goes on with the new cloths.")
            : tr("What the drops have come to is lost, unless a recording is saved before.");
    return confirm(this, title, tr("Lay out new cloths?"), consequence, button);
}

void LessonWindow::chooseLesson(int index)
{
    if (!mayClear(tr("Another lesson"), tr("&Lay Out"))) {
        lessons_->setCurrentIndex(chosen_);
        return;
    }
    const bool chosen = index == own_cloths  ? chooseCloths()
                        : index == from_file ? chooseFile()
                                             : openLesson(inShownLanguage(QString(":/lessons/%1.json").arg(shipped[index])));
    if (chosen) { chosen_ = index; }
    lessons_->setCurrentIndex(chosen_);
}

bool LessonWindow::chooseCloths()
{
    ClothChoice choice(*document_.design(), this);
    if (choice.exec() != QDialog::Accepted) { return false; }
    Lesson lesson;
    lesson.title = tr("Cloths of my own").toStdString();
    lesson.cloths = choice.chosen();
    showLesson(lesson);
    return true;
}

bool LessonWindow::chooseFile()
{
    const QString path = QFileDialog::getOpenFileName(this, tr("Open Lesson"), {}, tr("Lessons (*.json)"));
    return !path.isEmpty() && openLesson(path);
}

bool LessonWindow::openLesson(const QString& path)
{
    try {
        if (path.startsWith(':')) {
            QFile file(path);
            if (!file.open(QIODevice::ReadOnly)) { throw FileError(path.toStdString() + ": this lesson is not there."); }
            showLesson(parse_lesson(file.readAll().toStdString(), path.toStdString()));
        } else {
            showLesson(read_lesson(QFile::encodeName(path).toStdString()));
        }
        return true;
    } catch (const Error& error) {
        say(QString::fromStdString(error.what()));
        Q_EMIT failed(note_->text());
        return false;
    }
}

void LessonWindow::showLesson(const Lesson& lesson)
{
    lesson_ = lesson;
    for (std::size_t k = 0; k < lesson_.cloths.size(); ++k) { lesson_.cloths[k].design = dyed(lesson_.cloths[k].design, k); }
    setWindowTitle(tr("%1 – Hygroloom").arg(QString::fromStdString(lesson_.title)));
    note_->clear();
    controls_->setLesson(lesson_);
    scene_->setDrop(controls_->dropVolume());
    steps_->setLesson(lesson_);
    pause_->setChecked(false);
    layOut();
}

void LessonWindow::layOut()
{
    scene_->setTable(nullptr, {});
    table_.reset();
    table_ = std::make_unique<LessonTable>(lesson_.cloths, lesson_.air);
    scene_->setTable(table_.get(), lesson_.cloths);
    setSpeed();
    look();
}

void LessonWindow::reset()
{
    note_->clear();
    controls_->setLesson(lesson_);
    scene_->setDrop(controls_->dropVolume());
    layOut();
    steps_->restart(0);
}

void LessonWindow::setPaused(bool paused) { pause_->setChecked(paused); }

void LessonWindow::setSpeed()
{
    if (table_) { table_->set_speed(pause_->isChecked() ? 0 : slow_->isChecked() ? LessonTable::slow_motion : 1); }
}

void LessonWindow::look()
{
    if (!table_) { return; }
    const double clock = table_->clock();
    clock_->setText(tr("%1 s").arg(QLocale().toString(clock, 'f', 1)));
    const double speed = slow_->isChecked() ? LessonTable::slow_motion : 1, pace = table_->pace();
    TableState state;
    state.air = controls_->air();
    state.tilt_deg = controls_->tilt();
    bool all = true;
    for (int k = 0; k < table_->cloths(); ++k) {
        const auto view = table_->view(k);
        all = all && (view || !table_->failure(k).empty());
        state.cloths.push_back(view ? view->score : ClothScore{});
    }
    pace_->setText(!all                  ? tr("The cloths are being laid out.")
                   : pause_->isChecked() ? tr("Paused")
                   : pace < 0.9 * speed  ? tr("This machine follows at %1 of real time.").arg(QLocale().toString(pace, 'f', 2))
                   : slow_->isChecked()  ? tr("Ten times slower than real")
                                         : tr("Real time"));
    if (all) { steps_->look(state, clock); }
}

QString LessonWindow::clockText() const { return clock_->text(); }

void LessonWindow::say(const QString& sentence) { note_->setText(sentence); }

void LessonWindow::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape) {
        close();
    } else if (event->key() >= Qt::Key_1 && event->key() <= Qt::Key_4) { // wherever the focus is
        scene_->setFocus();
        scene_->chooseCloth(event->key() - Qt::Key_1);
    } else {
        QWidget::keyPressEvent(event);
    }
}

/// The clock is read from the last row of a class, as the words under the cloths are.
void LessonWindow::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    QFont large = font();
    constexpr double least = 1.8; // times the window's text
    large.setPixelSize(std::max(qRound(least * QFontInfo(font()).pixelSize()), scene_->textSize()));
    clock_->setFont(large);
}

/// Also where the desktop changes it.
void LessonWindow::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::WindowStateChange) { screen_->setChecked(isFullScreen()); }
    QWidget::changeEvent(event);
}

} // namespace hygroloom
