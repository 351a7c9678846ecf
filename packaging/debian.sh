#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# Builds the Debian packages hygroloom, hygroloom-cli, hygroloom-study, hygroloom-data and python3-hygroloom from the files that git knows: packaging/debian.sh [FOLDER]
# They come into FOLDER (build/debian), which is emptied first. Needs debhelper and lintian beside what packaging/dependencies.sh installs.
# DEB_BUILD_OPTIONS="cuda" builds for GPUs, too; JOBS=8 uses more than two cores.
set -eu
folder=${1:-$(dirname "$0")/../build/debian}

rm -rf "$folder"
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
cd "$(dirname "$0")/.."
source=$folder/hygroloom
mkdir "$source"
git ls-files -z | tar --create --null --files-from=- | tar --extract --directory "$source"
mv "$source/packaging/debian" "$source/debian"
HYGROLOOM_COMMIT=$(git describe --always --dirty)
export HYGROLOOM_COMMIT

cd "$source"
DEB_BUILD_OPTIONS="${DEB_BUILD_OPTIONS:-} parallel=${JOBS:-2}" dpkg-buildpackage -b -us -uc > "$folder/build.log" 2>&1 || {
  tail -30 "$folder/build.log" >&2
  exit 1
}
cd ..
rm -rf "$source"
for package in ./*.deb; do
  case $package in *-dbgsym_*) continue ;; esac
  dpkg-deb --fsys-tarfile "$package" | grep -qaF "$folder" && { echo "$package names the folder that it was built in." >&2; exit 1; }
  echo "$package"
done
lintian --allow-root --fail-on error,warning ./*.changes
