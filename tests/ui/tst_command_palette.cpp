// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Commands found by their letters. Needs a display: xvfb-run.
#include "ui/window/command_palette.h"
#include "window_test.h"

#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>

#include <algorithm>

using namespace hygroloom;

class TestCommandPalette : public WindowTest {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        useOwnSettings();
        openWindow();
    }

    void cleanupTestCase() { window_.reset(); }

    void anyCommandIsFoundByAFewLetters()
    {
        CommandPalette palette(*window_->menuBar());
        QVERIFY(palette.shown() > 40);
        palette.search("mesh exp");
        QCOMPARE(palette.shown(), 1);
        QCOMPARE(palette.chosen()->text(), QString("Export &Mesh…"));
        palette.search("stop"); // nothing runs
        QVERIFY(palette.shown() >= 1);
        QVERIFY(!palette.chosen());
        palette.search("no command has this name");
        QCOMPARE(palette.shown(), 0);
        const auto labels = palette.findChildren<QLabel*>();
        QVERIFY(std::any_of(labels.begin(), labels.end(),
                            [&](const QLabel* label) { return label->isVisibleTo(&palette) && label->text() == "No command matches."; }));
        QVERIFY(!palette.chosen());
    }

    void theFieldOfCommandsIsTypedIntoAnywhereAndUndone()
    {
        CommandPalette palette(*window_->menuBar());
        palette.show();
        auto* words = palette.findChild<QLineEdit*>();
        QTest::keyClicks(words, "mesh xp");
        words->setCursorPosition(5);
        QTest::keyClicks(words, "ex");
        QCOMPARE(words->text(), QString("mesh exxp"));
        QCOMPARE(words->cursorPosition(), 7);
        QCOMPARE(palette.shown(), 0);
        QVERIFY(words->isUndoAvailable());
        words->undo();
        QCOMPARE(words->text(), QString("mesh xp"));
    }

    void aCommandThatIsGoneIsNotDone()
    {
        QMenuBar bar;
        QMenu* menu = bar.addMenu("File");
        QAction* recent = menu->addAction("cloth.hygro");
        CommandPalette palette(bar);
        palette.search("cloth");
        QCOMPARE(palette.chosen(), recent);
        delete recent;
        QCOMPARE(palette.shown(), 1);
        QVERIFY(!palette.chosen());
    }

    void ctrlKDoesWhatIsChosen()
    {
        window_->setWorkspace(Workspace::design);
        QTimer::singleShot(200, this, [] {
            if (auto* palette = qobject_cast<CommandPalette*>(QApplication::activeModalWidget())) {
                QTest::keyClicks(palette->findChild<QLineEdit*>(), "view simulate");
                QTest::keyClick(palette->findChild<QLineEdit*>(), Qt::Key_Return);
            }
        });
        trigger("Find Command");
        QCOMPARE(window_->workspace(), Workspace::simulate);
    }
};

QTEST_MAIN(TestCommandPalette)
#include "tst_command_palette.moc"
