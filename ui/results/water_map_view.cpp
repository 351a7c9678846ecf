// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/water_map_view.h"

#include "core/base/error.h"
#include "core/run/recording.h"
#include "ui/basics/design_undo.h"

#include <QBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QResizeEvent>
#include <QSpinBox>

#include <algorithm>

namespace hygroloom {

namespace {

constexpr int legend_width = 92;

} // namespace

WaterMapView::WaterMapView(Playback& playback, QWidget* parent)
    : QWidget(parent), playback_(playback), top_(new WaterMap(tr("Top"))), bottom_(new WaterMap(tr("Bottom"))), value_(new QLabel),
      empty_(new QLabel(tr("Run the experiment to see how the water spreads on both faces."))), cells_(new QSpinBox), legend_(new QWidget),
      maps_(new QBoxLayout(QBoxLayout::TopToBottom))
{
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

    maps_->setSpacing(4);
    maps_->addWidget(top_, 1);
    maps_->addWidget(bottom_, 1);
    auto* middle = new QHBoxLayout;
    middle->setSpacing(0);
    middle->addLayout(maps_, 1);
    middle->addWidget(legend_);
    auto* foot = new QHBoxLayout;
    foot->setContentsMargins(8, 0, 8, 4);
    foot->addWidget(value_, 1);
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
    setMinimumWidth(280);

    const auto startOver = [this] {
        maximum_ = 0;
        refresh();
        scan();
    };
    connect(cells_, &QSpinBox::valueChanged, this, startOver);
    for (WaterMap* map : {top_, bottom_}) { connect(map, &WaterMap::pointed, value_, &QLabel::setText); }
    connect(&playback_, &Playback::runChanged, this, startOver);
    connect(&playback_, &Playback::ended, this, &WaterMapView::scan);
    connect(&playback_, &Playback::frameShown, this, &WaterMapView::refresh);
    refresh();
}

void WaterMapView::setCrossingsPerCell(int crossings) { cells_->setValue(crossings); }

void WaterMapView::setWaterColors(WaterColors colors)
{
    colors_ = colors;
    refresh();
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
                 cells = cells_->value()](const NewestJob::Turn& turn) {
        const Frame start = start_of_maps(*run, *first);
        const FaceMap top = faceMap(*run, *frame, *first, MapSide::top, cells);
        const FaceMap bottom = faceMap(*run, *frame, *first, MapSide::bottom, cells);
        const Experiment* experiment = find_experiment(run->design, run->experiment);
        // Cloth that is wet at the start sets the scale, whatever time is shown first.
        double atStart = 0;
        if (experiment && starts_wet(experiment->type)) {
            for (MapSide side : {MapSide::top, MapSide::bottom}) {
                atStart = std::max(atStart, cell_map(run->textile, *first, start, side, cells).maximum());
            }
        }
        turn.deliver([this, of, cells, atStart, top, bottom] {
            if (of != playback_.generation() || cells != cells_->value()) { return; }
            widen(std::max({atStart, top.cells.maximum(), bottom.cells.maximum()}));
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
                  path = playback_.path().toStdString(), cells = cells_->value()](const NewestJob::Turn& turn) {
        try {
            Recording recording(path);
            const Frame start = start_of_maps(*run, *first);
            double most = 0;
            recording.read_frames([&](const Frame& frame) {
                for (MapSide side : {MapSide::top, MapSide::bottom}) {
                    most = std::max(most, cell_map(run->textile, frame, start, side, cells).maximum());
                }
                return !turn.outdated();
            });
            turn.deliver([this, of, cells, most] {
                if (of == playback_.generation() && cells == cells_->value()) { widen(most); }
            });
        } catch (const Error&) {
            // The reader of the frames reports what is wrong with the recording.
        }
    });
}

double WaterMapView::range() const { return roundedUp(maximum_); }

void WaterMapView::widen(double maximum)
{
    maximum_ = std::max(maximum_, maximum);
    top_->setRange(range(), colors_);
    bottom_->setRange(range(), colors_);
    update();
}

void WaterMapView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    maps_->setDirection(width() - legend_width > 1.3 * height() ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
}

void WaterMapView::paintEvent(QPaintEvent*)
{
    if (!playback_.frame() || top_->map().columns < 1 || !(maximum_ > 0)) {
        return; // no scale while all is dry
    }
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(palette().color(QPalette::WindowText));
    const QRectF room = legend_->geometry();
    drawLegend(painter, QRectF(room.left() + 4, room.top(), room.width() - 8, std::min(240.0, room.height())), tr("Water"), 1000 * range(),
               tr("g/m²"), colors_);
}

} // namespace hygroloom
