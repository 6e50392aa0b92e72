#!/usr/bin/env bash
# packaging/fmu/zeromq.sh FOLDER builds ZeroMQ as an archive for FMUs in FOLDER/{include,lib,licenses}. Debian's archive
# cannot be linked into shared objects, and requires Kerberos. The sources of ZeroMQ 4.3.4 are part of those of pyzmq on
# PyPI.
set -euo pipefail

pyzmq=25.1.2
here=$(dirname "$(readlink -f "$0")")
folder=$(realpath -m "$1")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

python3 -m venv venv
venv/bin/pip download --quiet --retries 1 --no-deps --no-binary pyzmq --dest . "pyzmq==$pyzmq"
tar -xf "pyzmq-$pyzmq.tar.gz"
sources=$scratch/pyzmq-$pyzmq/bundled/zeromq
cmake -S "$here/zeromq" -B build -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$folder" -DSOURCES="$sources"
cmake --build build ${CONTACTD_JOBS:+-j "$CONTACTD_JOBS"}
rm -rf "$folder"
cmake --install build
mkdir "$folder/licenses"
cat "$sources/COPYING" "$sources/COPYING.LESSER" >"$folder/licenses/zeromq"
version=$(sed -n 's/^#define ZMQ_VERSION_\(MAJOR\|MINOR\|PATCH\) \([0-9]*\)$/\2/p' "$folder/include/zmq.h" | paste -sd.)
echo "zeromq-$version, in pyzmq-$pyzmq.tar.gz, its folder bundled/zeromq" >"$folder/sources.txt"
