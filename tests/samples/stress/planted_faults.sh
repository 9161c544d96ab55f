#!/usr/bin/env bash
# planted_faults.sh STRESS LIBRARY_FOLDER OUT [FAULT...]: plants each fault in turn, and sees that the scenario beside it
# finds it by the check beside that, and makes a script of at most 20 lines that fails the same way.
set -euo pipefail
stress=$1 library=$2 out=$3
shift 3

faults='
lost-voxel            tower_felling      accounting
skipped-shadow-patch  spray_everything   shadow
leaked-body           joint_massacre     objects
wrong-mass            tower_felling      mass
stale-light           light_groups       lights
unsaved-field         rubble_avalanche   save
race                  rubble_avalanche   replay
energy-gain           domino_city        energy
brush-off-by-one      swiss_cheese       brush
unhashed-field        flood              hash
'
mkdir -p "$out"
failed=0
while read -r fault scenario check; do
    [[ $fault ]] || continue
    [[ $# == 0 || " $* " == *" $fault "* ]] || continue
    script=$out/${scenario}_1_failure.lua
    rm -f "$script"
    printed=$(LD_LIBRARY_PATH=$library RUBBLE_PLANTED_FAULT=$fault \
        "$stress" "$scenario" --images 0 --minutes 0.1 --minimise 60 --out "$out" 2>/dev/null) && printed="all checks held"
    lines=$([[ -f $script ]] && wc -l <"$script" || echo 0)
    if grep -q "FAILED at step [0-9]*: $check:" <<<"$printed" && ((lines > 0 && lines <= 20)); then
        echo "$fault: found by $check in $scenario, $lines lines"
    else
        echo "$fault: expected a failure of $check in $scenario and a script of 1 to 20 lines, found $lines lines and:"
        tail -n 30 <<<"$printed"
        failed=1
    fi
done <<<"$faults"
exit "$failed"
