// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What wearing a garment came to, on one page that needs nothing else: numbers, maps, curves, where the water is, what went in.
#pragma once

#include "core/analysis/page.h"
#include "core/wear/wear_map.h"
#include "core/wear/wear_metrics.h"

namespace hygroloom {

/// Which of a run's frames, at these times (s), a report shows: at a quarter, half, three quarters and the end; or those nearest to the
/// times that are wanted. Each once, in order.
std::vector<int> frames_for_report(const std::vector<double>& frames, const std::vector<double>& wanted);

/// Every panel in each of the frames, on one scale.
std::vector<ReportPicture> pictures_of_panels(const WearLayout& layout, const std::vector<std::shared_ptr<const WearFrame>>& frames,
                                              const WearMapOptions& options);
/// The same of a recording's frames. Throws FileError.
std::vector<ReportPicture> pictures_of_panels(const WearRecording& recording, const std::vector<int>& frames,
                                              const WearMapOptions& options);

/// A garment as it is at the end of a run. Precondition: the layout outlives it.
struct GarmentAtEnd {
    std::string name;
    const WearLayout* layout;
    std::shared_ptr<const WearFrame> frame;
};
/// Every panel of all of them on one scale, whose end is put into `how`.
std::vector<ReportPicture> pictures_on_one_scale(const std::vector<GarmentAtEnd>& garments, WearMapOptions& how);

/// finished: the run came to its end. units: of the inputs.
ReportPage wear_report(const WearRecord& record, const WearMetrics& metrics, const std::vector<ReportPicture>& pictures, bool finished,
                       const ReaderUnits& units = {});

} // namespace hygroloom
