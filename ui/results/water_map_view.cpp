// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/water_map_view.h"

#include "core/analysis/map_picture.h"
#include "core/base/error.h"
#include "core/base/units.h"
#include "core/run/recording.h"
#include "ui/basics/design_undo.h"
#include "ui/basics/preferences.h"
#include "ui/basics/quantity.h"
#include "ui/results/report_file.h"

#include <QAction>
#include <QBoxLayout>
#include <QComboBox>
#include <QLabel>
#include <QPainter>
#include <QResizeEvent>
#include <QSpinBox>
#include <QStandardItemModel>

#include <algorithm>

namespace hygroloom {

namespace {

constexpr int legend_width = 92;

} // namespace

WaterMapView::WaterMapView(Playback& playback, QWidget* parent)
    : QWidget(parent), playback_(playback), top_(new WaterMap(tr("Top"))), bottom_(new WaterMap(tr("Bottom"))), value_(new QLabel),
      empty_(new QLabel(tr("Run the experiment, or open a run that is kept, to see how the water spreads on both faces."))),
      quantity_(new QComboBox), cells_(new QSpinBox), legend_(new QWidget), maps_(new QBoxLayout(QBoxLayout::TopToBottom))
{
    quantity_->addItems({tr("Water"), tr("Temperature"), tr("Humidity")});
    quantity_->setAccessibleName(tr("What the maps and the picture show"));
    cells_->setRange(1, 50);
    cells_->setValue(2);
    new DesignUndo(cells_);
    cells_->setAccessibleName(tr("Map resolution, crossings per cell"));
    cells_->setToolTip("<p>" + tr("Each cell of the maps is the mean over N × N crossings.") + "</p>");
    value_->setAccessibleName(tr("Value under the pointer"));
    empty_->setWordWrap(true);
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setForegroundRole(QPalette::PlaceholderText);
    legend_->setFixedWidth(legend_width);
    legend_->setMinimumHeight(120);

    layOut();
    setMinimumWidth(280);
    connectParts();
    shareRanges(own_ranges_);
    offerQuantities();
    refresh();
}

void WaterMapView::shareRanges(ColorRanges& ranges)
{
    ranges_->disconnect(this);
    ranges_ = &ranges;
    connect(ranges_, &ColorRanges::changed, this, &WaterMapView::showRange);
    connect(ranges_, &ColorRanges::fitWanted, this, [this] {
        if (isVisible()) { startOver(); }
    });
}

void WaterMapView::layOut()
{
    maps_->setSpacing(4);
    maps_->addWidget(top_, 1);
    maps_->addWidget(bottom_, 1);
    auto* middle = new QHBoxLayout;
    middle->setSpacing(0);
    middle->addLayout(maps_, 1);
    middle->addWidget(legend_);
    auto* foot = new QHBoxLayout;
    foot->setContentsMargins(8, 0, 8, 4);
    foot->addStretch(1);
    auto* name = new QLabel(tr("Map resolution (crossings per cell)"));
    name->setBuddy(cells_);
    foot->addWidget(name);
    foot->addWidget(cells_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 6, 0, 0);
    layout->setSpacing(4);
    layout->addLayout(middle, 1);
    layout->addWidget(empty_);
    layout->addLayout(foot);
    auto* shown = new QHBoxLayout; // with room for the value, which moves nothing
    shown->setContentsMargins(8, 0, 8, 4);
    shown->addWidget(quantity_);
    shown->addWidget(value_, 1);
    layout->addLayout(shown);
}

void WaterMapView::connectParts()
{
    connect(cells_, &QSpinBox::valueChanged, this, &WaterMapView::startOver);
    for (WaterMap* map : {top_, bottom_}) { connect(map, &WaterMap::pointed, value_, &QLabel::setText); }
    connect(quantity_, &QComboBox::currentIndexChanged, this, [this] {
        value_->clear();
        startOver();
        Q_EMIT quantityChanged();
    });
    connect(&PreferenceNews::instance(), &PreferenceNews::changed, this, &WaterMapView::refresh);
    connect(&playback_, &Playback::runChanged, this, [this] {
        offerQuantities();
        startOver();
    });
    connect(&playback_, &Playback::ended, this, [this] {
        offerQuantities();
        scan();
    });
    connect(&playback_, &Playback::frameShown, this, &WaterMapView::refresh);
}

void WaterMapView::startOver()
{
    any_water_ = false;
    if (playback_.frame() && quantity() != ShownQuantity::water) {
        ranges_->widen(quantity(), range_of_values(*playback_.frame(), quantity()));
    }
    showRange();
    refresh();
    scan();
}

void WaterMapView::setCrossingsPerCell(int crossings) { cells_->setValue(crossings); }

ShownQuantity WaterMapView::quantity() const { return static_cast<ShownQuantity>(quantity_->currentIndex()); }

void WaterMapView::offerQuantities()
{
    auto* model = qobject_cast<QStandardItemModel*>(quantity_->model());
    for (const ShownQuantity each : {ShownQuantity::temperature, ShownQuantity::humidity}) {
        const int row = static_cast<int>(each);
        const QString why = playback_.run() ? QString::fromStdString(why_not_shown(playback_.run()->plan, each)) : QString();
        const bool warm = each == ShownQuantity::temperature;
        QStandardItem* item = model->item(row);
        item->setEnabled(why.isEmpty());
        item->setText(why.isEmpty() ? (warm ? tr("Temperature") : tr("Humidity"))
                                    : (warm ? tr("Temperature (not modelled)") : tr("Humidity (not modelled)")));
        item->setToolTip(!why.isEmpty() ? "<p>" + why.toHtmlEscaped() + "</p>"
                         : warm         ? QString()
                                        : "<p>" + tr("Relative humidity of the air in the yarns' pores.") + "</p>");
        if (!why.isEmpty() && quantity_->currentIndex() == row) { quantity_->setCurrentIndex(0); }
    }
}

void WaterMapView::setWaterColors(WaterColors colors)
{
    colors_ = colors;
    showRange();
    refresh();
}

void WaterMapView::offerSaving(QAction* top, QAction* bottom)
{
    top_->addAction(top);
    bottom_->addAction(bottom);
    for (WaterMap* map : {top_, bottom_}) { map->setContextMenuPolicy(Qt::ActionsContextMenu); }
}

void WaterMapView::save(MapSide side, const QString& file) const
{
    const auto run = playback_.run();
    const auto frame = playback_.frame(), first = playback_.firstFrame();
    if (!run || !frame || !first) { throw Error(tr("No run is shown whose map could be saved.").toStdString()); }
    const int cells = cells_->value();
    const bool water = quantity() == ShownQuantity::water;
    MapPicture picture = water ? map_picture(*run, *frame, start_of_maps(*run, *first), side, cells, unitsOfReader())
                               : quantity_picture(*run, *frame, quantity(), side, cells);
    picture.image.units = unitsOfReader();
    if (water) {
        picture.image.most = range();
    } else {
        picture.image.range = values();
    }
    const std::filesystem::path path = file.toStdString();
    if (file.endsWith(".csv", Qt::CaseInsensitive)) {
        write_cell_map_csv(picture.map, *run, frame->time, side, path);
    } else {
        write_picture(picture, path);
    }
}

void WaterMapView::refresh()
{
    empty_->setVisible(!playback_.frame());
    if (!playback_.frame() || !playback_.firstFrame() || !playback_.run()) {
        mapper_.drop();
        top_->clear();
        bottom_->clear();
        update();
        return;
    }
    mapper_.run([this, of = playback_.generation(), run = playback_.run(), frame = playback_.frame(), first = playback_.firstFrame(),
                 cells = cells_->value(), shown = quantity()](const NewestJob::Turn& turn) {
        const Frame start = start_of_maps(*run, *first);
        const FaceMap top = faceMap(*run, *frame, *first, MapSide::top, cells, shown);
        const FaceMap bottom = faceMap(*run, *frame, *first, MapSide::bottom, cells, shown);
        const Experiment* experiment = find_experiment(run->design, run->experiment);
        // Cloth that is wet at the start sets the scale, whatever time is shown first.
        double atStart = 0;
        if (shown == ShownQuantity::water && experiment && starts_wet(experiment->type)) {
            atStart = mostOnFaces(run->textile, *first, start, cells);
        }
        turn.deliver([this, of, cells, shown, atStart, top, bottom, values = range_of_values(*frame, shown)] {
            if (of != playback_.generation() || cells != cells_->value() || shown != quantity()) { return; }
            const double most = std::max({atStart, top.cells.maximum(), bottom.cells.maximum()});
            any_water_ = any_water_ || most > 0;
            ranges_->widen(shown, shown == ShownQuantity::water ? ValueRange{0, most} : values);
            top_->setMap(top.cells, top.stain, top.size);
            bottom_->setMap(bottom.cells, bottom.stain, bottom.size);
            update();
            Q_EMIT mapChanged();
        });
    });
}

void WaterMapView::scan()
{
    scanner_.drop();
    if (playback_.live() || !playback_.run() || !playback_.firstFrame()) { return; }
    scanner_.run([this, of = playback_.generation(), run = playback_.run(), first = playback_.firstFrame(),
                  path = playback_.path().toStdString(), cells = cells_->value(), shown = quantity()](const NewestJob::Turn& turn) {
        try {
            Recording recording(path);
            const Frame start = start_of_maps(*run, *first);
            double most = 0;
            std::optional<ValueRange> values;
            recording.read_frames([&](const Frame& frame) {
                const ValueRange range = range_of_values(frame, shown);
                values = values ? united(*values, range) : range;
                if (shown != ShownQuantity::water) { return !turn.outdated(); }
                most = std::max(most, mostOnFaces(run->textile, frame, start, cells));
                return !turn.outdated();
            });
            turn.deliver([this, of, cells, shown, most, values] {
                if (of != playback_.generation() || cells != cells_->value() || shown != quantity()) { return; }
                any_water_ = any_water_ || most > 0;
                if (shown == ShownQuantity::water) {
                    ranges_->widenWater(most);
                } else if (values) {
                    ranges_->widen(shown, *values);
                }
                update();
            });
        } catch (const Error&) {
            // The reader of the frames reports what is wrong with the recording.
        }
    });
}

void WaterMapView::showRange()
{
    const ValueRange ends = values();
    for (WaterMap* map : {top_, bottom_}) {
        if (quantity() == ShownQuantity::water) {
            map->setRange(range(), colors_);
        } else {
            map->setRange(ends.high, quantity() == ShownQuantity::temperature ? WaterColors::warmth : colors_, ends.low);
        }
    }
    if (quantity() != ShownQuantity::water) { Q_EMIT quantityChanged(); }
    update();
}

void WaterMapView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    maps_->setDirection(width() - legend_width > 1.3 * height() ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
}

void WaterMapView::paintEvent(QPaintEvent*)
{
    const bool water = quantity() == ShownQuantity::water;
    if (!playback_.frame() || top_->map().columns < 1 || !ranges_->of(quantity()) || (water && !any_water_)) {
        return; // no scale while all is dry
    }
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(palette().color(QPalette::WindowText));
    const QRectF room = legend_->geometry();
    const QRectF area(room.left() + 4, room.top(), room.width() - 8, std::min(240.0, room.height()));
    const ValueRange ends = values();
    const auto title = [this](const QString& name) { return legendTitle(name, *ranges_, quantity()); };
    switch (quantity()) {
    case ShownQuantity::water: return drawLegend(painter, area, title(tr("Water")), 1000 * range(), tr("g/m²"), colors_);
    case ShownQuantity::humidity: return drawLegend(painter, area, title(tr("Humidity")), 100 * ends.low, 100 * ends.high, "%", colors_);
    case ShownQuantity::temperature: {
        const UserUnit user = userUnit(QStringLiteral("°C"));
        drawLegend(painter, area, title(tr("Temperature")), user.of(celsius_from_kelvin(ends.low)), user.of(celsius_from_kelvin(ends.high)),
                   user.unit, WaterColors::warmth);
    }
    }
}

} // namespace hygroloom
