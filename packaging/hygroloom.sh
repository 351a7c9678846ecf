#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# Starts Hygroloom from the folder that it was unpacked into: ./hygroloom [project or recording]
here=$(dirname "$(readlink -f "$0")")
# The system's C++ library where it is new enough, else the one that came along.
if ! QT_QPA_PLATFORM=offscreen "$here/bin/hygroloom" --version >/dev/null 2>&1; then
  LD_LIBRARY_PATH="$here/lib/c++${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
  export LD_LIBRARY_PATH
fi
exec "$here/bin/hygroloom" "$@"
