#!/usr/bin/env bash
# Builds, then tracks and scores every scenario: one table of how good the tracker is, held against
# bounds. scripts/regression.sh [--fast] [--data DIR] [--compare old.csv] [--only NAME,NAME]
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
preset=${VDAMF_PRESET:-ci}  # one with benchmarks: ci or dev
"$root/scripts/build.sh" "$preset"
program=$root/build/$preset/benchmarks/vdamf_regression
[ -x "$program" ] || { echo "the preset $preset builds no benchmarks: VDAMF_PRESET=ci" >&2; exit 2; }
exec "$program" "$@"
