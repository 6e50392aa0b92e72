#!/usr/bin/env bash
# packaging/windows/python.sh FOLDER: what a module of Python for Windows is compiled and linked with, to FOLDER/{include,lib}: the
# headers, and an import library of python3.dll, which has the stable ABI in all versions. From the sources of the same Debian release.
set -euo pipefail

folder=$(realpath -m "$1")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

mkdir -p lists/partial cache/archives/partial
sed -n 's/^deb /deb-src /p' /etc/apt/sources.list >sources.list
# apt of its own, which knows of sources and leaves the machine's lists as they are.
for asked in update "source --download-only python3.13"; do
    apt-get -q -o Dir::Etc::SourceList="$scratch/sources.list" -o Dir::Etc::SourceParts=/dev/null \
        -o Dir::State::Lists="$scratch/lists" -o Dir::Cache="$scratch/cache" -o APT::Sandbox::User=root $asked || true
done
ls python3.13_*.orig.tar.xz >/dev/null || { echo "the sources of Python cannot be had from this mirror" >&2 && exit 1; }
mkdir python
tar -xf python3.13_*.orig.tar.xz -C python --strip-components=1

rm -rf "$folder"
mkdir -p "$folder/lib"
cp -r python/Include "$folder/include"
cp python/PC/pyconfig.h.in "$folder/include/pyconfig.h"
# Python's own list of what python3.dll shows: functions, and data.
{
    echo "LIBRARY python3.dll"
    echo EXPORTS
    sed -n 's/^EXPORT_FUNC(\(\w*\))$/\1/p; s/^EXPORT_DATA(\(\w*\))$/\1 DATA/p' python/PC/python3dll.c
} >python3.def
x86_64-w64-mingw32ucrt-dlltool --input-def python3.def --output-lib "$folder/lib/libpython3.a"
