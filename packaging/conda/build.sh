#!/usr/bin/env bash
# Builds the C libraries of contactd and installs them into $PREFIX. It runs in the root of the sources; conda sets
# PREFIX, CPU_COUNT and CMAKE_ARGS. CONTACTD_DUCC0 is the folder made by packaging/ducc0/fetch.sh; if it is empty, CMake
# fetches the sources, which requires a network.
set -euo pipefail

[ -n "${CONTACTD_DUCC0:-}" ] || unset CONTACTD_DUCC0
# shellcheck disable=SC2086  # conda passes several options as one text
cmake -S . -B build/conda -G Ninja ${CMAKE_ARGS:-} -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$PREFIX" \
    -DCMAKE_INSTALL_LIBDIR=lib -DCONTACTD_FEM=OFF -DCONTACTD_SERVER=OFF -DCONTACTD_TESTS=OFF -DCONTACTD_UNITY=ON
cmake --build build/conda --target contactd_c contactd_local_c contactd_cntc --parallel "${CPU_COUNT:-2}"
for component in c_library c_local_library c_development cntc cntc_development; do
    cmake --install build/conda --component "$component"
done
