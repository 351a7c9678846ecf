// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/basics/quantity.h"

#include "core/base/text.h"
#include "core/base/units.h"
#include "ui/basics/preferences.h"

#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <map>

namespace hygroloom {

namespace {

QString unicode(std::string_view utf8) { return QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size())); }
QString spelled(const TradeUnit& unit) { return unicode(unit.spellings.front()); }

/// Shown in the unit that is stored, unless the preferences choose another.
Quantity quantity(Stored kind, double minimum, double maximum, double step, int decimals, Measure measure = Measure::other)
{
    Quantity q;
    q.units = trade_units(kind);
    q.unit = spelled(q.units.front());
    q.minimum = minimum;
    q.maximum = maximum;
    q.step = step;
    q.decimals = decimals;
    q.measure = measure;
    return q;
}

QLocale ungrouped()
{
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale;
}

} // namespace

QString shownNumber(double value, int decimals)
{
    const QLocale locale = ungrouped();
    QString text = locale.toString(value, 'f', decimals);
    if (decimals > 0) {
        while (text.endsWith(locale.zeroDigit())) { text.chop(1); }
        if (text.endsWith(locale.decimalPoint())) { text.chop(locale.decimalPoint().size()); }
    }
    return text == "-0" ? "0" : text;
}

QString significant(double value)
{
    const int decimals =
        value == 0 || !std::isfinite(value) ? 0 : std::clamp(2 - static_cast<int>(std::floor(std::log10(std::abs(value)))), 0, 6);
    return shownNumber(value, decimals);
}

QString inFull(double value) { return ungrouped().toString(value, 'g', 10); }

UserUnit userUnit(const QString& unit)
{
    const Preferences chosen = preferences();
    const auto yarn = static_cast<YarnUnit>(chosen.yarn);
    if (unit == "°C" && chosen.degrees == static_cast<int>(TemperatureUnit::fahrenheit)) { return {"°F", 1.8, 32}; }
    if (unit == "/cm" && chosen.sett == static_cast<int>(SettUnit::per_inch)) { return {"/in", 2.54}; }
    if (unit == "tex" && yarn == YarnUnit::ne) { return {"Ne", ne_from_tex(1), 0, true}; }
    if (unit == "tex" && yarn == YarnUnit::nm) { return {"Nm", 1000, 0, true}; }
    if (unit == "tex" && yarn == YarnUnit::denier) { return {"den", 9}; }
    const int length = chosen.length;
    if (length == 0 || (unit != "mm" && unit != "mm/s")) { return {unit, 1}; }
    const bool inches = static_cast<LengthUnit>(length) == LengthUnit::inch;
    return {QString(unit).replace("mm", inches ? "in" : "cm"), inches ? 1 / 25.4 : 0.1};
}

QString valueText(double value, const QString& unit, bool full)
{
    const UserUnit user = userUnit(unit);
    const QString number = full ? inFull(user.of(value)) : significant(user.of(value));
    return user.unit.isEmpty() || user.unit == "°" ? number + user.unit : number + QChar(0x00a0) + user.unit;
}

QString momentText(double seconds, double duration)
{
    return ungrouped().toString(seconds, 'f', decimals_of_moments(duration)) + QChar(0x00a0) + "s";
}

QString bytesText(double bytes)
{
    const ByteCount count = byte_count(bytes);
    return shownNumber(count.number, count.decimals) + QChar(0x00a0) + count.unit;
}

Quantity Quantity::of(Stored unit, double minimum, double maximum, bool is_whole)
{
    struct Look {
        double step;
        int decimals;
        Measure measure = Measure::other;
    };
    static const std::map<Stored, Look> looks{{Stored::number, {0.01, 3}},
                                              {Stored::fraction, {0.01, 3}},
                                              {Stored::degree, {5, 1}},
                                              {Stored::per_cm, {1, 2, Measure::sett}},
                                              {Stored::per_m, {50, 1}},
                                              {Stored::per_mm, {1, 2}},
                                              {Stored::mm, {0, 4, Measure::length}},
                                              {Stored::um, {0.5, 3}},
                                              {Stored::tex, {0, 2, Measure::linear_density}},
                                              {Stored::celsius, {1, 1, Measure::temperature}},
                                              {Stored::second, {1, 3}},
                                              {Stored::metre_per_second, {0.1, 2}},
                                              {Stored::microlitre, {1, 2}},
                                              {Stored::g_per_m2, {10, 1}},
                                              {Stored::g_per_m2_hour, {50, 1}},
                                              {Stored::mn_per_m, {1, 2}},
                                              {Stored::mpa_second, {0.1, 4}},
                                              {Stored::kg_per_m3, {10, 1}},
                                              {Stored::percent, {0.5, 1}},
                                              {Stored::watt_per_m_kelvin, {0.01, 4}},
                                              {Stored::joule_per_kg_kelvin, {10, 1}},
                                              {Stored::joule_per_g, {1, 2}}};
    if (unit == Stored::share) { return percent(minimum, maximum); }
    if (is_whole) { return quantity(unit, minimum, maximum, 1, 0); }
    const Look& look = looks.at(unit);
    return quantity(unit, minimum, maximum, look.step, look.decimals, look.measure);
}

Quantity Quantity::length(double minimum_mm, double maximum_mm)
{
    return quantity(Stored::mm, minimum_mm, maximum_mm, 0, 4, Measure::length);
}

Quantity Quantity::linearDensity(double minimum_tex, double maximum_tex)
{
    return quantity(Stored::tex, minimum_tex, maximum_tex, 0, 2, Measure::linear_density);
}

Quantity Quantity::sett(double minimum_per_cm, double maximum_per_cm)
{
    return quantity(Stored::per_cm, minimum_per_cm, maximum_per_cm, 1, 2, Measure::sett);
}

Quantity Quantity::twist(double maximum_per_m) { return quantity(Stored::per_m, 0, maximum_per_m, 50, 1); }

Quantity Quantity::perMillimetre(double maximum) { return quantity(Stored::per_mm, 0, maximum, 1, 2); }

Quantity Quantity::fraction(double minimum, double maximum) { return quantity(Stored::fraction, minimum, maximum, 0.01, 3); }

Quantity Quantity::percent(double minimum, double maximum)
{
    Quantity q = quantity(Stored::share, minimum, maximum, maximum > 0.5 ? 5 : 0.5, maximum > 0.5 ? 1 : 2);
    q.units.erase(q.units.begin()); // a number alone is one of percent
    q.unit = spelled(q.units.front());
    q.shown_per_stored = 100;
    return q;
}

Quantity Quantity::count(int minimum, int maximum) { return quantity(Stored::number, minimum, maximum, 1, 0); }

Quantity Quantity::angle(double minimum_deg, double maximum_deg) { return quantity(Stored::degree, minimum_deg, maximum_deg, 5, 1); }

Quantity Quantity::temperature(double minimum_c, double maximum_c)
{
    return quantity(Stored::celsius, minimum_c, maximum_c, 1, 1, Measure::temperature);
}

Quantity Quantity::speed(double maximum_m_s) { return quantity(Stored::metre_per_second, 0, maximum_m_s, 0.1, 2); }

Quantity Quantity::volume(double minimum_ul, double maximum_ul) { return quantity(Stored::microlitre, minimum_ul, maximum_ul, 1, 2); }

Quantity Quantity::time(double minimum_s, double maximum_s) { return quantity(Stored::second, minimum_s, maximum_s, 1, 3); }

Quantity Quantity::arealDensity(double maximum_g_m2) { return quantity(Stored::g_per_m2, 0, maximum_g_m2, 10, 1); }

Quantity Quantity::arealRate(double maximum_g_m2_h) { return quantity(Stored::g_per_m2_hour, 0, maximum_g_m2_h, 50, 1); }

Quantity Quantity::surfaceTension(double minimum_mn_m, double maximum_mn_m)
{
    return quantity(Stored::mn_per_m, minimum_mn_m, maximum_mn_m, 1, 2);
}

Quantity Quantity::viscosity(double minimum_mpa_s, double maximum_mpa_s)
{
    return quantity(Stored::mpa_second, minimum_mpa_s, maximum_mpa_s, 0.1, 4);
}

Quantity Quantity::density(double minimum_kg_m3, double maximum_kg_m3)
{
    return quantity(Stored::kg_per_m3, minimum_kg_m3, maximum_kg_m3, 10, 1);
}

namespace {

/// Spelled as in the quantities above; empty: the unit that is stored.
QString preferredSpelling(Measure measure)
{
    const Preferences p = preferences();
    switch (measure) {
    case Measure::length: return QStringList{"", "cm", "in"}[p.length];
    case Measure::linear_density: return QStringList{"", "Ne", "Nm", "den"}[p.yarn];
    case Measure::sett: return QStringList{"", "/in"}[p.sett];
    case Measure::temperature: return QStringList{"", "°F"}[p.degrees];
    case Measure::other: break;
    }
    return {};
}

QString withUnit(const QString& number, const QString& unit)
{
    return unit.isEmpty() || unit == "°" ? number + unit : number + QChar(0x00a0) + unit;
}

} // namespace

const TradeUnit* Quantity::preferred() const
{
    const QString wanted = preferredSpelling(measure);
    if (wanted.isEmpty()) { return nullptr; }
    for (const TradeUnit& candidate : units) {
        if (spelled(candidate) == wanted) { return &candidate; }
    }
    return nullptr;
}

QString Quantity::shownUnit() const { return preferred() ? spelled(*preferred()) : unit; }

double Quantity::toShown(double stored) const { return preferred() ? preferred()->typed(stored) : stored * shown_per_stored; }

double Quantity::fromShown(double shown) const { return preferred() ? preferred()->stored(shown) : shown / shown_per_stored; }

/// As fine in a larger unit as in the one that is stored.
int Quantity::shownDecimals(double stored) const
{
    if (measure != Measure::length || !preferred() || decimals == 0 || stored == 0) { return decimals; }
    return decimals + static_cast<int>(std::ceil(std::log10(stored / preferred()->typed(stored))));
}

bool Quantity::shortens(double stored) const
{
    if (measure != Measure::length || !preferred()) { return false; }
    const double shown = toShown(stored), scale = std::pow(10.0, shownDecimals(stored));
    return std::abs(std::round(shown * scale) / scale - shown) > 1e-9 * std::abs(shown);
}

/// A length that was typed in the unit that is shown keeps its digits; converted from another one it has endlessly many, of which three are
/// shown.
QString Quantity::number(double stored) const
{
    return shortens(stored) ? significant(toShown(stored)) : shownNumber(toShown(stored), shownDecimals(stored));
}

QString Quantity::text(double stored) const { return withUnit(number(stored), shownUnit()); }

QString Quantity::shortText(double stored) const
{
    return withUnit(decimals == 0 ? number(stored) : significant(toShown(stored)), shownUnit());
}

QString Quantity::fullText(double stored) const { return withUnit(inFull(toShown(stored)), shownUnit()); }

QString Quantity::besideText(double stored) const
{
    const bool usual = preferred() == nullptr;
    if (measure == Measure::sett) {
        return usual ? withUnit(shownNumber(per_inch_from_per_cm(stored), 0), "/in") : withUnit(shownNumber(stored, 1), "/cm");
    }
    if (measure == Measure::linear_density) {
        return usual ? QCoreApplication::translate("hygroloom::Quantity", "Ne %1").arg(shownNumber(ne_from_tex(stored), 1))
                     : withUnit(shownNumber(stored, 1), "tex");
    }
    return {};
}

QString Quantity::range() const
{
    double low = minimum, high = maximum;
    if (toShown(low) > toShown(high)) { std::swap(low, high); } // a count: the finer the yarn, the higher
    return QCoreApplication::translate("hygroloom::Quantity", "Allowed: %1 to %2.").arg(number(low), text(high));
}

std::optional<double> Quantity::parse(const QString& typed, QString* complaint) const
{
    const auto complain = [&](const QString& sentence) {
        if (complaint) { *complaint = sentence; }
        return std::optional<double>();
    };
    static const QRegularExpression form("^\\s*([-+]?[0-9]*[.,]?[0-9]*(?:[eE][-+]?[0-9]+)?)\\s*(.*?)\\s*$");
    const auto match = form.match(QString(typed).replace(QChar(0x00a0), ' '));
    bool isNumber = false;
    const double number = match.captured(1).replace(',', '.').toDouble(&isNumber);
    if (!isNumber) {
        return complain(QCoreApplication::translate("hygroloom::Quantity", "“%1” does not begin with a number.").arg(typed.trimmed()));
    }
    if (decimals == 0 && number != std::round(number)) {
        return complain(QCoreApplication::translate("hygroloom::Quantity", "“%1” is not a whole number.").arg(typed.trimmed()));
    }
    const QString unit = QString(match.captured(2)).replace(QChar(0x03bc), QChar(0x00b5));
    if (unit.isEmpty()) { return fromShown(number); }
    for (const Qt::CaseSensitivity sensitivity : {Qt::CaseSensitive, Qt::CaseInsensitive}) {
        for (const TradeUnit& candidate : units) {
            for (const std::string_view spelling : candidate.spellings) {
                if (unicode(spelling).compare(unit, sensitivity) == 0) { return candidate.stored(number); }
            }
        }
    }
    QStringList known;
    for (const TradeUnit& candidate : units) { known << spelled(candidate); }
    known.removeAll(QString());
    if (known.isEmpty()) {
        return complain(QCoreApplication::translate("hygroloom::Quantity", "This number has no unit; remove “%1”.").arg(unit));
    }
    return complain(
        QCoreApplication::translate("hygroloom::Quantity", "“%1” is not a unit of this field. Use %2.").arg(unit, known.join(", ")));
}

double Quantity::stepped(double stored, double steps) const
{
    const double shown = toShown(stored);
    double size = step;
    if (size == 0) {
        const double magnitude = std::floor(std::log10(std::max(std::abs(shown), 1e-9)) + 1e-9);
        size = std::max(std::pow(10.0, magnitude - 1), std::pow(10.0, -shownDecimals(stored)));
    }
    size *= std::abs(steps) < 1 ? std::abs(steps) : 1;
    const double count = std::abs(steps) < 1 ? (steps > 0 ? 1 : -1) : steps;
    const double grid = shown / size;
    const double nearest = std::round(grid);
    const bool onGrid = std::abs(grid - nearest) < 1e-6;
    const double from = onGrid ? nearest : (count > 0 ? std::floor(grid) : std::ceil(grid));
    const double next = (from + count) * size;
    // Of a count nothing, or less, is an endless yarn's.
    if (measure == Measure::linear_density && next <= 0) { return stored; }
    return std::clamp(fromShown(next), minimum, maximum);
}

} // namespace hygroloom
