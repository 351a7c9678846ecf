// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Fields of one yarn of the chosen fabric.
#pragma once

#include "ui/design_form.h"

class QCheckBox;
class QToolButton;

namespace hygroloom {

class YarnPanel : public QObject {
    Q_OBJECT
public:
    /// Adds its rows to the form. The weft's can follow the warp's.
    YarnPanel(DesignForm& form, bool weft, QObject* parent);

private:
    const Yarn* yarn() const;
    /// Changes the yarn, and the weft with the warp while it is the same.
    std::function<void(Design&, std::optional<double>)> writing(std::function<void(Yarn&, std::optional<double>)> change);
    void editYarn(const QString& undo, const std::string& field, const std::function<void(Yarn&)>& change);
    std::string path(const char* field) const;
    void addMaterials();
    void addColor(const QString& kind);
    void refresh();
    void refreshMaterials();

    DesignForm& form_;
    bool weft_;
    QCheckBox* same_ = nullptr;
    QComboBox* fibre_ = nullptr;
    QComboBox* blend_ = nullptr;
    QComboBox* twist_direction_ = nullptr;
    QComboBox* ply_direction_ = nullptr;
    QToolButton* color_ = nullptr;
    QuantityEdit* ply_twist_ = nullptr;
    QuantityEdit* share_ = nullptr;
    QuantityEdit* diameter_ = nullptr;
    QuantityEdit* density_ = nullptr;
    QuantityEdit* packing_ = nullptr;
    QLabel* density_note_ = nullptr;
    QLabel* diameter_note_ = nullptr;
    QLabel* crimp_ = nullptr;
    QLabel* pore_ = nullptr;
    std::vector<QWidget*> fields_;
    std::string unlinked_; ///< fabric whose equal weft the user wants to edit apart
};

} // namespace hygroloom
