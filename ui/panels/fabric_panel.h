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
    bool showField(const Place& where);

private:
    /// An object in the chosen fabric; before: its path in the fabric, with a dot. of(fabric): it.
    template <typename Part, typename Of> FormOwner<Part> part(const std::string& before, Of of, const QString& kind = {})
    {
        return {[this, before] { return "fabrics[" + std::to_string(document_.fabricIndex()) + "]." + before; },
                [this, of]() -> const Part* { return document_.fabric() ? of(*document_.fabric()) : nullptr; },
                [this, of](Design& design, const std::function<void(Part&)>& change) {
                    change(*of(design.fabrics[static_cast<std::size_t>(document_.fabricIndex())]));
                },
                kind};
    }
    FormOwner<Fabric> whole()
    {
        return part<Fabric>("", [](auto& fabric) { return &fabric; });
    }
    void addConstruction();
    void addSett(const char* key, double Fabric::*member);
    void addThickness();
    void addFinish();
    void addFaces();
    void addCrimps();
    void addFlyaway();
    void addMeasured();
    void addLoom();
    void addDerived();

    Document& document_;
    DesignForm* form_;
    YarnPanel* warp_ = nullptr;
    YarnPanel* stripes_ = nullptr;
    FibrePanel* fibres_ = nullptr;
};

} // namespace hygroloom
