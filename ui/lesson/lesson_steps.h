// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a lesson says and asks, step by step: the next one comes when what was asked for has been seen, or when the class wants it.
#pragma once

#include "core/lesson/lesson.h"

#include <QTimer>
#include <QWidget>

class QLabel;
class QPushButton;

namespace hygroloom {

class LessonSteps : public QWidget {
    Q_OBJECT
public:
    explicit LessonSteps(QWidget* parent = nullptr);

    /// Begins at the first step. Without steps the widget hides.
    void setLesson(const Lesson& lesson);
    /// Time counts from here on; clock in s of simulated time.
    void restart(double clock);
    /// What there is to see now; since_step_s follows from the clock.
    void look(TableState state, double clock);
    int step() const { return step_; }
    bool seen() const { return seen_; }
    /// From seen to the next step; 0: it does not come by itself.
    int msToNext() const;
    void next();
    /// From here on no step comes by itself, until next().
    void back();

Q_SIGNALS:
    void stepChanged();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void show(int step);
    void goOn();

    std::vector<LessonStep> steps_;
    int step_ = 0;
    double begun_ = -1; // s of the clock; less than 0: with the next look
    bool seen_ = false;
    bool held_ = false; // since the class went back
    QTimer pause_;      // from seen to the next step
    QLabel *count_, *text_, *ask_, *mark_;
    QPushButton *back_, *next_;
};

} // namespace hygroloom
