// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Exporting from the window: the estimated size, the file written, cancelled, refused, and the choice remembered.
#include "ui/basics/quantity_edit.h"
#include "ui/document/document.h"
#include "ui/export/export_dialog.h"
#include "ui/results/playback.h"
#include "ui/window/examples.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

using namespace hygroloom;

class TestExportDialog : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName("hygroloom-test");
        QCoreApplication::setApplicationName("hygroloom-test-export");
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings_.path());
    }
    void init()
    {
        QSettings().clear();
        folder_ = std::make_unique<QTemporaryDir>();
        QVERIFY(document_.openExample(shippedExample()));
        dialog_ = std::make_unique<ExportDialog>(document_, playback_);
        dialog_->show();
    }
    void cleanup()
    {
        dialog_.reset();
        playback_.clear();
    }

    void theSizeShownIsTheCores()
    {
        choose("Piece", 1);
        type("Width along the weft", "3 mm");
        type("Height along the warp", "2");
        for (int detail = 0; detail < 3; ++detail) {
            choose("Detail", detail);
            dialog_->setFile(folder_->filePath("cloth.ply"));
            const ExportEstimate size = coreEstimate(MeshFormat::ply);
            const std::size_t count = size.curves > 0 ? size.curves : size.triangles;
            waitForText("Size of the export", QLocale().toString(static_cast<qulonglong>(count)));
            waitForText("Size of the export", bytesText(size.bytes));
        }
    }

    void theSizeFollowsTheDesign()
    {
        choose("Piece", 1);
        waitForText("Size of the export", "ends");
        const QString before = text("Size of the export");
        document_.edit("picks", {}, [](Design& design) { design.fabrics[0].picks_per_cm *= 0.5; });
        QTRY_VERIFY_WITH_TIMEOUT(text("Size of the export") != before, 5000);
    }

    void anExportIsWhatTheCoreWrites_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("detail");
        QTest::newRow("yarns, PLY") << "cloth.ply" << 1;
        QTest::newRow("fibres, STL") << "cloth.stl" << 2;
        QTest::newRow("centrelines, curves") << "cloth.bcc" << 0;
        QTest::newRow("yarns, OBJ with its colours") << "cloth.obj" << 1;
    }

    void anExportIsWhatTheCoreWrites()
    {
        QFETCH(QString, name);
        QFETCH(int, detail);
        choose("Detail", detail);
        type("Repeats along the weft", "3");
        dialog_->setFile(folder_->filePath(name));
        write();

        QDir().mkpath(folder_->filePath("core"));
        const MeshExport made = coreExport();
        export_textile(made.textile, made.fabric, made.options, folder_->filePath("core/" + name).toStdString());
        for (const QString& file : QDir(folder_->filePath("core")).entryList(QDir::Files)) {
            QCOMPARE(contents(file), contents("core/" + file));
        }
        QVERIFY(text("Result of the export").startsWith("Wrote " + name));
        QVERIFY(button("Open Folder")->isVisible());
    }

    void waterAtTheTimeShownColoursTheSimulatedPiece()
    {
        auto* piece = dialog_->findChildren<QComboBox*>().at(2);
        QVERIFY(!piece->itemText(3).contains(" s"));
        auto run = std::make_shared<RunRecord>();
        run->design = *document_.design();
        run->fabric = document_.fabric()->name;
        run->textile = build_textile(run->design, *document_.fabric(), {0, 0, 6, 4});
        auto frame = std::make_shared<Frame>();
        frame->time = 1.5;
        for (int i = 0; i < run->textile.segments(); ++i) { frame->saturation.push_back(static_cast<float>(i % 10) / 10); }
        playback_.begin(run, {});
        playback_.append(frame, std::make_shared<Metrics>());
        QTRY_VERIFY(piece->itemText(3).contains("1.5 s"));
        choose("Piece", 3);
        dialog_->setFile(folder_->filePath("wet.ply"));
        write();

        ExportOptions options{smooth_request(run->textile, MeshDetail::yarn), frame->saturation};
        export_textile(run->textile, *document_.fabric(), options, folder_->filePath("core.ply").toStdString());
        QCOMPARE(contents("wet.ply"), contents("core.ply"));
        options.saturation.clear();
        export_textile(run->textile, *document_.fabric(), options, folder_->filePath("dry.ply").toStdString());
        QVERIFY(contents("wet.ply") != contents("dry.ply"));

        dialog_->setFile(folder_->filePath("wet.stl")); // holds no colours
        waitForNote("colours of vertices");
        QVERIFY(!button("Export")->isEnabled());
    }

    void aComplaintLeavesTheFieldsTheirPlaces()
    {
        choose("Piece", 2);
        choose("Detail", 1);
        dialog_->setFile(folder_->filePath("cloth.usda"));
        waitForNote("hold curves");
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
        int bottom = 0;
        for (const QComboBox* box : dialog_->findChildren<QComboBox*>()) {
            QVERIFY2(box->isVisible() && box->height() >= box->minimumSizeHint().height(), qPrintable(box->accessibleName()));
            QVERIFY2(box->y() >= bottom, qPrintable(box->accessibleName()));
            bottom = box->geometry().bottom();
        }
        QVERIFY(named<QuantityEdit>("Samples per crossing")->y() > bottom);
    }

    void cancellingLeavesWhatWasThere()
    {
        QFile old(folder_->filePath("cloth.ply"));
        QVERIFY(old.open(QIODevice::WriteOnly));
        old.write("as it was");
        old.close();
        choose("Detail", 2);
        choose("Piece", 1);
        type("Width along the weft", "15");
        type("Height along the warp", "15");
        dialog_->setFile(old.fileName());
        QSignalSpy ended(dialog_.get(), &ExportDialog::ended);
        QTimer::singleShot(0, this, [] {
            if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) { box->button(QMessageBox::Ok)->click(); }
        });
        button("Export")->click();
        QVERIFY(dialog_->writing());
        QTest::qWait(100); // the window lives on meanwhile
        dialog_->reject();
        QVERIFY(dialog_->isVisible());
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, 10000);
        QVERIFY(text("Result of the export").startsWith("Cancelled."));
        QCOMPARE(QDir(folder_->path()).entryList(QDir::Files | QDir::Hidden), QStringList{"cloth.ply"});
        QCOMPARE(contents("cloth.ply"), QByteArray("as it was"));
        type("Width along the weft", "14"); // another choice: what was said of the last one goes
        QCOMPARE(text("Result of the export"), QString());
    }

    void cancellingAtOnceEndsIt()
    {
        choose("Detail", 2); // more than is written before one can cancel
        choose("Piece", 1);
        type("Width along the weft", "15");
        type("Height along the warp", "15");
        dialog_->setFile(folder_->filePath("cloth.ply"));
        for (int i = 0; i < 20; ++i) {
            QSignalSpy ended(dialog_.get(), &ExportDialog::ended);
            dialog_->start();
            QVERIFY(dialog_->writing());
            dialog_->cancel();
            QVERIFY(!button("Cancelling…")->isEnabled());
            QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, 10000);
            QVERIFY(!dialog_->writing());
            QVERIFY(button("Close")->isEnabled());
            QVERIFY(QDir(folder_->path()).isEmpty(QDir::Files | QDir::Hidden));
        }
    }

    void filesBesideTheMainOneAreReplacedOnlyWhenAgreed()
    {
        for (const char* name : {"cloth.mtl", "cloth.bin"}) {
            QFile other(folder_->filePath(name));
            QVERIFY(other.open(QIODevice::WriteOnly));
            other.write("of another program");
        }
        for (const auto& [name, beside] : {std::pair("cloth.obj", "cloth.mtl"), std::pair("cloth.gltf", "cloth.bin")}) {
            dialog_->setFile(folder_->filePath(name));
            for (const bool estimated : {false, true}) {
                if (estimated) { waitForText("Size of the export", "about"); }
                const QString asked = startAnswering(QMessageBox::Cancel);
                QVERIFY2(asked.startsWith(QString(beside) + " already exists."), qPrintable(asked));
                QVERIFY(!dialog_->writing());
                QCOMPARE(contents(beside), QByteArray("of another program"));
            }
        }
    }

    void agreeingHoldsForOneExport()
    {
        dialog_->setFile(folder_->filePath("cloth.obj"));
        write();
        const QString asked = startAnswering(QMessageBox::Cancel);
        QVERIFY2(asked.startsWith("cloth.obj and cloth.mtl already exist."), qPrintable(asked));
        QVERIFY(!dialog_->writing());
    }

    void aNameWithAFolderStaysWhereItIs()
    {
        QVERIFY(QDir(folder_->path()).mkpath("a/a"));
        dialog_->setFile(folder_->filePath("first.ply"));
        write();
        dialog_->setFile("a/cloth.ply"); // in the folder of the one before
        write();
        QVERIFY(QFile::exists(folder_->filePath("a/cloth.ply")));
        QCOMPARE(text("File"), QDir::toNativeSeparators(folder_->filePath("a/cloth.ply")));
        QVERIFY(startAnswering(QMessageBox::Ok).startsWith("cloth.ply already exists."));
        QTRY_VERIFY_WITH_TIMEOUT(!dialog_->writing(), 10000);
        QVERIFY(!QFile::exists(folder_->filePath("a/a/cloth.ply")));
    }

    void aSampleThatCannotBeIsRefused()
    {
        dialog_->setFile(folder_->filePath("cloth.ply"));
        choose("Piece", 2);
        document_.edit("sample", {}, [](Design& design) { design.experiments[0].sample_mm[0] = 1e12; });
        QTRY_VERIFY_WITH_TIMEOUT(!button("Export")->isEnabled(), 5000);
        const auto labels = dialog_->findChildren<QLabel*>();
        QVERIFY(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) { return label->text().contains("sample's size"); }));
        document_.edit("sample", {}, [](Design& design) { design.experiments[0].sample_mm[0] = 2; });
        QTRY_VERIFY_WITH_TIMEOUT(button("Export")->isEnabled(), 5000);
    }

    void namesAreShownAsTheyAre()
    {
        document_.edit("name", {}, [](Design& design) { design.fabrics[0].name = "<b>cloth</b>"; });
        dialog_->setFile(folder_->filePath("nowhere<br>/cloth.ply"));
        waitForNote("nowhere<br>");
        dialog_->setFile(folder_->filePath("a<i>b.gltf"));
        write();
        for (const QLabel* label : dialog_->findChildren<QLabel*>()) {
            QVERIFY2(label->textFormat() == Qt::PlainText || !Qt::mightBeRichText(label->text()), qPrintable(label->text()));
        }
        Qt::TextFormat format = Qt::AutoText;
        QVERIFY(startAnswering(QMessageBox::Cancel, &format).contains("a<i>b.gltf"));
        QCOMPARE(format, Qt::PlainText);
    }

    void aFileIsReplacedOnlyWhenAgreed()
    {
        QFile old(folder_->filePath("cloth.ply"));
        QVERIFY(old.open(QIODevice::WriteOnly));
        old.close();
        dialog_->setFile(old.fileName());
        bool byDefault = false;
        QTimer::singleShot(0, this, [&byDefault] {
            if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                byDefault = box->defaultButton() == box->button(QMessageBox::Cancel);
                box->button(QMessageBox::Cancel)->click();
            }
        });
        dialog_->start();
        QVERIFY(byDefault);
        QVERIFY(!dialog_->writing());
        QVERIFY(contents("cloth.ply").isEmpty());
    }

    void whatCannotBeIsRefusedInASentence()
    {
        dialog_->setFile(folder_->filePath("cloth.obj"));
        type("Repeats along the weft", "0");
        waitForNote("Allowed: 1 to");
        QVERIFY(!button("Export")->isEnabled());
        type("Repeats along the weft", "1.5");
        waitForNote("“1.5” is not a whole number.");
        QVERIFY(!button("Export")->isEnabled());
        type("Repeats along the weft", "many");
        waitForNote("does not begin with a number");
        type("Repeats along the weft", "60000");
        waitForNote("These repeats have");
        type("Repeats along the weft", "1");
        type("Sides", "2");
        waitForNote("Allowed: 3 to");
        type("Sides", "");
        choose("Format", 2); // STL
        choose("Detail", 0);
        waitForNote("STL files are written with triangles only");
        QVERIFY(!button("Export")->isEnabled());
        choose("Detail", 1);
        dialog_->setFile(folder_->filePath("nowhere/cloth.stl"));
        waitForNote("does not exist");
        dialog_->setFile(folder_->filePath("cloth.stl"));
        QTRY_VERIFY_WITH_TIMEOUT(button("Export")->isEnabled(), 5000);
        document_.edit("ends", {}, [](Design& design) { design.fabrics[0].ends_per_cm = -1; });
        waitForNote("This fabric has an error");
        QVERIFY(!button("Export")->isEnabled());
    }

    void formatAndEndingGoTogether()
    {
        choose("Format", 3);
        QVERIFY(text("File").endsWith(".glb"));
        dialog_->setFile(folder_->filePath("cloth.usda"));
        QCOMPARE(dialog_->findChildren<QComboBox*>().at(0)->currentData().toString(), QString(".usda"));
        choose("Format", 1);
        QCOMPARE(text("File"), folder_->filePath("cloth.ply"));
    }

    void theChoiceIsRemembered()
    {
        choose("Format", 4);
        choose("Detail", 2);
        choose("Piece", 1);
        type("Width along the weft", "7.5");
        type("Samples per crossing", "20");
        dialog_->findChild<QCheckBox*>()->setChecked(false);
        dialog_->reject();
        dialog_ = std::make_unique<ExportDialog>(document_, playback_);
        dialog_->show();
        QCOMPARE(dialog_->findChildren<QComboBox*>().at(0)->currentIndex(), 4);
        QCOMPARE(dialog_->findChildren<QComboBox*>().at(1)->currentIndex(), 2);
        QCOMPARE(dialog_->findChildren<QComboBox*>().at(2)->currentIndex(), 1);
        QCOMPARE(named<QuantityEdit>("Width along the weft")->value(), std::optional<double>(7.5));
        QCOMPARE(named<QuantityEdit>("Samples per crossing")->value(), std::optional<double>(20));
        QVERIFY(!dialog_->findChild<QCheckBox*>()->isChecked());
    }

private:
    template <typename Widget> Widget* named(const QString& name)
    {
        for (Widget* widget : dialog_->findChildren<Widget*>()) {
            if (widget->accessibleName() == name) { return widget; }
        }
        return nullptr;
    }

    QPushButton* button(const QString& words)
    {
        for (QPushButton* button : dialog_->findChildren<QPushButton*>()) {
            if (button->text().remove('&') == words) { return button; }
        }
        return nullptr;
    }

    void choose(const QString& box, int row) { named<QComboBox>(box)->setCurrentIndex(row); }

    void type(const QString& field, const QString& words)
    {
        auto* edit = named<QuantityEdit>(field);
        edit->selectAll();
        if (words.isEmpty()) { QTest::keyClick(edit, Qt::Key_Delete); }
        QTest::keyClicks(edit, words);
    }

    QString text(const QString& name)
    {
        if (const auto* label = named<QLabel>(name)) { return label->text(); }
        return named<QLineEdit>(name)->text();
    }

    void waitForText(const QString& name, const QString& words)
    {
        QTRY_VERIFY2_WITH_TIMEOUT(text(name).contains(words), qPrintable(words + " in " + text(name)), 5000);
    }

    void waitForNote(const QString& words)
    {
        const auto shown = [&] {
            const auto labels = dialog_->findChildren<QLabel*>();
            return std::any_of(labels.begin(), labels.end(),
                               [&](const QLabel* label) { return label->isVisible() && label->text().contains(words); });
        };
        QTRY_VERIFY2_WITH_TIMEOUT(shown(), qPrintable(words), 5000);
    }

    void write()
    {
        QSignalSpy ended(dialog_.get(), &ExportDialog::ended);
        QTRY_VERIFY_WITH_TIMEOUT(button("Export")->isEnabled(), 5000);
        button("Export")->click();
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, 20000);
    }

    /// Starts the export and presses this button when it asks; returns the question.
    QString startAnswering(QMessageBox::StandardButton answer, Qt::TextFormat* format = nullptr)
    {
        QString question;
        QObject meanwhile;
        QTimer::singleShot(0, &meanwhile, [&] {
            if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                question = box->text();
                if (format) { *format = box->textFormat(); }
                box->button(answer)->click();
            }
        });
        dialog_->start();
        return question;
    }

    QByteArray contents(const QString& name)
    {
        QFile file(folder_->filePath(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("there is none");
    }

    /// The same as the dialog's fields say, made by hand.
    MeshExport coreExport()
    {
        const auto number = [&](const char* name) { return *named<QuantityEdit>(name)->typed(nullptr); };
        const Fabric& fabric = *document_.fabric();
        const bool sized = named<QComboBox>("Piece")->currentIndex() == 1;
        const TextileRegion region = sized ? region_of_sample(fabric, number("Width along the weft"), number("Height along the warp"))
                                           : region_of_repeats(fabric, static_cast<int>(number("Repeats along the weft")),
                                                               static_cast<int>(number("Repeats along the warp")));
        MeshExport made{fabric, build_textile(*document_.design(), fabric, region), {}, 0};
        made.options.mesh = smooth_request(made.textile, static_cast<MeshDetail>(named<QComboBox>("Detail")->currentIndex()));
        return made;
    }

    ExportEstimate coreEstimate(MeshFormat format)
    {
        const MeshExport made = coreExport();
        return export_estimate(made.textile, made.fabric, made.options, format);
    }

    QTemporaryDir settings_;
    std::unique_ptr<QTemporaryDir> folder_;
    Document document_;
    Playback playback_;
    std::unique_ptr<ExportDialog> dialog_;
};

QTEST_MAIN(TestExportDialog)
#include "tst_export_dialog.moc"
