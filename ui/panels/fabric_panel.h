// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The chosen fabric: sett, thickness, finish, its yarns, and the numbers that follow from them.
#pragma once

#include "ui/panels/design_form.h"

#include <QScrollArea>

namespace hygroloom {

class FibrePanel;
class YarnPanel;

class FabricPanel : public QScrollArea {
    Q_OBJECT
public:
    explicit FabricPanel(Document& document, QWidget* parent = nullptr);

    /// Opens and scrolls to the fields of a yarn, as yarn_in() numbers them: 0 is the fabric's own.
    void showYarn(int yarn);
    /// Shows the field of the value at this path, in the chosen fabric or one of the project's own fibres, and gives it the focus.
    bool showField(const std::string& where);

private:
    using Read = std::function<std::optional<double>(const Fabric&)>;
    using Write = std::function<void(Fabric&, std::optional<double>)>;
    DesignField field(const QString& label, const QString& undo, const char* where, Read read, Write write, const QString& help = {});
    void addConstruction();
    void addSett(const QString& label, const QString& undo, const char* where, double Fabric::*member, const QString& help);
    void addThickness();
    void addFinish();
    void addFaces();
    void addCrimps();
    void addFlyaway();
    void addMeasured();
    void addDerived();

    Document& document_;
    DesignForm* form_;
    YarnPanel* warp_ = nullptr;
    YarnPanel* stripes_ = nullptr;
    FibrePanel* fibres_ = nullptr;
};

} // namespace hygroloom
