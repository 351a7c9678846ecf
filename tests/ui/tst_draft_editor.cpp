// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The draft editor: what is changed in the draft shows in the cloth, and the other way round; the order of the yarns.
#include "core/design/drawdown.h"
#include "core/project/project_file.h"
#include "ui/document/document.h"
#include "ui/weave/cloth_picture.h"
#include "ui/weave/draft_editor.h"
#include "ui/weave/order_editor.h"
#include "ui/weave/weave_edits.h"
#include "ui/window/examples.h"

#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>

using namespace hygroloom;

class TestDraftEditor : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        document_ = std::make_unique<Document>();
        QVERIFY(document_->openExample(shippedExample()));
        document_->edit("weave", {}, [](Design& d) { d.fabrics[0].weave = weave_from_pattern("twill 2/2 Z"); });
        document_->history()->clear();
        editor_ = std::make_unique<DraftEditor>(*document_);
        editor_->resize(900, 500);
        editor_->show();
    }
    void cleanup()
    {
        editor_.reset();
        document_.reset();
    }

    void aWeaveWithoutADraftShowsItsSmallest()
    {
        QCOMPARE(editor_->draft().shafts, 4);
        QCOMPARE(editor_->draft().treadles, 4);
        QVERIFY(!document_->fabric()->weave.draft());
        QCOMPARE(document_->history()->count(), 0);
        editor_->findDraft();
        QVERIFY(document_->fabric()->weave.draft());
        QVERIFY(document_->fabric()->weave.same_matrix(weave_from_pattern("twill 2/2 Z")));
    }

    void everyPartOfTheDraftChangesTheCloth_data()
    {
        QTest::addColumn<int>("part");
        QTest::addColumn<QPoint>("cell");
        QTest::newRow("threading") << static_cast<int>(DraftPart::threading) << QPoint(0, 2);
        QTest::newRow("tie-up") << static_cast<int>(DraftPart::tieUp) << QPoint(0, 2);
        QTest::newRow("treadling") << static_cast<int>(DraftPart::treadling) << QPoint(2, 0);
        QTest::newRow("drawdown") << static_cast<int>(DraftPart::drawdown) << QPoint(2, 0);
    }
    void everyPartOfTheDraftChangesTheCloth()
    {
        QFETCH(int, part);
        QFETCH(QPoint, cell);
        const auto where = static_cast<DraftPart>(part);
        const Weave before = document_->fabric()->weave;
        const bool was = editor_->paper()->filled(where, cell);
        click(where, cell);
        QCOMPARE(editor_->paper()->filled(where, cell), !was);
        const Weave after = document_->fabric()->weave;
        QVERIFY(!after.same_matrix(before));
        QVERIFY(drawdown(editor_->draft()).same_matrix(after));
        QCOMPARE(document_->history()->count(), 1);
        document_->history()->undo();
        QVERIFY(document_->fabric()->weave == before);
    }

    void aDragIsOneStep()
    {
        const QPoint from = middle(DraftPart::threading, {0, 0}), to = middle(DraftPart::threading, {3, 0});
        QWidget* at = editor_->paper()->viewport();
        click(DraftPart::threading, {3, 0}); // empties the corner, so that the drag fills it
        document_->history()->clear();
        click(DraftPart::threading, {3, 3});
        QTest::mousePress(at, Qt::LeftButton, {}, middle(DraftPart::threading, {1, 0}));
        QTest::mouseMove(at, to);
        QTest::mouseRelease(at, Qt::LeftButton, {}, to);
        QCOMPARE(document_->history()->count(), 2);
        QCOMPARE(document_->history()->undoText(), QString("threading"));
        for (int end = 1; end < 4; ++end) { QCOMPARE(editor_->draft().threading[static_cast<std::size_t>(end)], std::vector<int>{0}); }
        Q_UNUSED(from)
    }

    void aLiftplanWeavesTheSameCloth()
    {
        auto* plan = named<QComboBox>("Treadling or liftplan");
        plan->setCurrentIndex(1);
        Q_EMIT plan->activated(1);
        QVERIFY(!editor_->draft().liftplan.empty());
        QVERIFY(document_->fabric()->weave.same_matrix(weave_from_pattern("twill 2/2 Z")));
        click(DraftPart::treadling, {2, 0});
        QVERIFY(document_->fabric()->weave.warp_up(2, 0) != weave_from_pattern("twill 2/2 Z").warp_up(2, 0));
    }

    void aSinkingShedTurnsTheClothOver()
    {
        auto* shed = named<QComboBox>("Shed");
        shed->setCurrentIndex(1);
        Q_EMIT shed->activated(1);
        QVERIFY(document_->fabric()->weave.same_matrix(inverted(weave_from_pattern("twill 2/2 Z"))));
    }

    void shaftsAndTreadlesCanBeAddedAndTakenAway()
    {
        named<QSpinBox>("Shafts")->setValue(6);
        QCOMPARE(editor_->draft().shafts, 6);
        named<QSpinBox>("Treadles")->setValue(5);
        QCOMPARE(editor_->draft().treadles, 5);
        QVERIFY(document_->fabric()->weave.same_matrix(weave_from_pattern("twill 2/2 Z")));
        named<QSpinBox>("Shafts")->setValue(3);
        QVERIFY(editor_->draft().threading[3].empty());
        document_->history()->undo();
        QCOMPARE(editor_->draft().shafts, 6);
    }

    void keysReachEveryPart()
    {
        DraftPaper* paper = editor_->paper();
        QTest::keyClick(paper, Qt::Key_Left);
        for (int i = 0; i < 4; ++i) { QTest::keyClick(paper, Qt::Key_Up); }
        QCOMPARE(paper->cursorPart(), DraftPart::threading);
        for (int i = 0; i < 4; ++i) { QTest::keyClick(paper, Qt::Key_Right); }
        QCOMPARE(paper->cursorPart(), DraftPart::tieUp);
        QTest::keyClick(paper, Qt::Key_Down);
        QCOMPARE(paper->cursorPart(), DraftPart::treadling);
        const std::string before = format_project(*document_->design());
        QTest::keyClick(paper, Qt::Key_Space);
        QVERIFY(format_project(*document_->design()) != before);
    }

    void draggingAYarnOverTheBarOrdersTheEnds()
    {
        OrderEditor* order = editor_->order();
        order->addYarn();
        QCOMPARE(order->chosenYarn(), 1);
        QWidget* at = editor_->paper()->viewport();
        QTest::mousePress(at, Qt::LeftButton, {}, middle(DraftPart::warpBar, {1, 0}));
        QTest::mouseMove(at, middle(DraftPart::warpBar, {2, 0}));
        QTest::mouseRelease(at, Qt::LeftButton, {}, middle(DraftPart::warpBar, {2, 0}));
        const std::vector<YarnRun> expected{{0, 1}, {1, 2}, {0, 1}};
        QCOMPARE(document_->fabric()->warp_order, expected);
        QCOMPARE(document_->history()->count(), 2);
        order->setColor(Qt::red);
        QCOMPARE(clothPicture(*document_->fabric(), 4, 4).pixelColor(1, 3 - 0),
                 QColor(weave().warp_up(1, 0) ? QColor(Qt::red) : yarnColor(document_->fabric()->weft, false)));
        order->chooseYarn(1);
        order->removeYarn();
        QVERIFY(document_->fabric()->extra_yarns.empty());
        QVERIFY(document_->fabric()->warp_order.empty());
        while (document_->history()->canUndo()) { document_->history()->undo(); }
        QVERIFY(document_->fabric()->extra_yarns.empty());
    }

    void aDoubleClickOnAYarnOpensItsFields()
    {
        OrderEditor* order = editor_->order();
        order->addYarn();
        QSignalSpy asked(order, &OrderEditor::yarnActivated);
        auto* list = order->findChild<QListWidget*>();
        const QPoint at = list->visualItemRect(list->item(1)).center();
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, at);
        QTest::mouseDClick(list->viewport(), Qt::LeftButton, {}, at);
        QCOMPARE(asked.count(), 1);
        QCOMPARE(asked.first().first().toInt(), 1);
    }

    void aStrokeOnAHugeClothIsSeenAtOnceAndGoesIntoTheDesignAtItsEnd_data()
    {
        QTest::addColumn<int>("part");
        QTest::newRow("drawdown") << static_cast<int>(DraftPart::drawdown);
        QTest::newRow("threading") << static_cast<int>(DraftPart::threading);
        QTest::newRow("order of the ends") << static_cast<int>(DraftPart::warpBar);
    }
    void aStrokeOnAHugeClothIsSeenAtOnceAndGoesIntoTheDesignAtItsEnd()
    {
        QFETCH(int, part);
        const auto where = static_cast<DraftPart>(part);
        const Weave huge = weave_from_draft(hugeDraft(600));
        document_->edit("weave", {}, [&](Design& d) { d.fabrics[0].weave = huge; });
        editor_->order()->addYarn();
        document_->history()->clear();
        const Fabric before = *document_->fabric();
        QWidget* paper = editor_->paper()->viewport();
        const int y = where == DraftPart::threading ? 2 : 0;
        QSignalSpy changes(document_.get(), &Document::designChanged);
        const bool was = editor_->paper()->filled(where, {3, y});
        QTest::mousePress(paper, Qt::LeftButton, {}, middle(where, {3, y}));
        QTest::mouseMove(paper, middle(where, {9, y}));
        QCoreApplication::processEvents();
        QCOMPARE(changes.count(), 0);
        if (where != DraftPart::warpBar) { QCOMPARE(editor_->paper()->filled(where, {9, y}), !was); }
        QTest::mouseRelease(paper, Qt::LeftButton, {}, middle(where, {9, y}));
        QCOMPARE(changes.count(), 1);
        QCOMPARE(document_->history()->count(), 1);
        const Fabric after = *document_->fabric();
        QVERIFY(after != before);
        document_->history()->undo();
        QVERIFY(*document_->fabric() == before);
        document_->history()->redo();
        QVERIFY(*document_->fabric() == after);
    }

    void whatIsUndoneDuringAStrokeLosesNothingOfIt()
    {
        document_->edit("weave", {}, [&](Design& d) { d.fabrics[0].weave = weave_from_draft(hugeDraft(600)); });
        document_->history()->clear();
        document_->edit("name", {}, [](Design& d) { d.fabrics[0].name += "!"; });
        const Weave before = weave();
        QWidget* paper = editor_->paper()->viewport();
        QTest::mousePress(paper, Qt::LeftButton, {}, middle(DraftPart::drawdown, {2, 0}));
        QCoreApplication::processEvents();
        document_->history()->undo();
        QTest::mouseMove(paper, middle(DraftPart::drawdown, {4, 0}));
        QTest::mouseRelease(paper, Qt::LeftButton, {}, middle(DraftPart::drawdown, {4, 0}));
        for (int end : {2, 3, 4}) { QCOMPARE(weave().warp_up(end, 0), !before.warp_up(2, 0)); }
        QVERIFY(!QString::fromStdString(document_->fabric()->name).endsWith('!'));
    }

    void aStrokeGoesIntoTheDesignWhenTheEditorIsHidden()
    {
        document_->edit("weave", {}, [&](Design& d) { d.fabrics[0].weave = weave_from_draft(hugeDraft(600)); });
        const bool was = weave().warp_up(2, 0);
        QTest::mousePress(editor_->paper()->viewport(), Qt::LeftButton, {}, middle(DraftPart::drawdown, {2, 0}));
        QCOMPARE(weave().warp_up(2, 0), was);
        editor_->hide();
        QCOMPARE(weave().warp_up(2, 0), !was);
    }

    void anOrderCanBeTyped()
    {
        editor_->order()->addYarn();
        auto* ends = named<QLineEdit>("Order of the ends");
        ends->setText("12A 4b");
        Q_EMIT ends->editingFinished();
        const std::vector<YarnRun> expected{{0, 12}, {1, 4}};
        QCOMPARE(document_->fabric()->warp_order, expected);
        QCOMPARE(editor_->paper()->cells(DraftPart::warpBar).width(), 16);
        ends->setText("3C");
        Q_EMIT ends->editingFinished();
        QCOMPARE(document_->fabric()->warp_order, expected);
        QCOMPARE(ends->text(), QString("3C"));
        QVERIFY(ends->accessibleDescription().contains("no yarn C"));
        document_->edit("name", {}, [](Design& d) { d.fabrics[0].name += "!"; });
        QCOMPARE(ends->text(), QString("3C"));
        QTest::keyClick(ends, Qt::Key_Escape);
        QCOMPARE(ends->text(), QString("12A 4B"));
        QVERIFY(!ends->accessibleDescription().contains("no yarn C"));
        ends->setText("3C");
        Q_EMIT ends->editingFinished();
        document_->edit("another", {}, [](Design& d) { d.fabrics.push_back(d.fabrics[0]); });
        document_->setFabricIndex(static_cast<int>(document_->design()->fabrics.size()) - 1);
        QCOMPARE(ends->text(), QString("12A 4B"));
    }

private:
    /// Straight over 8 shafts, 2 of them up at each pick.
    static Draft hugeDraft(int threads)
    {
        Draft draft;
        draft.shafts = draft.treadles = 8;
        for (int i = 0; i < threads; ++i) {
            draft.threading.push_back({i % 8});
            draft.treadling.push_back({i % 8});
        }
        for (int i = 0; i < 8; ++i) { draft.tie_up.push_back(i < 7 ? std::vector<int>{i, i + 1} : std::vector<int>{0, 7}); }
        return draft;
    }
    const Weave& weave() const { return document_->fabric()->weave; }
    QPoint middle(DraftPart part, const QPoint& cell) { return editor_->paper()->squareOf(part, cell).center().toPoint(); }
    void click(DraftPart part, const QPoint& cell)
    {
        QTest::mouseClick(editor_->paper()->viewport(), Qt::LeftButton, {}, middle(part, cell));
    }
    template <typename Widget> Widget* named(const QString& name)
    {
        for (Widget* widget : editor_->findChildren<Widget*>()) {
            if (widget->accessibleName() == name) { return widget; }
        }
        return nullptr;
    }

    std::unique_ptr<Document> document_;
    std::unique_ptr<DraftEditor> editor_;
};

QTEST_MAIN(TestDraftEditor)
#include "tst_draft_editor.moc"
