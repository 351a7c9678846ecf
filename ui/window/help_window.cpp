// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/window/help_window.h"

#include <QAction>
#include <QEvent>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextTable>
#include <QToolBar>
#include <QVBoxLayout>

#include <algorithm>

namespace hygroloom {

namespace {

constexpr int widest_picture = 760; // pixels

/// Gives pages more room between their parts, thin lines to tables, and pictures that fit.
class HelpBrowser : public QTextBrowser {
protected:
    void doSetSource(const QUrl& name, QTextDocument::ResourceType type) override
    {
        QTextBrowser::doSetSource(name, type);
        QTextCursor cursor(document());
        cursor.beginEditBlock();
        for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
            QTextBlockFormat format = block.blockFormat();
            const bool picture = block.text().contains(QChar::ObjectReplacementCharacter); // a fifth of its height would be a gap
            if (!picture) { format.setLineHeight(120, QTextBlockFormat::ProportionalHeight); }
            if (format.headingLevel() > 0) {
                format.setTopMargin(format.headingLevel() == 1 ? 0 : 18);
                format.setBottomMargin(6);
            }
            QTextCursor(block).setBlockFormat(format);
        }
        for (QTextFrame* frame : document()->rootFrame()->childFrames()) {
            if (auto* table = qobject_cast<QTextTable*>(frame)) { table->setFormat(tidied(table->format())); }
        }
        cursor.endEditBlock();
        moveCursor(QTextCursor::Start);
    }

    QVariant loadResource(int type, const QUrl& name) override
    {
        const QVariant loaded = QTextBrowser::loadResource(type, name);
        if (type != QTextDocument::ImageResource) { return loaded; }
        QImage picture = loaded.value<QImage>();
        if (picture.isNull()) { picture.loadFromData(loaded.toByteArray()); }
        if (picture.width() <= widest_picture) { return picture; }
        // At the screen's own resolution.
        const qreal ratio = devicePixelRatioF();
        picture = picture.scaledToWidth(std::min(picture.width(), qRound(widest_picture * ratio)), Qt::SmoothTransformation);
        picture.setDevicePixelRatio(picture.width() / static_cast<qreal>(widest_picture));
        return picture;
    }

private:
    QTextTableFormat tidied(QTextTableFormat format) const
    {
        format.setBorderCollapse(true);
        format.setBorder(1);
        format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
        format.setBorderBrush(palette().mid());
        format.setCellSpacing(0);
        format.setCellPadding(5);
        format.setTopMargin(4);
        format.setBottomMargin(8);
        return format;
    }
};

QUrl addressOf(const QString& page) { return QUrl("qrc:/help/" + page + ".md"); }

} // namespace

HelpWindow::HelpWindow(QWidget* parent) : QDialog(parent), browser_(new HelpBrowser), words_(new QLineEdit), none_(new QLabel)
{
    setWindowTitle(tr("Hygroloom User's Guide"));
    auto* bar = new QToolBar;
    const auto add = [&](const QString& text, const QKeySequence& key, auto work) {
        QAction* action = bar->addAction(text);
        action->setShortcut(key);
        action->setToolTip(tr("%1 (%2)").arg(text, key.toString(QKeySequence::NativeText)));
        connect(action, &QAction::triggered, browser_, work);
        return action;
    };
    QAction* back = add(tr("Back"), QKeySequence("Alt+Left"), &QTextBrowser::backward);
    QAction* forward = add(tr("Forward"), QKeySequence("Alt+Right"), &QTextBrowser::forward);
    add(tr("Contents"), QKeySequence("Alt+Home"), [this] { showPage("index"); });
    back->setEnabled(false);
    forward->setEnabled(false);
    connect(browser_, &QTextBrowser::backwardAvailable, back, &QAction::setEnabled);
    connect(browser_, &QTextBrowser::forwardAvailable, forward, &QAction::setEnabled);
    bar->addSeparator();
    words_->setPlaceholderText(tr("Find on this page"));
    words_->setAccessibleName(words_->placeholderText());
    words_->setClearButtonEnabled(true);
    words_->setMaximumWidth(240);
    bar->addWidget(words_);
    bar->addWidget(none_);
    auto* find_key = new QAction(this);
    find_key->setShortcut(QKeySequence::Find);
    connect(find_key, &QAction::triggered, words_, [this] {
        words_->setFocus();
        words_->selectAll();
    });
    addAction(find_key);
    connect(words_, &QLineEdit::returnPressed, this, &HelpWindow::find);
    connect(words_, &QLineEdit::textEdited, none_, &QLabel::clear);

    browser_->setAccessibleName(tr("Page of the guide"));
    browser_->setOpenExternalLinks(true);
    browser_->setFrameShape(QFrame::NoFrame);
    browser_->document()->setDocumentMargin(20);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(bar);
    layout->addWidget(browser_, 1);
    resize(860, 720);
    browser_->setFocus();
}

void HelpWindow::showPage(const QString& page)
{
    if (page != this->page()) { browser_->setSource(addressOf(page)); }
}

QString HelpWindow::page() const { return QFileInfo(browser_->source().path()).completeBaseName(); }

/// From the cursor on, and once more from the top.
void HelpWindow::find()
{
    bool found = browser_->find(words_->text());
    if (!found) {
        const QTextCursor before = browser_->textCursor();
        browser_->moveCursor(QTextCursor::Start);
        found = browser_->find(words_->text());
        if (!found) { browser_->setTextCursor(before); }
    }
    none_->setText(found || words_->text().isEmpty() ? QString() : tr("Not on this page."));
}

/// A page takes the colours of its links when it is read.
void HelpWindow::changeEvent(QEvent* event)
{
    QDialog::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && !browser_->source().isEmpty()) { browser_->reload(); }
}

} // namespace hygroloom
