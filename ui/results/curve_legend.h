// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Names of a plot's curves, each behind a piece of its line long enough to show its dashes.
#pragma once

#include <QPen>
#include <QWidget>

#include <vector>

namespace hygroloom {

class CurveLegend : public QWidget {
    Q_OBJECT
public:
    struct Entry {
        QString name;
        QPen pen;
        bool operator==(const Entry&) const = default;
    };

    explicit CurveLegend(QWidget* parent = nullptr);

    void setEntries(const std::vector<Entry>& entries);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    std::vector<Entry> entries_;
};

} // namespace hygroloom
