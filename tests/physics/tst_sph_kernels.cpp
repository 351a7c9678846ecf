// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Properties every SPH kernel must have, and the surface forces built on it.
#include "core/physics/fluid_forces.h"
#include "core/sim/droplet.h"

#include <QTest>

using namespace hygroloom;

class TestSphKernels : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void kernelIntegratesToOneAndIsNeverNegative()
    {
        const double support = 3e-4;
        double sum = 0;
        constexpr int n = 4000;
        for (int i = 0; i < n; ++i) {
            const double r = (i + 0.5) / n * support;
            const double w = double(spline_kernel(Real(r), Real(support)));
            QVERIFY(w >= 0);
            sum += 4 * pi * r * r * w * support / n;
        }
        QVERIFY(std::abs(sum - 1) < 1e-4);
        QCOMPARE(spline_kernel(Real(support), Real(support)), Real(0));
    }
    void gradientIsTheKernelsSlope()
    {
        const double support = 1.0;
        for (double r : {0.1, 0.3, 0.45, 0.6, 0.9}) {
            const double h = 1e-3;
            const double slope =
                (double(spline_kernel(Real(r + h), Real(support))) - double(spline_kernel(Real(r - h), Real(support)))) / (2 * h);
            QVERIFY(std::abs(double(spline_gradient_factor(Real(r), Real(support))) * r - slope) < 2e-2 * std::abs(slope) + 1e-2);
        }
        QCOMPARE(spline_gradient_factor(Real(0), Real(1)), Real(0));
    }
    void gradientSumsToNothingInALattice()
    {
        Vec3d sum;
        for (int i = -3; i <= 3; ++i)
            for (int j = -3; j <= 3; ++j)
                for (int k = -3; k <= 3; ++k) {
                    const Vec3d d{double(i), double(j), double(k)};
                    sum += double(spline_gradient_factor(Real(length(d)), Real(2.0))) * d;
                }
        QVERIFY(length(sum) < 1e-6);
    }
    void pressureStiffnessHasThePublishedValues() // cubic lattice, cubic spline
    {
        QVERIFY(std::abs(pressure_stiffness(1.0, 2.0) - 1.1769) < 1e-3);
        QVERIFY(std::abs(pressure_stiffness(1.0, 2.4) - 2.404) < 2e-3);
        QVERIFY(std::abs(pressure_stiffness(1.0, 3.0) - 6.891) < 5e-3);
    }
    void wallPullAddsUpToTheWorkOfAdhesion()
    {
        // The potential at a distance is the pull integrated from there outwards; over all distances it makes the work of adhesion.
        const double support = 2e-4, work = 0.1;
        constexpr int n = 2000;
        double potential = 0, energy = 0;
        for (int i = n - 1; i >= 0; --i) {
            const double d = (i + 0.5) / n * support;
            potential += double(wall_pull(Real(work), Real(d), Real(support))) * support / n;
            energy += potential * support / n;
        }
        QVERIFY(std::abs(energy - work) < 2e-3 * work);
    }
    void pairForcePushesNearAndPullsFar()
    {
        QVERIFY(pair_force_shape(Real(0.1), Real(1)) > 0);
        QVERIFY(pair_force_shape(Real(0.6), Real(1)) < 0);
        QVERIFY(std::abs(pair_force_shape(Real(1), Real(1))) < 1e-6);
    }
    void dropletLatticeIsABall()
    {
        for (int count : {1, 7, 500, 2000}) {
            const std::vector<Vec3d> places = droplet_lattice(count, 1.0);
            QCOMPARE(int(places.size()), count);
            double farthest = 0;
            for (const Vec3d& p : places) farthest = std::max(farthest, length(p));
            QVERIFY(farthest < std::cbrt(3.0 * count / (4.0 * pi)) + 1.0);
        }
    }
};

QTEST_APPLESS_MAIN(TestSphKernels)
#include "tst_sph_kernels.moc"
