// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Yarn for a metre of cloth and the cloth on its loom, against trade examples.
#include "core/laboratory/technical.h"

#include "core/base/units.h"
#include "tests/room/square_cotton.h"

#include <QTest>

#include <cmath>

using namespace hygroloom;

namespace {

TechnicalCard card_of_fabric(const Fabric& fabric, const CardRequest& request = {})
{
    return technical_card(fabric, fit_fabric({}, fabric), request);
}
Fabric poplin() { return library_fabric("Poplin shirting"); }

} // namespace

class TestTechnical : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void yarnWeighsAsMuchAsTheCloth_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"Poplin shirting", "Denim", "Cotton sateen", "Sports micro-twill", "F"}) QTest::newRow(name) << name;
    }
    void yarnWeighsAsMuchAsTheCloth()
    {
        QFETCH(QString, name);
        const Fabric& fabric = library_fabric(name.toStdString());
        const TechnicalCard card = card_of_fabric(fabric, {140});
        const double mass = quantities_in_use({}, fabric).areal_density_g_m2;
        QVERIFY2(near_to(card.grams_per_metre / 1.40, mass, 1e-3), qPrintable(QString("%1 %2").arg(card.grams_per_metre / 1.40).arg(mass)));
    }
    /// Aera Tex: 5400 ends of 100 denier weigh 60.00 g a metre, with 10 % more yarn 66.0 g.
    void endsOfHundredDenierWeighAsTheTradeSays()
    {
        Fabric fabric = poplin();
        fabric.warp.linear_density_tex = tex_from_denier(100);
        fabric.warp_crimp_percent = 0;
        fabric.ends_per_cm = 54; // on 100 cm
        const auto warp_grams = [&](double waste) {
            const TechnicalCard card = card_of_fabric(fabric, {100, waste});
            QVERIFY2(card.ends == 5400, qPrintable(QString::number(card.ends)));
            const YarnConsumption& warp = card.yarns.front();
            QVERIFY(near_to(warp.grams_per_metre / (1 + 0.01 * warp.crimp_percent), 60 * (1 + 0.01 * waste), 1e-4));
        };
        warp_grams(0);
        warp_grams(10);
    }
    /// Brooks, The Weight of a Piece: 2280 ends of 30s over 38 yd are 103 1/7 hanks and 3 lb 7 oz; as many picks' worth of 36s in the
    /// reed's width 2 lb 13 3/4 oz.
    void hanksOfAPieceWeighAsBrooksSays()
    {
        constexpr double yard = 0.9144, pound = 453.59237, ounces = 16;
        Fabric fabric = poplin();
        fabric.warp.linear_density_tex = tex_from_ne(30);
        fabric.weft.linear_density_tex = tex_from_ne(36);
        fabric.ends_per_cm = 2280 / (38 * 2.54);
        fabric.picks_per_cm = fabric.ends_per_cm;
        fabric.loom.reed_width_cm = 38 * 2.54;
        const TechnicalCard card = card_of_fabric(fabric, {38 * 2.54});
        const auto piece = [&](const YarnConsumption& use, double longer) {
            return use.grams_per_metre / longer * 38 * yard / pound * ounces;
        };
        const YarnConsumption &warp = card.yarns[0], &weft = card.yarns[1];
        QVERIFY2(std::abs(piece(warp, 1 + 0.01 * warp.crimp_percent) - (3 * 16 + 7)) < 0.1, qPrintable(QString::number(piece(warp, 1))));
        QVERIFY2(std::abs(piece(weft, 1) - (2 * 16 + 13.75)) < 0.15, qPrintable(QString::number(piece(weft, 1))));
    }
    /// Poplin of 52.4 x 28.3 on 150 cm that shrinks by 6 % in width and 3 % in length: 7860 ends in a reed of 159 cm.
    void aPoplinLiesOnTheLoomAsWorkedByHand()
    {
        Fabric fabric = poplin();
        fabric.ends_per_cm = 52.4;
        fabric.picks_per_cm = 28.3;
        fabric.loom.reed_width_cm = 159;
        fabric.loom.picks_per_cm = 28.3 / 1.03;
        fabric.loom.ends_per_dent = 2;
        const LoomState loom = loom_state(fabric, 150);
        QVERIFY(near_to(*loom.ends_per_cm, 49.4, 1e-3));
        QVERIFY(near_to(*loom.dents_per_10_cm, 247, 1e-3));
        QVERIFY(near_to(*loom.width_shrinks_percent, 6, 1e-9));
        QVERIFY(near_to(*loom.length_shrinks_percent, 3, 1e-9));
    }
    void loomAndFinishedStateGoBackAndForth()
    {
        Fabric fabric = poplin();
        fabric.loom.ends_per_cm = 49.4;
        const double reed = *loom_state(fabric, 150).reed_width_cm;
        fabric.loom.ends_per_cm.reset();
        fabric.loom.reed_width_cm = reed;
        QVERIFY(near_to(*loom_state(fabric, 150).ends_per_cm, 49.4, 1e-12));
        QVERIFY(!loom_state(poplin(), 150).reed_width_cm && !loom_state(poplin(), 150).dents_per_10_cm);
    }
    void widthFollowsFromTheReedAndContradictionsAreTold()
    {
        Fabric fabric = poplin();
        fabric.loom.reed_width_cm = 106;
        TechnicalCard card = card_of_fabric(fabric);
        QVERIFY(near_to(card.width_cm, 100, 1e-9) && card.notes.front().find("not given") != std::string::npos);
        fabric.loom.ends_per_cm = fabric.ends_per_cm / 1.04;
        card = card_of_fabric(fabric);
        QVERIFY(near_to(card.width_cm, 106 / 1.04, 1e-9) && near_to(*card.loom.width_shrinks_percent, 4, 1e-9));
        QCOMPARE(card.ends, std::round(card.ends));
        const auto told = [](const TechnicalCard& of, const char* words) {
            return std::any_of(of.notes.begin(), of.notes.end(),
                               [&](const std::string& note) { return note.find(words) != std::string::npos; });
        };
        QVERIFY(!told(card, "is wrong"));
        card = card_of_fabric(fabric, {150});
        QVERIFY(told(card, "is wrong") && told(card, "does not come from a reed of 106 cm"));
        QVERIFY(!told(card, "picks/cm on the loom"));
        fabric.loom.picks_per_cm = 2 * fabric.picks_per_cm;
        QVERIFY(told(card_of_fabric(fabric), "picks/cm on the loom"));
        fabric.warp.price = 0;
        fabric.weft.price = 0;
        QVERIFY(!card_of_fabric(fabric).yarn_cost_per_metre); // nobody's price
    }
    void costsAreTheSumOfTheirLinesAndNoneWithoutPrices()
    {
        Fabric fabric = poplin();
        QVERIFY(!card_of_fabric(fabric).yarn_cost_per_metre);
        fabric.warp.price = 6.5;
        QVERIFY(!card_of_fabric(fabric).yarn_cost_per_metre);
        fabric.weft.price = 6.5;
        const TechnicalCard card = card_of_fabric(fabric, {150, 5, 4});
        QVERIFY(near_to(*card.yarn_cost_per_metre, 6.5e-3 * card.grams_per_metre, 1e-12));
        QVERIFY(card.grams_per_metre > 1.05 * card_of_fabric(fabric, {150}).grams_per_metre);
    }
    void pricesAndLoomsMakeNoOtherCloth()
    {
        Fabric fabric = poplin();
        const FabricQuantities before = quantities_in_use({}, fabric);
        fabric.warp.price = 3;
        fabric.loom.reed_width_cm = 160;
        QCOMPARE(quantities_in_use({}, fabric).areal_density_g_m2, before.areal_density_g_m2);
    }
    /// Of a cloth that is said to be so thin that its weft is nearly straight. A crimp that is given was measured.
    void calculatedTakeUpFarFromTaylorsRuleIsTold()
    {
        Fabric fabric = poplin();
        fabric.warp_crimp_percent.reset();
        fabric.weft_crimp_percent.reset();
        const auto notes = [&fabric] {
            int of_weft = 0;
            for (const std::string& note : card_of_fabric(fabric).notes) of_weft += note.find("of the weft") != std::string::npos;
            return of_weft;
        };
        fabric.thickness_mm.reset();
        QCOMPARE(notes(), 0);
        fabric.thickness_mm = 0.26;
        QCOMPARE(notes(), 1);
        fabric.weft_crimp_percent = fit_fabric({}, fabric).derived.weft.crimp_percent;
        QCOMPARE(notes(), 0);
    }
};

QTEST_APPLESS_MAIN(TestTechnical)
#include "tst_technical.moc"
