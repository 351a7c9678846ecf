#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# Measures speed against accuracy of the scenes in resources/tradeoff and writes the results beside them, which the next build ships.
# For a machine that does nothing else; the references take long. Arguments go to tradeoff: packaging/measure-tradeoff.sh --repeats 5
# SCENES="droplet-on-cotton drying-of-wool" measures only those, CLI=... another program, BACKEND=cuda a GPU (written as NAME-cuda.json).
set -eu
cd "$(dirname "$0")/.."
cli=${CLI:-build/release/bin/hygroloom-cli}
backend=${BACKEND:-cpu}
suffix=""
[ "$backend" = cpu ] || suffix="-$backend"
[ -x "$cli" ] || { echo "$cli is not there; build it with packaging/build.sh, or name it with CLI=." >&2; exit 1; }

for project in resources/tradeoff/*.hygro; do
  scene=$(basename "$project" .hygro)
  case " ${SCENES:-$scene} " in *" $scene "*) ;; *) continue ;; esac
  echo "$scene"
  "$cli" tradeoff "$project" --backend "$backend" --convergence -o "out/tradeoff/$scene$suffix" "$@"
  cp "out/tradeoff/$scene$suffix/tradeoff.json" "resources/tradeoff/$scene$suffix.json"
done

# The scenes that the expectation is tested with, on the same machine.
for project in tests/data/tradeoff/*.hygro; do
  scene=$(basename "$project" .hygro)
  case " ${SCENES:-$scene} " in *" $scene "*) ;; *) continue ;; esac
  echo "$scene"
  "$cli" tradeoff "$project" --backend "$backend" --fidelities live,draft,standard --knobs none -o "out/tradeoff/$scene$suffix" "$@"
  cp "out/tradeoff/$scene$suffix/tradeoff.json" "tests/data/tradeoff/$scene$suffix.json"
done
