// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What to begin with: pictures come by themselves, every choice is reached by mouse and keyboard.
#include "core/project/library.h"
#include "ui/basics/cache_folder.h"
#include "ui/basics/preferences.h"
#include "ui/panels/start_page.h"

#include <QCheckBox>
#include <QListWidget>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace hygroloom;

class TestStartPage : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName("hygroloom-test");
        QCoreApplication::setApplicationName("hygroloom-test");
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder_.path());
        qputenv("XDG_CACHE_HOME", folder_.filePath("cache").toUtf8());
    }

    void init()
    {
        setPreferences({});
        page_ = std::make_unique<StartPage>(QStringList{example("textile-A"), example("one-drop-on-cotton")},
                                            QStringList{example("textile-B"), "/nowhere/gone.hygro"});
        page_->show();
    }

    void cleanup() { page_.reset(); }

    void picturesAreMadeInTheBackgroundAndKept()
    {
        for (const char* name : {"Examples", "New project with a fabric of the library", "Recent"}) {
            QTRY_VERIFY2_WITH_TIMEOUT(colors(list(name)->item(0)) > 1, name, 20000);
        }
        QListWidget* fabrics = list("New project with a fabric of the library");
        QCOMPARE(fabrics->count(), static_cast<int>(shipped_presets().size()));
        QTRY_VERIFY_WITH_TIMEOUT(colors(fabrics->item(fabrics->count() - 1)) > 1, 20000);
        const QDir kept(cacheFolder() + "/pictures");
        QTRY_COMPARE_WITH_TIMEOUT(kept.entryList({"*.png"}, QDir::Files).size(), 3, 20000); // of the files alone
        // Another page takes them from there.
        for (const QString& each : kept.entryList({"*.png"}, QDir::Files)) {
            QImage red(176, 176, QImage::Format_RGB32);
            red.fill(Qt::red);
            QVERIFY(red.save(kept.filePath(each)));
        }
        page_ = std::make_unique<StartPage>(QStringList{example("textile-A")}, QStringList());
        page_->show();
        QTRY_COMPARE_WITH_TIMEOUT(list("Examples")->item(0)->icon().pixmap(88, 88).toImage().pixelColor(40, 40), QColor(Qt::red), 20000);
    }

    void whatIsGoneIsNotOffered()
    {
        QCOMPARE(list("Recent")->count(), 1);
        QCOMPARE(list("Recent")->item(0)->text(), QString("textile-B.hygro"));
    }

    void everyChoiceClosesThePage()
    {
        QSignalSpy file(page_.get(), &StartPage::fileChosen);
        click(list("Recent"), 0);
        QCOMPARE(file.count(), 1);
        QCOMPARE(file.front().front().toString(), example("textile-B"));
        QVERIFY(!page_->isVisible());
        init();
        QSignalSpy shown(page_.get(), &StartPage::exampleChosen);
        click(list("Examples"), 1);
        QCOMPARE(shown.count(), 1);
        QCOMPARE(shown.front().front().toString(), example("one-drop-on-cotton"));
    }

    void keysReachEverything()
    {
        QSignalSpy preset(page_.get(), &StartPage::presetChosen);
        QListWidget* fabrics = list("New project with a fabric of the library");
        page_->activateWindow();
        fabrics->setFocus();
        fabrics->setCurrentRow(2);
        QTest::keyClick(fabrics, Qt::Key_Return);
        QTRY_COMPARE(preset.count(), 1);
        QCOMPARE(preset.front().front().toInt(), 2);
        init();
        int buttons = 0;
        for (auto wanted : {&StartPage::newWanted, &StartPage::openWanted, &StartPage::guideWanted}) {
            init();
            QSignalSpy spy(page_.get(), wanted);
            for (QPushButton* button : page_->findChildren<QPushButton*>()) {
                QVERIFY(button->focusPolicy() & Qt::TabFocus);
                const char* names[] = {"New Project", "Open…", "User's Guide"};
                if (button->text().remove('&') == QString::fromUtf8(names[buttons])) {
                    QTest::keyClick(button, Qt::Key_Space);
                    break;
                }
            }
            QCOMPARE(spy.count(), 1);
            ++buttons;
        }
    }

    void rowsOfCardsAreSeenWholeAtAnySize()
    {
        for (const QSize& size : {page_->size(), QSize(980, 560), QSize(1100, 623), QSize(1200, 760)}) {
            page_->resize(size);
            QCoreApplication::processEvents();
            for (const char* name : {"Examples", "New project with a fabric of the library"}) {
                QListWidget* cards = list(name);
                const int height = cards->viewport()->height(), row = cards->gridSize().height();
                QVERIFY2(height >= row && height % row == 0, qPrintable(QString("%1: %2 of %3").arg(name).arg(height).arg(row)));
                QVERIFY(cards->height() - height < row + 4); // as many rows as there is room for
                for (int i = 0; i < cards->count(); ++i) {
                    const QListWidgetItem* card = cards->item(i);
                    const QRect given = cards->visualItemRect(card);
                    const QRect room(0, 0, given.width() - 4, 1000); // in which the name is wrapped
                    const int lines = cards->fontMetrics().boundingRect(room, Qt::TextWordWrap | Qt::AlignHCenter, card->text()).height();
                    QVERIFY2(cards->iconSize().height() + lines <= given.height() && given.height() <= row, qPrintable(card->text()));
                }
            }
        }
    }

    void theBoxSaysWhetherItComesAtTheStart()
    {
        auto* box = page_->findChild<QCheckBox*>();
        QVERIFY(box->isChecked());
        box->click();
        QCOMPARE(preferences().start_page, 0);
        QCOMPARE(QSettings().value("window/start_page").toInt(), 0);
    }

private:
    static QString example(const QString& name) { return QString(HYGROLOOM_SOURCE_DIR) + "/resources/examples/" + name + ".hygro"; }

    QListWidget* list(const QString& name)
    {
        for (QListWidget* each : page_->findChildren<QListWidget*>()) {
            if (each->accessibleName() == name) { return each; }
        }
        return nullptr;
    }

    static int colors(const QListWidgetItem* item)
    {
        const QImage image = item->icon().pixmap(88, 88).toImage();
        QSet<QRgb> found;
        for (int x = 2; x < image.width() - 2; ++x) { found << image.pixel(x, image.height() / 2); }
        return static_cast<int>(found.size());
    }

    static void click(QListWidget* list, int row)
    {
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(row)).center());
    }

    QTemporaryDir folder_;
    std::unique_ptr<StartPage> page_;
};

QTEST_MAIN(TestStartPage)
#include "tst_start_page.moc"
