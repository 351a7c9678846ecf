#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# Measures speed against accuracy of the scenes in resources/tradeoff and of those that the expectation is tested with, and writes
# measured.csv beside them from all files in out/; the next build ships it. For a machine that does nothing else; the references take long.
# Arguments go to tradeoff: packaging/measure-tradeoff.sh --repeats 5
# SCENES=strip measures only scenes with that in their name, CLI=... another program, BACKEND=cuda a GPU.
set -eu
cd "$(dirname "$0")/.."
cli=${CLI:-build/release/bin/hygroloom-cli}
backend=${BACKEND:-cpu}
[ -x "$cli" ] || { echo "$cli is not there; build it with packaging/build.sh, or name it with CLI=." >&2; exit 1; }

# An experiment is named after what it is and the fabric that it is on.
measure() {
  folder=$1
  shift
  mkdir -p "out/$folder"
  grep -o '"name": "[^"]* on [^"]*"' "$folder/scenes.hygro" | cut -d '"' -f 4 | while IFS= read -r scene; do
    case $scene in *"${SCENES:-}"*) ;; *) continue ;; esac
    echo "$scene"
    "$cli" tradeoff "$folder/scenes.hygro" --fabric "${scene##* on }" --experiment "$scene" --backend "$backend" \
      -o "out/$folder/$scene, $backend.json" "$@" < /dev/null
  done
  "$cli" tradeoff --csv "out/$folder"/*.json > "out/$folder/measured.csv"
  cp "out/$folder/measured.csv" "$folder/measured.csv"
}
measure resources/tradeoff --convergence "$@"
measure tests/data/tradeoff --fidelities live,draft,standard "$@"
