// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Three workspaces: Run is of a sample or a garment, Compare of runs or a study. Needs a display: xvfb-run.
#include "window_test.h"

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
        trigger("Study");
        QCOMPARE(window_->workspace(), Workspace::study);
        QTRY_COMPARE(buttons(), (QStringList{"Runs", "Study!", "Design", "Run", "Compare!"}));
        trigger("Design");
        QTRY_COMPARE(buttons(), (QStringList{"Design!", "Run", "Compare"}));
        trigger("Run a Sample or a Garment"); // what it showed last
        QCOMPARE(window_->workspace(), Workspace::garment);
        trigger("Compare");
        QCOMPARE(window_->workspace(), Workspace::study);
        trigger("Study"); // which is shown
        QTRY_COMPARE(buttons(), (QStringList{"Runs", "Study!", "Design", "Run", "Compare!"}));
        trigger("Runs");
        QCOMPARE(window_->workspace(), Workspace::compare);
        window_->setWorkspace(Workspace::simulate);
    }
};

QTEST_MAIN(TestWorkspaces)
#include "tst_workspaces.moc"
