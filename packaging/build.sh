#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# Configures and builds the release preset, with two jobs at most. Further arguments go to the build: --target hygroloom-cli
set -eu
cd "$(dirname "$0")/.."

if [ -z "${CUDACXX:-}" ] && ! command -v nvcc >/dev/null 2>&1 && [ -x /usr/local/cuda/bin/nvcc ]; then
  PATH="$PATH:/usr/local/cuda/bin"
  export PATH
fi
# A build folder that came along from another place does not work here.
cache=build/release/CMakeCache.txt
if [ -f "$cache" ] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$(pwd -P)" "$cache"; then
  rm -rf build/release
fi

# Device code for one architecture takes a minute more than PTX, which a driver finishes where it first runs. Without a GPU that is enough.
architectures=
has_gpu() { [ -e /dev/nvidiactl ] || [ -e /dev/dxg ] || cat /sys/bus/pci/devices/*/vendor 2>/dev/null | grep -qx 0x10de; }
if [ -z "${CUDACXX:-}" ] && ! command -v nvcc >/dev/null 2>&1; then
  echo "There is no CUDA Toolkit (nvcc) here; Hygroloom is built for the CPU only."
elif [ ! -f "$cache" ] && ! has_gpu; then
  architectures=90-virtual
elif grep -qs '^HYGROLOOM_CUDA_ARCHITECTURES:STRING=90-virtual$' "$cache" && has_gpu; then
  architectures=90
fi

jobs=$(nproc 2>/dev/null || echo 1)
[ "$jobs" -le 2 ] || jobs=2
cmake --preset release --log-level=NOTICE ${architectures:+"-DHYGROLOOM_CUDA_ARCHITECTURES=$architectures"}
cmake --build --preset release --parallel "$jobs" "$@"
