#!/usr/bin/env bash
# Parses each source on its own, as the README's build compiles it and without any warning: where
# the CI compiles many as one, a file can use what only another one includes.
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset release -B build/check >/dev/null
# But for the tracker's, which the CI compiles one by one too, and what the build itself writes.
mapfile -t commands < <(ninja -C build/check -t commands all | grep -v ' -o libs/tracking/' |
    grep -v " -c $PWD/build/" | sed -n 's/ -MD .* -c / -fsyntax-only -Werror /p')
echo "${#commands[@]} sources"
((${#commands[@]} > 0))
printf '%s\0' "${commands[@]}" | xargs -0 -P "$(nproc)" -I{} sh -c '{}'
