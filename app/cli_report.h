// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// --report: pages as HTML, text or JSON, or as PDF, which the window's program writes.
#pragma once

#include "core/analysis/page.h"

#include <string>

namespace hygroloom {

/// Throws Stop when a report cannot have this name: it must end in .html, .txt, .json or .pdf, and a .pdf needs the program `hygroloom`
/// beside this one or in the path. An empty name is none.
void check_report_name(const std::string& file);

/// Throws FileError, and Stop when the other program could not write it.
void write_report_file(const std::string& file, const ReportPage& page);

} // namespace hygroloom
