// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The dock of what lies between: the gap between skin and cloth zone by zone, and what share of the water each seam passes.
#pragma once

#include "ui/garment/garment_choice.h"

#include <QScrollArea>

class QTableWidget;

namespace hygroloom {

class QuantityEdit;
class ZonesForm;

class FitForm : public QScrollArea {
    Q_OBJECT
public:
    explicit FitForm(GarmentChoice& choice, QWidget* parent = nullptr);

    /// Of a zone, of "shoulder", or of "default"; nullptr: there is no such row.
    QuantityEdit* gapOf(const std::string& zone) const;
    /// Between two panels in either order; of all seams that have no share of their own without names.
    QuantityEdit* seamOf(const std::string& one = {}, const std::string& other = {}) const;
    ZonesForm& ownZones() { return *own_zones_; }

private:
    struct Gap {
        std::string zone;
        QuantityEdit* edit;
    };
    struct Seam {
        std::string one, other; ///< empty: all that are not named
        QuantityEdit* edit;
    };
    void addGap(const std::string& zone, const QString& name);
    void addSeam(const std::string& one, const std::string& other, const QString& name);
    void rebuildSeams();
    void refresh();

    GarmentChoice& choice_;
    QTableWidget* zones_;
    QTableWidget* seam_rows_;
    ZonesForm* own_zones_;
    std::vector<Gap> gaps_;
    std::vector<Seam> seams_;
};

} // namespace hygroloom
