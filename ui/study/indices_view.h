// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Sensitivity indices as bars: what each factor makes alone, and with the others.
#pragma once

#include "ui/study/study_chart.h"

class QLabel;
class QPushButton;

namespace hygroloom {

class IndicesChart : public StudyChart {
    Q_OBJECT
public:
    explicit IndicesChart(QWidget* parent = nullptr);
    /// nullptr: none.
    void setIndices(const StudyIndices* indices);

protected:
    void drawPicture(QPainter& painter) override;

private:
    void drawBar(QPainter& painter, const QRectF& room, double value, double low, double high, int stroke) const;

    const StudyIndices* indices_ = nullptr;
};

class IndicesView : public QWidget {
    Q_OBJECT
public:
    explicit IndicesView(QWidget* parent = nullptr);
    void setStudy(const std::shared_ptr<const StudyData>& study);
    /// While they are computed; why they cannot be; empty: neither.
    void say(const QString& sentence, bool busy);
    QString note() const;

Q_SIGNALS:
    void computeRequested();

private:
    void choose();

    std::shared_ptr<const StudyData> data_;
    QComboBox* metric_;
    QPushButton* compute_;
    IndicesChart* chart_;
    QLabel* note_;
};

} // namespace hygroloom
