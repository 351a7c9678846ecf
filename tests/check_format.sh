#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# Whether clang-format 14 would change anything. Without that version the test is skipped (77). Run by ctest: check_format.sh <root>
set -eu
format=$(command -v clang-format-14 || command -v clang-format || true)
if [ -z "$format" ] || ! "$format" --version | grep -q "version 14\."; then
  echo "SKIPPED: clang-format 14 is not installed; other versions format differently."
  exit 77
fi
cd "$1"
# --dry-run also complains of namespace comments that clang-format 14 writes again as they are: what it complains of is compared.
suspects=$(find app core gpu ui tests \( -name '*.cpp' -o -name '*.h' -o -name '*.cu' -o -name '*.cuh' \) -print0 |
  xargs -0 -n 50 "$format" --dry-run -Werror 2>&1 | sed -n 's/^\([^ :]*\):[0-9]*:[0-9]*: error: .*/\1/p' | sort -u)
faults=0
for file in $suspects; do
  "$format" "$file" | cmp -s - "$file" && continue
  echo "$file: run clang-format -i on it"
  faults=1
done
exit $faults
