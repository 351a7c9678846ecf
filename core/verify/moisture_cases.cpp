// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Fibres, vapour and heat of single segments against Crank, the wet bulb, the isotherm and IAPWS.
#include "core/physics/air.h"
#include "core/physics/sorption.h"
#include "core/solver/steps/yarn_lines.h"
#include "core/verify/set_ups.h"
#include "core/verify/verify.h"

#include <algorithm>

namespace hygroloom {
namespace {

/// The n-th zero of J0: McMahon, then Newton.
double bessel_root(int n)
{
    double root = (n - 0.25) * pi;
    for (int i = 0; i < 20; ++i) root += std::cyl_bessel_j(0.0, root) / std::cyl_bessel_j(1.0, root);
    return root;
}

/// Share of the final uptake of a cylinder whose skin steps to a value at time 0 (Crank 1975, eq. 5.23); fourier = D t / R^2.
double crank_uptake(double fourier)
{
    if (fourier < 1e-3) { // short times: two terms of the expansion, below 1e-5 here
        return 4.0 * std::sqrt(fourier / pi) - fourier - std::pow(fourier, 1.5) / (3.0 * std::sqrt(pi));
    }
    double sum = 0;
    for (int n = 1; n <= 60; ++n) {
        const double root = bessel_root(n);
        sum += 4.0 / (root * root) * std::exp(-root * root * fourier);
    }
    return 1.0 - sum;
}

/// Concentration at r = position R over the skin's (Crank 1975, eq. 5.22).
double crank_concentration(double fourier, double position)
{
    double sum = 0;
    for (int n = 1; n <= 200; ++n) {
        const double root = bessel_root(n);
        sum += 2.0 * std::exp(-root * root * fourier) * std::cyl_bessel_j(0.0, root * position) / (root * std::cyl_bessel_j(1.0, root));
    }
    return 1.0 - sum;
}

/// On lines over the section within through the middles of the shells of segment 0, and from the last one's to the skin.
double regain_at(const Frame& frame, int shells, double skin, double section)
{
    const auto start = [&](int k) { return 2.0 - std::exp2(1.0 - static_cast<double>(k) / shells); };
    const auto middle = [&](int k) { return 0.5 * (start(k) + start(k + 1)); };
    int outer = 1;
    while (outer < shells && middle(outer) < section) ++outer;
    const auto at = [&](int k) { return static_cast<double>(frame.shells[k]); };
    const bool is_skin = outer == shells;
    const double inner = middle(outer - 1), share = (section - inner) / ((is_skin ? 1.0 : middle(outer)) - inner);
    return at(outer - 1) + share * ((is_skin ? skin : at(outer)) - at(outer - 1));
}

std::vector<VerifyResult> crank_cylinder(const VerifyValues& v, Backend& backend)
{
    const double fourier = value(v, "fourier");
    Scene scene = bare_scene(1, 1, 1e-3, isotherm_temperature);
    scene.rules.sorption = true;
    scene.rules.fibre_shells = static_cast<int>(value(v, "shells"));
    scene.rules.shows_shells = true;
    scene.cloth.yarns[0].fibre_area = 1e-6 * scene.cloth.yarns[0].pore_area; // the liquid outlasts what the fibre takes
    const double full = scene.climate.density * scene.cloth.yarns[0].pore_area * scene.cloth.length[0];
    scene.cloth.start.liquid = {full, full};
    const double time =
        fourier * scene.cloth.yarns[0].fibre_radius * scene.cloth.yarns[0].fibre_radius / scene.cloth.yarns[0].diffusivity.constant;
    scene.rules.network_step = time / 8000;
    const Frame frame = frames_at(backend, scene, {time}).front();
    const double expected = crank_uptake(fourier), position = value(v, "position"),
                 skin = regain_at_reference(scene.cloth.yarns[0].isotherm, 1.0);
    return {{"uptake", static_cast<double>(frame.regain[0]) / skin, expected, 0.005 * expected},
            {"concentration", regain_at(frame, scene.rules.fibre_shells, skin, position * position) / skin,
             crank_concentration(fourier, position), 0.01}};
}

struct AirExchange {
    double temperature, vapour, heat_transfer, mass_transfer;
};

/// Where evaporation takes exactly the heat that the air brings, or the air the heat that condensation gives.
double wet_bulb_temperature(const AirExchange& air)
{
    double low = air.temperature - 60, high = air.temperature + 60;
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (low + high);
        const double surplus = air.heat_transfer * (air.temperature - middle) -
                               air.mass_transfer * heat_of_evaporation(middle) * (saturation_concentration(middle) - air.vapour);
        (surplus > 0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// A crossing with wet pores in moving air.
Scene drying_scene(const AirExchange& air, double humidity)
{
    Scene scene = bare_scene(1, 1, 1e-3, air.temperature);
    scene.rules.vapour = scene.rules.heat = true;
    scene.cloth.face_only = true;
    scene.climate.humidity = humidity;
    scene.climate.vapour = air.vapour;
    scene.climate.heat_transfer = air.heat_transfer;
    scene.climate.mass_transfer = air.mass_transfer;
    for (YarnParameters& yarn : scene.cloth.yarns) {
        yarn.fibre_specific_heat *= 0.1; // little to cool: the liquid outlasts it
        yarn.fibre_radius = 1e-6;        // much surface: the air outside is all that holds evaporation back
    }
    const double saturation = humidity > 1 ? 0.5 : 0.9; // of full pores there is hardly any air; what condenses needs room
    const double liquid = saturation * scene.climate.density * scene.cloth.yarns[0].pore_area * scene.cloth.length[0];
    scene.cloth.start.liquid = {liquid, liquid};
    return scene;
}

/// Time in which the air brings a crossing's heat capacity once round, s.
double settling_time(const Scene& scene, const AirExchange& air)
{
    const YarnParameters& yarn = scene.cloth.yarns[0];
    const double capacity = yarn.fibre_area * scene.cloth.length[0] * yarn.fibre_density * yarn.fibre_specific_heat +
                            scene.cloth.start.liquid[0] * water_specific_heat;
    return capacity / (air.heat_transfer * scene.cloth.cell_area);
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
    const double settle = 8.0 * settling_time(scene, air);
    scene.rules.network_step = settle / 400;
    const Frame frame = frames_at(backend, scene, {settle}).front();
    return {{"temperature_c", celsius_from_kelvin(frame.temperature[0]), celsius_from_kelvin(wet_bulb_temperature(air)), 0.25}};
}

std::vector<VerifyResult> drying_rate(const VerifyValues& v, Backend& backend)
{
    const AirExchange air = air_of(v, convective_heat_transfer(value(v, "air_speed_m_s"), 1e-3 * value(v, "length_mm")));
    Scene scene = drying_scene(air, value(v, "relative_humidity"));
    const double settle = 8.0 * settling_time(scene, air);
    scene.rules.network_step = settle / 800;
    const std::vector<Frame> frames = frames_at(backend, scene, {settle, 1.25 * settle});
    const double rate =
        (frames[1].ledger.water_evaporated - frames[0].ledger.water_evaporated) / (0.25 * settle * 2.0 * scene.cloth.cell_area);
    const double wet = wet_bulb_temperature(air);
    const double expected = 3.6e6 * air.mass_transfer * (saturation_concentration(wet) - air.vapour);
    // In saturated air nothing is left but what rounding leaves of two equal concentrations.
    const double rounding = 1e-12 * 3.6e6 * air.mass_transfer * air.vapour;
    return {{"surface_temperature_c", celsius_from_kelvin(frames[1].temperature[0]), celsius_from_kelvin(wet), 0.25},
            {"rate_g_m2_h", 3.6e6 * rate, expected, 0.05 * std::abs(expected) + rounding}};
}

/// Vapour pressure over water, Pa: Wagner and Pruss 2002 (IAPWS-95 auxiliary equation); below 0 C, of supercooled water, Murphy and
/// Koop 2005.
double reference_saturation_pressure(double temperature)
{
    if (temperature < 273.15) {
        const double log = std::log(temperature);
        return std::exp(54.842763 - 6763.22 / temperature - 4.210 * log + 0.000367 * temperature +
                        std::tanh(0.0415 * (temperature - 218.8)) *
                            (53.878 - 1331.22 / temperature - 9.44523 * log + 0.014025 * temperature));
    }
    const double tau = 1.0 - temperature / 647.096;
    const double sum = -7.85951783 * tau + 1.84408259 * std::pow(tau, 1.5) - 11.7866497 * std::pow(tau, 3) +
                       22.6807411 * std::pow(tau, 3.5) - 15.9618719 * std::pow(tau, 4) + 1.80122502 * std::pow(tau, 7.5);
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
    const double temperature = kelvin_from_celsius(value(v, "temperature_c")), humidity = value(v, "relative_humidity");
    const Scene scene = fibre_in_air(library_material(v.at("material").word), temperature, humidity);
    const Frame frame = frames_at(backend, scene, {time_to_condition}).front();

    // The isotherm at 20 C, shifted by Clausius and Clapeyron with the heat of sorption, solved by bisection.
    double low = 0, high = 1;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        const double here =
            middle * std::exp(-heat_of_sorption(middle) * water_molar_mass / gas_constant * (1.0 / temperature - 1.0 / 293.15));
        (here < std::min(1.0, humidity) ? low : high) = middle; // fibres are full in saturated air
    }
    const double expected = regain_at_reference(scene.cloth.yarns[0].isotherm, 0.5 * (low + high));
    return {{"regain", frame.regain[0], expected, std::max(1e-6, 0.03 * expected)}};
}

} // namespace

std::vector<VerifyCase> moisture_cases()
{
    const VerifyParameter humidity{"relative_humidity", 0.65, 0, most_humidity, ""};
    return {
        {"crank_cylinder",
         "A fibre in liquid: share of the final uptake, and the water at a place in it, against Crank's series for a cylinder.",
         {{"fourier", 0.1, 5e-3, 10, ""}, {"position", 0.5, 0, 1, ""}, whole_number("shells", largest_shell_count, 1, largest_shell_count)},
         crank_cylinder},
        {"wet_bulb",
         "A wet crossing in an air stream: its temperature against the balance of heat and evaporation.",
         {{"temperature_c", 20, -10, 60, ""}, humidity, on_or_off("radiation", false)},
         wet_bulb},
        {"drying_rate",
         "A wet crossing in air flowing along a sample: temperature and rate of drying of each face.",
         {{"temperature_c", 20, -10, 60, ""},
          humidity,
          {"air_speed_m_s", 1, 0, 20, ""},
          {"length_mm", 80, 1, 2000, ""},
          on_or_off("radiation", false)},
         drying_rate},
        {"saturation_concentration",
         "Vapour over water against the IAPWS reference equation.",
         {{"temperature_c", 20, -20, 90, ""}},
         saturation},
        {"regain",
         "A fibre left long in a climate: regain against its isotherm.",
         {{"material", 0, 0, 0, "cotton"}, {"temperature_c", 20, -10, 60, ""}, humidity},
         regain},
    };
}

} // namespace hygroloom
