// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/basics/core_words.h"

#include <QCoreApplication>

#include <cstring>
#include <utility>

namespace hygroloom {

QString coreWord(const char* english) { return QCoreApplication::translate("core", english); }

QString coreWord(const std::string& english)
{
    for (const auto& [kind, form] : {std::pair("panel ", "panel %1"), std::pair("zone ", "zone %1")}) {
        if (english.starts_with(kind)) { return coreWord(form).arg(coreWord(english.c_str() + std::strlen(kind))); }
    }
    return coreWord(english.c_str());
}

QString coreWord(const QString& english) { return coreWord(english.toUtf8().constData()); }

QString coreTitle(const std::string& title, const std::string& face)
{
    return face.empty() ? coreWord(title) : coreWord(title) + ", " + coreWord(face);
}

} // namespace hygroloom
