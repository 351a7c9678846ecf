// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The dock of the experiment on the chosen garment: duration, climate, activity.
#pragma once

#include "ui/basics/quantity.h"
#include "ui/garment/garment_choice.h"

#include <QScrollArea>

class QComboBox;
class QFormLayout;
class QLabel;
class QTableWidget;
class QToolButton;

namespace hygroloom {

class QuantityEdit;
class RatesFile;

class WearForm : public QScrollArea {
    Q_OBJECT
public:
    explicit WearForm(GarmentChoice& choice, QWidget* parent = nullptr);

    /// Half-way from the selected activity to the next one, or to the end.
    void addActivity();
    void removeActivity();
    RatesFile& rates() { return *rates_; }

private:
    QWidget* makeHead();
    QWidget* makeActivity();
    /// Of an object in the experiment; before: its path there, with a dot. of(experiment): it.
    template <typename Part, typename Of> void addField(QFormLayout* form, const char* key, const char* before, Of of);
    void refresh();
    void refreshActivity();

    GarmentChoice& choice_;
    QComboBox* wears_;
    QToolButton* add_;
    QToolButton* rename_;
    QToolButton* remove_;
    struct Shown {
        QuantityEdit* edit;
        std::string key;
        std::function<std::optional<double>(const WearExperiment&)> value;
    };
    std::vector<Shown> fields_;
    QLabel* activity_title_;
    QTableWidget* activity_;
    RatesFile* rates_;
    QToolButton* add_activity_;
    QToolButton* remove_activity_;
};

} // namespace hygroloom
