# Runs inside the root of ./dev arm64 before packages are installed. MPI's headers for arm64 depend on a Fortran
# compiler that runs on arm64, and would replace the compilers that run here. This script prevents that; nothing here is
# compiled with it.
set -eu
folder=$(mktemp -d)
mkdir "$folder/DEBIAN"
cat >"$folder/DEBIAN/control" <<'END'
Package: contactd-without-fortran
Version: 1
Architecture: all
Multi-Arch: foreign
Maintainer: contactd authors <contactd@example.org>
Provides: gfortran-mod-15
Description: stands for a Fortran compiler of arm64
END
dpkg-deb --build "$folder" "$folder.deb" >/dev/null
dpkg --install "$folder.deb" >/dev/null
rm -r "$folder" "$folder.deb"
