// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Units and conversions between the trade's and SI. Each conversion stands here once.
#pragma once

#include "core/base/portable.h"

namespace hygroloom {

constexpr double pi = 3.14159265358979323846;
constexpr double zero_celsius = 273.15;          // K
constexpr double gravity_acceleration = 9.80665; // m/s2, standard gravity
constexpr double gas_constant = 8.314462618;     // J/(mol K), CODATA 2018
constexpr double water_molar_mass = 0.01801528;  // kg/mol
constexpr double standard_pressure = 101325.0;   // Pa

constexpr double metre_from_mm(double mm) { return mm * 1e-3; }
constexpr double mm_from_metre(double m) { return m * 1e3; }
constexpr double metre_from_um(double um) { return um * 1e-6; }
constexpr double um_from_metre(double m) { return m * 1e6; }
constexpr double cubic_metre_from_ul(double ul) { return ul * 1e-9; }
constexpr double newton_per_metre_from_mn_m(double mn_m) { return mn_m * 1e-3; }
constexpr double pascal_second_from_mpa_s(double mpa_s) { return mpa_s * 1e-3; }
constexpr double kelvin_from_celsius(double c) { return c + zero_celsius; }
constexpr double celsius_from_kelvin(double k) { return k - zero_celsius; }
constexpr double radian_from_degree(double d) { return d * (pi / 180.0); }

// Yarn counts: tex is g/km; Ne hanks of 840 yd per lb; Nm km per kg; denier g per 9 km.
constexpr double ne_from_tex(double tex) { return 590.5 / tex; }
constexpr double tex_from_ne(double ne) { return 590.5 / ne; }
constexpr double nm_from_tex(double tex) { return 1000.0 / tex; }
constexpr double tex_from_nm(double nm) { return 1000.0 / nm; }
constexpr double denier_from_tex(double tex) { return 9.0 * tex; }
constexpr double tex_from_denier(double denier) { return denier / 9.0; }
constexpr double per_inch_from_per_cm(double per_cm) { return 2.54 * per_cm; }
constexpr double per_cm_from_per_inch(double per_inch) { return per_inch / 2.54; }

} // namespace hygroloom
