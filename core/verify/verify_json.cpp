// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/verify/verify_json.h"

#include <nlohmann/json.hpp>

namespace hygroloom {

using Json = nlohmann::ordered_json;

Json parameters_value(const std::vector<VerifyParameter>& parameters)
{
    Json json = Json::object();
    for (const VerifyParameter& p : parameters) json[p.name] = p.word.empty() ? Json(p.value) : Json(p.word);
    return json;
}

Json report_value(const VerifyReport& report)
{
    Json results = Json::array();
    for (const VerifyResult& r : report.results) {
        Json result{{"name", r.name}, {"computed", r.computed}, {"expected", r.expected}, {"tolerance", r.tolerance}, {"pass", r.pass()}};
        if (!r.parts.empty()) result["computed"] = result["expected"] = Json::object();
        for (const VerifyPart& p : r.parts) {
            result["computed"][p.name] = p.computed;
            result["expected"][p.name] = p.expected;
        }
        if (r.rule != Rule::near) result["rule"] = r.rule == Rule::at_most ? "at_most" : "at_least";
        if (r.blind) result["blind"] = true;
        if (!r.known_miss.empty()) result.update({{"known_miss", r.known_miss}, {"known_miss_bound", r.miss_bound}});
        results.push_back(result);
    }
    Json json{{"case", report.name}, {"parameters", parameters_value(report.parameters)}, {"results", results}, {"wall_s", report.wall}};
    if (!report.source.empty()) json["compared_with"] = report.source;
    if (!report.not_applicable.empty()) json["not_applicable"] = report.not_applicable;
    return json;
}

} // namespace hygroloom
