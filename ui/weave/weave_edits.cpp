// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/weave/weave_edits.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cstdlib>

namespace hygroloom {

namespace {

/// A matrix of this size; up(end, pick) gives its crossings.
template <typename Up> Weave made(int ends, int picks, Up up)
{
    std::vector<std::uint8_t> matrix(static_cast<std::size_t>(ends) * static_cast<std::size_t>(picks));
    auto* next = matrix.data();
    for (int pick = 0; pick < picks; ++pick) {
        for (int end = 0; end < ends; ++end) { *next++ = up(end, pick) ? 1 : 0; }
    }
    return Weave(ends, picks, std::move(matrix));
}

QString translated(const char* text) { return QCoreApplication::translate("hygroloom::WeaveEditor", text); }

} // namespace

Crossings lineOf(const QPoint& from, const QPoint& to)
{
    const QPoint way = to - from;
    const int steps = std::max(std::abs(way.x()), std::abs(way.y()));
    Crossings line{from};
    for (int i = 1; i <= steps; ++i) {
        line << from + QPoint(qRound(static_cast<double>(way.x()) * i / steps), qRound(static_cast<double>(way.y()) * i / steps));
    }
    return line;
}

Crossings areaOf(const QRect& area)
{
    Crossings all;
    for (int pick = area.top(); pick <= area.bottom(); ++pick) {
        for (int end = area.left(); end <= area.right(); ++end) { all << QPoint(end, pick); }
    }
    return all;
}

Crossings floodOf(const Weave& weave, const QPoint& from)
{
    const int ends = weave.ends(), picks = weave.picks();
    const bool kind = weave.warp_up(from.x(), from.y());
    std::vector<bool> seen(static_cast<std::size_t>(ends) * static_cast<std::size_t>(picks));
    Crossings reached;
    const auto reach = [&](int end, int pick) {
        end = wrapped(end, ends);
        pick = wrapped(pick, picks);
        const std::size_t place = static_cast<std::size_t>(pick) * static_cast<std::size_t>(ends) + static_cast<std::size_t>(end);
        if (!seen[place] && weave.warp_up(end, pick) == kind) {
            seen[place] = true;
            reached << QPoint(end, pick);
        }
    };
    reach(from.x(), from.y());
    for (int i = 0; i < reached.size(); ++i) {
        const QPoint at = reached[i];
        reach(at.x() - 1, at.y());
        reach(at.x() + 1, at.y());
        reach(at.x(), at.y() - 1);
        reach(at.x(), at.y() + 1);
    }
    return reached;
}

Weave withPainted(const Weave& weave, const Crossings& crossings, bool up)
{
    std::vector<std::uint8_t> matrix = weave.crossings();
    for (const QPoint& at : crossings) {
        const int end = wrapped(at.x(), weave.ends()), pick = wrapped(at.y(), weave.picks());
        matrix[static_cast<std::size_t>(pick) * static_cast<std::size_t>(weave.ends()) + static_cast<std::size_t>(end)] = up ? 1 : 0;
    }
    return Weave(weave.ends(), weave.picks(), std::move(matrix));
}

Weave endsMirrored(const Weave& weave)
{
    return made(weave.ends(), weave.picks(), [&](int end, int pick) { return weave.warp_up(weave.ends() - 1 - end, pick); });
}

Weave picksMirrored(const Weave& weave)
{
    return made(weave.ends(), weave.picks(), [&](int end, int pick) { return weave.warp_up(end, weave.picks() - 1 - pick); });
}

Weave shifted(const Weave& weave, int ends, int picks)
{
    return made(weave.ends(), weave.picks(), [&](int end, int pick) { return weave.warp_up(end - ends, pick - picks); });
}

Weave inverted(const Weave& weave)
{
    return made(weave.ends(), weave.picks(), [&](int end, int pick) { return !weave.warp_up(end, pick); });
}

Weave rotated(const Weave& weave)
{
    return made(weave.picks(), weave.ends(), [&](int end, int pick) { return weave.warp_up(weave.ends() - 1 - pick, end); });
}

Weave resized(const Weave& weave, int ends, int picks)
{
    return made(ends, picks, [&](int end, int pick) { return weave.warp_up(end, pick); });
}

Weave withEndInserted(const Weave& weave, int at)
{
    return made(weave.ends() + 1, weave.picks(), [&](int end, int pick) { return weave.warp_up(end > at ? end - 1 : end, pick); });
}

Weave withPickInserted(const Weave& weave, int at)
{
    return made(weave.ends(), weave.picks() + 1, [&](int end, int pick) { return weave.warp_up(end, pick > at ? pick - 1 : pick); });
}

Weave withoutEnd(const Weave& weave, int at)
{
    return made(weave.ends() - 1, weave.picks(), [&](int end, int pick) { return weave.warp_up(end >= at ? end + 1 : end, pick); });
}

Weave withoutPick(const Weave& weave, int at)
{
    return made(weave.ends(), weave.picks() - 1, [&](int end, int pick) { return weave.warp_up(end, pick >= at ? pick + 1 : pick); });
}

Weave partOf(const Weave& weave, const QRect& area)
{
    return made(area.width(), area.height(), [&](int end, int pick) { return weave.warp_up(area.left() + end, area.top() + pick); });
}

Weave withPart(const Weave& weave, const QPoint& at, const Weave& part)
{
    return made(weave.ends(), weave.picks(), [&](int end, int pick) {
        const int x = wrapped(end - at.x(), weave.ends()), y = wrapped(pick - at.y(), weave.picks());
        return x < part.ends() && y < part.picks() ? part.warp_up(x, y) : weave.warp_up(end, pick);
    });
}

QString gridText(const Weave& weave)
{
    QString text;
    text.reserve((weave.ends() + 1) * weave.picks());
    for (int pick = weave.picks() - 1; pick >= 0; --pick) {
        for (int end = 0; end < weave.ends(); ++end) { text += weave.warp_up(end, pick) ? '1' : '0'; }
        text += '\n';
    }
    return text;
}

std::optional<Weave> weaveFromText(const QString& text, QString* why)
{
    QStringList rows;
    for (QString row : text.split('\n')) {
        row.remove(' ').remove('\t').remove('\r').remove(',').remove(';');
        row.replace('#', '1').replace('.', '0');
        if (!row.isEmpty()) { rows.prepend(row); }
    }
    const auto wrong = [&](const char* sentence) {
        *why = translated(sentence);
        return std::nullopt;
    };
    if (rows.isEmpty()) { return wrong(QT_TRANSLATE_NOOP("hygroloom::WeaveEditor", "The clipboard holds no text; copy rows of 0 and 1.")); }
    for (const QString& row : rows) {
        if (row.size() != rows.first().size()) {
            return wrong(QT_TRANSLATE_NOOP("hygroloom::WeaveEditor", "The rows on the clipboard differ in length; make them alike."));
        }
        if (!std::all_of(row.begin(), row.end(), [](QChar c) { return c == '0' || c == '1'; })) {
            return wrong(QT_TRANSLATE_NOOP("hygroloom::WeaveEditor", "The clipboard holds no weave; copy rows of 0 and 1."));
        }
    }
    if (rows.size() > largest_repeat || rows.first().size() > largest_repeat) {
        return wrong(QT_TRANSLATE_NOOP("hygroloom::WeaveEditor", "What is on the clipboard is larger than 2000 ends or picks."));
    }
    return made(static_cast<int>(rows.first().size()), static_cast<int>(rows.size()),
                [&](int end, int pick) { return rows[pick][end] == '1'; });
}

} // namespace hygroloom
