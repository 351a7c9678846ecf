#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# Tries to break the command line and prints what was tried, what held and what broke: packaging/reliability.sh [--minutes N] [--seed N]
# [--only CLASS] [--build FOLDER]. It takes four minutes; with --minutes 300 as many hours as that is. Exits with 1 if anything broke, whose files it keeps.
set -eu
cd "$(dirname "$0")/.."
exec python3 tests/app/reliability.py "$@"
