#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Measures what docs/performance.md reports, and writes its generated chapters and
# plots (docs/performance/*.svg): stages of a frame, modes of contact beside CGAL,
# growth with muscles and vertices, and with --steps single steps. Takes five
# minutes on two cores that do nothing else, with --steps half an hour more. Needs
# python3-numpy of Debian.
#
# usage: benchmarks/performance.sh DATA OUT [options]
#
#   DATA             the folder with lhdl_hip; for --steps with all public data
#   OUT              where figures are kept; those of an earlier run go
#   --quick          a frame or two of everything, to see that this runs
#   --large          also 16 muscles and meshes 16 times as fine: some minutes more
#   --steps          also the steps of benchmarks/steps.sh
#   --programs=DIR   a build folder; build/release, built if need be
#   --page=FILE      the page to write; docs/performance.md, with --quick a copy
#                    of it in OUT
set -euo pipefail

usage() {
  sed -n '/^# usage/,/^set/{/^set/d;s/^# \{0,1\}//;p}' "$0" >&2
  exit 2
}

refuse() {
  echo "performance: $*" >&2
  exit 2
}

data='' out='' quick='' large='' steps='' build='' page=''
for word in "$@"; do
  case $word in
    --quick) quick=yes ;;
    --large) large=yes ;;
    --steps) steps=yes ;;
    --programs=*) build=${word#*=} ;;
    --page=*) page=$(realpath -m "${word#*=}") ;;
    -*) usage ;;
    *) if [[ -z $data ]]; then data=$word; elif [[ -z $out ]]; then out=$word; else usage; fi ;;
  esac
done
[[ -n $data && -n $out ]] || usage
folders=(lhdl_hip)
[[ -z $steps || -n $quick ]] || folders+=(bodyparts3d bodyparts3d_shank bodyparts3d_shoulder)
for folder in "${folders[@]}"; do
  [[ -d $data/$folder ]] || refuse "$data has no folder $folder"
done
/usr/bin/python3 -c 'import numpy' 2>/dev/null ||
  refuse "/usr/bin/python3 has no numpy: apt-get install python3-numpy"
[[ -z $build || -d $build ]] || refuse "$build is no build folder"
data=$(realpath "$data")
out=$(realpath -m "$out")
[[ -z $build ]] || build=$(realpath "$build")
cd "$(dirname "${BASH_SOURCE[0]}")/.."

targets=(musclewarp-deform musclewarp-phantom solve_benchmark)
[[ -z $steps ]] || targets+=(step_benchmark)
if [[ -z $build ]]; then
  build=$PWD/build/release
  cmake --preset release -DMUSCLEWARP_BUILD_BENCHMARKS=ON >/dev/null
  cmake --build "$build" --target "${targets[@]}" >/dev/null
fi
for program in "${targets[@]}"; do
  [[ $program == musclewarp-* ]] && folder=tools || folder=benchmarks
  [[ -x $build/$folder/$program ]] ||
    refuse "$build/$folder has no $program; build it with -DMUSCLEWARP_BUILD_BENCHMARKS=ON"
done
if [[ -z $page ]]; then
  page=$PWD/docs/performance.md
  [[ -z $quick ]] || page=$out/performance.md
fi

work=$out/work figures=$out/work/figures # moved to OUT when all are there
rm -rf "$work"
mkdir -p "$figures" "$work/cache"
trap 'rm -rf "$work"' EXIT

# Prints the ticks of all processors, those of them idle, and those of this script.
ticks() {
  awk '/^cpu /{print $2 + $3 + $4 + $5 + $6 + $7 + $8 + $9, $5 + $6}' /proc/stat
  awk '{print $14 + $15 + $16 + $17}' "/proc/$$/stat"
}
mapfile -t before < <(ticks)

# Keeps the share of the processors that other programs took: on a busy machine two
# threads may have no more than one processor, and seem to be of no use.
write_load() {
  local after
  mapfile -t after < <(ticks)
  awk -v before="${before[*]}" -v after="${after[*]}" 'BEGIN {
    split(before, b); split(after, a)
    all = a[1] - b[1]
    others = all - (a[2] - b[2]) - (a[3] - b[3])
    if (all <= 0 || others < 0) others = 0
    printf "{\"other_programs\": %.4f}\n", others / (all + (all == 0))
  }' >"$figures/load.json"
}

# Runs a program, which may end with exit code 1: frames that are not usable take
# their time all the same.
run() {
  local code=0
  "$@" >"$work/log" 2>&1 || code=$?
  if ((code > 1)); then
    tail -n 20 "$work/log" >&2
    echo "performance: $(basename "$1") failed with exit code $code" >&2
    exit 1
  fi
}

# NAME FLAG...: deforms, and keeps the report as figures/NAME.json.
deform() {
  local name=$1
  shift
  run "$build/tools/musclewarp-deform" "$@" --bones=once --out="$work/run"
  mv "$work/run/report.json" "$figures/$name.json"
  rm -rf "$work/run"
}

# Seeds whose rest poses are soon free of crossings.
turns=3 last=12 seeds=(3 4) numbers=(2 4 8) cuts=(1 2 3) frames=all
if [[ -n $large ]]; then numbers+=(16) cuts+=(4); fi
if [[ -n $quick ]]; then turns=1 last=3 seeds=(3) numbers=(2 4) cuts=(1 2) frames=0:1; fi

# The modes of contact and CGAL by turns, so that all of them have the same share
# of what else the machine does. Preparations are made before, into the cache.
lhdl=(--scene=data/scenes/lhdl_hip_motion.json --data_root="$data" --cache="$work/cache"
  --motion=lhdl_hip/motions/hip_flexion.mot)
mode_flags() {
  case $1 in
    none | paper | certified) echo --contact="$1" ;;
    reference) echo --contact=certified --solver=reference ;;
  esac
}
modes=(none paper certified reference)
for mode in "${modes[@]}"; do
  read -ra flags <<<"$(mode_flags "$mode")"
  run "$build/tools/musclewarp-deform" "${lhdl[@]}" "${flags[@]}" --frames=0:0 --out="$work/run"
  rm -rf "$work/run"
done
echo "performance: prepared after $SECONDS s"
for ((turn = 1; turn <= turns; ++turn)); do
  for mode in "${modes[@]}"; do
    read -ra flags <<<"$(mode_flags "$mode")"
    for threads in 1 2; do
      deform "mode_${mode}_${threads}_$turn" "${lhdl[@]}" "${flags[@]}" --frames=0:$last \
        --profile --threads=$threads
    done
  done
  OMP_NUM_THREADS=1 MUSCLEWARP_DATA_ROOT=$data run "$build/benchmarks/solve_benchmark" \
    --benchmark_filter='/(reference|ceres|arap_10)/' --benchmark_out_format=json \
    --benchmark_out="$figures/solve_$turn.json"
  echo "performance: turn $turn of modes done after $SECONDS s"
done

# growth NAME SEED SCENE_FOLDER: the report of a random scene.
grow() {
  deform "$1" --scene="$2/scene.json" --frames=$frames
  echo "performance: $1 done after $SECONDS s"
}
phantom() {
  run "$build/tools/musclewarp-phantom" --scene=random --seed="$1" --num_muscles="$2" --out="$3"
}
for seed in "${seeds[@]}"; do
  for number in "${numbers[@]}"; do
    phantom "$seed" "$number" "$work/random"
    grow "muscles_${seed}_$number" "$work/random"
    rm -rf "$work/random"
  done
done
phantom "${seeds[0]}" 2 "$work/random"
for cut in "${cuts[@]}"; do
  run /usr/bin/python3 -B benchmarks/performance/refined_scene.py "$work/random" "$cut" "$work/fine"
  grow "vertices_${seeds[0]}_$cut" "$work/fine"
  rm -rf "$work/fine"
done

if [[ -n $steps ]]; then
  only=()
  [[ -z $quick ]] || only=(--only=embedded)
  for anew in --anew ''; do # records the steps, then takes them again
    run benchmarks/steps.sh "$data" "$out/steps" --programs="$build" "${only[@]}" ${anew:+$anew}
    echo "performance: steps ${anew:+recorded and }taken after $SECONDS s"
  done
  /usr/bin/python3 -B benchmarks/steps_table.py "$out/steps" >"$figures/steps.md"
fi

write_load
rm -rf "$out/figures"
mv "$figures" "$out/figures"
/usr/bin/python3 -B benchmarks/performance/page.py "$out/figures" "$page" \
  --command="benchmarks/performance.sh DATA OUT${quick:+ --quick}${large:+ --large}${steps:+ --steps}"
echo "performance: wrote $page after $SECONDS s"
