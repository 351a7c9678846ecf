// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a WIF file says, thread by thread, with gaps filled and oddities repaired. Between wif_file.h and the fabric.
#pragma once

#include "core/design/draft.h"
#include "core/project/wif_file.h"

namespace hygroloom {

struct WifThreads {
    std::vector<std::optional<Color>> colors; ///< one per thread
    std::optional<double> spacing_cm;         ///< mean
    std::optional<double> thickness_cm;
    bool spacing_default = false; ///< the number that drafting programs write by default
    bool thickness_default = false;
};

struct WifDraft {
    Draft draft; ///< all threads, up to most_imported_threads
    WifThreads warp, weft;
};

/// Throws FileError when the file holds no complete draft.
WifDraft read_wif_draft(const WifFile& file, const std::string& name, std::vector<ImportLine>& report);

} // namespace hygroloom
