// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The fields of one factor: how it is spread, and over which values.
#pragma once

#include "core/study/study.h"
#include "ui/basics/quantity.h"

#include <QWidget>

#include <map>

class QComboBox;
class QFormLayout;
class QLineEdit;

namespace hygroloom {

/// A factor, and what is wrong with what was typed for it.
struct DraftFactor {
    Factor factor;
    QString complaint; ///< empty: nothing
};

/// How a factor is spread, in words: "26 to 36", "20, 40, 60", "normal, 800 ± 40".
QString spreadText(const Factor& factor, const UserUnit& unit = {});
/// A range round the present value of a field, or from 0 to 1 where it has none.
Factor proposedFactor(const std::string& path, std::optional<double> now);

class FactorForm : public QWidget {
    Q_OBJECT
public:
    explicit FactorForm(QWidget* parent = nullptr);

    /// Fields show and take numbers in the unit; the factor has them in its own.
    void setFactor(const Factor& factor, const UserUnit& unit = {});
    DraftFactor factor() const;

    enum class Spread { range, list, log_range, normal, lognormal, triangular };
    void setSpread(Spread spread);
    /// The field of that name: "low", "high", "step", "values", "mean", "sd", "mode", "levels", "base".
    QLineEdit* field(const QString& name) const { return fields_.at(name); }

Q_SIGNALS:
    void edited();

private:
    void add(const QString& name, const QString& label, const QString& tip);
    Spread spread() const;
    void showFields();
    std::optional<double> number(const QString& name, const QString& title, bool needed, QString& complaint) const;
    std::optional<double> stored(std::optional<double> shown) const;
    std::optional<double> storedWidth(std::optional<double> shown) const;
    void readList(DraftFactor& draft) const;
    void readNumbers(DraftFactor& draft) const;
    void readOptions(DraftFactor& draft) const;

    std::string path_;
    UserUnit unit_;
    QFormLayout* form_;
    QComboBox* spread_;
    std::map<QString, QLineEdit*> fields_;
};

} // namespace hygroloom
