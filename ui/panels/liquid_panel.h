// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The liquid of the chosen experiment, and the project's own liquids.
#pragma once

#include "ui/panels/design_form.h"

class QToolButton;

namespace hygroloom {

class LiquidPanel : public QObject {
    Q_OBJECT
public:
    /// Adds the row of the experiment's liquid to the form.
    LiquidPanel(DesignForm& form, QWidget* parent);
    /// Adds a section with the project's own liquids to it.
    void addOwnLiquids();

    /// Shows the fields of one of the project's own.
    void choose(int liquid);
    /// A copy of the experiment's liquid, which the experiment takes.
    void addLiquid();
    void duplicateLiquid();
    /// Why it cannot have that name, in a sentence; empty: it can.
    QString whyNotNamed(const QString& name) const;
    /// Also in the experiments that use it. False, with the reason, where the name cannot be had.
    bool rename(const QString& name, QString* why);
    /// Experiments that use it take water, or the library's liquid of that name.
    void removeLiquid();

private:
    const Liquid* own() const;
    QStringList usersOf(const std::string& liquid) const;
    void refresh();
    void askName();
    void askRemoval();

    DesignForm& form_;
    QWidget* window_;
    QComboBox* used_ = nullptr;
    QLabel* note_ = nullptr;
    FormSection section_;
    QComboBox* own_ = nullptr;
    QToolButton* duplicate_ = nullptr;
    QToolButton* rename_ = nullptr;
    QToolButton* remove_ = nullptr;
    QLabel* users_ = nullptr;
    std::vector<QWidget*> fields_;
    int liquid_ = 0;        ///< of the project's own, the one last chosen; there may be fewer now
    std::string last_used_; ///< by the experiment that was shown, so that another choice of it is followed
};

} // namespace hygroloom
