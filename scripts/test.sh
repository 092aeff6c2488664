#!/usr/bin/env bash
# Installs what is missing, builds and runs all tests: scripts/test.sh [preset]
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${1:-${VDAMF_PRESET:-release}}
scripts/build.sh "$preset"
ctest --preset "$preset" -j $(($(nproc) + 1))
