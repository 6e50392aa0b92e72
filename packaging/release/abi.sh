#!/usr/bin/env bash
# packaging/release/abi.sh OLD NEW: compares the C libraries of two archives for Linux
# (contactd-VERSION-linux-x86_64.tar.gz) with abidiff. Exits with 0 if NEW contains everything in OLD, unchanged.
set -euo pipefail

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
for which in old new; do
    mkdir "$scratch/$which"
    tar -xf "$1" -C "$scratch/$which" --strip-components=1
    shift
done
status=0
for old in "$scratch"/old/lib/*.so*; do
    [ ! -L "$old" ] || continue
    name=$(basename "$old" | sed 's/\.so.*//')
    new=$(find "$scratch/new/lib" -type f -name "$name.so*" | head -n 1)
    [ -n "$new" ] || { echo "abi: $name is gone" >&2; exit 1; }
    # abidiff adds 8 for a change that breaks old programs; 4 alone means added functions.
    found=0
    abidiff --headers-dir1 "$scratch/old/include" --headers-dir2 "$scratch/new/include" "$old" "$new" || found=$?
    if [ $((found & 11)) -ne 0 ] || [ "$(nm -D --defined-only "$old" | awk '{print $3}' | sed 's/@.*//' | sort -u |
        comm -23 - <(nm -D --defined-only "$new" | awk '{print $3}' | sed 's/@.*//' | sort -u) | wc -l)" -ne 0 ]; then
        echo "abi: $name has lost or changed something" >&2
        status=1
    fi
done
exit $status
