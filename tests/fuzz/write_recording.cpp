// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Writes the files that fuzzing by bytes starts from: write_recording OF_A_SAMPLE [OF_A_GARMENT [OF_A_STUDY]]
#include "core/study/results.h"
#include "tests/support/crafted_wear.h"

using namespace hygroloom;

int main(int count, char** values)
{
    if (count < 2 || count > 4) return 2;
    write_small_recording(values[1]);
    if (count >= 3) write_small_wear_recording(values[2]);
    if (count < 4) return 0;
    using Role = StudyColumnRole;
    const StudyTable table{{{"point", Role::point, true, {0, 1}, {}, {}},
                            {"replicate", Role::replicate, true, {0, 0}, {}, {}},
                            {"radius_mm", Role::metric, true, {4.5, 6}, {}, {}},
                            {"status", Role::status, false, {}, {row_done, row_failed}, {0, 1}}}};
    write_results_database(table, "{}", "{}", values[3]);
}
