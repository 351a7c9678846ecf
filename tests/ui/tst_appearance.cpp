// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Light, dark and high contrast: everything can be seen in each. Needs a display: xvfb-run.
#include "window_test.h"

#include <QCheckBox>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QRadioButton>
#include <QSlider>
#include <QToolButton>

#include <algorithm>
#include <cstdlib>

using namespace hygroloom;

class TestAppearance : public WindowTest {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        useOwnSettings();
        openWindow();
    }

    void cleanupTestCase() { window_.reset(); }

    void highContrastOutlinesEveryControl()
    {
        applyAppearance(Appearance::contrast);
        QWidget page;
        page.resize(300, 300);
        auto* radio = new QRadioButton(&page);
        radio->setGeometry(10, 10, 100, 24);
        auto* slider = new QSlider(Qt::Horizontal, &page);
        slider->setGeometry(10, 50, 200, 24);
        auto* text = new QPlainTextEdit(&page);
        text->setGeometry(10, 90, 100, 60);
        auto* list = new QListWidget(&page);
        list->setGeometry(10, 160, 100, 60);
        page.show();
        const QImage picture = page.grab().toImage();
        const auto brightest = [&](QRect where) {
            int most = 0;
            for (int y = where.top(); y <= where.bottom(); ++y) {
                for (int x = where.left(); x <= where.right(); ++x) { most = std::max(most, qGray(picture.pixel(x, y))); }
            }
            return most;
        };
        const int background = qGray(QApplication::palette().color(QPalette::Window).rgb());
        const int least = background + 160;                                                              // 21 : 1 is 255
        QVERIFY(brightest(radio->geometry().adjusted(0, 0, -76, 0)) > least);                            // without its words
        QVERIFY(brightest(QRect(slider->geometry().center(), QSize(90, 12)).translated(0, -6)) > least); // the groove
        QVERIFY(brightest(QRect(slider->geometry().topLeft(), QSize(12, 24))) > least);                  // the handle
        for (const QWidget* framed : {static_cast<QWidget*>(text), static_cast<QWidget*>(list)}) {
            const QRect place = framed->geometry();
            QVERIFY(brightest(QRect(place.topLeft(), QSize(1, place.height()))) > least);
            QVERIFY(brightest(QRect(place.bottomLeft(), QSize(place.width(), 1))) > least);
        }
        applyAppearance(Appearance::light);
    }

    void whatCanBeTickedIsSeenInTheDark()
    {
        applyAppearance(Appearance::dark);
        QWidget page;
        page.resize(200, 100);
        auto* radio = new QRadioButton(&page);
        radio->setGeometry(10, 10, 24, 24);
        auto* box = new QCheckBox(&page);
        box->setGeometry(10, 50, 24, 24);
        page.show();
        const QImage picture = page.grab().toImage();
        const int background = qGray(QApplication::palette().color(QPalette::Window).rgb());
        for (const QWidget* one : {static_cast<QWidget*>(radio), static_cast<QWidget*>(box)}) {
            int most = 0;
            for (int x = one->x(); x < one->geometry().right(); ++x) {
                most = std::max(most, qGray(picture.pixel(x, one->geometry().center().y())));
            }
            QVERIFY(most > background + 60);
        }
        applyAppearance(Appearance::light);
    }

    void everyLookCanBeChosenAndIsKept()
    {
        for (const Appearance look : {Appearance::contrast, Appearance::dark, Appearance::light}) {
            saveAppearance(look);
            QCOMPARE(savedAppearance(), look);
            applyAppearance(look);
            QCOMPARE(isDark(QApplication::palette()), look != Appearance::light);
            for (const char* heading : {"Weft yarn", "Flyaways", "Measured in the laboratory"}) {
                QTRY_VERIFY2_WITH_TIMEOUT(drawsInTheLooksInk(heading), heading, 2000);
            }
        }
    }

private:
    /// Whether a heading of the fabric panel has a pixel of the present look's text.
    bool drawsInTheLooksInk(const QString& heading)
    {
        const QColor ink = QApplication::palette().color(QPalette::ButtonText);
        for (auto* button : window_->findChildren<QToolButton*>()) {
            if (button->text() != heading) { continue; }
            const QImage picture = button->grab().toImage();
            for (int y = 0; y < picture.height(); ++y) {
                for (int x = 0; x < picture.width(); ++x) {
                    const QColor c = picture.pixelColor(x, y);
                    if (std::abs(c.red() - ink.red()) + std::abs(c.green() - ink.green()) + std::abs(c.blue() - ink.blue()) < 24) {
                        return true;
                    }
                }
            }
        }
        return false;
    }
};

QTEST_MAIN(TestAppearance)
#include "tst_appearance.moc"
