// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The language of the window. The setting look/language holds a code of languages(), or nothing for the system's; it acts at the next
// start.
#pragma once

#include <QDateTime>
#include <QString>

#include <vector>

class QCoreApplication;

namespace hygroloom {

struct Language {
    QString code; ///< "de"
    QString name; ///< its own: "Deutsch"
};

/// Those that the window speaks; English first.
std::vector<Language> languages();

/// The code of the one that the setting asks for, or that the system has, or English.
QString chosenLanguage();

/// Installs the translations of chosenLanguage(), Qt's own too. Numbers have points in every language, as in files and in core's sentences.
void install_language(QCoreApplication& application);

/// A title as a word within a sentence: "Draft" as "draft"; German nouns keep their capital.
QString withinSentence(const QString& title);

/// A file that ships: the one of its name in the folder de beside it, where the window speaks German and there is one, and so on.
QString inShownLanguage(const QString& path);
/// Date and time, short, as the window's language writes them.
QString shortMoment(const QDateTime& moment);

} // namespace hygroloom
