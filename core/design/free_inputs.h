// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Inputs of a fabric that one measurement may tell: each one number for the whole fabric, within the range in which it is not known.
#pragma once

#include "core/design/unknowns.h"

#include <string>
#include <vector>

namespace hygroloom {

struct FreeInput {
    std::string key; ///< of a fabric's `uncertainty`
    std::string title;
    std::string unit; ///< "°", or empty
    double low = 0, given = 0, high = 0;
};

/// Those there are: contact_angle_deg, receding_angle_deg, packing_factor.
const std::vector<std::string>& free_input_keys();

/// Of the fabric, with the range of unknown_inputs(), of a packing the part of it in which the yarns fit into the weave. Throws Error, in a
/// sentence: there is no such input, it is known, or it differs from yarn to yarn. Precondition: validate() found no error.
FreeInput free_input(const Design& design, const Fabric& fabric, const std::string& key);

/// The fabric with inputs of free_input() at other values. A contact angle becomes the fabric's own, as of a finish; a receding angle
/// makes fibres of the fabric's own, so that other fabrics keep theirs.
Design with_inputs(const Design& design, const std::string& fabric, const std::vector<FreeInput>& inputs,
                   const std::vector<double>& values);

/// The input's value in a fabric's `uncertainty` and among those before a calibration.
std::optional<double>& uncertainty_of(Fabric& fabric, const std::string& key);
std::optional<double>& before_of(Calibrated& calibrated, const std::string& key);

} // namespace hygroloom
