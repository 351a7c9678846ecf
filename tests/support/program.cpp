// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// tests_core tst_weave [arguments of QtTest]
#include "tests/support/program.h"

#include <cstdio>
#include <filesystem>

namespace hygroloom {
namespace {

std::map<std::string, TestMain>& tests()
{
    static std::map<std::string, TestMain> all;
    return all;
}

} // namespace

bool take_up_test(const char* file, TestMain run) { return tests().emplace(std::filesystem::path(file).stem().string(), run).second; }

} // namespace hygroloom

int main(int count, char** values)
{
    const auto& all = hygroloom::tests();
    const auto found = count > 1 ? all.find(values[1]) : all.end();
    if (found == all.end()) {
        std::fprintf(stderr, "Name one of these tests first:\n");
        for (const auto& [name, run] : all) std::fprintf(stderr, "  %s\n", name.c_str());
        return 2;
    }
    values[1] = values[0];
    return found->second(count - 1, values + 1);
}
