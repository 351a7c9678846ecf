// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Numbers with units as people type and read them: "30 Ne", "0.2mm", "100 epi". The stored unit is the design's.
#pragma once

#include "core/base/trade_units.h"
#include "core/design/field.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace hygroloom {

/// Of which numbers the preferences choose the unit that is shown.
enum class Measure { other, length, linear_density, sett, temperature };

/// One kind of number: what it is shown in, what may be typed, what is allowed.
struct Quantity {
    QString unit;                 ///< of the stored number, or that times shown_per_stored; empty for a plain one
    std::vector<TradeUnit> units; ///< the one of unit first; compared without case unless it would be ambiguous
    Measure measure = Measure::other;
    double shown_per_stored = 1;
    double minimum = 0; ///< stored unit
    double maximum = 1;
    double step = 0;  ///< of an arrow key, in the shown unit; 0: a tenth of the number's own magnitude
    int decimals = 3; ///< 0: a count, of which no fraction is taken

    /// Of a row of fields: as its unit is usually shown and stepped.
    static Quantity of(Stored unit, double minimum, double maximum, bool is_whole);
    template <typename Owner> static Quantity of(const Field<Owner>& row) { return of(row.unit(), row.least, row.most, row.is_whole()); }
    static Quantity length(double minimum_mm, double maximum_mm);
    static Quantity linearDensity(double minimum_tex, double maximum_tex);
    static Quantity sett(double minimum_per_cm, double maximum_per_cm);
    static Quantity twist(double maximum_per_m);
    static Quantity perMillimetre(double maximum);
    static Quantity fraction(double minimum, double maximum); ///< plain number
    static Quantity percent(double minimum, double maximum);  ///< stored as a fraction
    static Quantity count(int minimum, int maximum);
    static Quantity angle(double minimum_deg, double maximum_deg);
    static Quantity temperature(double minimum_c, double maximum_c);
    static Quantity speed(double maximum_m_s);
    static Quantity volume(double minimum_ul, double maximum_ul);
    static Quantity time(double minimum_s, double maximum_s);
    static Quantity arealDensity(double maximum_g_m2);
    static Quantity arealRate(double maximum_g_m2_h);
    static Quantity surfaceTension(double minimum_mn_m, double maximum_mn_m);
    static Quantity viscosity(double minimum_mpa_s, double maximum_mpa_s);
    static Quantity density(double minimum_kg_m3, double maximum_kg_m3);

    QString shownUnit() const;              ///< unit, or the preferred one
    QString number(double stored) const;    ///< "35"
    QString text(double stored) const;      ///< "35 /cm"
    bool shortens(double stored) const;     ///< whether text() has fewer digits than the number
    QString shortText(double stored) const; ///< of a calculated number: three significant digits
    QString fullText(double stored) const;  ///< of the same, as it was computed
    QString range() const;                  ///< "Allowed: 1 to 200 /cm."
    /// The stored value of what was typed, or why it cannot be read.
    std::optional<double> parse(const QString& typed, QString* complaint = nullptr) const;
    double stepped(double stored, double steps) const;
    /// The number in another unit that the trade uses: "Ne 30", "89 /in"; empty for other measures.
    QString besideText(double stored) const;

private:
    const TradeUnit* preferred() const; ///< nullptr: unit is shown
    double toShown(double stored) const;
    double fromShown(double shown) const;
    int shownDecimals(double stored) const;
};

/// A number with at most this number of decimals and no trailing zeros, in the user's locale.
QString shownNumber(double value, int decimals);

/// Three significant digits; a whole number keeps all of its own.
QString significant(double value);
/// The number as it was computed, to be said where the short one is pointed at.
QString inFull(double value);

/// A value with its unit, in the user's unit where it is a length ("mm"), a speed ("mm/s") or a temperature ("°C"): three significant
/// digits, or all.
QString valueText(double value, const QString& unit, bool full = false);
/// The user's unit of a value in that one ("mm", "mm/s", "°C", "tex", "/cm"), how many of it one is, and what zero is in it; of a count
/// the number over the value.
struct UserUnit {
    QString unit;
    double per_one = 1;
    double at_zero = 0;
    bool inverse = false;
    double of(double value) const { return inverse ? per_one / value : value * per_one + at_zero; }
};
UserUnit userUnit(const QString& unit);

/// A time in s within a duration in s; all times of one duration have equal decimals: "3.20 s" of 10 s.
QString momentText(double seconds, double duration);

/// "820 kB", "3.4 MB", "34 MB", "1.2 GB".
QString bytesText(double bytes);

} // namespace hygroloom
