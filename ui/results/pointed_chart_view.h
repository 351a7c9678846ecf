// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A chart that tells the number under the pointer: of the nearest curve at that place, or of the marker there.
#pragma once

#include <QChartView>
#include <QPointer>
#include <QXYSeries>

#include <functional>
#include <optional>
#include <vector>

namespace hygroloom {

class PointedChartView : public QChartView {
    Q_OBJECT
public:
    explicit PointedChartView(QChart* chart, QWidget* parent = nullptr);

    /// What is said of a value of a series.
    using Words = std::function<QString(const QPointF& value)>;
    enum class Told {
        curve, ///< also between its points; the nearest to the pointer at its x
        points ///< its points alone, where the pointer is near one
    };
    void tell(QXYSeries* series, Told told, Words words);
    /// What was to be told so far.
    void forget();
    /// What is said there; empty: nothing. at: of this widget.
    QString wordsAt(const QPointF& at) const;

Q_SIGNALS:
    /// What is under the pointer; empty: nothing.
    void pointed(const QString& words);

protected:
    void drawForeground(QPainter* painter, const QRectF& rect) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    bool viewportEvent(QEvent* event) override;

private:
    struct Source {
        QPointer<QXYSeries> series;
        Told told;
        Words words;
    };
    struct Found {
        QPointF place; ///< of the chart
        QString words;
    };
    std::optional<Found> find(const QPointF& at) const;
    void point(const std::optional<Found>& found);

    std::vector<Source> sources_;
    std::optional<Found> found_;
};

} // namespace hygroloom
