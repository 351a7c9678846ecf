// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Fits the few inputs of a fabric that are not known to what a laboratory measured, and says how sure they are, or why they cannot be told.
#pragma once

#include "core/analysis/measured_data.h"
#include "core/analysis/page.h"
#include "core/design/free_inputs.h"
#include "core/run/run_options.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace hygroloom {

struct FittedInput : FreeInput {
    double value = 0;
    double half = 0;      ///< half width of the 90 % interval
    double uneven = 0;    ///< the part of it by how unevenly the runs follow the input; the parts add up as squares
    double numerical = 0; ///< the part of it that the numerical errors of the runs make
};

struct Calibration {
    std::string fabric, experiment;
    Fidelity fidelity = Fidelity::standard;
    MeasuredData data;
    std::vector<FittedInput> inputs;
    std::vector<double> before, fitted;           ///< simulated, of each measured number: with the inputs as given, and as fitted
    double residual_rms_before = 0;               ///< root mean square of measured less simulated, in the curve's unit; of metrics
    double residual_rms = 0;                      ///< in their spreads, where they have them
    std::vector<std::vector<double>> correlation; ///< of the fitted inputs' errors
    std::vector<std::string> notes;               ///< what limits the result, in sentences
    std::string refusal;                          ///< why the data do not tell the inputs, in a sentence; empty: they do
    bool identifiable() const { return refusal.empty(); }
};

/// What the experiment gives of each measured number with the inputs at each of some points, in their order.
using Model = std::function<std::vector<std::vector<double>>(const std::vector<std::vector<double>>& points)>;

/// Of a simulated number, in its unit.
struct NumberError {
    std::optional<double> half; ///< of the 90 % interval of its numerical error; none: not known. All numbers of a curve err alike
    double step = 0;            ///< by which it jumps, as water that stands at one crossing or the next; 0: it does not
};
using NumberErrors = std::function<std::vector<NumberError>(const std::vector<double>& simulated)>;

/// Fits by least squares (Levenberg-Marquardt, from the given values, within the ranges). Residuals are weighed by the spreads, if given.
/// The intervals follow from the Jacobian: by the spreads where given, widened where the residuals are larger; else by Student's law from
/// the residuals, whose size may change along a curve (MacKinnon and White 1985, HC3) and of which neighbours that deviate alike count as
/// fewer. What moves all numbers of a curve alike does not show in the residuals, as the fit takes it up. On top, as squares, therefore
/// come how unevenly the numbers follow each input, by the scatter of five runs about a line (Student's law), and their numerical errors,
/// both carried through the fit. At last the interval is widened to the points tried that fit as well as its ends would on a straight line.
/// Refuses where the numbers that tell an input jump as it moves. Throws what the model throws.
Calibration calibrate(const MeasuredData& data, const std::vector<FreeInput>& inputs, const Model& model, const NumberErrors& errors = {});

/// Before any run: too few numbers, or all the same. Empty: it may be tried.
std::string refusal_of(const MeasuredData& data, const std::vector<FreeInput>& inputs);

/// The project with the fitted values in its fabric, its `uncertainty` as the intervals are, and where they come from. Precondition: the
/// data tell the inputs.
Design calibrated_design(const Design& design, const Calibration& calibration);

/// A table for people: inputs, then measured and simulated numbers.
std::string calibration_table(const Calibration& calibration);
std::string calibration_json(const Calibration& calibration);
/// One page with the fit and its residuals as pictures.
ReportPage calibration_report(const Calibration& calibration);
/// The measured points with the curves before and after; empty unless there is a curve of two times at least.
std::string fit_svg(const Calibration& calibration);

} // namespace hygroloom
