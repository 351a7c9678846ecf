// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/study/analysis_module.h"

#include "core/base/error.h"

#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <memory>
#include <mutex>

namespace hygroloom {
namespace {

using Ask = char* (*)(const char*);

/// Where this code lies: the program, or a library that holds it.
std::filesystem::path own_file()
{
    std::error_code none;
    Dl_info info{};
    static const char place = 0;
    if (dladdr(&place, &info) != 0 && info.dli_fname) {
        const std::filesystem::path file = std::filesystem::canonical(info.dli_fname, none);
        if (!none) return file;
    }
    return std::filesystem::read_symlink("/proc/self/exe", none);
}

struct Module {
    Ask ask = nullptr;
    std::string reason; ///< why there is none, in a sentence
};

/// In the build beside bin, installed in lib/hygroloom; it stays loaded.
Module load()
{
    const std::filesystem::path folder = own_file().parent_path();
    std::string reason = "the module hygroloom_openturns.so is not there";
    for (const char* way : {"../lib/hygroloom", "../../lib/hygroloom", "../../hygroloom", "../hygroloom", "."}) {
        const std::filesystem::path file = folder / way / "hygroloom_openturns.so";
        std::error_code none;
        if (!std::filesystem::exists(file, none)) continue;
        void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (const auto ask = library ? reinterpret_cast<Ask>(dlsym(library, "hygroloom_openturns")) : nullptr) return {ask, ""};
        if (const char* error = dlerror()) reason = error;
    }
    return {nullptr, "Sensitivities, surfaces and suggestions need OpenTURNS, which is missing (" + reason +
                         "). Install the package hygroloom-study, or libopenturns-dev before Hygroloom is built."};
}

const Module& module()
{
    static const Module loaded = load();
    return loaded;
}

} // namespace

std::string why_no_module() { return module().reason; }

nlohmann::json ask_module(const nlohmann::json& request)
{
    if (!module().ask) throw Error(module().reason);
    static std::mutex one_at_a_time;
    const std::lock_guard lock(one_at_a_time);
    const std::unique_ptr<char, decltype(&std::free)> text(module().ask(request.dump().c_str()), &std::free);
    if (!text) throw Error("The analysis ran out of memory.");
    nlohmann::json answer = nlohmann::json::parse(text.get());
    if (answer.contains("error")) throw Error("The analysis failed: " + answer.at("error").get<std::string>());
    return answer;
}

} // namespace hygroloom
