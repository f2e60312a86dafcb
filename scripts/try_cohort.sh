#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Tries musclewarp-cohort on 24 phantoms, three of them broken on purpose, on this
# machine or on a Slurm of its own: 21 are usable, three are named with the reason.
# Then again, with jobs and the engine killed on the way: the same files come out,
# and no frame that was there is computed again. Installs Snakemake (and Slurm) if
# need be. Takes some minutes, and needs root for Slurm; no part of .ci/run.
#
# usage: scripts/try_cohort.sh local|slurm [BIN] [FOLDER]
#   BIN     the programs [build/release/tools]
#   FOLDER  to work in, which is kept [a temporary one, which is not]
# CORES=N: on so many cores [1]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

where=${1:?local or slurm}
bin=$(realpath "${2:-build/release/tools}")
cores=${CORES:-1}
export OMP_WAIT_POLICY=passive PYTHONDONTWRITEBYTECODE=1

case $where in
  local)
    muscles=4
    # Certified contact makes all frames of these seeds usable (scripts/random_scenes.py).
    seeds=(1 3 4 5 6 7 8 9 10 12 13 14 15 16 19 20 22 24 25 27 28)
    options=(--profile local --cores "$cores")
    ;;
  slurm)
    muscles=4
    seeds=(1 3 4 5 6 7 8 9 10 12 13 14 15 16 19 20 22 24 25 27 28)
    options=(--profile slurm)
    ;;
  *)
    echo "try_cohort: '$where' is neither local nor slurm" >&2
    exit 2
    ;;
esac
for program in musclewarp-deform musclewarp-phantom; do
  [[ -x $bin/$program ]] || {
    echo "try_cohort: $bin has no $program; build it, or name another folder" >&2
    exit 2
  }
done
if ! command -v snakemake >/dev/null; then
  as_root=()
  ((EUID == 0)) || as_root=(sudo)
  "${as_root[@]}" apt-get -qq update
  "${as_root[@]}" apt-get -qq install -y --no-install-recommends snakemake \
    >/dev/null
fi

if [[ -n ${3:-} ]]; then
  work=$(realpath -m "$3")
  mkdir -p "$work"
else
  work=$(mktemp -d)
fi
end() {
  [[ $where != slurm ]] || scripts/slurm_here.sh stop "$work/slurm" || true
  [[ -n ${keep:-} ]] || rm -rf "$work"
}
keep=${3:-}
trap end EXIT
in=$work/in

fail() {
  echo "try_cohort: $*" >&2
  exit 1
}

# --- The subjects
line() {
  printf '%s\t%s\tn/a\t%s\tn/a\tn/a\n' "$1" "$2" "$3" >>"$in/subjects.tsv"
}
phantom() {
  "$bin/musclewarp-phantom" --out="$in/$1" "${@:2}" >/dev/null
}
rm -rf "$in"
mkdir -p "$in"
printf 'participant_id\tscene\tmodel\tmotion\tside\tflags\n' >"$in/subjects.tsv"
for seed in "${seeds[@]}"; do
  name=$(printf 'sub-%02d' "$seed")
  phantom "$name" --scene=random --num_muscles=$muscles --seed="$seed"
  line "$name" "$name/scene.json" n/a
done
phantom sub-badmesh --scene=random --num_muscles=$muscles --seed=1
printf 'ply\nthis is no mesh\n' >"$in/sub-badmesh/muscle_01.ply"
line sub-badmesh sub-badmesh/scene.json n/a
phantom sub-nomesh --scene=random --num_muscles=$muscles --seed=3
rm "$in/sub-nomesh/muscle_02.ply"
line sub-nomesh sub-nomesh/scene.json n/a
phantom sub-badmotion --scene=hip --seed=2
sed -i 's/^0\.2\t/0.2\tten /' "$in/sub-badmotion/hip.mot"
line sub-badmotion sub-badmotion/motion.json sub-badmotion/hip.mot
subjects=$(($(wc -l <"$in/subjects.tsv") - 1))
echo "try_cohort: $subjects subjects"

if [[ $where == slurm ]]; then
  scripts/slurm_here.sh start "$work/slurm" "$cores"
  export SLURM_CONF=$work/slurm/slurm.conf
fi
cohort=(cohort/musclewarp-cohort "$in")
options+=(--deform "$bin/musclewarp-deform")

# Runs a cohort to its end, and checks what it says.
run() {
  local out=$1 code=0
  "${cohort[@]}" "$out" group "${options[@]}" >"$out.log" 2>&1 || code=$?
  ((code == 1)) || fail "exit code $code, not 1: see $out.log: $(tail -n 5 "$out.log")"
  tail -n 7 "$out.log"
  grep -q "^24 jobs in .*: 21 usable, 3 not" "$out.log" || fail "not 21 and 3"
  local reason
  for reason in "sub-badmesh scene: refused: .*muscle_01.ply: is truncated" \
    "sub-nomesh scene: refused: .*muscle_02.ply: does not exist" \
    "sub-badmotion hip: refused: .*hip.mot: "; do
    grep -q "^$reason" "$out.log" || fail "no line '$reason' in $out.log"
  done
  [[ -s $out/group.tsv && -s $out/group.html ]] || fail "no table or page of the group"
}

# --- A scene that is not there: refused before anything is written
mkdir -p "$work/missing"
printf 'participant_id\tscene\tmodel\tmotion\tside\tflags\nsub-1\tno.json\tn/a\tn/a\tn/a\tn/a\n' \
  >"$work/missing/subjects.tsv"
code=0
cohort/musclewarp-cohort "$work/missing" "$work/none" group "${options[@]}" || code=$?
((code == 2)) && [[ ! -e $work/none ]] || fail "a missing scene is not refused"

# --- Undisturbed
rm -rf "$work"/{undisturbed,disturbed}*
echo "try_cohort: undisturbed"
began=$(date +%s.%N)
run "$work/undisturbed"
wall=$(awk "BEGIN { print $(date +%s.%N) - $began }")
scripts/compare_cohorts.py --overhead "$work/undisturbed" "$wall" "$cores"

# --- Disturbed
echo "try_cohort: jobs are killed, then the engine"
out=$work/disturbed
jobs_of_ours() {
  pgrep -f -- "^$bin/musclewarp-deform .*--out=$out/" || true
}
setsid "${cohort[@]}" "$out" group "${options[@]}" >"$out.killed.log" 2>&1 &
command=$!
kills=0
for _ in 1 2 3 4 5; do
  sleep $((4 + RANDOM % 8))
  for _ in $(seq 100); do
    victim=$(jobs_of_ours | shuf -n 1)
    [[ -n $victim ]] && break
    sleep 0.1
  done
  kill -9 "$victim" && kills=$((kills + 1)) || true
done
sleep 3
engine=$(pgrep -P "$command" || true)
# shellcheck disable=SC2086 # one word per process
kill -9 "$command" $engine
wait "$command" 2>/dev/null || true
if [[ $where == slurm ]]; then
  scripts/slurm_here.sh kill "$work/slurm"
fi
scripts/compare_cohorts.py --frames "$out" >"$work/frames.before"
echo "try_cohort: killed $kills jobs and the engine; $(wc -l <"$work/frames.before")" \
  "frames and $(find "$out" -name job.json | wc -l) records are there;" \
  "$(jobs_of_ours | wc -l) job(s) live on"
run "$out"
scripts/compare_cohorts.py --frames "$out" >"$work/frames.after"
again=$(comm -23 <(sort "$work/frames.before") <(sort "$work/frames.after") | wc -l)
echo "try_cohort: $again frames that were there were computed again"
# Between a frame and its entry in the log of --resume a kill may fall.
((again <= kills)) || fail "$again frames were done twice"
scripts/compare_cohorts.py "$work/undisturbed" "$out"

# --- Once more: nothing is left to do
find "$out" -name job.json -printf '%p %T@\n' | sort >"$work/records.before"
began=$(date +%s.%N)
run "$out" >/dev/null
echo "try_cohort: with nothing to do it takes" \
  "$(awk "BEGIN { printf \"%.1f\", $(date +%s.%N) - $began }") s"
find "$out" -name job.json -printf '%p %T@\n' | sort | cmp - "$work/records.before" ||
  fail "jobs that were done were done again"
du -sm "$work/undisturbed" | awk '{ print "try_cohort: " $1 " MB of results" }'
echo "try_cohort: all well"
