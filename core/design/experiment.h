// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A laboratory experiment on a fabric.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace hygroloom {

struct Climate {
    double temperature_c = 25;
    double relative_humidity = 0.65; ///< 0..1
    double air_speed_m_s = 0.1;
    bool operator==(const Climate&) const = default;
};

struct Droplet {
    double volume_ul = 15;
    double time_s = 0;
    std::array<double, 2> at_mm{0, 0}; ///< from the sample's centre: along the weft, along the warp
    double height_mm = 2;              ///< of the drop's lowest point over the fabric
    double speed_m_s = 0;              ///< downwards, when it appears
    bool operator==(const Droplet&) const = default;
};

enum class ExperimentType { droplet };

struct Experiment {
    std::string name;
    ExperimentType type = ExperimentType::droplet;
    Climate climate;
    std::string liquid = "water";
    std::array<double, 2> sample_mm{20, 20}; ///< along the weft, along the warp
    double duration_s = 10;
    std::vector<Droplet> droplets{Droplet{}};
    bool operator==(const Experiment&) const = default;
};

} // namespace hygroloom
