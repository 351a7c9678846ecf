// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The mathematics of core/study/analysis.h by OpenTURNS, as a module that is loaded when it is asked for: JSON in, JSON out. Its library
// takes 0.1 s to load, which programs that do not ask for it do not wait for.
#include "core/study/openturns/module.h"

#include <nlohmann/json.hpp>
#include <openturns/ConstantBasisFactory.hxx>
#include <openturns/Exception.hxx>
#include <openturns/KrigingAlgorithm.hxx>
#include <openturns/Log.hxx>
#include <openturns/MartinezSensitivityAlgorithm.hxx>
#include <openturns/MaternModel.hxx>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

namespace {

using Json = nlohmann::json;

OT::Sample sample_of(const Json& rows)
{
    const std::size_t columns = rows.empty() ? 0 : rows[0].size();
    OT::Sample sample(rows.size(), columns);
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t k = 0; k < columns; ++k) sample(i, k) = rows.at(i).at(k).get<double>();
    return sample;
}

/// Of a design in blocks: one sample, another, and the first with one column of the other for each factor (Martinez 2011, by correlations).
Json indices(const Json& request)
{
    const auto samples = request.at("samples").get<std::size_t>(), factors = request.at("factors").get<std::size_t>();
    const auto outputs = request.at("outputs").get<std::vector<double>>();
    OT::Sample y(outputs.size(), 1);
    for (std::size_t i = 0; i < outputs.size(); ++i) y(i, 0) = outputs[i];
    OT::MartinezSensitivityAlgorithm algorithm(OT::Sample(outputs.size(), factors), y, samples);
    algorithm.setUseAsymptoticDistribution(true);
    algorithm.setConfidenceLevel(0.95);
    const OT::Point first = algorithm.getFirstOrderIndices(), total = algorithm.getTotalOrderIndices();
    const OT::Interval first_interval = algorithm.getFirstOrderIndicesInterval(), total_interval = algorithm.getTotalOrderIndicesInterval();
    Json result;
    for (std::size_t k = 0; k < factors; ++k) {
        result["first"].push_back(first[k]);
        result["first_low"].push_back(first_interval.getLowerBound()[k]);
        result["first_high"].push_back(first_interval.getUpperBound()[k]);
        result["total"].push_back(total[k]);
        result["total_low"].push_back(total_interval.getLowerBound()[k]);
        result["total_high"].push_back(total_interval.getUpperBound()[k]);
    }
    return result;
}

/// What a surface is besides its points: how far it reaches along each input, its height, and the share of noise in that.
struct SurfaceState {
    std::vector<double> scale;
    double amplitude = 1, nugget = 0;
};

OT::MaternModel kernel_of(const SurfaceState& state)
{
    OT::MaternModel kernel(OT::Point(state.scale.begin(), state.scale.end()), OT::Point(1, state.amplitude), 2.5);
    kernel.setNuggetFactor(state.nugget);
    return kernel;
}

/// Outputs about 0 with a spread of 1.
struct Standard {
    double mean = 0, spread = 1;
    explicit Standard(const std::vector<double>& values)
    {
        for (const double v : values) mean += v / static_cast<double>(values.size());
        double variance = 0;
        for (const double v : values) variance += (v - mean) * (v - mean) / static_cast<double>(values.size());
        if (variance > 0) spread = std::sqrt(variance);
    }
    OT::Sample of(const std::vector<double>& values) const
    {
        OT::Sample sample(values.size(), 1);
        for (std::size_t i = 0; i < values.size(); ++i) sample(i, 0) = (values[i] - mean) / spread;
        return sample;
    }
};

/// The surface through points with a state that stays as it is.
OT::KrigingResult fixed_surface(const OT::Sample& x, const OT::Sample& y, const SurfaceState& state)
{
    OT::KrigingAlgorithm algorithm(x, y, kernel_of(state), OT::ConstantBasisFactory(x.getDimension()).build());
    algorithm.setOptimizeParameters(false);
    algorithm.run();
    return algorithm.getResult();
}

/// The most likely state for a given noise, and how likely it is (logarithm).
std::pair<SurfaceState, double> most_likely(const OT::Sample& x, const OT::Sample& y, SurfaceState state)
{
    const OT::UnsignedInteger dimension = x.getDimension();
    OT::KrigingAlgorithm algorithm(x, y, kernel_of(state), OT::ConstantBasisFactory(dimension).build());
    algorithm.setOptimizationBounds(OT::Interval(OT::Point(dimension, 0.03), OT::Point(dimension, 30.0)));
    algorithm.run();
    const OT::Point found = algorithm.getResult().getCovarianceModel().getFullParameter();
    for (std::size_t k = 0; k < dimension; ++k) state.scale[k] = algorithm.getResult().getCovarianceModel().getScale()[k];
    state.amplitude = algorithm.getResult().getCovarianceModel().getAmplitude()[0];
    const double likelihood = algorithm.getReducedLogLikelihoodFunction()(OT::Point(state.scale.begin(), state.scale.end()))[0];
    return {state, likelihood};
}

/// Share of the variance that the state predicts of points that are left out, a tenth of them at a time.
double left_out_share(const OT::Sample& x, const OT::Sample& y, const SurfaceState& state)
{
    const std::size_t count = x.getSize(), folds = std::min<std::size_t>(10, count);
    double missed = 0, all = 0;
    for (std::size_t fold = 0; fold < folds; ++fold) {
        OT::Indices kept, left;
        for (std::size_t i = 0; i < count; ++i) (i % folds == fold ? left : kept).add(i);
        const OT::Sample predicted = fixed_surface(x.select(kept), y.select(kept), state).getConditionalMean(x.select(left));
        for (std::size_t i = 0; i < left.getSize(); ++i) {
            missed += std::pow(predicted(i, 0) - y(left[i], 0), 2);
            all += std::pow(y(left[i], 0), 2); // their mean is 0
        }
    }
    return all > 0 ? 1 - missed / all : 1;
}

Json fit(const Json& request)
{
    const OT::Sample x = sample_of(request.at("inputs"));
    const auto outputs = request.at("outputs").get<std::vector<double>>();
    const OT::Sample y = Standard(outputs).of(outputs);
    SurfaceState best;
    double likelihood = -INFINITY;
    for (const double nugget : {1e-8, 1e-4, 1e-3, 1e-2, 0.05, 0.2, 0.6}) { // what a run's particles add at random
        SurfaceState start{std::vector<double>(x.getDimension(), 0.5 * std::sqrt(static_cast<double>(x.getDimension()))), 1, nugget};
        try {
            const auto [state, here] = most_likely(x, y, start);
            if (!(here > likelihood)) continue;
            likelihood = here;
            best = state;
        } catch (const OT::Exception&) { // points too near to each other for so little noise
        }
    }
    if (best.scale.empty()) throw std::runtime_error("The surface cannot be fitted to these points.");
    const double share = left_out_share(x, y, best);
    return {{"scale", best.scale}, {"amplitude", best.amplitude}, {"nugget", best.nugget}, {"q2", share}};
}

Json predict(const Json& request)
{
    const auto outputs = request.at("outputs").get<std::vector<double>>();
    const Standard standard(outputs);
    const Json& given = request.at("state");
    const SurfaceState state{given.at("scale").get<std::vector<double>>(), given.at("amplitude").get<double>(),
                             given.at("nugget").get<double>()};
    const OT::KrigingResult surface = fixed_surface(sample_of(request.at("inputs")), standard.of(outputs), state);
    const OT::Sample at = sample_of(request.at("at"));
    const OT::Sample mean = surface.getConditionalMean(at);
    Json result{{"mean", Json::array()}, {"sd", Json::array()}};
    const bool with_sd = request.value("with_sd", true);
    for (std::size_t i = 0; i < at.getSize(); ++i) {
        result["mean"].push_back(standard.mean + standard.spread * mean(i, 0));
        if (with_sd) result["sd"].push_back(standard.spread * std::sqrt(std::max(0.0, surface.getConditionalMarginalVariance(at[i]))));
    }
    return result;
}

Json answer(const Json& request)
{
    const auto what = request.at("do").get<std::string>();
    if (what == "indices") return indices(request);
    if (what == "fit") return fit(request);
    if (what == "predict") return predict(request);
    return {{"error", "The module cannot do \"" + what + "\"."}};
}

} // namespace

extern "C" char* hygroloom_openturns(const char* request)
{
    std::string text;
    try {
        OT::Log::Show(OT::Log::NONE);
        text = answer(Json::parse(request)).dump();
    } catch (const std::exception& error) {
        text = Json{{"error", error.what()}}.dump(-1, ' ', false, Json::error_handler_t::replace);
    }
    return strdup(text.c_str());
}
