// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The lesson: a table with cloths that fills the screen, what is said about it, and what a hand can do.
#pragma once

#include "core/lesson/lesson_table.h"
#include "ui/basics/film.h"

#include <QTimer>
#include <QWidget>

class QCloseEvent;
class QComboBox;
class QLabel;
class QMenu;
class QToolButton;

namespace hygroloom {

class Document;
class LessonControls;
class LessonScene;
class LessonSteps;

/// Esc closes it, as soon as a film that runs is written.
class LessonWindow : public QWidget {
    Q_OBJECT
public:
    /// Begins with the first lesson that ships.
    explicit LessonWindow(const Document& document, QWidget* parent = nullptr);
    ~LessonWindow() override;

    LessonScene& scene() { return *scene_; }
    LessonSteps& steps() { return *steps_; }
    LessonControls& controls() { return *controls_; }
    LessonTable* table() { return table_.get(); }
    const Lesson& lesson() const { return lesson_; }
    /// False after failed() gave the reason.
    bool openLesson(const QString& path);
    void showLesson(const Lesson& lesson);
    void setPaused(bool paused);
    /// Without asking.
    void reset();
    QString clockText() const;
    /// A film is being taken or written.
    bool filming() const { return film_.busy(); }
    /// Ends it. It is waited for, in a dialog, where it is kept.
    void leaveFilm(bool keep);

Q_SIGNALS:
    void failed(const QString& sentence);
    /// The user wants to read about it.
    void helpWanted();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

private:
    void build();
    QWidget* buildSide();
    QToolButton* addButton(const QString& text, const QKeySequence& key, bool checkable);
    void connectParts();
    bool mayClear(const QString& title, const QString& button);
    void chooseLesson(int index);
    bool chooseCloths();
    bool chooseFile();
    void layOut();
    void setSpeed();
    void look();
    void fillSaveMenu();
    QString askForFile(const QString& title, const QString& name, const QString& kind, const QString& ending);
    void saveRecording(int cloth);
    void recordingEnded(const QString& sentence, bool failed);
    void saveFilm(bool movie);
    void endFilm();
    void filmEnded(const QString& sentence);
    void say(const QString& sentence);

    const Document& document_;
    Lesson lesson_;
    int chosen_ = 0; ///< place in the list of lessons
    LessonScene* scene_;
    LessonSteps* steps_;
    LessonControls* controls_;
    QComboBox* lessons_;
    QLabel *clock_, *pace_, *note_;
    QToolButton *pause_, *slow_, *reset_, *explain_, *squeeze_, *screen_, *save_, *help_, *leave_;
    QMenu* save_menu_;
    QTimer looks_, pictures_;
    Film film_{"lesson"};
    bool closing_ = false; ///< as soon as the film is written
    QString not_saved_;    ///< why the last recording was not
    std::unique_ptr<LessonTable> table_;
};

} // namespace hygroloom
