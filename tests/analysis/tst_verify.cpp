// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Every case of verify with its public values or smaller ones, and with others, on the CPU and, where there is one, on a GPU.
#include "core/base/error.h"
#include "core/verify/fits.h"
#include "core/verify/verify.h"
#include "gpu/backends.h"

#include <QTest>

using namespace hygroloom;

namespace {

using Changes = std::map<std::string, std::string>;

/// Of cases that take long ctest runs less; verify runs them whole, and so does this test with HYGROLOOM_WHOLE_CASES=1.
Changes smaller(const std::string& name, const std::string& machine)
{
    if (qEnvironmentVariableIsSet("HYGROLOOM_WHOLE_CASES")) return {};
    static const std::map<std::string, Changes> all{
        {"hydrostatic", {{"particles", "2000"}}},
        {"laplace_pressure", {{"particles", "2500"}}},
        {"sessile_drop", {{"particles", "2000"}}},
        {"impact", {{"particles", "500"}}},
        {"experiments_agree", {{"duration_s", "0.02"}, {"fidelity", "live"}}},
        {"goes_on_on_cpu", {{"duration_s", "0.1"}}},
        {"stain_shape", {{"volume_ul", "2"}, {"time_s", "2"}}},
        {"measured_n6", {{"duration_s", "60"}}},
        {"measured_n3", {{"step_s", "8"}}},
        {"measured_t3", {{"sample_mm", "20"}, {"volume_ul", "8"}}},
        {"measured_t4", {{"sample_mm", "14"}, {"volume_ul", "4"}}},
        {"measured_t6", {{"duration_s", "900"}}},
        {"measured_t7", {}},
        {"measured_t8", {{"duration_s", "10"}}},
    };
    if (name == "experiments_agree" && machine == "cuda") return {{"duration_s", "0.2"}}; // with particles, which are fast there
    const auto found = all.find(name);
    return found == all.end() ? Changes() : found->second;
}

} // namespace

class TestVerify : public QObject {
    Q_OBJECT
    void check(const std::string& name, const Changes& changes, const std::string& machine)
    {
        std::unique_ptr<Backend> backend;
        try {
            backend = make_backend(machine);
        } catch (const DeviceError& e) {
            if (qEnvironmentVariableIsSet("HYGROLOOM_REQUIRE_CUDA")) QFAIL(e.what());
            QSKIP(e.what());
        }
        const VerifyReport report = run_verify_case(name, changes, *backend);
        QVERIFY(report.results.empty() == !report.not_applicable.empty());
        for (const VerifyResult& r : report.results)
            QVERIFY2(
                r.pass() || r.misses_as_known(),
                qPrintable(
                    QString("%1: computed %2, expected %3 +- %4").arg(r.name.c_str()).arg(r.computed).arg(r.expected).arg(r.tolerance)));
    }

private Q_SLOTS:
    void manyScenesAskForQueuesUnlessTheUserHas()
    {
        constexpr const char* name = "CUDA_DEVICE_MAX_CONNECTIONS";
        const QByteArray before = qgetenv(name);
        qunsetenv(name);
        announce_scenes(0, 8);
        announce_scenes(3, 20);
        QVERIFY(!qEnvironmentVariableIsSet(name));
        announce_scenes(0, 9);
        QCOMPARE(qgetenv(name), QByteArray("16"));
        qputenv(name, "4");
        announce_scenes(20, 20);
        QCOMPARE(qgetenv(name), QByteArray("4"));
        if (before.isNull())
            qunsetenv(name);
        else
            qputenv(name, before);
    }
    void oneSceneFillsACpuUnlessMoreAreAskedFor()
    {
        QCOMPARE(make_backends("cpu", 0, 5, 0).size(), std::size_t(1));
        QCOMPARE(make_backends("cpu", 3, 5, 0).size(), std::size_t(3));
        QCOMPARE(make_backends("cpu", 9, 5, 0).size(), std::size_t(5));
        QVERIFY_EXCEPTION_THROWN(make_backends("abacus", 2, 5, 0), Error);
    }
    void casesPass_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("machine");
        for (const char* machine : {"cpu", "cuda"})
            for (const VerifyCase& c : verify_cases())
                if (c.source.empty() || machine == std::string("cpu"))
                    QTest::addRow("%s on %s", c.name.c_str(), machine) << QString::fromStdString(c.name) << machine;
    }
    void casesPass()
    {
        QFETCH(QString, name);
        QFETCH(QString, machine);
        check(name.toStdString(), smaller(name.toStdString(), machine.toStdString()), machine.toStdString());
    }
    void otherValuesPassToo_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("changes");
        QTest::newRow("air through an open cloth") << "air_permeability"
                                                   << "fabric=Sheeting pressure_pa=200";
        QTest::newRow("a flat cap") << "sessile_drop"
                                    << "contact_angle_deg=45 particles=1000";
        QTest::newRow("a heavy drop") << "sessile_drop"
                                      << "contact_angle_deg=75 volume_ul=30 gravity=1 particles=2000";
        QTest::newRow("a drop on yarns of ninety degrees") << "drop_on_yarns"
                                                           << "contact_angle_deg=90";
        QTest::newRow("a drop at rest that wets") << "liquid_rest"
                                                  << "contact_angle_deg=45";
        QTest::newRow("a drop at rest that hardly wets, of another number") << "liquid_rest"
                                                                            << "contact_angle_deg=120 particles=1100";
        QTest::newRow("a large warm drop swings") << "rayleigh_drop"
                                                  << "radius_mm=2.5 temperature_c=50 particles=2000";
        QTest::newRow("a drop swings with three lobes") << "rayleigh_drop"
                                                        << "mode=3 particles=2000";
        QTest::newRow("a deep column") << "hydrostatic"
                                       << "depth_mm=45 particles=2000";
        QTest::newRow("a drop fired at a dense fabric") << "impact"
                                                        << "fabric=Denim speed_m_s=5 volume_ul=3 particles=300";
        QTest::newRow("a large warm drop that hardly wets") << "sessile_drop"
                                                            << "contact_angle_deg=150 temperature_c=50 volume_ul=12 particles=2000";
        QTest::newRow("a drop fired at steep yarns") << "impact"
                                                     << "fabric=B speed_m_s=5 particles=200";
        QTest::newRow("a drop fired at an open fabric") << "impact"
                                                        << "fabric=C speed_m_s=1 volume_ul=8 particles=500";
        QTest::newRow("as fast as drops may be") << "impact"
                                                 << "speed_m_s=10 particles=200";
        QTest::newRow("a slug that empties later") << "slug_arrest"
                                                   << "hysteresis=1.2 time_s=600";
        QTest::newRow("an hour later") << "slug_arrest"
                                       << "hysteresis=1.2 time_s=3600";
        QTest::newRow("a slug without hysteresis") << "slug_arrest"
                                                   << "hysteresis=1 time_s=3600";
        QTest::newRow("a short slug in dense fibres") << "slug_arrest"
                                                      << "packing=0.7 contact_angle_deg=50 slug_mm=4 time_s=200";
        QTest::newRow("a slug at rest in coarse fibres") << "slug_rest"
                                                         << "packing=0.4 fibre_radius_um=15 slug_mm=5 cell_mm=0.25";
        QTest::newRow("a loose yarn in water") << "supplied_yarn"
                                               << "packing=0.35 contact_angle_deg=10 fibre_radius_um=12 time_s=2";
        QTest::newRow("a dense yarn that hardly wets") << "supplied_yarn"
                                                       << "packing=0.7 contact_angle_deg=65 time_s=100";
        QTest::newRow("a yarn beside a room it drinks from") << "two_fronts"
                                                             << "conductance=1";
        QTest::newRow("a fast room") << "two_fronts"
                                     << "permeability_m2=1e-10 entry_suction_pa=800 porosity=0.5 time_s=1";
        QTest::newRow("the top of the strip") << "retention_column"
                                              << "height_mm=300";
        QTest::newRow("finer rooms") << "retention_column"
                                     << "entry_suction_pa=2500 shape=3 hysteresis=1.4 height_mm=250 strip_mm=400";
        QTest::newRow("nothing enters a cloth that repels") << "repellent_drop"
                                                            << "fabric=D contact_angle_deg=110";
        QTest::newRow("something enters what wets") << "repellent_drop"
                                                    << "contact_angle_deg=30 time_s=1";
        QTest::newRow("a front far behind the other") << "two_fronts"
                                                      << "permeability_m2=3e-13 time_s=0.2";
        QTest::newRow("rods so far apart that water hardly stands between") << "rod_column"
                                                                            << "rod_radius_um=0.3 suction_pa=12 half_gap_um=30";
        QTest::newRow("liquid in narrow gaps, whose skin is dry beside it") << "rod_menisci"
                                                                            << "half_gap_um=10 pressure_pa=300";
        QTest::newRow("the same in twice as large voxels") << "rod_menisci"
                                                           << "half_gap_um=10 pressure_pa=300 voxels=24";
        QTest::newRow("a slug in cells as long as it") << "slug_arrest"
                                                       << "cell_mm=10";
        QTest::newRow("a cloth of few thick yarns at work") << "free_energy"
                                                            << "fabric=B time_s=5";
        QTest::newRow("a puddle") << "cap_shape"
                                  << "volume_ul=500 contact_angle_deg=6";
        QTest::newRow("a drop that has just touched") << "cap_spreading"
                                                      << "time_s=0.0001";
        QTest::newRow("a strip that drains to what is hardly connected")
            << "retention_column"
            << "entry_suction_pa=420 shape=4 hysteresis=1 strip_mm=100 height_mm=82";
        QTest::newRow("rooms of a denim") << "between_yarns"
                                          << "fabric=Denim";
        QTest::newRow("a loose cloth at work") << "free_energy"
                                               << "fabric=C time_s=5";
        QTest::newRow("wide tube, wetting") << "washburn"
                                            << "radius_um=200 contact_angle_deg=0 time_s=0.5 temperature_c=40";
        QTest::newRow("fine tube") << "washburn"
                                   << "radius_um=0.5 contact_angle_deg=85 time_s=1000";
        QTest::newRow("tight strip") << "darcy_strip"
                                     << "permeability_m2=3e-14 pressure_pa=20000 porosity=0.3 time_s=200";
        QTest::newRow("early uptake") << "crank_cylinder"
                                      << "fourier=0.05";
        QTest::newRow("late uptake") << "crank_cylinder"
                                     << "fourier=0.3";
        QTest::newRow("shells of drafts") << "crank_cylinder"
                                          << "shells=5";
        QTest::newRow("usual shells, early") << "crank_cylinder"
                                             << "shells=8 fourier=0.01";
        QTest::newRow("shells of references, at first") << "crank_cylinder"
                                                        << "shells=16 fourier=0.005";
        QTest::newRow("desert") << "wet_bulb"
                                << "temperature_c=40 relative_humidity=0.1";
        QTest::newRow("with radiation") << "wet_bulb"
                                        << "temperature_c=25 relative_humidity=0.4 radiation=1";
        QTest::newRow("slow air") << "drying_rate"
                                  << "air_speed_m_s=0.2 length_mm=150 relative_humidity=0.3";
        QTest::newRow("warm air") << "saturation_concentration"
                                  << "temperature_c=36";
        QTest::newRow("damp wool") << "regain"
                                   << "material=wool relative_humidity=0.9";
        QTest::newRow("cold silk") << "regain"
                                   << "material=silk temperature_c=-5 relative_humidity=0.5";
        QTest::newRow("hot polyester") << "regain"
                                       << "material=polyester temperature_c=55";
        QTest::newRow("hardly wetting at all") << "washburn"
                                               << "contact_angle_deg=89.99";
        QTest::newRow("a column that hardly rises") << "jurin"
                                                    << "contact_angle_deg=89.99";
        QTest::newRow("upright, fine") << "washburn_gravity"
                                       << "radius_um=100 contact_angle_deg=40 height_mm=70";
        QTest::newRow("column in a fine tube") << "jurin"
                                               << "radius_um=20 contact_angle_deg=60 temperature_c=40";
        QTest::newRow("small source") << "radial_wicking"
                                      << "source_radius_mm=1 radius_mm=6 permeability_m2=3e-12 porosity=0.4";
        QTest::newRow("early slab") << "slab_conduction"
                                    << "fourier=0.2";
        QTest::newRow("late slab off the middle") << "slab_conduction"
                                                  << "fourier=1 position=0.5";
        QTest::newRow("late half space") << "half_space"
                                         << "time_s=20";
        QTest::newRow("damp wool sheet with diffusion") << "sorption_heating"
                                                        << "humidity_to=0.95 fibre_diffusivity_m2_s=1e-13";
        QTest::newRow("cotton sheet, fitted isotherm") << "sorption_heating"
                                                       << "material=cotton humidity_from=0.3 isotherm=gab";
        QTest::newRow("wool half wetted") << "adiabatic_wetting"
                                          << "material=wool regain=0.2";
        QTest::newRow("poor management")
            << "management_indices"
            << "absorption_rate_bottom_pct_s=5 one_way_transport_pct=-200 spreading_speed_bottom_mm_s=0.4 wetting_time_top_s=60";
        QTest::newRow("repellent") << "conservation"
                                   << "contact_angle_deg=120 duration_s=0.1";
        QTest::newRow("fine tube for a minute") << "washburn"
                                                << "radius_um=1 contact_angle_deg=0 time_s=60";
        QTest::newRow("wide tube, hardly wetting, hot") << "washburn"
                                                        << "radius_um=100 contact_angle_deg=80 time_s=0.1 temperature_c=60";
        QTest::newRow("open strip") << "darcy_strip"
                                    << "permeability_m2=1e-11 pressure_pa=1000 porosity=0.99 time_s=0.01";
        QTest::newRow("loose mat") << "darcy_strip"
                                   << "permeability_m2=1e-10 pressure_pa=100 porosity=0.1 time_s=1";
        QTest::newRow("upright, high") << "washburn_gravity"
                                       << "height_mm=150";
        QTest::newRow("upright, near the top") << "washburn_gravity"
                                               << "radius_um=100 height_mm=144";
        QTest::newRow("upright, wide") << "washburn_gravity"
                                       << "radius_um=200 height_mm=70";
        QTest::newRow("column in a wide tube") << "jurin"
                                               << "radius_um=500 contact_angle_deg=60 temperature_c=60";
        QTest::newRow("column of metres") << "jurin"
                                          << "radius_um=1";
        QTest::newRow("far front") << "radial_wicking"
                                   << "source_radius_mm=0.5 radius_mm=50 porosity=0.8";
        QTest::newRow("near front") << "radial_wicking"
                                    << "source_radius_mm=5 radius_mm=5.5";
        QTest::newRow("half uptake, at the axis") << "crank_cylinder"
                                                  << "fourier=0.06306 position=0";
        QTest::newRow("late uptake, at the axis") << "crank_cylinder"
                                                  << "fourier=0.2 position=0";
        QTest::newRow("near the skin") << "crank_cylinder"
                                       << "fourier=0.1 position=0.95";
        QTest::newRow("very early slab, near the face") << "slab_conduction"
                                                        << "fourier=0.001 position=0.95";
        QTest::newRow("nearly cold slab") << "slab_conduction"
                                          << "fourier=3 position=0.3";
        QTest::newRow("deep and slow") << "half_space"
                                       << "diffusivity_m2_s=1.4e-7 depth_mm=3 time_s=100";
        QTest::newRow("fast and shallow") << "half_space"
                                          << "diffusivity_m2_s=1e-5 depth_mm=0.1 time_s=0.001";
        QTest::newRow("hottest and driest") << "wet_bulb"
                                            << "temperature_c=60 relative_humidity=0";
        QTest::newRow("chilly") << "wet_bulb"
                                << "temperature_c=10 relative_humidity=0.5";
        QTest::newRow("in the frost") << "wet_bulb"
                                      << "temperature_c=-10 relative_humidity=0.3";
        QTest::newRow("drying in saturated air") << "drying_rate"
                                                 << "relative_humidity=1";
        QTest::newRow("condensation") << "wet_bulb"
                                      << "relative_humidity=1.2";
        QTest::newRow("condensation in the frost") << "wet_bulb"
                                                   << "temperature_c=-10 relative_humidity=2 radiation=1";
        QTest::newRow("condensing in hot wind") << "drying_rate"
                                                << "temperature_c=60 relative_humidity=2 air_speed_m_s=5";
        QTest::newRow("wool in more than saturated air") << "regain"
                                                         << "material=wool relative_humidity=1.2 temperature_c=45";
        QTest::newRow("no evaporation") << "wet_bulb"
                                        << "relative_humidity=1";
        QTest::newRow("drying in a storm") << "drying_rate"
                                           << "temperature_c=60 relative_humidity=0 air_speed_m_s=10 length_mm=20";
        QTest::newRow("drying in damp air") << "drying_rate"
                                            << "temperature_c=10 relative_humidity=0.9 air_speed_m_s=0.1 radiation=1";
        QTest::newRow("drying in still air") << "drying_rate"
                                             << "air_speed_m_s=0";
        QTest::newRow("supercooled") << "saturation_concentration"
                                     << "temperature_c=-10";
        QTest::newRow("hot") << "saturation_concentration"
                             << "temperature_c=60";
        QTest::newRow("viscose, warm and damp") << "regain"
                                                << "material=viscose relative_humidity=0.95 temperature_c=36";
        QTest::newRow("hemp in the frost") << "regain"
                                           << "material=hemp relative_humidity=0.3 temperature_c=-10";
        QTest::newRow("cotton, bone-dry") << "regain"
                                          << "relative_humidity=0";
        QTest::newRow("cotton, saturated") << "regain"
                                           << "relative_humidity=1";
        QTest::newRow("viscose sheet") << "sorption_heating"
                                       << "material=viscose humidity_to=0.9";
        QTest::newRow("light sheet in fast air") << "sorption_heating"
                                                 << "areal_density_g_m2=20 mass_transfer_m_s=0.05 heat_transfer_w_m2k=50";
        QTest::newRow("heavy cotton sheet") << "sorption_heating"
                                            << "material=cotton areal_density_g_m2=1000 heat_transfer_w_m2k=10";
        QTest::newRow("sheet that dries") << "sorption_heating"
                                          << "humidity_from=0.8 humidity_to=0.2";
        QTest::newRow("silk sheet with diffusion") << "sorption_heating"
                                                   << "material=silk humidity_from=0.2 humidity_to=0.8 fibre_diffusivity_m2_s=5e-14";
        QTest::newRow("polyester wetted") << "adiabatic_wetting"
                                          << "material=polyester regain=0.007";
        QTest::newRow("viscose wetted") << "adiabatic_wetting"
                                        << "material=viscose regain=0.3";
        QTest::newRow("cotton, a little wetted") << "adiabatic_wetting"
                                                 << "regain=0.01";
        QTest::newRow("excellent management") << "management_indices"
                                              << "absorption_rate_bottom_pct_s=100 one_way_transport_pct=400 spreading_speed_bottom_mm_s=4";
        QTest::newRow("a small disc, one face") << "tester"
                                                << "radius_mm=4 content_pct=60 rise_s=10 bottom_share=0.25";
        QTest::newRow("a disc on the ring") << "tester"
                                            << "radius_mm=15 content_pct=200 rise_s=2";
        QTest::newRow("a disc into a ring's band") << "tester"
                                                   << "radius_mm=19.5 content_pct=300 rise_s=6 bottom_share=0.5";
        QTest::newRow("a disc past all rings, at once") << "tester"
                                                        << "radius_mm=35 content_pct=400 rise_s=0.25 bottom_share=0";
        QTest::newRow("at the grades' bounds") << "management_indices"
                                               << "wetting_time_top_s=3 wetting_time_bottom_s=120 maximum_wetted_radius_top_mm=22";
    }
    void otherValuesPassToo()
    {
        QFETCH(QString, name);
        QFETCH(QString, changes);
        std::map<std::string, std::string> values;
        for (const QString& change : changes.split(' '))
            values[change.section('=', 0, 0).toStdString()] = change.section('=', 1).toStdString();
        check(name.toStdString(), values, "cpu");
    }
    void whatDoesNotWetATubeDoesNotGetIntoIt_data()
    {
        QTest::addColumn<QString>("angle");
        for (const char* angle : {"90", "90.1", "120", "180"}) QTest::addRow("%s degrees", angle) << angle;
    }
    void whatDoesNotWetATubeDoesNotGetIntoIt()
    {
        QFETCH(QString, angle);
        const auto backend = make_cpu_backend();
        for (const auto& [name, result] : {std::pair("washburn", "distance_mm"), std::pair("jurin", "height_mm")}) {
            const VerifyReport report = run_verify_case(name, {{"contact_angle_deg", angle.toStdString()}}, *backend);
            QVERIFY(report.pass());
            QCOMPARE(report.results.size(), std::size_t(1));
            QCOMPARE(report.results[0].name, std::string(result));
            QCOMPARE(report.results[0].computed, 0.0);
            QCOMPARE(report.results[0].expected, 0.0);
        }
    }
    void aWordStandsForMoreThanOneCase()
    {
        QCOMPARE(verify_names("").size(), verify_cases().size());
        const std::vector<std::string> measured = verify_names("measured");
        QVERIFY(measured.size() > 10 && measured.size() < verify_cases().size());
        for (const std::string& name : measured) QVERIFY(QString::fromStdString(name).startsWith("measured_"));
        QCOMPARE(verify_names("jurin"), std::vector<std::string>{"jurin"});
    }
    void aMissIsNeverAPass()
    {
        VerifyReport report;
        report.results = {{"high", 2, 1, 0.5},
                          {"low enough", 2, 1, 0.5, Rule::at_least},
                          {"high again", 2, 1, 0.5, Rule::at_most, "known", {}, false, 1.1}};
        QVERIFY(!report.results[0].pass() && report.results[1].pass() && !report.results[2].pass());
        QVERIFY(!report.pass() && !report.as_expected());
        report.results.erase(report.results.begin());
        QVERIFY(!report.pass() && report.as_expected());
        report.results[1].miss_bound = 0.9; // it misses by 1
        QVERIFY(!report.as_expected());
        report.results[1].miss_bound = 1.1;
        report.results[1].blind = true;
        QVERIFY(!report.as_expected());
        report.results[1].blind = false;
        report.results[1].computed = std::nan("");
        QVERIFY(!report.as_expected());
        QVERIFY(known_miss({"low", 1.2, 1, 0.5}, "it holds", 2).known_miss.empty());
        QVERIFY(known_miss({"high", 2, 1, 0.5}, "it does not", 2).misses_as_known());
        VerifyResult ratio{"ratio", 1.0005, 1, 0, Rule::at_least};
        QVERIFY(ratio.pass() && !direction(ratio).pass() && direction(ratio).blind);
        ratio.computed = 1.0015;
        QVERIFY(direction(ratio).pass());
        VerifyResult grades{"grades"};
        grades.parts = {{"top", 3, 3}, {"bottom", 4, 4}};
        QVERIFY(grades.pass());
        grades.parts[1].computed = 5;
        QVERIFY(!grades.pass());
    }
    void wrongQuestionsAreAnsweredWithASentence_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("value");
        QTest::newRow("no such case") << "washboard"
                                      << "x"
                                      << "1";
        QTest::newRow("no such parameter") << "washburn"
                                           << "radius_mm"
                                           << "1";
        QTest::newRow("rods too far apart for a column") << "rod_column"
                                                         << "half_gap_um"
                                                         << "59.7";
        QTest::newRow("out of range") << "washburn"
                                      << "contact_angle_deg"
                                      << "181";
        QTest::newRow("time to a height that is never reached") << "washburn_gravity"
                                                                << "contact_angle_deg"
                                                                << "90";
        QTest::newRow("no number") << "washburn"
                                   << "radius_um"
                                   << "ten";
        QTest::newRow("nan") << "washburn"
                             << "radius_um"
                             << "nan";
        QTest::newRow("half a start") << "laplace_pressure"
                                      << "starts"
                                      << "1.5";
        QTest::newRow("half a particle") << "hydrostatic"
                                         << "particles"
                                         << "8000.5";
        QTest::newRow("between two modes") << "rayleigh_drop"
                                           << "mode"
                                           << "2.5";
        QTest::newRow("half a switch") << "sessile_drop"
                                       << "gravity"
                                       << "0.5";
        QTest::newRow("a little radiation") << "wet_bulb"
                                            << "radiation"
                                            << "0.1";
        QTest::newRow("half a shell") << "crank_cylinder"
                                      << "shells"
                                      << "4.5";
        QTest::newRow("no such material") << "regain"
                                          << "material"
                                          << "steel";
        QTest::newRow("no such fabric") << "conservation"
                                        << "fabric"
                                        << "Textile Z";
        QTest::newRow("higher than the strip") << "retention_column"
                                               << "height_mm"
                                               << "301";
        QTest::newRow("a yarn that water does not enter") << "supplied_yarn"
                                                          << "contact_angle_deg"
                                                          << "80";
        QTest::newRow("a slug of too many cells") << "slug_arrest"
                                                  << "slug_mm"
                                                  << "500";
        QTest::newRow("no such closure") << "conservation"
                                         << "closure"
                                         << "sponge";
        QTest::newRow("no such experiment") << "conservation"
                                            << "experiment"
                                            << "boiling";
    }
    void wrongQuestionsAreAnsweredWithASentence()
    {
        QFETCH(QString, name);
        QFETCH(QString, key);
        QFETCH(QString, value);
        const auto backend = make_cpu_backend();
        QVERIFY_EXCEPTION_THROWN(run_verify_case(name.toStdString(), {{key.toStdString(), value.toStdString()}}, *backend), Error);
    }
    void aRefusalSaysWhatIsAllowed_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("value");
        QTest::addColumn<QString>("sentence");
        QTest::newRow("number") << "washburn"
                                << "radius_um"
                                << "0"
                                << "radius_um: must be a number from 0.01 to 1000; \"0\" was given.";
        QTest::newRow("whole number") << "laplace_pressure"
                                      << "starts"
                                      << "1.5"
                                      << "starts: must be a whole number from 1 to 100; \"1.5\" was given.";
        QTest::newRow("switch") << "drop_conservation"
                                << "swelling"
                                << "0.5"
                                << "swelling: must be 0 or 1; \"0.5\" was given.";
    }
    void aRefusalSaysWhatIsAllowed()
    {
        QFETCH(QString, name);
        QFETCH(QString, key);
        QFETCH(QString, value);
        QFETCH(QString, sentence);
        const auto backend = make_cpu_backend();
        try {
            run_verify_case(name.toStdString(), {{key.toStdString(), value.toStdString()}}, *backend);
            QFAIL("This was not refused.");
        } catch (const Error& error) {
            QCOMPARE(QString(error.what()), sentence);
        }
    }
};

QTEST_APPLESS_MAIN(TestVerify)
#include "tst_verify.moc"
