// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A comparison on one page for a meeting: which fabric, how sure, what differs, how it was computed and what is not known.
#pragma once

#include "core/analysis/comparison.h"
#include "core/analysis/page.h"
#include "core/analysis/reader_units.h"

namespace hygroloom {

/// Of a map of a fabric as given: "Cotton, as given, top"; there is nothing but that where no replicates are compared.
std::string map_caption(const Comparison& comparison, const std::string& fabric, const std::string& side);

/// maps: of all candidates as given, on one colour scale.
/// units: of numbers and curves.
ReportPage comparison_report(const Comparison& comparison, const std::vector<ReportPicture>& maps, const ReaderUnits& units = {});

} // namespace hygroloom
