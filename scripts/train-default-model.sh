#!/usr/bin/env bash
# Trains models/vehicle.txt, the discriminator that the programs have built in:
#   scripts/train-default-model.sh [--data DIR] [--work DIR] [--model FILE] [--left-out]
#       [OPTIONS of vdamf-train]
# Simulates scenes (datasets/scenarios and random streets), imports two KITTI drives
# (2011_09_26/2011_09_26_drive_0001_sync and 0005) and two sweeps of Argoverse 2
# (av2_samples/7fab2350) from DIR, tracks them all and trains. Scenes that are in
# the work folder already are not simulated again. --left-out also tells how a model does on each
# recorded drive that it knows nothing of, which takes four times as long.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
preset=${VDAMF_PRESET:-release}
apps=${VDAMF_APPS:-$root/build/$preset/apps}
data=${VDAMF_DATA_DIR:-}
work=$root/results/training
options=()
left_out=
model=$root/models/vehicle.txt
while [ $# -gt 0 ]; do
    case $1 in
        --data | --work | --model)
            [ $# -gt 1 ] || { echo "$1 needs a value" >&2; exit 2; } ;;&
        --data) data=$2; shift 2 ;;
        --work) work=$2; shift 2 ;;
        --model) model=$2; shift 2 ;;
        --left-out) left_out=yes; shift ;;
        *) options+=("$1"); shift ;;
    esac
done
[ -z "$data" ] || [ -d "$data" ] || { echo "$data: no such folder of recordings" >&2; exit 2; }
[ -x "$apps/vdamf-train" ] || "$root/scripts/build.sh" "$preset"
mkdir -p "$work"
work=$(cd "$work" && pwd)
list=$work/recordings.ini
echo "# Written by scripts/train-default-model.sh" > "$list"

# record NAME [line...]: a section of the list; the rawlog is NAME.rawlog, its truth NAME.csv.
record()
{
    printf '\n[recording %s]\nrawlog = %s.rawlog\ntruth = %s.csv\n' "$1" "$1" "$1" >> "$list"
    shift
    [ $# -eq 0 ] || printf '%s\n' "$@" >> "$list"
}

# simulate NAME SCENARIO [options]: unless it is there.
simulate()
{
    local name=$1 scenario=$2
    shift 2
    [ -f "$work/$name.csv" ] ||
        "$apps/vdamf-simulate" "$scenario" -o "$work/$name.rawlog" --truth "$work/$name.csv" \
            --overwrite --quiet "$@"
}

for scenario in "$root"/datasets/scenarios/*.ini; do
    name=$(basename "$scenario" .ini)
    case $name in argoverse | noisy_ins) continue ;; esac
    simulate "$name" "$scenario"
    record "$name" "scene = $name"
done
simulate line_scanner_2 "$root/datasets/scenarios/parked_row.ini" \
    --set sensor.model=LMS-511 --set sensor.z_m=0.6 --set sensor.x_m=3
record line_scanner_2 "scene = parked_row"
simulate line_scanner_3 "$root/datasets/scenarios/two_wheelers_and_people.ini" \
    --set sensor.model=LMS-511 --set sensor.z_m=0.6 --set sensor.x_m=3
record line_scanner_3 "scene = two_wheelers_and_people"

# streets KIND FIRST ROUNDS SENSORS [OPTION]: random streets with seeds from FIRST on, seen by the
# sensors in turn; OPTION: of random-scene.awk.
streets()
{
    local number=$2 sensor name
    for _ in $(seq "$3"); do
        for sensor in $4; do
            name=$1_${number}_$sensor
            awk -v seed="$number" -v sensor="$sensor" ${5:+-v "$5"} \
                -f "$root/scripts/random-scene.awk" > "$work/$name.ini"
            simulate "$name" "$work/$name.ini"
            record "$name" "scene = $name"
            number=$((number + 1))
        done
    done
}
streets street 1 22 "HDL-32E HDL-64E VLP-16"
streets green 101 18 "HDL-64E HDL-32E VLP-16" green=1
streets built 201 8 "HDL-64E HDL-32E VLP-16" built=1

if [ -n "$data" ] && [ -d "$data/2011_09_26" ]; then
    for drive in 0001 0005; do
        name=kitti_$drive
        [ -f "$work/$name.csv" ] ||
            "$apps/vdamf-import" kitti-raw "$data/2011_09_26/2011_09_26_drive_${drive}_sync" \
                -o "$work/$name.rawlog" --truth "$work/$name.csv" --overwrite
        record "$name" "scene = $name" "region_fov_deg = 70" "max_range_m = 60" "weight = 10"
        [ -z "$left_out" ] || options+=(--leave-out "$name")
    done
else
    echo "no recorded drives (--data DIR): the model is trained on simulated scenes alone" >&2
fi

log=$data/av2_samples/7fab2350
if [ -n "$data" ] && [ -d "$log" ]; then
    [ -f "$work/argoverse_2_16.csv" ] ||
        VDAMF_APPS=$apps "$root/scripts/argoverse-sweeps.sh" "$log" "$work" argoverse > /dev/null
    [ -z "$left_out" ] || options+=(--leave-out argoverse)
    for truth in "$work"/argoverse_*_*.csv; do
        record "$(basename "$truth" .csv)" "scene = argoverse" "max_range_m = 60" "weight = 10"
    done
else
    echo "no Argoverse sweeps ($log)" >&2
fi

[[ " ${options[*]-} " == *" --cost "* ]] || options+=(--cost 0.02)
[[ " ${options[*]-} " == *" --frames-per-track "* ]] || options+=(--frames-per-track 10)
[[ " ${options[*]-} " == *" --vehicle-share "* ]] || options+=(--vehicle-share 0.25)
"$apps/vdamf-train" classifier "$list" -o "$model" --overwrite "${options[@]}"
