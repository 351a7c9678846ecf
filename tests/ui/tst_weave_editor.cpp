// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The weave editor's tools and actions, with mouse and keys.
#include "core/project/project_file.h"
#include "ui/basics/appearance.h"
#include "ui/document/document.h"
#include "ui/weave/point_paper.h"
#include "ui/weave/weave_editor.h"
#include "ui/weave/weave_notes.h"
#include "ui/window/examples.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>

using namespace hygroloom;

class TestWeaveEditor : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        document_ = std::make_unique<Document>();
        QVERIFY(document_->openExample(shippedExample()));
        document_->edit("weave", {}, [](Design& d) { d.fabrics[0].weave = Weave(4, 4, std::vector<std::uint8_t>(16, 0)); });
        document_->history()->clear();
        editor_ = std::make_unique<WeaveEditor>(*document_);
        editor_->resize(300, 640);
        editor_->show();
    }
    void cleanup()
    {
        editor_.reset();
        document_.reset();
    }

    void aToolDrawsWhatItIsNamedFor_data()
    {
        QTest::addColumn<QString>("tool");
        QTest::addColumn<QString>("grid");
        QTest::newRow("brush") << "brush"
                               << "0000\n0100\n1000\n0000\n"; // from the first to the last crossing of the drag
        QTest::newRow("line") << "line"
                              << "0000\n0010\n0100\n1000\n";
        QTest::newRow("rectangle") << "rectangle"
                                   << "0000\n1110\n1110\n1110\n";
        QTest::newRow("fill") << "fill"
                              << "1111\n1111\n1111\n1111\n";
        QTest::newRow("select") << "select"
                                << "0000\n0000\n0000\n0000\n";
    }
    void aToolDrawsWhatItIsNamedFor()
    {
        QFETCH(QString, tool);
        QFETCH(QString, grid);
        editor_->action(tool)->trigger();
        if (tool == "brush") {
            drag({0, 1}, {1, 2});
        } else {
            drag({0, 0}, {2, 2});
        }
        QCOMPARE(gridText(weave()), grid);
        if (tool == "select") {
            QCOMPARE(editor_->paper()->selection(), QRect(0, 0, 3, 3));
            return;
        }
        QCOMPARE(document_->history()->count(), 1);
        document_->history()->undo();
        QCOMPARE(gridText(weave()), QString("0000\n0000\n0000\n0000\n"));
    }

    void anActionChangesTheWeaveInOneStep_data()
    {
        QTest::addColumn<QString>("grid");
        QTest::newRow("mirror-ends") << "010\n011\n";
        QTest::newRow("mirror-picks") << "110\n010\n";
        QTest::newRow("invert") << "101\n001\n";
        QTest::newRow("rotate") << "10\n11\n00\n";
        QTest::newRow("shift-left") << "100\n101\n";
        QTest::newRow("shift-right") << "001\n011\n";
        QTest::newRow("shift-up") << "110\n010\n";
        QTest::newRow("shift-down") << "110\n010\n";
        QTest::newRow("clear") << "000\n000\n";
        QTest::newRow("insert-end") << "0010\n1110\n";
        QTest::newRow("insert-pick") << "010\n110\n110\n";
        QTest::newRow("delete-end") << "10\n10\n";
        QTest::newRow("delete-pick") << "010\n";
    }
    void anActionChangesTheWeaveInOneStep()
    {
        QFETCH(QString, grid);
        setGrid("010\n110\n");
        editor_->action(QTest::currentDataTag())->trigger();
        QCOMPARE(gridText(weave()), grid);
        QCOMPARE(document_->history()->count(), 1);
        QVERIFY(!document_->history()->undoText().isEmpty());
        document_->history()->undo();
        QCOMPARE(gridText(weave()), QString("010\n110\n"));
    }

    void actionsKeepToTheSelection()
    {
        setGrid("1000\n0000\n0000\n0010\n");
        editor_->paper()->setSelection({0, 2, 2, 2});
        editor_->action("invert")->trigger();
        QCOMPARE(gridText(weave()), QString("0100\n1100\n0000\n0010\n"));
    }

    void whatIsCutCanBePasted()
    {
        setGrid("0000\n0000\n1000\n1100\n");
        editor_->paper()->setSelection({0, 0, 2, 2});
        editor_->action("cut")->trigger();
        QCOMPARE(QApplication::clipboard()->text(), QString("10\n11\n"));
        QCOMPARE(gridText(weave()), QString("0000\n0000\n0000\n0000\n"));
        editor_->paper()->setSelection({2, 2, 1, 1});
        editor_->action("paste")->trigger();
        QCOMPARE(gridText(weave()), QString("0010\n0011\n0000\n0000\n"));
        QCOMPARE(document_->history()->count(), 2);
    }

    void whatIsNoGridIsNotPasted()
    {
        for (const char* text : {"", "hello", "101\n10\n", "00000\n00000\n"}) {
            QApplication::clipboard()->setText(text);
            editor_->action("paste")->trigger();
            QCOMPARE(document_->history()->count(), 0);
        }
    }

    void keysDrawAndSelect()
    {
        PointPaper* paper = editor_->paper();
        editor_->action("line")->trigger();
        QTest::keyClick(paper, Qt::Key_Space);
        for (int i = 0; i < 2; ++i) {
            QTest::keyClick(paper, Qt::Key_Right);
            QTest::keyClick(paper, Qt::Key_Up);
        }
        QTest::keyClick(paper, Qt::Key_Space);
        QCOMPARE(gridText(weave()), QString("0000\n0010\n0100\n1000\n"));
        QTest::keyClick(paper, Qt::Key_Left, Qt::ShiftModifier);
        QCOMPARE(paper->selection(), QRect(1, 2, 2, 1));
        QTest::keyClick(paper, Qt::Key_Escape);
        QVERIFY(paper->selection().isEmpty());
    }

    void everyToolHasANameAKeyAndAnIcon()
    {
        QStringList keys;
        for (QAction* action : editor_->paper()->actions()) {
            QVERIFY2(!action->text().isEmpty() && !action->shortcut().isEmpty() && !action->icon().isNull(),
                     qPrintable(action->objectName()));
            QVERIFY(!keys.contains(action->shortcut().toString()));
            keys << action->shortcut().toString();
        }
        QCOMPARE(keys.size(), 24);
    }

    void aLargeRepeatScrollsAndZooms()
    {
        document_->edit("weave", {}, [](Design& d) { d.fabrics[0].weave = resized(weave_from_pattern("twill 2/2 Z"), 2000, 2000); });
        PointPaper* paper = editor_->paper();
        QVERIFY(paper->squareOf(0, 0).bottom() <= paper->viewport()->height()); // the first pick is seen at first
        const double before = paper->squareOf(0, 0).width();
        editor_->action("zoom-in")->trigger();
        QVERIFY(paper->squareOf(0, 0).width() > before);
        editor_->action("fit")->trigger();
        QCOMPARE(paper->squareOf(0, 0).width(), before);
        QVERIFY(!paper->grab().isNull());
    }

    void theNotesDescribeTheWeave()
    {
        Document empty;
        WeaveEditor later(empty);
        QVERIFY(later.notes()->text().contains("Add a fabric"));
        QVERIFY(empty.openExample(shippedExample()));
        QVERIFY2(later.notes()->text().contains("100 % of the crossings interlace"), qPrintable(later.notes()->text()));
        document_->edit("weave", {}, [](Design& d) { d.fabrics[0].weave = weave_from_pattern("satin 5/2"); });
        QString text = editor_->notes()->text();
        QVERIFY2(text.contains("Longest floats: warp 4, weft 4."), qPrintable(text));
        QVERIFY2(text.contains("40 % of the crossings interlace"), qPrintable(text));
        QVERIFY2(text.contains("Setts: ") && text.contains("% of their limit"), qPrintable(text));
        setGrid("101\n100\n");
        text = editor_->notes()->text();
        QVERIFY2(text.contains("Ends that never interlace: 1, 2."), qPrintable(text));
        QVERIFY2(text.contains("Longest floats: warp endless, weft "), qPrintable(text));
    }

    /// A repeat this large takes tens of milliseconds to check and to draw anew: that waits until the stroke ends, and what is painted
    /// shows.
    void paintingALargeRepeatWaitsForTheStrokesEnd()
    {
        std::vector<std::uint8_t> up(std::size_t(largest_repeat) * largest_repeat);
        for (std::size_t i = 0; i < up.size(); ++i) { up[i] = (i % largest_repeat + i / largest_repeat) % 4 == 0 ? 1 : 0; }
        document_->edit("weave", {}, [&](Design& d) { d.fabrics[0].weave = Weave(largest_repeat, largest_repeat, up); });
        document_->history()->clear();
        PointPaper* paper = editor_->paper();
        const QSignalSpy painted(paper, &PointPaper::painted), changed(document_.get(), &Document::designChanged);
        const auto square = [&](int end) { return paper->squareOf(end, 1).center(); };
        const auto mouse = [&](QEvent::Type type, int end) {
            QMouseEvent event(type, square(end), paper->viewport()->mapToGlobal(square(end)), Qt::LeftButton, Qt::LeftButton,
                              Qt::NoModifier);
            QApplication::sendEvent(paper->viewport(), &event);
        };
        const QImage before = paper->viewport()->grab().toImage();
        mouse(QEvent::MouseButtonPress, 0);
        for (int end = 1; end <= 20; ++end) { mouse(QEvent::MouseMove, end); }
        const QImage during = paper->viewport()->grab().toImage();
        QCOMPARE(painted.size(), 0);
        QCOMPARE(changed.size(), 0);
        QVERIFY(document_->fabric()->weave.crossings() == up);
        for (int end = 0; end <= 20; ++end) { QVERIFY(before.pixel(square(end).toPoint()) != during.pixel(square(end).toPoint())); }

        mouse(QEvent::MouseButtonRelease, 20);
        QCOMPARE(painted.size(), 1);
        QCOMPARE(document_->history()->count(), 1);
        const Weave& drawn = document_->fabric()->weave;
        const bool first = drawn.warp_up(0, 1);
        for (int end = 0; end <= 20; ++end) { QCOMPARE(drawn.warp_up(end, 1), first); }
        document_->history()->undo();
        QVERIFY(document_->fabric()->weave.crossings() == up);
    }

    void aDarkSquareIsWarpUpInEveryLook()
    {
        setGrid("0110\n0110\n1001\n1001\n");
        PointPaper* paper = editor_->paper();
        for (const Appearance look : {Appearance::dark, Appearance::contrast, Appearance::light}) {
            applyAppearance(look);
            const QImage picture = paper->viewport()->grab().toImage();
            const auto lightness = [&](int end, int pick) {
                return picture.pixelColor(paper->squareOf(end, pick).center().toPoint() + QPoint(0, 2)).lightnessF();
            };
            QVERIFY2(lightness(3, 0) < 0.3F && lightness(2, 0) > 0.7F, qPrintable(QString::number(static_cast<int>(look))));
        }
    }

private:
    const Weave& weave() const { return document_->fabric()->weave; }

    void setGrid(const char* rows)
    {
        QString why;
        const auto made = weaveFromText(rows, &why);
        QVERIFY2(made, qPrintable(why));
        document_->edit("weave", {}, [&](Design& d) { d.fabrics[0].weave = *made; });
        document_->history()->clear();
    }

    void drag(const QPoint& from, const QPoint& to)
    {
        PointPaper* paper = editor_->paper();
        const auto at = [&](const QPoint& p) { return paper->squareOf(p.x(), p.y()).center().toPoint(); };
        QTest::mousePress(paper->viewport(), Qt::LeftButton, {}, at(from));
        QTest::mouseMove(paper->viewport(), at(to));
        QTest::mouseRelease(paper->viewport(), Qt::LeftButton, {}, at(to));
    }

    std::unique_ptr<Document> document_;
    std::unique_ptr<WeaveEditor> editor_;
};

QTEST_MAIN(TestWeaveEditor)
#include "tst_weave_editor.moc"
