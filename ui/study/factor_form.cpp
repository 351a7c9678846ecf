// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/study/factor_form.h"

#include "ui/study/study_fields.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QSignalBlocker>

#include <cmath>

namespace hygroloom {

namespace {

using Type = FactorDistribution::Type;

/// A comma may stand for the point.
std::optional<double> numberOf(const QString& text)
{
    bool is = false;
    const double number = QString(text).replace(',', '.').trimmed().toDouble(&is);
    return is && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

/// As it is in the project, or with 6 digits in another unit, which has endlessly many.
QString textOf(const std::optional<double>& number, const UserUnit& unit)
{
    if (!number) { return {}; }
    const bool own = unit.per_one == 1 && unit.at_zero == 0;
    return own ? QString::fromStdString(factor_value(*number).text) : QString::number(unit.of(*number), 'g', 6);
}

/// A distance of two numbers.
QString widthText(const std::optional<double>& number, UserUnit unit)
{
    unit.at_zero = 0;
    return textOf(number, unit);
}

QString textOf(const FactorValue& value, const UserUnit& unit)
{
    return value.is_number ? textOf(std::optional(value.number), unit) : QString::fromStdString(value.text);
}

FactorValue valueOf(const QString& text, const UserUnit& unit)
{
    bool is = false;
    const double number = text.toDouble(&is);
    if (!is) { return factor_value(text.toStdString()); }
    return unit.per_one == 1 && unit.at_zero == 0 ? factor_value(number) : factor_value((number - unit.at_zero) / unit.per_one);
}

/// With few digits: 0.9 times 35 is 31.5, not 31.500000000000004.
double shortened(double number) { return QString::number(number, 'g', 3).toDouble(); }

} // namespace

QString spreadText(const Factor& factor, const UserUnit& unit)
{
    const FactorDistribution& d = factor.distribution;
    if (factor.is_list()) {
        QStringList words;
        for (const FactorValue& value : factor.values) { words << textOf(value, unit); }
        return words.join(", ");
    }
    const auto number = [&unit](const std::optional<double>& at) { return at ? studyNumber(unit.of(*at)) : QString("?"); };
    const auto width = [&unit](double sd) { return studyNumber(unit.per_one * sd); };
    const QString range = FactorForm::tr("%1 to %2").arg(number(d.low), number(d.high));
    switch (d.type) {
    case Type::uniform: return factor.step ? FactorForm::tr("%1, step %2").arg(range, width(*factor.step)) : range;
    case Type::log_uniform: return FactorForm::tr("%1, logarithmic").arg(range);
    case Type::normal: return FactorForm::tr("normal, %1 ± %2").arg(number(d.mean), width(d.sd));
    case Type::lognormal: return FactorForm::tr("lognormal, %1 ± %2").arg(number(d.mean), width(d.sd));
    case Type::triangular: return FactorForm::tr("%1, most often %2").arg(range, number(d.mode));
    }
    return range;
}

Factor proposedFactor(const std::string& path, std::optional<double> now)
{
    Factor factor;
    factor.path = path;
    const double middle = now.value_or(0.5);
    factor.distribution.low = now ? shortened(middle - 0.2 * std::abs(middle)) : 0;
    factor.distribution.high = now && middle != 0 ? shortened(middle + 0.2 * std::abs(middle)) : 1;
    if (path.find("contact_angle_deg") != std::string::npos && !now) {
        factor.distribution.low = 20;
        factor.distribution.high = 60;
    }
    return factor;
}

FactorForm::FactorForm(QWidget* parent) : QWidget(parent), form_(new QFormLayout(this)), spread_(new QComboBox)
{
    form_->setContentsMargins(0, 4, 0, 0);
    form_->setVerticalSpacing(4);
    spread_->addItems({tr("Range"), tr("List of values"), tr("Range, logarithmic"), tr("Normal"), tr("Lognormal"), tr("Triangular")});
    spread_->setAccessibleName(tr("How the factor is spread"));
    form_->addRow(tr("Spread:"), spread_);
    add("values", tr("Values:"), tr("Numbers or words, separated by commas: 20, 40, 60"));
    add("mean", tr("Mean:"), {});
    add("sd", tr("Standard deviation:"), {});
    add("low", tr("From:"), {});
    add("mode", tr("Most often:"), {});
    add("high", tr("To:"), {});
    add("step", tr("Step:"), tr("Only values that are whole steps from the lowest; empty: any value."));
    add("levels", tr("Levels:"), tr("On a grid, and one at a time; empty: as many as the points allow."));
    add("base", tr("Base:"), tr("Where other factors change one at a time; empty: the project's own value."));
    connect(spread_, &QComboBox::currentIndexChanged, this, [this] {
        showFields();
        Q_EMIT edited();
    });
    showFields();
}

void FactorForm::add(const QString& name, const QString& label, const QString& tip)
{
    auto* field = new QLineEdit;
    field->setAccessibleName(QString(label).remove(':'));
    if (!tip.isEmpty()) { field->setToolTip("<p>" + tip + "</p>"); }
    connect(field, &QLineEdit::editingFinished, this, [this, field] {
        if (!field->isModified()) { return; }
        field->setModified(false);
        Q_EMIT edited();
    });
    form_->addRow(label, field);
    fields_[name] = field;
}

FactorForm::Spread FactorForm::spread() const { return static_cast<Spread>(spread_->currentIndex()); }

void FactorForm::setSpread(Spread spread) { spread_->setCurrentIndex(static_cast<int>(spread)); }

void FactorForm::showFields()
{
    const Spread at = spread();
    const bool list = at == Spread::list, bell = at == Spread::normal || at == Spread::lognormal;
    const std::pair<const char*, bool> shown[] = {{"values", list},
                                                  {"mean", bell},
                                                  {"sd", bell},
                                                  {"low", !list},
                                                  {"mode", at == Spread::triangular},
                                                  {"high", !list},
                                                  {"step", at == Spread::range},
                                                  {"levels", !list},
                                                  {"base", true}};
    for (const auto& [name, is] : shown) { form_->setRowVisible(fields_.at(name), is); }
    const QString bound = bell ? tr("no bound") : QString();
    fields_.at("low")->setPlaceholderText(bound);
    fields_.at("high")->setPlaceholderText(bound);
}

void FactorForm::setFactor(const Factor& factor, const UserUnit& unit)
{
    unit_ = unit;
    const QSignalBlocker quiet(spread_);
    path_ = factor.path;
    const FactorDistribution& d = factor.distribution;
    constexpr Spread spreads[] = {Spread::range, Spread::log_range, Spread::normal, Spread::lognormal,
                                  Spread::triangular}; // as Type has them
    setSpread(factor.is_list() ? Spread::list : spreads[static_cast<int>(d.type)]);
    const bool bell = d.type == Type::normal || d.type == Type::lognormal;
    fields_.at("values")->setText(factor.is_list() ? spreadText(factor, unit_) : QString());
    fields_.at("mean")->setText(bell ? textOf(d.mean, unit_) : QString());
    fields_.at("sd")->setText(bell ? widthText(d.sd, unit_) : QString());
    fields_.at("low")->setText(textOf(d.low, unit_));
    fields_.at("high")->setText(textOf(d.high, unit_));
    fields_.at("mode")->setText(d.type == Type::triangular ? textOf(d.mode, unit_) : QString());
    fields_.at("step")->setText(widthText(factor.step, unit_));
    fields_.at("levels")->setText(factor.levels ? QString::number(*factor.levels) : QString());
    fields_.at("base")->setText(factor.base ? textOf(*factor.base, unit_) : QString());
    showFields();
}

std::optional<double> FactorForm::number(const QString& name, const QString& title, bool needed, QString& complaint) const
{
    const QString text = fields_.at(name)->text().trimmed();
    if (text.isEmpty() && !needed) { return std::nullopt; }
    const std::optional<double> number = numberOf(text);
    if (!number && complaint.isEmpty()) {
        complaint =
            text.isEmpty() ? tr("%1 is missing; type a number.").arg(title) : tr("%1 must be a number; given is “%2”.").arg(title, text);
    }
    return number;
}

std::optional<double> FactorForm::stored(std::optional<double> shown) const
{
    return shown && (unit_.per_one != 1 || unit_.at_zero != 0) ? std::optional((*shown - unit_.at_zero) / unit_.per_one) : shown;
}

std::optional<double> FactorForm::storedWidth(std::optional<double> shown) const
{
    return shown && unit_.per_one != 1 ? std::optional(*shown / unit_.per_one) : shown;
}

void FactorForm::readList(DraftFactor& draft) const
{
    for (const QString& word : fields_.at("values")->text().split(',', Qt::SkipEmptyParts)) {
        if (!word.trimmed().isEmpty()) { draft.factor.values.push_back(valueOf(word.trimmed(), unit_)); }
    }
    if (draft.factor.values.empty()) { draft.complaint = tr("The list is empty; type values separated by commas."); }
}

void FactorForm::readNumbers(DraftFactor& draft) const
{
    const Spread at = spread();
    FactorDistribution& d = draft.factor.distribution;
    QString& complaint = draft.complaint;
    constexpr Type types[] = {Type::uniform, Type::uniform, Type::log_uniform, Type::normal, Type::lognormal, Type::triangular};
    d.type = types[static_cast<int>(at)];
    const bool bell = at == Spread::normal || at == Spread::lognormal;
    if (bell) {
        d.mean = stored(number("mean", tr("The mean"), true, complaint)).value_or(0);
        d.sd = storedWidth(number("sd", tr("The standard deviation"), true, complaint)).value_or(0);
    }
    d.low = stored(number("low", tr("The lowest value"), !bell, complaint));
    if (at == Spread::triangular) { d.mode = stored(number("mode", tr("The most frequent value"), true, complaint)).value_or(0); }
    d.high = stored(number("high", tr("The highest value"), !bell, complaint));
}

void FactorForm::readOptions(DraftFactor& draft) const
{
    if (spread() == Spread::range) { draft.factor.step = storedWidth(number("step", tr("The step"), false, draft.complaint)); }
    if (spread() != Spread::list && !draft.factor.step) {
        if (const auto levels = number("levels", tr("The number of levels"), false, draft.complaint)) {
            if (*levels != std::floor(*levels) || *levels < 2 || *levels > 10000) {
                draft.complaint = tr("The number of levels must be a whole number from 2 to 10000; given is %1.").arg(studyNumber(*levels));
            } else {
                draft.factor.levels = static_cast<int>(*levels);
            }
        }
    }
    if (const QString base = fields_.at("base")->text().trimmed(); !base.isEmpty()) { draft.factor.base = valueOf(base, unit_); }
}

DraftFactor FactorForm::factor() const
{
    DraftFactor draft;
    draft.factor.path = path_;
    if (spread() == Spread::list) {
        readList(draft);
    } else {
        readNumbers(draft);
    }
    readOptions(draft);
    return draft;
}

} // namespace hygroloom
