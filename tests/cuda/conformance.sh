#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# The physics on a GPU against known answers, against the CPU, and under compute-sanitizer. See README.md beside it.
# Usage: conformance.sh [hygroloom-cli]; exit status 1 if anything failed.
cli=${1:-build/release/bin/hygroloom-cli}
failed=0
export XDG_CACHE_HOME=/dev/null # no estimate learns from a run before: results are compared to the byte

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
try "a drop as a cap agrees with the CPU" "$cli" verify experiments_agree --set closure=pores --set fidelity=live --backend cuda
examples=$(dirname "$0")/../../resources/examples
without_times() { grep -v '"wall_s"' "$1"; }
if [ -d "$examples" ]; then
    # The same steps as one kernel, with frames fetched while other steps run, and stage by stage, with frames fetched at once: the same bytes.
    results=$(mktemp -d)
    agree() { # what, arguments of simulate...
        run=$1
        shift
        try "$run" sh -c "'$cli' simulate $* --backend cuda --fidelity draft --json > $results/one"
        try "$run, stage by stage" sh -c "'$cli' simulate $* --backend cuda --fidelity draft --json --profile > $results/staged"
        without_times "$results/one" > "$results/a"
        without_times "$results/staged" > "$results/b"
        try "they agree to the byte" cmp "$results/a" "$results/b"
    }
    agree "a drop" "$examples/one-drop-on-cotton.hygro" --set "experiments[0].duration_s=0.2"
    agree "a drop as a cap" "$examples/one-drop-on-cotton.hygro" --set "experiments[0].duration_s=0.2" --set fidelity.free_liquid=cap
    agree "a drop shown in cells" "$examples/one-drop-on-cotton.hygro" --set "experiments[0].duration_s=0.2" --shown-mm 0.8
    agree "a drying" "$examples/laboratory.hygro" --experiment drying --set "experiments[4].duration_s=600"
    worn() { # backend, file
        sh -c "'$cli' simulate '$examples/lined-singlet.hygro' --set 'experiments[0].duration_s=60' --fidelity draft --backend $1 \
            | grep -v ' thread(s)\| on ' > $2"
    }
    try "a lined garment" worn cuda "$results/one"
    try "a lined garment on the CPU" worn cpu "$results/beside"
    try "they agree to the printed digits" cmp "$results/one" "$results/beside"
    # Until yarns are full: what the garment holds in the end, within 1 %.
    filled() { "$cli" simulate "$examples/lined-singlet.hygro" --fidelity live --backend "$1" --json | awk -F'[:,]' '/"water_g"/ && !n++ { print $2 }'; }
    on_gpu=$(filled cuda) beside=$(filled cpu)
    try "a lined garment that fills up: $on_gpu g, on the CPU $beside g" awk "BEGIN { exit !($on_gpu > 0 && ($on_gpu / $beside - 1) ^ 2 < 1e-4) }"
    # Yarns that seams join into rings: both corners of a symmetric garment's hem hold the same within 2 %.
    "$cli" garment import built-in:tee --fabric "Textile F" -o "$results/tee.hygro" -q > "$results/one"
    even() {
        "$cli" simulate "$results/tee.hygro" --fidelity live --backend cuda -q -o "$results/tee.hygrorec" > "$results/one"
        "$cli" garment map "$results/tee.hygrorec" -o "$results/map" > "$results/one"
        awk -F, '$1 == "back" && $5 < 60 && $4 < -200 { left += $11; ++n } $1 == "back" && $5 < 60 && $4 > 200 { right += $11; ++m }
            END { left /= n; right /= m; print left, right; exit !(left > 0 && (right / left - 1) ^ 2 < 4e-4) }' "$results/map/cells.csv"
    }
    try "a tee is even left and right" even
    # Blocks of few threads with one fabric at a time, of many side by side: the same bytes.
    compared() { # fabrics at once, file
        sh -c "'$cli' compare '$examples/paper/figure-13-structures.hygro' --experiment 'one drop' --set 'experiments.one drop.duration_s=0.2' \
            --backend cuda --fidelity standard --at-once $1 --json > $2"
    }
    try "seven fabrics one after the other" compared 1 "$results/one"
    try "seven fabrics side by side" compared 7 "$results/beside"
    without_times "$results/one" > "$results/a"
    without_times "$results/beside" > "$results/b"
    try "they agree to the byte" cmp "$results/a" "$results/b"
    # A GPU goes on from its own state, with a part more.
    try "a part comes on" sh -c "'$cli' simulate '$examples/laboratory.hygro' --experiment 'horizontal wicking' --backend cuda --fidelity draft \
        --set fabrics[0].warp.material=polyester fabrics[0].weft.material=polyester fabrics[0].contact_angle_deg=20 \
        'experiments[3].closure=paper' 'experiments[3].volume_ul=1' 'experiments[3].sample_mm=[16,16]' experiments[3].duration_s=200 \
        experiments[3].climate.relative_humidity=0.993 experiments[3].climate.air_speed_m_s=0 | grep 'Vapour was left out until'"
    rm -r "$results"
else
    echo "skip whole runs: the examples are not there"
fi
if command -v compute-sanitizer > /dev/null; then
    for tool in memcheck racecheck initcheck; do
        try "$tool, liquid" compute-sanitizer --error-exitcode 9 --tool $tool "$cli" verify drop_conservation \
            --set particles=100 --set time_s=0.01 --backend cuda
        try "$tool, yarns" compute-sanitizer --error-exitcode 9 --tool $tool "$cli" verify conservation \
            --set experiment=moisture_management --set duration_s=0.1 --backend cuda
        try "$tool, a cap" compute-sanitizer --error-exitcode 9 --tool $tool "$cli" verify conservation \
            --set closure=pores --set fidelity=live --set duration_s=0.05 --backend cuda
        try "$tool, a drop on cloth" compute-sanitizer --error-exitcode 9 --tool $tool "$cli" verify conservation \
            --set closure=pores --set fidelity=draft --set duration_s=0.02 --backend cuda
        try "$tool, cells" compute-sanitizer --error-exitcode 9 --tool $tool "$cli" simulate "$examples/laboratory.hygro" --experiment drying \
            --set "experiments[4].duration_s=1" --shown-mm 2 --fidelity draft --backend cuda
        try "$tool, a lined garment" compute-sanitizer --error-exitcode 9 --tool $tool "$cli" simulate "$examples/lined-singlet.hygro" \
            --set "experiments[0].duration_s=1" --cell-mm 40 --fidelity draft --backend cuda
        try "$tool, yarns that touch" compute-sanitizer --error-exitcode 9 --tool $tool "$cli" verify conservation \
            --set experiment=moisture_management --set "fabric=Textile C" --set duration_s=0.02 --backend cuda
    done
else
    echo "skip compute-sanitizer: not there"
fi
exit $failed
