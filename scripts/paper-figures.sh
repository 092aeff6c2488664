#!/usr/bin/env bash
# Makes the paper's figures 8 to 11 again from our data, as results/figures/*.svg:
#   scripts/paper-figures.sh [--data DIR]
# Fig. 8: a vehicle circles in front of the LADAR; Fig. 9 and 10: a vehicle followed through woods, told
# from clutter; Fig. 11: grid, weights, ROC and DET of the discriminator, which is trained for it
# (train-default-model.sh, some minutes; DIR as there; its model is left in results/training).
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
preset=${VDAMF_PRESET:-ci} # one with benchmarks: ci or dev
build=${VDAMF_BUILD:-$root/build/$preset}
[ -x "$build/benchmarks/vdamf_paper_figures" ] || "$root/scripts/build.sh" "$preset"
out=$root/results/figures
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$out"

simulate()
{
    "$build/apps/vdamf-simulate" "$1" -o "$work/$2.rawlog" --truth "$work/$2.csv" --quiet \
        --set sensor.model=HDL-64E
}
simulate "$root/datasets/scenarios/constant_curvature.ini" circle
"$build/benchmarks/vdamf_paper_figures" -i "$work/circle.rawlog" --truth "$work/circle.csv" \
    --target circling --circle -o "$out"
simulate "$root/datasets/figures/woods.ini" woods
"$build/benchmarks/vdamf_paper_figures" -i "$work/woods.rawlog" --truth "$work/woods.csv" \
    --target followed -o "$out"

VDAMF_APPS=$build/apps "$root/scripts/train-default-model.sh" "$@" \
    --model "$root/results/training/vehicle.txt" --plots "$work/plots"
for plot in weights vehicles clutter roc det reliability; do
    mv "$work/plots/$plot.svg" "$out/fig11_$plot.svg"
done
ls "$out"
