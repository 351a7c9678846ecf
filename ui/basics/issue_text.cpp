// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/basics/issue_text.h"

#include "ui/basics/quantity.h"

#include <QRegularExpression>

#include <algorithm>

namespace hygroloom {

namespace {

const QString number = R"((?<![\w.])-?\d+(?:\.\d+)?(?:e[+-]?\d+)?)";

/// Numbers and the unit that is meant by all of them; unit: the part of it that the reader's takes the place of.
struct Form {
    const char* unit;
    const char* pattern; ///< N: a number
};

constexpr Form forms[] = {{"mm", R"(N(?: (?:x|to|and) N)* mm(?![\w/])(?:[^;.]*; given is N)?)"},
                          {"/cm", R"(N(?: ends| picks)?/cm\b)"},
                          {"/cm", R"(N ends and N picks per cm\b)"},
                          {"/cm", R"(per cm must be from N to N; given is N)"},
                          {"tex", R"(N(?: to N)? tex\b(?:; given is N)?)"}};

QString converted(QString phrase, const QString& unit, const UserUnit& user)
{
    static const QRegularExpression one(number);
    std::vector<QRegularExpressionMatch> found;
    QStringList shown;
    for (auto each = one.globalMatch(phrase); each.hasNext();) {
        found.push_back(each.next());
        shown << significant(user.of(found.back().captured().toDouble()));
    }
    if (user.inverse && shown.size() > 1) { std::swap(shown[0], shown[1]); } // of a range: from the least to the most
    for (std::size_t i = found.size(); i-- > 0;) {
        phrase.replace(found[i].capturedStart(), found[i].capturedLength(), shown[static_cast<qsizetype>(i)]);
    }
    const bool in_words = !phrase.contains(unit); // "per cm"
    return in_words ? phrase.replace("per cm", "per " + user.unit.mid(1)) : phrase.replace(unit, user.unit);
}

QString withoutNames(QString words)
{
    for (const Form& form : forms) {
        const QString unit = form.unit;
        const UserUnit user = userUnit(unit);
        if (user.unit == unit) { continue; }
        const QRegularExpression pattern(QString(form.pattern).replace('N', number));
        std::vector<QRegularExpressionMatch> found;
        for (auto each = pattern.globalMatch(words); each.hasNext();) { found.push_back(each.next()); }
        for (auto each = found.rbegin(); each != found.rend(); ++each) {
            words.replace(each->capturedStart(), each->capturedLength(), converted(each->captured(), unit, user));
        }
    }
    return words;
}

} // namespace

QString inReadersUnits(const QString& sentence)
{
    QStringList parts = sentence.split('"');
    for (qsizetype i = 0; i < parts.size(); i += 2) { parts[i] = withoutNames(parts[i]); }
    return parts.join('"');
}

QString issueText(const Issue& issue) { return inReadersUnits(QString::fromStdString(issue.text)); }

} // namespace hygroloom
