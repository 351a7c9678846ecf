#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# The verdict of ThreadSanitizer: builds the tests that use threads with the preset tsan, proves that a race put in by hand is found, and runs them.
# packaging/threads.sh    Takes some 30 minutes; exits with 1 where a race is found.
set -eu
cd "$(dirname "$0")/.."
tests="tests_queue/tst_run_queue tests_run/tst_late_frames tests_run/tst_session tests_solver/tst_liquid tests_solver/tst_touching tests_solver/tst_mixed_yarns"

cmake --preset tsan --log-level=NOTICE >/dev/null
cmake --build --preset tsan --target thread_check hygroloom-cli tests_queue tests_run tests_solver
bin=build/tsan/bin
TSAN_OPTIONS="suppressions=$PWD/tests/support/tsan.supp exitcode=0"
export TSAN_OPTIONS QTEST_FUNCTION_TIMEOUT=3600000 # ms; what is checked is slow
failed=""
log=build/tsan/thread-check.log
# Reports, but for those of the watchdog of Qt Test, a thread that is Qt's alone.
reports() { awk 'BEGIN { RS = "==================\n" } /^WARNING: ThreadSanitizer/ && !/QtTest Watchdog/ { print RS $0 }' "$log"; }
# run NAME EXPECTED COMMAND...: expected is "race", or "none" and an exit code of 0.
run() {
  name=$1
  expected=$2
  shift 2
  "$@" > "$log" 2>&1 && code=0 || code=$?
  races=$(reports | grep -c '^WARNING' || true)
  echo "$name: exit $code, $races races"
  case $expected,$races,$code in
    none,0,0 | race,[1-9]*) return ;;
  esac
  failed="$failed $name;"
  if [ "$races" -gt 0 ]; then reports | head -60; else tail -20 "$log"; fi
}
run "a race put in by hand" race $bin/thread_check race
run "the same without it" none $bin/thread_check none
for test in $tests; do run "${test#*/}" none "$bin/tests/${test%/*}" "${test#*/}"; done
run "simulate, 4 threads" none $bin/hygroloom-cli simulate resources/examples/one-drop-on-cotton.hygro --fidelity draft --threads 4 -q \
  --set "experiments[0].duration_s=0.05" --set fidelity.particles_per_droplet=500 -o build/tsan/drop.hygrorec
run "simulate side by side" none $bin/hygroloom-cli simulate resources/examples/three-candidates.hygro --experiment "one drop" --fidelity draft \
  --fabrics "Cotton plain,Hemp plain" --at-once 2 -q --set "experiments[0].duration_s=0.02" --set fidelity.particles_per_droplet=500 -o build/tsan/several
rm -rf build/tsan/drop.hygrorec build/tsan/several
[ -z "$failed" ] || { echo "Broken:$failed"; exit 1; }
