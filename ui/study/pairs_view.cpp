// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/study/pairs_view.h"

#include "ui/compare/chart_style.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>

#include <cmath>

namespace hygroloom {

namespace {

constexpr double reach = 8; // pixels
constexpr std::size_t many_points = 5000;

} // namespace

PairsChart::PairsChart(QWidget* parent) : StudyChart(parent)
{
    setAccessibleName(tr("Two columns against each other"));
    setAccessibleDescription(tr("Left and Right choose the next row across."));
}

void PairsChart::setAxes(const StudyAxis* across, const StudyAxis* up, const StudyAxis* color)
{
    across_ = across;
    up_ = up;
    color_ = color;
    redraw();
}

QRectF PairsChart::area() const
{
    const double line = QFontMetricsF(font()).height();
    return QRectF(rect()).adjusted(72, line + 12, color_ ? -110 : -20, -2 * line - 12);
}

std::optional<QPointF> PairsChart::placeOf(std::size_t row) const
{
    if (!across_ || !up_ || row >= across_->numbers.size()) { return std::nullopt; }
    const double x = across_->placeOf(across_->numbers[row]), y = up_->placeOf(up_->numbers[row]);
    if (!std::isfinite(x) || !std::isfinite(y)) { return std::nullopt; }
    const QRectF on = area();
    return QPointF(on.left() + x * on.width(), on.bottom() - y * on.height());
}

std::optional<std::size_t> PairsChart::rowAt(const QPointF& position) const
{
    std::optional<std::size_t> nearest;
    double least = reach * reach;
    for (std::size_t row = 0; hasRows() && row < data_->table.rows(); ++row) {
        const std::optional<QPointF> at = isKept(row) ? placeOf(row) : std::nullopt;
        if (!at) { continue; }
        const QPointF off = *at - position;
        if (const double far = QPointF::dotProduct(off, off); far < least) {
            least = far;
            nearest = row;
        }
    }
    return nearest;
}

void PairsChart::drawPicture(QPainter& painter)
{
    if (!across_ || !up_) { return; }
    const QRectF on = area();
    const double line = QFontMetricsF(font()).height();
    drawAxes(painter, on, *across_, *up_, palette());
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(QRectF(on.left(), on.bottom() + line + 4, on.width(), line + 2), Qt::AlignCenter, across_->title);
    painter.drawText(QRectF(8, 4, on.right() - 8, line + 2), Qt::AlignLeft, up_->title);
    const bool many = data_->table.rows() > many_points;
    const double radius = many ? 1 : 4.5;
    painter.setRenderHint(QPainter::Antialiasing, !many);
    const QColor plain = strokeOf(0, palette()).color(), faint = gridColor(palette());
    for (const bool kept : {false, true}) { // what a brush keeps lies on top
        for (std::size_t row = 0; row < data_->table.rows(); ++row) {
            if (isKept(row) != kept) { continue; }
            const std::optional<QPointF> at = placeOf(row);
            if (!at) { continue; }
            const double number = color_ ? color_->numbers[row] : NAN;
            const QColor color = !kept ? faint : std::isfinite(number) ? studyColor(color_->placeOf(number), palette()) : plain;
            if (many) {
                painter.fillRect(QRectF(at->x() - radius, at->y() - radius, 2 * radius, 2 * radius), color);
                continue;
            }
            painter.setPen(kept ? QPen(palette().color(QPalette::Base), 0.7) : Qt::NoPen);
            painter.setBrush(color);
            painter.drawEllipse(*at, radius, radius);
        }
    }
    drawColors(painter);
}

void PairsChart::drawColors(QPainter& painter) const
{
    if (!color_) { return; }
    const double line = QFontMetricsF(font()).height();
    const QRectF bar(width() - 96, area().top(), 14, area().height());
    for (int y = 0; y < static_cast<int>(bar.height()); ++y) {
        painter.fillRect(QRectF(bar.left(), bar.bottom() - y - 1, bar.width(), 1.5), studyColor(y / bar.height(), palette()));
    }
    painter.setPen(palette().color(QPalette::Text));
    for (const double tick : color_->ticks(5)) {
        const double y = bar.bottom() - color_->placeOf(tick) * bar.height();
        painter.drawText(QRectF(bar.right() + 5, y - line / 2, 74, line), Qt::AlignLeft | Qt::AlignVCenter, color_->text(tick));
    }
}

void PairsChart::drawMarks(QPainter& painter)
{
    const std::optional<QPointF> at = chosen_ ? placeOf(*chosen_) : std::nullopt;
    if (!at) { return; }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(palette().color(QPalette::Base), 5));
    painter.drawEllipse(*at, 8, 8);
    painter.setPen(QPen(palette().color(QPalette::Text), 2));
    painter.drawEllipse(*at, 8, 8);
}

void PairsChart::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) { return; }
    if (const auto row = rowAt(event->position())) { Q_EMIT rowChosen(*row); }
}

/// The next row to the left or right.
void PairsChart::keyPressEvent(QKeyEvent* event)
{
    const bool right = event->key() == Qt::Key_Right;
    if (!hasRows() || !across_ || !(right || event->key() == Qt::Key_Left)) { return StudyChart::keyPressEvent(event); }
    const std::vector<double>& numbers = across_->numbers;
    const auto before = [&](std::size_t a, std::size_t b) { // rows with the same number follow each other
        return right ? std::pair(numbers[a], a) < std::pair(numbers[b], b) : std::pair(numbers[b], b) < std::pair(numbers[a], a);
    };
    std::optional<std::size_t> next;
    for (std::size_t row = 0; row < numbers.size(); ++row) {
        if (!isKept(row) || !placeOf(row) || (chosen_ && !before(*chosen_, row))) { continue; }
        if (!next || before(row, *next)) { next = row; }
    }
    if (next) { Q_EMIT rowChosen(*next); }
}

QString PairsChart::tipAt(const QPointF& position) const
{
    const auto row = rowAt(position);
    return row ? rowInWords(*data_, *row) : QString();
}

PairsView::PairsView(QWidget* parent)
    : QWidget(parent), across_(new QComboBox), up_(new QComboBox), color_(new QComboBox), chart_(new PairsChart)
{
    across_->setAccessibleName(tr("Column across"));
    up_->setAccessibleName(tr("Column upwards"));
    color_->setAccessibleName(tr("Column that colours"));
    auto* head = new QHBoxLayout;
    head->setContentsMargins(8, 6, 8, 0);
    for (const auto& [text, box] : {std::pair(tr("Across:"), across_), std::pair(tr("Upwards:"), up_), std::pair(tr("Colour:"), color_)}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(14);
        head->addWidget(new QLabel(text));
        head->addWidget(box, 1);
        connect(box, &QComboBox::currentIndexChanged, this, &PairsView::choose);
    }
    QLabel* note = makeNote(tr("What the pairs show"));
    note->setText(tr("Each point is a row. Click one to choose it; it can then become a candidate."));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(head);
    layout->addWidget(chart_, 1);
    layout->addWidget(note);
}

void PairsView::setStudy(const std::shared_ptr<const StudyData>& study)
{
    chart_->setAxes(nullptr, nullptr, nullptr);
    data_ = study;
    std::size_t factors = 0;
    for (std::size_t i = 0; study && i < study->axes.size(); ++i) { factors += study->axes[i].is_factor && !study->axes[i].empty; }
    fillAxes(*across_, study.get(), true, true, 0);
    fillAxes(*up_, study.get(), true, true, factors > 1 ? 1 : factors);
    fillAxes(*color_, study.get(), true, true, factors);
    chart_->setStudy(study);
    choose();
}

void PairsView::choose()
{
    chart_->setAxes(chosenAxis(*across_, data_.get()), chosenAxis(*up_, data_.get()), chosenAxis(*color_, data_.get()));
}

} // namespace hygroloom
