// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The library as pictures to choose from, and a user's own part of it.
#include "ui/document/document.h"
#include "ui/panels/candidates_panel.h"
#include "ui/panels/preset_gallery.h"
#include "ui/window/examples.h"

#include <QListWidget>
#include <QPushButton>
#include <QSet>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

using namespace hygroloom;

class TestPresetGallery : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }

    void presetsInSightGetAPicture()
    {
        PresetGallery gallery(folder_.filePath("none.json"));
        gallery.show();
        auto* list = gallery.findChild<QListWidget*>();
        QCOMPARE(list->count(), static_cast<int>(shipped_presets().size()));
        QVERIFY(gallery.chosen());
        const auto colors = [&](int row) {
            const QImage picture = list->item(row)->icon().pixmap(64, 64).toImage();
            QSet<QRgb> found;
            for (int x = 0; x < picture.width(); ++x) { found << picture.pixel(x, picture.height() / 2); }
            return found.size();
        };
        const int last = list->count() - 1;
        QTRY_VERIFY_WITH_TIMEOUT(colors(0) > 1, 5000);
        QCOMPARE(colors(last), 1); // out of sight
        list->scrollToBottom();
        QTRY_VERIFY_WITH_TIMEOUT(colors(last) > 1, 5000);
        list->scrollToTop();
        gallery.search({}, QString::fromStdString(shipped_presets().back().fabric().name));
        QVERIFY(colors(0) > 1); // known from before
    }

    void searchingAndGroupsNarrowTheChoice()
    {
        PresetGallery gallery(folder_.filePath("none.json"));
        auto* list = gallery.findChild<QListWidget*>();
        const int all = list->count();
        const QString group = QString::fromStdString(shipped_presets().front().group);
        gallery.search(group, {});
        QVERIFY(list->count() > 0 && list->count() < all);
        gallery.search({}, QString::fromStdString(shipped_presets().back().fabric().name));
        QVERIFY(list->count() >= 1);
        QCOMPARE(gallery.chosen()->fabric().name, shipped_presets().back().fabric().name);
        gallery.search({}, "no fabric is called like this");
        QCOMPARE(list->count(), 0);
        QVERIFY(!gallery.chosen());
    }

    void aPresetBecomesACandidateAndCanBeUndone()
    {
        Document document;
        QVERIFY(document.openExample(shippedExample()));
        CandidatesPanel candidates(document);
        const std::size_t before = document.design()->fabrics.size();
        candidates.addPreset(shipped_presets().front());
        QCOMPARE(document.design()->fabrics.size(), before + 1);
        QCOMPARE(document.fabric()->name, shipped_presets().front().fabric().name);
        QVERIFY(!document.fabricHasError());
        document.history()->undo();
        QCOMPARE(document.design()->fabrics.size(), before);
    }

    void whatIsKeptIsFoundAndCanBeRemoved()
    {
        const QString path = folder_.filePath("own/library.json");
        Document document;
        QVERIFY(document.openExample(shippedExample()));
        Fabric fabric = *document.fabric();
        fabric.name = "my shirting";
        keepInLibrary(*document.design(), fabric, path);
        keepInLibrary(*document.design(), fabric, path); // replaces the first
        PresetGallery gallery(path);
        auto* list = gallery.findChild<QListWidget*>();
        QCOMPARE(list->count(), static_cast<int>(shipped_presets().size()) + 1);
        gallery.removeChosen(); // a shipped one stays
        QCOMPARE(list->count(), static_cast<int>(shipped_presets().size()) + 1);
        list->setCurrentRow(list->count() - 1);
        QCOMPARE(gallery.chosen()->fabric().name, std::string("my shirting"));
        gallery.removeChosen();
        QCOMPARE(list->count(), static_cast<int>(shipped_presets().size()));
        QVERIFY(read_library(path.toStdString()).empty());
    }

private:
    QTemporaryDir folder_;
};

QTEST_MAIN(TestPresetGallery)
#include "tst_preset_gallery.moc"
