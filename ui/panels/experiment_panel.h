// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The chosen experiment: its type, climate, sample, liquid, and what its type has.
#pragma once

#include "ui/panels/design_form.h"

#include <QScrollArea>

class QCheckBox;
class QToolButton;

namespace hygroloom {

class ClimateCourse;
class DropletSection;
class LiquidPanel;

/// As the window begins one: the standard's; a drop has a sample on which its water stays. Files that name no sample keep theirs.
Experiment freshExperiment(ExperimentType type);

class ExperimentPanel : public QScrollArea {
    Q_OBJECT
public:
    explicit ExperimentPanel(Document& document, QWidget* parent = nullptr);

    void addExperiment();
    DropletSection& droplets() { return *droplets_; }
    /// Shows the field of the value at this path, in the chosen experiment or in a liquid of the project, and gives it the focus.
    bool showField(const Place& where);

private:
    /// An object in the chosen experiment; before(): its path there, with a dot. of(experiment): it.
    template <typename Part, typename Before, typename Of> FormOwner<Part> part(Before before, Of of, const QString& kind = {})
    {
        return {[this, before] { return "experiments[" + std::to_string(document_.experimentIndex()) + "]." + before(); },
                [this, of]() -> const Part* { return document_.experiment() ? of(*document_.experiment()) : nullptr; },
                [this, of](Design& design, const std::function<void(Part&)>& change) {
                    change(*of(design.experiments[static_cast<std::size_t>(document_.experimentIndex())]));
                },
                kind};
    }
    FormOwner<Experiment> whole()
    {
        return part<Experiment>([] { return ""; }, [](auto& experiment) { return &experiment; });
    }
    QuantityEdit* addSampleSize(std::size_t axis);
    void addChoice();
    void addConditions();
    void addTypes();
    void addModel();
    void refreshChoice();
    void refreshType();
    void setType(int chosen);
    void renameExperiment();
    void removeExperiment();
    void edit(const QString& undo, const std::function<void(Experiment&)>& change);

    Document& document_;
    DesignForm* form_;
    QComboBox* choice_ = nullptr;
    QToolButton* remove_ = nullptr;
    QToolButton* rename_ = nullptr;
    /// Rows that only some types have.
    struct Group {
        QWidget* widget;
        const char* field; ///< the types that use it have the rows
    };
    std::vector<Group> groups_;
    QComboBox* type_ = nullptr;
    LiquidPanel* liquids_ = nullptr;
    ClimateCourse* course_ = nullptr;
    QuantityEdit* size_[2] = {};
    QComboBox* closure_ = nullptr;
    QComboBox* direction_ = nullptr;
    QComboBox* side_ = nullptr;
    QCheckBox* swelling_ = nullptr;
    DropletSection* droplets_ = nullptr;
};

} // namespace hygroloom
