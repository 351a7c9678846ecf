// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "app/cli_replicates.h"

namespace hygroloom {

void add_replicates_option(CLI::App& verb, int& replicates, const std::string& whose)
{
    verb.add_option("--replicates", replicates,
                    "Runs" + whose +
                        "; 1: the cloth as given. Of more the first is that, and the others have inputs drawn within "
                        "what is not known of them")
        ->check(CLI::Range(1, 1000));
}

} // namespace hygroloom
