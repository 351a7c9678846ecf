// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Files to try the programs with: trial_files design SEED FILE writes a random project and prints how long it is worth being run, s;
// trial_files recording SEED FILE writes a recording that was changed at random and prints how; trial_files garment SEED FILE that of a
// worn garment.
#include "core/project/project_file.h"
#include "tests/support/crafted_wear.h"
#include "tests/support/random_design.h"

#include <cstdio>
#include <cstdlib>
#include <string>

using namespace hygroloom;

int main(int count, char** values)
{
    if (count != 4) return 2;
    const std::string what = values[1], file = values[3];
    const int seed = std::atoi(values[2]);
    if (what == "design") {
        double simulated = 0;
        write_project(random_design(seed, simulated), file);
        std::printf("%.9g\n", simulated);
        return 0;
    }
    const bool is_garment = what == "garment";
    is_garment ? write_small_wear_recording(file) : write_small_recording(file);
    std::uint8_t bytes[24];
    for (std::uint64_t i = 0; i < sizeof bytes; ++i)
        bytes[i] = static_cast<std::uint8_t>(256 * random_uniform(20261124, static_cast<std::uint64_t>(seed), i));
    const Choices choices(bytes, 4 + static_cast<std::size_t>(seed) % 20);
    std::printf("%s\n", craft(file, choices, is_garment ? targets_of_a_garment() : targets_of_a_sample()).c_str());
    return 0;
}
