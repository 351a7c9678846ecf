// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Fibres, vapour and heat of single segments against Crank, the wet bulb, the isotherm and IAPWS.
#include "core/base/error.h"
#include "core/design/design.h"
#include "core/physics/air.h"
#include "core/physics/sorption.h"
#include "core/verify/set_ups.h"
#include "core/verify/verify.h"


namespace hygroloom {
namespace {

double value(const VerifyValues& values, const char* name) { return values.at(name).value; }

/// Share of the final uptake of a cylinder whose skin steps to a value at time 0 (Crank 1975, eq. 5.23); fourier = D t / R^2.
double crank_uptake(double fourier)
{
    if (fourier < 1e-3) { // short times: two terms of the expansion, below 1e-5 here
        return 4.0 * std::sqrt(fourier / pi) - fourier - std::pow(fourier, 1.5) / (3.0 * std::sqrt(pi));
    }
    double sum = 0;
    for (int n = 1; n <= 60; ++n) {
        double root = (n - 0.25) * pi; // zero of J0: McMahon, then Newton
        for (int i = 0; i < 20; ++i) root += std::cyl_bessel_j(0.0, root) / std::cyl_bessel_j(1.0, root);
        sum += 4.0 / (root * root) * std::exp(-root * root * fourier);
    }
    return 1.0 - sum;
}

std::vector<VerifyResult> crank_cylinder(const VerifyValues& v, Backend& backend)
{
    const double fourier = value(v, "fourier");
    Scene scene = bare_scene(1, 1, 1e-3, isotherm_temperature);
    scene.sorption = true;
    scene.fibre_shells = static_cast<int>(value(v, "shells"));
    scene.yarns[0].fibre_area = 1e-6 * scene.yarns[0].pore_area; // the liquid outlasts what the fibre takes
    const double full = scene.climate.density * scene.yarns[0].pore_area * scene.length[0];
    scene.initial_liquid = {full, full};
    const double time = fourier * scene.yarns[0].fibre_radius * scene.yarns[0].fibre_radius / scene.yarns[0].diffusivity.constant;
    scene.network_step = time / 8000;
    const Frame frame = frames_at(backend, scene, {time}).front();
    const double expected = crank_uptake(fourier);
    return {
        {"uptake", static_cast<double>(frame.regain[0]) / regain_at_reference(scene.yarns[0].isotherm, 1.0), expected, 0.005 * expected}};
}

struct AirExchange {
    double temperature, vapour, heat_transfer, mass_transfer;
};

/// Where evaporation takes exactly the heat that the air brings.
double wet_bulb_temperature(const AirExchange& air)
{
    double low = air.temperature - 60, high = air.temperature;
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (low + high);
        const double surplus = air.heat_transfer * (air.temperature - middle) -
                               air.mass_transfer * heat_of_evaporation(middle) * (saturation_concentration(middle) - air.vapour);
        (surplus > 0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// A crossing with full pores in moving air.
Scene drying_scene(const AirExchange& air, double humidity)
{
    Scene scene = bare_scene(1, 1, 1e-3, air.temperature);
    scene.vapour = scene.heat = true;
    scene.face_only = true;
    scene.climate.humidity = humidity;
    scene.climate.vapour = air.vapour;
    scene.climate.heat_transfer = air.heat_transfer;
    scene.climate.mass_transfer = air.mass_transfer;
    const double full = scene.climate.density * scene.yarns[0].pore_area * scene.length[0];
    scene.initial_liquid = {full, full};
    return scene;
}

AirExchange air_of(const VerifyValues& v, double convection)
{
    const double temperature = kelvin_from_celsius(value(v, "temperature_c"));
    const double radiation = value(v, "radiation") > 0.5 ? radiative_heat_transfer(temperature) : 0.0;
    return {temperature, value(v, "relative_humidity") * saturation_concentration(temperature), convection + radiation,
            mass_transfer(convection, temperature)};
}

std::vector<VerifyResult> wet_bulb(const VerifyValues& v, Backend& backend)
{
    // Radiation as large as convection, as in the published column.
    AirExchange air = air_of(v, 5.0);
    air.heat_transfer = value(v, "radiation") > 0.5 ? 10.0 : 5.0;
    Scene scene = drying_scene(air, value(v, "relative_humidity"));
    const double capacity = scene.yarns[0].fibre_area * scene.length[0] * 1550 * 1250 + scene.initial_liquid[0] * water_specific_heat;
    const double settle = 12.0 * capacity / (air.heat_transfer * scene.cell_area);
    scene.network_step = settle / 400;
    const Frame frame = frames_at(backend, scene, {settle}).front();
    return {{"temperature_c", celsius_from_kelvin(frame.temperature[0]), celsius_from_kelvin(wet_bulb_temperature(air)), 0.25}};
}

std::vector<VerifyResult> drying_rate(const VerifyValues& v, Backend& backend)
{
    const AirExchange air = air_of(v, convective_heat_transfer(value(v, "air_speed_m_s"), 1e-3 * value(v, "length_mm")));
    Scene scene = drying_scene(air, value(v, "relative_humidity"));
    const double capacity = scene.yarns[0].fibre_area * scene.length[0] * 1550 * 1250 + scene.initial_liquid[0] * water_specific_heat;
    const double settle = 8.0 * capacity / (air.heat_transfer * scene.cell_area);
    scene.network_step = settle / 800;
    const std::vector<Frame> frames = frames_at(backend, scene, {settle, 1.25 * settle});
    const double rate = (frames[1].ledger.water_evaporated - frames[0].ledger.water_evaporated) / (0.25 * settle * 2.0 * scene.cell_area);
    const double wet = wet_bulb_temperature(air);
    const double expected = 3.6e6 * air.mass_transfer * (saturation_concentration(wet) - air.vapour);
    return {{"surface_temperature_c", celsius_from_kelvin(frames[1].temperature[0]), celsius_from_kelvin(wet), 0.25},
            {"rate_g_m2_h", 3.6e6 * rate, expected, 0.05 * expected}};
}

/// Vapour pressure over water, Pa: Wagner and Pruss 2002 (IAPWS-95 auxiliary equation), down to 0 C.
double reference_saturation_pressure(double temperature)
{
    const double tau = 1.0 - temperature / 647.096;
    const double sum = -7.85951783 * tau + 1.84408259 * std::pow(tau, 1.5) - 11.7866497 * std::pow(tau, 3) + 22.6807411 * std::pow(tau, 3.5) -
                       15.9618719 * std::pow(tau, 4) + 1.80122502 * std::pow(tau, 7.5);
    return 22.064e6 * std::exp(647.096 / temperature * sum);
}

std::vector<VerifyResult> saturation(const VerifyValues& v, Backend&)
{
    const double temperature = kelvin_from_celsius(value(v, "temperature_c"));
    const double expected = 1e3 * reference_saturation_pressure(temperature) / (vapour_gas_constant * temperature);
    return {{"concentration_g_m3", 1e3 * saturation_concentration(temperature), expected, 0.002 * expected}};
}

std::vector<VerifyResult> regain(const VerifyValues& v, Backend& backend)
{
    const std::string& name = v.at("material").word;
    const Material* material = find_material(Design{}, name);
    if (!material) throw Error("There is no material \"" + name + "\" in the library.");
    const double temperature = kelvin_from_celsius(value(v, "temperature_c")), humidity = value(v, "relative_humidity");
    Scene scene = bare_scene(1, 1, 1e-3, temperature);
    scene.sorption = scene.vapour = true;
    scene.fibre_shells = 8;
    scene.climate.humidity = humidity;
    scene.climate.vapour = humidity * saturation_concentration(temperature);
    scene.climate.mass_transfer = 0.01;
    for (YarnParameters& yarn : scene.yarns) {
        yarn.isotherm = {material->standard_regain, material->saturation_regain, material->gab.monolayer_regain, material->gab.c,
                         material->gab.k};
        yarn.diffusivity.constant = 1e-12; // only the end matters here
        yarn.initial_regain = 0;
        yarn.resting_regain = equilibrium_regain(yarn.isotherm, humidity, temperature);
    }
    scene.network_step = 5.0;
    const Frame frame = frames_at(backend, scene, {40000.0}).front();

    // The isotherm at 20 C, shifted by Clausius and Clapeyron with the heat of sorption, solved by bisection.
    double low = 0, high = 1;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        const double here = middle * std::exp(-heat_of_sorption(middle) * water_molar_mass / gas_constant * (1.0 / temperature - 1.0 / 293.15));
        (here < humidity ? low : high) = middle;
    }
    const double expected = regain_at_reference(scene.yarns[0].isotherm, 0.5 * (low + high));
    return {{"regain", frame.regain[0], expected, 0.03 * expected}};
}

} // namespace

std::vector<VerifyCase> moisture_cases()
{
    return {
        {"crank_cylinder", "A fibre in liquid: share of the final uptake against Crank's series for a cylinder.",
         {{"fourier", 0.1, 1e-4, 2, ""}, {"shells", 20, 1, largest_shell_count, ""}}, crank_cylinder},
        {"wet_bulb", "A wet crossing in an air stream: its temperature against the balance of heat and evaporation.",
         {{"temperature_c", 20, 1, 60, ""}, {"relative_humidity", 0.65, 0, 1, ""}, {"radiation", 0, 0, 1, ""}}, wet_bulb},
        {"drying_rate", "A wet crossing in air flowing along a sample: temperature and rate of drying of each face.",
         {{"temperature_c", 20, 1, 60, ""}, {"relative_humidity", 0.65, 0, 0.99, ""}, {"air_speed_m_s", 1, 0, 20, ""}, {"length_mm", 80, 1, 2000, ""},
          {"radiation", 0, 0, 1, ""}},
         drying_rate},
        {"saturation_concentration", "Vapour over water against the IAPWS reference equation.", {{"temperature_c", 20, 0, 90, ""}}, saturation},
        {"regain", "A fibre left long in a climate: regain against its isotherm.",
         {{"material", 0, 0, 0, "cotton"}, {"temperature_c", 20, -10, 60, ""}, {"relative_humidity", 0.65, 0, 1, ""}}, regain},
    };
}

} // namespace hygroloom
