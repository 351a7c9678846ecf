// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/basics/issue_text.h"

#include "ui/basics/quantity.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace hygroloom {

namespace {

QString properUnit(Stored unit) { return QString::fromUtf8(trade_units(unit).front().spellings.front()); }

std::string shownNumber(double value, Stored unit, const std::string& format)
{
    const UserUnit user = userUnit(properUnit(unit));
    return user.unit == properUnit(unit) ? formatted(value, format) : significant(user.of(value)).toStdString();
}

/// With the gap before it.
std::string behindNumber(Stored unit, bool in_english)
{
    const QString proper = properUnit(unit), user = userUnit(proper).unit;
    const QString word = in_english ? QString::fromUtf8(unit_in_sentences(unit)) : proper;
    if (word.isEmpty()) { return {}; }
    const QString shown = user == proper ? word : user;
    return (shown == "°" ? shown : " " + shown).toStdString();
}

std::string shownRange(const Between& range, const std::string& format, bool in_english)
{
    std::string least = shownNumber(range.least, range.unit, format), most = shownNumber(range.most, range.unit, format);
    if (userUnit(properUnit(range.unit)).inverse) { std::swap(least, most); }
    const QString both = QCoreApplication::translate("core", "%1 to %2").arg(QString::fromStdString(least), QString::fromStdString(most));
    return both.toStdString() + behindNumber(range.unit, in_english);
}

/// The English title, or the label of forms, which has translations.
std::string shownTitle(const Title& title, bool in_english)
{
    if (!in_english) { return QCoreApplication::translate("core", title.label).toStdString(); }
    QString words = title.title;
    if (title.unit == Stored::per_cm) { words.replace("per cm", "per " + userUnit("/cm").unit.mid(1)); }
    return words.toStdString();
}

/// What stands in a gap.
struct Shown {
    std::string format;
    bool in_english;

    std::string operator()(const std::string& text) const { return text; }
    std::string operator()(double number) const { return formatted(number, format); }
    std::string operator()(long number) const { return std::to_string(number); }
    std::string operator()(const Amount& amount) const
    {
        return shownNumber(amount.value, amount.unit, format) + behindNumber(amount.unit, in_english);
    }
    std::string operator()(const Bare& bare) const { return shownNumber(bare.value, bare.unit, format); }
    std::string operator()(const Between& range) const { return shownRange(range, format, in_english); }
    std::string operator()(const UnitAlone& alone) const
    {
        return userUnit(properUnit(alone.unit)).unit.mid(alone.has_slash ? 0 : 1).toStdString();
    }
    std::string operator()(const Title& title) const { return shownTitle(title, in_english); }
    std::string operator()(const Message& message) const { return messageText(message).toStdString(); }
};

} // namespace

QString messageText(const Message& message)
{
    const std::string sentence = QCoreApplication::translate("core", message.text.c_str()).toStdString();
    const auto shown = [in_english = sentence == message.text](const Argument& argument, const std::string& format) {
        return std::visit(Shown{format, in_english}, argument.value);
    };
    return QString::fromStdString(filled(sentence, message.arguments, shown));
}

QString issueText(const Issue& issue) { return messageText(issue.message); }

QString firstError(const std::vector<Issue>& issues)
{
    const Issue* error = first_error(issues);
    return error ? issueText(*error) : QString();
}

} // namespace hygroloom
