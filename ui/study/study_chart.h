// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the charts of a study share: the picture of all rows is drawn once and kept, for there may be 100 000.
#pragma once

#include "ui/study/study_data.h"

#include <QFontMetricsF>
#include <QPixmap>
#include <QWidget>

class QComboBox;
class QPainter;

namespace hygroloom {

class StudyChart : public QWidget {
    Q_OBJECT
public:
    explicit StudyChart(QWidget* parent = nullptr);

    virtual void setStudy(std::shared_ptr<const StudyData> study);
    /// Rows that others brushed; the rest is drawn faint.
    void setKept(const KeptPoints& kept);
    /// The row that is marked.
    void setChosen(std::optional<std::size_t> row);
    std::optional<std::size_t> chosen() const { return chosen_; }
    /// The numbers under the pointer, as text; empty: none.
    virtual QString tipAt(const QPointF&) const { return {}; }

Q_SIGNALS:
    void rowChosen(std::size_t row);

protected:
    /// All that does not depend on the chosen row or the pointer.
    virtual void drawPicture(QPainter& painter) = 0;
    virtual void drawMarks(QPainter&) {}
    void redraw();
    bool isKept(std::size_t row) const { return kept_.empty() || kept_[row]; }
    bool hasRows() const { return data_ && data_->table.rows() > 0; }
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool event(QEvent* event) override;
    QSize minimumSizeHint() const override { return {260, 200}; }

    std::shared_ptr<const StudyData> data_;
    KeptPoints kept_;
    std::optional<std::size_t> chosen_;

private:
    QPixmap picture_;
};

/// The axes' titles in a box; what was chosen stays where it is still there, else the one at that place.
void fillAxes(QComboBox& box, const StudyData* data, bool factors, bool metrics, std::size_t otherwise);
/// The axis that an entry of the box stands for; nullptr: none.
const StudyAxis* chosenAxis(const QComboBox& box, const StudyData* data);

/// What stands below a tick of the axis across: pixels, as the area.
struct TickLabel {
    double at = 0;              ///< of the tick
    double left = 0, width = 0; ///< of its text
    QString text;               ///< empty: there is no room for it
};
/// Each word has a text, cut where its neighbours leave no more room; of numbers those that have room.
std::vector<TickLabel> tickLabels(const QRectF& area, const StudyAxis& across, const QFontMetricsF& metrics);
/// Lines and numbers of two axes round an area.
void drawAxes(QPainter& painter, const QRectF& area, const StudyAxis& across, const StudyAxis& up, const QPalette& palette);
/// Of a value from 0 to 1: blue to yellow, as far as both are seen on the palette.
QColor studyColor(double share, const QPalette& palette);
QColor gridColor(const QPalette& palette);

} // namespace hygroloom
