// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "app/cli_replicates.h"

namespace hygroloom {

void add_replicates_option(CLI::App& verb, int& replicates, const std::string& whose)
{
    verb.add_option("--replicates", replicates,
                    "Number of runs" + whose +
                        ". With 1, the cloth is computed as described. With more, inputs that are not known, such as the "
                        "contact angle, are drawn at random in all runs but the first")
        ->check(CLI::Range(1, 1000));
}

} // namespace hygroloom
