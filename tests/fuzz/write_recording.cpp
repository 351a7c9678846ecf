// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Writes the recordings that fuzzing by bytes starts from: write_recording OF_A_SAMPLE [OF_A_GARMENT]
#include "tests/support/crafted_wear.h"

int main(int count, char** values)
{
    if (count < 2 || count > 3) return 2;
    hygroloom::write_small_recording(values[1]);
    if (count == 3) hygroloom::write_small_wear_recording(values[2]);
}
