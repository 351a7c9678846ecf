// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/water_map.h"

#include "core/base/text.h"
#include "core/base/units.h"
#include "ui/basics/appearance.h"
#include "ui/basics/preferences.h"
#include "ui/basics/quantity.h"

#include <QLocale>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hygroloom {

namespace {

// The map is a picture of the fabric: pale in every palette, so that little water looks like little.
constexpr char dry_color[] = "#f5f1e8";
constexpr char ink_on_map[] = "#1d2327";

/// A temperature or a humidity with its unit.
QString airText(ShownQuantity quantity, double value)
{
    const bool warm = quantity == ShownQuantity::temperature;
    const UserUnit user = userUnit(warm ? QStringLiteral("°C") : QStringLiteral("%"));
    return shownNumber(user.of(warm ? celsius_from_kelvin(value) : 100 * value), 1) + QChar(0x00a0) + user.unit;
}

} // namespace

FaceMap faceMap(const RunRecord& run, const Frame& frame, const Frame& first, MapSide side, int crossings_per_cell, ShownQuantity quantity)
{
    FaceMap made;
    made.cells = quantity == ShownQuantity::water ? cell_map(run.textile, frame, start_of_maps(run, first), side, crossings_per_cell)
                                                  : quantity_map(run.textile, frame, quantity, side, crossings_per_cell);
    made.size = QSizeF(run.textile.ends() * run.textile.warp.pitch, run.textile.picks() * run.textile.weft.pitch);
    // Only a drop or a feed in the middle makes a stain.
    const Experiment* experiment = find_experiment(run.design, run.experiment);
    if (quantity == ShownQuantity::water && (!experiment || wets_a_spot(experiment->type))) {
        made.stain = wetted_circle(run.textile, frame, side == MapSide::top ? Face::top : Face::bottom);
    }
    return made;
}

double mostOnFaces(const Textile& textile, const Frame& frame, const Frame& start, int crossings_per_cell)
{
    return std::max(cell_map(textile, frame, start, MapSide::top, crossings_per_cell).maximum(),
                    cell_map(textile, frame, start, MapSide::bottom, crossings_per_cell).maximum());
}

WaterMap::WaterMap(const QString& title, QWidget* parent) : QWidget(parent), title_(title)
{
    setMouseTracking(true);
    setAccessibleName(title);
    connect(&PreferenceNews::instance(), &PreferenceNews::changed, this, qOverload<>(&QWidget::update));
}

void WaterMap::setMap(const CellMap& map, const std::optional<Circle>& circle, const QSizeF& size)
{
    updateRow();
    size_ = size;
    map_ = map;
    replicates_.reset();
    difference_ = false;
    stain_ = circle.has_value();
    circle_ = circle.value_or(Circle{0, 0, -1});
    render();
    if (map.quantity != ShownQuantity::water) {
        const auto [low, high] = std::minmax_element(map.water.begin(), map.water.end());
        setAccessibleDescription(map.quantity == ShownQuantity::temperature
                                     ? tr("Temperatures from %1 to %2.").arg(airText(map.quantity, *low), airText(map.quantity, *high))
                                     : tr("Humidities from %1 to %2.").arg(airText(map.quantity, *low), airText(map.quantity, *high)));
        update();
        return;
    }
    const QString most = tr("Most water %1 grams per square metre").arg(shownNumber(1000 * map.maximum(), 0));
    setAccessibleDescription(
        !stain_ ? most + "."
                : tr("%1; wetted radius now %2.").arg(most, hygroloom::valueText(std::max(0.0, mm_from_metre(circle_.radius)), "mm")));
    update();
}

void WaterMap::setReplicates(const std::optional<MapRange>& replicates) { replicates_ = replicates; }

void WaterMap::setDifference(const MapDifference& difference, const QSizeF& size)
{
    updateRow();
    size_ = size;
    map_ = difference.cells;
    real_ = difference.real;
    difference_ = true;
    stain_ = false;
    circle_ = Circle{0, 0, -1};
    render();
    const auto cells = std::count(real_.begin(), real_.end(), true);
    setAccessibleDescription(tr("Largest difference to the baseline %1 grams per square metre; %2 of %3 cells differ.")
                                 .arg(shownNumber(1000 * largestOf(difference), 1))
                                 .arg(cells)
                                 .arg(real_.size()));
    update();
}

void WaterMap::clear()
{
    map_ = {};
    circle_ = {};
    image_ = {};
    cell_ = {-1, -1};
    update();
}

void WaterMap::setOutdated(bool outdated)
{
    if (outdated_ == outdated) { return; }
    outdated_ = outdated;
    update();
}

void WaterMap::setRange(double maximum, WaterColors colors, double minimum)
{
    if (maximum != maximum_ || minimum != minimum_ || colors != colors_) {
        minimum_ = minimum;
        maximum_ = maximum;
        colors_ = colors;
        render();
        update();
    }
}

void WaterMap::render()
{
    if (map_.columns < 1) { return; }
    image_ = QImage(map_.columns, map_.rows, QImage::Format_RGB32);
    for (int row = 0; row < map_.rows; ++row) {
        for (int column = 0; column < map_.columns; ++column) { image_.setPixelColor(column, map_.rows - 1 - row, colorOf(column, row)); }
    }
}

QColor WaterMap::colorOf(int column, int row) const
{
    const double share = (map_.at(column, row) - minimum_) / (maximum_ - minimum_);
    if (map_.quantity != ShownQuantity::water) { return waterColor(share, colors_); }
    if (!difference_) { return share > 0.004 ? waterColor(share, colors_) : QColor(dry_color); }
    return real_[static_cast<std::size_t>(row) * map_.columns + column] ? differenceColor(share) : noDifferenceColor();
}

QString replicateRange(int runs)
{
    return (runs >= fewest_for_percentiles ? WaterMap::tr("5th to 95th percentile of %1 replicates")
                                           : WaterMap::tr("least to most of %1 replicates"))
        .arg(runs);
}

QString WaterMap::valueText(int column, int row) const
{
    if (map_.quantity != ShownQuantity::water) { return airText(map_.quantity, map_.at(column, row)); }
    const double value = 1000 * map_.at(column, row);
    if (!difference_) {
        const QString text = tr("%1 g/m²").arg(shownNumber(value, 1));
        if (!replicates_) { return text; }
        const CellMap& low = replicates_->low; // its cells may be larger
        const int x = std::min(low.columns - 1, static_cast<int>((column + 0.5) * map_.cell_width / low.cell_width));
        const int y = std::min(low.rows - 1, static_cast<int>((row + 0.5) * map_.cell_height / low.cell_height));
        return tr("%1 (%2, in cells of %5 mm: %3 to %4)")
            .arg(text, replicateRange(replicates_->runs), shownNumber(1000 * low.at(x, y), 1),
                 shownNumber(1000 * replicates_->high.at(x, y), 1), shownNumber(1000 * low.cell_width, 1));
    }
    const bool real = real_[static_cast<std::size_t>(row) * map_.columns + column];
    const QString text = value < 0 ? tr("%1 g/m² less than the baseline") : tr("%1 g/m² more than the baseline");
    return text.arg(shownNumber(std::abs(value), 1)) + (real ? QString() : tr(", not shown to differ"));
}

QRectF WaterMap::roomOfMap() const
{
    const double line = fontMetrics().height() + 4;
    return {8, line, width() - 16.0, height() - line - 6};
}

std::optional<double> WaterMap::ownScale() const
{
    const double w = size_.width(), h = size_.height();
    if (isHidden() || !(w > 0 && h > 0)) { return std::nullopt; }
    const QRectF room = roomOfMap();
    return std::min(room.width() / w, room.height() / h);
}

double WaterMap::pixelsPerMetre() const
{
    double least = std::numeric_limits<double>::infinity();
    for (const WaterMap* map : row_) { least = std::min(least, map->ownScale().value_or(least)); }
    return least;
}

double WaterMap::roomOfBar() const
{
    double narrowest = std::numeric_limits<double>::infinity();
    for (const WaterMap* map : row_) {
        if (map->ownScale()) { narrowest = std::min(narrowest, map->size_.width()); }
    }
    return narrowest * pixelsPerMetre();
}

QRectF WaterMap::mapArea() const
{
    const QRectF room = roomOfMap();
    const double scale = pixelsPerMetre();
    if (!ownScale()) { return room; }
    const QSizeF size = scale * size_;
    return {room.center().x() - 0.5 * size.width(), room.top(), size.width(), size.height()};
}

/// What this shows may change the scale of all.
void WaterMap::updateRow()
{
    for (WaterMap* map : row_) { map->update(); }
}

QString WaterMap::radiusText(double room) const
{
    if (!stain_) { return {}; }
    if (!(circle_.radius > 0)) { return tr("dry"); }
    const double mm = mm_from_metre(circle_.radius);
    const QString radius = hygroloom::valueText(mm, "mm");
    const QString text = tr("wetted radius now %1").arg(radius);
    return fontMetrics().horizontalAdvance(text) + 12 <= room ? text : radius;
}

void WaterMap::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor ink = palette().color(QPalette::WindowText);
    const QRectF area = mapArea();
    painter.setPen(ink);
    QFont bold = font();
    bold.setBold(true);
    painter.setFont(bold);
    // A long name leaves room for the number beside it.
    const QFontMetricsF metrics(bold);
    const double number = image_.isNull() ? 0 : QFontMetricsF(font()).horizontalAdvance(radiusText(0)) + 12;
    const QString name = metrics.elidedText(title_, Qt::ElideRight, width() - 16 - number);
    const double title = metrics.horizontalAdvance(name);
    const QString radius = image_.isNull() ? QString() : radiusText(width() - 16 - title);
    const bool fits = title + 12 + fontMetrics().horizontalAdvance(radius) <= area.width();
    const QRectF head = fits ? QRectF(area.left(), 0, area.width(), area.top() - 2) : QRectF(8, 0, width() - 16, area.top() - 2);
    painter.drawText(head, Qt::AlignLeft | Qt::AlignVCenter, name);
    painter.setFont(font());
    if (image_.isNull()) {
        QColor line = ink;
        line.setAlphaF(0.25F);
        painter.setPen(QPen(line, 1, Qt::DashLine));
        painter.drawRect(area.adjusted(0.5, 0.5, -0.5, -0.5));
        return;
    }
    painter.drawText(head, Qt::AlignRight | Qt::AlignVCenter, radius);
    painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
    const double pixelsPerMetre = area.width() / size_.width();
    const QSizeF cells(map_.columns * map_.cell_width * pixelsPerMetre, map_.rows * map_.cell_height * pixelsPerMetre);
    painter.setClipRect(area);
    painter.drawImage(QRectF(QPointF(area.left(), area.bottom() - cells.height()), cells), image_);
    if (outdated_) {
        QColor paper = palette().color(QPalette::Window), line = ink;
        paper.setAlphaF(0.45F);
        line.setAlphaF(0.5F);
        painter.fillRect(area, paper);
        painter.fillRect(area, QBrush(line, Qt::BDiagPattern));
    }
    painter.setClipping(false);
    if (circle_.radius > 0) {
        const QPointF centre(area.center().x() + circle_.x * pixelsPerMetre, area.center().y() - circle_.y * pixelsPerMetre);
        painter.setClipRect(area);
        painter.setPen(QPen(QColor(255, 255, 255, 190), 3));
        painter.drawEllipse(centre, circle_.radius * pixelsPerMetre, circle_.radius * pixelsPerMetre);
        painter.setPen(QPen(QColor("#c2410c"), 1.5, Qt::DashLine));
        painter.drawEllipse(centre, circle_.radius * pixelsPerMetre, circle_.radius * pixelsPerMetre);
        painter.setClipping(false);
    }
    drawScaleBar(painter, area.bottomLeft() + QPointF(8, -8), 1000 / pixelsPerMetre, roomOfBar(), QColor(ink_on_map),
                 QColor(255, 255, 255, 170));
    if (cell_.x() >= 0) {
        const QSizeF cell(map_.cell_width * pixelsPerMetre, map_.cell_height * pixelsPerMetre);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1.5));
        painter.setClipRect(area);
        painter.drawRect(QRectF(QPointF(area.left() + cell_.x() * cell.width(), area.bottom() - (cell_.y() + 1) * cell.height()), cell));
    }
}

QPoint WaterMap::cellAt(const QPointF& at) const
{
    const QRectF area = mapArea();
    if (image_.isNull() || !area.contains(at)) { return {-1, -1}; }
    const double metre = size_.width() / area.width();
    return {std::min(map_.columns - 1, static_cast<int>((at.x() - area.left()) * metre / map_.cell_width)),
            std::min(map_.rows - 1, static_cast<int>((area.bottom() - at.y()) * metre / map_.cell_height))};
}

QString WaterMap::wordsAt(const QPointF& at) const
{
    const QPoint cell = cellAt(at);
    if (cell.x() < 0) { return {}; }
    const double x = (cell.x() + 0.5) * map_.cell_width - 0.5 * size_.width();
    const double y = (cell.y() + 0.5) * map_.cell_height - 0.5 * size_.height();
    const UserUnit user = userUnit(QStringLiteral("mm"));
    const auto place = [decimals = user.per_one == 1     ? 1
                                   : user.per_one < 0.05 ? 3
                                                         : 2,
                        &user](double metre) { return QLocale().toString(user.of(mm_from_metre(metre)), 'f', decimals); };
    return tr("%1: %2 at %3, %4 %5").arg(title_, valueText(cell.x(), cell.y()), place(x), place(y), user.unit);
}

void WaterMap::mouseMoveEvent(QMouseEvent* event)
{
    const QPoint cell = cellAt(event->position());
    if (cell != cell_) {
        cell_ = cell;
        update();
    }
    Q_EMIT pointed(wordsAt(event->position()));
}

void WaterMap::leaveEvent(QEvent*)
{
    cell_ = {-1, -1};
    update();
    Q_EMIT pointed({});
}

} // namespace hygroloom
