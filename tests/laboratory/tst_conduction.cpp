// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Heat and vapour through voxels, where they are known.
#include "core/base/error.h"
#include "core/base/units.h"
#include "core/physics/laboratory.h"
#include "core/room/conduction.h"
#include "tests/room/square_cotton.h"

#include <QTest>

#include <cmath>

using namespace hygroloom;

namespace {

/// A cell of so many voxels of 1 um a side, one along y; outside(x, z) from its middle, in voxels.
template <typename Outside> DrawnLayer cell(int side, const Outside& outside)
{
    DrawnLayer layer;
    layer.per_end = side;
    layer.per_pick = 1;
    layer.dx = layer.dy = layer.dz = 1e-6;
    layer.grid = {side, 1, side, true, false};
    layer.reach = 1;
    for (int z = 0; z < side; ++z)
        for (int x = 0; x < side; ++x)
            layer.outside.push_back(static_cast<float>(1e-6 * outside(x + 0.5 - 0.5 * side, z + 0.5 - 0.5 * side)));
    return layer;
}

/// Square array of cylinders (Rayleigh 1892; Perrins and others 1979), over what is between them.
double rayleigh(double share, double contrast)
{
    const double t = (contrast - 1) / (contrast + 1);
    return 1 + 2 * share * t / (1 - share * t - 0.305827 * t * t * std::pow(share, 4));
}

} // namespace

class TestConduction : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void layersConductInSeries()
    {
        const double found = conductivity_through(cell(20, [](double, double z) { return z; }), 0, 1, 4); // lower half of the better
        QVERIFY2(near_to(found, 1 / (0.5 / 1 + 0.5 / 4), 1e-6), qPrintable(QString::number(found)));
    }
    void stripesConductSideBySide()
    {
        const double found = conductivity_through(cell(20, [](double x, double) { return std::abs(x) - 5; }), 0, 1, 4);
        QVERIFY2(near_to(found, 2.5, 1e-6), qPrintable(QString::number(found)));
    }
    void anEvenLayerConductsAsItsSubstance()
    {
        QVERIFY(near_to(conductivity_through(cell(8, [](double, double) { return 1.0; }), 0, 0.026, 3), 0.026, 1e-6));
    }
    void whatIsNotSolvedIsNoNumber()
    {
        QVERIFY_THROWS_EXCEPTION(Error, conductivity_through(cell(4, [](double, double z) { return z; }), 0, 1, std::nan("")));
    }
    /// A row of rods between two faces of one temperature each is a square array by symmetry.
    void rodsConductAsRayleighSays()
    {
        for (const double share : {0.2, 0.4})
            for (const double contrast : {1e-3, 10.0}) {
                const double radius = 48 * std::sqrt(share / pi);
                const double found =
                    conductivity_through(cell(48, [&](double x, double z) { return std::hypot(x, z) - radius; }), 0, 1, contrast);
                QVERIFY2(near_to(found, rayleigh(share, contrast), 0.03),
                         qPrintable(QString("%1 %2: %3").arg(share).arg(contrast).arg(found / rayleigh(share, contrast))));
            }
    }
    void acrossFibresIsRayleighsFirstTerm()
    {
        QVERIFY(near_to(conductivity_across_fibres(0.3, 10, 1), 1 + 2 * 0.3 * (9.0 / 11) / (1 - 0.3 * 9.0 / 11), 1e-12));
        QVERIFY(near_to(conductivity_across_fibres(0.6, 0, 1), 0.4 / 1.6, 1e-12)); // vapour past fibres that take none
    }
    /// A millimetre of still air at 35 C, by hand: 1e-3 x 461.5 x 308.15 / (2.71e-5 x 2.418e6).
    void aMillimetreOfAirResistsAsItsDiffusivitySays()
    {
        QVERIFY(near_to(evaporative_resistance(1e-3, 308.15), 2.17, 0.005));
        QVERIFY(near_to(height_of_hairs(2, 1000, 1), 20, 1e-12)); // pressed by a thousandth, ten times as high
    }
    void aTouchGivesWhatCarslawAndJaegerSay()
    {
        QVERIFY(near_to(contact_heat(10, 500, 250, 0.25), 10 * 500 * 0.427584, 1e-5)); // e erfc(1), of tables
        QVERIFY(near_to(contact_heat(10, 1, 1000, 0.01), 10 * 1, 1e-3));               // at first the conductance decides
        for (const double conductance : {1e4, 1e6, 1e9})                               // without one 10 K x e over the root of pi t
            QVERIFY(near_to(contact_heat(10, conductance, 100, 0.2), 10 * 100 / std::sqrt(pi * 0.2), 2e-3));
        QVERIFY(near_to(contact_heat(10, 19.999, 1, 1), contact_heat(10, 20.001, 1, 1), 1e-3)); // where its series takes over
    }
};

QTEST_APPLESS_MAIN(TestConduction)
#include "tst_conduction.moc"
