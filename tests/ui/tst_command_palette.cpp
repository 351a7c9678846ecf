// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Commands found by their letters. Needs a display: xvfb-run.
#include "ui/window/command_palette.h"
#include "window_test.h"

#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QSet>
#include <QTreeView>

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

    void noTwoCommandsReadTheSame()
    {
        // Two projects of one name, and one of that name with a sign that menus take for the mark of a key.
        QStringList opened;
        for (const char* name : {"a/summer/cloth.hygro", "b/summer/cloth.hygro", "c/winter/cloth.hygro", "c/winter/cl&oth.hygro"}) {
            const QString path = folder_.filePath(name);
            QVERIFY(QDir().mkpath(QFileInfo(path).absolutePath()) && QFile::copy(example("one-drop-on-cotton"), path));
            QVERIFY(window_->openFile(path));
            opened << path;
        }
        CommandPalette palette(*window_->menuBar());
        palette.show();
        auto* list = palette.findChild<QTreeView*>();
        QSet<QString> names, seen;
        for (int row = 0; row < palette.shown(); ++row) {
            const QModelIndex index = list->model()->index(row, 0);
            const QString name = index.data().toString();
            QVERIFY2(!names.contains(name), qPrintable(name));
            names.insert(name);
            // As much of it as there is room for.
            const int margins = 2 * (list->style()->pixelMetric(QStyle::PM_FocusFrameHMargin) + 1);
            const QString shown = list->fontMetrics().elidedText(name, list->textElideMode(), list->visualRect(index).width() - margins);
            QVERIFY2(!seen.contains(shown), qPrintable(shown));
            seen.insert(shown);
        }
        QVERIFY(names.contains("File ▸ Open Recent ▸ cloth.hygro in a/summer"));
        QVERIFY(names.contains("File ▸ Open Recent ▸ cloth.hygro in winter"));
        QVERIFY(names.contains("File ▸ Open Recent ▸ cl&oth.hygro"));
        palette.search("a/summer");
        QCOMPARE(palette.shown(), 1);
        QCOMPARE(palette.chosen()->statusTip(), opened.first());
    }

    void commandsOfOneNameSayWhatTheyDo()
    {
        QMenuBar bar;
        QMenu* menu = bar.addMenu("Run");
        menu->addAction("Start")->setStatusTip("Start the sample.");
        menu->addAction("Start")->setStatusTip("Start the garment.");
        for (int i = 0; i < 2; ++i) { menu->addAction("Stop"); }
        const CommandPalette palette(bar);
        const QAbstractItemModel* model = palette.findChild<QTreeView*>()->model();
        QStringList names;
        for (int row = 0; row < model->rowCount(); ++row) { names << model->index(row, 0).data().toString(); }
        QCOMPARE(names,
                 (QStringList{"Run ▸ Start: Start the sample.", "Run ▸ Start: Start the garment.", "Run ▸ Stop (1)", "Run ▸ Stop (2)"}));
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
                QTest::keyClicks(palette->findChild<QLineEdit*>(), "view sample");
                QTest::keyClick(palette->findChild<QLineEdit*>(), Qt::Key_Return);
            }
        });
        trigger("Find Command");
        QCOMPARE(window_->workspace(), Workspace::simulate);
    }
};

QTEST_MAIN(TestCommandPalette)
#include "tst_command_palette.moc"
