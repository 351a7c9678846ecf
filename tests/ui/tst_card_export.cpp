// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// File, Technical Card: what is written is the core's, and an unwritable place is told.
#include "core/analysis/card.h"
#include "ui/export/card_export.h"
#include "ui/window/examples.h"

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace hygroloom;

class TestCardExport : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theCardIsTheCores()
    {
        QTemporaryDir folder;
        Document document;
        QVERIFY(document.openExample(shippedExample()));
        QWidget window;
        CardExport card(document, &window);
        QSignalSpy making(&card, &CardExport::making), written(&card, &CardExport::written), failed(&card, &CardExport::failed);
        card.write(folder.filePath("card.html"));
        QCOMPARE(making.count(), 1);
        QTRY_COMPARE_WITH_TIMEOUT(written.count(), 1, 60000);
        QFile file(folder.filePath("card.html"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray page = file.readAll();
        const Card own = card_of(*document.design(), *document.fabric(), *document.fitted());
        for (const LaboratoryNumber& number : own.numbers.found) QVERIFY2(page.contains(number.title.c_str()), number.title.c_str());
        QVERIFY(page.contains("data:image/png"));
        card.write(folder.filePath("no such folder/card.html"));
        QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, 60000);
    }
};

QTEST_MAIN(TestCardExport)
#include "tst_card_export.moc"
