#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# Makes the pictures of the user's guide anew, from the program itself: packaging/make-pictures.sh BUILD_FOLDER
# Needs xvfb-run and some minutes. Each picture must stay under 200 kB.
set -e
cd "$(dirname "$0")/.."
build=${1:?usage: packaging/make-pictures.sh BUILD_FOLDER}
ninja -C "$build" make_pictures
xvfb-run -a -s "-screen 0 1400x900x24" "$build/bin/make_pictures" resources/help
large=$(find resources/help -name '*.png' -size +200k)
[ -z "$large" ] || { echo "larger than 200 kB: $large"; exit 1; }
