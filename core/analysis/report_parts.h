// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Pieces of HTML that reports are made of. Texts are escaped here.
#pragma once

#include "core/analysis/map_image.h"

#include <string>
#include <vector>

namespace hygroloom {

struct ReportPicture {
    std::string caption;
    Image image;
};

/// A whole page; body: HTML.
std::string page(const std::string& title, const std::string& body);
/// A heading and what follows it; nothing where the body is empty.
std::string section(const char* title, const std::string& body);
/// A row of a name, a number, its unit and, if there is one, a remark.
std::string row(const std::string& name, const std::string& value, const std::string& unit, const std::string& remark = "");
std::string table(const std::string& rows);
std::string list(const std::vector<std::string>& sentences);
/// Pictures inside the page, with captions.
std::string figures_of(const std::vector<ReportPicture>& pictures);

} // namespace hygroloom
