#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# Installs the Debian packages in a bare Debian, runs both programs, removes the packages and looks whether anything stays:
# packaging/try-package.sh [FOLDER_OF_PACKAGES]    Needs root, debootstrap and a Debian mirror (MIRROR=...). ROOT=... keeps the Debian for next time.
set -eu
cd "$(dirname "$0")/.."
folder=${1:-build/debian}
suite=${SUITE:-bookworm}
[ "$(id -u)" -eq 0 ] || { echo "A chroot needs root: sudo $0 $*" >&2; exit 1; }
ls "$folder"/*.deb >/dev/null

root=${ROOT:-$(mktemp -d)}
listed=$(mktemp -d)
end() {
  umount "$root/proc" 2>/dev/null || true
  rm -rf "$listed"
  [ -n "${ROOT:-}" ] || rm -rf --one-file-system "$root" # what could not be unmounted is not its own
}
trap end EXIT
[ -e "$root/etc/debian_version" ] || debootstrap --variant=minbase "$suite" "$root" "${MIRROR:-http://deb.debian.org/debian}" > "$listed/debootstrap" || {
  tail -5 "$listed/debootstrap" >&2
  exit 1
}
mount -t proc none "$root/proc"
rm -rf "$root"/tmp/*.deb "$root/tmp/home"
mkdir "$root/tmp/home" # what lies there is the user's, not the packages'
cp "$folder"/*.deb "$root/tmp/"
rm -f "$root"/tmp/*-dbgsym_*.deb
inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/tmp/home LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
# apt-get, whose output is shown when it fails only.
inside_apt() {
  inside apt-get -y -qq --no-install-recommends "$@" > "$listed/apt" 2>&1 || { cat "$listed/apt" >&2; exit 1; }
}
# Every file, folder and link with its contents, but for what dpkg, apt and the system write for themselves.
list_files() {
  inside sh -c 'cd / && find . -xdev \( -path ./var/lib/dpkg -o -path ./var/lib/apt -o -path ./var/cache -o -path ./var/log -o -path ./tmp \) -prune -o \
    \( -type f -exec md5sum {} + -o -not -type f -print \)' | sort -k 2 > "$listed/$1"
}

# What the packages need comes first, so that what stays is theirs.
needs=$(for package in "$root"/tmp/*.deb; do dpkg-deb -f "$package" Depends | tr , '\n'; done | sed 's/^ *//; /^$/d; /^hygroloom/d' | sort -u | paste -sd ,)
inside_apt install shared-mime-info desktop-file-utils hicolor-icon-theme
inside_apt satisfy "$needs"
list_files before

inside_apt install $(cd "$root" && ls tmp/*.deb | sed 's|^|/|')
mkdir -p "$root/tmp/tree/tests/data/garments" "$root/tmp/written"
cp packaging/debian/tests/installed "$root/tmp/tree/"
cp tests/data/garments/sheet.dae "$root/tmp/tree/tests/data/garments/"
inside AUTOPKGTEST_TMP=/tmp/written sh -c 'cd /tmp/tree && ./installed'

inside_apt purge hygroloom hygroloom-cli hygroloom-study hygroloom-data python3-hygroloom
list_files after
if ! diff "$listed/before" "$listed/after"; then
  echo "The packages leave something behind." >&2
  exit 1
fi
echo "Installed, run and removed; nothing stays."
