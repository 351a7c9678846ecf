// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The list of runs in progress: what is on, what waits and why; by keyboard and mouse they are paused, stopped and reordered.
#include "tests/support/places.h"
#include "tests/support/quick_job.h"
#include "ui/results/queue_list.h"

#include <QLabel>
#include <QMainWindow>
#include <QPushButton>
#include <QStatusBar>
#include <QTest>
#include <QTreeWidget>

using namespace hygroloom;

class TestQueueList : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        window_ = std::make_unique<QMainWindow>();
        window_->resize(900, 400);
        queue_ = std::make_unique<WindowQueue>();
        button_ = new QueueButton(*queue_);
        window_->statusBar()->addPermanentWidget(button_);
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    }
    void cleanup()
    {
        window_.reset();
        queue_.reset();
    }

    void theButtonCountsAndHides()
    {
        QVERIFY(!button_->isVisible());
        const int id = add("first", 3);
        QTRY_COMPARE(button_->text(), QString("Runs: 1 on, 2 waiting"));
        QVERIFY(button_->isVisible());
        queue_->runs().cancel(id);
        QTRY_VERIFY(!button_->isVisible());
    }
    void theListSaysWhyOneWaits()
    {
        add("first", 1);
        add("second", 2);
        open();
        QTRY_COMPARE(cell(0, 1), QString("Running"));
        QCOMPARE(cell(0, 0), QString("first"));
        QCOMPARE(cell(1, 0), QString("second"));
        QCOMPARE(cell(1, 1), QString("Waits until other runs are done"));
        QCOMPARE(cell(1, 2), QString("0 of 2 runs, 0 %"));
        QTRY_VERIFY(cell(0, 2) != QString("0 %"));
    }
    void keysPauseReorderAndStop()
    {
        add("first", 1);
        add("second", 1);
        add("third", 1);
        open();
        QTRY_COMPARE(cell(0, 1), QString("Running"));
        QTest::keyClick(list(), Qt::Key_P);
        QCOMPARE(cell(0, 1), QString("Paused"));
        QTRY_COMPARE(cell(1, 1), QString("Running")); // it has taken its turn
        choose(2);
        QTest::keyClick(list(), Qt::Key_Up, Qt::AltModifier);
        QCOMPARE(cell(1, 0), QString("third"));
        QCOMPARE(tree()->currentItem()->text(0), QString("third"));
        QTest::keyClick(list(), Qt::Key_Down, Qt::AltModifier);
        QCOMPARE(cell(1, 0), QString("second"));
        choose(1);
        QTest::keyClick(list(), Qt::Key_Delete);
        QTRY_COMPARE(tree()->topLevelItemCount(), 2);
        QTRY_COMPARE(cell(1, 1), QString("Running"));
        QCOMPARE(button_->text(), QString("Runs: 1 on, 1 paused"));
        choose(0);
        QTest::keyClick(list(), Qt::Key_P); // "third" has its place
        QCOMPARE(cell(0, 1), QString("Waits until other runs are done"));
        choose(1);
        QTest::keyClick(list(), Qt::Key_Delete);
        QTRY_COMPARE(cell(0, 1), QString("Running"));
    }
    void buttonsDoTheSame()
    {
        add("first", 1);
        add("second", 1);
        open();
        QTRY_COMPARE(cell(0, 1), QString("Running"));
        QVERIFY(!button("Earlier")->isEnabled());
        QTest::mouseClick(button("Later"), Qt::LeftButton);
        QCOMPARE(cell(1, 0), QString("first"));
        QTest::mouseClick(button("Pause"), Qt::LeftButton);
        QCOMPARE(cell(1, 1), QString("Paused"));
        QVERIFY(button("Resume"));
        QTest::mouseClick(button("Stop"), Qt::LeftButton);
        QTRY_COMPARE(tree()->topLevelItemCount(), 1);
        QVERIFY(!button("Stop")->isEnabled()); // or a second click would hit the other
        choose(0);
        QTest::mouseClick(button("Stop"), Qt::LeftButton);
        QTRY_COMPARE(tree()->topLevelItemCount(), 0);
        QVERIFY(!button("Stop")->isEnabled());
        QVERIFY(list()->isVisible() && !button("Stop")->isVisible() && !tree()->isVisible()); // nothing to press
    }

private:
    int add(const char* name, std::size_t count)
    {
        RunBatch batch;
        batch.name = name;
        batch.count = count;
        batch.places = cpu_places();
        batch.job = [](std::size_t) { return slow_job(); };
        return queue_->runs().add(std::move(batch));
    }
    void open()
    {
        QTRY_VERIFY(button_->isVisible());
        QTest::mouseClick(button_, Qt::LeftButton);
        QTRY_VERIFY(list()->isVisible());
    }
    QueueList* list() const { return button_->findChild<QueueList*>(); }
    QTreeWidget* tree() const { return list()->findChild<QTreeWidget*>(); }
    QString cell(int row, int column) const
    {
        const QTreeWidgetItem* item = tree()->topLevelItem(row);
        return item ? item->text(column) : QString();
    }
    void choose(int row) { tree()->setCurrentItem(tree()->topLevelItem(row)); }
    QPushButton* button(const QString& text) const
    {
        for (auto* one : list()->findChildren<QPushButton*>())
            if (one->text() == text) return one;
        return nullptr;
    }

    std::unique_ptr<QMainWindow> window_;
    std::unique_ptr<WindowQueue> queue_;
    QueueButton* button_ = nullptr;
};

QTEST_MAIN(TestQueueList)
#include "tst_queue_list.moc"
