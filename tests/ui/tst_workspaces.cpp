// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Three workspaces: Run is of a sample or a garment, Compare of runs or a study. Needs a display: xvfb-run.
#include "ui/garment/garment_edits.h"
#include "window_test.h"

#include <QComboBox>
#include <QDockWidget>
#include <QRegularExpression>
#include <QToolBar>
#include <QToolButton>

using namespace hygroloom;

class TestWorkspaces : public WindowTest {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        useOwnSettings();
        openWindow();
    }
    void cleanupTestCase() { window_.reset(); }

    void threeWorkspacesHaveTheirModes()
    {
        const auto buttons = [this] {
            QStringList shown;
            for (const auto* button : window_->findChild<QToolBar*>("tools")->findChildren<QToolButton*>()) {
                if (button->isVisible() && button->defaultAction() && button->defaultAction()->isCheckable()) {
                    shown << button->text() + (button->isChecked() ? "!" : "");
                }
            }
            return shown.filter(QRegularExpression("^(Sample|Garment|Runs|Study|Design|Run|Compare)"));
        };
        window_->setWorkspace(Workspace::simulate);
        QTRY_COMPARE(buttons(), (QStringList{"Sample!", "Garment", "Design", "Run!", "Compare"}));
        trigger("Show the Garment");
        QCOMPARE(window_->workspace(), Workspace::garment);
        QTRY_COMPARE(buttons(), (QStringList{"Sample", "Garment!", "Design", "Run!", "Compare"}));
        QTest::keyClick(window_.get(), Qt::Key_5, Qt::ControlModifier);
        QTRY_COMPARE(window_->workspace(), Workspace::study);
        QTRY_COMPARE(buttons(), (QStringList{"Runs", "Study!", "Design", "Run", "Compare!"}));
        trigger("Design");
        QTRY_COMPARE(buttons(), (QStringList{"Design!", "Run", "Compare"}));
        trigger("Run, as Last Shown");
        QCOMPARE(window_->workspace(), Workspace::garment);
        trigger("Compare, as Last Shown");
        QCOMPARE(window_->workspace(), Workspace::study);
        trigger("Compare: Study"); // which is shown
        QTRY_COMPARE(buttons(), (QStringList{"Runs", "Study!", "Design", "Run", "Compare!"}));
        QTest::keyClick(window_.get(), Qt::Key_3, Qt::ControlModifier);
        QTRY_COMPARE(window_->workspace(), Workspace::compare);
        QTest::keyClick(window_.get(), Qt::Key_4, Qt::ControlModifier);
        QTRY_COMPARE(window_->workspace(), Workspace::garment);
        QTest::keyClick(window_.get(), Qt::Key_2, Qt::ControlModifier);
        QTRY_COMPARE(window_->workspace(), Workspace::simulate);
    }

    /// Fabrics and garments are chosen where they are run, and share the panels.
    void theSubjectOfARunIsChosenOnItsPage()
    {
        QVERIFY(window_->document().openExample(example("three-candidates")));
        window_->setWorkspace(Workspace::simulate);
        QComboBox* subject = nullptr;
        for (auto* box : window_->run().docks().experiment->findChildren<QComboBox*>()) {
            if (box->accessibleName() == "Subject") { subject = box; }
        }
        QVERIFY(subject);
        const auto choose = [subject](int index) {
            subject->setCurrentIndex(index);
            Q_EMIT subject->activated(index);
        };
        const int fabrics = static_cast<int>(window_->document().design()->fabrics.size());
        QCOMPARE(subject->count(), fabrics + 1);
        choose(1);
        QCOMPARE(window_->document().fabricIndex(), 1);
        QCOMPARE(window_->workspace(), Workspace::simulate);
        addBuiltInGarment(window_->document(), "tee");
        addBuiltInGarment(window_->document(), "leggings");
        QCOMPARE(subject->count(), fabrics + 2);
        choose(fabrics + 1);
        QCOMPARE(window_->workspace(), Workspace::garment);
        QCOMPARE(window_->run().garment().choice().garment()->name, std::string("leggings"));
        QCOMPARE(subject->currentText(), QString("Garment: leggings"));
        QVERIFY(window_->run().docks().experiment->isVisible() && window_->run().docks().garment->isVisible());
        window_->run().docks().fit->close();
        choose(0);
        QCOMPARE(window_->workspace(), Workspace::simulate);
        QCOMPARE(subject->currentText(), "Sample of " + QString::fromStdString(window_->document().fabric()->name));
        QVERIFY(window_->run().docks().experiment->isVisible() && window_->run().docks().garment->isHidden());
        window_->setWorkspace(Workspace::garment);
        QVERIFY(window_->run().docks().fit->isHidden()); // as it was left
        window_->document().history()->setClean();
    }
};

QTEST_MAIN(TestWorkspaces)
#include "tst_workspaces.moc"
