// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Every case of verify with its public values and with others, on the CPU and, where there is one, on a GPU.
#include "core/base/error.h"
#include "core/verify/verify.h"
#include "gpu/backends.h"

#include <QTest>

using namespace hygroloom;

class TestVerify : public QObject {
    Q_OBJECT
    void check(const std::string& name, const std::map<std::string, std::string>& changes, const std::string& machine)
    {
        std::unique_ptr<Backend> backend;
        try {
            backend = make_backend(machine);
        } catch (const DeviceError& e) {
            if (qEnvironmentVariableIsSet("HYGROLOOM_REQUIRE_CUDA")) QFAIL(e.what());
            QSKIP(e.what());
        }
        const VerifyReport report = run_verify_case(name, changes, *backend);
        QVERIFY(!report.results.empty());
        for (const VerifyResult& r : report.results)
            QVERIFY2(r.pass(), qPrintable(QString("%1: computed %2, expected %3 +- %4").arg(r.name.c_str()).arg(r.computed).arg(r.expected).arg(r.tolerance)));
    }

private Q_SLOTS:
    void casesPass_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("machine");
        for (const char* machine : {"cpu", "cuda"})
            for (const VerifyCase& c : verify_cases()) QTest::addRow("%s on %s", c.name.c_str(), machine) << QString::fromStdString(c.name) << machine;
    }
    void casesPass()
    {
        QFETCH(QString, name);
        QFETCH(QString, machine);
        check(name.toStdString(), {}, machine.toStdString());
    }
    void otherValuesPassToo_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("changes");
        QTest::newRow("wide tube, wetting") << "washburn" << "radius_um=200 contact_angle_deg=0 time_s=0.5 temperature_c=40";
        QTest::newRow("fine tube") << "washburn" << "radius_um=0.5 contact_angle_deg=85 time_s=1000";
        QTest::newRow("tight strip") << "darcy_strip" << "permeability_m2=3e-14 pressure_pa=20000 porosity=0.3 time_s=200";
        QTest::newRow("p = 1") << "barenblatt" << "exponent=1 volume_ul=20 time_s=5";
        QTest::newRow("late p = 2") << "barenblatt" << "time_s=60";
        QTest::newRow("early uptake") << "crank_cylinder" << "fourier=0.05";
        QTest::newRow("late uptake") << "crank_cylinder" << "fourier=0.3";
        QTest::newRow("desert") << "wet_bulb" << "temperature_c=40 relative_humidity=0.1";
        QTest::newRow("with radiation") << "wet_bulb" << "temperature_c=25 relative_humidity=0.4 radiation=1";
        QTest::newRow("slow air") << "drying_rate" << "air_speed_m_s=0.2 length_mm=150 relative_humidity=0.3";
        QTest::newRow("warm air") << "saturation_concentration" << "temperature_c=36";
        QTest::newRow("damp wool") << "regain" << "material=wool relative_humidity=0.9";
        QTest::newRow("cold silk") << "regain" << "material=silk temperature_c=-5 relative_humidity=0.5";
        QTest::newRow("hot polyester") << "regain" << "material=polyester temperature_c=55";
        QTest::newRow("upright, fine") << "washburn_gravity" << "radius_um=100 contact_angle_deg=40 height_mm=70";
        QTest::newRow("column in a fine tube") << "jurin" << "radius_um=20 contact_angle_deg=60 temperature_c=40";
        QTest::newRow("small source") << "radial_wicking" << "source_radius_mm=1 radius_mm=6 permeability_m2=3e-12 porosity=0.4";
        QTest::newRow("early slab") << "slab_conduction" << "fourier=0.2";
        QTest::newRow("late slab off the middle") << "slab_conduction" << "fourier=1 position=0.5";
        QTest::newRow("late half space") << "half_space" << "time_s=20";
        QTest::newRow("damp wool sheet with diffusion") << "sorption_heating" << "humidity_to=0.95 fibre_diffusivity_m2_s=1e-13";
        QTest::newRow("cotton sheet, fitted isotherm") << "sorption_heating" << "material=cotton humidity_from=0.3 isotherm=gab";
        QTest::newRow("wool half wetted") << "adiabatic_wetting" << "material=wool regain=0.2";
        QTest::newRow("poor management") << "management_indices" << "absorption_rate_bottom_pct_s=5 one_way_transport_pct=-200 spreading_speed_bottom_mm_s=0.4 wetting_time_top_s=60";
        QTest::newRow("repellent") << "conservation" << "contact_angle_deg=120 duration_s=0.1";
    }
    void otherValuesPassToo()
    {
        QFETCH(QString, name);
        QFETCH(QString, changes);
        std::map<std::string, std::string> values;
        for (const QString& change : changes.split(' ')) values[change.section('=', 0, 0).toStdString()] = change.section('=', 1).toStdString();
        check(name.toStdString(), values, "cpu");
    }
    void wrongQuestionsAreAnsweredWithASentence_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("value");
        QTest::newRow("no such case") << "washboard" << "x" << "1";
        QTest::newRow("no such parameter") << "washburn" << "radius_mm" << "1";
        QTest::newRow("out of range") << "washburn" << "contact_angle_deg" << "120";
        QTest::newRow("no number") << "washburn" << "radius_um" << "ten";
        QTest::newRow("nan") << "washburn" << "radius_um" << "nan";
        QTest::newRow("no such material") << "regain" << "material" << "steel";
    }
    void wrongQuestionsAreAnsweredWithASentence()
    {
        QFETCH(QString, name);
        QFETCH(QString, key);
        QFETCH(QString, value);
        const auto backend = make_cpu_backend();
        QVERIFY_EXCEPTION_THROWN(run_verify_case(name.toStdString(), {{key.toStdString(), value.toStdString()}}, *backend), Error);
    }
};

QTEST_APPLESS_MAIN(TestVerify)
#include "tst_verify.moc"
