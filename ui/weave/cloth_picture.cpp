// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/weave/cloth_picture.h"

#include "core/base/words.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>

namespace hygroloom {

QColor yarnColor(const Yarn& yarn, bool warp)
{
    if (yarn.color) { return QColor(yarn.color->red, yarn.color->green, yarn.color->blue); }
    return warp ? QColor("#f0e8d8") : QColor("#e2d5bb");
}

int orderPeriod(const Fabric& fabric, bool warp)
{
    int period = 0;
    for (const YarnRun& run : warp ? fabric.warp_order : fabric.weft_order) { period += run.count; }
    return std::max(1, period);
}

std::vector<int> threadYarns(const Fabric& fabric, bool warp, int count)
{
    const std::vector<YarnRun>& order = warp ? fabric.warp_order : fabric.weft_order;
    const int known = static_cast<int>(fabric.extra_yarns.size());
    std::vector<int> yarns;
    yarns.reserve(static_cast<std::size_t>(count));
    while (!order.empty() && static_cast<int>(yarns.size()) < count) {
        const std::size_t before = yarns.size();
        for (const YarnRun& run : order) {
            yarns.insert(yarns.end(), static_cast<std::size_t>(std::clamp(run.count, 0, largest_yarn_order)),
                         std::clamp(run.yarn, 0, known));
        }
        if (yarns.size() == before) { break; }
    }
    yarns.resize(static_cast<std::size_t>(count), 0);
    return yarns;
}

void setThreadYarns(Fabric& fabric, bool warp, const std::vector<int>& yarns)
{
    std::vector<YarnRun>& order = warp ? fabric.warp_order : fabric.weft_order;
    order.clear();
    for (const int yarn : yarns) {
        if (!order.empty() && order.back().yarn == yarn) {
            ++order.back().count;
        } else {
            order.push_back({yarn, 1});
        }
    }
    if (order.size() == 1 && order.front().yarn == 0) { order.clear(); }
}

QString yarnLetter(int yarn) { return QString::fromStdString(letters_of(yarn)); }

QString orderText(const std::vector<YarnRun>& order)
{
    QStringList runs;
    for (const YarnRun& run : order) { runs << QString::number(run.count) + yarnLetter(run.yarn); }
    return runs.join(' ');
}

std::optional<std::vector<YarnRun>> orderFromText(const QString& text, int yarns, QString* why)
{
    static const QRegularExpression form("\\s*(\\d*)\\s*([A-Za-z]{1,2})[\\s,]*");
    std::vector<YarnRun> order;
    int place = 0, threads = 0;
    while (place < text.size()) {
        const auto match = form.match(text, place, QRegularExpression::NormalMatch, QRegularExpression::AnchorAtOffsetMatchOption);
        if (!match.hasMatch()) {
            if (text.mid(place).trimmed().isEmpty()) { break; }
            *why = QCoreApplication::translate("hygroloom::OrderEditor", "Type counts and yarn letters, such as 12A 4B.");
            return std::nullopt;
        }
        const QString letters = match.captured(2).toUpper();
        int yarn = letters.back().unicode() - 'A';
        if (letters.size() == 2) { yarn += 26 * (letters.front().unicode() - 'A' + 1); }
        const int count = match.captured(1).isEmpty() ? 1 : match.captured(1).toInt();
        if (yarn >= yarns) {
            *why = QCoreApplication::translate("hygroloom::OrderEditor", "There is no yarn %1; the last one is %2.")
                       .arg(letters, yarnLetter(yarns - 1));
            return std::nullopt;
        }
        if (count < 1 || count > largest_yarn_order - threads) {
            *why = QCoreApplication::translate("hygroloom::OrderEditor", "Each stripe needs at least 1 yarn; all together at most %1.")
                       .arg(largest_yarn_order);
            return std::nullopt;
        }
        threads += count;
        order.push_back({yarn, count});
        place = static_cast<int>(match.capturedEnd());
    }
    return order;
}

QImage clothPicture(const Fabric& fabric, int ends, int picks)
{
    const auto colors = [&](bool warp, int count) {
        std::vector<QRgb> all;
        for (const int yarn : threadYarns(fabric, warp, count)) { all.push_back(yarnColor(yarn_in(fabric, warp, yarn), warp).rgb()); }
        return all;
    };
    const std::vector<QRgb> warp = colors(true, ends), weft = colors(false, picks);
    QImage image(ends, picks, QImage::Format_RGB32);
    for (int pick = 0; pick < picks; ++pick) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(picks - 1 - pick));
        for (int end = 0; end < ends; ++end) {
            line[end] = fabric.weave.warp_up(end, pick) ? warp[static_cast<std::size_t>(end)] : weft[static_cast<std::size_t>(pick)];
        }
    }
    return image;
}

} // namespace hygroloom
