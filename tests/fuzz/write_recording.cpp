// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Writes the recording that fuzzing by bytes starts from.
#include "tests/support/crafted_recording.h"

int main(int count, char** values)
{
    if (count != 2) return 2;
    hygroloom::write_small_recording(values[1]);
}
