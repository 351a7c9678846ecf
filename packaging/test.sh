#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# Installs what is missing, builds everything, runs all tests on a virtual screen. Arguments go to ctest: packaging/test.sh -L fast
set -eu
cd "$(dirname "$0")/.."

packaging/dependencies.sh
packaging/build.sh
exec xvfb-run -a -s "-screen 0 1280x1024x24" ctest --preset release "$@"
