#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# Installs with apt what building, testing and showing Hygroloom needs; of that with the argument "run" only what command line and window need.
# Does nothing when all of it is there.
set -eu

packages="
  cmake ninja-build ccache g++ git python3
  qt6-base-dev libqt6opengl6-dev qt6-svg-dev qt6-charts-dev qt6-tools-dev qt6-tools-dev-tools qt6-l10n-tools qt6-translations-l10n
  libgl-dev libegl-dev libgl1-mesa-dri fonts-dejavu-core
  libeigen3-dev libassimp-dev libtbb-dev nlohmann-json3-dev libcli11-dev libfmt-dev libsqlite3-dev libpng-dev zlib1g-dev libcsv-dev libcairo2-dev
  libboost-dev
"
if [ "${1:-all}" != run ]; then
  packages="$packages
  libopenturns-dev
  python3-dev pybind11-dev python3-numpy python3-xarray python3-pandas python3-pytest
  libbenchmark-dev clang-format-14
  xvfb xauth
  slurm-wlm munge
"
fi

if ! command -v dpkg-query >/dev/null 2>&1 || ! command -v apt-get >/dev/null 2>&1; then
  echo "This is no Debian or Ubuntu. Install what these packages hold, if it is not there yet:" $packages >&2
  exit 0
fi

missing=""
for package in $packages; do
  status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

as_root=""
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null 2>&1; then
    echo "Packages are missing, and installing them needs root. Ask whoever administers this machine to run:" >&2
    echo "  apt-get install --no-install-recommends$missing" >&2
    exit 1
  fi
  as_root="sudo"
fi
echo "Installing with apt:$missing"
$as_root apt-get update -qq
$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq -o Dpkg::Use-Pty=0 \
  --no-install-recommends $missing >/dev/null
