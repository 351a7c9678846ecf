// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The user's guide: every page is there, every link and picture leads somewhere, and F1 opens the right page. Needs a display: xvfb-run.
#include "ui/panels/experiment_panel.h"
#include "ui/window/help_window.h"
#include "window_test.h"

#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QRegularExpression>
#include <QTextBlock>
#include <QTextBrowser>

#include <algorithm>

using namespace hygroloom;

class TestHelpWindow : public WindowTest {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        useOwnSettings();
        openWindow();
        QVERIFY(window_->openFile(example("laboratory")));
    }

    void cleanupTestCase() { window_.reset(); }

    void theProgramCarriesEveryPageAndPicture()
    {
        for (const QString& name : QDir(pages()).entryList({"*.md"}, QDir::Files)) {
            QVERIFY2(QFile::exists(":/help/" + name), qPrintable(name + " is not in resources.qrc"));
        }
    }

    void everyPageIsThere_data()
    {
        QTest::addColumn<QString>("page");
        for (const char* page : {"index", "design", "simulate", "compare", "limits", "command-line"}) { QTest::newRow(page) << page; }
        for (int type = 0; type < experiment_types; ++type) {
            const char* page = name_of(static_cast<ExperimentType>(type));
            QTest::newRow(page) << page;
        }
    }
    void everyPageIsThere()
    {
        QFETCH(QString, page);
        HelpWindow guide;
        guide.showPage(page);
        QCOMPARE(guide.page(), page);
        QVERIFY(guide.browser().toPlainText().size() > 20);
        QVERIFY(guide.browser().document()->begin().blockFormat().headingLevel() == 1);
    }

    void everyLinkAndPictureLeadsSomewhere()
    {
        HelpWindow guide;
        QStringList seen{"index"};
        for (int i = 0; i < seen.size(); ++i) {
            guide.showPage(seen[i]);
            for (const QString& link : links(guide.browser())) {
                const QUrl to = guide.browser().source().resolved(QUrl(link));
                if (to.scheme() == "https") { continue; }
                QVERIFY2(to.scheme() == "qrc" && QFile::exists(":" + to.path()), qPrintable(seen[i] + " has a dead link: " + link));
                const QString page = QFileInfo(to.path()).completeBaseName();
                if (!seen.contains(page)) { seen << page; }
            }
            for (const QString& picture : pictures(guide.browser())) {
                const QVariant loaded =
                    guide.browser().document()->resource(QTextDocument::ImageResource, guide.browser().source().resolved(picture));
                QVERIFY2(!loaded.value<QImage>().isNull(), qPrintable(seen[i] + " lacks its picture " + picture));
            }
        }
        for (const QString& name : QDir(pages()).entryList({"*.md"}, QDir::Files)) {
            QVERIFY2(seen.contains(QFileInfo(name).completeBaseName()), qPrintable("No link leads to " + name));
        }
    }

    void f1ExplainsTheWorkspace()
    {
        const char* pages[] = {"design", "simulate", "compare"};
        for (const int workspace : {1, 2, 0}) {
            window_->setWorkspace(static_cast<Workspace>(workspace));
            window_->centralWidget()->setFocus();
            trigger("User's Guide");
            QCOMPARE(window_->guide()->page(), QString(pages[workspace]));
        }
        QVERIFY(window_->guide()->isVisible() && !window_->guide()->isModal());
    }

    void f1ExplainsTheExperimentThatIsEdited()
    {
        window_->setWorkspace(Workspace::simulate);
        const auto& experiments = window_->document().design()->experiments;
        for (std::size_t i = 0; i < experiments.size(); ++i) {
            window_->document().setExperimentIndex(static_cast<int>(i));
            QApplication::setActiveWindow(window_.get());
            window_->run().sample().experiment().findChild<QComboBox*>()->setFocus();
            trigger("User's Guide");
            QCOMPARE(window_->guide()->page(), QString(name_of(experiments[i].type)));
        }
    }

    void linksAreFollowedAndRetracedByKeys()
    {
        HelpWindow guide;
        guide.show();
        QVERIFY(QTest::qWaitForWindowExposed(&guide));
        QApplication::setActiveWindow(&guide);
        guide.showPage("index");
        guide.browser().setFocus();
        QTest::keyClick(&guide.browser(), Qt::Key_Tab); // the first link
        QTest::keyClick(&guide.browser(), Qt::Key_Return);
        QCOMPARE(guide.page(), QString("design"));
        QTest::keyClick(&guide.browser(), Qt::Key_Left, Qt::AltModifier);
        QCOMPARE(guide.page(), QString("index"));
        QTest::keyClick(&guide.browser(), Qt::Key_Right, Qt::AltModifier);
        QCOMPARE(guide.page(), QString("design"));
        QTest::keyClick(&guide.browser(), Qt::Key_Home, Qt::AltModifier);
        QCOMPARE(guide.page(), QString("index"));
    }

    void wordsAreFoundOnEveryPage()
    {
        HelpWindow guide;
        guide.showPage("design");
        auto* words = guide.findChild<QLineEdit*>();
        words->setText("ashenhurst");
        Q_EMIT words->returnPressed();
        QCOMPARE(guide.page(), QString("design"));
        QCOMPARE(guide.browser().textCursor().selectedText().toLower(), QString("ashenhurst"));

        words->setText("AATCC 198");
        QVERIFY(guide.found().count() >= 2 && !guide.found().isHidden());
        const auto rowOf = [&](const QString& page) {
            for (int row = 0; row < guide.found().count(); ++row) {
                if (guide.found().item(row)->data(Qt::UserRole) == page) { return row; }
            }
            return -1;
        };
        const int row = rowOf("horizontal_wicking");
        QVERIFY(row >= 0);
        const QStringList lines = guide.found().item(row)->text().split('\n');
        QVERIFY2(lines.size() == 2 && lines[0].contains("Horizontal wicking") && lines[1].contains("AATCC 198"),
                 qPrintable(lines.join('|')));
        Q_EMIT guide.found().itemClicked(guide.found().item(row));
        QCOMPARE(guide.page(), QString("horizontal_wicking"));
        QCOMPARE(guide.browser().textCursor().selectedText(), QString("AATCC 198"));

        words->setText("a word that no page has");
        Q_EMIT words->returnPressed();
        QVERIFY(guide.found().isHidden());
        const auto labels = guide.findChildren<QLabel*>();
        QVERIFY(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) { return label->text() == "Not in the guide."; }));
    }

    /// F3 meets each place that the list counts once, and comes back to the first.
    void theNextPlaceGoesOnAcrossPages()
    {
        HelpWindow guide;
        guide.show();
        QVERIFY(QTest::qWaitForWindowExposed(&guide));
        QApplication::setActiveWindow(&guide);
        guide.showPage("preferences"); // does not have it
        guide.findChild<QLineEdit*>()->setText("ISO 139");
        int places = 0;
        QStringList pages;
        for (int row = 0; row < guide.found().count(); ++row) {
            static const QRegularExpression count("\\((\\d+)\\)\n");
            places += count.match(guide.found().item(row)->text()).captured(1).toInt();
            pages << guide.found().item(row)->data(Qt::UserRole).toString();
        }
        QVERIFY(pages.size() >= 2 && !pages.contains("preferences"));
        QStringList met;
        QString first;
        for (int k = 0; k <= places; ++k) {
            QTest::keyClick(&guide, Qt::Key_F3);
            QCOMPARE(guide.browser().textCursor().selectedText(), QString("ISO 139"));
            const QString place = guide.page() + QString::number(guide.browser().textCursor().position());
            if (k == 0) { first = place; }
            if (k == places) {
                QCOMPARE(place, first);
            } else {
                QVERIFY2(!met.contains(place), qPrintable(place));
            }
            met << place;
            if (!pages.isEmpty() && guide.page() == pages.first()) { pages.removeFirst(); }
        }
        QVERIFY2(pages.isEmpty(), qPrintable(pages.join(' ')));
    }

private:
    static QString pages() { return QString(HYGROLOOM_SOURCE_DIR) + "/resources/help"; }

    template <typename Take> static QStringList ofFragments(const QTextBrowser& browser, Take take)
    {
        QStringList found;
        for (QTextBlock block = browser.document()->begin(); block.isValid(); block = block.next()) {
            for (auto at = block.begin(); !at.atEnd(); ++at) {
                const QString one = take(at.fragment().charFormat());
                if (!one.isEmpty()) { found << one; }
            }
        }
        return found;
    }
    static QStringList links(const QTextBrowser& browser)
    {
        return ofFragments(browser, [](const QTextCharFormat& format) { return format.anchorHref(); });
    }
    static QStringList pictures(const QTextBrowser& browser)
    {
        return ofFragments(
            browser, [](const QTextCharFormat& format) { return format.isImageFormat() ? format.toImageFormat().name() : QString(); });
    }
};

QTEST_MAIN(TestHelpWindow)
#include "tst_help_window.moc"
