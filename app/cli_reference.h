// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The option table of the program as values, from which reference, man page and shell completion are written.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace hygroloom {

struct DescribedOption {
    std::vector<std::string> names;   ///< "-o", "--output"; one in capitals for a positional argument
    std::string value;                ///< what stands after it, in words; empty for a flag
    std::vector<std::string> choices; ///< when it is one of a few words
    std::string usual;                ///< the value when left out
    std::string meaning;
    bool positional = false;
    bool required = false;
    bool takes_path = false; ///< a file or a folder
};

struct DescribedVerb {
    std::string name;
    std::string meaning;
    std::string example;
    std::string notes; ///< lines that follow the example
    std::vector<DescribedOption> options;
};

/// Those that the help lists, in its order.
std::vector<DescribedVerb> described_verbs(const CLI::App& app);
/// Of the program itself, without a verb.
std::vector<DescribedOption> described_options(const CLI::App& app);

std::string manual_page(const CLI::App& app);
std::string bash_completion(const CLI::App& app);
std::string zsh_completion(const CLI::App& app);
std::string fish_completion(const CLI::App& app);

} // namespace hygroloom
