#!/usr/bin/env bash
# Installs what is missing and builds with a CMake preset: scripts/build.sh [preset]
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${1:-${VDAMF_PRESET:-release}}
scripts/install-packages.sh
options=()
command -v ccache >/dev/null && options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
cmake --preset "$preset" "${options[@]}"
cmake --build --preset "$preset"
