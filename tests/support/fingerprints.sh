#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# Runs small scenes, garments and studies with one build and writes what they recorded, as hashes, their metrics and rows into a folder. To see
# whether a change keeps every byte, run it with both builds and compare: fingerprints.sh OLD/bin old; fingerprints.sh NEW/bin new; diff -r old new
# Usage: fingerprints.sh <folder of hygroloom-cli> <folder to write> [<fingerprint program>, if it is not in that folder's tests/]
set -eu
bin=$1
out=$2
fingerprint=${3:-$bin/tests/fingerprint}
data=$(dirname "$0")/../data/fingerprints
mkdir -p "$out"
export XDG_CACHE_HOME="$(cd "$out" && pwd)/cache" # or what is learned of this machine's speed would change the expected times

# The name to write, the project, the run.
recorded() {
  name=$1
  project=$2
  shift 2
  "$bin/hygroloom-cli" simulate "$data/$project.hygro" "$@" --backend cpu --json --quiet -o "$out/$name.hygrorec" > "$out/$name.all"
  "$fingerprint" "$out/$name.hygrorec" > "$out/$name.fields"
  # Sentences, versions and times may change; numbers may not.
  grep -E '^ *("[a-z_0-9]+": *)?(-?[0-9.e+-]+|true|false|null|[[{]),?$' "$out/$name.all" |
    grep -vE '"(wall|expected)[a-z_]*"|"threads"' > "$out/$name.numbers"
  rm -rf "$out/$name.all" "$out/$name.hygrorec" "$XDG_CACHE_HOME"
}

scene() {
  name=$1
  shift
  recorded "$name" scenes "$@"
}

# The rows less what differs between machines and moments, and the sensitivities.
study() {
  "$bin/hygroloom-cli" sweep "$data/scenes.hygro" --study "$data/$1.study.json" --backend cpu --quiet -o "$out/$1" > "$out/$1.all"
  sed -E 's/,(wall_s,device,commit,reason|[^,]*,"[^"]*",[^,]*,[^,]*)$//' "$out/$1/results.csv" > "$out/$1.rows"
  [ ! -e "$out/$1/sensitivity.json" ] || mv "$out/$1/sensitivity.json" "$out/$1.sensitivity"
  rm -rf "$out/$1" "$out/$1.all" "$XDG_CACHE_HOME"
}

scene droplet-draft --fabric "Textile F" --experiment droplet --fidelity draft --threads 2
scene droplet-one-thread --fabric "Textile F" --experiment droplet --fidelity draft --threads 1
scene droplet-standard --fabric "Textile F" --experiment "small droplet" --fidelity standard
scene droplet-double --fabric "Textile F" --experiment "small droplet" --fidelity draft --set fidelity.double_precision=1
scene drop-after-drop --fabric "Textile F" --experiment "drop after drop" --fidelity draft
scene droplet-on-stripes --fabric stripes --experiment droplet --fidelity draft
scene swelling --fabric "Textile F" --experiment swelling --fidelity draft
scene management --fabric "Textile F" --experiment management --fidelity standard
scene management-in-bundles --fabric "Textile F" --experiment management --fidelity draft --set fidelity.crossings_per_cell=2
scene management-in-drops --fabric "Textile F" --experiment "management in drops" --fidelity draft
scene vertical --fabric "Textile F" --experiment vertical --fidelity draft
scene horizontal --fabric stripes --experiment horizontal --fidelity standard
scene drying --fabric "Textile F" --experiment drying --fidelity standard
scene drying-on-stripes --fabric stripes --experiment drying --fidelity reference
scene conditioning --fabric "Textile F" --experiment conditioning --fidelity draft --threads 1
scene sweat --fabric "Textile F" --experiment sweat --fidelity standard
scene everything --fabric "Textile F" --experiment "small droplet" --fidelity draft --physics heat=on,vapour=on,sorption=on
recorded tee garments --experiment tee --fidelity draft
recorded lined-singlet garments --experiment "lined singlet" --fidelity draft
recorded patch garments --experiment patch --fidelity standard
study grid
study replicates
