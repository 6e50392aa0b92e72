#!/usr/bin/env bash
# packaging/windows/python.sh FOLDER provides the files for compiling and linking a Python module for Windows in
# FOLDER/{include,lib}: the headers, and an import library of python3.dll, which has the stable ABI in all versions. The
# sources are those of the same Debian release.
set -euo pipefail

folder=$(realpath -m "$1")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

mkdir -p lists/partial cache/archives/partial
sed -n 's/^deb /deb-src /p' /etc/apt/sources.list >sources.list
# Uses a separate configuration of apt, which includes sources and does not change the machine's lists.
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
# Extracts Python's own list of the functions and data that python3.dll exports.
{
    echo "LIBRARY python3.dll"
    echo EXPORTS
    sed -n 's/^EXPORT_FUNC(\(\w*\))$/\1/p; s/^EXPORT_DATA(\(\w*\))$/\1 DATA/p' python/PC/python3dll.c
} >python3.def
x86_64-w64-mingw32ucrt-dlltool --input-def python3.def --output-lib "$folder/lib/libpython3.a"
