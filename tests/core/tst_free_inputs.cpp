// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/base/error.h"
#include "core/design/free_inputs.h"
#include "core/design/validate.h"
#include "core/project/project_file.h"
#include "core/verify/set_ups.h"

#include <QTest>

#include <functional>

using namespace hygroloom;

namespace tst_free_inputs {
namespace {

/// Of cotton with a finish whose contact angle is given as 35 degrees and known within 20.
Design cloth()
{
    Design design = drop_on_cotton(3, 2, 35);
    Fabric& fabric = design.fabrics[0];
    fabric.name = "cloth";
    fabric.contact_angle_deg = 35;
    fabric.uncertainty.contact_angle_deg = 20;
    fabric.uncertainty.packing_factor = 0;
    return design;
}

void of_polyester(Fabric& fabric)
{
    fabric.warp.material = fabric.weft.material = {{"polyester", 1.0}};
    fabric.contact_angle_deg.reset();
    fabric.uncertainty = {};
}

std::string message_of(const std::function<void()>& act)
{
    try {
        act();
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

} // namespace

class TestFreeInputs : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void inputsAreThoseThatAreNotKnown()
    {
        Design design = cloth();
        const FreeInput angle = free_input(design, design.fabrics[0], "contact_angle_deg");
        QVERIFY(angle.low == 15 && angle.given == 35 && angle.high == 55);
        QVERIFY(has(message_of([&] { free_input(design, design.fabrics[0], "contact_angel_deg"); }), "did you mean"));
        QVERIFY(has(message_of([&] { free_input(design, design.fabrics[0], "receding_angle_deg"); }), "is known")); // 0 on cotton
        design.fabrics[0].uncertainty.packing_factor = 0.3; // up to 0.8, at which these yarns hold more fibre than the weave has room for
        for (Yarn* yarn : {&design.fabrics[0].warp, &design.fabrics[0].weft}) yarn->diameter_mm = 0.33;
        const FreeInput packing = free_input(design, design.fabrics[0], "packing_factor");
        QVERIFY(packing.low == 0.2 && packing.given == 0.5 && packing.high > 0.5 && packing.high < 0.79);
        QVERIFY(validate_and_fit(with_inputs(design, "cloth", {packing}, {packing.high})).fabrics[0]);
        QVERIFY(!validate_and_fit(with_inputs(design, "cloth", {packing}, {packing.high + 0.01})).fabrics[0]);
        design.fabrics[0].uncertainty.contact_angle_deg = 0;
        QVERIFY(has(message_of([&] { free_input(design, design.fabrics[0], "contact_angle_deg"); }), "is known"));
    }
    void aRecedingAngleLeavesOtherFabricsAlone()
    {
        Design design = cloth();
        of_polyester(design.fabrics[0]);
        design.fabrics.push_back(design.fabrics[0]);
        design.fabrics[1].name = "other";
        const FreeInput angle = free_input(design, design.fabrics[0], "receding_angle_deg");
        QVERIFY(angle.low == 15 && angle.given == 25 && angle.high == 35); // 45 less 10, 20, 30
        Design fitted = with_inputs(design, "cloth", {angle}, {31});
        fitted.fabrics[0].calibrated = Calibrated{"strip.csv", "drop", "draft", "wick_height_mm", 1, {}};
        QCOMPARE(receding_angle_of(fitted, fitted.fabrics[0].warp.material, {}), 31.0);
        QCOMPARE(receding_angle_of(fitted, fitted.fabrics[1].warp.material, {}), 25.0);
        QVERIFY(!has_error(validate(fitted)));
        QVERIFY(parse_project(format_project(fitted), "p") == fitted);
        const Design again = with_inputs(fitted, "cloth", {angle}, {29});
        QCOMPARE(receding_angle_of(again, again.fabrics[0].warp.material, {}), 29.0);
        QCOMPARE(again.materials.size(), fitted.materials.size()); // its own fibre is changed, none is left behind
        Design shared = fitted;
        shared.fabrics[1].warp.material = shared.fabrics[0].warp.material;
        const Design apart = with_inputs(shared, "cloth", {angle}, {29});
        QCOMPARE(receding_angle_of(apart, apart.fabrics[1].warp.material, {}), 31.0);
    }
    void aFibreMadeByHandStaysAsItIs()
    {
        Design design = cloth();
        of_polyester(design.fabrics[0]);
        const FreeInput angle = free_input(design, design.fabrics[0], "receding_angle_deg");
        Material by_hand = *find_material(design, "polyester");
        by_hand.name = "polyester of cloth"; // as a calibration would name one
        by_hand.receding_angle_deg = 11;
        design.materials.push_back(by_hand);
        const auto stays = [&](const Design& given) {
            const Design fitted = with_inputs(given, "cloth", {angle}, {31});
            return *find_material(fitted, by_hand.name) == by_hand && fitted.materials.size() == given.materials.size() + 1 &&
                   receding_angle_of(fitted, fitted.fabrics[0].warp.material, {}) == 31.0;
        };
        QVERIFY(stays(design));
        Design calibrated = design; // of some other input: the fabric is not made of that fibre
        calibrated.fabrics[0].calibrated = Calibrated{"strip.csv", "drop", "draft", "wick_height_mm", 1, {}};
        QVERIFY(stays(calibrated));
        Design made_of_it = design;
        for (Yarn* yarn : {&made_of_it.fabrics[0].warp, &made_of_it.fabrics[0].weft}) yarn->material = {{by_hand.name, 1.0}};
        QVERIFY(stays(made_of_it));
    }
};

} // namespace tst_free_inputs

QTEST_APPLESS_MAIN(tst_free_inputs::TestFreeInputs)
#include "tst_free_inputs.moc"
