// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The project's own fibres: made from a yarn's, edited, renamed and deleted in the window, and undone.
#include "ui/panels/fabric_panel.h"
#include "ui/panels/fibre_panel.h"
#include "ui/window/examples.h"

#include <QDir>
#include <QLabel>
#include <QTest>
#include <QToolButton>

using namespace hygroloom;

class TestFibrePanel : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        document_ = std::make_unique<Document>();
        QVERIFY(document_->openExample(QDir(examplesFolder()).filePath("laboratory.hygro")));
        document_->edit("yarns", {}, [](Design& d) {
            d.fabrics[0].warp.material = {{"polyester", 0.65}, {"cotton", 0.35}};
            d.fabrics[0].weft = d.fabrics[0].warp;
        });
        panel_ = std::make_unique<FabricPanel>(*document_);
        panel_->resize(330, 700);
        panel_->show();
        QVERIFY(QTest::qWaitForWindowExposed(panel_.get()));
    }
    void cleanup()
    {
        panel_.reset();
        document_.reset();
    }

    void aYarnsFibreBecomesOnesOwn()
    {
        QVERIFY(document_->design()->materials.empty());
        QVERIFY(!fibres()->section().heading->isChecked());
        press("Own fibre from the yarn's");
        const Design made = *document_->design();
        QCOMPARE(made.materials.size(), std::size_t(1));
        QCOMPARE(made.materials[0].name, std::string("polyester 2"));
        QCOMPARE(made.materials[0].based_on, std::string("polyester"));
        QCOMPARE(made.fabrics[0].warp.material[0].name, std::string("polyester 2"));
        QCOMPARE(made.fabrics[0].weft, made.fabrics[0].warp); // which was the same
        QVERIFY(fibres()->section().heading->isChecked());
        QCOMPARE(button("Own fibre from the yarn's")->text(), QString("Edit…"));
        press("Own fibre from the yarn's"); // shows it, and makes no other
        QCOMPARE(*document_->design(), made);
        press("Own fibre from the blended one");
        QCOMPARE(document_->design()->fabrics[0].warp.material[1].name, std::string("cotton 2"));
        document_->history()->undo();
        document_->history()->undo();
        QVERIFY(document_->design()->materials.empty());
        QCOMPARE(document_->design()->fabrics[0].warp.material[0].name, std::string("polyester"));
    }

    void itsCrossSectionIsAShapeOrANumber()
    {
        press("Own fibre from the yarn's");
        auto* shape = choice("Cross-section");
        QVERIFY(shape->isVisible());
        QCOMPARE(shape->currentText(), QString("round"));
        shape->setCurrentIndex(1);
        Q_EMIT shape->activated(1);
        QCOMPARE(own().cross_section.shape, std::string("trilobal"));
        QCOMPARE(edit("perimeter of the fibre")->value(), std::optional(1.19));
        Q_EMIT edit("perimeter of the fibre")->edited(2.5, false);
        QCOMPARE(own().cross_section, (CrossSection{2.5, {}}));
        QCOMPARE(shape->currentText(), QString("own perimeter"));
        document_->history()->undo();
        QCOMPARE(shape->currentText(), QString("trilobal"));
    }

    void fieldsShowWhatIsWrong()
    {
        press("Own fibre from the yarn's");
        Q_EMIT edit("fibre's receding angle")->edited(170, false);
        QVERIFY(document_->hasError());
        QVERIFY(edit("fibre's receding angle")->toolTip().contains("cannot be above the contact angle"));
        document_->endStroke();
        Q_EMIT edit("fibre's receding angle")->edited(std::nullopt, false);
        QVERIFY(!document_->hasError());
        Q_EMIT edit("fibre's radius")->edited(9, false);
        QCOMPARE(own().fibre_radius_um, 9.0);
        QVERIFY(edit("fibre's radius")->text().endsWith("µm"));
    }

    /// A number would change nothing while the library's isotherm is used: the window says so, and offers the master curve.
    void aRegainOfOnesOwnNeedsTheMasterCurve()
    {
        press("Own fibre from the blended one");
        Q_EMIT edit("fibre's standard regain")->edited(0.12, false);
        QVERIFY(!document_->issuesAt("materials[0].isotherm").empty());
        Q_EMIT choice("Isotherm")->activated(1);
        QVERIFY(!own().gab.given());
        QVERIFY(document_->issuesAt("materials[0].isotherm").empty());
        Q_EMIT choice("Isotherm")->activated(0);
        QCOMPARE(own().gab, find_library_material("cotton")->gab);
    }

    /// As a project file gives them; choosing what is chosen leaves them, and the undo list, alone.
    void anIsothermsOwnNumbersAreSaidToBeItsOwn()
    {
        press("Own fibre from the blended one");
        QComboBox* isotherm = choice("Isotherm");
        QCOMPARE(isotherm->currentText(), QString("as the fibre it is based on"));
        QCOMPARE(isotherm->count(), 2);
        const GabIsotherm numbers{0.05, 9, 0.8};
        document_->edit("numbers", {}, [&](Design& d) { d.materials[0].gab = numbers; });
        document_->endStroke();
        QCOMPARE(isotherm->currentText(), QString("own numbers"));
        const int edits = document_->history()->index();
        Q_EMIT isotherm->activated(2);
        QCOMPARE(own().gab, numbers);
        QCOMPARE(document_->history()->index(), edits);
        Q_EMIT isotherm->activated(0);
        QCOMPARE(own().gab, find_library_material("cotton")->gab);
        QCOMPARE(isotherm->currentText(), QString("as the fibre it is based on"));
        Q_EMIT isotherm->activated(0);
        QCOMPARE(document_->history()->index(), edits + 1);
        document_->history()->undo();
        QCOMPARE(own().gab, numbers);
        QCOMPARE(isotherm->currentText(), QString("own numbers"));
    }

    void namesFollow()
    {
        press("Own fibre from the yarn's");
        QString why;
        QVERIFY(!fibres()->rename("wool", &why) && !why.isEmpty());
        QVERIFY(fibres()->rename("trilobal", &why));
        QCOMPARE(document_->design()->fabrics[0].weft.material[0].name, std::string("trilobal"));
        fibres()->removeFibre();
        QVERIFY(document_->design()->materials.empty());
        QCOMPARE(document_->design()->fabrics[0].weft.material[0].name, std::string("polyester"));
        QVERIFY(!document_->hasError());
    }

private:
    FibrePanel* fibres() { return panel_->findChild<FibrePanel*>(); }
    const Material& own() { return document_->design()->materials.at(0); }
    QuantityEdit* edit(const char* name) { return panel_->findChild<QuantityEdit*>(name); }
    template <typename Widget> Widget* named(const char* name)
    {
        for (Widget* widget : panel_->findChildren<Widget*>()) {
            if (widget->accessibleName() == name) { return widget; }
        }
        return nullptr;
    }
    QComboBox* choice(const char* name) { return named<QComboBox>(name); }
    QToolButton* button(const char* name) { return named<QToolButton>(name); } // the warp's, which comes first
    void press(const char* name) { button(name)->click(); }

    std::unique_ptr<Document> document_;
    std::unique_ptr<FabricPanel> panel_;
};

QTEST_MAIN(TestFibrePanel)
#include "tst_fibre_panel.moc"
