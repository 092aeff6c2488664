#!/usr/bin/env bash
# Builds the fuzz targets with clang and runs them, each under AddressSanitizer and
# UndefinedBehaviorSanitizer with at most 1 GB of memory and 10 s an input. What they find is kept
# in build/fuzzers/findings/TARGET; exit code 1 where there is any.
# scripts/fuzz.sh [--seconds N] [--runs N] [TARGET]...   for each target, whichever ends first; 60 s
set -uo pipefail
cd "$(dirname "$0")/.."
usage() { sed -n '5s/^# //p' scripts/fuzz.sh >&2; exit 2; }
limits=()
targets=()
while [ $# -gt 0 ]; do
    case $1 in
        --seconds | --runs)
            [[ ${2:-} =~ ^[0-9]+$ ]] || usage
            [ "$1" = --seconds ] && limits+=("-max_total_time=$2") || limits+=("-runs=$2")
            shift 2 ;;
        -*) usage ;;
        *) targets+=("$1"); shift ;;
    esac
done
[ ${#limits[@]} -eq 0 ] && limits=(-max_total_time=60)
if [ ${#targets[@]} -eq 0 ]; then
    for source in fuzz/targets/*.cpp; do targets+=("$(basename "$source" .cpp)"); done
fi
for target in "${targets[@]}"; do
    [ -f "fuzz/targets/$target.cpp" ] && continue
    echo "no target $target; there are:" $(basename -s .cpp fuzz/targets/*.cpp) >&2
    exit 2
done

if ! command -v clang++ >/dev/null; then
    sudo=$([ "$(id -u)" -eq 0 ] || echo sudo)
    $sudo apt-get update -q && $sudo apt-get install -q -y --no-install-recommends \
        clang libclang-rt-14-dev || exit 1
fi
scripts/build.sh fuzzers || exit 1

build=build/fuzzers
failed=0
printf '\n%-18s %10s %10s %9s %8s %9s %9s\n' target inputs inputs/s edges 'MB peak' slowest_s findings
for target in "${targets[@]}"; do
    findings=$build/findings/$target log=$build/findings/$target.log
    mkdir -p "$findings" "$build/corpus/$target"
    seeds=(fuzz/corpus/"$target")
    [ -d fuzz/regressions/"$target" ] && seeds+=(fuzz/regressions/"$target")
    dictionary=()
    [ -f fuzz/dictionaries/"$target" ] && dictionary=(-dict=fuzz/dictionaries/"$target")
    # Leaks are looked for when the tests replay the inputs: here that would take most of the time.
    ASAN_OPTIONS=detect_leaks=0 UBSAN_OPTIONS=print_stacktrace=1 \
        "$build/fuzz/vdamf_fuzz_$target" "${limits[@]}" -rss_limit_mb=1024 \
        -timeout=10 -detect_leaks=0 -print_final_stats=1 -artifact_prefix="$findings/" "${dictionary[@]}" \
        "$build/corpus/$target" "${seeds[@]}" > "$log" 2>&1
    code=$?
    stat() { sed -n "s/^stat::$1: *//p" "$log" | tail -1; }
    count=$(find "$findings" -type f | wc -l)
    edges=$(grep -o 'cov: [0-9]*' "$log" | tail -1 | cut -d' ' -f2)
    printf '%-18s %10s %10s %9s %8s %9s %9s\n' "$target" "$(stat number_of_executed_units)" \
        "$(stat average_exec_per_sec)" "${edges:--}" "$(stat peak_rss_mb)" \
        "$(stat slowest_unit_time_sec)" "$count"
    if [ $code -ne 0 ] || [ "$count" -gt 0 ]; then
        failed=1
        grep -m3 -E 'ERROR: |runtime error|does not hold|SUMMARY' "$log" | sed 's/^/    /'
    fi
done
exit $failed
