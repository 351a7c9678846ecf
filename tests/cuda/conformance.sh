#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# The physics on a GPU against known answers, against the CPU, and under compute-sanitizer. See README.md beside it.
# Usage: conformance.sh [hygroloom-cli]; exit status 1 if anything failed.
cli=${1:-build/release/bin/hygroloom-cli}
failed=0

try() { # what, command...
    what=$1
    shift
    if output=$("$@" 2>&1); then
        echo "pass $what"
    else
        echo "FAIL $what"
        echo "$output" | tail -20
        failed=1
    fi
}

"$cli" devices
for name in $("$cli" verify --list | awk '/^[a-z]/ { print $1 }'); do
    case $name in measured_*) continue ;; esac # comparisons, which may miss
    try "$name" "$cli" verify "$name" --backend cuda
done
for experiment in droplet moisture_management vertical_wicking horizontal_wicking drying conditioning sweat; do
    try "$experiment agrees with the CPU" "$cli" verify experiments_agree --set experiment=$experiment --backend cuda
done
if command -v compute-sanitizer > /dev/null; then
    for tool in memcheck racecheck initcheck; do
        try "$tool, liquid" compute-sanitizer --error-exitcode 9 --tool $tool "$cli" verify drop_conservation \
            --set particles=100 --set time_s=0.01 --backend cuda
        try "$tool, yarns" compute-sanitizer --error-exitcode 9 --tool $tool "$cli" verify conservation \
            --set experiment=moisture_management --set duration_s=0.1 --backend cuda
    done
else
    echo "skip compute-sanitizer: not there"
fi
exit $failed
