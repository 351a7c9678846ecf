// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Fixed names that core has in English, as metrics, faces, tests, curves and zones, in the language of the window. Files keep the English
// ones.
#pragma once

#include <QString>

#include <string>

namespace hygroloom {

/// In the language of the window, as of "zone chest"; what is not in the table, as names that somebody gave, comes back as it is.
QString coreWord(const QString& english);
QString coreWord(const std::string& english);
QString coreWord(const char* english);

/// "wetted radius, top"; an empty face is left out.
QString coreTitle(const std::string& title, const std::string& face);

} // namespace hygroloom
