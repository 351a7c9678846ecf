#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# Writes the guide's command-line reference anew, from the option table of the program: packaging/reference.sh [BUILD_FOLDER]
# The test `reference` compares the two.
set -eu
cd "$(dirname "$0")/.."
"${1:-build/release}/bin/hygroloom-cli" reference > resources/help/command-line.md
