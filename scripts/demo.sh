#!/usr/bin/env bash
# Installs what is missing, builds, and tracks the vehicles of the shipped street scene.
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${VDAMF_PRESET:-release}
scripts/build.sh "$preset"
mkdir -p results
"build/$preset/apps/vdamf-track" -c config.ini -i datasets/street/street.rawlog \
    -o results/street_tracked.rawlog --tracks results/tracks.csv --picture results/street.svg \
    --report results/street.html --overwrite
echo
echo "annotated rawlog  results/street_tracked.rawlog"
echo "table of tracks   results/tracks.csv"
echo "picture           results/street.svg"
echo "page to play      results/street.html"
