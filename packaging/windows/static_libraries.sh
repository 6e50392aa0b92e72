#!/usr/bin/env bash
# packaging/windows/static_libraries.sh FOLDER builds HDF5, zlib and the core of prometheus-cpp for Windows as archives
# inside DLLs. The sources are those of the same Debian release. Results and licences are in
# FOLDER/{include,lib,licenses}.
set -euo pipefail

here=$(dirname "$(readlink -f "$0")")
folder=$(realpath -m "$1")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
export CONTACTD_STATIC_LIBRARIES=$folder

# Uses a separate configuration of apt, which includes sources and does not change the machine's lists.
apt_of_sources() {
    apt-get -q -o Dir::Etc::SourceList="$scratch/sources.list" -o Dir::Etc::SourceParts=/dev/null \
        -o Dir::State::Lists="$scratch/lists" -o Dir::Cache="$scratch/cache" -o APT::Sandbox::User=root "$@"
}

get_sources() {
    mkdir -p lists/partial cache/archives/partial
    sed -n 's/^deb /deb-src /p' /etc/apt/sources.list >sources.list
    apt_of_sources update
    # Only the authors' archives are needed, so a mirror may lack Debian's part of a source.
    apt_of_sources source --download-only hdf5 prometheus-cpp zlib || true
}

# configured NAME OPTIONS... unpacks and configures a library without shared objects. The result does not depend on the
# machine and the date, so that it is reproducible.
configured() {
    local name=$1 flags="-Wa,-muse-unaligned-vector-move -D_GNU_SOURCE -ffile-prefix-map=$scratch/="
    shift
    ls "$name"_*.orig.tar.* >/dev/null 2>&1 || { echo "the sources of $name cannot be had from this mirror" >&2 && exit 1; }
    mkdir "$name"
    tar -xf "$name"_*.orig.tar.* -C "$name" --strip-components=1
    # HDF5 would record the machine and the date.
    [ ! -e "$name/src/H5build_settings.off.c.in" ] || cp "$name"/src/H5build_settings.{off,cmake}.c.in
    mkdir -p "$folder/licenses"
    find "$name" -maxdepth 1 \( -name 'COPYING*' -o -name 'LICENSE*' \) -type f -exec cat {} + >"$folder/licenses/$name"
    ls "$name"_*.orig.tar.* >>"$folder/sources.txt"
    cmake -S "$name" -B "$name-build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$folder" \
        -DCMAKE_TOOLCHAIN_FILE="$here/toolchain.cmake" -DCMAKE_INSTALL_LIBDIR=lib -DBUILD_SHARED_LIBS=OFF \
        -DCMAKE_C_FLAGS="$flags" -DCMAKE_CXX_FLAGS="$flags" "$@"
}

built() { cmake --build "$@" ${CONTACTD_JOBS:+-j "$CONTACTD_JOBS"}; }

rm -rf "$folder"
mkdir -p "$folder"/{include,lib}
get_sources
# zlib also installs files of its shared library, some of which Debian's archive lacks.
configured zlib
built zlib-build --target zlibstatic
cp zlib-build/libzlibstatic.a "$folder/lib/libz.a"
find zlib zlib-build -maxdepth 1 \( -name zlib.h -o -name zconf.h \) -exec cp {} "$folder/include" \;
configured prometheus-cpp -DENABLE_PUSH=OFF -DENABLE_PULL=OFF -DENABLE_COMPRESSION=OFF -DENABLE_TESTING=OFF \
    -DUSE_THIRDPARTY_LIBRARIES=OFF -DGENERATE_PKGCONFIG=ON
built prometheus-cpp-build
cmake --install prometheus-cpp-build
configured hdf5 -DHDF5_BUILD_CPP_LIB=ON -DHDF5_BUILD_HL_LIB=OFF -DHDF5_BUILD_TOOLS=OFF -DHDF5_BUILD_UTILS=OFF \
    -DHDF5_BUILD_EXAMPLES=OFF -DBUILD_TESTING=OFF -DHDF5_ENABLE_Z_LIB_SUPPORT=ON -DHDF5_ENABLE_SZIP_SUPPORT=OFF \
    -DHDF5_ENABLE_NONSTANDARD_FEATURES=OFF \
    -DZLIB_INCLUDE_DIR="$folder/include" -DZLIB_LIBRARY="$folder/lib/libz.a"
built hdf5-build
cmake --install hdf5-build
