// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Properties every SPH kernel must have, and the surface forces built on it.
#include "core/base/random.h"
#include "core/physics/fluid_forces.h"
#include "core/physics/particle_steps.h"
#include "core/solver/droplet.h"

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
    void stepsShortenWithTheSpacingAndWithWhatDrivesThem()
    {
        // Water: 72.74e-3 N/m, 998.2 kg/m3, 1.0016e-3 Pa s. sqrt((0.2 mm)^3 / (2 pi 7.287e-5 m3/s2)) / 4 = 33.05 us.
        const double capillarity = 72.74e-3 / 998.2, viscosity = 1.0016e-3 / 998.2, spacing = 1e-4;
        const LiquidSteps steps = longest_steps(capillarity, viscosity, spacing);
        QVERIFY(std::abs(steps.capillary - 33.05e-6) < 0.02e-6);
        QVERIFY(std::abs(steps.viscous - 0.025 * 4 * spacing * spacing / viscosity) < 1e-12);
        const LiquidSteps finer = longest_steps(capillarity, viscosity, 0.5 * spacing);
        QVERIFY(std::abs(finer.capillary / steps.capillary - std::pow(0.5, 1.5)) < 1e-12);
        QVERIFY(std::abs(finer.viscous / steps.viscous - 0.25) < 1e-12);
    }
    void deepLiquidTakesStepsThatItsWeightAllows()
    {
        // 10 mm deep: sqrt(9.81 x 0.01) = 0.31321 m/s; 0.09 x 0.1 mm / 0.31321 m/s = 28.73 us.
        QVERIFY(std::abs(longest_weight_step(1e-4, 9.81, 0.01) - 28.73e-6) < 0.01e-6);
        QVERIFY(std::isinf(longest_weight_step(1e-4, 9.81, 0.0)));
        QVERIFY(std::isinf(longest_weight_step(1e-4, 0.0, 0.01)));
    }
    void particlesAreMoreViscousThanTheirLiquidAndLessSoTheFinerTheyAre()
    {
        const double capillarity = 72.74e-3 / 998.2, own = 1.0016e-3 / 998.2;
        const double coarse = viscosity_of_particles(own, capillarity, 1e-4), fine = viscosity_of_particles(own, capillarity, 0.25e-4);
        QVERIFY(fine > own);
        QVERIFY(std::abs((coarse - own) / (fine - own) - 2) < 1e-9);
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
    void curvatureIsTheSlopeOfTheGradient()
    {
        for (double r : {0.1, 0.3, 0.45, 0.6, 0.9}) {
            const double h = 1e-3;
            const auto slope = [](double at) { return double(spline_gradient_factor(Real(at), Real(1))) * at; };
            const double expected = (slope(r + h) - slope(r - h)) / (2 * h);
            QVERIFY(std::abs(double(spline_curvature(Real(r), Real(1))) - expected) < 2e-2 * std::abs(expected) + 2e-2);
        }
    }
    void whatLiesBeyondAPlaneIsTheKernelsIntegral()
    {
        QVERIFY(std::abs(kernel_beyond_plane(Real(0), Real(2)) - Real(0.5)) < Real(1e-5));
        QCOMPARE(kernel_beyond_plane(Real(2), Real(2)), Real(0));
        for (double d : {0.05, 0.3, 0.9, 1.2, 1.8}) { // of a support of 2
            double in_plane = 0;
            constexpr int n = 4000;
            for (int i = 0; i < n; ++i) {
                const double s = (i + 0.5) / n * 2;
                in_plane += 2 * pi * s * double(spline_kernel(Real(std::hypot(s, d)), Real(2))) * 2 / n;
            }
            QVERIFY(std::abs(double(kernel_in_plane(Real(d), Real(2))) - in_plane) < 1e-3);
            const double h = 1e-3;
            const auto beyond = [](double at) { return double(kernel_beyond_plane(Real(at), Real(2))); };
            const auto in = [](double at) { return double(kernel_in_plane(Real(at), Real(2))); };
            QVERIFY(std::abs((beyond(d - h) - beyond(d + h)) / (2 * h) - in_plane) < 1e-3);
            QVERIFY(std::abs((in(d + h) - in(d - h)) / (2 * h) - double(kernel_in_plane_slope(Real(d), Real(2)))) < 2e-3);
        }
    }
    void virialsBeyondAPlaneAreTheKernelsIntegrals()
    {
        for (double distance : {0.05, 0.5, 1.1, 1.8}) { // of a support of 2
            double slope = 0, curvature = 0;
            constexpr int n = 600;
            const double step = 2.0 / n;
            for (int k = 0; k < n; ++k) {
                const double z = distance + (k + 0.5) * step;
                for (int i = 0; i < n; ++i) {
                    const double s = (i + 0.5) * step, r = std::hypot(s, z);
                    const double ring = 2 * pi * s * step * step;
                    slope -= ring * r * r * double(spline_gradient_factor(Real(r), Real(2)));
                    curvature += ring * z * double(spline_curvature(Real(r), Real(2)));
                }
            }
            QVERIFY(std::abs(double(slope_virial_beyond_plane(Real(distance), Real(2))) - slope) < 2e-3);
            QVERIFY(std::abs(double(curvature_virial_beyond_plane(Real(distance), Real(2))) - curvature) < 2e-3);
        }
    }
    void wallsWetTheLessTheLargerTheAngle()
    {
        for (const auto& [attraction, share] : {std::pair{&wall_attraction, &wall_share}, std::pair{&bead_attraction, &bead_share}}) {
            Real attracts = 2, counts = 2;
            for (double degree = 0; degree <= 180; degree += 1) {
                const Real cosine = Real(std::cos(radian_from_degree(degree)));
                QVERIFY(attraction(cosine) <= attracts && attraction(cosine) > 0);
                QVERIFY(share(cosine) <= counts && share(cosine) >= 0 && share(cosine) <= 1);
                attracts = attraction(cosine);
                counts = share(cosine);
            }
            QVERIFY(std::abs(share(Real(-1e-8)) - Real(1)) < Real(1e-4)); // no jump at 90 degrees, where a vessel's falls with the root
        }
    }
    void forceOfAWallIsTheSlopeOfItsEnergy()
    {
        // The wall adds kernel_beyond_plane() to what is near the particle and -kernel_in_plane() to its gradient along the normal.
        const double pull = 3, tilt = 0.7, support = 2, h = 1e-3;
        const auto energy = [&](double distance) {
            return -pull * double(kernel_beyond_plane(Real(distance), Real(support))) -
                   tilt * double(kernel_in_plane(Real(distance), Real(support)));
        };
        for (double distance : {0.1, 0.5, 1.3, 1.8}) {
            const double expected = -(energy(distance + h) - energy(distance - h)) / (2 * h);
            QVERIFY(std::abs(double(surface_force_of_wall(Real(pull), Real(tilt), Real(distance), Real(support))) - expected) < 5e-3);
        }
        QCOMPARE(surface_force_of_wall(Real(pull), Real(tilt), Real(support), Real(support)), Real(0));
    }
    void surfaceForceIsTheSlopeOfTheSurfacesEnergy()
    {
        // A random heap, evenly spread so that no share reaches 1: the force on one of it against a difference of energies.
        constexpr int n = 12;
        std::vector<Vec3d> x;
        for (std::uint64_t i = 0; i < n; ++i)
            x.push_back({1.5 * random_uniform(7, 0, i), 1.5 * random_uniform(7, 1, i), 1.5 * random_uniform(7, 2, i)});
        const SurfaceEnergy e = surface_energy(Real(1), Real(1));
        const Real support = Real(surface_support_in_spacings);
        const auto single = [](const Vec3d& v) { return Vec3{Real(v.x), Real(v.y), Real(v.z)}; };
        struct Here {
            double share;
            Vec3 slope;
        };
        const auto at = [&](std::size_t i) {
            Here here{double(spline_kernel(0, support)), {}};
            for (std::size_t j = 0; j < n; ++j) {
                if (j == i) continue;
                const Vec3 d = single(x[i] - x[j]);
                here.share += double(spline_kernel(length(d), support));
                here.slope += spline_gradient_factor(length(d), support) * d;
            }
            return here;
        };
        const auto energy = [&] {
            double sum = 0;
            for (std::size_t i = 0; i < n; ++i) {
                const Here here = at(i);
                const double missing = std::max(0.0, 1 - here.share);
                sum += double(e.well) * missing * missing + double(e.gradient) * double(dot(here.slope, here.slope));
            }
            return sum;
        };
        Vec3 force, total;
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j) {
                if (j == i) continue;
                const Here a = at(i), b = at(j);
                const Vec3 tilt = e.tilt(a.slope) - e.tilt(b.slope), d = single(x[i] - x[j]);
                const SplineUnits units(support);
                const Real r = length(d);
                const SurfaceForce<Real> parts = surface_force(e.pull(Real(a.share)) + e.pull(Real(b.share)), tilt, d, Real(1) / r,
                                                               Spline<Real>(r * units.per_metre), units.per_metre);
                const Vec3 f = units.slope * (parts.along * d - parts.against * tilt);
                total += f;
                if (i == 0) force += f;
            }
        const double h = 1e-2, scale = double(length(force));
        const double own[3] = {double(force.x), double(force.y), double(force.z)};
        double* axes[3] = {&x[0].x, &x[0].y, &x[0].z};
        for (int k = 0; k < 3; ++k) {
            const double before = *axes[k];
            *axes[k] = before + h;
            const double above = energy();
            *axes[k] = before - h;
            const double below = energy();
            *axes[k] = before;
            QVERIFY2(std::abs(own[k] + (above - below) / (2 * h)) < 1e-2 * scale,
                     qPrintable(QString("%1 against %2").arg(own[k]).arg(-(above - below) / (2 * h))));
        }
        QVERIFY(double(length(total)) < 1e-4 * scale);
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
