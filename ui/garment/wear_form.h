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
    void addField(QFormLayout* form, const QString& name, const Quantity& quantity, const char* key, double& (*value)(WearExperiment&));
    void refresh();
    void refreshActivity();

    GarmentChoice& choice_;
    QComboBox* wears_;
    QToolButton* add_;
    QToolButton* rename_;
    QToolButton* remove_;
    struct Field {
        QuantityEdit* edit;
        std::string key;
        double& (*value)(WearExperiment&);
    };
    std::vector<Field> fields_;
    QLabel* activity_title_;
    QTableWidget* activity_;
    RatesFile* rates_;
    QToolButton* add_activity_;
    QToolButton* remove_activity_;
};

} // namespace hygroloom
