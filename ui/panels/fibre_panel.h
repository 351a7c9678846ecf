// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The project's own fibres: copies of fibres of the library, with fields for what differs.
#pragma once

#include "ui/panels/design_form.h"

class QToolButton;

namespace hygroloom {

class FibrePanel : public QObject {
    Q_OBJECT
public:
    /// Adds a section with the project's own fibres to the form.
    FibrePanel(DesignForm& form, QWidget* parent);

    const FormSection& section() const { return section_; }
    /// Shows the fields of one of the project's own.
    void choose(int fibre);
    /// Gives the cross-section the focus.
    void startEditing();
    void duplicateFibre();
    /// Why it cannot have that name, in a sentence; empty: it can.
    QString whyNotNamed(const QString& name) const;
    /// Also in the yarns that are made of it. False, with the reason, where the name cannot be had.
    bool rename(const QString& name, QString* why);
    /// Yarns that are made of it take the library's fibre that it is based on.
    void removeFibre();

private:
    const Material* own() const;
    std::string path(const char* field) const;
    /// Fabrics with a yarn of that fibre.
    QStringList usersOf(const std::string& fibre) const;
    FormOwner<Material> row();
    void change(const QString& undo, const std::string& where, const std::function<void(Material&)>& work);
    void addChoice();
    void addCrossSection();
    void addWetting();
    void addSorption();
    void addHeat();
    int isothermRow() const;
    void chooseIsotherm(int row);
    void refreshIsotherm();
    void refresh();
    void refreshShape();
    void askName();
    void askRemoval();

    DesignForm& form_;
    QWidget* window_;
    FormSection section_;
    QComboBox* own_ = nullptr;
    QToolButton* duplicate_ = nullptr;
    QToolButton* rename_ = nullptr;
    QToolButton* remove_ = nullptr;
    QLabel* about_ = nullptr;
    QComboBox* shape_ = nullptr;
    QuantityEdit* receding_ = nullptr;
    QComboBox* isotherm_ = nullptr;
    std::vector<QWidget*> fields_;
    int fibre_ = 0; ///< of the project's own, the one last chosen; there may be fewer now
};

/// The design's place of an own fibre of that name: the one it has, or a new copy of the library's, whose name is then free_name() of its
/// own. none: neither has it.
std::optional<std::size_t> ownFibre(Design& design, const std::string& name);

} // namespace hygroloom
