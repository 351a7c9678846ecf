// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/basics/count_edit.h"

#include "ui/basics/core_words.h"
#include "ui/basics/preferences.h"

namespace hygroloom {

namespace {

/// In the order of YarnUnit.
CountSystem preferredSystem()
{
    constexpr CountSystem systems[] = {CountSystem::tex, CountSystem::ne, CountSystem::nm, CountSystem::denier};
    return systems[preferences().yarn];
}

} // namespace

CountEdit::CountEdit(QWidget* parent) : QuantityEdit(Quantity::linearDensity(least_tex, most_tex), parent) {}

void CountEdit::setYarn(const Yarn& yarn)
{
    const bool other = yarn.plies != plies_ || yarn.filament_count != filaments_;
    plies_ = yarn.plies;
    filaments_ = yarn.filament_count;
    typed_.reset();
    if (other) { takeBack(); }
    setValue(yarn.linear_density_tex);
}

YarnCount CountEdit::count() const
{
    if (typed_ && value() && typed_->tex() == *value()) { return *typed_; }
    return {value().value_or(0) / plies_, plies_, {}};
}

std::optional<double> CountEdit::parse(const QString& typed, QString* complaint) const
{
    try {
        typed_ = read_yarn_count(typed.trimmed().toStdString(), preferredSystem());
        return typed_->tex();
    } catch (const CountError& error) {
        if (complaint) {
            *complaint = tr("“%1” is no yarn count: %2. Write it as %3.")
                             .arg(typed.trimmed(), coreWord(QString::fromStdString(error.reason)), QString::fromUtf8(count_forms));
        }
        return {};
    }
}

QString CountEdit::textOf(double tex) const
{
    return QString::fromStdString(count_text(tex, plies_, filaments_, preferredSystem())).replace(' ', QChar(0x00a0));
}

QString CountEdit::otherSystem(double tex) const
{
    const CountSystem other = preferredSystem() != CountSystem::tex ? CountSystem::tex : filaments_ ? CountSystem::denier : CountSystem::ne;
    return QString::fromStdString(count_text(tex, plies_, filaments_, other));
}

double CountEdit::next(double tex, double steps) const { return plies_ * quantity().stepped(tex / plies_, steps); }

bool CountEdit::differs(std::optional<double> typed) const
{
    if (QuantityEdit::differs(typed)) { return true; }
    if (!typed || !typed_) { return false; }
    return typed_->plies != plies_ || (typed_->filaments && *typed_->filaments * typed_->plies != filaments_.value_or(0));
}

} // namespace hygroloom
