// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/garment/garment_drawing.h"

#include "core/base/units.h"
#include "core/garment/outline.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace hygroloom {

namespace {

constexpr double gap = 0.03;       // m, between panels on the sheet
constexpr double wide_sheet = 1.6; // its width over its height, about

/// Rows of panels, the tallest first, as wide together as the sheet.
void layOut(GarmentDrawing& drawing)
{
    std::vector<FlatBox> boxes;
    double area = 0, widest = 0;
    for (const DrawnPanel& panel : drawing.panels) {
        WearPanel measured;
        measured.outline = panel.outline;
        boxes.push_back(measured.box());
        area += (boxes.back().width() + gap) * (boxes.back().height() + gap);
        widest = std::max(widest, boxes.back().width());
    }
    std::vector<std::size_t> order(boxes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return boxes[a].height() > boxes[b].height() + 0.02; });
    const double width = std::max(widest, std::sqrt(wide_sheet * area)) + gap;
    double x = 0, top = 0, row = 0;
    for (const std::size_t k : order) {
        if (x > 0 && x + boxes[k].width() > width) {
            top -= row + gap;
            x = row = 0;
        }
        DrawnPanel& panel = drawing.panels[k];
        panel.on_sheet = {x - boxes[k].left, top - boxes[k].high};
        x += boxes[k].width() + gap;
        row = std::max(row, boxes[k].height());
    }
    for (DrawnPanel& panel : drawing.panels) {
        for (std::size_t i = 0; i < panel.outline.size(); ++i) {
            const QPointF at(panel.outline[i][0] + panel.on_sheet[0], panel.outline[i][1] + panel.on_sheet[1]);
            i == 0 ? panel.path.moveTo(at) : panel.path.lineTo(at);
        }
        panel.path.closeSubpath();
        drawing.sheet = drawing.sheet.united(panel.path.boundingRect());
    }
}

} // namespace

int GarmentDrawing::panelAt(const QPointF& sheet_place) const
{
    for (std::size_t k = 0; k < panels.size(); ++k) {
        if (panels[k].path.contains(sheet_place)) { return static_cast<int>(k); }
    }
    return -1;
}

std::shared_ptr<const GarmentDrawing> drawingOf(const GarmentPattern& pattern)
{
    auto drawing = std::make_shared<GarmentDrawing>();
    for (const PatternPanel& panel : pattern.panels) { drawing->panels.push_back({panel.name, outline_of(panel), {}, {}}); }
    std::set<std::array<int, 2>> sewn;
    for (const PatternSeam& seam : pattern.seams) {
        sewn.insert({std::min(seam.panel_a, seam.panel_b), std::max(seam.panel_a, seam.panel_b)});
    }
    drawing->sewn.assign(sewn.begin(), sewn.end());
    drawing->shape = pattern.shape;
    drawing->is_draped = pattern.is_draped;
    drawing->issues = pattern.issues;
    layOut(*drawing);
    return drawing;
}

std::shared_ptr<const GarmentDrawing> drawingOf(const WearLayout& layout)
{
    auto drawing = std::make_shared<GarmentDrawing>();
    for (const WearPanel& panel : layout.panels) { drawing->panels.push_back({panel.name, panel.outline, {}, {}}); }
    drawing->shape = layout.shape;
    layOut(*drawing);
    return drawing;
}

QColor fabricColor(int index)
{
    // Lightened from Okabe and Ito's eight, of which blue is left to water.
    static const QColor colors[] = {"#f3d9a4", "#b9dfcf", "#e9c3d6", "#efe7a0", "#d9c5b2", "#c9d3a8", "#f0bfa6", "#cfcfd6"};
    return colors[static_cast<std::size_t>(std::max(0, index)) % std::size(colors)];
}

QString clothsOf(const PanelCut& cut)
{
    const QString fabric = QString::fromStdString(cut.fabric);
    if (cut.layers < 2) { return fabric; }
    if (cut.lining.empty()) { return QStringLiteral("%1 × %2").arg(cut.layers).arg(fabric); }
    const QString lining = QString::fromStdString(cut.lining);
    return cut.layers == 2 ? fabric + " + " + lining : QStringLiteral("%1 + %2 × %3").arg(fabric).arg(cut.layers - 1).arg(lining);
}

GarmentPaint fabricPaint(const Design& design, const Garment& garment, const GarmentDrawing& drawing)
{
    GarmentPaint paint;
    for (const DrawnPanel& panel : drawing.panels) {
        PanelFill fill;
        PanelLabel label{QString::fromStdString(panel.name), {}, 0};
        if (const PanelCut* cut = garment.cut_of(panel.name)) {
            label.fabric = clothsOf(*cut);
            label.grain = radian_from_degree(cut->grain_deg);
            const auto found = std::find_if(design.fabrics.begin(), design.fabrics.end(),
                                            [&](const Fabric& fabric) { return fabric.name == cut->fabric; });
            if (found != design.fabrics.end()) {
                const QRectF box = panel.path.boundingRect();
                fill.image = QImage(1, 1, QImage::Format_RGB32);
                fill.image.fill(fabricColor(static_cast<int>(found - design.fabrics.begin())));
                const QPointF middle = box.center() - QPointF(panel.on_sheet[0], panel.on_sheet[1]);
                fill.origin = {middle.x(), middle.y()};
                fill.across = {1.1 * box.width(), 0};
                fill.along = {0, 1.1 * box.height()};
            }
        }
        paint.fills.push_back(std::move(fill));
        paint.labels.push_back(std::move(label));
    }
    return paint;
}

} // namespace hygroloom
