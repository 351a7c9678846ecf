// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a description leaves open, and the cloths that replicates draw from it.
#include "core/base/units.h"
#include "core/design/unknowns.h"
#include "core/design/validate.h"
#include "tests/support/drop_design.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <set>

using namespace hygroloom;

namespace {

const UnknownInput* input_named(const std::vector<UnknownInput>& inputs, const std::string& begin)
{
    for (const UnknownInput& input : inputs)
        if (input.name.starts_with(begin)) return &input;
    return nullptr;
}

/// A fabric of polyester yarns by their linear density.
Design polyester()
{
    Design design = drop_design();
    design.fabrics[0].contact_angle_deg.reset();
    for (Yarn* yarn : {&design.fabrics[0].warp, &design.fabrics[0].weft}) {
        yarn->material = {{"polyester", 1.0}};
        yarn->diameter_mm.reset();
        yarn->packing_factor.reset();
        yarn->linear_density_tex = 15;
    }
    return design;
}

} // namespace

class TestUnknowns : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void rangesAreThoseOfTheLibrary()
    {
        const Design design = polyester();
        const auto inputs = unknown_inputs(design, design.fabrics[0]);
        const UnknownInput* angle = input_named(inputs, "contact angle on polyester");
        QVERIFY(angle && angle->low == 20 && angle->given == 45 && angle->high == 55 && !angle->source.empty());
        QVERIFY(input_named(inputs, "contact angle hysteresis on polyester"));
        QVERIFY(input_named(inputs, "packing"));
        QCOMPARE(inputs.size(), std::size_t(3)); // both yarns are alike
        for (const Material& fibre : material_library()) {
            const AngleRange range = contact_angle_range(fibre.name);
            QVERIFY2(range.low <= fibre.contact_angle_deg && fibre.contact_angle_deg <= range.high, fibre.name.c_str());
        }
    }
    void whatTheUserKnowsIsNotDrawn()
    {
        Design design = polyester();
        Fabric& fabric = design.fabrics[0];
        fabric.uncertainty = {0.0, 0.0, 0.0};
        QVERIFY(unknown_inputs(design, fabric).empty());
        fabric.uncertainty.receding_angle_deg = 3;
        const auto off = unknown_inputs(design, fabric);
        QVERIFY(off.size() == 1 && off[0].name.starts_with("contact angle hysteresis") && off[0].low == 17 && off[0].high == 23);
        fabric.uncertainty.receding_angle_deg = 0;
        fabric.uncertainty.contact_angle_deg = 4;
        const auto inputs = unknown_inputs(design, fabric);
        QCOMPARE(inputs.size(), std::size_t(1));
        QVERIFY(inputs[0].low == 41 && inputs[0].high == 49);
        fabric.contact_angle_deg = 178; // a finish, and the scale ends
        const auto finish = unknown_inputs(design, fabric);
        QVERIFY(finish.size() == 1 && finish[0].low == 174 && finish[0].high == 180);
    }
    void aHypercubeUsesEveryStratumOnce()
    {
        constexpr int runs = 9;
        for (const char* name : {"contact angle on cotton", "packing"}) {
            std::set<int> strata;
            QCOMPARE(place_in_range({5, 0, runs}, name), 0.5);
            for (int i = 1; i < runs; ++i) strata.insert(static_cast<int>((runs - 1) * place_in_range({5, i, runs}, name)));
            QCOMPARE(strata.size(), std::size_t(runs - 1));
        }
        QVERIFY(place_in_range({5, 1, runs}, "a") != place_in_range({5, 1, runs}, "b"));
        QVERIFY(place_in_range({5, 1, runs}, "a") != place_in_range({6, 1, runs}, "a"));
    }
    void replicatesDifferWithinTheRanges()
    {
        const Design design = polyester();
        const std::string fabric = design.fabrics[0].name, experiment = design.experiments[0].name;
        QVERIFY(drawn(design, fabric, experiment, {1, 0, 1}).design == design);
        const Design first = drawn(design, fabric, experiment, {1, 0, 6}).design;
        QVERIFY(first == design); // the cloth in one run is the first of several
        std::set<double> angles, packings, places;
        for (int i = 1; i < 6; ++i) {
            const Design other = drawn(design, fabric, experiment, {1, i, 6}).design;
            const Material fibre = *find_material(other, "polyester");
            angles.insert(fibre.contact_angle_deg);
            QVERIFY(fibre.contact_angle_deg >= 20 && fibre.contact_angle_deg <= 55);
            const double off = fibre.contact_angle_deg - *fibre.receding_angle_deg;
            QVERIFY(off >= 10 && off <= 30);
            packings.insert(*other.fabrics[0].warp.packing_factor);
            QCOMPARE(*other.fabrics[0].warp.packing_factor, *other.fabrics[0].weft.packing_factor);
            places.insert(other.experiments[0].droplets[0].at_mm[0]);
            QVERIFY(validate_and_fit(other).fabrics[0]);
            QVERIFY(drawn(design, fabric, experiment, {1, i, 6}).design == other);
        }
        QVERIFY(angles.size() == 5 && packings.size() == 5 && places.size() == 5);
    }
    void likeFibresShareTheirUnknown()
    {
        Design design = polyester();
        design.fabrics.push_back(design.fabrics[0]);
        design.fabrics[1].name = "open";
        design.fabrics[1].ends_per_cm *= 0.8;
        for (int i = 1; i < 5; ++i) {
            const auto angle = [&](const std::string& fabric) {
                return find_material(drawn(design, fabric, design.experiments[0].name, {3, i, 5}).design, "polyester")->contact_angle_deg;
            };
            QCOMPARE(angle("open"), angle(design.fabrics[0].name));
        }
    }
    /// A garment's fabrics are drawn together; what they share is drawn once.
    void theFabricsOfAGarmentAreDrawnTogether()
    {
        Design design = polyester();
        design.fabrics.push_back(design.fabrics[0]);
        design.fabrics[1].name = "coarse";
        for (Yarn* yarn : {&design.fabrics[1].warp, &design.fabrics[1].weft}) yarn->linear_density_tex = 16;
        const std::vector<std::string> both{design.fabrics[0].name, "coarse"};
        QVERIFY(drawn(design, both, {3, 0, 5}).design == design && drawn(design, both, {3, 2, 1}).design == design);
        const Drawn alone = drawn(design, std::vector{both[0]}, {3, 2, 5}), together = drawn(design, both, {3, 2, 5});
        QCOMPARE(together.names.size(), alone.names.size() + 1); // the packing of the other yarn
        QCOMPARE(find_material(together.design, "polyester")->contact_angle_deg,
                 find_material(alone.design, "polyester")->contact_angle_deg);
        QCOMPARE(*find_material(together.design, "polyester")->receding_angle_deg,
                 *find_material(alone.design, "polyester")->receding_angle_deg);
        QVERIFY(together.design.fabrics[0] == alone.design.fabrics[0]);
        QVERIFY(together.design.fabrics[1].warp.packing_factor != design.fabrics[1].warp.packing_factor);
    }
    void aPackingThatDoesNotFitStaysAsGiven()
    {
        Design design = polyester();
        Fabric& fabric = design.fabrics[0];
        fabric.uncertainty.packing_factor = 0.3;
        fabric.flyaway = {};
        fabric.thickness_mm = 0.04; // loose yarns are too thick for it
        fabric.ends_per_cm = fabric.picks_per_cm = 10;
        QVERIFY(validate_and_fit(design).fabrics[0]);
        int drew = 0;
        for (int i = 1; i < 12; ++i) {
            const Design other = drawn(design, fabric.name, design.experiments[0].name, {1, i, 12}).design;
            QVERIFY(validate_and_fit(other).fabrics[0]);
            drew += other.fabrics[0].warp.packing_factor.has_value() ? 1 : 0;
        }
        QVERIFY2(drew > 0 && drew < 11, qPrintable(QString::number(drew)));
    }
};

QTEST_APPLESS_MAIN(TestUnknowns)
#include "tst_unknowns.moc"
