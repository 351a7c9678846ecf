// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The whole window with settings of its own, for the tests that drive it. Needs a display: xvfb-run.
#pragma once

#include "ui/basics/appearance.h"
#include "ui/basics/preferences.h"
#include "ui/compare/compare_view.h"
#include "ui/results/run_panel.h"
#include "ui/window/main_window.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

namespace hygroloom {

/// A test of the window derives from it.
class WindowTest : public QObject {
public:
    static void initMain() { requestOpenGL(); }

protected:
    Playback& playback() { return window_->run().sample().playback(); }
    QueuedRun& simulation() { return window_->run().run(); }
    RunPanel& simulationPanel() { return window_->run().panel(); }
    WaterMapView& waterMaps() { return window_->run().sample().maps(); }
    Chart& chart() { return window_->run().chartOf(Subject::sample); }
    ResultsPanel& results() { return window_->run().sample().resultsPanel(); }
    Timeline& timeline() { return window_->run().timelineOf(Subject::sample); }
    CompareView& compareView() { return window_->compare().view(); }
    RunHistory& runs() { return window_->compare().runs(); }
    static QString example(const QString& name) { return QString(HYGROLOOM_SOURCE_DIR) + "/resources/examples/" + name + ".hygro"; }

    /// The defaults, but pictures at rest as they are drawn first: a processor draws each pixel.
    static Preferences quickPreferences()
    {
        Preferences quick;
        quick.refine_at_rest = 0;
        return quick;
    }

    /// Before the first window.
    void useOwnSettings()
    {
        QCoreApplication::setOrganizationName("hygroloom-test");
        QCoreApplication::setApplicationName("hygroloom-test");
        qputenv("XDG_DATA_HOME", folder_.path().toUtf8()); // unsaved work
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder_.path());
        applyAppearance(Appearance::light);
        setPreferences(quickPreferences());
    }

    /// Small, as a processor draws every pixel: for a test of what is seen, say how large.
    void openWindow(QSize size = {900, 640})
    {
        window_ = std::make_unique<MainWindow>();
        window_->resize(size);
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
        QApplication::setActiveWindow(window_.get()); // there may be no window manager to do it
    }

    /// Chooses the command with this text, else one whose text begins with it.
    void trigger(const QString& words)
    {
        const auto actions = window_->findChildren<QAction*>();
        for (const bool whole : {true, false}) {
            for (QAction* action : actions) {
                const QString text = action->text().remove('&');
                if (whole ? text == words : text.startsWith(words)) {
                    action->trigger();
                    return;
                }
            }
        }
        QFAIL(qPrintable("There is no action " + words));
    }

    /// Does the work with the next modal dialog of a kind, whenever it opens.
    template <typename Dialog, typename Work> void meet(Work work)
    {
        auto* timer = new QTimer(this);
        QObject::connect(timer, &QTimer::timeout, this, [timer, work] {
            if (auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget())) {
                timer->deleteLater();
                timer->stop();
                work(dialog);
            }
        });
        timer->start(50);
    }

    /// Presses the button with this text in the next question. Returns what was asked, once it was.
    std::shared_ptr<QString> press(const QString& text)
    {
        auto asked = std::make_shared<QString>();
        meet<QMessageBox>([asked, text](QMessageBox* box) {
            *asked = box->text() + "\n" + box->informativeText();
            for (QAbstractButton* button : box->buttons()) {
                if (button->text().remove('&') == text) {
                    button->click();
                    return;
                }
            }
            box->reject();
            QFAIL(qPrintable("There is no button " + text));
        });
        return asked;
    }

    /// Answers the next question; the value is true once there was one.
    std::shared_ptr<bool> answer(QMessageBox::StandardButton button)
    {
        auto asked = std::make_shared<bool>(false);
        meet<QMessageBox>([asked, button](QMessageBox* box) {
            *asked = true;
            box->button(button)->click();
        });
        return asked;
    }

    /// Gives the next file dialog this path, over a file that is there.
    void chooseFile(const QString& path)
    {
        meet<QFileDialog>([path](QFileDialog* dialog) {
            dialog->setOption(QFileDialog::DontConfirmOverwrite);
            dialog->findChild<QLineEdit*>()->setText(path);
            QMetaObject::invokeMethod(dialog, "accept");
        });
    }

    /// Shortens the experiment to a small drop. A live run takes less than a second; other fidelities have particles and take seconds.
    void shortenExperiment(double duration_s, double sample_mm, double volume_ul)
    {
        window_->document().edit("a short experiment", {}, [=](Design& d) {
            Experiment& e = d.experiments[0];
            e.duration_s = duration_s;
            e.sample_mm = {sample_mm, sample_mm};
            e.droplets = {Droplet{volume_ul, 0, {0, 0}, 0.05, 0}};
        });
        simulationPanel().setFidelity(Fidelity::live);
    }

    QTemporaryDir folder_;
    std::unique_ptr<MainWindow> window_;
};

} // namespace hygroloom
