// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/basics/language.h"

#include "ui/basics/appearance.h"

#include <QCoreApplication>
#include <QFile>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QTranslator>

#include <algorithm>

namespace hygroloom {

namespace {

bool isSpoken(const QString& code)
{
    const std::vector<Language> all = languages();
    return std::any_of(all.begin(), all.end(), [&code](const Language& each) { return each.code == code; });
}

/// The first of the languages that the system asks for which the window speaks.
QString systemLanguage()
{
    for (const QString& wish : QLocale::system().uiLanguages()) {
        if (QString code = wish.section('-', 0, 0); isSpoken(code)) { return code; }
    }
    return "en";
}

/// Dates alone follow it; numbers have points everywhere.
QLocale& locale_of_dates()
{
    static QLocale locale;
    return locale;
}

QString& shown()
{
    static QString code = "en";
    return code;
}

} // namespace

std::vector<Language> languages() { return {{"en", "English"}, {"de", "Deutsch"}}; }

QString chosenLanguage()
{
    const QString asked = QSettings().value("look/language").toString();
    return isSpoken(asked) ? asked : systemLanguage();
}

void install_language(QCoreApplication& application)
{
    useResources();
    const QString code = shown() = chosenLanguage();
    // English as the system writes it, where it is the system's language: days and months have an order of their own in each country.
    locale_of_dates() = QLocale::system().name().startsWith(code) ? QLocale::system() : QLocale(code);
    QLocale::setDefault(QLocale::c());
    if (code == "en") { return; }
    for (const auto& [file, folder] : {std::pair<QString, QString>{"qtbase_" + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath)},
                                       {"hygroloom_" + code, ":/translations"}}) {
        auto* translator = new QTranslator(&application);
        if (translator->load(file, folder)) {
            QCoreApplication::installTranslator(translator);
        } else {
            delete translator; // Qt's own need not be there
        }
    }
}

QString inShownLanguage(const QString& path)
{
    const QString name = path.section('/', -1), own = path.chopped(name.size()) + shown() + '/' + name;
    return QFile::exists(own) ? own : path;
}

QString withinSentence(const QString& title)
{
    return locale_of_dates().language() == QLocale::German ? title : title.left(1).toLower() + title.mid(1);
}

QString shortMoment(const QDateTime& moment) { return locale_of_dates().toString(moment, QLocale::ShortFormat); }

} // namespace hygroloom
