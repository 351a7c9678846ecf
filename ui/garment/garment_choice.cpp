// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/garment/garment_choice.h"

#include "core/base/error.h"

#include <algorithm>

namespace hygroloom {

GarmentChoice::GarmentChoice(Document& document, QObject* parent) : QObject(parent), document_(document)
{
    connect(&document_, &Document::designChanged, this, &GarmentChoice::refresh);
    connect(&document_, &Document::pathChanged, this, &GarmentChoice::refresh);
    refresh();
}

const Garment* GarmentChoice::garment() const
{
    const auto& garments = document_.design()->garments;
    return garment_ >= 0 && garment_ < static_cast<int>(garments.size()) ? &garments[static_cast<std::size_t>(garment_)] : nullptr;
}

const WearExperiment* GarmentChoice::wear() const
{
    const auto& wears = document_.design()->wears;
    return wear_ >= 0 && wear_ < static_cast<int>(wears.size()) ? &wears[static_cast<std::size_t>(wear_)] : nullptr;
}

std::vector<int> GarmentChoice::wearsOfGarment() const
{
    std::vector<int> found;
    const auto& wears = document_.design()->wears;
    for (std::size_t k = 0; garment() && k < wears.size(); ++k) {
        if (wears[k].garment == garment()->name) { found.push_back(static_cast<int>(k)); }
    }
    return found;
}

void GarmentChoice::setGarmentIndex(int index)
{
    if (index != garment_) {
        garment_ = index;
        refresh();
    }
    Q_EMIT garmentChosen();
}

void GarmentChoice::setWearIndex(int index)
{
    if (index == wear_) { return; }
    wear_ = index;
    Q_EMIT changed();
}

std::filesystem::path GarmentChoice::base() const { return document_.folder().toStdString(); }

void GarmentChoice::refresh()
{
    garment_ = std::clamp(garment_, 0, std::max(0, static_cast<int>(document_.design()->garments.size()) - 1));
    const std::vector<int> wears = wearsOfGarment();
    if (std::find(wears.begin(), wears.end(), wear_) == wears.end()) { wear_ = wears.empty() ? -1 : wears.front(); }
    read();
    Q_EMIT changed();
}

void GarmentChoice::read()
{
    const Garment* chosen = garment();
    if (!chosen) {
        reader_.drop();
        source_.reset();
        drawing_.reset();
        problem_.clear();
        reading_ = false;
        Q_EMIT drawingChanged();
        return;
    }
    const Source source{chosen->source, chosen->built_in, chosen->uv_unit, base()};
    if (source_ == source) { return; }
    source_ = source;
    reading_ = true;
    problem_.clear();
    reader_.run([this, source, garment = *chosen](const NewestJob::Turn& turn) {
        std::shared_ptr<const GarmentDrawing> drawing;
        QString problem;
        try {
            drawing = drawingOf(read_pattern(garment, source.base, [&turn] { return turn.outdated(); }));
        } catch (const Cancelled&) {
            return;
        } catch (const std::exception& error) {
            problem = QString::fromUtf8(error.what());
        }
        turn.deliver([this, source, drawing, problem] {
            if (source_ != source) { return; } // another has been asked for
            drawing_ = drawing;
            problem_ = problem;
            reading_ = false;
            Q_EMIT drawingChanged();
        });
    });
}

} // namespace hygroloom
