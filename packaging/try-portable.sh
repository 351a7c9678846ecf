#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# Unpacks the bundle in a bare Debian that has a desktop's libraries but no Qt, and runs both programs, the window without a screen and on a virtual one:
# packaging/try-portable.sh [BUNDLE]    Needs root, debootstrap, Xvfb and a Debian mirror (MIRROR=...). ROOT=... keeps the Debian for next time.
set -eu
cd "$(dirname "$0")/.."
bundle=${1:-$(ls build/portable/hygroloom-*.tar.gz)}
[ "$(id -u)" -eq 0 ] || { echo "A chroot needs root: sudo $0 $*" >&2; exit 1; }

root=${ROOT:-$(mktemp -d)}
screen=""
end() {
  [ -z "$screen" ] || kill "$screen"
  umount "$root/tmp/.X11-unix" "$root/proc" 2>/dev/null || true
  rm -f "$root.log"
  [ -n "${ROOT:-}" ] || rm -rf --one-file-system "$root" # what could not be unmounted is not its own
}
trap end EXIT
[ -e "$root/etc/debian_version" ] || debootstrap --variant=minbase bookworm "$root" "${MIRROR:-http://deb.debian.org/debian}" > "$root.log" || {
  tail -5 "$root.log" >&2
  exit 1
}
mount -t proc none "$root/proc"
inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
inside apt-get install -y -qq --no-install-recommends libgl1 libegl1 libopengl0 libgl1-mesa-dri libx11-6 libx11-xcb1 libfontconfig1 fonts-dejavu-core >/dev/null 2>&1
if inside sh -c 'ldconfig -p | grep -q libQt6'; then
  echo "There is a Qt in $root; take another." >&2
  exit 1
fi
bundled="/opt/moved, with blanks" # it may lie anywhere
rm -rf "$root$bundled"
mkdir -p "$root$bundled"
tar --extract --file "$bundle" --directory "$root$bundled" --strip-components 1
example="$bundled/share/hygroloom/examples/one-drop-on-cotton.hygro"
touch "$root/tmp/begun"

inside "$bundled/bin/hygroloom-cli" simulate "$example" --fidelity draft --quiet > "$root/tmp/said"
head -3 "$root/tmp/said"
cp tests/data/garments/sheet.dae "$root/tmp/"
inside "$bundled/bin/hygroloom-cli" garment import /tmp/sheet.dae
inside QT_QPA_PLATFORM=offscreen "$bundled/hygroloom" --version
number=77
Xvfb ":$number" -screen 0 1280x1024x24 -nolisten tcp >/dev/null 2>&1 &
screen=$!
sleep 2
mkdir -p "$root/tmp/.X11-unix"
mount --bind /tmp/.X11-unix "$root/tmp/.X11-unix"
inside DISPLAY=":$number" timeout --preserve-status 10 "$bundled/hygroloom" "$example" 2>"$root/tmp/said" && code=0 || code=$?
# 143: it ran until it was ended.
[ "$code" -eq 143 ] || { cat "$root/tmp/said" >&2; echo "The window did not stay open; it ended with $code." >&2; exit 1; }
written=$(find "$root$bundled" -newer "$root/tmp/begun")
[ -z "$written" ] || { echo "Written into the bundle's folder: $written" >&2; exit 1; }
echo "Both programs run without Qt on the system."
