// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The strip over the picture: from where it is looked at, what is cut open, what is measured. The View menu has the same commands.
#pragma once

#include "ui/picture/textile_canvas.h"

#include <QToolBar>

class QAction;
class QComboBox;
class QDoubleSpinBox;
class QMenu;
class QSlider;

namespace hygroloom {

/// Sides of the swatch that the design workspace shows, to choose from.
constexpr double swatch_sides_mm[] = {5, 20, 50, 100};
constexpr int first_swatch = 1;

class ViewBar : public QToolBar {
    Q_OBJECT
public:
    /// canvas: what its commands act on; nullptr disables them.
    explicit ViewBar(TextileCanvas* canvas, QWidget* parent = nullptr);

    /// Adds the commands to a menu of the window.
    void fillMenu(QMenu* menu);
    /// What a single key does in the picture; false when it does nothing.
    bool pressKey(int key);
    QAction* fitAction() const { return fit_; }
    void setSection(const SectionPlane& section);
    const SectionPlane& section() const { return section_; }
    /// The fabric that is shown reaches this far from its middle, in mm.
    void setHalfExtent(const QVector3D& half);
    /// One of swatch_sides_mm.
    int swatch() const { return swatch_; }

Q_SIGNALS:
    void swatchChosen(int choice);

private:
    QAction* addKeyed(const QString& text, int key, const QString& tip, std::function<void(TextileCanvas&)> work);
    QMenu* choices(const QString& title, const QString& setting, const QStringList& names, int first,
                   const std::function<void(int)>& choose);
    void buildViews();
    void buildSection();
    void buildMeasure();
    void refreshSection();
    double half() const; ///< mm, that the section may be moved each way

    TextileCanvas* canvas_;
    std::vector<std::pair<int, QAction*>> keys_;
    QAction* fit_ = nullptr;
    QAction* parallel_ = nullptr;
    QAction* particles_ = nullptr;
    QAction* shadow_ = nullptr;
    QAction* measure_ = nullptr;
    QMenu* views_ = nullptr;
    QMenu* swatches_ = nullptr;
    QMenu* navigation_ = nullptr;
    QMenu* sections_ = nullptr;
    QComboBox* measure_on_ = nullptr;
    QSlider* slider_ = nullptr;
    QDoubleSpinBox* position_ = nullptr;
    QAction* flip_ = nullptr;
    std::vector<QAction*> section_parts_; ///< shown only while something is cut
    QAction* measure_part_ = nullptr;
    SectionPlane section_;
    QVector3D half_extent_{10, 10, 10}; ///< mm
    int swatch_ = first_swatch;
};

} // namespace hygroloom
