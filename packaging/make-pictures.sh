#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# Takes pictures anew, from the program itself: packaging/make-pictures.sh BUILD_FOLDER [guide|views]
# guide: those of the user's guide, in some minutes; each must stay under 200 kB. views: those that tst_pictures compares with. Needs xvfb-run.
set -e
cd "$(dirname "$0")/.."
build=${1:?usage: packaging/make-pictures.sh BUILD_FOLDER [guide|views]}
which=${2:-all}
if [ "$which" != views ]; then
  ninja -C "$build" make_pictures
  xvfb-run -a -s "-screen 0 1400x900x24" "$build/bin/make_pictures" resources/help
  large=$(find resources/help -name '*.png' -size +200k)
  [ -z "$large" ] || { echo "larger than 200 kB: $large"; exit 1; }
fi
if [ "$which" != guide ]; then
  ninja -C "$build" tests_ui
  for scale in 1 2; do
    HYGROLOOM_TAKE_PICTURES=1 QT_SCALE_FACTOR=$scale LP_NUM_THREADS=0 xvfb-run -a -s "-screen 0 2700x1700x24" "$build/bin/tests/tests_ui" tst_pictures
  done
fi
