// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The laws by which yarns reflect light, in the shaders' own words: what is mirrored by water and by fibres, and where to.
#include "core/base/units.h"
#include "core/project/wet_look.h"
#include "ui/picture/cloth_light.h"

#include <QTest>

using namespace hygroloom;

namespace tst_cloth_light {
using namespace hygroloom::cloth_light;

namespace {

const Vec3d up{0, 0, 1};

Vec3d leaning(double degrees, bool along_x)
{
    const double sine = std::sin(degrees * pi / 180), cosine = std::cos(degrees * pi / 180);
    return along_x ? Vec3d{sine, 0, cosine} : Vec3d{0, sine, cosine};
}

/// Of light towards all of the half space, the share of a white matt face's that got as much.
template <typename Light> double sent_back(const Light& light)
{
    constexpr int steps = 200;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        for (int k = 0; k < steps; ++k) {
            const double sine = std::sqrt((i + 0.5) / steps), turn = 2 * pi * (k + 0.5) / steps; // even in the squared sine: by the cosine
            sum += light(Vec3d{sine * std::cos(turn), sine * std::sin(turn), std::sqrt(1 - sine * sine)});
        }
    }
    return sum / (steps * steps);
}

} // namespace

class TestClothLight : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void waterAndFibresMirrorByTheirRefractiveIndices()
    {
        const auto square_on = [](double outside, double inside) { return std::pow((inside - outside) / (inside + outside), 2); };
        QVERIFY(std::abs(film_zero - square_on(1, water_index)) < 1e-4);
        QVERIFY(std::abs(film_zero - (1 - film_entry)) < 1e-4);
        QVERIFY(std::abs(fibre_zero - square_on(1, 1.55)) < 1e-4);
        QVERIFY(std::abs(fibre_under - square_on(water_index, 1.55)) < 1e-4);
        QCOMPARE(film_rough, wet_roughness);
        QVERIFY(std::abs(film_peak - (2 / std::pow(film_rough, 4) - 2)) < 1e-3);
    }

    void fibresThrowLightAcrossThemselvesAndNotAlong()
    {
        const Vec3d along_x{1, 0, 0};
        for (const auto& [lean, least] : {std::pair(30.0, 1.5), {50.0, 4.0}}) { // the bell alone: 2.0 and 5.3
            const double across = fibre_shine(up, along_x, leaning(lean, false), up),
                         along = fibre_shine(up, along_x, leaning(lean, true), up);
            QVERIFY2(across > least * along, qPrintable(QString("%1: %2 and %3").arg(lean).arg(across).arg(along)));
            QVERIFY(matt_light(up, along_x, leaning(lean, false), up, 1) > 1.05 * matt_light(up, along_x, leaning(lean, true), up, 1));
        }
        // The highlight is where both inclinations are opposite: it moves along the fibre with the lamp. The bell alone: 3.2.
        QVERIFY(fibre_shine(up, along_x, leaning(40, true), leaning(-40, true)) > 3 * fibre_shine(up, along_x, leaning(40, true), up));
    }

    void woundFibresTurnTheirHighlight()
    {
        const Vec3d straight = fibre_direction(up, {0, 1, 0}, 0), wound = fibre_direction(up, {0, 1, 0}, std::tan(pi / 6));
        QVERIFY(length(straight - Vec3d{0, 1, 0}) < 1e-3);
        QVERIFY(std::abs(dot(straight, wound) - std::cos(pi / 6)) < 1e-3);
        QVERIFY(std::abs(dot(wound, up)) < 1e-3);
        QVERIFY(wound.x > 0); // towards where a skin's angle grows: Z
    }

    void glossIsPartOfTheLightThatComes()
    {
        const double lean = 30, gets = lamp_strength * std::cos(lean * pi / 180);
        const Vec3d lamp = leaning(lean, true);
        const double fibres = sent_back([&](const Vec3d& eye) { return fibre_shine(up, {0, 1, 0}, lamp, eye); });
        QVERIFY2(fibres > 0.01 * gets && fibres < 0.1 * gets, qPrintable(QString::number(fibres / gets)));
        const double film = sent_back([&](const Vec3d& eye) { return film_shine(up, lamp, eye, 1); });
        const double sky = sky_strength + sky_below;
        QVERIFY2(film > film_zero * gets && film < diffuse_reflection(water_index) * (gets + sky), qPrintable(QString::number(film)));
    }

    void waterTakesTheGlossOfFibresAndGivesItsOwn()
    {
        QCOMPARE(gloss(1, 5, 0), 1.0);
        QVERIFY(std::abs(gloss(1, 0, 1) - fibre_under / fibre_zero) < 1e-12);
        QVERIFY(std::abs(gloss(0, 1, 0.5) - 0.5) < 1e-12);
    }
};

} // namespace tst_cloth_light

QTEST_GUILESS_MAIN(tst_cloth_light::TestClothLight)
#include "tst_cloth_light.moc"
