#!/usr/bin/env bash
# packaging/ducc0/fetch.sh FOLDER puts the headers of ducc0's FFT, unchanged, into FOLDER/{include,licenses}. ducc0 as a
# whole is under the GPL. Its FFT and the headers included by it are BSD-3-Clause or GPL, and nothing else is kept.
set -euo pipefail

here=$(dirname "$(readlink -f "$0")")
folder=$(realpath -m "$1")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

python3 -m venv venv
venv/bin/pip download --quiet --retries 1 --no-deps --no-binary ducc0 --require-hashes --dest . -r "$here/requirements.txt"
tar -xf ducc0-*.tar.gz
rm -rf "$folder"
mkdir -p "$folder/licenses"
cd ducc0-*/src
for header in fft/fft1d_impl fft/fft infra/{aligned_array,error_handling,mav,misc_utils,simd,threading,useful_macros} math/{cmplx,unity_roots}; do
    grep -q 'SPDX-License-Identifier: BSD-3-Clause OR GPL-2.0-or-later' "ducc0/$header.h"
    install -D -m 644 "ducc0/$header.h" "$folder/include/ducc0/$header.h"
done
# Extracts the copyright notice and the licence of the binaries from the head of the FFT.
awk '/SPDX/ { next } /This code is free software/ { exit } { print }' ducc0/fft/fft1d_impl.h | sed '/^\/\*$/d; /^\*\/$/d; /^ \*$/d' >"$folder/licenses/ducc0"
sed -n 's/^ducc0==\([0-9.]*\).*/\1/p' "$here/requirements.txt" >"$folder/version"
basename "$scratch"/ducc0-*.tar.gz >"$folder/sources.txt"
