// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Any command of the menus, found by a few letters of its name.
#pragma once

#include <QDialog>

class QAction;
class QLabel;
class QLineEdit;
class QMenuBar;
class QSortFilterProxyModel;
class QTreeView;

namespace hygroloom {

class CommandPalette : public QDialog {
    Q_OBJECT
public:
    explicit CommandPalette(const QMenuBar& menus, QWidget* parent = nullptr);

    /// Shows the commands that have all these words in their name or their menu's.
    void search(const QString& words);
    int shown() const;
    /// What Enter would do; nullptr when nothing is found, or it cannot be done now or any more. Not done by the palette itself.
    QAction* chosen() const;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void filter(const QString& words);

    QLineEdit* words_;
    QTreeView* list_;
    QSortFilterProxyModel* found_;
    QLabel* none_;
};

} // namespace hygroloom
