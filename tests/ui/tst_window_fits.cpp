// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The window stays within small screens in every workspace, language and size of letters. Needs a display: xvfb-run.
#include "ui/basics/count_edit.h"
#include "ui/basics/language.h"
#include "window_test.h"

#include <QDockWidget>
#include <QLayout>
#include <QScreen>
#include <QScrollArea>
#include <QTranslator>

using namespace hygroloom;

namespace {

constexpr Workspace workspaces[] = {Workspace::garment, Workspace::design, Workspace::study, Workspace::simulate, Workspace::compare};
const QSize smallest_screen{1280, 800}; // less a title bar
constexpr int title_bar = 28;

/// What asks for so much room, for whoever has to mend it.
QString widest(const QMainWindow& window)
{
    QStringList lines;
    for (const QDockWidget* dock : window.findChildren<QDockWidget*>()) {
        if (!dock->isVisible()) { continue; }
        const QSize least = dock->minimumSizeHint();
        lines << QString("%1 %2x%3").arg(dock->objectName()).arg(least.width()).arg(least.height());
    }
    const QSize middle = window.centralWidget()->minimumSizeHint();
    lines << QString("middle %1x%2").arg(middle.width()).arg(middle.height());
    return lines.join(", ");
}

} // namespace

class TestWindowFits : public WindowTest {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        useOwnSettings();
        usual_ = QApplication::font();
    }

    void cleanup()
    {
        window_.reset();
        for (QTranslator* translator : qApp->findChildren<QTranslator*>()) {
            QCoreApplication::removeTranslator(translator);
            delete translator;
        }
        QApplication::setFont(usual_);
        QSettings().clear();
    }

    void everyWorkspaceFits_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<double>("letters");
        QTest::addColumn<QSize>("screen");
        const auto row = [](const QString& language, double letters, const QSize& screen) {
            QTest::addRow("%s, letters x %g, %d x %d", qPrintable(language), letters, screen.width(), screen.height())
                << language << letters << screen;
        };
        for (const QString& language : {QString("en"), QString("de")}) {
            for (const double letters : {1.0, 2.0}) { row(language, letters, smallest_screen); }
        }
        for (const QSize screen : {QSize(1440, 900), QSize(2560, 1600)}) { row("de", 2, screen); } // what asks for most room
    }
    void everyWorkspaceFits()
    {
        QFETCH(QString, language);
        QFETCH(double, letters);
        QFETCH(QSize, screen);
        show(language, letters, screen);
        const QSize room = screen - QSize(0, title_bar);
        QVERIFY(window_->minimumWidth() <= smallest_screen.width() && window_->minimumHeight() <= smallest_screen.height() - title_bar);
        for (int round = 0; round < 2; ++round) { // the second from the states that the first left
            for (const Workspace workspace : workspaces) {
                window_->setWorkspace(workspace);
                settle();
                const QSize least = window_->layout()->totalMinimumSize();
                const QString found = QString("workspace %1: %2 x %3; %4")
                                          .arg(static_cast<int>(workspace))
                                          .arg(least.width())
                                          .arg(least.height())
                                          .arg(widest(*window_));
                QVERIFY2(least.width() <= room.width() && least.height() <= room.height(), qPrintable(found));
                QCOMPARE(window_->size(), room);
            }
        }
    }

    void longCountsAndComplaintsLeaveTheFormItsWidth_data() { everyWorkspaceFits_data(); }
    void longCountsAndComplaintsLeaveTheFormItsWidth()
    {
        QFETCH(QString, language);
        QFETCH(double, letters);
        QFETCH(QSize, screen);
        show(language, letters, screen);
        for (const char* typed : {"133.2/24 den x 2", "Ne 88.88/2", "150/48 den", "60/2 Ny"}) {
            auto* count = window_->findChild<CountEdit*>();
            QVERIFY(count);
            count->setFocus();
            count->selectAll();
            QTest::keyClicks(count, typed);
            QTest::keyClick(count, Qt::Key_Return);
            settle();
            QVERIFY(window_->document().design()->fabrics[0].warp.linear_density_tex); // the count was taken
            const QScrollArea* form = nullptr;
            for (const QWidget* at = count; at && !form; at = at->parentWidget()) { form = qobject_cast<const QScrollArea*>(at); }
            QVERIFY(form);
            const int wide = form->widget()->minimumSizeHint().width(), room = form->viewport()->width();
            QVERIFY2(wide <= room, qPrintable(QString("%1: %2 of %3 pixels").arg(typed).arg(wide).arg(room)));
        }
    }

    void aGeometryOfALargerScreenIsCutToThisOne()
    {
        const QSize screen = QGuiApplication::primaryScreen()->availableSize();
        openWindow(screen + QSize(400, 300));
        window_->move(300, 200);
        QCOMPARE(window_->width(), screen.width() + 400);
        const QByteArray geometry = window_->saveGeometry();
        window_.reset();
        QSettings().setValue("window/geometry", geometry);
        window_ = std::make_unique<MainWindow>();
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
        const QRect place = window_->geometry();
        QVERIFY2(QRect(QPoint(), screen).contains(place),
                 qPrintable(QString("%1 x %2 at %3, %4").arg(place.width()).arg(place.height()).arg(place.x()).arg(place.y())));
    }

private:
    /// The shipped example on such a screen.
    void show(const QString& language, double letters, const QSize& screen)
    {
        QSettings().setValue("look/language", language);
        install_language(*qApp);
        QFont font = usual_;
        font.setPointSizeF(letters * usual_.pointSizeF());
        QApplication::setFont(font);
        openWindow(screen - QSize(0, title_bar));
        window_->openShippedExample();
    }
    /// Some things are laid out later.
    static void settle()
    {
        for (int turn = 0; turn < 3; ++turn) {
            QApplication::processEvents();
            QCoreApplication::sendPostedEvents();
        }
    }

    QFont usual_;
};

QTEST_MAIN(TestWindowFits)
#include "tst_window_fits.moc"
