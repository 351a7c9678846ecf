// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A window with a project of its own, for the tests of a project's runs.
#pragma once

#include "ui/document/run_folder.h"
#include "window_test.h"

#include <QPushButton>
#include <QTreeWidget>

namespace hygroloom {

class ProjectRunsTest : public WindowTest {
protected:
    void openProject()
    {
        project_ = folder_.filePath(QString("p%1/cloth.hygro").arg(++tests_));
        QVERIFY(QDir().mkpath(QFileInfo(project_).absolutePath()));
        QVERIFY(QFile::copy(example("one-drop-on-cotton"), project_));
        openWindow();
        QVERIFY(window_->openFile(project_));
    }

    void closeProject()
    {
        window_.reset();
        QDir(Recovery::standardFolder()).removeRecursively();
    }

    void openExample()
    {
        window_->openShippedExample();
        QVERIFY(window_->document().path().isEmpty());
    }

    void run()
    {
        if (window_->document().experiment()->duration_s != 0.02) { shortenExperiment(0.02, 4, 0.5); }
        simulationPanel().setFidelity(Fidelity::live);
        QSignalSpy ended(&simulation(), &QueuedRun::ended);
        window_->run().start();
        QTRY_VERIFY_WITH_TIMEOUT(ended.count() == 1, 60000);
    }

    QString saveAs(const QString& name)
    {
        const QString path = QFileInfo(project_).absolutePath() + "/" + name;
        chooseFile(path);
        trigger("Save As…");
        return path;
    }

    QTreeWidget* list() { return compareView().findChild<QTreeWidget*>(); }
    QPushButton* button(const QString& text)
    {
        for (QPushButton* each : compareView().findChildren<QPushButton*>()) {
            if (each->text().remove('&') == text) { return each; }
        }
        return nullptr;
    }

    QString project_;
    int tests_ = 0;
};

} // namespace hygroloom
