// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/study/analysis_module.h"

#include "core/base/error.h"
#include "core/base/shipped_file.h"

#include <cstdlib>
#include <dlfcn.h>
#include <memory>
#include <mutex>

namespace hygroloom {
namespace {

using Ask = char* (*)(const char*);

struct Module {
    Ask ask = nullptr;
    std::string reason; ///< why there is none, in a sentence
};

/// It stays loaded.
Module load()
{
    std::string reason = "the module hygroloom_openturns.so is not there";
    if (const std::filesystem::path file = shipped_file("hygroloom_openturns.so"); !file.empty()) {
        void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (const auto ask = library ? reinterpret_cast<Ask>(dlsym(library, "hygroloom_openturns")) : nullptr) return {ask, ""};
        if (const char* error = dlerror()) reason = error;
    }
    return {nullptr, "Sensitivities, surfaces and suggestions need OpenTURNS, which is missing (" + reason +
                         "). Install the package hygroloom-study, or from the source run packaging/dependencies.sh and packaging/build.sh "
                         "--target hygroloom_openturns."};
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
