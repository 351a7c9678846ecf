// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The Garment workspace without its window: adding garments, cutting panels, the wearer, the experiment, the flat view.
#include "core/project/project_file.h"
#include "ui/basics/name_dialog.h"
#include "ui/basics/quantity_edit.h"
#include "ui/document/document.h"
#include "ui/document/recovery.h"
#include "ui/garment/fit_form.h"
#include "ui/garment/flat_view.h"
#include "ui/garment/garment_edits.h"
#include "ui/garment/garment_panel.h"
#include "ui/garment/garment_view.h"
#include "ui/garment/panel_table.h"
#include "ui/garment/wear_form.h"
#include "ui/garment/zones_form.h"
#include "ui/picture/viewport.h"
#include "ui/results/project_runs.h"
#include "ui/results/run_history.h"
#include "ui/window/examples.h"
#include "ui/window/run_workspace.h"

#include <QComboBox>
#include <QDir>
#include <QDropEvent>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolButton>

using namespace hygroloom;

class TestGarmentWorkspace : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        document_ = std::make_unique<Document>();
        recovery_ = std::make_unique<Recovery>(*document_, folder_.path());
        QVERIFY(document_->openExample(QDir(examplesFolder()).filePath("three-candidates.hygro")));
        window_ = std::make_unique<QMainWindow>();
        history_ = std::make_unique<RunHistory>();
        project_ = std::make_unique<ProjectRuns>(*document_, *recovery_, *history_);
        viewport_ = std::make_unique<Viewport>();
        run_ = std::make_unique<RunWorkspace>(*document_, *history_, *project_, queue_, *viewport_, *window_);
        run_->setSubject(Subject::garment);
        workspace_ = &run_->garment();
        window_->setCentralWidget(&workspace_->view());
        window_->resize(1000, 700);
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    }
    void cleanup()
    {
        run_.reset();
        viewport_.reset();
        window_.reset();
        project_.reset();
        history_.reset();
        recovery_.reset();
        document_.reset();
    }

    void anEmptyProjectOffersATee()
    {
        QPushButton* add = nullptr;
        for (auto* button : workspace_->view().findChildren<QPushButton*>()) {
            if (button->text().contains("tee")) { add = button; }
        }
        QVERIFY(add);
        QVERIFY(add->isVisible());
        add->click();
        QCOMPARE(document_->design()->garments.size(), std::size_t{1});
        QCOMPARE(document_->design()->wears.size(), std::size_t{1});
        QVERIFY(!document_->hasError());
        QTRY_VERIFY(workspace_->choice().drawing());
        QVERIFY(!add->isVisible());
        QCOMPARE(workspace_->panel().panels().rowCount(), static_cast<int>(workspace_->choice().drawing()->panels.size()));
        document_->history()->undo();
        QVERIFY(document_->design()->garments.empty() && document_->design()->wears.empty());
        QVERIFY(add->isVisible());
    }

    void aPanelIsCutFromAnotherFabric()
    {
        addTee();
        PanelTable& table = workspace_->panel().panels();
        const std::string panel = workspace_->choice().drawing()->panels[1].name;
        auto* fabric = qobject_cast<QComboBox*>(table.cellWidget(1, 1));
        QVERIFY(fabric->count() > 1);
        fabric->setCurrentIndex(1);
        Q_EMIT fabric->activated(1);
        QCOMPARE(garment().cut_of(panel)->fabric, document_->design()->fabrics[1].name);
        QCOMPARE(garment().cut_of("*")->fabric, document_->design()->fabrics[0].name);
        auto* grain = qobject_cast<QuantityEdit*>(table.cellWidget(1, 2));
        Q_EMIT grain->edited(45.0, false);
        QCOMPARE(garment().cut_of(panel)->grain_deg, 45.0);
        QCOMPARE(garment().cut_of(panel)->fabric, document_->design()->fabrics[1].name);
        document_->history()->undo();
        QCOMPARE(garment().cut_of(panel)->grain_deg, 0.0);
        document_->history()->undo();
        QCOMPARE(garment().cut_of(panel)->fabric, document_->design()->fabrics[0].name);
        QCOMPARE(fabric->currentIndex(), 0);
    }

    void aFabricIsDroppedOnAPanel()
    {
        addTee();
        FlatView& flat = workspace_->view().flat();
        const int panel = 0;
        const QPointF at = flat.pixelOf(middleOf(panel));
        QCOMPARE(flat.spotAt(at).panel, panel);
        const QString fabric = QString::fromStdString(document_->design()->fabrics[1].name);
        QMimeData data;
        data.setData(fabric_mime, fabric.toUtf8());
        QDragEnterEvent enter(at.toPoint(), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier); // without it no drop arrives
        QCoreApplication::sendEvent(&flat, &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&flat, &drop);
        QCOMPARE(garment().cut_of(workspace_->choice().drawing()->panels[panel].name)->fabric, fabric.toStdString());
        QCOMPARE(flat.picture().pixelColor((flat.pixelOf(cornerNear(panel))).toPoint()), fabricColor(1));
        document_->history()->undo();
        QCOMPARE(flat.picture().pixelColor((flat.pixelOf(cornerNear(panel))).toPoint()), fabricColor(0));
    }

    void panelsDoNotOverlapOnTheSheet()
    {
        addTee();
        const auto& panels = workspace_->choice().drawing()->panels;
        for (std::size_t a = 0; a < panels.size(); ++a) {
            for (std::size_t b = a + 1; b < panels.size(); ++b) {
                QVERIFY(!panels[a].path.boundingRect().intersects(panels[b].path.boundingRect()));
            }
        }
    }

    void zoomingKeepsThePlaceUnderThePointer()
    {
        addTee();
        FlatView& flat = workspace_->view().flat();
        const QPointF at = flat.pixelOf(middleOf(0));
        const GarmentSpot before = flat.spotAt(at);
        QWheelEvent wheel(at, flat.mapToGlobal(at), {}, {0, 240}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&flat, &wheel);
        const GarmentSpot after = flat.spotAt(at);
        QCOMPARE(after.panel, before.panel);
        QVERIFY(std::abs(after.flat[0] - before.flat[0]) < 1e-9 && std::abs(after.flat[1] - before.flat[1]) < 1e-9);
        QVERIFY((flat.pixelOf(cornerNear(0)) - at).manhattanLength() > 5);
    }

    void aFileThatIsNotThereIsReported()
    {
        addGarmentFile(*document_, "/nowhere/none.json");
        QTRY_VERIFY(!workspace_->choice().reading());
        QVERIFY(workspace_->choice().problem().contains("none.json"));
        bool shown = false;
        for (const QLabel* label : workspace_->view().findChildren<QLabel*>()) {
            shown = shown || (label->isVisible() && label->text() == workspace_->choice().problem());
        }
        QVERIFY(shown);
    }

    void aFileThatIsNoGarmentChangesNothing_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("words") << QByteArray("Dear all");
        QTest::newRow("another dialect") << QByteArray("{}");
    }
    void aFileThatIsNoGarmentChangesNothing()
    {
        QFETCH(QByteArray, text);
        for (const QString& name : {QString("letter.json"), QString("letter.obj"), QString("letter.txt")}) {
            QFile file(folder_.filePath(name));
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) > 0);
            file.close();
            QSignalSpy said(run_.get(), &RunWorkspace::problemFound);
            chooseFile(file.fileName());
            workspace_->panel().addFile();
            QTRY_COMPARE(said.count(), 1);
            QVERIFY2(said[0][0].toString().contains(name), qPrintable(said[0][0].toString()));
            QVERIFY(document_->design()->garments.empty());
            QVERIFY(!document_->history()->canUndo());
        }
        chooseFile(QString(HYGROLOOM_SOURCE_DIR) + "/tests/data/garments/tee.json");
        workspace_->panel().addFile();
        QTRY_COMPARE(document_->design()->garments.size(), std::size_t{1});
        QTRY_VERIFY(workspace_->choice().drawing());
    }

    void theSizeOfATeeChangesItsPanels()
    {
        addTee();
        const double before = workspace_->choice().drawing()->sheet.height();
        editGarment(*document_, "length", 0, "length_mm", [](Garment& g) { g.built_in.length_mm = 900; });
        QTRY_VERIFY(workspace_->choice().drawing()->sheet.height() > before + 0.1);
    }

    void activityIsAddedAndRemoved()
    {
        addTee();
        WearForm& wear = workspace_->wear();
        wear.addActivity();
        QCOMPARE(document_->design()->wears[0].activity.size(), std::size_t{2});
        QCOMPARE(document_->design()->wears[0].activity[1].time_s, 900.0);
        QVERIFY(!document_->hasError());
        auto* table = wear.findChild<QTableWidget*>();
        Q_EMIT qobject_cast<QuantityEdit*>(table->cellWidget(1, 1))->edited(0.2, false);
        QCOMPARE(document_->design()->wears[0].activity[1].factor, 0.2);
        wear.removeActivity();
        QCOMPARE(document_->design()->wears[0].activity.size(), std::size_t{1});
        document_->history()->undo();
        QCOMPARE(document_->design()->wears[0].activity[1].factor, 0.2);
    }

    void gapsAreSetZoneByZone()
    {
        addTee();
        FitForm& fit = workspace_->fit();
        QVERIFY(!fit.gapOf("elbow"));
        QuantityEdit* chest = fit.gapOf("chest");
        QVERIFY(chest && !chest->value());
        Q_EMIT chest->edited(12.0, false);
        QCOMPARE(garment().gap_of("chest"), 12.0);
        QCOMPARE(garment().gap_of("back"), 3.0);
        QCOMPARE(chest->value(), std::optional(12.0));
        Q_EMIT chest->edited(std::nullopt, false);
        QCOMPARE(garment().gap_of("chest"), 3.0);
        QVERIFY(!garment().wearer.gap_mm.contains("chest"));
        document_->history()->undo();
        QCOMPARE(garment().gap_of("chest"), 12.0);
        document_->history()->undo();
        QCOMPARE(garment().gap_of("chest"), 3.0);
        Q_EMIT fit.gapOf("default")->edited(7.0, false);
        QCOMPARE(garment().gap_of("back"), 7.0);
        QVERIFY(!document_->hasError());
    }

    void seamsPassTheirShares()
    {
        addTee();
        FitForm& fit = workspace_->fit();
        const auto& drawing = *workspace_->choice().drawing();
        QVERIFY(!drawing.sewn.empty());
        QuantityEdit* side = fit.seamOf("front", "back");
        QVERIFY(side && side == fit.seamOf("back", "front"));
        Q_EMIT side->edited(0.0, false);
        QCOMPARE(garment().seam_between("front", "back"), 0.0);
        for (const auto& [one, other] : drawing.sewn) {
            const std::string &a = drawing.panels[static_cast<std::size_t>(one)].name,
                              &b = drawing.panels[static_cast<std::size_t>(other)].name;
            QVERIFY(fit.seamOf(a, b));
            const bool is_side = (a == "front" && b == "back") || (a == "back" && b == "front");
            QCOMPARE(garment().seam_between(a, b), is_side ? 0.0 : 1.0);
        }
        Q_EMIT fit.seamOf()->edited(0.5, false);
        QCOMPARE(garment().seams.at("default"), 0.5);
        QCOMPARE(garment().seam_between("front", "back"), 0.0);
        Q_EMIT side->edited(std::nullopt, false);
        QCOMPARE(garment().seam_between("back", "front"), 0.5);
        QVERIFY(!document_->hasError());
        document_->history()->undo();
        QCOMPARE(garment().seam_between("front", "back"), 0.0);
    }

    /// A project may name a seam in the other order; it stays one.
    void aZoneIsDrawnOnAFlatPanel()
    {
        addTee();
        FlatView& flat = workspace_->view().flat();
        ZonesForm& form = workspace_->fit().ownZones();
        const auto click = [&](const QPointF& at) { QTest::mouseClick(&flat, Qt::LeftButton, {}, at.toPoint()); };
        const QPointF middle = flat.pixelOf(middleOf(0));
        form.drawButton().click();
        QVERIFY(flat.outlining());
        click(middle + QPointF(-15, 10));
        click(middle + QPointF(15, 10));
        click(middle + QPointF(25, 15)); // taken back
        QTest::keyClick(&flat, Qt::Key_Backspace);
        click(middle + QPointF(15, -20));
        click(flat.pixelOf(middleOf(1))); // another panel's place
        click(middle + QPointF(-15, -20));
        QVERIFY(garment().wearer.own_zones.empty());
        click(middle + QPointF(-15, 10)); // the first corner closes it
        QCOMPARE(garment().wearer.own_zones.size(), std::size_t{1});
        QVERIFY(!flat.outlining() && !form.drawButton().isChecked());
        const OwnZone zone = garment().wearer.own_zones[0];
        QCOMPARE(zone.panel, workspace_->choice().drawing()->panels[0].name);
        QCOMPARE(zone.outline_mm.size(), std::size_t{4});
        const GarmentSpot corner = flat.spotAt((middle + QPointF(15, -20)).toPoint());
        QVERIFY(std::abs(zone.outline_mm[2][0] - 1e3 * corner.flat[0]) < 1e-2 &&
                std::abs(zone.outline_mm[2][1] - 1e3 * corner.flat[1]) < 1e-2);
        QVERIFY(!document_->hasError());
        document_->history()->undo();
        QVERIFY(garment().wearer.own_zones.empty());
        document_->history()->redo();

        form.drawButton().click();
        click(middle);
        QTest::keyClick(&flat, Qt::Key_Escape);
        QVERIFY(!flat.outlining());
        QCOMPARE(garment().wearer.own_zones.size(), std::size_t{1});
        QCOMPARE(form.table().rowCount(), 1);
        auto* rate = qobject_cast<QuantityEdit*>(form.table().cellWidget(0, 1));
        Q_EMIT rate->edited(1500.0, false);
        QCOMPARE(garment().wearer.own_zones[0].sweat_g_m2_h, 1500.0);
        QVERIFY(whyNotZoneName(garment(), 0, "chest").contains("zone of the body"));
        QVERIFY(whyNotZoneName(garment(), -1, QString::fromStdString(zone.name)).contains("already exists"));
        form.table().selectRow(0);
        form.removeSelected();
        QVERIFY(garment().wearer.own_zones.empty());
        QCOMPARE(form.table().rowCount(), 0);
        document_->history()->undo();
        QCOMPARE(garment().wearer.own_zones[0].sweat_g_m2_h, 1500.0);
    }

    void aSeamKeepsTheOrderOfTheProject()
    {
        addTee();
        editGarment(*document_, "taped", 0, {}, [](Garment& edited) { edited.seams = {{"back|front", 0.25}, {"front|collar", 0.5}}; });
        QuantityEdit* side = workspace_->fit().seamOf("front", "back");
        QCOMPARE(side->value(), std::optional(0.25));
        Q_EMIT side->edited(0.75, false);
        QCOMPARE(garment().seams, (std::map<std::string, double>{{"back|front", 0.75}, {"front|collar", 0.5}}));
        Q_EMIT side->edited(std::nullopt, false);
        QCOMPARE(garment().seams, (std::map<std::string, double>{{"front|collar", 0.5}}));
    }

    void removingAGarmentRemovesItsExperiments()
    {
        addTee();
        addBuiltInGarment(*document_, "leggings");
        QCOMPARE(document_->design()->wears.size(), std::size_t{2});
        workspace_->choice().setGarmentIndex(0);
        workspace_->panel().removeChosen();
        QCOMPARE(document_->design()->wears.size(), std::size_t{1});
        QCOMPARE(document_->design()->wears[0].garment, std::string("leggings"));
        QVERIFY(!document_->hasError());
    }

    void experimentsFollowTheNameOfTheirGarment()
    {
        addTee();
        renameGarment(*document_, 0, " running shirt ");
        QCOMPARE(garment().name, std::string("running shirt"));
        QCOMPARE(document_->design()->wears[0].garment, std::string("running shirt"));
        QVERIFY(!document_->hasError());
        QVERIFY(workspace_->choice().wear());
        addBuiltInGarment(*document_, "tee");
        renameGarment(*document_, 1, "running shirt"); // taken
        QCOMPARE(document_->design()->garments[1].name, std::string("tee"));
        renameWear(*document_, 0, "race");
        QCOMPARE(document_->design()->wears[0].name, std::string("race"));
    }

    void aTakenNameStaysInItsFieldWithTheReason()
    {
        addTee();
        addBuiltInGarment(*document_, "leggings"); // stands second; the tee is the chosen one
        QToolButton* rename = nullptr;
        for (auto* button : workspace_->panel().findChildren<QToolButton*>()) {
            if (button->accessibleName() == "Rename the garment") { rename = button; }
        }
        QVERIFY(rename);
        bool met = false;
        QTimer::singleShot(0, this, [&met] {
            auto* dialog = qobject_cast<NameDialog*>(QApplication::activeModalWidget());
            QVERIFY(dialog);
            auto* field = dialog->findChild<QLineEdit*>();
            QCOMPARE(field->text(), QString("tee"));
            const QSize size = dialog->size();
            QTest::keyClicks(field, " leggings");
            QVERIFY2(dialog->complaint().contains("“leggings” already exists"), qPrintable(dialog->complaint()));
            QTest::keyClick(field, Qt::Key_Return);
            QVERIFY(dialog->isVisible());
            QCOMPARE(field->text(), QString(" leggings"));
            QCOMPARE(dialog->size(), size);
            QTest::keyClick(field, Qt::Key_2);
            QVERIFY(dialog->complaint().isEmpty());
            QTest::keyClick(field, Qt::Key_Return);
            QVERIFY(!dialog->isVisible());
            met = true;
        });
        rename->click();
        QVERIFY(met);
        QCOMPARE(garment().name, std::string("leggings2"));
        document_->history()->undo();
        QCOMPARE(garment().name, std::string("tee"));
        const QString other = QString::fromStdString(document_->design()->experiments[0].name);
        QVERIFY(whyNotWearName(*document_->design(), 0, other).contains(other));
        QVERIFY(whyNotWearName(*document_->design(), 0, "wear").isEmpty()); // its own
        QVERIFY(!whyNotGarmentName(*document_->design(), 0, "  ").isEmpty());
    }

private:
    /// Gives the next file dialog this path.
    void chooseFile(const QString& path)
    {
        auto* timer = new QTimer(this);
        connect(timer, &QTimer::timeout, this, [timer, path] {
            auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            if (!dialog) { return; }
            timer->stop();
            timer->deleteLater();
            dialog->findChild<QLineEdit*>()->setText(path);
            QMetaObject::invokeMethod(dialog, "accept");
        });
        timer->start(50);
    }
    const Garment& garment() const { return document_->design()->garments.front(); }
    void addTee()
    {
        workspace_->choice().setGarmentIndex(addBuiltInGarment(*document_, "tee"));
        QTRY_VERIFY(workspace_->choice().drawing());
        QCoreApplication::processEvents();
    }
    GarmentSpot spot(int panel, double up) const
    {
        const DrawnPanel& drawn = workspace_->choice().drawing()->panels[static_cast<std::size_t>(panel)];
        const QRectF box = drawn.path.boundingRect();
        return {panel, {box.center().x() - drawn.on_sheet[0], box.top() + up * box.height() - drawn.on_sheet[1]}};
    }
    GarmentSpot middleOf(int panel) const { return spot(panel, 0.5); }
    /// Below the name and the arrow.
    GarmentSpot cornerNear(int panel) const { return spot(panel, 0.06); }

    QTemporaryDir folder_;
    std::unique_ptr<Document> document_;
    std::unique_ptr<Recovery> recovery_;
    std::unique_ptr<RunHistory> history_;
    std::unique_ptr<ProjectRuns> project_;
    std::unique_ptr<QMainWindow> window_;
    WindowQueue queue_;
    std::unique_ptr<Viewport> viewport_;
    std::unique_ptr<RunWorkspace> run_;
    GarmentSubject* workspace_ = nullptr; ///< of it
};

QTEST_MAIN(TestGarmentWorkspace)
#include "tst_garment_workspace.moc"
