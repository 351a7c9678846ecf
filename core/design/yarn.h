// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A yarn as a designer gives it.
#pragma once

#include "core/design/material.h"

#include <cstdint>
#include <optional>

namespace hygroloom {

enum class TwistDirection { s, z };

/// How a yarn is made: see yarn_class.h.
enum class YarnClass { ring, rotor, plied, flat, textured, monofilament };
constexpr int yarn_classes = 6;

/// As screens show it (sRGB).
struct Color {
    std::uint8_t red = 0, green = 0, blue = 0;
    bool operator==(const Color&) const = default;
};

/// A bare filament in the middle of a yarn, which the yarn's fibres are spun round; in each single yarn of a plied one.
struct YarnCore {
    std::string material = "elastane";
    double share = 0.05; ///< of the yarn's mass
    bool operator==(const YarnCore&) const = default;
};

/// A yarn has a diameter, or a linear density with a packing factor; all three must agree.
/// With a diameter alone the packing factor is default_packing_factor, with a linear density alone that of its class: see packing_of().
/// Of a plied yarn, diameter and linear density are the whole yarn's; twist is that of its single yarns.
struct Yarn {
    std::vector<MaterialShare> material{{"cotton", 1.0}}; ///< of its fibres; those round the core where there is one
    std::optional<YarnCore> core;
    std::optional<double> diameter_mm; ///< of the free yarn
    std::optional<double> linear_density_tex;
    std::optional<double> packing_factor; ///< fibre volume / yarn volume
    std::optional<YarnClass> yarn_class;  ///< without it, see yarn_class_of()
    std::optional<int> filament_count;    ///< of continuous filaments; their radius then follows from it, not from the material
    int fibres_per_yarn = 30;             ///< drawn fibres (bundles of real ones)
    double twist_per_m = 700;
    TwistDirection twist_direction = TwistDirection::z;
    int plies = 1;
    double ply_twist_per_m = 400; ///< of two plies or more round each other
    TwistDirection ply_twist_direction = TwistDirection::s;
    std::optional<double> irregularity_cv; ///< coefficient of variation of the linear density along the yarn, 0 .. 0.4; see evenness.h
    std::optional<Color> color;            ///< without it, the undyed fibre's
    std::optional<double> price;           ///< of a kilogram, in any currency
    std::string library_yarn;              ///< name of the yarn of one's library that it refers to; empty: of none
    bool operator==(const Yarn&) const = default;
};

/// Names, the core's last.
inline std::vector<std::string> materials_in(const Yarn& yarn)
{
    std::vector<std::string> names;
    for (const MaterialShare& part : yarn.material) names.push_back(part.name);
    if (yarn.core) names.push_back(yarn.core->material);
    return names;
}

constexpr double least_tex = 0.05, most_tex = 50000; ///< of a whole yarn
constexpr int fewest_filaments = 2, most_filaments = 100000;
constexpr int most_plies = 6;
constexpr double least_core_share = 0.005, most_core_share = 0.4;
constexpr double default_packing_factor = 0.5; ///< of a yarn that is given by its diameter

} // namespace hygroloom
