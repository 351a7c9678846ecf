#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# Installs what is missing, builds everything, runs the tests on a virtual screen but for those of label slow, which are whole runs: --all runs them
# too. Further arguments go to ctest: packaging/test.sh -L fast
set -eu
cd "$(dirname "$0")/.."

if [ "${1:-}" = --all ]; then
  shift
else
  set -- -LE slow "$@"
fi
packaging/dependencies.sh
packaging/build.sh
exec xvfb-run -a -s "-screen 0 1280x1024x24" ctest --preset release "$@"
