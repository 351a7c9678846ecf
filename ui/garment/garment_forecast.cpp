// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/garment/garment_forecast.h"

#include "core/base/error.h"
#include "ui/basics/quantity.h"
#include "ui/basics/words.h"
#include "ui/garment/worn_run.h"
#include "ui/results/plan_dialog.h"

namespace hygroloom {

RunForecast garmentForecast(const Design& design, const std::string& wear, const std::filesystem::path& base, Fidelity fidelity,
                            const std::string& machine, const NewestJob::Turn& turn)
{
    RunForecast forecast;
    try {
        const GarmentParts parts = garment_parts(design, *find_wear(design, wear), base, [&turn] { return turn.outdated(); });
        RunOptions options;
        options.fidelity = fidelity;
        if (turn.outdated()) { return forecast; }
        const GarmentScene scene = garment_scene(parts, resolution_of(options));
        const WearPlan plan = plan_wear(scene, *parts.wear, fidelity, machine);
        const QString seconds = roughDuration(plan.time.seconds), bytes = bytesText(plan.bytes);
        forecast.text = tr("%1, %2").arg(seconds, bytes);
        const QString form = plan.time.learned.empty() ? tr("%1 %2, %3; %4 on two cores.") : tr("%1 %2, %3; %4 on this machine.");
        forecast.about = form.arg(plan.cells).arg(cellsText(wear_layout(parts, scene).cells_in_words), bytes, seconds);
        forecast.tip = "<p>" + forecast.about.toHtmlEscaped() + "</p>";
    } catch (const Cancelled&) { // another is asked for
    } catch (const NotEnoughMemory& error) {
        forecast.about = tr("This run takes about %1 of memory; %2 are free.").arg(bytesText(error.needed), bytesText(error.available));
    } catch (const std::exception& error) {
        forecast.about = QString::fromUtf8(error.what());
    }
    return forecast;
}

} // namespace hygroloom
