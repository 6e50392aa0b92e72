#!/usr/bin/env bash
# Fuzzes: run.sh [SECONDS] [TARGET...]   each target for so long (default 600), from the kept corpus and the seeds
#         run.sh keep [TARGET...]        makes the kept corpus anew: as few inputs as reach everything that was found
# What ends a program is left in build/fuzz/found/, to be given to the program again. ./dev fuzz builds and calls this.
set -euo pipefail

cd "$(dirname "$0")/../.."
work=build/fuzz
seconds=600
keep=no
case ${1:-} in
keep) keep=yes && shift ;;
[0-9]*) seconds=$1 && shift ;;
esac
if [ $# -gt 0 ]; then targets=("$@"); else targets=($(basename -a "$work"/bin/fuzz_* | sed 's/^fuzz_//') commands); fi

# Anything over twenty seconds or half a gigabyte at once is a finding, too: inputs are no larger than 4 KiB.
limits=(-max_len=4096 -timeout=20 -rss_limit_mb=1024 -malloc_limit_mb=512)
export ASAN_OPTIONS=detect_leaks=1:allocator_may_return_null=0 UBSAN_OPTIONS=print_stacktrace=1

[ "${targets[*]}" = commands ] || python3 tests/fuzz/seeds.py "$work/seeds"
status=0
for target in "${targets[@]}"; do
    if [ "$target" = commands ]; then # a program of Python, without a corpus
        if [ $keep = no ]; then
            echo "==> fuzzing $target for $seconds s" >&2
            python3 tests/fuzz/commands.py "$seconds" || status=$?
        fi
        continue
    fi
    program=$work/bin/fuzz_$target
    [ -x "$program" ] || { echo "there is no target '$target'; there are $(basename -a "$work"/bin/fuzz_* | sed 's/^fuzz_//' | xargs)" >&2 && exit 2; }
    archive=tests/fuzz/corpus/$target.zip
    kept=$work/kept/$target
    rm -rf "$kept" && mkdir -p "$work/corpus/$target" "$work/found" "$kept"
    [ ! -e "$archive" ] || python3 -m zipfile -e "$archive" "$kept"
    if [ $keep = yes ]; then
        new=$(mktemp -d "$work/kept.XXXXXX")
        "$program" -set_cover_merge=1 -use_counters=0 "${limits[@]}" -artifact_prefix="$work/found/$target-" "$new" "$work/seeds/$target" "$kept" "$work/corpus/$target" 2>/dev/null
        python3 tests/fuzz/pack.py "$new" "$archive"
        echo "$target: $(find "$new" -type f | wc -l) inputs, an archive of $(stat -c %s "$archive") bytes"
        rm -rf "$new"
        continue
    fi
    echo "==> fuzzing $target for $seconds s" >&2
    dictionary=()
    case $target in creep_table | ic_file | ic_content | profile_file | contact_file) ;; *) dictionary=(-dict="$work/seeds/json.dict") ;; esac
    "$program" "${limits[@]}" "${dictionary[@]}" -max_total_time="$seconds" -print_final_stats=1 \
        -artifact_prefix="$work/found/$target-" "$work/corpus/$target" "$work/seeds/$target" "$kept" \
        >"$work/$target.log" 2>&1 || status=$?
    grep -E "^(SUMMARY|does not hold|stat::number_of_executed)|Test unit written" "$work/$target.log" | sed "s/^/$target: /" || true
    tail -n 40 "$work/$target.log" | grep -E "DONE" | tail -n 1 | sed "s/^/$target: /" || true
done
exit $status
