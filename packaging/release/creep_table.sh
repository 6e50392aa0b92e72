#!/bin/sh
# Builds and checks the creep-force table of a release in FOLDER, or solves a share of both, and continues after
# interruptions. docs/creep-tables.md describes the table.
#
#     packaging/release/creep_table.sh FOLDER [INDEX/COUNT]
set -eu
folder=${1:?"Give the folder of the release."}
table=$folder/creep-0.28.creep
most=20000000 # bytes

if [ $# -gt 1 ]; then
    contactctl table build "$table" --nu 0.28 --share "$2"
    [ ! -e "$table" ] || contactctl table check "$table" --points 10000 --seed 7 --share "$2"
    exit 0
fi
contactctl table build "$table" --nu 0.28
contactctl table check "$table" --points 10000 --seed 7
size=$(wc -c < "$table")
if [ "$size" -gt "$most" ]; then
    echo "$table has $size bytes; a release ships at most $most. Reduce the cells." >&2
    exit 1
fi
