// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The flat picture of a cloth: which yarn lies on top at each crossing, in its colour.
#pragma once

#include "core/design/fabric.h"

#include <QColor>
#include <QImage>
#include <QString>

namespace hygroloom {

/// Its own colour, or an undyed fibre's.
QColor yarnColor(const Yarn& yarn, bool warp);

/// Which yarn each of the first count ends (picks) is, as yarn_in() numbers them.
std::vector<int> threadYarns(const Fabric& fabric, bool warp, int count);
/// Threads of one period of the order; 1 when all are alike.
int orderPeriod(const Fabric& fabric, bool warp);
/// Gives the fabric an order of these yarns, one per thread of a period.
void setThreadYarns(Fabric& fabric, bool warp, const std::vector<int>& yarns);

/// "A" for the fabric's own yarn, "B" for the first extra one.
QString yarnLetter(int yarn);
/// "12A 4B", and back; without a value, why says in a sentence what is wrong.
QString orderText(const std::vector<YarnRun>& order);
std::optional<std::vector<YarnRun>> orderFromText(const QString& text, int yarns, QString* why);

/// One pixel per crossing; the first pick is the bottom row.
QImage clothPicture(const Fabric& fabric, int ends, int picks);

} // namespace hygroloom
