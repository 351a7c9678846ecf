// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/lesson/lesson_steps.h"

#include <QBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>

#include <algorithm>

namespace hygroloom {

namespace {

constexpr int least_to_read_ms = 2500, read_character_ms = 60;

QLabel* plainLabel()
{
    auto* label = new QLabel;
    label->setTextFormat(Qt::PlainText); // files of strangers
    label->setWordWrap(true);
    return label;
}

} // namespace

LessonSteps::LessonSteps(QWidget* parent)
    : QWidget(parent), count_(plainLabel()), text_(plainLabel()), ask_(plainLabel()), mark_(plainLabel()),
      back_(new QPushButton(tr("Back"))), next_(new QPushButton(tr("Next")))
{
    QFont bold = font();
    bold.setBold(true);
    ask_->setFont(bold);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(back_);
    buttons->addWidget(next_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(count_);
    layout->addLayout(buttons); // over the texts, which are of any length: they stay where they are
    for (QLabel* label : {text_, ask_, mark_}) { layout->addWidget(label); }
    pause_.setSingleShot(true);
    connect(&pause_, &QTimer::timeout, this, &LessonSteps::goOn);
    connect(next_, &QPushButton::clicked, this, &LessonSteps::next);
    connect(back_, &QPushButton::clicked, this, &LessonSteps::back);
    for (QPushButton* button : {back_, next_}) {
        button->setAutoDefault(true); // Enter presses it, too
        button->installEventFilter(this);
    }
}

/// Space pauses the table, but not while a button has the focus.
bool LessonSteps::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space) {
        event->accept();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

void LessonSteps::setLesson(const Lesson& lesson)
{
    steps_ = lesson.steps;
    held_ = false;
    setVisible(!steps_.empty());
    show(0);
}

void LessonSteps::restart(double clock)
{
    pause_.stop();
    begun_ = clock;
    seen_ = false;
    mark_->clear();
}

void LessonSteps::show(int step)
{
    pause_.stop();
    step_ = step;
    begun_ = -1;
    seen_ = false;
    mark_->clear();
    if (steps_.empty()) { return; }
    const LessonStep& now = steps_[static_cast<std::size_t>(step)];
    count_->setText(tr("Step %1 of %2").arg(step + 1).arg(steps_.size()));
    text_->setText(QString::fromStdString(now.text));
    ask_->setText(QString::fromStdString(now.ask));
    ask_->setVisible(!now.ask.empty());
    back_->setEnabled(step > 0);
    next_->setEnabled(step + 1 < static_cast<int>(steps_.size()));
    Q_EMIT stepChanged();
}

void LessonSteps::look(TableState state, double clock)
{
    if (steps_.empty() || seen_) { return; }
    if (begun_ < 0) { begun_ = clock; }
    state.since_step_s = clock - begun_;
    const LessonStep& now = steps_[static_cast<std::size_t>(step_)];
    if (!now.seen || state.cloths.empty() || !is_seen(*now.seen, state)) { return; }
    seen_ = true;
    mark_->setText(tr("Seen."));
    if (!held_ && step_ + 1 < static_cast<int>(steps_.size())) {
        pause_.start(std::max(least_to_read_ms, read_character_ms * static_cast<int>(text_->text().size())));
    }
}

int LessonSteps::msToNext() const { return pause_.isActive() ? pause_.interval() : 0; }

void LessonSteps::goOn()
{
    if (step_ + 1 < static_cast<int>(steps_.size())) { show(step_ + 1); }
}

void LessonSteps::next()
{
    held_ = false;
    goOn();
}

void LessonSteps::back()
{
    held_ = true;
    if (step_ > 0) { show(step_ - 1); }
}

} // namespace hygroloom
