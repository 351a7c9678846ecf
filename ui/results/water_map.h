// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// One face of the fabric from above, in cells of n x n crossings: water per area, temperature or humidity.
#pragma once

#include "core/analysis/cell_map.h"
#include "core/analysis/metrics.h"
#include "core/analysis/replicate_range.h"
#include "ui/basics/color_map.h"
#include "ui/results/map_difference.h"

#include <QImage>
#include <QWidget>

#include <optional>
#include <vector>

namespace hygroloom {

/// What a map shows of one face at one time.
struct FaceMap {
    CellMap cells;
    std::optional<Circle> stain; ///< of experiments that make one
    QSizeF size;                 ///< of the fabric, m
};

/// What the interval of so many replicates is: "5th to 95th percentile of 16 replicates".
QString replicateRange(int runs);

/// first: the run's first frame.
FaceMap faceMap(const RunRecord& run, const Frame& frame, const Frame& first, MapSide side, int crossings_per_cell,
                ShownQuantity quantity = ShownQuantity::water);

/// The most water of a cell of either face, kg/m2. start: start_of_maps() of the run. The colours of a run's maps reach to rounded_up() of
/// the most of all its frames.
double mostOnFaces(const Textile& textile, const Frame& frame, const Frame& start, int crossings_per_cell);

class WaterMap : public QWidget {
    Q_OBJECT
public:
    explicit WaterMap(const QString& title, QWidget* parent = nullptr);

    /// size: of the fabric, m; cells at the far edges may reach beyond it.
    void setMap(const CellMap& map, const std::optional<Circle>& circle, const QSizeF& size);
    /// What the value under the pointer has beside it, until another map is set; none: nothing.
    void setReplicates(const std::optional<MapRange>& replicates);
    /// What is said there, in pixels; empty outside the cloth.
    QString wordsAt(const QPointF& at) const;
    /// Instead of the map, its difference to a baseline.
    void setDifference(const MapDifference& difference, const QSizeF& size);
    void clear();
    /// Hatched: what is shown is of before, and what follows is being computed.
    void setOutdated(bool outdated);
    bool outdated() const { return outdated_; }
    /// All that stand in one row, this among them: they have one scale, and bars of one length. They live as long as this.
    void setRow(const std::vector<WaterMap*>& row) { row_ = row; }
    double pixelsPerMetre() const;
    /// For how many pixels the bar of its scale is chosen.
    double roomOfBar() const;
    /// What the ends of the colours stand for, in the map's unit.
    void setRange(double maximum, WaterColors colors, double minimum = 0);
    const CellMap& map() const { return map_; }
    const Circle& circle() const { return circle_; }
    QSize sizeHint() const override { return {220, 220}; }
    QSize minimumSizeHint() const override { return {120, 110}; }

Q_SIGNALS:
    /// The value under the pointer, as text; empty outside.
    void pointed(const QString& text);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    QRectF roomOfMap() const;
    /// None: it has no map.
    std::optional<double> ownScale() const;
    QRectF mapArea() const;
    void updateRow();
    /// In fewer words where there is little room, in pixels.
    QString radiusText(double room) const;
    void render();
    QColor colorOf(int column, int row) const;
    QString valueText(int column, int row) const;
    /// Column and row; less than 0: outside.
    QPoint cellAt(const QPointF& at) const;

    QString title_;
    CellMap map_;
    Circle circle_;
    bool stain_ = true; ///< whether there is one to speak of
    bool difference_ = false;
    bool outdated_ = false;
    std::optional<MapRange> replicates_;
    std::vector<bool> real_; ///< cells of a difference, see MapDifference
    QSizeF size_;
    QImage image_;
    double minimum_ = 0, maximum_ = 1;
    WaterColors colors_ = WaterColors::blue;
    QPoint cell_{-1, -1};
    std::vector<WaterMap*> row_{this};
};

} // namespace hygroloom
