#!/usr/bin/env bash
# packaging/wheels/static_libraries.sh FOLDER builds the libraries inside a Python module that Debian does not provide
# as suitable archives: HDF5 without network access, reproc, and the core of prometheus-cpp. The sources are those of
# the same Debian release. Results and licences are in FOLDER/{include,lib,licenses}.
set -euo pipefail

folder=$(realpath -m "$1")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

# Uses a separate configuration of apt, which includes sources and does not change the machine's lists.
apt_of_sources() {
    apt-get -q -o Dir::Etc::SourceList="$scratch/sources.list" -o Dir::Etc::SourceParts=/dev/null \
        -o Dir::State::Lists="$scratch/lists" -o Dir::Cache="$scratch/cache" -o APT::Sandbox::User=root "$@"
}

get_sources() {
    mkdir -p lists/partial cache/archives/partial
    apt-get indextargets --format 'deb-src $(SITE) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' |
        { grep ' main$' || true; } | sort -u >sources.list
    [ -s sources.list ] || sed -n 's/^deb /deb-src /p' /etc/apt/sources.list >sources.list
    apt_of_sources update
    # Only the authors' archives are needed, so a mirror may lack Debian's part of a source.
    apt_of_sources source --download-only hdf5 reproc prometheus-cpp || true
}

# library NAME OPTIONS... builds and installs a library without shared objects. The result does not depend on the
# machine and the date, so that it is reproducible.
library() {
    local name=$1
    shift
    ls "$name"_*.orig.tar.* >/dev/null 2>&1 || { echo "the sources of $name cannot be had from this mirror" >&2 && exit 1; }
    mkdir "$name"
    tar -xf "$name"_*.orig.tar.* -C "$name" --strip-components=1
    # HDF5 would record the machine and the date.
    [ ! -e "$name/src/H5build_settings.off.c.in" ] || cp "$name"/src/H5build_settings.{off,cmake}.c.in
    cmake -S "$name" -B "$name-build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$folder" \
        -DCMAKE_INSTALL_LIBDIR=lib -DCMAKE_POSITION_INDEPENDENT_CODE=ON -DBUILD_SHARED_LIBS=OFF \
        -DCMAKE_C_FLAGS="-ffile-prefix-map=$scratch/=" -DCMAKE_CXX_FLAGS="-ffile-prefix-map=$scratch/=" "$@"
    cmake --build "$name-build" ${CONTACTD_JOBS:+-j "$CONTACTD_JOBS"}
    cmake --install "$name-build"
    mkdir -p "$folder/licenses"
    find "$name" -maxdepth 1 \( -name 'COPYING*' -o -name 'LICENSE*' \) -type f -exec cat {} + >"$folder/licenses/$name"
    (cd "$scratch" && ls "$name"_*.orig.tar.*) >>"$folder/sources.txt"
}

rm -rf "$folder"
mkdir -p "$folder"
get_sources
library reproc -DREPROC++=ON
library prometheus-cpp -DENABLE_PUSH=OFF -DENABLE_PULL=OFF -DENABLE_COMPRESSION=OFF -DENABLE_TESTING=OFF \
    -DUSE_THIRDPARTY_LIBRARIES=OFF
library hdf5 -DHDF5_BUILD_CPP_LIB=ON -DHDF5_BUILD_HL_LIB=OFF -DHDF5_BUILD_TOOLS=OFF -DHDF5_BUILD_UTILS=OFF \
    -DHDF5_BUILD_EXAMPLES=OFF -DBUILD_TESTING=OFF -DHDF5_ENABLE_Z_LIB_SUPPORT=ON -DHDF5_ENABLE_SZIP_SUPPORT=OFF \
    -DHDF5_ENABLE_NONSTANDARD_FEATURES=OFF
