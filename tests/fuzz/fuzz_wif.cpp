// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Any bytes, as a WIF draft, a grid and a picture, either are refused with a FileError, or become a fabric that a project keeps and
// whose exported draft gives the same weave again.
#include "core/base/error.h"
#include "core/design/drawdown.h"
#include "core/project/draft_import.h"
#include "core/project/project_file.h"
#include "tests/fuzz/require.h"

using namespace hygroloom;

namespace {

void keep(const DraftImport& draft)
{
    require(!draft.report.empty(), "an import reports what it did");
    Design design;
    design.fabrics.push_back(draft.fabric);
    if (const auto& plan = draft.fabric.weave.draft()) {
        require(fault_in(*plan).empty(), "the draft is sound");
        require(drawdown(*plan).same_matrix(draft.fabric.weave), "the draft draws the weave");
    }
    require(parse_project(format_project(design), "written") == design, "a project keeps the fabric");
    if (has_error(validate(design))) return;
    const DraftImport again = import_wif(format_wif(design, draft.fabric), "written.wif");
    require(again.fabric.weave.same_matrix(draft.fabric.weave), "an exported weave comes back");
    require(again.fabric.warp_order == draft.fabric.warp_order && again.fabric.weft_order == draft.fabric.weft_order, "orders come back");
    require(again.fabric.extra_yarns == draft.fabric.extra_yarns, "yarns come back");
}

template <typename Import> void try_import(Import import)
{
    try {
        keep(import());
    } catch (const FileError&) {
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    if (bytes.starts_with("\x89PNG") || bytes.starts_with("BM"))
        try_import([&] { return import_picture(bytes, "input.png"); });
    else if (bytes.find('[') != std::string_view::npos)
        try_import([&] { return import_wif(bytes, "input.wif"); });
    else
        try_import([&] { return import_grid(bytes, "input.txt"); });
    return 0;
}
