// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What to begin with: recent projects, examples and fabrics of the library as pictures, a new project, the guide.
#pragma once

#include "ui/basics/newest_job.h"

#include <QDialog>
#include <QStringList>

class QListWidget;
class QListWidgetItem;
class QVBoxLayout;

namespace hygroloom {

/// Closes itself with any choice. Pictures are made in the background once it is seen; those of files are kept in the cache.
class StartPage : public QDialog {
    Q_OBJECT
public:
    /// Paths of the examples that ship with the program, and of what was opened last.
    StartPage(const QStringList& examples, const QStringList& recent, QWidget* parent = nullptr);

Q_SIGNALS:
    void newWanted();
    void openWanted();
    void guideWanted();
    void exampleChosen(const QString& path);
    void fileChosen(const QString& path);
    /// Of shipped_presets().
    void presetChosen(int preset);

protected:
    void showEvent(QShowEvent* event) override;

private:
    QListWidget* addList(QVBoxLayout& into, const QString& title, QListWidget* list);
    void addButtons(QVBoxLayout& into);
    void fill(const QStringList& examples, const QStringList& recent);
    void choose(const QListWidgetItem& item);
    void paintPictures();

    QListWidget* recent_ = nullptr;
    QListWidget* examples_ = nullptr;
    QListWidget* fabrics_ = nullptr;
    bool painted_ = false;
    NewestJob painter_; // last: its deliveries use the rest
};

} // namespace hygroloom
