#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# Installs what is missing, builds everything, runs the tests on a virtual screen but for those of label slow, which are whole runs and what takes
# long: --all runs them too. Other arguments go to ctest as they are, which then chooses: packaging/test.sh -L slow
set -eu
cd "$(dirname "$0")/.."

if [ $# -eq 0 ]; then
  set -- -LE slow
elif [ "$1" = --all ]; then
  shift
fi
packaging/dependencies.sh
packaging/build.sh
exec xvfb-run -a -s "-screen 0 1280x1024x24" ctest --preset release --no-tests=error "$@"
