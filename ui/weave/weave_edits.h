// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the weave editor's tools do to a matrix, as functions from a weave to a weave. The results are free matrices.
#pragma once

#include "core/design/weave.h"

#include <QPoint>
#include <QRect>
#include <QString>
#include <QVector>

#include <optional>

namespace hygroloom {

/// x is the end, y the pick; they may lie outside the repeat, where the weave continues.
using Crossings = QVector<QPoint>;

/// index in 0 .. count-1.
inline int wrapped(int index, int count) { return ((index % count) + count) % count; }

Crossings lineOf(const QPoint& from, const QPoint& to);
Crossings areaOf(const QRect& area);
/// All crossings like this one that can be reached from it by steps along ends and picks, round the repeat's edges too.
Crossings floodOf(const Weave& weave, const QPoint& from);

Weave withPainted(const Weave& weave, const Crossings& crossings, bool up);
Weave endsMirrored(const Weave& weave);
Weave picksMirrored(const Weave& weave);
/// What leaves at one edge of the repeat comes in at the other.
Weave shifted(const Weave& weave, int ends, int picks);
Weave inverted(const Weave& weave);
/// By 90° clockwise as seen on point paper.
Weave rotated(const Weave& weave);
/// New ends and picks continue the weave.
Weave resized(const Weave& weave, int ends, int picks);
/// A new end (pick) before this one, a copy of it.
Weave withEndInserted(const Weave& weave, int end);
Weave withPickInserted(const Weave& weave, int pick);
/// Precondition: there are two at least.
Weave withoutEnd(const Weave& weave, int end);
Weave withoutPick(const Weave& weave, int pick);

Weave partOf(const Weave& weave, const QRect& area);
/// The part's first crossing comes to lie at a place; what passes an edge of the repeat comes in at the other.
Weave withPart(const Weave& weave, const QPoint& at, const Weave& part);

/// Rows of 0 and 1, the last pick first, as point paper shows them.
QString gridText(const Weave& weave);
/// Also of . and #, with spaces or commas between. Without a value, why says in a sentence what is wrong.
std::optional<Weave> weaveFromText(const QString& text, QString* why);

} // namespace hygroloom
