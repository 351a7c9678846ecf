// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Any bytes either are refused with a FileError, or are a project that is written and read back as the same one.
// Whatever validate() lets pass must have finite derived quantities.
#include "core/base/error.h"
#include "core/design/fitted_fabric.h"
#include "core/project/project_file.h"
#include "tests/fuzz/require.h"

#include <cmath>

using namespace hygroloom;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    Design design;
    try {
        design = parse_project({reinterpret_cast<const char*>(data), size}, "input");
    } catch (const FileError&) {
        return 0;
    }
    const std::string text = format_project(design);
    const Design again = parse_project(text, "written");
    require(again == design, "a project reads back as it was written");
    require(format_project(again) == text, "a project is written the same way twice");

    if (has_error(validate(design))) return 0;
    for (const Fabric& fabric : design.fabrics) {
        const FabricQuantities q = derive_quantities(design, fabric);
        require(std::isfinite(q.areal_density_g_m2) && q.areal_density_g_m2 > 0, "areal density");
        require(q.porosity > 0 && q.porosity < 1, "porosity");
        require(q.warp.section_mm.width > 0 && q.weft.section_mm.height > 0, "sections");
        require(std::isfinite(q.inter_yarn_pore_radius_um) && q.inter_yarn_pore_radius_um > 0, "pores");
        require(q.warp.packing_factor_in_fabric <= 0.86 && q.weft.packing_factor_in_fabric <= 0.86, "packing");
        require(q.warp.crimp_percent >= -1e-9 && std::isfinite(q.weft.crimp_percent), "crimp");
    }
    return 0;
}
