// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The user's guide: the pages of resources/help, which the program carries in itself.
#pragma once

#include <QDialog>

class QLabel;
class QLineEdit;
class QListWidget;
class QTextBrowser;
class QToolBar;

namespace hygroloom {

/// Does not block the window it explains.
class HelpWindow : public QDialog {
    Q_OBJECT
public:
    explicit HelpWindow(QWidget* parent = nullptr);

    /// page: the name of a file in resources/help without its ending, such as "design".
    void showPage(const QString& page);
    /// The same for the page that is on screen.
    QString page() const;
    QTextBrowser& browser() { return *browser_; }
    /// Pages that have the words of the search box; hidden while there are none.
    QListWidget& found() { return *found_; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void addSearch(QToolBar& bar);
    void list();
    void findNext();
    void openFound(int row);

    QTextBrowser* browser_;
    QLineEdit* words_;
    QLabel* none_;
    QListWidget* found_;
};

} // namespace hygroloom
