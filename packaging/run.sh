#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# From a bare machine to a result: installs what command line and window need and builds these two, lets one drop fall on cotton, prints the
# metrics, draws the maps into out/, and opens the window on the result when there is a screen. Usage: packaging/run.sh [draft|standard|reference]
set -eu
cd "$(dirname "$0")/.."
fidelity=${1:-draft}

packaging/dependencies.sh run
packaging/build.sh --target hygroloom-cli --target hygroloom

mkdir -p out
cli=build/release/bin/hygroloom-cli
recording=out/one-drop-on-cotton.hygrorec
"$cli" simulate resources/examples/one-drop-on-cotton.hygro --fidelity "$fidelity" -o "$recording"
for side in top bottom; do
  for kind in png csv; do
    "$cli" measure "$recording" --quiet --map "$side" --cells 2 -o "out/one-drop-on-cotton-$side.$kind" >/dev/null
  done
done
echo "The recording and its maps are in $(pwd)/out."

if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
  exec build/release/bin/hygroloom "$recording"
fi
echo "There is no screen here; on one, open it with: build/release/bin/hygroloom $recording"
