#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# Builds the Debian packages of what is committed twice, in two folders, in two time zones and without ccache, and compares them byte by byte:
# packaging/reproducible.sh [FOLDER]    Keeps both results there (build/reproducible).
set -eu
cd "$(dirname "$0")/.."
folder=${1:-build/reproducible}
export CCACHE_DISABLE=1

build() {
  rm -rf "$folder/$1"
  git clone -q --shared . "$folder/$1/clone"
  "$folder/$1/clone/packaging/debian.sh" "$folder/$1/packages" >/dev/null
}
build first
TZ=Pacific/Apia LC_ALL=C build second/deeper
different=0
for package in "$folder"/first/packages/*.deb; do
  name=$(basename "$package")
  if cmp -s "$package" "$folder/second/deeper/packages/$name"; then
    sha256sum "$package" | sed "s|  .*/|  |"
  else
    echo "$name differs." >&2
    different=1
  fi
done
exit "$different"
