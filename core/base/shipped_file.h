// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Where programs and modules lie that come with this one.
#pragma once

#include <filesystem>

namespace hygroloom {

/// The file of that name in the folder lib/hygroloom of the build or the installed tree that this program, or this module of Python, lies
/// in; empty where it is not there. The folder that one works in is never looked at.
std::filesystem::path shipped_file(const std::string& name);

} // namespace hygroloom
