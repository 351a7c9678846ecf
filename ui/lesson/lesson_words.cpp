// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/lesson/lesson_words.h"

#include "core/base/text.h"
#include "ui/basics/quantity.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>

namespace hygroloom {

namespace {

QString tenths(int count) { return QLocale().toString(0.1 * std::abs(count), 'f', 1); }

/// To hundredths, or two digits of what is shorter: a drop that is drawn in at once takes some time, too.
QString secondsOf(double seconds)
{
    constexpr int fewest = 2, most = 6;
    return QLocale().toString(seconds, 'f', seconds > 0 ? std::clamp(decimals_for(seconds, 2), fewest, most) : fewest);
}

} // namespace

QString waterInWords(const WaterShares& shares)
{
    if (shares.drops == 0) { return QCoreApplication::translate("hygroloom::Lesson", "No drop so far."); }
    QStringList parts;
    const auto add = [&](int count, const QString& text, const QString& less) {
        if (count != 0) { parts << (count > 0 ? text : less).arg(tenths(count)); }
    };
    add(shares.in_yarns, QCoreApplication::translate("hygroloom::Lesson", "%1 in the yarns"),
        QCoreApplication::translate("hygroloom::Lesson", "%1 of the yarns’ own vapour gone"));
    add(shares.in_fibres, QCoreApplication::translate("hygroloom::Lesson", "%1 in the fibres"),
        QCoreApplication::translate("hygroloom::Lesson", "%1 of the fibres’ own water gone"));
    add(shares.in_air, QCoreApplication::translate("hygroloom::Lesson", "%1 in the air"),
        QCoreApplication::translate("hygroloom::Lesson", "%1 more came from the air"));
    add(shares.standing, QCoreApplication::translate("hygroloom::Lesson", "%1 still standing"), {});
    add(shares.run_off, QCoreApplication::translate("hygroloom::Lesson", "%1 run off"), {});
    const QString all = parts.join(QCoreApplication::translate("hygroloom::Lesson", ", ", "between shares of water"));
    if (shares.drops == 1) { return QCoreApplication::translate("hygroloom::Lesson", "Of 1 drop: %1.").arg(all); }
    return QCoreApplication::translate("hygroloom::Lesson", "Of %1 drops: %2.").arg(QString::number(shares.drops), all);
}

QStringList scoreLines(const ClothScore& score)
{
    const QString area = QCoreApplication::translate("hygroloom::Lesson", "Wet area %1 mm²").arg(shownNumber(score.wet_area_mm2, 0));
    const QString radius =
        QCoreApplication::translate("hygroloom::Lesson", "Radius %1 mm").arg(QLocale().toString(score.radius_mm, 'f', 1));
    const QString absorbed = score.absorbed_s >= 0
                                 ? QCoreApplication::translate("hygroloom::Lesson", "Absorbed in %1 s").arg(secondsOf(score.absorbed_s))
                             : score.wiped     ? QCoreApplication::translate("hygroloom::Lesson", "The last drop was wiped off")
                             : score.drops > 0 ? QCoreApplication::translate("hygroloom::Lesson", "Not absorbed yet")
                                               : QCoreApplication::translate("hygroloom::Lesson", "No drop to absorb");
    return {area, radius, absorbed};
}

QString noticeOf(const ClothView& view)
{
    if (!view.notice.empty()) { return QString::fromStdString(view.notice); }
    if (view.sliding == 1) {
        return QCoreApplication::translate("hygroloom::Lesson", "On a real cloth 1 drop would run down; here it stays.");
    }
    if (view.sliding > 1) {
        return QCoreApplication::translate("hygroloom::Lesson", "On a real cloth %1 drops would run down; here they stay.")
            .arg(view.sliding);
    }
    return {};
}

} // namespace hygroloom
