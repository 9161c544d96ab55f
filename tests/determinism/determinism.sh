#!/usr/bin/env bash
# Runs scripted scenes in nine configurations and compares their state hashes. Each pair of values of compiler,
# optimisation, threads, renderer and mode (play, load a save half-way, replay a recording) occurs in at least one of
# the nine (pairwise testing). Builds what it needs.
#   tests/determinism/determinism.sh [--small] [--steps N] [--long SCENE] [SCENE...]
# By default: all scripted scenes and the town for 600 steps, and the tower for 3,600. --long SCENE runs another scene six
# times as long; none: no scene. --small: three builds in five configurations, without a renderer.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.." && pwd)

# compiler optimisation threads renderer mode
table='
g++     O2 4 off replay
g++     O2 2 on  play
g++     O3 1 off play
g++     O3 4 off load
g++     O0 2 off load
clang++ O2 1 on  load
clang++ O3 2 on  replay
clang++ O0 1 off replay
clang++ O0 4 on  play
'
small='
g++     O2 1 off play
g++     O2 2 off load
g++     O0 2 off replay
clang++ O2 1 off replay
clang++ O2 2 off load
'
steps=600 long=tower scenes=()
while (($#)); do
    case $1 in
    --small) table=$small && shift ;;
    --steps) steps=$2 && shift 2 ;;
    --long) long=$2 && shift 2 ;;
    *) scenes+=("$1") && shift ;;
    esac
done
((${#scenes[@]})) || scenes=(tower bridge fire wall pane light_shop dominoes craters crush
    garden crane domino_run raft drive lights chapel mechanics town)

programOf() { echo "$root/build/determinism/$1-$2/bin/hash_scene"; }

build() {
    local folder=$root/build/determinism/$1-$2 c=gcc
    [[ $1 == clang++ ]] && c=clang
    echo "building with $1 -$2" >&2
    cmake -G Ninja -S "$root" -B "$folder" -DCMAKE_BUILD_TYPE=Determinism -DCMAKE_CXX_COMPILER="$1" -DCMAKE_C_COMPILER="$c" \
        -DCMAKE_CXX_FLAGS="-$2" -DCMAKE_C_FLAGS="-$2" -DRUBBLE_BENCHMARKS=OFF >/dev/null
    cmake --build "$folder" --target hash_scene >/dev/null
}

# check SCENE STEPS: fails unless all configurations give the hashes of the first one.
check() {
    local first='' cxx opt threads renderer mode hashes options
    while read -r cxx opt threads renderer mode; do
        [[ $cxx ]] || continue
        options=(--scene "$1" --steps "$2" --threads "$threads" --mode "$mode")
        [[ $renderer == on ]] && options+=(--renderer)
        echo "$1: $cxx -$opt ${options[*]}" >&2
        hashes=$("$(programOf "$cxx" "$opt")" "${options[@]}" 2>/dev/null) || {
            echo "$1: failed: $cxx -$opt ${options[*]}"
            return 1
        }
        if [[ ! $first ]]; then
            first=$hashes
        elif [[ $hashes != "$first" ]]; then
            echo "$1: other hashes: $cxx -$opt ${options[*]}"
            diff <(echo "$first") <(echo "$hashes") | head -4
            return 1
        fi
    done <<<"$table"
    echo "$1: equal over $2 steps: ${first##* }"
}

while read -r cxx opt rest; do
    [[ $cxx ]] || continue
    [[ $(declare -p built 2>/dev/null) == *" $cxx-$opt "* ]] || build "$cxx" "$opt"
    built="${built:-} $cxx-$opt "
done <<<"$table"

failed=0
for scene in "${scenes[@]}"; do check "$scene" "$steps" || failed=1; done
[[ $long == none ]] || check "$long" $((steps * 6)) || failed=1
exit $failed
