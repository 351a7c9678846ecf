// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The chosen fabric: sett, thickness, finish, both yarns, and the numbers that follow from them.
#pragma once

#include "ui/design_form.h"

#include <QScrollArea>

namespace hygroloom {

class FabricPanel : public QScrollArea {
    Q_OBJECT
public:
    explicit FabricPanel(Document& document, QWidget* parent = nullptr);

private:
    using Read = std::function<std::optional<double>(const Fabric&)>;
    using Write = std::function<void(Fabric&, std::optional<double>)>;
    DesignField field(const QString& label, const QString& undo, const char* where, Read read, Write write, const QString& help = {});
    void addConstruction();
    void addCrimps();
    void addFlyaway();
    void addMeasured();
    void addDerived();

    Document& document_;
    DesignForm* form_;
};

} // namespace hygroloom
