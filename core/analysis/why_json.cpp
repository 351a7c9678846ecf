// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/why_json.h"

namespace hygroloom {
namespace {

using Json = nlohmann::ordered_json;

Json compared_value(const Compared& compared)
{
    return {{"difference", compared.difference},    {"low", compared.low},     {"high", compared.high},
            {"verdict", name_of(compared.verdict)}, {"pairs", compared.pairs}, {"share_of_pairs", compared.share_of_pairs}};
}

const char* method_of(const Why& why)
{
    if (!why.nothing.empty()) return "none";
    if (why.parts.size() == 1) return "only_part";
    return why.all_orders ? "shapley" : "one_at_a_time";
}

} // namespace

Json why_value(const Why& why)
{
    Json parts = Json::array();
    for (const Contribution& part : why.parts) {
        Json one{{"part", part.title}, {"keys", part.keys}, {"fabric_has", part.first}, {"baseline_has", part.second}};
        one.update(compared_value(part.compared));
        if (part.alone_in_fabric) one["alone_in_fabric"] = compared_value(*part.alone_in_fabric);
        if (part.alone_in_other) one["alone_in_baseline"] = compared_value(*part.alone_in_other);
        parts.push_back(std::move(one));
    }
    return {{"fabric", why.fabric},
            {"baseline", why.against},
            {"metric", why.metric.key},
            {"whole", why.whole ? compared_value(*why.whole) : Json(nullptr)},
            {"method", method_of(why)},
            {"fabrics", why.fabrics},
            {"replicates", why.replicates},
            {"contributions", parts},
            {"together", why.together ? compared_value(*why.together) : Json(nullptr)},
            {"sentences", sentences_of(why)}};
}

} // namespace hygroloom
