// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/window/help_window.h"

#include "ui/window/guide_search.h"

#include <QAction>
#include <QEvent>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QSplitter>
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

HelpWindow::HelpWindow(QWidget* parent)
    : QDialog(parent), browser_(new HelpBrowser), words_(new QLineEdit), none_(new QLabel), found_(new QListWidget)
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
    addSearch(*bar);

    browser_->setAccessibleName(tr("Page of the guide"));
    browser_->setOpenExternalLinks(true);
    browser_->setFrameShape(QFrame::NoFrame);
    browser_->document()->setDocumentMargin(20);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(bar);
    auto* parts = new QSplitter(Qt::Vertical);
    parts->addWidget(found_);
    parts->addWidget(browser_);
    parts->setStretchFactor(1, 1);
    parts->setSizes({160, 560});
    layout->addWidget(parts, 1);
    resize(860, 720);
    browser_->setFocus();
}

void HelpWindow::showPage(const QString& page)
{
    if (page != this->page()) { browser_->setSource(addressOf(page)); }
}

QString HelpWindow::page() const { return QFileInfo(browser_->source().path()).completeBaseName(); }

void HelpWindow::addSearch(QToolBar& bar)
{
    words_->setPlaceholderText(tr("Find in the guide"));
    words_->setAccessibleName(words_->placeholderText());
    words_->setToolTip(tr("Lists the pages that have this text. Enter or F3 goes to the next place."));
    words_->setClearButtonEnabled(true);
    words_->setMaximumWidth(240);
    bar.addWidget(words_);
    bar.addWidget(none_);
    found_->setAccessibleName(tr("Pages with this text"));
    found_->setAlternatingRowColors(true);
    found_->setFrameShape(QFrame::NoFrame);
    found_->hide();
    auto* to_words = new QAction(this);
    to_words->setShortcut(QKeySequence::Find);
    connect(to_words, &QAction::triggered, words_, [this] {
        words_->setFocus();
        words_->selectAll();
    });
    auto* next = new QAction(this);
    next->setShortcut(QKeySequence(Qt::Key_F3));
    connect(next, &QAction::triggered, this, &HelpWindow::findNext);
    addActions({to_words, next});
    connect(words_, &QLineEdit::returnPressed, this, &HelpWindow::findNext);
    connect(words_, &QLineEdit::textChanged, this, &HelpWindow::list);
    const auto open = [this](const QListWidgetItem* item) { openFound(found_->row(item)); };
    connect(found_, &QListWidget::itemClicked, this, open);
    connect(found_, &QListWidget::itemActivated, this, open);
}

/// Of each page that has the words: its title, how often, and the text round the first place.
void HelpWindow::list()
{
    found_->clear();
    for (const GuideHit& hit : searchGuide(words_->text())) {
        auto* item = new QListWidgetItem(tr("%1 (%2)").arg(hit.title).arg(hit.hits) + '\n' + hit.context, found_);
        item->setData(Qt::UserRole, hit.page);
        if (hit.page == page()) { found_->setCurrentItem(item); }
    }
    found_->setVisible(found_->count() > 0);
    none_->setText(found_->count() > 0 || words_->text().trimmed().isEmpty() ? QString() : tr("Not in the guide."));
}

/// The first place on a listed page.
void HelpWindow::openFound(int row)
{
    found_->setCurrentRow(row);
    showPage(found_->item(row)->data(Qt::UserRole).toString());
    browser_->moveCursor(QTextCursor::Start);
    browser_->find(words_->text());
}

/// From the cursor on, then on the pages listed below, and again from the first.
void HelpWindow::findNext()
{
    if (found_->count() == 0) { return; }
    int here = -1;
    for (int row = 0; row < found_->count(); ++row) {
        if (found_->item(row)->data(Qt::UserRole).toString() == page()) { here = row; }
    }
    if (here >= 0 && browser_->find(words_->text())) {
        found_->setCurrentRow(here);
    } else {
        openFound((here + 1) % found_->count());
    }
}

/// A page takes the colours of its links when it is read.
void HelpWindow::changeEvent(QEvent* event)
{
    QDialog::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && !browser_->source().isEmpty()) { browser_->reload(); }
}

} // namespace hygroloom
