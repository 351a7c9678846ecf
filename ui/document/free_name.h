// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Names for new parts of a project.
#pragma once

#include <string>

namespace hygroloom {

/// The wish itself where it is free, else followed by the first number from 2 on that makes it free.
template <typename Taken> std::string freeName(const std::string& wish, const Taken& taken)
{
    std::string name = wish;
    for (int i = 2; taken(name); ++i) { name = wish + " " + std::to_string(i); }
    return name;
}

} // namespace hygroloom
